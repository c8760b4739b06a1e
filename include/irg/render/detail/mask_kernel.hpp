// SPDX-License-Identifier: MIT
// The memory of an occlusion mask, and a triangle drawn into it pixel by pixel: exact coverage, and depths that are
// never nearer than those that drawing gives.
//
// The mask is kept in strips of 64 columns, so that a small triangle rarely meets a border; each strip is made of tiles
// of 64 rows, and what no triangle has touched is not even cleared.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/raster/draw_triangle.hpp>
#include <irg/render/detail/tile.hpp>

namespace irg {
namespace detail {

// 4 x 2 pixels, which are read and written together: what a triangle has just written never overlaps half of what the
// next one reads.
struct mask_cell {
  alignas(32) float key[8];
};
inline constexpr int mask_cells_across = tile_size / 4, mask_cells_down = tile_size / 2;  // of a tile

// The memory of a mask.
struct mask_target {
  int width, height, across, down;  // in pixels and in tiles
  float sign, farthest;  // of keys, as in tile.hpp
  mask_cell* cells;  // tile after tile down a strip, row after row
  float* farthest_key;  // 64 blocks for each tile: a key that no pixel of it lies behind
  float* tile_far;
  std::uint64_t* stale;  // the blocks of each tile of which `farthest_key` is not known
  std::uint8_t* touched;  // by tile

