// SPDX-License-Identifier: MIT
// The area of a convex polygon within each pixel of a row.
//
// A side of the polygon is a chain of edges that runs down. What it leaves uncovered in column x of a row is, for each
// edge, the integral of E(y) - x, clamped to [0, 1], over the part of the row it crosses; the coverage is the height of
// the polygon in the row less what both sides leave uncovered. The right side is walked in a mirror, its column x being
// -1 - x, so that both sides are one piece of code and a mirrored polygon gives the mirrored bits.
//
// Where edges cross the bounds of rows is kept in 24.40 fixed point, as a function of the edge and the row alone; so no
// window changes a pixel. The error is below 2^-40 of a pixel per row, 2^-18 for the longest edge. In a row, an edge's
// leftmost point and its reach are cut to multiples of 2^-20.
// Areas are floats, within 2^-18, of doubles where an edge passes over many columns of a row; each is a function of the
// row's edges on its side and of the column alone.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/conversion.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/detail/snapped_ring.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail {

// Areas are rounded to the nearest of 255 parts. What lies half-way goes up, and so does what lies so little below it
// that the computation's error could have put it there; thus equal areas that are computed in two ways round alike.
inline constexpr float area_rounding = 0.5f + 0x1p-10f;

inline constexpr std::int64_t area_one = std::int64_t{1} << 40;  // one column in fixed point

// Floats hold the columns of edges that reach over this many of a row to 2^-18. Longer reaches are computed in doubles.
inline constexpr std::int64_t area_float_reach = 64 * area_one;

// An edge in a row, or the part of one: where it is leftmost, how far it reaches from there, how high it is. The
// columns are whole numbers.
struct area_piece {
  float first;  // the column of its leftmost point
  float span;  // how many columns on it leaves nothing uncovered
  float rest;  // its leftmost point within the column
  float width, height;
  float scale;  // height / (2 * width)
  double wide;  // its width
};

