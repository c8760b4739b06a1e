// SPDX-License-Identifier: MIT
// The parts into which segments and rays cut a window, exactly. Every line runs through two given points, every vertex
// is a given point or the crossing of two such lines, so that each decision is the sign of a polynomial in given
// numbers. Rounded vertices order the exact ones wherever they differ, as correct rounding keeps the order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/crossing_point.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/visibility/detail/turn_between.hpp>

namespace irg::detail::inline IRG_ABI {

// Twice the area between the line from point i to point i + 1 of x and point k.
struct plane_area {
  template <class Numbers>
  constexpr auto operator()(const Numbers& x, std::size_t i, std::size_t k) const {
    return (x[2 * i + 2] - x[2 * i]) * (x[2 * k + 1] - x[2 * i + 1]) -
           (x[2 * i + 3] - x[2 * i + 1]) * (x[2 * k] - x[2 * i]);
  }
};

// A point that is given, or in which the lines `first` and `second` cross. `at` is it, rounded.
template <Floating T>
struct plane_vertex {
  point<T, 2> at{};
  segment<T, 2> first{}, second{};
  bool is_given = true;
};

// The sign of p - q along an axis.
template <Floating T>
constexpr int compare_exactly(const plane_vertex<T>& p, const plane_vertex<T>& q, std::size_t axis) noexcept {
  if (p.is_given && q.is_given)
    return p.at[static_cast<int>(axis)] < q.at[static_cast<int>(axis)]   ? -1
           : p.at[static_cast<int>(axis)] > q.at[static_cast<int>(axis)] ? 1
                                                                         : 0;
  if (p.is_given) return -compare_exactly(q, p, axis);
  const int p_turn = turn_between(p.second, p.first);
  if (q.is_given) {
    const auto formula = [axis](const auto& x) {
      constexpr plane_area area{};
      return (x[axis] - x[8 + axis]) * area(x, 2, 1) - (x[2 + axis] - x[8 + axis]) * area(x, 2, 0);
    };
    return p_turn * irg::sign_of<3>(formula, plane_numbers<T, 5>({p.first.a, p.first.b, p.second.a, p.second.b, q.at}));
  }
  const auto formula = [axis](const auto& x) {
    constexpr plane_area area{};
    const auto number = [&](std::size_t i) {
      return (x[2 * i + axis] - x[axis]) * area(x, i + 2, i + 1) - (x[2 * i + 2 + axis] - x[axis]) * area(x, i + 2, i);
    };
    const auto divisor = [&](std::size_t i) { return area(x, i + 2, i + 1) - area(x, i + 2, i); };
    return number(0) * divisor(4) - number(4) * divisor(0);
  };
  return p_turn * turn_between(q.second, q.first) *
         irg::sign_of<5>(formula, plane_numbers<T, 8>({p.first.a, p.first.b, p.second.a, p.second.b, q.first.a,
                                                       q.first.b, q.second.a, q.second.b}));
}

// By x, then by y.
template <Floating T>
constexpr int compare_vertices(const plane_vertex<T>& p, const plane_vertex<T>& q) noexcept {
  for (int axis = 0; axis < 2; ++axis) {
    if (p.at[axis] < q.at[axis]) return -1;
    if (q.at[axis] < p.at[axis]) return 1;
    if (const int order = compare_exactly(p, q, static_cast<std::size_t>(axis)); order != 0) return order;
  }
  return 0;
}

// What cuts the window: from line.a to line.b, or from line.b on, away from line.a.
template <Floating T>
struct plane_cut {
  segment<T, 2> line{};
  bool is_ray = false;
  bool is_obstacle = false;  // ends rays that cross it
};

template <Floating T>
struct sight_arrangement {
  struct half_edge {
    std::uint32_t origin = 0, cut = 0;
    bool is_backward = false;  // runs against the direction of its cut
    std::uint32_t next = 0;    // along the same part, which lies to the left
  };
  struct visit {
    std::uint32_t cut, vertex;
    std::uint8_t sides;  // 1 and 2: an obstacle goes on to the left, to the right
  };

