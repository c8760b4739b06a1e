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
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/crossing_point.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/visibility/detail/direction_order.hpp>

namespace irg::detail::inline IRG_ABI {

inline constexpr std::uint32_t no_sight_edge = no_index;
inline constexpr std::uint32_t at_source = 0xfffffffeu;  // nothing is seen at all

// Whether p, on the line through a and b, is between them or on one of them.
template <Floating T>
constexpr bool lies_within(const point<T, 2>& a, const point<T, 2>& b, const point<T, 2>& p) noexcept {
  const auto within = [](T from, T to, T v) { return from < to ? from <= v && v <= to : to <= v && v <= from; };
  return within(a.x, b.x, p.x) && within(a.y, b.y, p.y);
}

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
  for (const auto* e : edges) add(e->a), add(e->b);
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
    if (was_compared.size() <= greater(a, b)) was_compared.resize(greater(a, b) + std::size_t{1}, std::uint8_t{0});
    was_compared[a] = was_compared[b] = 1;
  }
};

template <Floating T, class Tally = no_sight_tally>
class sight_envelope {
public:
  // Where something changes: at the beginning of a slot, or within one, where the edges a and b cross.
  struct place {
    std::uint32_t slot = 0, a = no_sight_edge, b = no_sight_edge;
  };
  struct item {
    place at;
    std::uint32_t edge = no_sight_edge;  // what is nearest from there on
  };

  point<T, 2> source{};
  std::vector<sight_edge<T>> edges{};
  std::vector<point<T, 2>> towards{};  // a point in each direction
  std::vector<item> nearest{};
  [[no_unique_address]] Tally tally{};

  constexpr std::uint32_t ranks() const noexcept { return static_cast<std::uint32_t>(towards.size()); }

  // Adds an edge in the slots from `from` on, up to but not including `to`; slots past the last one begin again.
  constexpr void cover(std::uint32_t edge, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t all = 2 * ranks();
    if (to <= all) {
      if (from < to) add_run(edge, from, to);
    } else {
      add_run(edge, from, all);
      add_run(edge, 0, to - all);
    }
  }

  // Merges all that has been added.
  constexpr void merge() {
    std::vector<item> merged;
    std::vector<std::size_t> merged_ends;
    merged.reserve(nearest.size());
    while (ends_.size() > 1) {
      merged.clear();
      merged_ends.clear();
      std::size_t from = 0;
      for (std::size_t i = 0; i < ends_.size(); i += 2) {
        const std::size_t middle = ends_[i], to = i + 1 < ends_.size() ? ends_[i + 1] : middle;
        merge_runs(from, middle, to, merged);
        merged_ends.push_back(merged.size());
        from = to;
      }
      nearest.swap(merged);
      ends_.swap(merged_ends);
    }
  }

  // 1 when a is nearer than b wherever both are seen, -1 when b is; 2 when they cross and a is nearer before that, -2
  // when b is. What is equally near goes by number, unless it is so in one direction only.
  constexpr int compare(std::uint32_t a, std::uint32_t b) const noexcept {
    if (a == at_source || b == at_source) return a == at_source ? 1 : -1;
    const sight_edge<T>&e = edges[a], &f = edges[b];
    if (e.is_edge_on || f.is_edge_on) return compare_edge_on(a, b);
    const int e0 = orient2d(f.a, f.b, e.a), e1 = orient2d(f.a, f.b, e.b);
    if (e0 == 0 && e1 == 0) return a < b ? 1 : -1;
    if (e0 >= 0 && e1 >= 0) return 1;
    if (e0 <= 0 && e1 <= 0) return -1;
    const int f0 = orient2d(e.a, e.b, f.a), f1 = orient2d(e.a, e.b, f.b);
    if (f0 >= 0 && f1 >= 0) return -1;
    if (f0 <= 0 && f1 <= 0) return 1;
    return e0 > 0 ? 2 : -2;
  }

private:
  std::vector<std::size_t> ends_{};  // of the lists that are not merged yet

  constexpr void add_run(std::uint32_t edge, std::uint32_t from, std::uint32_t to) {
    nearest.push_back({{from, no_sight_edge, no_sight_edge}, edge});
    nearest.push_back({{to, no_sight_edge, no_sight_edge}, no_sight_edge});
    ends_.push_back(nearest.size());
  }

  constexpr int compare_edge_on(std::uint32_t a, std::uint32_t b) const noexcept {
    const sight_edge<T>&e = edges[a], &f = edges[b];
    if (!e.is_edge_on) return -compare_edge_on(b, a);
    const int by_number = a < b ? 1 : -1;
    if (!f.is_edge_on) {
      const int side = orient2d(f.a, f.b, e.a);
      return side != 0 ? side : by_number;
    }
    const bool a_within = lies_within(source, f.a, e.a), b_within = lies_within(source, e.a, f.a);
    return a_within == b_within ? by_number : a_within ? 1 : -1;
  }

