// SPDX-License-Identifier: MIT
// How much of a source is seen from a place, and at which lines that can change. Places come as a function that tells
// the side of a line on which they lie, and lie on no line through two of the given points. In each direction an area
// begins with an edge whose outer side is seen, a near one, and ends with a far one: all of it is seen when nothing is
// hidden of far edges, nothing when all of the near ones is, and the place is not within.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/compare.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/visibility/detail/turn_between.hpp>
#include <irg/visibility/sight_result.hpp>

namespace irg::detail::inline IRG_ABI {

// Whether a place is within a region, its edges given with the inside to their left.
// cost    a side or two for each edge
template <Floating T, class Side>
constexpr bool holds_place(const std::vector<segment<T, 2>>& outline, const Side& side) {
  if (outline.empty()) return false;
  const point<T, 2> aim = outline[0].a;
  bool is_inside = false;
  for (const auto& e : outline) {  // that cross the way from the place straight away from a corner
    if (e.a == aim || e.b == aim) continue;
    const int from = side(aim, e.a);
    if (from != side(aim, e.b) && side(e.a, e.b) == from) is_inside = !is_inside;
  }
  return is_inside;
}

enum class hidden_extent { nothing, something, everything };

enum class obstacle_place {
  ahead,
  beside
};  // what an obstacle is that runs along an edge: in front of the area behind it

template <Floating T>
struct source_view {
  std::vector<point<T, 2>> source{};  // one point, the ends of segments, or the corners of rings
  std::vector<segment<T, 2>> outline{};  // its edges, each with the source to its left: a segment there and back
  std::vector<segment<T, 2>> obstacles{};
  bool has_area = false;
};

template <Floating T>
constexpr bool is_source(const source_view<T>& view, const point<T, 2>& p) noexcept {
  for (const auto& s : view.source)
    if (s == p) return true;
  return false;
}

template <Floating T>
constexpr bool lies_on_source(const source_view<T>& view, const point<T, 2>& p) noexcept {
  for (const auto& e : view.outline)
    if (orient2d(e.a, e.b, p) == 0 && is_between_ends(e.a, e.b, p)) return true;
  return is_source(view, p);
}

// Whether the source lies on the other side of the obstacle's line than what is on side `from`.
template <Floating T>
constexpr bool parts_from_source(const source_view<T>& view, const segment<T, 2>& o, int from) noexcept {
  for (const auto& s : view.source)
    if (from == 0 || orient2d(o.a, o.b, s) != -from) return false;
  return true;
}

// Whether the line through u and v meets the source elsewhere than beyond v.
template <Floating T>
constexpr bool meets_source(const source_view<T>& view, const point<T, 2>& u, const point<T, 2>& v) noexcept {
  if (view.source.size() == 1) {
    const int axis = u.x != v.x ? 0 : 1;
    const T s = view.source[0][axis];
    return orient2d(u, v, view.source[0]) == 0 && (u[axis] < v[axis] ? s <= v[axis] : v[axis] <= s);
  }
  for (const auto& [p, q] : view.outline) {
    if (orient2d(u, v, p) * orient2d(u, v, q) > 0) continue;
    const int from = orient2d(p, q, u), to = orient2d(p, q, v);
    if (to == 0 || from != to || turn_between(segment<T, 2>{p, q}, segment<T, 2>{u, v}) != -to) return true;
  }
  return false;
}

template <Floating T, class Side>
constexpr bool sees_point(const source_view<T>& view, const Side& side) {
  const point<T, 2>& s = view.source[0];
  for (const auto& o : view.obstacles) {
    if (o.a == o.b || o.a == s || o.b == s) continue;
    const int beyond = orient2d(o.a, o.b, s);
    // Seen from the place, the ends lie on either side of the source, which lies on the other side of the obstacle.
    if (beyond != 0 && side(o.a, o.b) == -beyond && side(s, o.a) != side(s, o.b)) return false;
  }
  return true;
}

// Whether ab is nearer than pq where both are seen, for a place on the left of both. They do not cross.
template <Floating T>
constexpr bool is_in_front(const point<T, 2>& a, const point<T, 2>& b, const point<T, 2>& p, const point<T, 2>& q,
                           obstacle_place on_it) noexcept {
  const int at_a = orient2d(p, q, a), at_b = orient2d(p, q, b);
  if (at_a == 0 && at_b == 0) return on_it == obstacle_place::ahead;
  if (at_a <= 0 && at_b <= 0) return false;
  if (at_a >= 0 && at_b >= 0) return true;
  return orient2d(a, b, p) <= 0 && orient2d(a, b, q) <= 0;
}

// How much of the edge from p to q, counter-clockwise as seen from the place, obstacles hide.
template <Floating T, class Side>
constexpr hidden_extent hidden_of_edge(const source_view<T>& view, const Side& side, const point<T, 2>& p,
                                       const point<T, 2>& q, obstacle_place on_it) {
  std::vector<segment<T, 2>> hidden;
  const auto before = [&](const point<T, 2>& a, const point<T, 2>& b) { return !(a == b) && side(a, b) > 0; };
  for (const auto& o : view.obstacles) {
    if (o.a == o.b) continue;
    const bool is_forward = side(o.a, o.b) > 0;
    const point<T, 2>&a = is_forward ? o.a : o.b, &b = is_forward ? o.b : o.a;
    if (!is_in_front(a, b, p, q, on_it)) continue;
    const bool begins_within = a == p || (before(p, a) && before(a, q));
    const bool begins_before = before(a, p) && before(p, b);
    if (!begins_within && !begins_before) continue;
    const bool ends_within = b == q || (before(p, b) && before(b, q));
    hidden.push_back({begins_within ? a : p, ends_within ? b : q});
  }
  if (hidden.empty()) return hidden_extent::nothing;
  std::sort(hidden.begin(), hidden.end(), [&](const auto& x, const auto& y) { return before(x.a, y.a); });
  point<T, 2> reached = p;
  for (const auto& h : hidden) {
    if (before(reached, h.a)) return hidden_extent::something;
    if (before(reached, h.b)) reached = h.b;
  }
  return reached == q ? hidden_extent::everything : hidden_extent::something;
}

// Adds a point, a segment, or a ring with the source to its left.
template <Floating T, class Points>
constexpr void add_source(source_view<T>& view, const Points& points) {
  const std::size_t n = points.size();
  view.has_area = view.has_area || n > 2;
  for (std::size_t i = 0; i < n; ++i) {
    view.source.push_back(points[i]);
    if (n > 1) view.outline.push_back({points[i], points[(i + 1) % n]});
  }
}

template <Floating T, class Side>
constexpr seen_share share_seen(const source_view<T>& view, const Side& side) {
  if (view.source.size() == 1) return sees_point(view, side) ? seen_share::all : seen_share::none;
  bool all = true, none = true;
  for (const auto& [p, q] : view.outline) {
    const bool is_far = side(p, q) > 0;  // the place sees the inner side of this edge through the source
    const auto on_it = is_far || !view.has_area ? obstacle_place::beside : obstacle_place::ahead;
    const hidden_extent hidden = hidden_of_edge(view, side, is_far ? p : q, is_far ? q : p, on_it);
    if (is_far)
      all = all && hidden == hidden_extent::nothing;
    else
      none = none && hidden == hidden_extent::everything;
  }
  return all ? seen_share::all : none && !holds_place(view.outline, side) ? seen_share::none : seen_share::some;
}

template <Floating T>
constexpr bool crosses_obstacle(const source_view<T>& view) noexcept {
  for (const auto& e : view.outline)
    for (const auto& o : view.obstacles)
      if (cross_properly(e, o)) return true;
  return false;
}

// Whether something can change at the line through u and v, beyond v.
template <Floating T>
constexpr bool matters_beyond(const source_view<T>& view, const point<T, 2>& u, const point<T, 2>& v) noexcept {
  if (is_source(view, v) && !is_source(view, u)) return false;
  if (!meets_source(view, u, v)) return false;
  int at_u = 0, at_v = 0;  // 1 and 2: an obstacle goes on from there to the left, to the right
  for (const auto& o : view.obstacles) {
    const int a = orient2d(u, v, o.a), b = orient2d(u, v, o.b);
    const int sides = (a > 0 || b > 0 ? 1 : 0) | (a < 0 || b < 0 ? 2 : 0);
    if (o.a == u || o.b == u) at_u |= sides;
    if (o.a == v || o.b == v) at_v |= sides;
    if (a * b >= 0) continue;
    const int from = orient2d(o.a, o.b, u);
    if (from * orient2d(o.a, o.b, v) < 0 || parts_from_source(view, o, from)) return false;
  }
  return (at_u != 3 || lies_on_source(view, u)) && (at_v != 3 || is_source(view, v));
}

}  // namespace irg::detail::inline IRG_ABI