  std::vector<plane_cut<T>> cuts{};
  std::vector<point<T, 2>> sources{};  // given points at which no ray ends
  std::vector<plane_vertex<T>> vertices{};
  std::vector<half_edge> edges{};  // 2k and 2k + 1 are the same edge both ways
  box<T, 2> window{};
  std::vector<visit> visits{};  // of cuts at vertices
};

template <Floating T>
constexpr void add_visit(sight_arrangement<T>& parts, std::uint32_t cut, const plane_vertex<T>& at, int sides) {
  for (int axis = 0; axis < 2; ++axis)
    if (at.at[axis] < parts.window.low[axis] || parts.window.high[axis] < at.at[axis]) return;
  parts.visits.push_back({cut, static_cast<std::uint32_t>(parts.vertices.size()), static_cast<std::uint8_t>(sides)});
  parts.vertices.push_back(at);
}

// Whether the cut reaches the line that its ends lie on these sides of; `turn` is that from the line to the cut.
template <Floating T>
constexpr bool reaches(const plane_cut<T>& c, int a, int b, int turn) noexcept {
  return c.is_ray ? b == 0 || (a == b && turn == -a) : a * b <= 0;
}

template <Floating T>
constexpr int sides_of(const plane_cut<T>& obstacle, int a, int b) noexcept {
  if (!obstacle.is_obstacle) return 0;
  return (a > 0 || b > 0 ? 1 : 0) | (a < 0 || b < 0 ? 2 : 0);
}

// Whether a point of the line lies on the cut.
template <Floating T>
constexpr bool lies_on_cut(const plane_cut<T>& c, const point<T, 2>& p) noexcept {
  const point<T, 2>&a = c.line.a, &b = c.line.b;
  const int axis = a.x != b.x ? 0 : 1;
  const bool past_a = a[axis] < b[axis] ? a[axis] <= p[axis] : p[axis] <= a[axis];
  const bool past_b = a[axis] < b[axis] ? b[axis] <= p[axis] : p[axis] <= b[axis];
  return c.is_ray ? past_b : past_a && (!past_b || p[axis] == b[axis]);
}

template <Floating T>
constexpr void meet_cuts(sight_arrangement<T>& parts, std::uint32_t i, std::uint32_t k) {
  const plane_cut<T>&c = parts.cuts[i], &d = parts.cuts[k];
  const segment<T, 2>&s = c.line, &t = d.line;
  const int sa = orient2d(t.a, t.b, s.a), sb = orient2d(t.a, t.b, s.b), turn = turn_between(t, s);
  if (turn == 0) {
    if (sa != 0) return;
    for (const auto* p : {&s.a, &s.b, &t.a, &t.b})
      if (lies_on_cut(c, *p) && lies_on_cut(d, *p))
        for (const std::uint32_t cut : {i, k}) add_visit(parts, cut, {*p, {}, {}, true}, 0);
    return;
  }
  const int ta = orient2d(s.a, s.b, t.a), tb = orient2d(s.a, s.b, t.b);
  if (!reaches(c, sa, sb, turn) || !reaches(d, ta, tb, -turn)) return;
  plane_vertex<T> at{{}, s, t, true};
  if (sa == 0 || sb == 0) {
    at.at = sa == 0 ? s.a : s.b;
  } else if (ta == 0 || tb == 0) {
    at.at = ta == 0 ? t.a : t.b;
  } else {
    at.at = *intersection_point(s, t);
    at.is_given = false;
  }
  add_visit(parts, i, at, sides_of(d, ta, tb));
  add_visit(parts, k, at, sides_of(c, sa, sb));
}

// One number for all visits at one place, in the order of the places.
template <Floating T>
constexpr void number_vertices(sight_arrangement<T>& parts) {
  for (std::uint32_t i = 0; i < parts.cuts.size(); ++i) {
    if (!parts.cuts[i].is_ray) add_visit(parts, i, {parts.cuts[i].line.a, {}, {}, true}, 0);
    add_visit(parts, i, {parts.cuts[i].line.b, {}, {}, true}, 0);
  }
  std::vector<std::uint32_t> order(parts.vertices.size(), 0u), number(parts.vertices.size(), 0u);
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int c = compare_vertices(parts.vertices[a], parts.vertices[b]);
    return c != 0 ? c < 0 : parts.vertices[a].is_given && !parts.vertices[b].is_given;
  });
  std::vector<plane_vertex<T>> kept;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || compare_vertices(parts.vertices[order[i - 1]], parts.vertices[order[i]]) != 0)
      kept.push_back(parts.vertices[order[i]]);
    number[order[i]] = static_cast<std::uint32_t>(kept.size() - 1);
  }
  parts.vertices.swap(kept);
  for (auto& v : parts.visits) v.vertex = number[v.vertex];
}

template <Floating T>
constexpr bool runs_forward(const sight_arrangement<T>& parts, std::uint32_t cut) noexcept {
  const segment<T, 2>& s = parts.cuts[cut].line;
  return s.a.x < s.b.x || (s.a.x == s.b.x && s.a.y < s.b.y);
}

template <Floating T>
constexpr bool stops_at(const sight_arrangement<T>& parts, std::uint32_t cut,
                        const typename sight_arrangement<T>::visit& at) noexcept {
  if (!parts.cuts[cut].is_ray || at.sides != 3) return false;
  const plane_vertex<T>& v = parts.vertices[at.vertex];
  for (const point<T, 2>& s : parts.sources)
    if (v.is_given && v.at == s) return false;
  return true;
}

