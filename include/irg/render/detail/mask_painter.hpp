// SPDX-License-Identifier: MIT
// Triangles into an occlusion mask, in lanes. The greatest key counts, so they may come in any order: small ones are
// set up N at a time and go in at once, without lists; large ones block by block.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/render/detail/mask_kernel.hpp>
#include <irg/render/detail/tile_drawing.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

// Small triangles, ready to be drawn, a lane each. F is taken at the first pixel of the first cell.
struct mask_group {
  static constexpr int most = native_lanes<std::int32_t>;
  std::int32_t f[3][most], right[3][most], down[3][most];
  float x[most], y[most];  // from vertex 0 to the first pixel
  float base[most], plane_right[most], plane_down[most];
  std::int32_t x_first[most], y_first[most], x_last[most], y_last[most];  // of cells: 4 columns, 2 rows
};

template <class T>
struct mask_painter {
  static constexpr int count = mask_group::most;
  using integers = pack<std::int32_t, count>;
  using floats = pack<float, count>;
  static constexpr int few = 2 * block_size;  // boxes up to this size are drawn row by row

  const mask_target& m;
  cell_window window;
  triangle_finder<T> find;
  std::uint32_t queue[2 * count] = {};  // small triangles, to be set up together
  int queued = 0;

  // Sets up the first `used` of the queue.
  IRG_INLINE void set_up(mask_group& g, int used) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    corner_lanes<count> c;
    c.collect(find, queue, used);
    const auto &x = c.x, &y = c.y;
    const floats sign = F::broadcast(m.sign);
    const floats key[3] = {c.depth[0] * sign, c.depth[1] * sign, c.depth[2] * sign};
    const integers left = low_of(low_of(x[0], x[1]), x[2]), right = high_of(high_of(x[0], x[1]), x[2]);
    const integers top = low_of(low_of(y[0], y[1]), y[2]), bottom = high_of(high_of(y[0], y[1]), y[2]);
    const integers zero = I::broadcast(0), one = I::broadcast(1);
    const integers before = I::broadcast(half_pixel - 1), behind = I::broadcast(one_pixel - half_pixel);
    // To the first pixel of a cell and behind the last of one: what lies in the window's cells and not in the window is
    // outside the picture, where nothing can be drawn.
    const auto down_to = [](const integers& v, int step) { return integers{v.v & -step}; };
    const integers x_first = down_to(high_of({(left + before).v >> subpixel_bits}, I::broadcast(window.x_first)), 4),
                   x_last = low_of({(right + behind).v >> subpixel_bits}, I::broadcast(window.x_last)),
                   y_first = down_to(high_of({(top + before).v >> subpixel_bits}, I::broadcast(window.y_first)), 2),
                   y_last = low_of({(bottom + behind).v >> subpixel_bits}, I::broadcast(window.y_last));
    I::store(g.x_first, {x_first.v >> 2});
    I::store(g.x_last, {(x_last + I::broadcast(3)).v >> 2});
    I::store(g.y_first, {y_first.v >> 1});
    I::store(g.y_last, {(y_last + I::broadcast(1)).v >> 1});

