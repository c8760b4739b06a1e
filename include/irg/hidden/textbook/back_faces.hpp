// SPDX-License-Identifier: MIT
// Back faces by the rules of three sources, each with the limits that it has there. facing_by_plane, facing_by_angle
// and facing_by_order (hidden/back_faces.hpp) are the ones to use.
#pragma once

#include <irg/hidden/back_faces.hpp>

namespace irg::textbook::inline IRG_ABI {

/// Whether a face is a back face by the lecture's rule: some edge has no vertex inside of it. Polygons with collinear
/// vertices alone count as back faces.
/// needs   a convex polygon: of a concave one every edge may lie within the hull, and its back goes unnoticed
/// exact   the sign of the edge (y1 - y2, x2 - x1, x1 y2 - x2 y1) at each vertex, as orient2d decides it
/// cost    n^2 decisions
/// source  Mihajlovic 2016, 7.3, for clockwise vertices; for counter-clockwise ones, as the same lecture lists them
///         elsewhere, with the inequality reversed
template <PlaneRing R>
[[nodiscard]] constexpr bool is_back_by_edges(const R& projected, orientation order = orientation::clockwise) noexcept {
  const std::size_t n = ring_size(projected);
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = ring_vertex(projected, i), q = ring_vertex(projected, i + 1 < n ? i + 1 : 0);
    bool outside = true;
    for (std::size_t j = 0; j < n && outside; ++j) {
      const int side = orient2d(p, q, ring_vertex(projected, j));
      outside = order == orientation::clockwise ? side >= 0 : side <= 0;
    }
    if (outside) return true;
  }
  return false;
}

/// The normal of a face whose vertices are counter-clockwise seen from outside: (p3 - p2) x (p1 - p2), outward.
/// gives   0 for collinear points
/// exact   in integers and rationals
/// source  Hidden-surface slides
template <Scalar T>
[[nodiscard]] IRG_INLINE constexpr vec<T, 3> face_normal(const point<T, 3>& p1, const point<T, 3>& p2,
                                                         const point<T, 3>& p3) noexcept {
  return cross(p3 - p2, p1 - p2);
}

/// The mixed product w . (v x u) of a face and a viewer in (0, 0, d): positive when the viewer sees the front.
/// shape   v = p3 - p2, u = p1 - p2, w = (0, 0, d) - p2
/// exact   in integers and rationals, in the order of terms of the source
/// source  Hidden-surface slides
template <Scalar T>
[[nodiscard]] constexpr T mixed_product(const point<T, 3>& p1, const point<T, 3>& p2, const point<T, 3>& p3,
                                        const T& d) noexcept {
  const vec<T, 3> v = p3 - p2, u = p1 - p2, w = point<T, 3>{T(0), T(0), d} - p2;
  return product(w.x, product(v.y, u.z) - product(u.y, v.z)) - product(w.y, product(v.x, u.z) - product(u.x, v.z)) +
         product(w.z, product(v.x, u.y) - product(u.x, v.y));
}

/// Whether a polygon is hidden from a viewer in (0, 0, d), by its first three vertices.
/// needs   three vertices, the first three not collinear
/// gives   faces seen from their edge: hidden, as the slides' text has it; their procedure draws them
/// exact   the sign of mixed_product, as orient3d decides it
/// source  Hidden-surface slides, procedure HiddenPoly
template <PolygonRing R>
  requires(size_of<typename ring_traits<R>::point> == 3)
[[nodiscard]] constexpr bool is_hidden_polygon(const R& polygon, const ring_scalar<R>& d,
                                               edge_on_faces edge_on = edge_on_faces::hidden) noexcept {
  IRG_EXPECTS(ring_size(polygon) >= 3);
  using T = ring_scalar<R>;
  const auto p = [&](std::size_t i) {
    return generate_coordinates<point<T, 3>>([&](int k) { return coordinate(ring_vertex(polygon, i), k); });
  };
  return is_hidden(static_cast<facing>(orient3d(p(0), p(1), p(2), point<T, 3>{T(0), T(0), d})), edge_on);
}

/// Whether a face is a back face by the camera's z axis alone: z . normal > 0.
/// needs   parallel projection along z, which points from the camera into the scene: under central projection the rule
///         errs in both directions
/// gives   false, which is visible, for faces seen from their edge
/// exact   for every finite float, double and integer
/// source  Hank n.d., 4.1.5.1
template <Scalar T>
[[nodiscard]] constexpr bool is_back_by_axis(const vec<T, 3>& camera_z, const vec<T, 3>& normal) noexcept {
  const point<T, 3> origin{};
  return order_along_line(origin, point<T, 3>{camera_z.x, camera_z.y, camera_z.z},
                          point<T, 3>{normal.x, normal.y, normal.z}, origin) > 0;
}

}  // namespace irg::textbook::inline IRG_ABI
