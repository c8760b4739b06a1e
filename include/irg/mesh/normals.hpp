// SPDX-License-Identifier: MIT
// Normals of faces and of vertices. The normal of a polygon is the sum of the triangles fanned from its first vertex,
// which equals Newell's sum taken about that vertex: it needs no convex corner, averages over a polygon that is not
// quite flat, and does not suffer from a place far from the origin.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// How much each face around a vertex counts for the vertex's normal.
enum class normal_weight {
  average,  // all faces alike: the course's form; depends on how polygons are cut into triangles
  angle,    // by the face's angle at the vertex; does not depend on it
  area,     // by the face's area; does not depend on it as long as the vertex keeps its share of the area
};

namespace detail {

template <class M>
concept mesh_in_space =
    Mesh<M> && size_of<typename mesh_traits<M>::point> == 3 && Floating<scalar_of<typename mesh_traits<M>::point>>;
template <mesh_in_space M>
using mesh_normal = vec<scalar_of<typename mesh_traits<M>::point>, 3>;

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

inline namespace IRG_ABI {

template <class Position>
constexpr polygon_edges<Position> edges_of(std::size_t count, const Position& position) noexcept {
  polygon_edges<Position> edges{count, position, 1, 1};
  double reach = 0, largest = 0;
  for (std::size_t k = 0; k < count; ++k)
    for (int i = 0; i < 3; ++i) {
      const double size = magnitude(widened(coordinate(position(k), i)));
      if (!is_finite(size)) return {count, position, 1, 0};
      reach = greater(reach, size);
    }
  if (reach > 0x1p1022) edges.before = 0.25;  // else the difference of two finite numbers could be infinite
  for (std::size_t k = 1; k < count; ++k) {
    const vec<double, 3> v = edges(0, k);
    for (int i = 0; i < 3; ++i) largest = greater(largest, magnitude(v[i]));
  }
  edges.after = largest > 0 ? power_of_two_for(largest) : 0;
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

/// The interior angle of a polygon at vertex k, up to two pi where it is not convex.
template <class Position>
constexpr double corner_angle(const polygon_edges<Position>& edge, std::size_t k,
                              const vec<double, 3>& normal) noexcept {
  const vec<double, 3> next = edge(k, k + 1 < edge.count ? k + 1 : 0);
  const vec<double, 3> previous = edge(k, k > 0 ? k - 1 : edge.count - 1);
  const double angle = angle_between(next, previous);
  return dot(cross(next, previous), normal) < 0 ? two_pi<double> - angle : angle;
}

template <class M>
constexpr auto edges_of_face(const M& m, std::size_t f) noexcept {
  return edges_of(mesh_traits<M>::face_size(m, f),
                  [&m, f](std::size_t k) { return mesh_traits<M>::position(m, mesh_traits<M>::face_vertex(m, f, k)); });
}

/// A power of two that brings the mesh's finite coordinates below 4: the unit in which areas are compared.
template <class M>
constexpr double area_scale(const M& m) noexcept {
  double largest = 0;
  for (std::size_t v = 0; v < mesh_traits<M>::vertex_count(m); ++v)
    for (int i = 0; i < 3; ++i) {
      const double size = magnitude(widened(coordinate(mesh_traits<M>::position(m, v), i)));
      if (is_finite(size)) largest = greater(largest, size);
    }
  return largest > 0 ? power_of_two_for(largest) : 1;
}

/// Calls f(face, k, unit, share) for every corner of every face that has a normal: the face's unit normal, and how much
/// it counts for the vertex.
template <class M, class F>
constexpr void for_weighted_corners(const M& m, normal_weight weight, const F& f) {
  const double scale = weight == normal_weight::area ? area_scale(m) : 1;
  for (std::size_t face = 0; face < mesh_traits<M>::face_count(m); ++face) {
    const auto edges = edges_of_face(m, face);
    const vec<double, 3> sum = newell_sum(edges);
    const auto unit = try_normalize(sum);
    if (!unit) continue;
    double share = 1;
    if (weight == normal_weight::area) {
      const double ratio = scale / edges.before / edges.after;
      share = length(sum) * ratio * ratio;
    }
    for (std::size_t k = 0; k < edges.count; ++k) {
      if (weight == normal_weight::angle) share = corner_angle(edges, k, *unit);
      f(face, k, *unit, share);
    }
  }
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The plane normal of a polygon by Newell's method about its first vertex: at right angles to the plane, pointing to
/// the side from which the vertices run counter-clockwise, as long as twice the polygon's area.
/// gives   zero for fewer than three vertices and for collinear ones
/// exact   a triangle's is the cross product of two edges, computed in double; infinite where it is beyond the range
/// cost    one pass
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's method)
template <PolygonRing R>
  requires(size_of<typename ring_traits<R>::point> == 3 && Floating<scalar_of<typename ring_traits<R>::point>>)
constexpr auto newell_normal(const R& ring) noexcept {
  using T = scalar_of<typename ring_traits<R>::point>;
  const auto position = [&](std::size_t k) { return ring_traits<R>::vertex(ring, k); };
  const detail::polygon_edges edges{ring_traits<R>::size(ring), position, 1, 1};
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
constexpr std::optional<detail::mesh_normal<M>> face_normal(const M& m, std::size_t f) noexcept {
  using V = detail::mesh_normal<M>;
  const auto unit = try_normalize(detail::newell_sum(detail::edges_of_face(m, f)));
  if (!unit) return std::nullopt;
  return generate_coordinates<V>([&](int i) { return converted<scalar_of<V>>((*unit)[i]); });
}

/// The normal at every vertex of a mesh, of length 1: the normals of the faces around it, weighted, summed in the order
/// of the faces, and normalised. Faces without a normal are passed over.
/// shape   one vector per position, in the positions' order
/// gives   the zero vector where there is no direction: at positions that no face uses, and where the sum is exactly
///         zero, as on both sides of a thin sheet; never NaN
/// exact   each coordinate of the sum rounded once per face; areas smaller than 2^-1000 of the mesh's count nothing
/// cost    one pass over the corners; allocates the result
/// source  Mihajlovic 2016, 7.3 (average; its division by the count is left out as it keeps the direction); Thuermer
///         and Wuethrich 1998 (angle); area: the length of Newell's vector
template <detail::mesh_in_space M>
constexpr std::vector<detail::mesh_normal<M>> vertex_normals(const M& m,
                                                             normal_weight weight = normal_weight::average) {
  using V = detail::mesh_normal<M>;
  std::vector<V> normals(mesh_traits<M>::vertex_count(m), V{});
  detail::for_weighted_corners(m, weight, [&](std::size_t f, std::size_t k, const vec<double, 3>& unit, double share) {
    V& normal = normals[mesh_traits<M>::face_vertex(m, f, k)];
    normal += generate_coordinates<V>([&](int i) { return converted<scalar_of<V>>(product(unit[i], share)); });
  });
  for (V& normal : normals) normal = normalized(normal);
  return normals;
}

/// Gives a mesh smooth shading: its normals become those of vertex_normals, and every corner names the normal of its
/// position.
/// exact   as vertex_normals
/// cost    one pass over the corners; allocates the normals
template <Floating T>
constexpr void assign_vertex_normals(mesh<T>& m, normal_weight weight = normal_weight::average) {
  m.normals = vertex_normals(m, weight);
  for (mesh_corner& corner : m.corners) corner.normal = corner.position;
}

}  // namespace IRG_ABI
}  // namespace irg
