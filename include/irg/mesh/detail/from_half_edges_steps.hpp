// SPDX-License-Identifier: MIT
// The steps of from_half_edges.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/half_edge_mesh.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The triangles of a face with rings, as half-edges that leave their corners.
template <Scalar T>
constexpr std::vector<std::uint32_t> triangles_of_ringed_face(const half_edge_mesh<T>& b, std::uint32_t face) {
  std::vector<std::uint32_t> corners, triangles;
  std::vector<std::vector<point<T, 2>>> rings;
  mesh<T> outer;  // by itself, for its normal
  each_half_edge_of(b, b.faces[face], [&](std::uint32_t h) {
    outer.corners.push_back({static_cast<std::uint32_t>(outer.positions.size())});
    outer.positions.push_back(b.positions[b.origin(h)]);
  });
  outer.face_starts.push_back(static_cast<std::uint32_t>(outer.corners.size()));
  const vec<T, 3> normal = face_normal(outer, 0).value_or(vec<T, 3>{});
  const auto size = [&](int i) { return normal[i] < T(0) ? T(0) - normal[i] : normal[i]; };
  const int axis = size(0) < size(1) ? (size(1) < size(2) ? 2 : 1) : (size(0) < size(2) ? 2 : 0);
  each_loop_of(b, face, [&](std::uint32_t l) {
    rings.emplace_back();
    each_half_edge_of(b, l, [&](std::uint32_t h) {
      const point<T, 3>& p = b.positions[b.origin(h)];
      rings.back().push_back({p[axis == 0 ? 1 : 0], p[axis == 2 ? 1 : 2]});
      corners.push_back(h);
    });
  });
  for (const auto& t : triangulate_monotone(rings).triangles)
    for (const std::uint32_t k : t) triangles.push_back(corners[k]);
  return triangles;
}

// Appends one face to a mesh, as it is or, with rings, as triangles.
template <Scalar T, class Corner>
constexpr void append_face(mesh<T>& m, const half_edge_mesh<T>& b, std::uint32_t face, const Corner& corner) {
  if (b.loops[b.faces[face]].next != half_edge::none) {
    for (const std::uint32_t h : triangles_of_ringed_face(b, face)) {
      m.corners.push_back(corner(h));
      if ((m.corners.size() - m.face_starts.back()) % 3 == 0)
        m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
    return;
  }
  const std::size_t before = m.corners.size();
  each_half_edge_of(b, b.faces[face], [&](std::uint32_t h) { m.corners.push_back(corner(h)); });
  if (m.corners.size() - before < 3)
    m.corners.resize(before, mesh_corner{});
  else
    m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
