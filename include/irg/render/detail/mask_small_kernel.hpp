// SPDX-License-Identifier: MIT
// Small triangles into an occlusion mask, in lanes: set up N at a time, and drawn without lists. Those of a pixel or
// few are drawn N at a time, too; of the others each goes cell by cell over its box.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <irg/render/detail/mask_block_kernel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

// Small triangles, ready to be drawn, a lane each. F is taken at the first pixel of the first cell.
struct mask_group {
  static constexpr int most = native_lanes<std::int32_t>;
  std::int32_t f[3][most], right[3][most], down[3][most], right4[3][most], down2[3][most];
  float x[most], y[most];  // from vertex 0 to the first pixel
  float base[most], plane_right[most], plane_down[most];
  std::int32_t x_first[most], y_first[most], columns[most], rows[most];  // of cells: 4 columns, 2 rows
  std::int32_t cell[3][most];  // the first columns' cells in the first row
};

// The lanes whose bits are set, one behind the other from `to` on, where there must be room for all lanes.
// gives   how many they are
template <class T, int N>
IRG_INLINE int store_chosen(T* to, const pack<T, N>& from, unsigned bits) noexcept {
  static_assert(sizeof(T) == 4);
#ifdef __AVX512VL__
  if constexpr (N == 8) {
    typedef int ints __attribute__((vector_size(32)));
    const ints packed =
        __builtin_ia32_compresssi256_mask(reinterpret_cast<ints>(from.v), ints{}, static_cast<unsigned char>(bits));
    std::memcpy(to, &packed, sizeof packed);
    return std::popcount(bits);
  }
#endif
  T all[static_cast<unsigned>(N)];
  lanes<pack<T, N>>::store(all, from);
  int n = 0;
  for (unsigned k = 0; k < static_cast<unsigned>(N); ++k) {
    to[n] = all[k];
    n += static_cast<int>(bits >> k & 1);
  }
  return n;
}

template <class T>
struct mask_small_painter {
  using integers = mask_lanes::integers;
  using floats = mask_lanes::floats;
  static constexpr int count = mask_lanes::count;
  static constexpr int few = 2 * block_size;  // boxes up to this size are small
  static constexpr int dot = 2;  // those up to this size are dots

  const mask_target& m;
  cell_window window;
  triangle_finder<T> find;

  // Shapes: dots by columns and rows of pixels, small triangles by those of cells.
  static constexpr int dot_shapes = dot * dot, cell_columns = 4, cell_rows = 5,
                       shapes = dot_shapes + cell_columns * cell_rows;

  // Triangles that wait for others of their shape: the jumps that a shape needs are then the same for a whole register
  // of them, which a processor learns.
  std::uint32_t wait[static_cast<unsigned>(shapes)][static_cast<unsigned>(2 * count)] = {};
  int waiting[static_cast<unsigned>(shapes)] = {};
  // Before that, those of which the shape is known, and after it, pixels of dots.
  static constexpr int dots_at_once = 32;
  std::int32_t chosen[static_cast<unsigned>(2 * count)] = {}, chosen_shape[static_cast<unsigned>(2 * count)] = {};
  std::int32_t dot_place[static_cast<unsigned>(dots_at_once + count)] = {};  // 8 * cell + pixel in it
  float dot_key[static_cast<unsigned>(dots_at_once + count)] = {};
  int chosen_count = 0, dot_count = 0;

  // What N triangles need to be drawn, in registers.
  struct set_up_lanes {
    integers f[3], right[3], down[3];  // F at the centre of pixel (x_first, y_first)
    floats x, y;  // from vertex 0 to there
    mask_plane<floats> plane;
    integers x_first, y_first, x_last, y_last;  // pixels
  };

