// SPDX-License-Identifier: MIT
// Triangles culled and clipped one by one, for those who draw them at once instead of listing them.
#pragma once

#include <cstdint>

#include <irg/render/detail/bin/bin_triangles.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>

namespace irg::detail::inline IRG_ABI {

// A portion that takes one triangle after another.
template <class Portion = bin_portion>
constexpr Portion scratch_portion(const picture_tiles& grid) {
  Portion p;
  p.of_tile.assign(grid.count(), tile_share{});
  return p;
}

// One triangle, culled and clipped: its pieces are those of `scratch`; without pieces it is whole if true is returned.
template <class T>
constexpr bool list_alone(bin_portion& scratch, const triangle_batch<T>& batch, std::uint32_t i,
                          const listing_rules<T>& rules) {
  scratch.entry_count = 0;
  scratch.pieces.clear();
  list_one(scratch, batch, i, i, rules);
  return scratch.entry_count != 0;
}

// As above, given to draw(corners): piece by piece, or whole.
template <class T, class Draw>
constexpr void list_and_draw(bin_portion& scratch, const triangle_batch<T>& batch, std::uint32_t i,
                             const listing_rules<T>& rules, const Draw& draw) {
  const bool listed = list_alone(scratch, batch, i, rules);
  for (const clipped_piece& p : scratch.pieces) draw(corners_of(p.v));
  if (!scratch.pieces.empty() || !listed) return;
  draw(corners_of(batch, i));
}

}  // namespace irg::detail::inline IRG_ABI