inline namespace IRG_ABI {

// Where a snapped coordinate is.
IRG_INLINE constexpr std::int64_t area_position(std::int32_t x) noexcept { return std::int64_t{x} << 32; }
// The column of a position, and the position within it.
IRG_INLINE constexpr int area_column(std::int64_t position) noexcept { return static_cast<int>(position >> 40); }
IRG_INLINE constexpr std::int32_t area_rest(std::int64_t position) noexcept {  // in 2^-20
  return static_cast<std::int32_t>((position >> 20) & 0xfffff);
}
IRG_INLINE constexpr float area_fraction(std::int32_t rest) noexcept { return static_cast<float>(rest) * 0x1p-20f; }
// Cut to a multiple of 2^-20.
IRG_INLINE constexpr std::int64_t area_cut(std::int64_t position) noexcept { return position >> 20 << 20; }
// The same, rounded up.
IRG_INLINE constexpr int area_column_up(std::int64_t position) noexcept {
  return area_column(position + (area_one - 1));
}

// What an edge that reaches from `rest` to `rest + width`, seen from column 0, leaves uncovered in the columns given.
// With t(x) the part of its reach that lies right of x, that is scale * (t(x)^2 - t(x + 1)^2), and in columns left of
// its reach the height. From the column `span` on it is 0 without any rounding; where columns and width are below 8
// that
// needs no care, for left and right are exact then.
template <class F>
IRG_INLINE constexpr F uncovered_near(const F& column, const F& rest, const F& width, const F& scale, const F& height,
                                      const typename lanes<F>::mask* reached = nullptr) {
  const F zero = lanes<F>::broadcast(0), one = lanes<F>::broadcast(1);
  const F left = rest - column, right = left + width;
  const F t0 = minimum(maximum(right, zero), width), t1 = minimum(maximum(right - one, zero), width);
  const F reach = product(product(t0 - t1, t0 + t1), scale);
  return (reached == nullptr ? reach : select(*reached, reach, zero)) +
         product(minimum(maximum(left, zero), one), height);
}
template <class F>
IRG_INLINE constexpr F uncovered_by(const F& column, const F& span, const F& rest, const F& width, const F& scale,
                                    const F& height) {
  const typename lanes<F>::mask reached = column < span;
  return uncovered_near(column, rest, width, scale, height, &reached);
}

// One edge that crosses a row from top to bottom.
template <class F>
struct whole_edge_row {
  int first, end;
  F rest, width, scale;

  // What it leaves uncovered in column + ramp.
  IRG_INLINE constexpr F uncovered(int column, const F& ramp) const noexcept {
    const auto all = [](float x) { return lanes<F>::broadcast(x); };
    return uncovered_by(all(static_cast<float>(column - first)) + ramp, all(static_cast<float>(end - first)), rest,
                        width, scale, all(1));
  }
};

// Several edges in a row. A convex chain has no more than 256: their ends are on different multiples of 1/256.
struct edge_pieces_row {
  static constexpr int most = 256;
  area_piece piece[most];
  int count = 0;
  int first = 0, end = 0;
  bool is_wide = false;

  IRG_INLINE constexpr void clear() noexcept { count = 0, is_wide = false; }
  IRG_INLINE constexpr void add(std::int64_t a, std::int64_t b, std::int32_t height, float scale) noexcept {
    const std::int64_t low = a < b ? a : b, reach = area_cut(a < b ? b - a : a - b);
    const int from = area_column(low), to = area_column_up(area_cut(low) + reach);
    area_piece& p = piece[count];
    p.first = static_cast<float>(from);
    p.span = static_cast<float>(to - from);
    p.rest = area_fraction(area_rest(low));
    p.width = static_cast<float>(reach) * 0x1p-40f;
    p.wide = static_cast<double>(reach) * 0x1p-40;
    is_wide = is_wide || reach > area_float_reach;
    p.height = static_cast<float>(height) * 0x1p-8f;
    p.scale = scale;
    first = count == 0 ? from : minimum(first, from);
    end = count == 0 ? to : maximum(end, to);
    ++count;
  }

  template <class F>
  IRG_INLINE constexpr F uncovered(int column, const F& ramp) const noexcept {
    if (is_wide) [[unlikely]]
      return uncovered_wide(column, ramp);
    const auto all = [](float x) { return lanes<F>::broadcast(x); };
    const auto by = [&](const area_piece& p, const F& columns) {
      return uncovered_by(columns - all(p.first), all(p.span), all(p.rest), all(p.width), all(p.scale), all(p.height));
    };
    const F columns = all(static_cast<float>(column)) + ramp;
    F sum = by(piece[0], columns);
    for (int i = 1; i < count; ++i) sum = sum + by(piece[i], columns);
    return sum;
  }
  template <class F>
  IRG_NOINLINE constexpr F uncovered_wide(int column, const F& ramp) const noexcept {
    float each[static_cast<unsigned>(lanes<F>::count)] = {};
    lanes<F>::store(each, ramp);
    for (float& x : each) {
      const double at = column + static_cast<double>(x);
      double sum = 0;
      for (int i = 0; i < count; ++i) {
        const area_piece& p = piece[i];
        sum +=
            uncovered_near<double>(at - widened(p.first), widened(p.rest), p.wide, widened(p.scale), widened(p.height));
      }
      x = converted<float>(sum);
    }
    return lanes<F>::load(each);
  }
};

// An edge that runs down, as a function of the row.
struct area_edge {
  int row_first = 0, row_last = 0;  // the rows that it crosses from top to bottom
  std::int64_t position = 0, advance = 0;  // where it enters row_first; its way from row to row
  float scale = 0;  // height / (2 * width) of the edge and of all its parts

  IRG_INLINE constexpr area_edge() noexcept = default;
  // needs   a.y < b.y
  IRG_INLINE constexpr area_edge(const subpixel& a, const subpixel& b) noexcept
      : row_first((a.y + (one_pixel - 1)) >> subpixel_bits), row_last(b.y >> subpixel_bits) {
    const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    scale = dx == 0 ? 0.0f : converted<float>(0.5 * dy / (dx < 0 ? -dx : dx));
    if (row_first > row_last) return;
    const double slope = dx / dy;
    if (row_first < row_last) advance = static_cast<std::int64_t>(slope * 0x1p40);  // no more than 2^62 then
    const auto below = static_cast<double>(row_first * one_pixel - a.y);
    position = area_position(a.x) + static_cast<std::int64_t>(product(below, slope) * 0x1p32);
  }

  // Whether floats do for the rows that it crosses from top to bottom.
  IRG_INLINE constexpr bool suits_floats() const noexcept {
    return advance <= area_float_reach && -advance <= area_float_reach;
  }
  // Where it meets the upper bound of a row.
  IRG_INLINE constexpr std::int64_t enters(int row) const noexcept {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(position) +
                                     static_cast<std::uint64_t>(advance) *
                                         static_cast<std::uint64_t>(std::int64_t{row} - row_first));
  }
};

// One side of a ring, walked down: the present edge, from a to b.
// shape   Mirror is 1, or -1 for the right side; forward: the way round the ring
template <int Mirror, class Vertices>
struct area_side : area_edge {
  const Vertices& vertex;
  std::size_t n, i;
  bool forward;
  subpixel a, b;  // x mirrored

