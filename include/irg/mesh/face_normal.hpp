// SPDX-License-Identifier: MIT
// Normals of polygons and of faces: the sum of the triangles fanned from the first vertex, which equals Newell's sum
// taken about that vertex. It needs no convex corner, averages over a polygon that is not quite flat, and does not
// suffer from a place far from the origin.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {
/// What the normals of a mesh's faces and vertices are.
template <SpaceMesh M>
using mesh_normal = vec<scalar_of<typename mesh_traits<M>::point>, 3>;

inline namespace IRG_ABI {

/// The plane normal of a polygon by Newell's method about its first vertex: at right angles to the plane, pointing to
/// the side from which the vertices run counter-clockwise, as long as twice the polygon's area.
/// gives   zero for fewer than three vertices and for collinear ones
/// exact   a triangle's is the cross product of two edges, computed in double; infinite where it is beyond the range
/// cost    one pass
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's method)
template <PolygonRing R>
  requires(size_of<typename ring_traits<R>::point> == 3 && Floating<scalar_of<typename ring_traits<R>::point>>)
[[nodiscard]] constexpr vec<scalar_of<typename ring_traits<R>::point>, 3> newell_normal(const R& ring) noexcept;

/// The outward normal of face f, of length 1, by Newell's method about the face's first vertex.
/// needs   f < face_count
/// gives   nothing when the face has no area to working precision, or a coordinate that is NaN or infinite
/// exact   a triangle's is within 8u of the unit normal times its longest edge over its height; no overflow and no
///         underflow for finite positions of any size
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's method)
template <SpaceMesh M>
[[nodiscard]] constexpr std::optional<mesh_normal<M>> face_normal(const M& m, std::size_t f) noexcept;

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_ABI {

/// The differences between the vertices of a polygon, position(0) to position(count - 1), in double and times a power
/// of two that brings the largest near 1, so that products of them stay in range for any finite positions.
/// shape   after is 0 when all vertices coincide or one is not finite
template <class Position>
struct polygon_edges {
  std::size_t count;
  Position position;
  double before = 1, after = 0;  // the factors of a difference's terms and of the difference

  IRG_INLINE constexpr vec<double, 3> operator()(std::size_t from, std::size_t to) const noexcept {
    return generate_coordinates<vec<double, 3>>([&](int i) {
      const double a = widened(coordinate(position(from), i));
      const double b = widened(coordinate(position(to), i));
      return (product(b, before) - product(a, before)) * after;
    });
  }
};

template <class Position>
constexpr polygon_edges<Position> edges_of(std::size_t count, const Position& position) noexcept {
  polygon_edges<Position> edges{count, position, 1, 1};
  double reach = 0, largest = 0;
  for (std::size_t k = 0; k < count; ++k)
    for (int i = 0; i < 3; ++i) {
      const double size = magnitude(widened(coordinate(position(k), i)));
      if (!is_finite(size)) return {count, position, 1, 0};
      reach = maximum(reach, size);
    }
  if (reach > 0x1p1022) edges.before = 0.25;  // else the difference of two finite numbers could be infinite
  for (std::size_t k = 1; k < count; ++k) {
    const vec<double, 3> v = edges(0, k);
    for (int i = 0; i < 3; ++i) largest = maximum(largest, magnitude(v[i]));
  }
  edges.after = largest > 0 ? normalizing_power_of_two(largest) : 0;
  return edges;
}

/// The sum of the triangles fanned from the first vertex, each as the cross product of its edges.
template <class Position>
constexpr vec<double, 3> newell_sum(const polygon_edges<Position>& edge) noexcept {
  vec<double, 3> sum{};
  if (edge.after == 0) return sum;
  for (std::size_t k = 2; k < edge.count; ++k) sum += cross(edge(0, k - 1), edge(0, k));
  return sum;
}

template <class M>
constexpr auto edges_of_face(const M& m, std::size_t f) noexcept {
  return edges_of(mesh_traits<M>::face_size(m, f),
                  [&m, f](std::size_t k) { return mesh_traits<M>::position(m, mesh_traits<M>::face_vertex(m, f, k)); });
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <PolygonRing R>
  requires(size_of<typename ring_traits<R>::point> == 3 && Floating<scalar_of<typename ring_traits<R>::point>>)
[[nodiscard]] constexpr vec<scalar_of<typename ring_traits<R>::point>, 3> newell_normal(const R& ring) noexcept {
  using T = scalar_of<typename ring_traits<R>::point>;
  const auto position = [&](std::size_t k) { return ring_traits<R>::vertex(ring, k); };
  const detail::polygon_edges edges{ring_size(ring), position, 1, 1};
  const vec<double, 3> sum = detail::newell_sum(edges);
  return generate_coordinates<vec<T, 3>>([&](int i) { return narrowed<T>(sum[i]); });
}

template <SpaceMesh M>
[[nodiscard]] constexpr std::optional<mesh_normal<M>> face_normal(const M& m, std::size_t f) noexcept {
  using V = mesh_normal<M>;
  const auto unit = try_normalized(detail::newell_sum(detail::edges_of_face(m, f)));
  if (!unit) return std::nullopt;
  return generate_coordinates<V>([&](int i) { return converted<scalar_of<V>>((*unit)[i]); });
}

}  // namespace irg::inline IRG_ABI