  // 1 when the crossing of a and b comes after the direction of this rank, -1 before, 0 when it lies there.
  constexpr int crossing_after(std::uint32_t a, std::uint32_t b, std::uint32_t rank) const noexcept {
    const sight_edge<T>&e = edges[a], &f = edges[b];
    const segment<T, 2> ray{source, towards[rank == ranks() ? 0 : rank]};
    return *side_of_crossing(segment<T, 2>{e.a, e.b}, segment<T, 2>{f.a, f.b}, ray);
  }

  // Negative when p comes before q, positive when after it, 0 when they are one.
  constexpr int compare_places(const place& p, const place& q) const noexcept {
    if (p.slot != q.slot) return p.slot < q.slot ? -1 : 1;
    if (p.a == no_sight_edge || q.a == no_sight_edge)
      return static_cast<int>(p.a != no_sight_edge) - static_cast<int>(q.a != no_sight_edge);
    if (p.a == q.a && p.b == q.b) return 0;
    return -compare_crossing_directions<T>(source, {&edges[p.a], &edges[p.b], &edges[q.a], &edges[q.b]});
  }

  // Where a and b cross: a slot alone where a rank has that direction, and some place beyond when it is not between
  // `from` and `to`.
  constexpr place crossing_place(std::uint32_t a, std::uint32_t b, const place& from, const place& to) const noexcept {
    // Both are seen up to the direction of rank `high`; further directions may be more than half a turn away.
    std::uint32_t low = from.slot / 2, high = to.a == no_sight_edge ? to.slot / 2 : to.slot / 2 + 1;
    const int after_low = crossing_after(a, b, low);
    if (after_low <= 0) return {2 * low, no_sight_edge, no_sight_edge};
    const int after_high = low == high ? 1 : crossing_after(a, b, high);
    if (after_high >= 0) return {2 * high + (after_high > 0 ? 1 : 0), no_sight_edge, no_sight_edge};
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      const int after = crossing_after(a, b, middle);
      if (after == 0) return {2 * middle, no_sight_edge, no_sight_edge};
      (after > 0 ? low : high) = middle;
    }
    return {2 * low + 1, a, b};
  }

  static constexpr void append(std::vector<item>& out, std::size_t first, const place& at, std::uint32_t edge) {
    const std::uint32_t last = out.size() == first ? no_sight_edge : out.back().edge;
    if (last != edge) out.push_back({at, edge});
  }

  // Appends what is nearest of a and b from `from` to `to`.
  constexpr void append_nearest(std::vector<item>& out, std::size_t first, std::uint32_t a, std::uint32_t b,
                                const std::pair<place, place>& span) {
    const auto& [from, to] = span;
    const bool both = a != no_sight_edge && b != no_sight_edge;
    const int nearer = both ? compare(a, b) : a == no_sight_edge ? -1 : 1;
    if (both) tally.compared(a, b, nearer);
    if (nearer == 1 || nearer == -1) return append(out, first, from, nearer > 0 ? a : b);
    const std::uint32_t before = nearer > 0 ? a : b, after = nearer > 0 ? b : a;
    const place at = crossing_place(a, b, from, to);
    const bool begins = compare_places(from, at) < 0, ends = compare_places(at, to) < 0;
    if (begins) append(out, first, from, before);
    if (ends) append(out, first, begins ? at : from, after);
  }

  constexpr void merge_runs(std::size_t i, std::size_t middle, std::size_t end, std::vector<item>& out) {
    const std::size_t first = out.size();
    std::size_t k = middle;
    std::uint32_t a = no_sight_edge, b = no_sight_edge;
    while (i < middle && k < end) {
      const int order = compare_places(nearest[i].at, nearest[k].at);
      const place from = order <= 0 ? nearest[i].at : nearest[k].at;
      if (order <= 0) a = nearest[i++].edge;
      if (order >= 0) b = nearest[k++].edge;
      if (i == middle || k == end) {  // one list has ended, and nothing is what its last item says
        append_last(out, first, from, {a, b}, {i, middle, k, end});
        return;
      }
      const place& to = compare_places(nearest[i].at, nearest[k].at) <= 0 ? nearest[i].at : nearest[k].at;
      append_nearest(out, first, a, b, {from, to});
    }
    for (; i < middle; ++i) append(out, first, nearest[i].at, nearest[i].edge);
  }

  // The rest of two lists, of which one has ended.
  constexpr void append_last(std::vector<item>& out, std::size_t first, const place& from,
                             const std::array<std::uint32_t, 2>& edge, const std::array<std::size_t, 4>& rest) const {
    append(out, first, from, edge[0] == no_sight_edge ? edge[1] : edge[0]);
    for (std::size_t i = rest[0]; i < rest[1]; ++i) append(out, first, nearest[i].at, nearest[i].edge);
    for (std::size_t k = rest[2]; k < rest[3]; ++k) append(out, first, nearest[k].at, nearest[k].edge);
  }
};

}  // namespace irg::detail::inline IRG_ABI
