// SPDX-License-Identifier: MIT
// Normals of vertices: of those of the faces around each (face_normal.hpp), with three kinds of weights.
#pragma once

#include <cstddef>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/math/angle_between.hpp>
#include <irg/math/constants.hpp>
#include <irg/mesh/detail/unit_block_kernel.hpp>
#include <irg/mesh/face_normal.hpp>

namespace irg {

/// How much each face around a vertex counts for the vertex's normal.
enum class normal_weight {
  average,  // all faces alike: the course's form; depends on how polygons are cut into triangles
  angle,    // by the face's angle at the vertex; does not depend on it
  area,     // by the face's area; does not depend on it as long as the vertex keeps its share of the area
};

namespace detail {
inline namespace IRG_ABI {

/// The interior angle of a polygon at vertex k, up to two pi where it is not convex.
template <class Position>
constexpr double corner_angle(const polygon_edges<Position>& edge, std::size_t k,
                              const vec<double, 3>& normal) noexcept {
  const vec<double, 3> next = edge(k, k + 1 < edge.count ? k + 1 : 0);
  const vec<double, 3> previous = edge(k, k > 0 ? k - 1 : edge.count - 1);
  const double angle = angle_between(next, previous);
  return dot(cross(next, previous), normal) < 0 ? two_pi<double> - angle : angle;
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

/// Calls f(k, unit, share) for every corner of a face that has a normal: the face's unit normal, and how much it counts
/// for the vertex; areas in units of `scale`.
template <class M, class F>
constexpr void for_weighted_corners(const M& m, std::size_t face, normal_weight weight, double scale, const F& f) {
  const auto edges = edges_of_face(m, face);
  const vec<double, 3> sum = newell_sum(edges);
  const auto unit = try_normalize(sum);
  if (!unit) return;
  double share = 1;
  if (weight == normal_weight::area) {
    const double ratio = scale / edges.before / edges.after;
    share = length(sum) * ratio * ratio;
  }
  for (std::size_t k = 0; k < edges.count; ++k) {
    if (weight == normal_weight::angle) share = corner_angle(edges, k, *unit);
    f(k, *unit, share);
  }
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The normal at every vertex of a mesh, of length 1: the normals of the faces around it, weighted, summed in the order
/// of the faces, and normalised. Faces without a normal are passed over.
/// shape   one vector per position, in the positions' order
/// gives   the zero vector where there is no direction: at positions that no face uses, and where the sum is exactly
///         zero, as on both sides of a thin sheet; never NaN
/// exact   each coordinate of the sum rounded once per face; areas smaller than 2^-1000 of the mesh's count nothing, of
///         floats those smaller than 2^-149
/// cost    one pass over the corners; allocates the result
/// source  Mihajlovic 2016, 7.3 (average; its division by the count is left out as it keeps the direction); Thuermer
///         and Wuethrich 1998 (angle); area: the length of Newell's vector
template <detail::mesh_in_space M>
[[nodiscard]] constexpr std::vector<detail::mesh_normal<M>> vertex_normals(
    const M& m, normal_weight weight = normal_weight::average) {
  using V = detail::mesh_normal<M>;
  std::vector<V> normals(mesh_traits<M>::vertex_count(m), V{});
  const auto add = [&](std::size_t f, std::size_t k, const vec<double, 3>& n) IRG_INLINE_LAMBDA {
    normals[mesh_traits<M>::face_vertex(m, f, k)] +=
        generate_coordinates<V>([&](int i) { return converted<scalar_of<V>>(n[i]); });
  };
  const double scale = weight == normal_weight::area ? detail::area_scale(m) : 1;
  const auto add_face = [&](std::size_t f) {
    detail::for_weighted_corners(m, f, weight, scale, [&](std::size_t k, const vec<double, 3>& unit, double share) {
      add(f, k, generate_coordinates<vec<double, 3>>([&](int i) { return product(unit[i], share); }));
    });
  };
  std::size_t face = 0;
  if (detail::takes_blocks() && weight == normal_weight::average) {
    detail::unit_block block;
    while (face < mesh_traits<M>::face_count(m)) face = detail::for_block_of_triangles(m, face, block, add, add_face);
  }
  for (; face < mesh_traits<M>::face_count(m); ++face) add_face(face);
  detail::normalize_all(normals);
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