  // The first `used` of a queue; boxes start at multiples of Columns and Rows. What lies beyond the window is cut off,
  // but for what belongs to its outermost cells: that is outside the picture, where nothing can be drawn.
  template <int Columns, int Rows>
  IRG_INLINE set_up_lanes prepare(const std::uint32_t* numbers, int used) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    corner_lanes<count> c;
    c.collect(find, numbers, used);
    const auto &x = c.x, &y = c.y;
    const floats sign = F::broadcast(m.sign);
    const floats key[3] = {c.depth[0] * sign, c.depth[1] * sign, c.depth[2] * sign};
    const integers left = low_of(low_of(x[0], x[1]), x[2]), right = high_of(high_of(x[0], x[1]), x[2]);
    const integers top = low_of(low_of(y[0], y[1]), y[2]), bottom = high_of(high_of(y[0], y[1]), y[2]);
    const integers zero = I::broadcast(0), one = I::broadcast(1);
    const integers before = I::broadcast(half_pixel - 1), behind = I::broadcast(one_pixel - half_pixel);
    const auto down_to = [](const integers& v, int step) { return integers{v.v & -step}; };
    set_up_lanes s;
    s.x_first = down_to(high_of({(left + before).v >> subpixel_bits}, I::broadcast(window.x_first)), Columns);
    s.x_last = low_of({(right + behind).v >> subpixel_bits}, I::broadcast(window.x_last));
    s.y_first = down_to(high_of({(top + before).v >> subpixel_bits}, I::broadcast(window.y_first)), Rows);
    s.y_last = low_of({(bottom + behind).v >> subpixel_bits}, I::broadcast(window.y_last));

