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

template <Floating T>
class source_view {
public:
  std::vector<point<T, 2>> source{};  // one point, the ends of segments, or the corners of rings
  std::vector<segment<T, 2>> outline{};  // its edges, each with the source to its left: a segment there and back
  std::vector<segment<T, 2>> obstacles{};
  bool has_area = false;

  /// Adds a point, a segment, or a ring with the source to its left.
  template <class Points>
  constexpr void add_source(const Points& points) {
    const std::size_t n = points.size();
    has_area = has_area || n > 2;
    for (std::size_t i = 0; i < n; ++i) {
      source.push_back(points[i]);
      if (n > 1) outline.push_back({points[i], points[(i + 1) % n]});
    }
  }

  template <class Side>
  constexpr seen_share share(const Side& side) const {
    if (source.size() == 1) return sees_point(side) ? seen_share::all : seen_share::none;
    bool all = true, none = true;
    for (const auto& [p, q] : outline) {
      const bool is_far = side(p, q) > 0;  // the place sees the inner side of this edge through the source
      const coverage hidden =
          is_far ? cover(side, p, q, along::beside) : cover(side, q, p, has_area ? along::ahead : along::beside);
      if (is_far)
        all = all && hidden == coverage::nothing;
      else
        none = none && hidden == coverage::everything;
    }
    return all ? seen_share::all : none && !holds_place(outline, side) ? seen_share::none : seen_share::some;
  }

  constexpr bool crosses_obstacle() const noexcept {
    for (const auto& e : outline)
      for (const auto& o : obstacles)
        if (cross_properly(e.a, e.b, o)) return true;
    return false;
  }

  /// Whether something can change at the line through u and v, beyond v.
  constexpr bool matters_beyond(const point<T, 2>& u, const point<T, 2>& v) const noexcept {
    if (is_source(v) && !is_source(u)) return false;
    if (!meets_source(u, v)) return false;
    int at_u = 0, at_v = 0;  // 1 and 2: an obstacle goes on from there to the left, to the right
    for (const auto& o : obstacles) {
      const int a = orient2d(u, v, o.a), b = orient2d(u, v, o.b);
      const int sides = (a > 0 || b > 0 ? 1 : 0) | (a < 0 || b < 0 ? 2 : 0);
      if (o.a == u || o.b == u) at_u |= sides;
      if (o.a == v || o.b == v) at_v |= sides;
      if (a * b >= 0) continue;
      const int from = orient2d(o.a, o.b, u);
      if (from * orient2d(o.a, o.b, v) < 0 || parts_from_source(o, from)) return false;
    }
    return (at_u != 3 || lies_on_source(u)) && (at_v != 3 || is_source(v));
  }

private:
  enum class coverage { nothing, something, everything };
  enum class along { ahead, beside };  // what an obstacle is that runs along an edge: in front of the area behind it
  struct span_of_view {
    point<T, 2> from, to;
  };

  constexpr bool is_source(const point<T, 2>& p) const noexcept {
    for (const auto& s : source)
      if (s == p) return true;
    return false;
  }

  constexpr bool lies_on_source(const point<T, 2>& p) const noexcept {
    const auto within = [](T from, T to, T v) { return from < to ? from <= v && v <= to : to <= v && v <= from; };
    for (const auto& e : outline)
      if (orient2d(e.a, e.b, p) == 0 && within(e.a.x, e.b.x, p.x) && within(e.a.y, e.b.y, p.y)) return true;
    return is_source(p);
  }

  static constexpr bool cross_properly(const point<T, 2>& p, const point<T, 2>& q, const segment<T, 2>& o) noexcept {
    return orient2d(p, q, o.a) * orient2d(p, q, o.b) < 0 && orient2d(o.a, o.b, p) * orient2d(o.a, o.b, q) < 0;
  }

  // Whether the source lies on the other side of the obstacle's line than what is on side `from`.
  constexpr bool parts_from_source(const segment<T, 2>& o, int from) const noexcept {
    for (const auto& s : source)
      if (from == 0 || orient2d(o.a, o.b, s) != -from) return false;
    return true;
  }

  // Whether the line through u and v meets the source elsewhere than beyond v.
  constexpr bool meets_source(const point<T, 2>& u, const point<T, 2>& v) const noexcept {
    if (source.size() == 1) {
      const int axis = u.x != v.x ? 0 : 1;
      const T s = source[0][axis];
      return orient2d(u, v, source[0]) == 0 && (u[axis] < v[axis] ? s <= v[axis] : v[axis] <= s);
    }
    for (const auto& [p, q] : outline) {
      if (orient2d(u, v, p) * orient2d(u, v, q) > 0) continue;
      const int from = orient2d(p, q, u), to = orient2d(p, q, v);
      if (to == 0 || from != to || turn_between(segment<T, 2>{p, q}, segment<T, 2>{u, v}) != -to) return true;
    }
    return false;
  }

  template <class Side>
  constexpr bool sees_point(const Side& side) const {
    const point<T, 2>& s = source[0];
    for (const auto& o : obstacles) {
      if (o.a == o.b || o.a == s || o.b == s) continue;
      const int beyond = orient2d(o.a, o.b, s);
      // Seen from the place, the ends lie on either side of the source, which lies on the other side of the obstacle.
      if (beyond != 0 && side(o.a, o.b) == -beyond && side(s, o.a) != side(s, o.b)) return false;
    }
    return true;
  }

  // How much of the edge from p to q, counter-clockwise as seen from the place, obstacles hide.
  template <class Side>
  constexpr coverage cover(const Side& side, const point<T, 2>& p, const point<T, 2>& q, along on_it) const {
    std::vector<span_of_view> hidden;
    const auto before = [&](const point<T, 2>& a, const point<T, 2>& b) { return !(a == b) && side(a, b) > 0; };
    for (const auto& o : obstacles) {
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
    if (hidden.empty()) return coverage::nothing;
    std::sort(hidden.begin(), hidden.end(), [&](const auto& x, const auto& y) { return before(x.from, y.from); });
    point<T, 2> reached = p;
    for (const auto& h : hidden) {
      if (before(reached, h.from)) return coverage::something;
      if (before(reached, h.to)) reached = h.to;
    }
    return reached == q ? coverage::everything : coverage::something;
  }

  // Whether ab is nearer than pq where both are seen, for a place on the left of both. They do not cross.
  static constexpr bool is_in_front(const point<T, 2>& a, const point<T, 2>& b, const point<T, 2>& p,
                                    const point<T, 2>& q, along on_it) noexcept {
    const int at_a = orient2d(p, q, a), at_b = orient2d(p, q, b);
    if (at_a == 0 && at_b == 0) return on_it == along::ahead;
    if (at_a <= 0 && at_b <= 0) return false;
    if (at_a >= 0 && at_b >= 0) return true;
    return orient2d(a, b, p) <= 0 && orient2d(a, b, q) <= 0;
  }
};

}  // namespace irg::detail::inline IRG_ABI
