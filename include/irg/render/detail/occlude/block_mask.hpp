// SPDX-License-Identifier: MIT
// What large triangles hide, by blocks of 8 x 8 pixels: for each block a key that no pixel of it lies behind, and one
// layer of triangles that so far cover it in part. When the layer covers the block it becomes the block's key, so that
// two triangles with a common edge hide as much as the face they were cut from. Coverage is exact to the pixel, depths
// are never nearer than those that drawing gives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/math/floor_division.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/render/detail/occlude/mask_query.hpp>
#include <irg/render/detail/visible/tile.hpp>

namespace irg {
namespace detail {

// The memory of a mask. Keys as in tile.hpp.
struct block_mask {
  int width = 0, height = 0, across = 0, down = 0;  // in pixels and in blocks
  float sign = 1;
  std::vector<float> farthest_key, layer_key;  // by block
  std::vector<std::uint64_t> layer;  // the pixels that have `layer_key` or a nearer one, row after row

  IRG_INLINE constexpr std::size_t at(int bx, int by) const noexcept {
    return static_cast<std::size_t>(by) * static_cast<std::size_t>(across) + static_cast<std::size_t>(bx);
  }
};

inline namespace IRG_ABI {

inline constexpr std::uint64_t whole_block = ~std::uint64_t{0};

// An empty mask.
constexpr void clear_block_mask(block_mask& m, int width, int height, float sign, float farthest) {
  m.width = width;
  m.height = height;
  m.across = (width + block_size - 1) / block_size;
  m.down = (height + block_size - 1) / block_size;
  m.sign = sign;
  const std::size_t count = static_cast<std::size_t>(m.across) * static_cast<std::size_t>(m.down);
  m.farthest_key.assign(count, farthest);
  m.layer_key.assign(count, farthest);
  m.layer.assign(count, 0);
}

// The pixels of a block that lie in a window; bit 8 * y + x.
constexpr std::uint64_t block_bits(const cell_window& w, int bx, int by) noexcept {
  const int x = bx * block_size, y = by * block_size;
  const cell_window in = intersect(w, {x, y, x + block_size, y + block_size});
  if (in.empty()) return 0;
  const auto bits_below = [](int n) { return n == 8 ? whole_block : (std::uint64_t{1} << 8 * n) - 1; };
  const std::uint64_t row = ((std::uint64_t{1} << (in.x_last - x)) - 1) & ~((std::uint64_t{1} << (in.x_first - x)) - 1);
  const std::uint64_t rows = bits_below(in.y_last - y) & ~bits_below(in.y_first - y);
  return row * 0x0101010101010101u & rows;
}

// The pixels of a block that a triangle covers.
constexpr std::uint64_t block_coverage(const triangle_coverage& t, int bx, int by) noexcept {
  std::uint64_t bits = 0;
  for (int y = 0; y < block_size; ++y) {
    const int row = by * block_size + y, x = bx * block_size;
    std::int64_t f[3] = {t.edge[0](x, row), t.edge[1](x, row), t.edge[2](x, row)};
    for (int i = 0; i < block_size; ++i) {
      bits |= std::uint64_t{(f[0] | f[1] | f[2]) >= 0} << (y * block_size + i);
      for (int k = 0; k < 3; ++k) f[k] += t.edge[k].right;
    }
  }
  return bits;
}

// Some pixels of a block at `key` or nearer. One layer cannot hold two depths: of two that are far apart the nearer one
// is kept alone.
constexpr void cover_block(block_mask& m, std::size_t block, std::uint64_t bits, float key) noexcept {
  float& farthest = m.farthest_key[block];
  float& layer_key = m.layer_key[block];
  std::uint64_t& layer = m.layer[block];
  if (!(farthest < key)) return;
  if (layer == 0 || !(farthest < layer_key) || key - layer_key > layer_key - farthest) {
    layer = bits;
    layer_key = key;
  } else if (layer_key - key <= key - farthest) {
    layer |= bits;
    layer_key = lesser(layer_key, key);
  }
  if (layer != whole_block) return;
  farthest = layer_key;
  layer = 0;
}

// The columns of blocks, between first and last, in whose row `by` an edge has some, and has all, pixels on its inner
// side.
struct block_columns {
  std::int64_t first, last, inner_first, inner_last;
};
constexpr void limit_columns(block_columns& c, const triangle_edge& e, int by) noexcept {
  constexpr std::int64_t far_side = block_size - 1;
  const std::int64_t at_start = e(0, by * block_size), step = std::int64_t{e.right} * block_size;
  const std::int64_t across = e.right * far_side, along = e.down * far_side, zero = 0;
  const auto limit = [&](std::int64_t f, std::int64_t& first, std::int64_t& last) {
    if (step > 0)
      first = greater(first, -floor_div(f, step));
    else if (step < 0)
      last = lesser(last, floor_div(f, -step) + 1);
    else if (f < 0)
      last = first;
  };
  limit(at_start + greater(across, zero) + greater(along, zero), c.first, c.last);
  limit(at_start + lesser(across, zero) + lesser(along, zero), c.inner_first, c.inner_last);
}

// A plane of keys: that of a pixel is (base + right * X) + down * Y, with (X, Y) counted from vertex 0 in 1/256 pixel,
// or `low` where that is nearer.
struct key_plane {
  float base, right, down, low;

  IRG_INLINE constexpr float across(float x) const noexcept { return base + product(right, x); }
  IRG_INLINE constexpr float rise(float y) const noexcept { return product(down, y); }
};

// The plane through three vertices, lowered by what rounding may amount to, here and in draw_triangle: no covered pixel
// is farther. None is farther than the farthest vertex either, which is the better bound for slivers.
constexpr key_plane plane_below(const screen_vertex& a, const screen_vertex& b, const screen_vertex& c,
                                float sign) noexcept {
  const auto number = [](std::int64_t i) { return static_cast<float>(i); };
  const auto absolute = [](float v) { return v < 0 ? -v : v; };
  const subpixel &p = a.position, &q = b.position, &r = c.position;
  const float x1 = number(q.x - p.x), y1 = number(q.y - p.y), x2 = number(r.x - p.x), y2 = number(r.y - p.y);
  const float width = number(greater(greater(p.x, q.x), r.x) - lesser(lesser(p.x, q.x), r.x)),
              height = number(greater(greater(p.y, q.y), r.y) - lesser(lesser(p.y, q.y), r.y));
  const float key0 = product(a.depth, sign), key1 = product(b.depth, sign), key2 = product(c.depth, sign);
  const float inverse = 1.0f / number(signed_double_area(p, q, r)), k1 = key1 - key0, k2 = key2 - key0;
  const float right1 = product(k1, y2), right2 = product(k2, y1), down1 = product(k2, x1), down2 = product(k1, x2);
  const float size_right = product(absolute(right1) + absolute(right2), absolute(inverse)),
              size_down = product(absolute(down1) + absolute(down2), absolute(inverse));
  const float size = (product(size_right, width) + product(size_down, height)) +
                     greater(greater(absolute(key0), absolute(key1)), absolute(key2));
  // Each path from vertices to a key takes less than 12 roundings of 2^-24, and draw_triangle's errs by 8 of them.
  const float bias = product(size, 0x1p-19f) + 0x1p-140f;
  return {key0 - bias, product(right1 - right2, inverse), product(down1 - down2, inverse),
          lesser(lesser(key0, key1), key2)};
}

// From a vertex to the centre of a pixel, in 1/256 pixel; exact.
IRG_INLINE constexpr float offset_to(int pixel, std::int32_t vertex) noexcept {
  return static_cast<float>(pixel * one_pixel + half_pixel - vertex);
}

// Draws a triangle.
constexpr void draw_block_mask(block_mask& m, const screen_vertex& a, const screen_vertex& b, const screen_vertex& c) {
  const triangle_coverage t = cover_triangle(a.position, b.position, c.position);
  const cell_window picture{0, 0, m.width, m.height}, w = intersect(t.bounds, picture);
  if (t.double_area == 0 || w.empty()) return;
  const key_plane plane = plane_below(a, b, c, m.sign);
  const int right = plane.right < 0 ? block_size - 1 : 0, down = plane.down < 0 ? block_size - 1 : 0;
  const cell_window blocks = squares_of(w, block_size);
  for (int by = blocks.y_first; by < blocks.y_last; ++by) {
    block_columns columns{blocks.x_first, blocks.x_last, blocks.x_first, blocks.x_last};
    for (const triangle_edge& e : t.edge) limit_columns(columns, e, by);
    // The farthest key in a block: rounding never turns the order of keys round, so it is in a corner.
    const float rise = plane.rise(offset_to(by * block_size + down, a.position.y));
    const auto key_of = [&](int bx) {
      const float key = plane.across(offset_to(bx * block_size + right, a.position.x)) + rise;
      return greater(plane.low, key);
    };
    const auto in_part = [&](std::int64_t from, std::int64_t to) {
      for (std::int64_t i = from; i < to; ++i) {
        const int bx = static_cast<int>(i);
        const std::uint64_t bits = block_coverage(t, bx, by) | ~block_bits(picture, bx, by);
        cover_block(m, m.at(bx, by), bits, key_of(bx));
      }
    };
    if (columns.inner_first >= columns.inner_last) {
      in_part(columns.first, columns.last);
      continue;
    }
    in_part(columns.first, columns.inner_first);
    float* const row = m.farthest_key.data() + m.at(0, by);
    for (std::int64_t i = columns.inner_first; i < columns.inner_last; ++i) {
      const float key = key_of(static_cast<int>(i));
      row[i] = row[i] < key ? key : row[i];
    }
    in_part(columns.inner_last, columns.last);
  }
}

// Whether everything in a window of pixels that is at `key` or farther is hidden. Hidden means behind what was drawn:
// `key` or a nearer one at each pixel.
constexpr bool hidden_by_blocks(const block_mask& m, const cell_window& pixels, float key) noexcept {
  const cell_window w = intersect(pixels, {0, 0, m.width, m.height});
  if (w.empty() || !(key == key)) return false;
  return !any_square(w, block_size, [&](const cell_window& part, int bx, int by) {
    const std::size_t block = m.at(bx, by);
    if (key <= m.farthest_key[block]) return false;
    return !(key <= m.layer_key[block]) || (block_bits(part, bx, by) & ~m.layer[block]) != 0;
  });
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
