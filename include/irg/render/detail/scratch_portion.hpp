// SPDX-License-Identifier: MIT
// Triangles culled and clipped one by one, for those who draw them at once instead of listing them.
#pragma once

#include <cstdint>

#include <irg/render/detail/bin_kernel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// A portion that takes one triangle after another.
constexpr bin_portion scratch_portion(const picture_tiles& grid) {
  bin_portion p;
  p.of_tile.assign(grid.count(), tile_share{});
  return p;
}

// One triangle, culled and clipped: its pieces are those of `scratch`; without pieces it is whole if true is returned.
template <class T>
constexpr bool list_alone(bin_portion& scratch, const triangle_batch<T>& batch, std::uint32_t i,
                          const screen_mapping<T>& mapping, const picture_tiles& grid, face_culling culling) {
  scratch.entry_count = 0;
  scratch.pieces.clear();
  list_one(scratch, batch, i, i, mapping, grid, culling, skip_options{});
  return scratch.entry_count != 0;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
