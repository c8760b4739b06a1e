// SPDX-License-Identifier: MIT
// The ends of a mesh's edges side by side: which faces meet in an edge, without a table of all pairs of positions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/mesh.hpp>

namespace irg {

/// One end of an edge: the corner at its position, the position at its other end, and which way the corner's face runs.
struct edge_end {
  std::uint32_t from, to, corner;
  bool leaves;
  friend constexpr auto operator<=>(const edge_end&, const edge_end&) = default;
};

inline namespace IRG_ABI {

/// The ends of all edges, by the position that they are at, those of one edge side by side.
/// shape   two for each corner: where its edge to the next corner of the face begins, and where the edge from the one
///         before ends. An edge between two faces has four, two at each of its positions
/// needs   faces as validate_faces wants them
/// cost    linear, and a sort of the ends at each position; allocates
template <Scalar T>
[[nodiscard]] constexpr std::vector<edge_end> edge_ends(const mesh<T>& m) {
  std::vector<std::size_t> next(m.positions.size() + 1, 0);  // where the next end at a position goes
  for (const mesh_corner& c : m.corners) next[c.position + std::size_t{1}] += 2;
  for (std::size_t v = 0; v < m.positions.size(); ++v) next[v + 1] += next[v];
  std::vector<edge_end> ends(2 * m.corners.size(), edge_end{});
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::size_t count = m.face_size(f), first = m.face_starts[f];
    for (std::size_t k = 0; k < count; ++k) {
      const auto corner = static_cast<std::uint32_t>(first + k);
      const std::uint32_t here = m.corners[corner].position;
      ends[next[here]++] = {here, m.corners[first + (k + 1 < count ? k + 1 : 0)].position, corner, true};
      ends[next[here]++] = {here, m.corners[first + (k > 0 ? k - 1 : count - 1)].position, corner, false};
    }
  }
  for (std::size_t v = 0, begin = 0; v < m.positions.size(); begin = next[v++])
    std::sort(ends.begin() + static_cast<std::ptrdiff_t>(begin), ends.begin() + static_cast<std::ptrdiff_t>(next[v]));
  return ends;
}

}  // namespace IRG_ABI
}  // namespace irg
