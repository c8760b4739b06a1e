// SPDX-License-Identifier: MIT
// The nearest of many edges in each direction from a source. The turn is cut into slots: slot 2r is the direction of
// rank r alone, slot 2r + 1 all that lie between it and the next. What is nearest is kept as a list of places where it
// changes; lists of half as many edges are merged to one. Edges that cross are told apart on either side of the
// crossing, which stays a pair of edges: nothing is computed but signs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/compare.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/crossing_point.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/visibility/detail/direction_order.hpp>
#include <irg/visibility/detail/turn_between.hpp>

namespace irg::detail::inline IRG_ABI {

inline constexpr std::uint32_t no_sight_edge = no_index;
inline constexpr std::uint32_t at_source = 0xfffffffeu;  // nothing is seen at all

// An edge that stops sight. It runs counter-clockwise as the source sees it, or else it is seen edge-on, and a is its
// nearest point.
template <Floating T>
struct sight_edge {
  point<T, 2> a{}, b{};
  std::uint32_t start = 0, finish = 0;  // the ranks of the directions to a and to b
  std::uint32_t index = 0;              // in its list
  bool is_boundary = false, is_edge_on = false;
};

// The sign of (crossing of the lines a and b) x (crossing of c and d), both less the source; their order, when they lie
// less than half a turn apart and each of a and c ends on either side of its partner, first on that of the source.
template <Floating T>
constexpr int compare_crossing_directions(const point<T, 2>& source, const std::array<const sight_edge<T>*, 4>& edges) {
  std::array<double, 18> in{};
  std::size_t k = 0;
  const auto add = [&](const point<T, 2>& p) {
    in[k++] = widened(p.x);
    in[k++] = widened(p.y);
  };
  add(source);
  for (const auto* e : edges) {
    add(e->a);
    add(e->b);
  }
  const auto formula = [](const auto& x) {
    const auto area = [&x](std::size_t line, std::size_t end) {
      return (x[line + 2] - x[line]) * (x[end + 1] - x[line + 1]) - (x[line + 3] - x[line + 1]) * (x[end] - x[line]);
    };
    const auto part = [&](std::size_t first, std::size_t axis) {
      return (x[first + axis] - x[axis]) * area(first + 4, first + 2) -
             (x[first + 2 + axis] - x[axis]) * area(first + 4, first);
    };
    return part(2, 0) * part(10, 1) - part(2, 1) * part(10, 0);
  };
  const auto sign = [](const sight_edge<T>& a, const sight_edge<T>& b) { return orient2d(b.a, b.b, a.b); };
  return irg::sign_of<6>(formula, in) * sign(*edges[0], *edges[1]) * sign(*edges[2], *edges[3]);
}

// Does not count what is compared.
struct no_sight_tally {
  IRG_INLINE constexpr void compared(std::uint32_t, std::uint32_t, int) const noexcept {}
};

// Counts it, and keeps which edges were compared. The pseudo-edge at the source is none.
struct sight_tally {
  std::int64_t pairs = 0, crossings = 0;
  std::vector<std::uint8_t> was_compared{};  // by edge

  constexpr void compared(std::uint32_t a, std::uint32_t b, int outcome) {
    if (a == at_source || b == at_source) return;
    ++pairs;
    if (outcome == 2 || outcome == -2) ++crossings;
    if (was_compared.size() <= maximum(a, b)) was_compared.resize(maximum(a, b) + std::size_t{1}, std::uint8_t{0});
    was_compared[a] = was_compared[b] = 1;
  }
};

template <Floating T, class Tally = no_sight_tally>
struct sight_envelope {
  // Where something changes: at the beginning of a slot, or within one, where the edges a and b cross.
  struct place {
    std::uint32_t slot = 0, a = no_sight_edge, b = no_sight_edge;
  };
  struct item {
    place at;
    std::uint32_t edge = no_sight_edge;  // what is nearest from there on
  };
  // The list that two are merged to: the items of `out` from `first` on.
  struct merged {
    std::vector<item>& out;
    std::size_t first = out.size();

    constexpr void append(const place& at, std::uint32_t edge) {
      const std::uint32_t last = out.size() == first ? no_sight_edge : out.back().edge;
      if (last != edge) out.push_back({at, edge});
    }
  };