  IRG_INLINE constexpr area_side(const Vertices& v, std::size_t size, std::size_t top, bool goes_forward)
      : vertex(v), n(size), i(top), forward(goes_forward), a(at(top)), b(a) {}

  IRG_INLINE constexpr subpixel at(std::size_t k) const {
    const subpixel v = vertex(k);
    return {Mirror * v.x, v.y};
  }

  // Leads on to the first edge that ends below y.
  // needs   a vertex below y
  IRG_INLINE constexpr void lead_on(std::int32_t y) {
    do {
      a = b;
      i = next_vertex(i, n, forward);
      b = at(i);
    } while (b.y <= y);
    static_cast<area_edge&>(*this) = area_edge(a, b);
  }

  // The edges between the heights y and y_last of a row.
  IRG_INLINE constexpr void pieces(int row, std::int32_t y, std::int32_t y_last, edge_pieces_row& out) {
    const std::int32_t upper = row * one_pixel, lower = upper + one_pixel;
    out.clear();
    while (y < y_last) {
      if (b.y <= y) lead_on(y);
      const std::int32_t stop = minimum(b.y, y_last);
      out.add(y == upper ? enters(row) : area_position(a.x), stop == lower ? enters(row + 1) : area_position(b.x),
              stop - y, scale);
      y = stop;
    }
  }
};

// The whole rows of one edge, one after the other.
template <class F>
struct whole_edge_rows {
  std::int64_t low, advance, reach;
  F width, scale;

  template <class Side>
  IRG_INLINE constexpr whole_edge_rows(const Side& side, int row) noexcept
      : low(side.enters(row) + (side.advance < 0 ? side.advance : 0)), advance(side.advance),
        reach(area_cut(side.advance < 0 ? -side.advance : side.advance)),
        width(lanes<F>::broadcast(static_cast<float>(reach) * 0x1p-40f)), scale(lanes<F>::broadcast(side.scale)) {}

  IRG_INLINE constexpr F rest() const noexcept { return lanes<F>::broadcast(area_fraction(area_rest(low))); }
  IRG_INLINE constexpr whole_edge_row<F> row() const noexcept {
    return {area_column(low), area_column_up(area_cut(low) + reach), rest(), width, scale};
  }
  IRG_INLINE constexpr void next() noexcept {
    low = static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + static_cast<std::uint64_t>(advance));
  }
};

// Coverages of 0 to 255 from areas of 0 to 1.
IRG_INLINE constexpr std::int32_t coverage_of_area(float area) noexcept {
  return static_cast<std::int32_t>(product(255.0f, maximum(area, 0.0f)) + area_rounding);
}
template <int N>
IRG_INLINE pack<std::int32_t, N> coverage_of_area(const pack<float, N>& area) noexcept {
  using F = pack<float, N>;
  const F zero = lanes<F>::broadcast(0);
  const F scaled = lanes<F>::broadcast(255) * maximum(area, zero) + lanes<F>::broadcast(area_rounding);
  return converted<std::int32_t>(scaled);
}

// Sends one row to the target: the columns between both sides, as far as the window holds them.
// needs   height: of the polygon in the row, at most 1
template <class F, class Target, class Left, class Right>
IRG_INLINE constexpr void area_row(Target& target, const Left& left, const Right& right, float height,
                                   const cell_window& w) {
  constexpr int count = lanes<F>::count;
  const int x_first = maximum(left.first, w.x_first), x_last = minimum(-right.first, w.x_last);
  if (x_first >= x_last) return;
  const F up = lanes<F>::ramp(), down = lanes<F>::broadcast(0) - up, full = lanes<F>::broadcast(height);
  if (height == 1 && x_last - x_first >= 2 * count) {
    const int left_partial = (clamped(left.end, x_first, x_last) - x_first + (count - 1)) & -count;
    const int right_partial = (x_last - clamped(-right.end, x_first, x_last) + (count - 1)) & -count;
    const int solid = x_last - x_first - left_partial - right_partial;
    if (solid >= count) {
      int x = x_first;
      for (; x < x_first + left_partial; x += count) target.mix_all(x, coverage_of_area(full - left.uncovered(x, up)));
      target.fill(x, solid);
      for (x += solid; x < x_last; x += count)
        target.mix_all(x, coverage_of_area(full - right.uncovered(-1 - x, down)));
      return;
    }
  }
  for (int x = x_first; x < x_last; x += count)
    target.mix_some(x, minimum(count, x_last - x),
                    coverage_of_area(full - (left.uncovered(x, up) + right.uncovered(-1 - x, down))));
}

}  // namespace IRG_ABI
}  // namespace irg::detail
