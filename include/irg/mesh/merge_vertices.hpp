// SPDX-License-Identifier: MIT
// A mesh whose corners name position, normal and texture coordinate apart becomes what graphics hardware and many file
// formats want: one list of vertices, and one index for each corner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/mesh.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/mesh/triangulate.hpp>
#if IRG_BODIES
#include <algorithm>
#include <tuple>

#include <irg/mesh/detail/corner_groups.hpp>
#endif

namespace irg {

/// Vertices that differ in position, normal or texture coordinate, and triangles of them.
/// shape   each vertex is a corner of the mesh: the indices of its three parts there, no_index for what it
///         lacks
struct merged_vertices {
  std::vector<mesh_corner> vertices;
  std::vector<triangle_indices> triangles;
  bool operator==(const merged_vertices&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// The vertices of a mesh, merged where position, normal and texture coordinate are equal, and its triangles.
/// shape   vertices in the order in which corners use them first; triangles as triangulate makes them of the faces
/// needs   a mesh in which validate() finds no defect
/// gives   numbers compared by value, not by index: equal positions that the mesh lists twice are one vertex, and 0 is
///         -0; a corner that lacks a normal differs from one that has one. Positions that no corner names are left out
/// exact   always; no two vertices of the result are equal
/// cost    O(n log n), whatever the mesh
template <Floating T>
[[nodiscard]] IRG_API merged_vertices merge_vertices(const mesh<T>& m);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The triangles of a mesh as indices of its positions, in the order of its faces.
/// needs   a mesh in which validate() finds no defect
/// exact   as triangulate
/// cost    as triangulate
template <Scalar T>
[[nodiscard]] constexpr std::vector<triangle_indices> list_triangles(const mesh<T>& m) {
  const mesh<T> triangles = triangulated(m);
  std::vector<triangle_indices> list;
  list.reserve(triangles.face_count());
  for (std::size_t i = 0; i + 2 < triangles.corners.size(); i += 3)
    list.push_back(
        {{triangles.corners[i].position, triangles.corners[i + 1].position, triangles.corners[i + 2].position}});
  return list;
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API merged_vertices merge_vertices(const mesh<T>& m) {
  const mesh<T> triangles = triangulated(m);
  const auto positions = detail::first_equal_vectors<T, 3>(m.positions),
             normals = detail::first_equal_vectors<T, 3>(m.normals),
             texcoords = detail::first_equal_vectors<T, 2>(m.texcoords);
  std::vector<mesh_corner> corners = triangles.corners;
  std::vector<std::uint32_t> order(corners.size(), std::uint32_t{0});
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    mesh_corner& c = corners[i];
    c.position = positions[c.position];
    if (c.normal != no_index) c.normal = normals[c.normal];
    if (c.texcoord != no_index) c.texcoord = texcoords[c.texcoord];
    order[i] = i;
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const mesh_corner &x = corners[a], &y = corners[b];
    return std::tie(x.position, x.normal, x.texcoord, a) < std::tie(y.position, y.normal, y.texcoord, b);
  });
  std::vector<std::uint32_t> first(corners.size(), std::uint32_t{0});  // the first corner that is the same vertex
  for (std::size_t i = 0, group = 0; i < order.size(); ++i) {
    if (corners[order[i]] != corners[order[group]]) group = i;
    first[order[i]] = order[group];
  }
  merged_vertices out;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    if (first[i] == i) {
      first[i] = static_cast<std::uint32_t>(out.vertices.size());
      out.vertices.push_back(corners[i]);
    } else {
      first[i] = first[first[i]];  // an earlier one, which has its number
    }
    if (i % 3 == 2) out.triangles.push_back({{first[i - 2], first[i - 1], first[i]}});
  }
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