  IRG_INLINE constexpr std::size_t tile_at(int tx, int ty) const noexcept {
    return static_cast<std::size_t>(tx) * static_cast<std::size_t>(down) + static_cast<std::size_t>(ty);
  }
  // The cell in column x / 4 and row y / 2; the one below it is mask_cells_across further, also in the next tile.
  IRG_INLINE constexpr mask_cell* cell(int column, int row) const noexcept {
    const auto x = static_cast<std::size_t>(column), y = static_cast<std::size_t>(row);
    constexpr std::size_t n = mask_cells_across;
    return cells + (x / n * static_cast<std::size_t>(down * mask_cells_down) + y) * n + x % n;
  }
  IRG_INLINE constexpr float& pixel(int x, int y) const noexcept { return cell(x / 4, y / 2)->key[y % 2 * 4 + x % 4]; }
  IRG_INLINE constexpr float& block_far(int bx, int by) const noexcept {
    return farthest_key[tile_at(bx / blocks_across, by / blocks_across) * 64 +
                        static_cast<std::size_t>(by % blocks_across * blocks_across + bx % blocks_across)];
  }
};

inline namespace IRG_ABI {

// What the pixels beyond the picture hold: they never count as the farthest.
inline constexpr float mask_outside = std::numeric_limits<float>::infinity();

// A tile's pixels before the first triangle.
constexpr void clear_mask_tile(const mask_target& m, int tx, int ty) noexcept {
  const int x0 = tx * tile_size, y0 = ty * tile_size;
  const int width = lesser(m.width - x0, tile_size), height = lesser(m.height - y0, tile_size);
  mask_cell* cell = m.cell(x0 / 4, y0 / 2);
  if (width == tile_size && height == tile_size) {
    for (int i = 0; i < mask_cells_across * mask_cells_down; ++i)
      for (float& key : cell[i].key) key = m.farthest;
  } else {
    for (int y = 0; y < tile_size; ++y)
      for (int x = 0; x < tile_size; ++x) m.pixel(x0 + x, y0 + y) = x < width && y < height ? m.farthest : mask_outside;
  }
  const std::size_t tile = m.tile_at(tx, ty);
  for (int b = 0; b < 64; ++b)
    m.farthest_key[tile * 64 + static_cast<std::size_t>(b)] =
        b % blocks_across * block_size < width && b / blocks_across * block_size < height ? m.farthest : mask_outside;
  m.tile_far[tile] = m.farthest;
  m.stale[tile] = 0;
  m.touched[tile] = 1;
}
IRG_INLINE constexpr void touch_mask_tile(const mask_target& m, int tx, int ty) noexcept {
  if (m.touched[m.tile_at(tx, ty)] == 0) [[unlikely]]
    clear_mask_tile(m, tx, ty);
}

// A plane of keys, lowered by what rounding may amount to, here and in draw_triangle: the key of a pixel is
// (base + right * X) + down * Y, with (X, Y) counted from vertex 0 in 1/256 pixel. A covered pixel's key is not above
// what draw_triangle gives. The order of operations is fixed, so all paths have the same bits.
template <class F>
struct mask_plane {
  F base, right, down, high;

  IRG_INLINE constexpr F across(const F& x) const noexcept { return base + product(right, x); }
  IRG_INLINE constexpr F rise(const F& y) const noexcept { return product(down, y); }
  IRG_INLINE constexpr F key(const F& x, const F& y) const noexcept { return across(x) + rise(y); }
};

// The plane through the vertices 0, (x1, y1), (x2, y2) with their keys; `area` is x1 * y2 - y1 * x2, and no covered
// centre is farther from vertex 0 than `width` and `height`.
template <class F>
IRG_INLINE constexpr mask_plane<F> make_mask_plane(const F& x1, const F& y1, const F& x2, const F& y2, const F& area,
                                                   const F& width, const F& height, const F (&key)[3]) noexcept {
  using f = lanes<F>;
  const F inverse = f::broadcast(1.0f) / area, zero = f::broadcast(0.0f);
  const auto absolute = [&](const F& v) { return high_of(v, zero - v); };
  const F k1 = key[1] - key[0], k2 = key[2] - key[0];
  const F a = product(k1, y2), b = product(k2, y1), c = product(k2, x1), d = product(k1, x2);
  const F size_right = product(absolute(a) + absolute(b), absolute(inverse)),
          size_down = product(absolute(c) + absolute(d), absolute(inverse));
  const F size = (product(size_right, width) + product(size_down, height)) +
                 high_of(high_of(absolute(key[0]), absolute(key[1])), absolute(key[2]));
  // Each path from vertices to a key takes less than 12 roundings of 2^-24, and draw_triangle's errs by 8 of them.
  const F bias = product(size, f::broadcast(0x1p-19f)) + f::broadcast(0x1p-140f);
  // Where the farthest vertex is a better bound than the plane, as for slivers, all is as far.
  const F low = low_of(low_of(key[0], key[1]), key[2]), high = high_of(high_of(key[0], key[1]), key[2]);
  const auto level = high - low < bias + bias;
  return {select(level, low, key[0] - bias), select(level, zero, product(a - b, inverse)),
          select(level, zero, product(c - d, inverse)), high};
}

// The plane of one triangle.
IRG_INLINE constexpr mask_plane<float> mask_plane_of(const screen_vertex& a, const screen_vertex& b,
                                                     const screen_vertex& c, float sign) noexcept {
  const subpixel &p = a.position, &q = b.position, &r = c.position;
  const float key[3] = {product(a.depth, sign), product(b.depth, sign), product(c.depth, sign)};
  const auto number = [](std::int64_t i) { return static_cast<float>(i); };
  return make_mask_plane<float>(number(q.x - p.x), number(q.y - p.y), number(r.x - p.x), number(r.y - p.y),
                                number(signed_double_area(p, q, r)),
                                number(greater(greater(p.x, q.x), r.x) - lesser(lesser(p.x, q.x), r.x)),
                                number(greater(greater(p.y, q.y), r.y) - lesser(lesser(p.y, q.y), r.y)), key);
}

// From a vertex to the centre of a pixel, in 1/256 pixel; exact.
IRG_INLINE constexpr float mask_offset(int pixel, std::int32_t vertex) noexcept {
  return static_cast<float>(pixel * one_pixel + half_pixel - vertex);
}

// One triangle, pixel by pixel: what the fast way has to equal.
constexpr void draw_mask_plainly(const mask_target& m, const screen_vertex& a, const screen_vertex& b,
                                 const screen_vertex& c, const cell_window& window) {
  const triangle_coverage coverage = cover_triangle(a.position, b.position, c.position);
  if (coverage.double_area == 0) return;
  const mask_plane<float> plane = mask_plane_of(a, b, c, m.sign);
  covered_spans(coverage, window, [&](const span_of_cells& span) {
    for (int x = span.x_first; x < span.x_last; ++x) {
      touch_mask_tile(m, x / tile_size, span.y / tile_size);
      float& stored = m.pixel(x, span.y);
      stored = high_of(plane.key(mask_offset(x, a.position.x), mask_offset(span.y, a.position.y)), stored);
      m.stale[m.tile_at(x / tile_size, span.y / tile_size)] |=
          std::uint64_t{1} << (span.y % tile_size / block_size * blocks_across + x % tile_size / block_size);
    }
  });
}

// The farthest key of a block.
IRG_INLINE constexpr float mask_block_least(const mask_cell* cell) noexcept {
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated()) {
    using F = lanes<pack<float, tile_lanes>>;
    auto least = F::load(cell->key);
    for (int r = 0; r < block_size / 2; ++r, cell += mask_cells_across)
      for (int c = 0; c < block_size / 4; ++c)
        for (int k = 0; k < 8; k += tile_lanes) least = low_of(F::load(cell[c].key + k), least);
    return least_of(least);
  }
#endif
  float least = cell->key[0];
  for (int r = 0; r < block_size / 2; ++r, cell += mask_cells_across)
    for (int c = 0; c < block_size / 4; ++c)
      for (const float key : cell[c].key) least = lesser(key, least);
  return least;
}

// The farthest of the blocks of a tile, all of which are known.
IRG_INLINE constexpr void refresh_mask_tile(const mask_target& m, std::size_t tile) noexcept {
  const float* farthest_key = m.farthest_key + tile * 64;
  float least[8] = {farthest_key[0], farthest_key[1], farthest_key[2], farthest_key[3],
                    farthest_key[4], farthest_key[5], farthest_key[6], farthest_key[7]};
  for (int b = 8; b < 64; b += 8)
    for (int i = 0; i < 8; ++i) least[i] = low_of(farthest_key[b + i], least[i]);
  for (int i = 1; i < 8; ++i) least[0] = low_of(least[i], least[0]);
  m.tile_far[tile] = least[0];
}

// Makes the farthest keys of all blocks of a tile, and of the tile, known.
IRG_INLINE constexpr void finish_mask_tile(const mask_target& m, int tx, int ty) noexcept {
  const std::size_t tile = m.tile_at(tx, ty);
  if (m.touched[tile] == 0) return;
  float* farthest_key = m.farthest_key + tile * 64;
  for (std::uint64_t stale = m.stale[tile]; stale != 0; stale &= stale - 1) {
    const int b = std::countr_zero(stale);
    farthest_key[b] = mask_block_least(m.cell((tx * tile_size + b % blocks_across * block_size) / 4,
                                              (ty * tile_size + b / blocks_across * block_size) / 2));
  }
  m.stale[tile] = 0;
  refresh_mask_tile(m, tile);
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
