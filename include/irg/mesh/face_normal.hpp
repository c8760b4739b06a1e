// SPDX-License-Identifier: MIT
// Normals of polygons and of faces: the sum of the triangles fanned from the first vertex, which equals Newell's sum
// taken about that vertex. It needs no convex corner, averages over a polygon that is not quite flat, and does not
// suffer from a place far from the origin.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/detail/face_normal_steps.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The plane normal of a polygon by Newell's method about its first vertex: at right angles to the plane, pointing to
/// the side from which the vertices run counter-clockwise, as long as twice the polygon's area.
/// gives   zero for fewer than three vertices and for collinear ones
/// exact   a triangle's is the cross product of two edges, computed in double; infinite where it is beyond the range
/// cost    one pass
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's method)
template <PolygonRing R>
  requires(size_of<typename ring_traits<R>::point> == 3 && Floating<scalar_of<typename ring_traits<R>::point>>)
[[nodiscard]] constexpr auto newell_normal(const R& ring) noexcept {
  using T = scalar_of<typename ring_traits<R>::point>;
  const auto position = [&](std::size_t k) { return ring_traits<R>::vertex(ring, k); };
  const detail::polygon_edges edges{ring_size(ring), position, 1, 1};
  const vec<double, 3> sum = detail::newell_sum(edges);
  return generate_coordinates<vec<T, 3>>([&](int i) { return detail::narrow<T>(sum[i]); });
}

/// The outward normal of face f, of length 1, by Newell's method about the face's first vertex.
/// needs   f < face_count
/// gives   nothing when the face has no area to working precision, or a coordinate that is NaN or infinite
/// exact   a triangle's is within 8u of the unit normal times its longest edge over its height; no overflow and no
///         underflow for finite positions of any size
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's method)
template <detail::mesh_in_space M>
[[nodiscard]] constexpr std::optional<detail::mesh_normal<M>> face_normal(const M& m, std::size_t f) noexcept {
  using V = detail::mesh_normal<M>;
  const auto unit = try_normalize(detail::newell_sum(detail::edges_of_face(m, f)));
  if (!unit) return std::nullopt;
  return generate_coordinates<V>([&](int i) { return converted<scalar_of<V>>((*unit)[i]); });
}

}  // namespace IRG_ABI
}  // namespace irg
