// SPDX-License-Identifier: MIT
// A body as the thesis stores it: points, edges, faces, and the colour and the surface of each face.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/colour/pixel.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/shade/material.hpp>

namespace irg {

/// The colour of faces and what they do with light.
template <Floating T>
struct stored_surface {
  rgba8 colour{255, 255, 255, 255};
  material<T> reflection{{T(1), T(1), T(1)}, {T(1), T(1), T(1)}, {}, T(1)};
  bool operator==(const stored_surface&) const = default;
};

/// Two points that a line joins.
struct stored_edge {
  std::uint32_t from = 0, to = 0;
  bool operator==(const stored_edge&) const = default;
};

/// A named body.
/// shape   edges name positions of `shape`; surface_of_face has an entry for each face, a number of `surfaces` or
///         no_index
template <Floating T>
struct stored_body {
  [[deprecated("irg: no_index")]] static constexpr std::uint32_t no_surface = no_index;
  part_name name;
  mesh<T> shape;
  std::vector<stored_edge> edges;
  std::vector<stored_surface<T>> surfaces;
  std::vector<std::uint32_t> surface_of_face;
  bool operator==(const stored_body&) const = default;
};

inline namespace IRG_ABI {

/// A mesh as a body of that name, with the edges of its faces and one surface for all of them.
/// shape   each edge once, from the smaller position to the larger, in their order; normals, texture coordinates and
///         parts are dropped
/// needs   a mesh in which validate() finds no defect
/// cost    O(n log n)
template <Floating T>
[[nodiscard]] constexpr stored_body<T> store_body(part_name name, const mesh<T>& m,
                                                  const stored_surface<T>& surface = {}) {
  stored_body<T> b{std::move(name), {}, {}, {surface}, {}};
  b.shape.positions = m.positions;
  b.shape.face_starts = m.face_starts;
  b.surface_of_face = std::vector<std::uint32_t>(m.face_count(), std::uint32_t{0});
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0, count = m.face_size(f); k < count; ++k) {
      const std::uint32_t from = m.corner(f, k).position, to = m.corner(f, k + 1 < count ? k + 1 : 0).position;
      b.shape.corners.push_back({from, no_index, no_index});
      if (from != to) b.edges.push_back(from < to ? stored_edge{from, to} : stored_edge{to, from});
    }
  const auto before = [](const stored_edge& a, const stored_edge& c) {
    return a.from != c.from ? a.from < c.from : a.to < c.to;
  };
  std::sort(b.edges.begin(), b.edges.end(), before);
  b.edges.erase(std::unique(b.edges.begin(), b.edges.end()), b.edges.end());
  return b;
}

}  // namespace IRG_ABI
}  // namespace irg
