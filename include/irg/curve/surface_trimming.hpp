// SPDX-License-Identifier: MIT
// Bezier surfaces trimmed by a polygon in the plane of their parameters, as triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/curve/detail/surface_bends.hpp>
#include <irg/curve/surface_tessellation.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/triangulate_monotone.hpp>

namespace irg::inline IRG_ABI {

/// Hands the triangles of the part of a Bezier surface that lies over a polygon in the plane of u and v to sink(corner,
/// corner, corner); no point of that part is farther from them than the tolerance.
/// shape   a ring or rings, those inside others holes (even-odd); parts outside of the unit square are left out. Edges
///         of the polygon are curves on the surface, cut where they leave a cell. Triangles counter-clockwise as u x v
///         for a polygon whose first ring is; corners are numbered one by one, also those of one place
/// gives   nothing where edges of the polygon cross or a coordinate is not finite, or is not as a number of the
///         surface's type; else as tessellate_within
/// exact   triangles that touch share their corners bit for bit: no cracks within the surface. Neighbours' borders are
///         not looked at
/// cost    for each triangle of the polygon the cells it meets, for each part three samples or more
/// source  irg's own: the polygon's triangles cut along the lines of tessellate_within
template <CurvePoint P, PlanePolygon R, class Sink>
  requires detail::PlacedPoint<P> && Floating<scalar_of<P>>
constexpr std::optional<surface_tessellation> tessellate_trimmed(const control_net<P>& net, const R& polygon,
                                                                 std::type_identity_t<scalar_of<P>> tolerance,
                                                                 Sink&& sink);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <CompiledControlPoint P>
IRG_API std::optional<surface_tessellation> send_trimmed_surface(
    const control_net<P>& net, const std::vector<point<scalar_of<P>, 2>>& places,
    const std::vector<std::array<std::uint32_t, 3>>& triangles, scalar_of<P> tolerance, const triangle_sink<P>& sink);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// Where the edge from a to b meets the line on which the coordinate `axis` is `at`; from b to a the same bits.
template <Floating T>
constexpr point<T, 2> edge_at(const point<T, 2>& a, const point<T, 2>& b, int axis, T at) noexcept {
  const T scale = is_finite(b[axis] - a[axis]) ? T(1) : T(0.5);
  const T length = b[axis] * scale - a[axis] * scale;  // exact products
  const curve_parameter<T> share{(b[axis] - at) * scale / length, (at - a[axis]) * scale / length};
  point<T, 2> p = blend(a, b, share);
  p[axis] = at;
  return p;
}

// Cuts a convex polygon by such a line: what is below goes to `below`, what is above stays.
template <Floating T>
constexpr void cut_off_below(std::vector<point<T, 2>>& polygon, int axis, T at, std::vector<point<T, 2>>& below,
                             std::vector<point<T, 2>>& above) {
  below.clear();
  above.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const point<T, 2>&p = polygon[k], &q = polygon[k + 1 < polygon.size() ? k + 1 : 0];
    if (p[axis] <= at) below.push_back(p);
    if (p[axis] >= at) above.push_back(p);
    if ((p[axis] < at && at < q[axis]) || (q[axis] < at && at < p[axis])) {
      const point<T, 2> crossing = edge_at(p, q, axis, at);
      below.push_back(crossing);
      above.push_back(crossing);
    }
  }
  polygon.swap(above);
}

// Hands the parts of a convex polygon between successive lines to each(part); what is outside of all is left out.
template <Floating T, class Each>
constexpr void each_part(std::vector<point<T, 2>> polygon, int axis, const patch_cuts& cuts, const Each& each) {
  std::vector<point<T, 2>> below, above;
  for (std::size_t k = 0; k < cuts.places.size() && polygon.size() > 2; ++k) {
    cut_off_below(polygon, axis, static_cast<T>(cuts[k]) / static_cast<T>(patch_steps), below, above);
    if (k > 0 && below.size() > 2) each(below);
  }
}

// The triangles of a polygon, cut along the lines of a surface.
template <CurvePoint P, class Sink>
constexpr std::optional<surface_tessellation> tessellate_parts(
    const control_net<P>& net, const std::vector<point<scalar_of<P>, 2>>& places,
    const std::vector<std::array<std::uint32_t, 3>>& triangles, scalar_of<P> tolerance, Sink& sink) {
  using T = scalar_of<P>;
  using corner = surface_corner<P>;
  surface_tessellation done;
  if (!has_finite_bends(net)) return surface_tessellation{0, 0, false};
  if (net.rows() < 2 || net.columns < 2) return done;
  patch_bends<P> bends(net);
  const auto along_u = cuts_of_patch(bends, tolerance, true), along_v = cuts_of_patch(bends, tolerance, false);
  done.within_tolerance = along_u.within && along_v.within;
  for (const auto& p : places)
    if (!is_finite(p)) return std::nullopt;
  std::vector<P> room(2 * net.columns + net.rows(), P{});
  std::vector<corner> corners;
  const auto put = [&](const std::vector<point<T, 2>>& part) {
    corners.clear();
    for (const auto& p : part) {
      const curve_parameter<T> u(p.x), v(p.y);
      corners.push_back({done.corners++, u, v, on_surface(patch_sample(net, u, v, room).point)});
    }
    for (std::size_t k = 2; k < corners.size(); ++k) put_triangle(done, sink, corners[0], corners[k - 1], corners[k]);
  };
  for (const std::array<std::uint32_t, 3>& t : triangles)
    each_part<T>({places[t[0]], places[t[1]], places[t[2]]}, 0, along_u,
                 [&](const auto& strip) { each_part<T>(strip, 1, along_v, put); });
  return done;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <CurvePoint P, PlanePolygon R, class Sink>
  requires detail::PlacedPoint<P> && Floating<scalar_of<P>>
constexpr std::optional<surface_tessellation> tessellate_trimmed(const control_net<P>& net, const R& polygon,
                                                                 std::type_identity_t<scalar_of<P>> tolerance,
                                                                 Sink&& sink) {
  using T = scalar_of<P>;
  const triangulation parts = triangulate_monotone(polygon);
  if (parts.status != triangulation_status::ok) return std::nullopt;
  std::vector<point<T, 2>> places;
  const auto add = [&](const auto& ring) {
    for (std::size_t k = 0; k < ring_size(ring); ++k) {
      const auto p = ring_vertex(ring, k);
      places.push_back({converted<T>(coordinate(p, 0)), converted<T>(coordinate(p, 1))});
    }
  };
  if constexpr (PlaneRing<R>)
    add(polygon);
  else
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::size(polygon)); ++i) add(polygon[i]);
  if constexpr (!IRG_BODIES && detail::CompiledControlPoint<P>)
    return detail::send_trimmed_surface(
        net, places, parts.triangles, tolerance,
        as_function<void(const surface_corner<P>&, const surface_corner<P>&, const surface_corner<P>&)>(sink));
  else
    return detail::tessellate_parts(net, places, parts.triangles, tolerance, sink);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <CompiledControlPoint P>
IRG_API std::optional<surface_tessellation> send_trimmed_surface(
    const control_net<P>& net, const std::vector<point<scalar_of<P>, 2>>& places,
    const std::vector<std::array<std::uint32_t, 3>>& triangles, scalar_of<P> tolerance, const triangle_sink<P>& sink) {
  return tessellate_parts(net, places, triangles, tolerance, sink);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
