// SPDX-License-Identifier: MIT
// Which triangles each tile of the picture has to draw: what bin_triangles fills, and the memory for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/raster/draw_counts.hpp>
#include <irg/raster/piece_weights.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/render/detail/visible/tile_test.hpp>

namespace irg {
namespace detail {

// A part of a source triangle that a clip plane left over.
struct clipped_piece {
  screen_vertex v[3];
  piece_weights weights;
  std::uint32_t source;  // its triangle, counted over all batches
};

// What a portion has for one tile.
struct tile_share {
  std::uint32_t count = 0;
  std::uint32_t area = 0;  // the pixels of all boxes, as far as they lie in the tile
};

// The triangles [first, last) of one batch, and what became of them.
struct bin_portion {
  std::size_t batch = 0;
  std::uint32_t first = 0, last = 0;  // within the batch
  std::vector<std::uint64_t> entries;  // tile and number: see entry_of
  std::size_t entry_count = 0;  // how many of `entries` are in use
  std::vector<tile_share> of_tile;
  std::vector<clipped_piece> pieces;
  skip_counts skipped;
  std::int64_t listed = 0;  // triangles of which some part is on a list
  std::int64_t clipped = 0;  // triangles that were cut, and hold pixel centres of the picture
  std::uint32_t first_piece = 0;  // the number of its first piece among all pieces
};

// The lists of all tiles, one after the other. Numbers below triangle_count name whole triangles, the rest pieces.
struct triangle_bins {
  std::vector<bin_portion> portions;
  std::vector<std::uint32_t> tile_first;  // where each tile's list starts; one more for the end
  std::vector<std::uint32_t> numbers;
  std::vector<float> tile_area;
  std::vector<clipped_piece> pieces;
  std::uint32_t triangle_count = 0;
  skip_counts skipped;
  std::int64_t listed = 0, clipped = 0;

  // The list of a tile.
  IRG_INLINE constexpr std::span<const std::uint32_t> list_of(std::size_t tile) const noexcept {
    return {numbers.data() + tile_first[tile], tile_first[tile + 1] - tile_first[tile]};
  }
};

// How the picture is cut into tiles.
struct picture_tiles {
  int width, height;  // of the picture
  int across, down;

  IRG_INLINE constexpr picture_tiles(int w, int h) noexcept
      : width(w), height(h), across((w + tile_size - 1) / tile_size), down((h + tile_size - 1) / tile_size) {}
  IRG_INLINE constexpr std::size_t count() const noexcept {
    return static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
  }
  IRG_INLINE constexpr cell_window window(std::size_t tile) const noexcept {
    const int x = static_cast<int>(tile) % across * tile_size, y = static_cast<int>(tile) / across * tile_size;
    return {x, y, minimum(x + tile_size, width), minimum(y + tile_size, height)};
  }
};

// The lists that drawing makes.
struct drawing_lists {
  triangle_bins bins;
  std::vector<std::uint8_t> seen;  // by triangle: whether any part of it was not passed over
};
struct open_workspace;

}  // namespace detail

/// The lists that drawing makes. Kept from picture to picture, they spare the next one the allocation.
class draw_workspace {
  friend struct detail::open_workspace;
  detail::drawing_lists lists_;
};

namespace detail {

struct open_workspace {
  IRG_INLINE constexpr drawing_lists& operator()(draw_workspace& w) const noexcept { return w.lists_; }
};
IRG_INLINE constexpr drawing_lists& lists_of(draw_workspace& w) noexcept { return open_workspace{}(w); }

inline namespace IRG_ABI {

// How many triangles there were, and why some were not drawn.
constexpr void add_skips(render_counts& stats, const triangle_bins& bins, std::span<const std::uint8_t> seen,
                         const skip_options& skip) noexcept {
  stats.triangles = static_cast<std::int64_t>(bins.triangle_count);
  stats.skipped = bins.skipped;
  stats.clipped = bins.clipped;
  if (skip.occluded == skipping::off) return;
  stats.skipped.occluded = bins.listed;
  for (const std::uint8_t s : seen) stats.skipped.occluded -= s;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