    const integers area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const integers flip = area < zero;
    const auto turned = [&](const integers& v) { return integers{(v.v ^ flip.v) - flip.v}; };
    const integers centre_x = x_first * I::broadcast(one_pixel) + I::broadcast(half_pixel),
                   centre_y = y_first * I::broadcast(one_pixel) + I::broadcast(half_pixel);
    F::store(g.x, to_float(centre_x - x[0]));
    F::store(g.y, to_float(centre_y - y[0]));
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      const integers dx = turned(x[q] - x[p]), dy = turned(y[q] - y[p]);
      const integers e = dx * (centre_y - y[p]) - dy * (centre_x - x[p]);
      const integers owns = (dy < zero) | both(dy == zero, zero < dx);
      I::store(g.f[k], {((e - one) - owns).v >> subpixel_bits});
      I::store(g.right[k], zero - dy);
      I::store(g.down[k], dx);
    }
    const auto plane = make_mask_plane<floats>(to_float(x[1] - x[0]), to_float(y[1] - y[0]), to_float(x[2] - x[0]),
                                               to_float(y[2] - y[0]), to_float(area), to_float(right - left),
                                               to_float(bottom - top), key);
    F::store(g.base, plane.base);
    F::store(g.plane_right, plane.right);
    F::store(g.plane_down, plane.down);
  }

  // Where a box of cells touches the tiles of a strip: tiles cleared if need be, blocks not known any longer.
  IRG_INLINE void mark(unsigned strip, unsigned x_first, unsigned x_last, unsigned y_first,
                       unsigned y_last) const noexcept {
    constexpr unsigned across = mask_cells_across, blocks = blocks_across;
    const std::uint64_t columns_in =
        (std::uint64_t{2} << (x_last - 1) % across / 2) - (std::uint64_t{1} << x_first % across / 2);
    for (unsigned by = y_first / 4; by <= (y_last - 1) / 4; ++by) {
      const int tx = static_cast<int>(strip), ty = static_cast<int>(by / blocks);
      touch_mask_tile(m, tx, ty);
      m.stale[m.tile_at(tx, ty)] |= columns_in << by % blocks * blocks;
    }
  }

  // How far the pixels of the registers of a cell are from its first, in columns and rows.
  static constexpr unsigned parts = 8u / static_cast<unsigned>(count);
  IRG_INLINE static integers columns() noexcept { return {lanes<integers>::ramp().v & 3}; }
  IRG_INLINE static integers rows(unsigned part) noexcept {
    return {(lanes<integers>::ramp().v >> 2) + static_cast<std::int32_t>(part)};
  }

  // The pixels in the second row of a cell.
  IRG_INLINE static integers lower(unsigned part) noexcept { return lanes<integers>::broadcast(0) < rows(part); }

  // Triangle i of a group, cell by cell.
  IRG_INLINE void draw_small(const mask_group& g, int i) const noexcept {
    const int x_first = g.x_first[i], x_last = g.x_last[i];
    const auto y_from = static_cast<unsigned>(g.y_first[i]), y_to = static_cast<unsigned>(g.y_last[i]);
    const auto end = static_cast<unsigned>(x_last);
    for (auto x = static_cast<unsigned>(x_first); x < end;) {
      const unsigned strip = x / mask_cells_across, stop = lesser(end, (strip + 1) * mask_cells_across);
      mark(strip, x, stop, y_from, y_to);
      x = stop;
    }
    int column = x_first;
    for (; x_last - column > 3; column += 3) draw_columns<3>(g, i, column);
    // One jump, and loops without a count of their own: small triangles are over before a processor could guess it.
    if (x_last - column == 1) return draw_columns<1>(g, i, column);
    if (x_last - column == 2) return draw_columns<2>(g, i, column);
    draw_columns<3>(g, i, column);
  }

  // Triangle i of a group, as far as it lies in some columns of cells.
  template <int Columns>
  IRG_INLINE void draw_columns(const mask_group& g, int i, int column) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const mask_plane<floats> plane{
        F::broadcast(g.base[i]), F::broadcast(g.plane_right[i]), F::broadcast(g.plane_down[i]), {}};
    const int skipped = 4 * (column - g.x_first[i]), y_first = g.y_first[i];
    constexpr auto n = static_cast<unsigned>(Columns);
    mask_cell* cell[n];
    floats across[n];
    for (unsigned k = 0; k < n; ++k) {
      cell[k] = m.cell(column + static_cast<int>(k), y_first);
      const integers from_first = columns() + I::broadcast(skipped + 4 * static_cast<int>(k));
      across[k] = plane.across(F::broadcast(g.x[i]) + to_float(from_first) * F::broadcast(one_pixel));
    }
    integers f[3][parts], right[3], down[3];
    floats y[parts];
    for (unsigned k = 0; k < 3; ++k) {
      const integers r = I::broadcast(g.right[k][i]), d = I::broadcast(g.down[k][i]);
      const integers first = I::broadcast(g.f[k][i]) + (columns() + I::broadcast(skipped)) * r;
      for (unsigned part = 0; part < parts; ++part) f[k][part] = first + both(lower(part), d);
      right[k] = {r.v * 4};
      down[k] = d + d;
    }
    for (unsigned part = 0; part < parts; ++part)
      y[part] = F::broadcast(g.y[i]) + to_float(rows(part)) * F::broadcast(one_pixel);
    std::size_t line = 0;
    for (int row = g.y_last[i] - y_first; row > 0; --row, line += mask_cells_across)
      for (unsigned part = 0; part < parts; ++part) {
        integers e[3] = {f[0][part], f[1][part], f[2][part]};
        const floats rise = plane.rise(y[part]);
        for (unsigned k = 0; k < n; ++k) {
          float* at = cell[k][line].key + part * static_cast<unsigned>(count);
          const auto stored = F::load(at);
          F::store(at, select((e[0] | e[1] | e[2]) < I::broadcast(0), stored, high_of(across[k] + rise, stored)));
          if (k + 1 < n)
            for (int edge = 0; edge < 3; ++edge) e[edge] = e[edge] + right[edge];
        }
        for (int edge = 0; edge < 3; ++edge) f[edge][part] = f[edge][part] + down[edge];
        y[part] = y[part] + F::broadcast(2 * one_pixel);
      }
  }

  // Draws a register of the queue, or what is left of it.
  IRG_NOINLINE void draw_queue(int used) noexcept {
    mask_group g;
    set_up(g, used);
    for (int i = 0; i < used; ++i)
      if (g.x_first[i] < g.x_last[i] && g.y_first[i] < g.y_last[i]) draw_small(g, i);
    for (int i = used; i < queued; ++i) queue[i - used] = queue[i];
    queued -= used;
  }
  IRG_INLINE void flush() noexcept {
    if (queued > 0) draw_queue(queued);
  }

  // The triangles first + k whose bit k is set: their boxes within the window are small and their sides below 2^15.
  IRG_INLINE void add_small(std::uint32_t first, unsigned bits) noexcept {
    for (unsigned k = 0; k < static_cast<unsigned>(count); ++k) {
      queue[queued] = first + k;
      queued += static_cast<int>(bits >> k & 1);
    }
    if (queued >= count) draw_queue(count);
  }

  // Any triangle, block by block. Blocks that no edge lets in, or that it lies behind, are passed over.
  IRG_NOINLINE void draw_large(const triangle_corners& c) const noexcept {
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

  void draw_tile(const triangle_coverage& t, const mask_plane<float>& plane, const subpixel& origin, int tx, int ty,
                 const cell_window& w) const noexcept {
    const std::size_t tile = m.tile_at(tx, ty);
    const int x = tx * tile_size, y = ty * tile_size;
    bool inside = true;
    for (const triangle_edge& e : t.edge) {
      const passing p = pass(e, x, y, tile_size);
      if (p.high < 0) return;
      inside = inside && p.low >= 0;
    }
    if (m.touched[tile] != 0 && m.stale[tile] == 0 &&
        (plane.high <= m.tile_far[tile] || nearest(plane, origin, x, y, tile_size) <= m.tile_far[tile]))
      return;
    touch_mask_tile(m, tx, ty);
    bool any = false;
    for (int by = w.y_first / block_size; by <= (w.y_last - 1) / block_size; ++by)
      for (int bx = w.x_first / block_size; bx <= (w.x_last - 1) / block_size; ++bx)
        any = draw_block(t, inside, plane, origin, tile, bx, by) || any;
    if (any && m.stale[tile] == 0) refresh_mask_tile(m, tile);
  }

  // gives   whether the block was gone into
  IRG_INLINE bool draw_block(const triangle_coverage& t, bool inside, const mask_plane<float>& plane,
                             const subpixel& origin, std::size_t tile, int bx, int by) const noexcept {
    const int x = bx * block_size, y = by * block_size;
    const std::uint64_t bit = std::uint64_t{1} << (by % blocks_across * blocks_across + bx % blocks_across);
    float& farthest_key = m.farthest_key[tile * 64 + static_cast<std::size_t>(std::countr_zero(bit))];
    if ((m.stale[tile] & bit) == 0 &&
        (plane.high <= farthest_key || nearest(plane, origin, x, y, block_size) <= farthest_key))
      return false;
    // An edge that runs through the block has values of 29 bits there at most; the others need not be known.
    std::int32_t f[3] = {}, right[3] = {}, down[3] = {};
    if (!inside) {
      inside = true;
      for (unsigned k = 0; k < 3; ++k) {
        const passing p = pass(t.edge[k], x, y, block_size);
        if (p.high < 0) return false;
        if (p.low >= 0) continue;
        inside = false;
        f[k] = static_cast<std::int32_t>(p.corner);
        right[k] = t.edge[k].right;
        down[k] = t.edge[k].down;
      }
    }
    mask_cell* cell = m.cell(x / 4, y / 2);
    const float dx = mask_offset(x, origin.x), dy = mask_offset(y, origin.y);
    farthest_key = inside ? draw_cells<true>(cell, f, right, down, plane, dx, dy)
                          : draw_cells<false>(cell, f, right, down, plane, dx, dy);
    m.stale[tile] &= ~bit;
    return true;
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
      const floats across =
          plane.across(F::broadcast(x) + to_float(columns() + I::broadcast(4 * column)) * F::broadcast(one_pixel));
      for (unsigned part = 0; part < parts; ++part) {
        integers e[3], step[3];
        if constexpr (!Inside)
          for (int k = 0; k < 3; ++k) {
            e[k] = I::broadcast(f[k]) + (columns() + I::broadcast(4 * column)) * I::broadcast(right[k]) +
                   rows(part) * I::broadcast(down[k]);
            step[k] = I::broadcast(2 * down[k]);
          }
        floats row_y = F::broadcast(y) + to_float(rows(part)) * F::broadcast(one_pixel);
        float* at = cell[column].key + part * static_cast<unsigned>(count);
        for (int row = 0; row < block_size / 2; ++row, at += 8 * mask_cells_across) {
          const auto stored = F::load(at);
          auto now = high_of(across + plane.rise(row_y), stored);
          if constexpr (!Inside) {
            now = select((e[0] | e[1] | e[2]) < I::broadcast(0), stored, now);
            for (int k = 0; k < 3; ++k) e[k] = e[k] + step[k];
          }
          F::store(at, now);
          least = low_of(now, least);
          row_y = row_y + F::broadcast(2 * one_pixel);
        }
      }
    }
    return least_of(least);
  }

  // A triangle of any size.
  IRG_INLINE void add(std::uint32_t number) noexcept {
    const triangle_corners c = find.corners(number);
    const cell_window box = pixels_touched(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    if (box.x_last - box.x_first <= few && box.y_last - box.y_first <= few)
      add_small(number, 1);
    else
      draw_large(c);
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