  point<T, 2> source{};
  std::vector<sight_edge<T>> edges{};
  std::vector<point<T, 2>> towards{};  // a point in each direction
  std::vector<item> nearest{};
  [[no_unique_address]] Tally tally{};
  std::vector<std::size_t> ends{};  // of the lists that are not merged yet
};

template <class Envelope>
constexpr std::uint32_t ranks(const Envelope& s) noexcept {
  return static_cast<std::uint32_t>(s.towards.size());
}

template <class Envelope>
constexpr void add_run(Envelope& s, std::uint32_t edge, std::uint32_t from, std::uint32_t to) {
  s.nearest.push_back({{from, no_sight_edge, no_sight_edge}, edge});
  s.nearest.push_back({{to, no_sight_edge, no_sight_edge}, no_sight_edge});
  s.ends.push_back(s.nearest.size());
}

// Adds an edge in the slots from `from` on, up to but not including `to`; slots past the last one begin again.
template <class Envelope>
constexpr void cover_slots(Envelope& s, std::uint32_t edge, std::uint32_t from, std::uint32_t to) {
  const std::uint32_t all = 2 * ranks(s);
  if (to <= all) {
    if (from < to) add_run(s, edge, from, to);
  } else {
    add_run(s, edge, from, all);
    add_run(s, edge, 0, to - all);
  }
}

template <class Envelope>
constexpr int compare_edge_on(const Envelope& s, std::uint32_t a, std::uint32_t b) noexcept {
  const auto &e = s.edges[a], &f = s.edges[b];
  if (!e.is_edge_on) return -compare_edge_on(s, b, a);
  const int by_number = a < b ? 1 : -1;
  if (!f.is_edge_on) {
    const int side = orient2d(f.a, f.b, e.a);
    return side != 0 ? side : by_number;
  }
  const bool a_within = is_between_ends(s.source, f.a, e.a), b_within = is_between_ends(s.source, e.a, f.a);
  return a_within == b_within ? by_number : a_within ? 1 : -1;
}

// 1 when a is nearer than b wherever both are seen, -1 when b is; 2 when they cross and a is nearer before that, -2
// when b is. What is equally near goes by number, unless it is so in one direction only.
template <class Envelope>
constexpr int compare_edges(const Envelope& s, std::uint32_t a, std::uint32_t b) noexcept {
  if (a == at_source || b == at_source) return a == at_source ? 1 : -1;
  const auto &e = s.edges[a], &f = s.edges[b];
  if (e.is_edge_on || f.is_edge_on) return compare_edge_on(s, a, b);
  const int e0 = orient2d(f.a, f.b, e.a), e1 = orient2d(f.a, f.b, e.b);
  if (e0 == 0 && e1 == 0) return a < b ? 1 : -1;
  if (e0 >= 0 && e1 >= 0) return 1;
  if (e0 <= 0 && e1 <= 0) return -1;
  const int f0 = orient2d(e.a, e.b, f.a), f1 = orient2d(e.a, e.b, f.b);
  if (f0 >= 0 && f1 >= 0) return -1;
  if (f0 <= 0 && f1 <= 0) return 1;
  return e0 > 0 ? 2 : -2;
}

// 1 when the crossing of a and b comes after the direction of this rank, -1 before, 0 when it lies there.
template <Floating T, class Tally>
constexpr int crossing_after(const sight_envelope<T, Tally>& s, std::uint32_t a, std::uint32_t b,
                             std::uint32_t rank) noexcept {
  const auto &e = s.edges[a], &f = s.edges[b];
  const segment<T, 2> ray{s.source, s.towards[rank == ranks(s) ? 0 : rank]};
  return sign_of(*side_of_crossing(segment<T, 2>{e.a, e.b}, segment<T, 2>{f.a, f.b}, ray));
}

// Negative when p comes before q, positive when after it, 0 when they are one.
template <class Envelope>
constexpr int compare_places(const Envelope& s, const typename Envelope::place& p,
                             const typename Envelope::place& q) noexcept {
  if (p.slot != q.slot) return p.slot < q.slot ? -1 : 1;
  if (p.a == no_sight_edge || q.a == no_sight_edge)
    return static_cast<int>(p.a != no_sight_edge) - static_cast<int>(q.a != no_sight_edge);
  if (p.a == q.a && p.b == q.b) return 0;
  return -compare_crossing_directions(s.source, {&s.edges[p.a], &s.edges[p.b], &s.edges[q.a], &s.edges[q.b]});
}

// Where a and b cross: a slot alone where a rank has that direction, and some place beyond when it is not between
// `from` and `to`.
template <class Envelope>
constexpr typename Envelope::place crossing_place(const Envelope& s, std::uint32_t a, std::uint32_t b,
                                                  const typename Envelope::place& from,
                                                  const typename Envelope::place& to) noexcept {
  // Both are seen up to the direction of rank `high`; further directions may be more than half a turn away.
  std::uint32_t low = from.slot / 2, high = to.a == no_sight_edge ? to.slot / 2 : to.slot / 2 + 1;
  const int after_low = crossing_after(s, a, b, low);
  if (after_low <= 0) return {2 * low, no_sight_edge, no_sight_edge};
  const int after_high = low == high ? 1 : crossing_after(s, a, b, high);
  if (after_high >= 0) return {2 * high + (after_high > 0 ? 1 : 0), no_sight_edge, no_sight_edge};
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    const int after = crossing_after(s, a, b, middle);
    if (after == 0) return {2 * middle, no_sight_edge, no_sight_edge};
    (after > 0 ? low : high) = middle;
  }
  return {2 * low + 1, a, b};
}

