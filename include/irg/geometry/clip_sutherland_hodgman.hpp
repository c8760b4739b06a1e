// SPDX-License-Identifier: MIT
// Sutherland and Hodgman's polygon clipping, in the plane against windows and convex polygons, in space against convex
// regions given by planes, such as a view pyramid's. Edges of the result that run along a boundary are the price of its
// simplicity where the polygon is not convex; polygon_overlay gives the pieces apart.
#pragma once

#include <span>
#include <vector>

#include <irg/geometry/clipped_line.hpp>
#include <irg/geometry/detail/clip_sutherland_hodgman_steps.hpp>
#include <irg/geometry/detail/convex_clipper.hpp>
#include <irg/geometry/detail/window_pipe.hpp>
#include <irg/geometry/detail/window_walk_kernel.hpp>

namespace irg {

/// Polygon vertices one after the other in memory. Models: std::vector<point<double, 2>>, a plain array, std::span.
template <class R>
concept VertexRange = requires(const R& r) {
  std::data(r);
  { std::size(r) } -> std::convertible_to<std::size_t>;
  requires PolygonVertex<std::remove_cvref_t<decltype(*std::data(r))>>;
};

/// The vertex type of a VertexRange.
template <VertexRange R>
using range_vertex = std::remove_cvref_t<decltype(*std::data(std::declval<const R&>()))>;

/// What a polygon with vertices of type V can be clipped to: a window or a convex polygon in the plane, planes in
/// space.
template <class Region, class V>
concept ClipRegion = (size_of<vertex_position<V>> == 2 && detail::is_window_for<Region, V>) ||
                     detail::convex_ring_for<Region, V> || detail::planes_for<Region, V>;

/// What interpolates vertices of type V.
template <class F, class V>
concept VertexInterpolation = requires(const F& f, const V& v, const vertex_scalar<V>& t) {
  { f(v, v, t) } -> std::convertible_to<V>;
};

inline namespace IRG_ABI {

/// The part of a polygon that lies in a window (box<T, 2>), in a convex polygon of either orientation, or, in space, on
/// or above all planes, into the caller's memory; the number of its vertices.
/// shape   the winding is kept, as is the first vertex when it is inside; points on a boundary are inside, and cuts are
///         not doubled, nor is a last vertex at the place of the first. `interpolate(a, b, t)` makes what a vertex
///         carries along, lerp_vertex as default; it is called with the ends of the given edge, or of the stretch along
///         a boundary, in an order that does not depend on the direction
/// gives   0 when nothing or no area is left, when the region is empty, and when a coordinate is NaN or infinite; a
///         number beyond out.size() when that is too small, and what fits is written. A polygon that is not convex
///         comes out as one ring whatever falls apart: pieces are joined by edges along the boundary, there and back
/// exact   every corner is a given vertex or a corner of the region, bit for bit, or where a given edge meets a
///         boundary, each coordinate correctly rounded; which of them there are is decided exactly, for all finite
///         floats and doubles. Polygons that share an edge cut it at the same points. Clipping again changes nothing,
///         bit for bit: a polygon whose vertices are all points of the region, rounded, comes back as it is; against
///         planes, one whose vertices are points of each half-space, rounded. In space two planes meet in the
///         polygon's plane, correctly rounded, too. If more than three vertices are not flat, that is the plane through
///         three of them, a third of the way round apart, where this leads into the region; else the place where the
///         line between the two cuts, rounded, seen along an axis, meets both planes, or the cut that is inside
/// cost    windows: for up to 64 plain points 2 to 3 ns per vertex and some 25 per edge that passes a boundary; else,
///         and in delicate cases, about twice as much or more; nothing allocates. Other regions: 3 ns per vertex and
///         boundary, 0.1 us per cut, 0.2 us per cut that is left in the end (where two planes meet 0.4), and two
///         allocations. Numbers beyond 2^+-80 some 5 us per cut and boundary
/// source  Sutherland and Hodgman 1974
template <VertexRange R, class Region, class F = lerp_vertex>
  requires ClipRegion<Region, range_vertex<R>> && VertexInterpolation<F, range_vertex<R>>
constexpr std::size_t clip_sutherland_hodgman(const R& polygon, const Region& region,
                                              std::type_identity_t<std::span<range_vertex<R>>> out,
                                              const F& interpolate = {}) {
  using V = range_vertex<R>;
  const std::span<const V> given(std::data(polygon), static_cast<std::size_t>(std::size(polygon)));
  if constexpr (Point<V> && Floating<vertex_scalar<V>> && detail::is_window_for<Region, V>)
    if (given.size() >= 3 && given.size() <= detail::few_vertices && region.low.x < region.high.x &&
        region.low.y < region.high.y)
      if (const auto count = detail::clip_few(given, region, out); count >= 0) return static_cast<std::size_t>(count);
  detail::span_sink<V> sink{out.data(), out.size()};
  detail::clip_into(given, region, interpolate, sink);
  return sink.finished();
}

/// As above, into memory of its own.
template <VertexRange R, class Region, class F = lerp_vertex>
  requires ClipRegion<Region, range_vertex<R>> && VertexInterpolation<F, range_vertex<R>>
[[nodiscard]] constexpr std::vector<range_vertex<R>> clip_sutherland_hodgman(const R& polygon, const Region& region,
                                                                             const F& interpolate = {}) {
  using V = range_vertex<R>;
  if (std::size(polygon) == 0) return {};
  const V& any = *std::data(polygon);  // V{} of a foreign type may leave its numbers as they are
  std::vector<V> kept(static_cast<std::size_t>(std::size(polygon)) * 2 + 8, any);
  std::size_t count = clip_sutherland_hodgman(polygon, region, std::span<V>(kept), interpolate);
  if (count > kept.size()) {
    kept.resize(count, any);
    count = clip_sutherland_hodgman(polygon, region, std::span<V>(kept), interpolate);
  }
  kept.resize(count, any);
  return kept;
}

}  // namespace IRG_ABI
}  // namespace irg
