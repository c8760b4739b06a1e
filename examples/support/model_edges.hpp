// SPDX-License-Identifier: MIT
// The edges of a model's faces.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/mesh/mesh.hpp>

namespace program {

/// Two positions of a model, the lower number first.
using edge = std::pair<std::uint32_t, std::uint32_t>;

/// The edges of the faces, each once.
inline std::vector<edge> edges_of(const irg::mesh<double>& m) {
  std::vector<edge> edges;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0, n = m.face_size(f); k < n; ++k)
      edges.push_back(std::minmax({m.corner(f, k).position, m.corner(f, k + 1 < n ? k + 1 : 0).position}));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace program
