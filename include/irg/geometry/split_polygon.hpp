// SPDX-License-Identifier: MIT
// Cutting a polygon in two: in space by a plane, in the plane by a line. Which vertices lie on which side is decided
// exactly, and two polygons that share an edge get the same new point on it.
#pragma once

#include <cstddef>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/detail/half_space.hpp>
#include <irg/geometry/detail/polygon_splitter.hpp>

namespace irg {

/// Where a polygon lies against a plane or a line.
enum class split_side {
  front,      // in front, or touching from there; nothing was cut
  back,       // behind, or touching from there
  both,       // on both sides
  on,         // all vertices on it, or none at all
  not_finite  // a number is NaN or infinite
};

/// The parts of a polygon; none of them without area.
template <PolygonVertex V>
struct split_parts {
  split_side side = split_side::on;
  std::vector<std::vector<V>> front, back;
};

/// The vertices of a polygon in a container with size() and [].
template <class R>
concept VertexRing = requires(const R& r, std::size_t i) {
  { r.size() } -> std::convertible_to<std::size_t>;
  requires PolygonVertex<std::remove_cvref_t<decltype(r[i])>>;
};

/// The type of such a ring's vertices.
template <VertexRing R>
using ring_vertex_type = std::remove_cvref_t<decltype(std::declval<const R&>()[std::size_t{}])>;

namespace detail::inline IRG_ABI {

template <int D, VertexRing R, class F>
constexpr split_parts<ring_vertex_type<R>> split(const R& ring,
                                                 const half_space<vertex_scalar<ring_vertex_type<R>>, D>& boundary,
                                                 const F& interpolate) {
  using V = ring_vertex_type<R>;
  split_parts<V> parts;
  bool finite = true, any_front = false, any_back = false;
  for (const auto& x : boundary.numbers) finite = finite && is_finite(x);
  std::vector<int> sides;
  for (std::size_t i = 0; i < ring.size() && finite; ++i) {
    const auto& p = position_of(ring[i]);
    for (int k = 0; k < D; ++k) finite = finite && is_finite(coordinate(p, k));
    if (!finite) break;
    sides.push_back(half_space_side(boundary, p));
    any_front = any_front || sides.back() > 0;
    any_back = any_back || sides.back() < 0;
  }
  parts.side = !finite                 ? split_side::not_finite
               : any_front && any_back ? split_side::both
               : any_front             ? split_side::front
               : any_back              ? split_side::back
                                       : split_side::on;
  const auto whole = [&] {
    std::vector<V> copy;
    for (std::size_t i = 0; i < ring.size(); ++i) copy.push_back(ring[i]);
    return copy;
  };
  if (parts.side == split_side::front) parts.front.push_back(whole());
  if (parts.side == split_side::back) parts.back.push_back(whole());
  if (parts.side != split_side::both) return parts;
  polygon_splitter<V, D> splitter(ring);
  splitter.cut(ring, sides, boundary, interpolate);
  parts.front = splitter.parts(1);
  parts.back = splitter.parts(-1);
  return parts;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The parts of a polygon in space before and behind a plane.
/// shape   parts run as the polygon does. Vertices on the plane belong to both sides; along the cut the parts of both
///         sides have the same vertices, all those that lie there. `interpolate(a, b, t)` makes a vertex at t of the
///         way from a, in front, to b, behind; its position is set afterwards. A polygon on one side comes back whole
/// needs   a simple polygon, convex or not, flat or nearly so; its vertices may touch its edges. Holes must be joined
///         to it by bridges
/// gives   no part without area. For a polygon that crosses itself one ring for each side, whose parts hang together
///         along the cut
/// exact   sides are decided exactly for the plane's and the vertices' numbers as they are, and so is the order along
///         the cut. A new point is at t = sa/(sa - sb) with sa and sb the plane's values at the ends, reckoned so that
///         each coordinate is within 1 ulp of the exact one and between those of the ends; from either polygon at an
///         edge it is the same. t is within 1 ulp, too
/// cost    linear, and the sorting of the points on the plane; allocates
/// source  Fuchs, Kedem and Naylor 1980, for BSP trees; the pairing of ends along the cut: Weiler and Atherton 1977
template <VertexRing R, Plane P, class F = lerp_vertex>
  requires(size_of<vertex_position<ring_vertex_type<R>>> == 3 && Real<vertex_scalar<ring_vertex_type<R>>> &&
           std::same_as<plane_scalar<P>, vertex_scalar<ring_vertex_type<R>>>)
[[nodiscard]] constexpr split_parts<ring_vertex_type<R>> split_polygon(const R& ring, const P& plane,
                                                                       const F& interpolate = {}) {
  return detail::split<3>(ring,
                          {{plane_coefficient(plane, 0), plane_coefficient(plane, 1), plane_coefficient(plane, 2),
                            plane_coefficient(plane, 3)}},
                          interpolate);
}

/// The parts of a polygon of the plane on the left (front) and on the right (back) of the line from one point over
/// another; as above.
/// gives   side `on` when the two points coincide
template <VertexRing R, class F = lerp_vertex>
  requires(size_of<vertex_position<ring_vertex_type<R>>> == 2 && Real<vertex_scalar<ring_vertex_type<R>>>)
[[nodiscard]] constexpr split_parts<ring_vertex_type<R>> split_polygon(const R& ring,
                                                                       const vertex_position<ring_vertex_type<R>>& from,
                                                                       const vertex_position<ring_vertex_type<R>>& over,
                                                                       const F& interpolate = {}) {
  return detail::split<2>(ring, {{coordinate(from, 0), coordinate(from, 1), coordinate(over, 0), coordinate(over, 1)}},
                          interpolate);
}

}  // namespace IRG_ABI
}  // namespace irg
