// SPDX-License-Identifier: MIT
// Triangles into an occlusion mask, block by block, in lanes: what no edge lets in, and what lies behind the farthest
// depth of a block or a tile, is passed over.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <irg/render/detail/mask_kernel.hpp>
#include <irg/render/detail/triangle_finder.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

// The cells of a mask in registers.
struct mask_lanes {
  static constexpr int count = native_lanes<std::int32_t>;
  using integers = pack<std::int32_t, count>;
  using floats = pack<float, count>;

  // How far the pixels of the registers of a cell are from its first, in columns and rows.
  static constexpr unsigned parts = 8u / static_cast<unsigned>(count);
  IRG_INLINE static integers columns() noexcept { return {lanes<integers>::ramp().v & 3}; }
  IRG_INLINE static integers rows(unsigned part) noexcept {
    return {(lanes<integers>::ramp().v >> 2) + static_cast<std::int32_t>(part)};
  }

  // The pixels in the second row of a cell.
  IRG_INLINE static integers lower(unsigned part) noexcept { return lanes<integers>::broadcast(0) < rows(part); }

  // The keys where `edges` is not negative, and elsewhere what is not a number: high_of(that, stored) is `stored`.
  IRG_INLINE static floats covered_or_nan(const floats& key, const integers& edges) noexcept {
    integers bits;
    std::memcpy(&bits.v, &key.v, sizeof bits.v);
    bits = bits | integers{edges.v >> 31};
    floats result;
    std::memcpy(&result.v, &bits.v, sizeof bits.v);
    return result;
  }
};

struct mask_block_painter {
  using integers = mask_lanes::integers;
  using floats = mask_lanes::floats;
  static constexpr int count = mask_lanes::count;

  const mask_target& m;
  cell_window window;

  // Any triangle, block by block. Blocks that no edge lets in, or that it lies behind, are passed over.
  IRG_NOINLINE void draw(const triangle_corners& c) const noexcept {
    const triangle_coverage t = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    const cell_window w = intersect(t.bounds, window);
    if (t.double_area == 0 || w.empty()) return;
    const mask_plane<float> plane = mask_plane_of(*c.v[0], *c.v[1], *c.v[2], m.sign);
    for (int tx = w.x_first / tile_size; tx <= (w.x_last - 1) / tile_size; ++tx)
      for (int ty = w.y_first / tile_size; ty <= (w.y_last - 1) / tile_size; ++ty) {
        const int x = tx * tile_size, y = ty * tile_size;
        draw_tile(t, plane, c.v[0]->position, tx, ty, intersect(w, {x, y, x + tile_size, y + tile_size}));
      }
  }

  // How an edge passes a square of pixels.
  struct passing {
    std::int64_t corner, low, high;
  };
  IRG_INLINE static passing pass(const triangle_edge& e, int x, int y, int size) noexcept {
    const std::int64_t corner = e(x, y), across = std::int64_t{e.right} * (size - 1),
                       along = std::int64_t{e.down} * (size - 1), zero = 0;
    return {corner, corner + lesser(across, zero) + lesser(along, zero),
            corner + greater(across, zero) + greater(along, zero)};
  }
  // The nearest key in a square of pixels: rounding never turns the order of keys round, so it is in a corner.
  IRG_INLINE static float nearest(const mask_plane<float>& plane, const subpixel& origin, int x, int y,
                                  int size) noexcept {
    return plane.key(mask_offset(x + (plane.right > 0 ? size - 1 : 0), origin.x),
                     mask_offset(y + (plane.down > 0 ? size - 1 : 0), origin.y));
  }

  // A triangle within a tile. Edges that do not run through it have no say. The others have 0 somewhere in it, and are
  // not longer than the guard band is wide, 2^16 pixels: so F fits in 32 bits all over the tile.
  struct tile_part {
    std::int32_t f[3] = {}, right[3] = {}, down[3] = {};  // F at the tile's first pixel
  };

  void draw_tile(const triangle_coverage& t, const mask_plane<float>& plane, const subpixel& origin, int tx, int ty,
                 const cell_window& w) const noexcept {
    const std::size_t tile = m.tile_at(tx, ty);
    const int x = tx * tile_size, y = ty * tile_size;
    tile_part part;
    for (unsigned k = 0; k < 3; ++k) {
      const triangle_edge& e = t.edge[k];
      const passing p = pass(e, x, y, tile_size);
      if (p.high < 0) return;
      if (p.low >= 0) continue;
      part.f[k] = static_cast<std::int32_t>(p.corner);
      part.right[k] = e.right;
      part.down[k] = e.down;
    }
    if (m.touched[tile] != 0 && m.stale[tile] == 0 &&
        (plane.high <= m.tile_far[tile] || nearest(plane, origin, x, y, tile_size) <= m.tile_far[tile]))
      return;
    touch_mask_tile(m, tx, ty);
    const bool any = draw_blocks(part, plane, origin, tile, x, y, w);
    if (any && m.stale[tile] == 0) refresh_mask_tile(m, tile);
  }

