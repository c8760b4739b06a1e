// SPDX-License-Identifier: MIT
// The vertices of files in which a vertex has one position, one normal and one texture coordinate, where a mesh's
// corners may pair them at will.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/mesh.hpp>

namespace irg::detail {

/// Which attributes all corners have, the vertices to write, and the vertex of each corner.
template <class Corner>
struct vertex_layout {
  bool normals = false, texcoords = false;
  std::vector<Corner> vertices;
  std::vector<std::uint32_t> of_corner;
};

inline namespace IRG_ABI {

/// The layout of a mesh: its positions in their order, those whose corners differ in normal or texture coordinate once
/// for each pair of them. An attribute that some corner lacks is left out; without corners, one of which there are not
/// as many as positions.
/// cost    O(n log n) where corners have attributes, else linear
template <Scalar T, class Corner = mesh_corner>
constexpr vertex_layout<Corner> vertices_to_write(const mesh<T>& m) {
  vertex_layout<Corner> out;
  const auto belong = [&](std::size_t n) { return n != 0 && (!m.corners.empty() || n == m.positions.size()); };
  out.normals = belong(m.normals.size());
  out.texcoords = belong(m.texcoords.size());
  for (const mesh_corner& c : m.corners) {
    out.normals = out.normals && c.normal != no_index;
    out.texcoords = out.texcoords && c.texcoord != no_index;
  }
  if (!out.normals && !out.texcoords) {
    for (std::uint32_t v = 0; v < m.positions.size(); ++v) out.vertices.push_back({v});
    for (const mesh_corner& c : m.corners) out.of_corner.push_back(c.position);
    return out;
  }
  const auto kept = [&](mesh_corner c) {
    if (!out.normals) c.normal = no_index;
    if (!out.texcoords) c.texcoord = no_index;
    return c;
  };
  const auto before = [](const Corner& a, const Corner& b) {
    if (a.position != b.position) return a.position < b.position;
    return a.normal != b.normal ? a.normal < b.normal : a.texcoord < b.texcoord;
  };
  std::vector<std::uint32_t> used(m.positions.size(), std::uint32_t{0});
  for (const mesh_corner& c : m.corners) {
    out.vertices.push_back(kept(c));
    used[c.position] = 1;
  }
  for (std::uint32_t v = 0; v < m.positions.size(); ++v)  // what no corner names is written, too
    if (used[v] == 0)
      out.vertices.push_back({v, out.normals && v < m.normals.size() ? v : no_index,
                              out.texcoords && v < m.texcoords.size() ? v : no_index});
  std::sort(out.vertices.begin(), out.vertices.end(), before);
  out.vertices.erase(std::unique(out.vertices.begin(), out.vertices.end()), out.vertices.end());
  out.of_corner.reserve(m.corners.size());
  for (const mesh_corner& c : m.corners) {
    const auto place = std::lower_bound(out.vertices.begin(), out.vertices.end(), kept(c), before);
    out.of_corner.push_back(static_cast<std::uint32_t>(place - out.vertices.begin()));
  }
  return out;
}

/// The vertex's normal; zero where it has none.
template <Scalar T>
constexpr vec<T, 3> normal_to_write(const mesh<T>& m, const mesh_corner& c) noexcept {
  return c.normal == no_index ? vec<T, 3>{} : m.normals[c.normal];
}
template <Scalar T>
constexpr vec<T, 2> texcoord_to_write(const mesh<T>& m, const mesh_corner& c) noexcept {
  return c.texcoord == no_index ? vec<T, 2>{} : m.texcoords[c.texcoord];
}

}  // namespace IRG_ABI
}  // namespace irg::detail