    const integers area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const integers flip = area < zero;
    const auto turned = [&](const integers& v) { return integers{(v.v ^ flip.v) - flip.v}; };
    const integers centre_x = s.x_first * I::broadcast(one_pixel) + I::broadcast(half_pixel),
                   centre_y = s.y_first * I::broadcast(one_pixel) + I::broadcast(half_pixel);
    s.x = to_float(centre_x - x[0]);
    s.y = to_float(centre_y - y[0]);
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      const integers dx = turned(x[q] - x[p]), dy = turned(y[q] - y[p]);
      const integers e = dx * (centre_y - y[p]) - dy * (centre_x - x[p]);
      const integers owns = (dy < zero) | both(dy == zero, zero < dx);
      s.f[k] = {((e - one) - owns).v >> subpixel_bits};
      s.right[k] = zero - dy;
      s.down[k] = dx;
    }
    s.plane = make_mask_plane<floats>(to_float(x[1] - x[0]), to_float(y[1] - y[0]), to_float(x[2] - x[0]),
                                      to_float(y[2] - y[0]), to_float(area), to_float(right - left),
                                      to_float(bottom - top), key);
    return s;
  }

  // The number of a cell by its column and row: less than 2^29.
  IRG_INLINE integers cell_at(const integers& column, const integers& row) const noexcept {
    return {(column.v >> 4) * (m.down << 9) + (row.v << 4) + (column.v & 15)};
  }

  // Sets up some small triangles.
  IRG_INLINE void set_up(mask_group& g, const std::uint32_t* numbers, int used) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const set_up_lanes s = prepare<4, 2>(numbers, used);
    const integers x{s.x_first.v >> 2}, y{s.y_first.v >> 1};
    I::store(g.x_first, x);
    I::store(g.y_first, y);
    I::store(g.columns, {((s.x_last.v + 3) >> 2) - x.v});
    I::store(g.rows, {((s.y_last.v + 1) >> 1) - y.v});
    for (int k = 0; k < 3; ++k) I::store(g.cell[k], cell_at(x + I::broadcast(k), y));
    F::store(g.x, s.x);
    F::store(g.y, s.y);
    for (int k = 0; k < 3; ++k) {
      I::store(g.f[k], s.f[k]);
      I::store(g.right[k], s.right[k]);
      I::store(g.down[k], s.down[k]);
      I::store(g.right4[k], {s.right[k].v << 2});
      I::store(g.down2[k], {s.down[k].v << 1});
    }
    F::store(g.base, s.plane.base);
    F::store(g.plane_right, s.plane.right);
    F::store(g.plane_down, s.plane.down);
  }

  // Draws some dots of so many columns and rows at most: one pixel of each box at a time.
  template <int Columns, int Rows>
  IRG_NOINLINE void draw_dots(const std::uint32_t* numbers, int used) noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const set_up_lanes s = prepare<1, 1>(numbers, used);
    const integers columns_of = s.x_last - s.x_first, rows_of = s.y_last - s.y_first;
    const unsigned which = (1u << used) - 1;
    for (int dy = 0; dy < Rows; ++dy) {
      const integers y = s.y_first + I::broadcast(dy);
      const floats rise = s.plane.rise(s.y + F::broadcast(static_cast<float>(dy * one_pixel)));
      for (int dx = 0; dx < Columns; ++dx) {
        integers f[3];
        for (int k = 0; k < 3; ++k) {
          f[k] = s.f[k];
          for (int i = 0; i < dx; ++i) f[k] = f[k] + s.right[k];
          for (int i = 0; i < dy; ++i) f[k] = f[k] + s.down[k];
        }
        const integers within = both(I::broadcast(dx) < columns_of, I::broadcast(dy) < rows_of);
        const unsigned covered = mask_bits(both(none_negative(f[0], f[1], f[2]), within)) & which;
        if constexpr (Columns * Rows > 1)
          if (covered == 0) continue;
        const integers x = s.x_first + I::broadcast(dx);
        const floats key = s.plane.across(s.x + F::broadcast(static_cast<float>(dx * one_pixel))) + rise;
        store_chosen(dot_key + dot_count, key, covered);
        const integers in_cell{(y.v & 1) * 4 + (x.v & 3)};
        dot_count += store_chosen(dot_place + dot_count, integers{(cell_at({x.v >> 2}, {y.v >> 1}).v << 3) | in_cell.v},
                                  covered);
        if (dot_count >= dots_at_once) {
          for (int i = 0; i < dots_at_once; ++i) draw_dot(dot_key[i], static_cast<std::uint32_t>(dot_place[i]));
          dot_count -= dots_at_once;
          for (int i = 0; i < count; ++i) {
            dot_key[i] = dot_key[dots_at_once + i];
            dot_place[i] = dot_place[dots_at_once + i];
          }
        }
      }
    }
  }
  IRG_INLINE void draw_dot(float key, std::uint32_t place) const noexcept {
    touch(place >> 12, std::uint64_t{1} << ((place >> 6 & 0x38) | (place >> 4 & 7)));
    float& stored = m.cells[place >> 3].key[place & 7];
    stored = high_of(key, stored);
  }

  // Before blocks of a tile are drawn to.
  IRG_INLINE void touch(std::size_t tile, std::uint64_t blocks) const noexcept {
    if (m.touched[tile] == 0) [[unlikely]] {
      const int number = static_cast<int>(tile);
      clear_mask_tile(m, number / m.down, number % m.down);
    }
    m.stale[tile] |= blocks;
  }

  // Before cells are drawn to, the first of them at (x, y).
  IRG_INLINE void touch_cells(unsigned cell, unsigned x, unsigned y, unsigned columns, unsigned rows) const noexcept {
    constexpr unsigned across = mask_cells_across, down = mask_cells_down;
    constexpr std::uint64_t each_row[] = {1, 0x101, 0x10101, 0x1010101};
    const unsigned column = x % across, row = y % down;
    const auto in_row = [](unsigned first, unsigned n) {
      return (std::uint64_t{2} << (first + n - 1) / 2) - (std::uint64_t{1} << first / 2);
    };
    if (column + columns <= across && row + rows <= down) [[likely]] {
      const unsigned by = row / 4;
      return touch(cell / (across * down), in_row(column, columns) * each_row[(row + rows - 1) / 4 - by] << 8 * by);
    }
    for (unsigned i = 0; i < columns;) {
      const unsigned strip = (x + i) / across, n = lesser(columns - i, (strip + 1) * across - (x + i));
      for (unsigned by = y / 4; by <= (y + rows - 1) / 4; ++by)
        touch(m.tile_at(static_cast<int>(strip), static_cast<int>(by / blocks_across)),
              in_row((x + i) % across, n) << by % blocks_across * blocks_across);
      i += n;
    }
  }

  // Triangle i of a group, cell by cell.
  IRG_INLINE void draw_small(const mask_group& g, int i) const noexcept {
    const int columns_of = g.columns[i];
    touch_cells(static_cast<unsigned>(g.cell[0][i]), static_cast<unsigned>(g.x_first[i]),
                static_cast<unsigned>(g.y_first[i]), static_cast<unsigned>(columns_of),
                static_cast<unsigned>(g.rows[i]));
    // Loops without a count of their own: small triangles are over before a processor could guess it.
    if (columns_of == 1) return draw_columns<1>(g, i, 0);
    if (columns_of == 2) return draw_columns<2>(g, i, 0);
    draw_columns<3>(g, i, 0);
    for (int skipped = 3; skipped < columns_of; ++skipped) draw_columns<1>(g, i, skipped);
  }

  // Triangle i of a group, as far as it lies in some columns of cells.
  template <int Columns>
  IRG_INLINE void draw_columns(const mask_group& g, int i, int columns_skipped) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const mask_plane<floats> plane{
        F::broadcast(g.base[i]), F::broadcast(g.plane_right[i]), F::broadcast(g.plane_down[i]), {}};
    const int skipped = 4 * columns_skipped;
    constexpr auto n = static_cast<unsigned>(Columns);
    mask_cell* cell[n];
    floats across[n];
    for (unsigned k = 0; k < n; ++k) {
      cell[k] = columns_skipped == 0 ? m.cells + g.cell[k][i] : m.cell(g.x_first[i] + columns_skipped, g.y_first[i]);
      const integers from_first = mask_lanes::columns() + I::broadcast(skipped + 4 * static_cast<int>(k));
      across[k] = plane.across(F::broadcast(g.x[i]) + to_float(from_first) * F::broadcast(one_pixel));
    }
    integers f[3][mask_lanes::parts], right[3], down[3];
    floats y[mask_lanes::parts];
    for (unsigned k = 0; k < 3; ++k) {
      const integers r = I::broadcast(g.right[k][i]), d = I::broadcast(g.down[k][i]);
      const integers first = I::broadcast(g.f[k][i]) + (mask_lanes::columns() + I::broadcast(skipped)) * r;
      for (unsigned part = 0; part < mask_lanes::parts; ++part) f[k][part] = first + both(mask_lanes::lower(part), d);
      right[k] = I::broadcast(g.right4[k][i]);
      down[k] = I::broadcast(g.down2[k][i]);
    }
    for (unsigned part = 0; part < mask_lanes::parts; ++part)
      y[part] = F::broadcast(g.y[i]) + to_float(mask_lanes::rows(part)) * F::broadcast(one_pixel);
    std::size_t line = 0;
    for (int row = g.rows[i]; row > 0; --row, line += mask_cells_across)
      for (unsigned part = 0; part < mask_lanes::parts; ++part) {
        integers e[3] = {f[0][part], f[1][part], f[2][part]};
        const floats rise = plane.rise(y[part]);
        for (unsigned k = 0; k < n; ++k) {
          float* at = cell[k][line].key + part * static_cast<unsigned>(count);
          const auto stored = F::load(at);
          F::store(at, high_of(mask_lanes::covered_or_nan(across[k] + rise, e[0] | e[1] | e[2]), stored));
          if (k + 1 < n)
            for (int edge = 0; edge < 3; ++edge) e[edge] = e[edge] + right[edge];
        }
        for (int edge = 0; edge < 3; ++edge) f[edge][part] = f[edge][part] + down[edge];
        y[part] = y[part] + F::broadcast(2 * one_pixel);
      }
  }

  IRG_NOINLINE void draw_cells_of(const std::uint32_t* numbers, int used) noexcept {
    mask_group g;
    set_up(g, numbers, used);
    for (int i = 0; i < used; ++i)
      if (g.columns[i] > 0 && g.rows[i] > 0) draw_small(g, i);
  }

  // The shape of boxes of pixels that are at most `few` wide and high.
  IRG_INLINE static integers shape_of(const integers& x_first, const integers& y_first, const integers& x_last,
                                      const integers& y_last) noexcept {
    using I = lanes<integers>;
    const integers w = x_last - x_first, h = y_last - y_first, one = I::broadcast(1);
    const integers columns_of = low_of({((x_last.v + 3) >> 2) - (x_first.v >> 2)}, I::broadcast(cell_columns)) - one,
                   rows_of = low_of({((y_last.v + 1) >> 1) - (y_first.v >> 1)}, I::broadcast(cell_rows)) - one;
    const integers most = I::broadcast(dot + 1);
    return select(both(w < most, h < most), (h - one) * I::broadcast(dot) + w - one,
                  rows_of * I::broadcast(cell_columns) + columns_of + I::broadcast(dot_shapes));
  }

  // The triangles whose bits are set, by the shapes of their boxes: these are small, no side is 2^15 long.
  IRG_INLINE void add(const integers& number, unsigned bits, const integers& shape) noexcept {
    store_chosen(chosen + chosen_count, number, bits);
    chosen_count += store_chosen(chosen_shape + chosen_count, shape, bits);
    if (chosen_count >= count) sort_chosen(count);
  }
  // To those that wait.
  IRG_INLINE void sort_chosen(int n) noexcept {
    std::uint32_t full = 0;
    static_assert(shapes <= 32);
    for (int i = 0; i < n; ++i) {
      const int shape = chosen_shape[i], place = waiting[shape]++;
      wait[shape][place] = static_cast<std::uint32_t>(chosen[i]);
      full |= static_cast<std::uint32_t>((place + 1) / count) << shape;
    }
    chosen_count -= n;
    for (int i = 0; i < count; ++i) {
      chosen[i] = chosen[count + i];
      chosen_shape[i] = chosen_shape[count + i];
    }
    for (; full != 0; full &= full - 1) draw_shape(std::countr_zero(full));
  }
  IRG_NOINLINE void draw_shape(int shape) noexcept {
    std::uint32_t* number = wait[shape];
    switch (shape) {
      case 0: draw_dots<1, 1>(number, count); break;
      case 1: draw_dots<2, 1>(number, count); break;
      case 2: draw_dots<1, 2>(number, count); break;
      case 3: draw_dots<2, 2>(number, count); break;
      default: draw_cells_of(number, count);
    }
    waiting[shape] -= count;
    for (int i = 0; i < count; ++i) number[i] = number[count + i];
  }
  // What still waits, whatever its shape.
  IRG_NOINLINE void flush() noexcept {
    std::uint32_t left[static_cast<unsigned>(shapes * count)];
    int n = 0;
    sort_chosen(chosen_count);
    const auto draw_left = [&](int shape_first, int shape_last, auto draw) {
      n = 0;
      for (int s = shape_first; s < shape_last; ++s) {
        for (int i = 0; i < waiting[s]; ++i) left[n++] = wait[s][i];
        waiting[s] = 0;
      }
      for (int i = 0; i < n; i += count) draw(left + i, lesser(n - i, count));
    };
    draw_left(0, dot_shapes, [this](const std::uint32_t* number, int used) { draw_dots<dot, dot>(number, used); });
    draw_left(dot_shapes, shapes, [this](const std::uint32_t* number, int used) { draw_cells_of(number, used); });
    for (; dot_count > 0; --dot_count)
      draw_dot(dot_key[dot_count - 1], static_cast<std::uint32_t>(dot_place[dot_count - 1]));
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
