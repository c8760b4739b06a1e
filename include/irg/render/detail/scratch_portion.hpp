// SPDX-License-Identifier: MIT
// Triangles culled and clipped one by one, for those who draw them at once instead of listing them.
#pragma once

#include <cstdint>

#include <irg/render/detail/triangle_finder.hpp>

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

// As above, given to draw(corners): piece by piece, or whole.
template <class T, class Draw>
constexpr void list_and_draw(bin_portion& scratch, const triangle_batch<T>& batch, std::uint32_t i,
                             const screen_mapping<T>& mapping, const picture_tiles& grid, face_culling culling,
                             const Draw& draw) {
  const bool listed = list_alone(scratch, batch, i, mapping, grid, culling);
  for (const clipped_piece& p : scratch.pieces) draw(triangle_corners{{&p.v[0], &p.v[1], &p.v[2]}});
  if (!scratch.pieces.empty() || !listed) return;
  const screen_vertex* screen = batch.vertices->screen.data();
  const auto& [v] = batch.triangles[i];
  draw(triangle_corners{{screen + v[0], screen + v[1], screen + v[2]}});
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
