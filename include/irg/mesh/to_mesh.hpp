// SPDX-License-Identifier: MIT
// Meshes of any type become irg's: the door through which users' meshes come into scenes.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/contract.hpp>
#include <irg/core/conversion.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::inline IRG_ABI {

/// A mesh of any type as a mesh<T>: its positions and faces.
/// needs   fewer than 2^32 - 1 positions and corners
/// exact   coordinates rounded once where T is narrower
/// cost    linear; allocates the result
template <Floating T, Mesh M>
[[nodiscard]] constexpr mesh<T> to_mesh(const M& m) {
  mesh<T> out;
  const std::size_t vertices = mesh_vertex_count(m), faces = mesh_face_count(m);
  IRG_EXPECTS(vertices < no_index);
  out.positions.reserve(vertices);
  out.face_starts.reserve(faces + 1);
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto p = mesh_position(m, v);
    const auto at = [&](int axis) { return converted<T>(coordinate(p, axis)); };
    out.positions.push_back({at(0), at(1), at(2)});
  }
  for (std::size_t f = 0; f < faces; ++f) {
    for (std::size_t k = 0; k < mesh_face_size(m, f); ++k)
      out.corners.push_back({static_cast<std::uint32_t>(mesh_face_vertex(m, f, k))});
    out.face_starts.push_back(static_cast<std::uint32_t>(out.corners.size()));
  }
  return out;
}

/// A mesh<U> as a mesh<T>, with its normals, texture coordinates and parts.
/// exact   each number rounded once where T is narrower; normals are not made unit vectors again
template <Floating T, Floating U>
[[nodiscard]] constexpr mesh<T> to_mesh(const mesh<U>& m) {
  mesh<T> out{{}, {}, {}, m.corners, m.face_starts, m.parts};
  const auto as = [](const U& x) { return converted<T>(x); };
  out.positions.reserve(m.positions.size());
  out.normals.reserve(m.normals.size());
  out.texcoords.reserve(m.texcoords.size());
  for (const auto& p : m.positions) out.positions.push_back({as(p.x), as(p.y), as(p.z)});
  for (const auto& n : m.normals) out.normals.push_back({as(n.x), as(n.y), as(n.z)});
  for (const auto& t : m.texcoords) out.texcoords.push_back({as(t.x), as(t.y)});
  return out;
}

}  // namespace irg::inline IRG_ABI
