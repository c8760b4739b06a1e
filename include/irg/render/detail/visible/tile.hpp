// SPDX-License-Identifier: MIT
// A tile of the picture while it is drawn: for each pixel the depth and the nearest triangle so far (its place in the
// tile's list), in the cache from the first triangle to the last. Colours come later, for what is still visible then.
//
// Depths are kept as keys, of which the greater is always the nearer: the depth itself or its negative.
//
// The tile is cut into blocks of 8 x 8 pixels. `farthest_key` holds for each a key that no pixel of it lies behind: a
// triangle that lies behind that is not seen there.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include <irg/core/lanes.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/raster/window.hpp>
#include <irg/render/detail/visible/tile_test.hpp>

namespace irg::detail {

struct tile {
  alignas(64) float key[tile_size * tile_stride];
  alignas(64) std::uint32_t id[tile_size * tile_stride];
  alignas(64) float farthest_key[blocks_across * blocks_across];
  float farthest;  // the least of `farthest_key`
  std::uint64_t stale;  // the blocks that were drawn to since their `farthest_key` was computed
  int width, height;  // of the part that lies in the picture
};

inline namespace IRG_ABI {

// Pixels and triangles of a tile are worked on so many at a time.
inline constexpr int tile_lanes = native_lanes<float>;
using tile_integers = pack<std::int32_t, tile_lanes>;
using tile_floats = pack<float, tile_lanes>;

// What pixels beside the picture hold: nothing is nearer, so they are never drawn to and never tested in earnest.
inline constexpr float beyond_everything = std::numeric_limits<float>::infinity();

// Makes the tile empty: nothing drawn, everything at the key of the farthest depth.
// needs   1 <= width, height <= tile_size: the part that lies in the picture
IRG_INLINE void clear_tile(tile& t, int width, int height, float farthest) noexcept {
  using F = lanes<tile_floats>;
  const auto x = F::ramp(), end = F::broadcast(static_cast<float>(width));
  const auto none = lanes<tile_integers>::broadcast(-1);
  for (int row = 0; row < tile_size; ++row)
    for (int k = 0; k < tile_stride; k += tile_lanes) {
      const auto inside = x + F::broadcast(static_cast<float>(k)) < end;
      const auto key =
          select(inside, F::broadcast(row < height ? farthest : beyond_everything), F::broadcast(beyond_everything));
      F::store(t.key + row * tile_stride + k, key);
      lanes<tile_integers>::store_bytes(t.id + row * tile_stride + k, none);
    }
  for (int b = 0; b < blocks_across * blocks_across; ++b)
    t.farthest_key[b] = b % blocks_across * block_size < width && b / blocks_across * block_size < height
                            ? farthest
                            : beyond_everything;
  t.farthest = farthest;
  t.stale = 0;
  t.width = width;
  t.height = height;
}

// Reckons `farthest` anew.
IRG_INLINE void refresh_farthest(tile& t) noexcept {
  using F = lanes<tile_floats>;
  auto least = F::load(t.farthest_key);
  for (int i = tile_lanes; i < blocks_across * blocks_across; i += tile_lanes)
    least = minimum(F::load(t.farthest_key + i), least);
  t.farthest = reduce_min(least);
}

// What is at this key is not seen.
IRG_INLINE void hide_key(tile& t, float key) noexcept {
  for (int i = 0; i < tile_size * tile_stride; ++i)
    if (t.key[i] == key) t.id[i] = no_index;
}

// The least key of a block.
IRG_INLINE float farthest_of_block(const tile& t, int block) noexcept {
  using F = lanes<tile_floats>;
  const float* row = t.key + block / blocks_across * block_size * tile_stride + block % blocks_across * block_size;
  auto least = F::load(row);
  for (int r = 0; r < block_size; ++r, row += tile_stride)
    for (int k = 0; k < block_size; k += tile_lanes) least = minimum(F::load(row + k), least);
  return reduce_min(least);
}

// Reckons `farthest_key` anew for the stale blocks, and `farthest`.
IRG_INLINE void refresh_far(tile& t) noexcept {
  for (; t.stale != 0; t.stale &= t.stale - 1) {
    const int block = std::countr_zero(t.stale);
    t.farthest_key[block] = farthest_of_block(t, block);
  }
  refresh_farthest(t);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
