// SPDX-License-Identifier: MIT
// From half-edges back to an indexed mesh, and what hangs together in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/half_edge_mesh.hpp>
#if IRG_BODIES
#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/face_normal.hpp>
#endif

namespace irg {

/// Which shell each face belongs to.
struct half_edge_shells {
  std::vector<std::uint32_t> of_face;  // from 0; none for faces that are no more
  std::uint32_t count = 0;
  bool operator==(const half_edge_shells&) const = default;
};

/// The numbers of elements of a boundary representation.
/// shape   vertices - edges + faces - rings = 2 (shells - genus) where nothing is open; rings are the loops of faces
///         beyond the outer ones, genus the holes through the bodies
struct half_edge_counts {
  std::size_t vertices = 0, edges = 0, faces = 0, rings = 0, shells = 0, borders = 0;
  std::ptrdiff_t genus = 0;
  bool operator==(const half_edge_counts&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// The indexed mesh of a boundary representation.
/// shape   faces in the order of their numbers (of their parts, where there are any), each from its loop's first
///         half-edge; vertices renumbered where some are gone; a face with rings becomes triangles
/// gives   what to_half_edges was made from, corner for corner, when nothing was changed. Faces of fewer than three
///         corners are left out
/// needs   plane faces where there are rings
/// exact   positions and attributes are copied; rings are cut as triangulate_monotone does
/// cost    linear, but for the faces with rings, which cost as triangulate_monotone
template <Floating T>
[[nodiscard]] IRG_API mesh<T> to_mesh(const half_edge_mesh<T>& b);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The shells of a boundary representation: faces that are joined over edges, and over the rings of faces.
/// shape   numbered from 0 by their lowest face
/// cost    linear
template <Scalar T>
[[nodiscard]] constexpr half_edge_shells shells_of(const half_edge_mesh<T>& b) {
  half_edge_shells out{std::vector<std::uint32_t>(b.faces.size(), no_index), 0};
  std::vector<std::uint32_t> open;
  for (std::uint32_t f = 0; f < b.faces.size(); ++f) {
    if (out.of_face[f] != no_index || b.faces[f] == no_index) continue;
    out.of_face[f] = out.count;
    open.push_back(f);
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      each_loop_of(b, at, [&](std::uint32_t l) {
        each_half_edge_of(b, l, [&](std::uint32_t h) {
          const std::uint32_t beside = b.face(b.twin(h));
          if (beside == no_index || out.of_face[beside] != no_index) return;
          out.of_face[beside] = out.count;
          open.push_back(beside);
        });
      });
    }
    ++out.count;
  }
  return out;
}

/// How many elements of each kind there are.
/// gives   the genus by Euler and Poincare's formula; with borders, that of the surface with a face set into each
/// cost    linear
/// source  Mantyla 1988
template <Scalar T>
[[nodiscard]] constexpr half_edge_counts counts_of(const half_edge_mesh<T>& b) {
  half_edge_counts n;
  std::vector<unsigned char> seen(b.half_edges.size(), 0);
  for (std::size_t v = 0; v < b.positions.size(); ++v)
    n.vertices += b.half_edge_at[v] < half_edge_mesh<T>::gone ? 1u : 0u;
  n.vertices += b.lone_vertices.size();
  for (std::uint32_t h = 0; h < b.half_edges.size(); ++h) {
    if (b.half_edges[h].origin == no_index) continue;
    n.edges += h % 2;
    if (b.half_edges[h].loop != no_index || seen[h] != 0) continue;
    ++n.borders;
    for (std::uint32_t g = h; seen[g] == 0; g = b.next(g)) seen[g] = 1;
  }
  for (std::uint32_t f = 0; f < b.faces.size(); ++f) {
    if (b.faces[f] == no_index) continue;
    ++n.faces;
    each_loop_of(b, f, [&](std::uint32_t l) { n.rings += l != b.faces[f] ? 1u : 0u; });
  }
  n.shells = shells_of(b).count;
  const auto signed_of = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
  n.genus = signed_of(n.shells) -
            (signed_of(n.vertices) - signed_of(n.edges) + signed_of(n.faces + n.borders) - signed_of(n.rings)) / 2;
  return n;
}

}  // namespace IRG_ABI

inline namespace IRG_ABI {

IRG_RENAMED(from_half_edges, to_mesh)

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

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
  if (b.loops[b.faces[face]].next != no_index) {
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

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API mesh<T> to_mesh(const half_edge_mesh<T>& b) {
  mesh<T> m;
  m.normals = b.normals;
  m.texcoords = b.texcoords;
  std::vector<std::uint32_t> number(b.positions.size(), no_index);
  for (std::size_t v = 0; v < b.positions.size(); ++v) {
    if (b.half_edge_at[v] == half_edge_mesh<T>::gone) continue;
    number[v] = static_cast<std::uint32_t>(m.positions.size());
    m.positions.push_back(b.positions[v]);
  }
  const auto corner = [&](std::uint32_t h) {
    const half_edge_attributes a = h < b.attributes.size() ? b.attributes[h] : half_edge_attributes{};
    return mesh_corner{number[b.origin(h)], a.normal, a.texcoord};
  };
  // The faces of one part after the other, those of none last.
  const std::size_t parts = b.parts.size();
  const auto part_of = [&](std::size_t f) {
    return f < b.face_parts.size() && b.face_parts[f] < parts ? std::size_t{b.face_parts[f]} : parts;
  };
  std::vector<std::size_t> start(parts + 2, 0);
  for (std::size_t f = 0; f < b.faces.size(); ++f) ++start[part_of(f) + 1];
  for (std::size_t i = 0; i <= parts; ++i) start[i + 1] += start[i];
  std::vector<std::uint32_t> order(b.faces.size(), 0);
  for (std::uint32_t f = 0; f < b.faces.size(); ++f) order[start[part_of(f)]++] = f;  // start tells the ends then
  for (std::size_t i = 0, k = 0; i <= parts; ++i) {
    const std::size_t first = m.face_count();
    for (; k < start[i]; ++k)
      if (b.faces[order[k]] != no_index) detail::append_face(m, b, order[k], corner);
    const std::size_t count = m.face_count() - first;
    if (i < parts)
      m.parts.push_back({b.parts[i].object, b.parts[i].group, b.parts[i].material, first, count});
    else if (parts != 0 && count != 0)
      m.parts.push_back({{}, {}, {}, first, count});
  }
  return m;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