// The edges of all cuts, each between neighbouring vertices; rays up to where obstacles stop them.
template <Floating T>
constexpr void join_visits(sight_arrangement<T>& parts) {
  using visit = typename sight_arrangement<T>::visit;
  struct joint {
    std::uint32_t low, high, cut;  // two neighbouring vertices of a cut
  };
  std::sort(parts.visits.begin(), parts.visits.end(),
            [](const visit& a, const visit& b) { return a.cut != b.cut ? a.cut < b.cut : a.vertex < b.vertex; });
  std::vector<joint> list;
  for (std::size_t i = 0, end = 0; i < parts.visits.size(); i = end) {
    std::vector<visit> places;
    for (end = i; end < parts.visits.size() && parts.visits[end].cut == parts.visits[i].cut; ++end) {
      if (places.empty() || places.back().vertex != parts.visits[end].vertex) places.push_back(parts.visits[end]);
      places.back().sides = static_cast<std::uint8_t>(places.back().sides | parts.visits[end].sides);
    }
    const std::uint32_t cut = parts.visits[i].cut;
    if (!runs_forward(parts, cut)) std::reverse(places.begin(), places.end());
    for (std::size_t k = 0; k + 1 < places.size() && !stops_at(parts, cut, places[k]); ++k) {
      const std::uint32_t p = places[k].vertex, q = places[k + 1].vertex;
      list.push_back({p < q ? p : q, p < q ? q : p, cut});
    }
  }
  std::sort(list.begin(), list.end(), [](const joint& a, const joint& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.cut < b.cut;
  });
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0 && list[i].low == list[i - 1].low && list[i].high == list[i - 1].high) continue;
    const bool forward = runs_forward(parts, list[i].cut);
    parts.edges.push_back({list[i].low, list[i].cut, !forward, 0});
    parts.edges.push_back({list[i].high, list[i].cut, forward, 0});
  }
}

// The segment whose direction the half-edge has.
template <Floating T>
constexpr segment<T, 2> direction_of(const sight_arrangement<T>& parts,
                                     const typename sight_arrangement<T>::half_edge& e) noexcept {
  const segment<T, 2>& s = parts.cuts[e.cut].line;
  return e.is_backward ? segment<T, 2>{s.b, s.a} : s;
}

// The order of half-edges round their origin, counter-clockwise.
template <Floating T>
constexpr bool turns_before(const sight_arrangement<T>& parts, std::uint32_t a, std::uint32_t b) noexcept {
  const segment<T, 2> u = direction_of(parts, parts.edges[a]), v = direction_of(parts, parts.edges[b]);
  const auto is_late = [](const segment<T, 2>& s) { return s.b.y < s.a.y || (s.b.y == s.a.y && s.b.x < s.a.x); };
  return is_late(u) != is_late(v) ? is_late(v) : turn_between(u, v) > 0;
}

template <Floating T>
constexpr void link_edges(sight_arrangement<T>& parts) {
  std::vector<std::uint32_t> order(parts.edges.size(), 0u);
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return parts.edges[a].origin != parts.edges[b].origin ? parts.edges[a].origin < parts.edges[b].origin
                                                          : turns_before(parts, a, b);
  });
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    for (end = i; end < order.size() && parts.edges[order[end]].origin == parts.edges[order[i]].origin;) ++end;
    for (std::size_t k = i; k < end; ++k) parts.edges[order[k] ^ 1u].next = order[k == i ? end - 1 : k - 1];
  }
}

// The vertices and half-edges of what stands in `cuts`, within a window.
template <Floating T>
constexpr void build_arrangement(sight_arrangement<T>& parts, const box<T, 2>& window) {
  parts.window = window;
  for (std::uint32_t i = 0; i < parts.cuts.size(); ++i)
    for (std::uint32_t k = 0; k < i; ++k) meet_cuts(parts, i, k);
  number_vertices(parts);
  join_visits(parts);
  link_edges(parts);
}

// The side of the line from u to v on which the part to the left of a half-edge lies, close to its origin: 1 left,
// -1 right; 0 only when u == v.
template <Floating T>
constexpr int side_beside(const sight_arrangement<T>& parts, std::uint32_t edge, const point<T, 2>& u,
                          const point<T, 2>& v) noexcept {
  const plane_vertex<T>& from = parts.vertices[parts.edges[edge].origin];
  const int side =
      from.is_given ? orient2d(u, v, from.at)
                    : sign_of(side_of_crossing(from.first, from.second, segment<T, 2>{u, v}).value_or(irg::side::on));
  if (side != 0) return side;
  const segment<T, 2> way = direction_of(parts, parts.edges[edge]);
  const int turn = turn_between(segment<T, 2>{u, v}, way);
  if (turn != 0) return turn;
  // Beside a line that runs the same way is its left.
  if (u.x != v.x) return (u.x < v.x) == (way.a.x < way.b.x) ? 1 : -1;
  if (u.y != v.y) return (u.y < v.y) == (way.a.y < way.b.y) ? 1 : -1;
  return 0;
}

}  // namespace irg::detail::inline IRG_ABI