// Appends what is nearest of a and b from `from` to `to`.
template <class Envelope>
constexpr void append_nearest(Envelope& s, typename Envelope::merged& list, std::uint32_t a, std::uint32_t b,
                              const std::pair<typename Envelope::place, typename Envelope::place>& span) {
  const auto& [from, to] = span;
  const bool both = a != no_sight_edge && b != no_sight_edge;
  const int nearer = both ? compare_edges(s, a, b) : a == no_sight_edge ? -1 : 1;
  if (both) s.tally.compared(a, b, nearer);
  if (nearer == 1 || nearer == -1) return list.append(from, nearer > 0 ? a : b);
  const std::uint32_t before = nearer > 0 ? a : b, after = nearer > 0 ? b : a;
  const auto at = crossing_place(s, a, b, from, to);
  const bool begins = compare_places(s, from, at) < 0, ends = compare_places(s, at, to) < 0;
  if (begins) list.append(from, before);
  if (ends) list.append(begins ? at : from, after);
}

// The rest of two lists, of which one has ended.
template <class Envelope>
constexpr void append_last(const Envelope& s, typename Envelope::merged& list, const typename Envelope::place& from,
                           const std::array<std::uint32_t, 2>& edge, const std::array<std::size_t, 4>& rest) {
  list.append(from, edge[0] == no_sight_edge ? edge[1] : edge[0]);
  for (std::size_t i = rest[0]; i < rest[1]; ++i) list.append(s.nearest[i].at, s.nearest[i].edge);
  for (std::size_t k = rest[2]; k < rest[3]; ++k) list.append(s.nearest[k].at, s.nearest[k].edge);
}

template <class Envelope>
constexpr void merge_runs(Envelope& s, std::size_t i, std::size_t middle, std::size_t end,
                          std::vector<typename Envelope::item>& out) {
  typename Envelope::merged list{out};
  std::size_t k = middle;
  std::uint32_t a = no_sight_edge, b = no_sight_edge;
  while (i < middle && k < end) {
    const int order = compare_places(s, s.nearest[i].at, s.nearest[k].at);
    const auto from = order <= 0 ? s.nearest[i].at : s.nearest[k].at;
    if (order <= 0) a = s.nearest[i++].edge;
    if (order >= 0) b = s.nearest[k++].edge;
    if (i == middle || k == end) {  // one list has ended, and nothing is what its last item says
      append_last(s, list, from, {a, b}, {i, middle, k, end});
      return;
    }
    const auto& to = compare_places(s, s.nearest[i].at, s.nearest[k].at) <= 0 ? s.nearest[i].at : s.nearest[k].at;
    append_nearest(s, list, a, b, {from, to});
  }
  for (; i < middle; ++i) list.append(s.nearest[i].at, s.nearest[i].edge);
}

// Merges all that has been added.
template <class Envelope>
constexpr void merge_envelope(Envelope& s) {
  std::vector<typename Envelope::item> merged;
  std::vector<std::size_t> merged_ends;
  merged.reserve(s.nearest.size());
  while (s.ends.size() > 1) {
    merged.clear();
    merged_ends.clear();
    std::size_t from = 0;
    for (std::size_t i = 0; i < s.ends.size(); i += 2) {
      const std::size_t middle = s.ends[i], to = i + 1 < s.ends.size() ? s.ends[i + 1] : middle;
      merge_runs(s, from, middle, to, merged);
      merged_ends.push_back(merged.size());
      from = to;
    }
    s.nearest.swap(merged);
    s.ends.swap(merged_ends);
  }
}

}  // namespace irg::detail::inline IRG_ABI