  // The blocks of a tile, a row of them at a time: which of them the edges let in, and the depths.
  // gives   whether any was gone into
  IRG_INLINE bool draw_blocks(const tile_part& t, const mask_plane<float>& p, const subpixel& origin, std::size_t tile,
                              int x, int y, const cell_window& w) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    constexpr int last = block_size - 1;
    const mask_plane<floats> plane{F::broadcast(p.base), F::broadcast(p.right), F::broadcast(p.down), {}};
    const int down_to_nearest = p.down > 0 ? last : 0, right_to_nearest = p.right > 0 ? last : 0;
    std::int32_t least[3], greatest[3];  // of F in a block, relative to its first pixel
    for (int k = 0; k < 3; ++k) {
      least[k] = last * (lesser(t.right[k], 0) + lesser(t.down[k], 0));
      greatest[k] = last * (greater(t.right[k], 0) + greater(t.down[k], 0));
    }
    const int bx_first = (w.x_first - x) / block_size, bx_last = (w.x_last - 1 - x) / block_size;
    const auto columns_in = (2u << bx_last) - (1u << bx_first);
    bool any = false;
    for (int by = (w.y_first - y) / block_size; by <= (w.y_last - 1 - y) / block_size; ++by) {
      float* const farthest_key = m.farthest_key + tile * 64 + by * blocks_across;
      const float dy = mask_offset(y + by * block_size, origin.y),
                  nearest_y = mask_offset(y + by * block_size + down_to_nearest, origin.y);
      std::int32_t f[3][blocks_across];
      unsigned seen = 0, inside = 0;
      for (int part = 0; part < blocks_across; part += count) {
        const integers column = (I::ramp() + I::broadcast(part)) * I::broadcast(block_size);
        integers corner[3];
        for (int k = 0; k < 3; ++k) {
          corner[k] = I::broadcast(t.f[k] + t.down[k] * (by * block_size)) + column * I::broadcast(t.right[k]);
          I::store(f[k] + part, corner[k]);
        }
        const auto all = [&](const std::int32_t(&rest)[3]) {
          return mask_bits(none_negative(corner[0] + I::broadcast(rest[0]), corner[1] + I::broadcast(rest[1]),
                                         corner[2] + I::broadcast(rest[2])));
        };
        const integers nearest_x = (column + I::broadcast(x + right_to_nearest)) * I::broadcast(one_pixel) +
                                   I::broadcast(half_pixel - origin.x);
        const floats bound = low_of(plane.key(to_float(nearest_x), F::broadcast(nearest_y)), F::broadcast(p.high));
        const unsigned nearer = mask_bits(F::load(farthest_key + part) < bound);
        const unsigned unknown = static_cast<unsigned>(m.stale[tile] >> (by * blocks_across + part));
        seen |= (all(greatest) & (nearer | unknown)) << part;
        inside |= all(least) << part;
      }
      for (seen &= columns_in; seen != 0; seen &= seen - 1) {
        const int bx = std::countr_zero(seen);
        mask_cell* cell = m.cell(x / 4, y / 2) + (by * (block_size / 2) * mask_cells_across + bx * (block_size / 4));
        const float dx = mask_offset(x + bx * block_size, origin.x);
        const std::int32_t at[3] = {f[0][bx], f[1][bx], f[2][bx]};
        farthest_key[bx] = (inside >> bx & 1) != 0 ? draw_cells<true>(cell, at, t.right, t.down, p, dx, dy)
                                                   : draw_cells<false>(cell, at, t.right, t.down, p, dx, dy);
        m.stale[tile] &= ~(std::uint64_t{1} << (by * blocks_across + bx));
        any = true;
      }
    }
    return any;
  }

  // The pixels of a block.
  // gives   the farthest key that is there now
  template <bool Inside>
  IRG_INLINE static float draw_cells(mask_cell* cell, const std::int32_t (&f)[3], const std::int32_t (&right)[3],
                                     const std::int32_t (&down)[3], const mask_plane<float>& p, float x,
                                     float y) noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const mask_plane<floats> plane{F::broadcast(p.base), F::broadcast(p.right), F::broadcast(p.down), {}};
    auto least = F::broadcast(mask_outside);
    for (int column = 0; column < block_size / 4; ++column) {
      const floats across = plane.across(F::broadcast(x) + to_float(mask_lanes::columns() + I::broadcast(4 * column)) *
                                                               F::broadcast(one_pixel));
      for (unsigned part = 0; part < mask_lanes::parts; ++part) {
        integers e[3], step[3];
        if constexpr (!Inside)
          for (int k = 0; k < 3; ++k) {
            e[k] = I::broadcast(f[k]) + (mask_lanes::columns() + I::broadcast(4 * column)) * I::broadcast(right[k]) +
                   mask_lanes::rows(part) * I::broadcast(down[k]);
            step[k] = I::broadcast(2 * down[k]);
          }
        floats row_y = F::broadcast(y) + to_float(mask_lanes::rows(part)) * F::broadcast(one_pixel);
        float* at = cell[column].key + part * static_cast<unsigned>(count);
        for (int row = 0; row < block_size / 2; ++row, at += 8 * mask_cells_across) {
          const auto stored = F::load(at);
          auto key = across + plane.rise(row_y);
          if constexpr (!Inside) {
            key = mask_lanes::covered_or_nan(key, e[0] | e[1] | e[2]);
            for (int k = 0; k < 3; ++k) e[k] = e[k] + step[k];
          }
          const auto now = high_of(key, stored);
          F::store(at, now);
          least = low_of(now, least);
          row_y = row_y + F::broadcast(2 * one_pixel);
        }
      }
    }
    return least_of(least);
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
