// SPDX-License-Identifier: MIT
// Whether two polygons of the plane share area, only touch, or have no point in common, decided exactly: convex ones by
// a separating edge, any simple ones by crossings of edges and containment.
#pragma once

#include <cstddef>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// What two polygons have in common.
enum class polygon_overlap {
  separate,  // no point
  touching,  // points of their boundaries, but no area
  overlapping,  // area
};

namespace detail::inline IRG_ABI {

// The stretch of a ring that lies on a line: the first and the last of its vertices there.
template <Point P>
struct stretch_on_line {
  assignable<P> first, last;
  bool any = false;
  IRG_INLINE constexpr void add(const P& q) noexcept {
    const auto p = as_assignable(q);
    if (!any || comes_before(p, first)) first = p;
    if (!any || comes_before(last, p)) last = p;
    any = true;
  }
};

// What an edge from p to q says of `other`, which lies on `side` of it or on its line, and of `own`, which lies on the
// other side or on the line: what they have in common lies there. `overlapping` when it says nothing.
template <PlaneRing A, PlaneRing B>
constexpr polygon_overlap across_edge(const A& own, const B& other, const ring_point<A>& p, const ring_point<A>& q,
                                      int side) noexcept {
  stretch_on_line<ring_point<A>> a{as_assignable(p), as_assignable(p)}, b = a;
  for (std::size_t i = 0; i < ring_size(other); ++i) {
    const auto v = ring_vertex(other, i);
    const int turn = orient2d(p, q, v);
    if (turn == -side) return polygon_overlap::overlapping;
    if (turn == 0) b.add(v);
  }
  if (!b.any) return polygon_overlap::separate;
  for (std::size_t i = 0; i < ring_size(own); ++i) {
    const auto v = ring_vertex(own, i);
    if (orient2d(p, q, v) == 0) a.add(v);
  }
  const bool apart = comes_before(a.last, b.first) || comes_before(b.last, a.first);
  return apart ? polygon_overlap::separate : polygon_overlap::touching;
}

// The answer of the first edge of `own` that has `other` on its outer side; `overlapping` when there is none. A ring
// without area has two outer sides.
template <PlaneRing A, PlaneRing B>
constexpr polygon_overlap separated_by(const A& own, const B& other) noexcept {
  const int direction = shoelace_sign(own);
  for (std::size_t i = 0; i < ring_size(own); ++i) {
    const auto p = ring_vertex(own, i), q = ring_vertex(own, i + 1);
    if (same_place(p, q)) continue;
    for (const int side : {-1, 1}) {
      if (side == direction) continue;
      const polygon_overlap found = across_edge(own, other, p, q, side);
      if (found != polygon_overlap::overlapping) return found;
    }
  }
  return polygon_overlap::overlapping;
}

template <PlaneRing R>
constexpr bool is_one_place(const R& ring) noexcept {
  for (std::size_t i = 1; i < ring_size(ring); ++i)
    if (!same_place(ring_vertex(ring, 0), ring_vertex(ring, i))) return false;
  return true;
}

// Whether the direction from p to v lies strictly inside the angle at p that opens counter-clockwise from u to w.
template <Point P>
constexpr bool is_within_angle(const P& p, const P& u, const P& w, const P& v) noexcept {
  const int opening = orient2d(p, u, w);
  if (opening > 0) return orient2d(p, u, v) > 0 && orient2d(p, v, w) > 0;
  if (opening < 0) return !(orient2d(p, w, v) >= 0 && orient2d(p, v, u) >= 0);
  return orient2d(p, u, v) > 0;  // straight
}
template <Point P>
constexpr bool same_direction(const P& p, const P& u, const P& v) noexcept {
  return orient2d(p, u, v) == 0 && comes_before(p, u) == comes_before(p, v);
}
// Whether two angles at p, each counter-clockwise from its first to its second point, have an open part in common.
template <Point P>
constexpr bool angles_overlap(const P& p, const P& u1, const P& w1, const P& u2, const P& w2) noexcept {
  return same_direction(p, u1, u2) || same_direction(p, w1, w2) || is_within_angle(p, u1, w1, u2) ||
         is_within_angle(p, u2, w2, u1) || is_within_angle(p, u1, w1, w2) || is_within_angle(p, u2, w2, w1);
}

// One edge of a counter-clockwise ring with what comes before it and after it.
template <Point P>
struct edge_with_neighbours {
  P before, from, to;
};

// How an edge of one ring meets an edge of another, both rings with the inside on their left.
template <Point P>
constexpr polygon_overlap meet_edges(const edge_with_neighbours<P>& a, const edge_with_neighbours<P>& b) noexcept {
  const int b_from = orient2d(a.from, a.to, b.from), b_to = orient2d(a.from, a.to, b.to);
  if (b_from * b_to > 0) return polygon_overlap::separate;
  const int a_from = orient2d(b.from, b.to, a.from), a_to = orient2d(b.from, b.to, a.to);
  if (a_from * a_to > 0) return polygon_overlap::separate;
  if (b_from * b_to < 0 && a_from * a_to < 0) return polygon_overlap::overlapping;
  // They may meet at the beginning of one; where they meet at an end, the edge from there on has its turn.
  const bool b_starts_on_a = b_from == 0 && is_between(a.from, a.to, b.from);
  const bool a_starts_on_b = a_from == 0 && is_between(b.from, b.to, a.from);
  const bool a_whole = b_starts_on_a && !same_place(b.from, a.from);  // and inside its length, or at its end
  const bool b_whole = a_starts_on_b && !same_place(a.from, b.from);
  if (b_starts_on_a && same_place(b.from, a.from))
    return angles_overlap(a.from, a.to, a.before, b.to, b.before) ? polygon_overlap::overlapping
                                                                  : polygon_overlap::touching;
  if (a_whole && !same_place(b.from, a.to) && angles_overlap(b.from, a.to, a.from, b.to, b.before))
    return polygon_overlap::overlapping;
  if (b_whole && !same_place(a.from, b.to) && angles_overlap(a.from, b.to, b.from, a.to, a.before))
    return polygon_overlap::overlapping;
  const bool ends_meet = (b_to == 0 && is_between(a.from, a.to, b.to)) || (a_to == 0 && is_between(b.from, b.to, a.to));
  return a_whole || b_whole || ends_meet ? polygon_overlap::touching : polygon_overlap::separate;
}

// Calls f(edge) for each edge that has a length, until it returns false.
template <class R, class F>
constexpr bool each_edge_with_neighbours(const R& ring, const F& f) noexcept {
  const std::size_t n = ring_size(ring);
  auto before = as_assignable(ring_vertex(ring, 0));
  for (std::size_t i = n; i-- > 1;)
    if (!same_place(ring_vertex(ring, i), ring_vertex(ring, 0))) {
      before = as_assignable(ring_vertex(ring, i));
      break;
    }
  for (std::size_t i = 0; i < n; ++i) {
    const auto from = as_assignable(ring_vertex(ring, i)), to = as_assignable(ring_vertex(ring, i + 1));
    if (same_place(from, to)) continue;
    if (!f(edge_with_neighbours<assignable<ring_point<R>>>{before, from, to})) return false;
    before = from;
  }
  return true;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// What two convex polygons have in common; each may run either way round, have collinear and repeated vertices, and be
/// a segment or a point.
/// needs   is_convex of both, finite coordinates
/// gives   `touching` for what meets a polygon without area, wherever; `separate` from an empty ring
/// exact   for all finite floats and all integers; other scalars: as exact as their own + - * are
/// cost    up to n * m turns; ends at the first edge that separates the polygons
/// source  irg's own, by the separating axis theorem: disjoint convex polygons are separated by the line of an edge
template <PlaneRing A, PlaneRing B>
  requires std::same_as<ring_point<A>, ring_point<B>>
[[nodiscard]] constexpr polygon_overlap convex_polygons_overlap(const A& a, const B& b) noexcept {
  if (ring_size(a) == 0 || ring_size(b) == 0) return polygon_overlap::separate;
  const polygon_overlap by_a = detail::separated_by(a, b);
  if (by_a != polygon_overlap::overlapping) return by_a;
  const polygon_overlap by_b = detail::separated_by(b, a);
  if (by_b != polygon_overlap::overlapping) return by_b;
  const auto p = ring_vertex(a, 0), q = ring_vertex(b, 0);
  const bool a_is_point = detail::is_one_place(a), b_is_point = detail::is_one_place(b);
  if (a_is_point && b_is_point && !same_place(p, q)) return polygon_overlap::separate;
  const bool flat = detail::shoelace_sign(a) == 0 || detail::shoelace_sign(b) == 0;
  return flat ? polygon_overlap::touching : polygon_overlap::overlapping;
}

/// What two simple polygons have in common, convex or not; each may run either way round and have collinear and
/// repeated vertices.
/// needs   rings with area that do not cross or touch themselves (touching vertices may give `overlapping` for polygons
///         that only touch there), finite coordinates
/// gives   `separate` when a ring has no area
/// exact   as convex_polygons_overlap
/// cost    n * m comparisons of edges' extents, turns where these overlap
/// source  irg's own: edge crossings and containment; at common points the angles of both polygons are compared
template <PlaneRing A, PlaneRing B>
  requires std::same_as<ring_point<A>, ring_point<B>>
[[nodiscard]] constexpr polygon_overlap polygons_overlap(const A& a, const B& b) noexcept {
  const auto ring_a = counter_clockwise_ring(a);
  const auto ring_b = counter_clockwise_ring(b);
  if (orientation_of(a) == orientation::degenerate || orientation_of(b) == orientation::degenerate)
    return polygon_overlap::separate;
  const auto apart = [](const auto& p, const auto& q, const auto& r, const auto& s, int k) {
    const auto low = [&](const auto& u, const auto& v) { return minimum(coordinate(u, k), coordinate(v, k)); };
    const auto high = [&](const auto& u, const auto& v) { return maximum(coordinate(u, k), coordinate(v, k)); };
    return high(p, q) < low(r, s) || high(r, s) < low(p, q);
  };
  bool touching = false;
  const bool done = !detail::each_edge_with_neighbours(ring_a, [&](const auto& e) {
    return detail::each_edge_with_neighbours(ring_b, [&](const auto& f) {
      if (apart(e.from, e.to, f.from, f.to, 0) || apart(e.from, e.to, f.from, f.to, 1)) return true;
      const polygon_overlap found = detail::meet_edges(e, f);
      touching = touching || found == polygon_overlap::touching;
      return found != polygon_overlap::overlapping;
    });
  });
  if (done) return polygon_overlap::overlapping;
  // No edge enters the other polygon: one lies inside the other as a whole, or in no part.
  const auto holds_vertex_of = [](const auto& outer, const auto& inner) {
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const location where = locate_point(outer, inner[i]);
      if (where != location::boundary) return where == location::inside;
    }
    return false;
  };
  if (holds_vertex_of(ring_a, ring_b) || holds_vertex_of(ring_b, ring_a)) return polygon_overlap::overlapping;
  return touching ? polygon_overlap::touching : polygon_overlap::separate;
}

}  // namespace IRG_ABI
}  // namespace irg
