// SPDX-License-Identifier: MIT
// Corners that name equal positions come to share one: what files without indices need before neighbours are known.
// Equality is exact. Vertices that are only near each other are another question, and need a distance from the caller.
#pragma once

#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/mesh/detail/corner_groups.hpp>
#endif

namespace irg::inline IRG_COMPILED_ABI {

/// The mesh with one position for all that are equal: the first of them, in the order in which they stood.
/// shape   faces, normals, texture coordinates and parts stay; positions that no corner names stay, too
/// gives   0 and -0 as one position, the first one's; NaN equal to NaN of the same bits
/// needs   a mesh in which validate() finds no bad index, of less than 2^32 positions
/// exact   always; no two positions of the result are equal
/// cost    O(n log n) for n positions, whatever they are; 16 (float) or 32 bytes for each
template <Floating T>
[[nodiscard]] IRG_API mesh<T> with_merged_positions(mesh<T> m);

}  // namespace irg::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

IRG_RENAMED(merge_positions, with_merged_positions)

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API mesh<T> with_merged_positions(mesh<T> m) {
  std::vector<std::uint32_t> to = detail::first_equal_vectors<T, 3>(m.positions);
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < to.size(); ++v) {
    if (to[v] != v) {
      to[v] = to[to[v]];  // an earlier one, whose new place is known
      continue;
    }
    m.positions[kept] = m.positions[v];
    to[v] = kept++;
  }
  m.positions.erase(m.positions.begin() + static_cast<std::ptrdiff_t>(kept), m.positions.end());
  for (mesh_corner& c : m.corners) c.position = to[c.position];
  return m;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
