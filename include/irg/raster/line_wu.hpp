// SPDX-License-Identifier: MIT
// line_wu: an antialiased line of two cells per step of its longer axis, whose coverages add up to 255. In integers.
//
// Along its longer axis the line visits one column of cells after the other (rows, for steep lines). In the middle of
// column j it passes between the centres of the cells k and k + 1, at y = k + f, 0 <= f < 1, an exact fraction. 255 * y
// rounded to the nearest integer is 255 * k + c: cell k gets 255 - c, cell k + 1 gets c. That rounded value goes from
// column to column by a quotient and a remainder, so it never drifts.
#pragma once

#include <irg/core/coordinates.hpp>
#include <irg/math/floor_division.hpp>
#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/detail/snapped_line.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {

/// Receives cells with their coverage, 1 to 255, one call each.
template <class S>
concept CoveredCellSink = requires(S& sink, const cell c, std::uint8_t coverage) { sink(c, coverage); };

inline namespace IRG_ABI {

/// Calls sink(cell, coverage) for the cells of the line from the middle of a to the middle of b that lie in the window.
/// shape   in every column from a's to b's (row, from 45 degrees up) one cell or two neighbours, from a to b; the
///         coverages of a column add up to 255, cells of coverage 0 are left out; both end cells are covered whole
/// gives   no call when the line misses the window or the window is empty; the one cell of a zero-length line
/// exact   for all int coordinates: the coverage of the upper neighbour is 255 times the fraction, rounded to the
///         nearest integer, halves going where options.ties says; clipped cells are the unclipped line's
/// cost    up to five 128-bit divisions per line, then two additions and two comparisons per visible column
/// source  Wu 1991
template <CoveredCellSink Sink>
constexpr void line_wu(cell a, cell b, const cell_window& window, Sink&& sink, const line_options& options = {});

/// The same with ends between pixels: the line stops at a and b.
/// shape   a column that the line does not cross whole counts for the part that it does: its coverages add up to
///         255 * part, rounded
/// gives   no call for a zero-length line; options.ends is not read
/// exact   for all int coordinates; the line is taken in the middle of each column, also where it ends before that
template <CoveredCellSink Sink>
constexpr void line_wu(const subpixel& a, const subpixel& b, const cell_window& window, Sink&& sink,
                       const line_options& options = {});

/// Mixes the paint into the cells of line_wu, each as far as it is covered.
/// gives   false and nothing drawn when a coordinate is NaN or infinite
/// exact   a line that ends beyond snap_limit is cut there first, which moves it by at most 1/512 pixel on each axis
template <WritableRaster R, ScreenPosition P, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_wu(R& raster, const P& a, const P& b, const Paint& paint, const line_options& options = {});

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// A line in 1/256 cell, mirrored so that it rises along both axes; dv <= du, du > 0. Column j has its centre at
// 256 * j + 128. The part from u_first to u_last is drawn.
struct wu_frame {
  std::int64_t u, v, du, dv, u_first, u_last;
  bool steep, u_mirrored, v_mirrored;
  int tie;  // 0: an exact half goes to the lower cell, 1: to the upper one

  IRG_INLINE constexpr cell at(std::int64_t column, std::int64_t row) const noexcept {
    const auto along = static_cast<int>(u_mirrored ? -1 - column : column),
               aside = static_cast<int>(v_mirrored ? -1 - row : row);
    return steep ? cell{aside, along} : cell{along, aside};
  }
  // 255 * y in column j, rounded, is floor(numerator(j) / denominator()).
  IRG_INLINE constexpr int128 numerator(std::int64_t j) const noexcept {
    const int128 centre = int128{one_pixel} * j + half_pixel - u;
    return 510 * (int128{v - half_pixel} * du + centre * dv) + int128{one_pixel} * du - 1 + tie;
  }
  IRG_INLINE constexpr std::int64_t denominator() const noexcept { return 2 * one_pixel * du; }
  IRG_INLINE constexpr std::int64_t change() const noexcept { return 510 * one_pixel * dv; }
  // How much of column j is drawn, in 1/256.
  IRG_INLINE constexpr int part_of(std::int64_t j) const noexcept {
    const std::int64_t from = maximum(j * one_pixel, u_first), to = minimum((j + 1) * one_pixel, u_last);
    return static_cast<int>(maximum(to - from, std::int64_t{0}));
  }
};

// The frame of a line in 1/256 cell; `beyond_a` and `beyond_b` are drawn before and after it.
constexpr wu_frame wu_frame_of(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, line_ties ties,
                               int beyond_a, int beyond_b) noexcept {
  const std::int64_t dx = bx - ax, dy = by - ay, width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy;
  const bool steep = height >= width && height > 0, left = dx < 0, up = dy < 0;
  wu_frame f{};
  f.steep = steep, f.u_mirrored = steep ? up : left, f.v_mirrored = steep ? left : up;
  const std::int64_t u = steep ? ay : ax, v = steep ? ax : ay;
  f.u = f.u_mirrored ? -u : u, f.v = f.v_mirrored ? -v : v;
  f.u_first = f.u - beyond_a, f.u_last = f.u + (steep ? height : width) + beyond_b;
  f.du = maximum(steep ? height : width, std::int64_t{1}), f.dv = steep ? width : height;
  f.tie = ties == line_ties::symmetric && f.u_mirrored && f.dv > 0 ? 1 : 0;
  return f;
}

// The first column whose rounded value is at least p, kept within [columns.first, columns.last].
constexpr std::int64_t wu_first_at(const wu_frame& f, std::int64_t p, const step_range& columns) noexcept {
  const int128 missing = int128{p} * f.denominator() - f.numerator(0);
  if (f.dv == 0) return missing > 0 ? columns.last : columns.first;
  const int128 j = ceil_div(missing, int128{f.change()});
  return j < columns.first ? columns.first : j > columns.last ? columns.last : static_cast<std::int64_t>(j);
}

// The columns whose cells may lie in the window.
constexpr step_range wu_visible(const wu_frame& f, const cell_window& w) noexcept {
  const step_range x{w.x_first, w.x_last}, y{w.y_first, w.y_last};
  const step_range along = f.steep ? y : x, aside = f.steep ? x : y;
  const step_range u = turned(along.first, along.last, f.u_mirrored), v = turned(aside.first, aside.last, f.v_mirrored);
  step_range columns{maximum(u.first, f.u_first >> subpixel_bits),
                     minimum(u.last, (f.u_last + one_pixel - 1) >> subpixel_bits)};
  if (columns.first >= columns.last) return {0, 0};
  const std::int64_t last = wu_first_at(f, 255 * v.last, columns);
  return {wu_first_at(f, 255 * (v.first - 1) + 1, columns), last};
}

template <class Sink>
constexpr void wu_walk(const wu_frame& f, const cell_window& w, Sink& sink) {
  if (w.empty() || f.u_first >= f.u_last) return;
  const step_range columns = wu_visible(f, w);
  if (columns.first >= columns.last) return;
  const auto put = [&](std::int64_t column, std::int64_t row, int coverage) {
    const cell c = f.at(column, row);
    const int aside = f.steep ? c.x : c.y;
    if (coverage > 0 && aside >= (f.steep ? w.x_first : w.y_first) && aside < (f.steep ? w.x_last : w.y_last))
      sink(c, static_cast<std::uint8_t>(coverage));
  };
  const std::int64_t d = f.denominator(), quotient = f.change() / d, rest = f.change() % d;
  const int128 numerator = f.numerator(columns.first), value = floor_div(numerator, int128{d});
  auto remainder = static_cast<std::int64_t>(numerator - value * d),
       row = static_cast<std::int64_t>(floor_div(value, int128{255}));
  auto c = static_cast<int>(value - int128{255} * row);
  for (std::int64_t j = columns.first; j < columns.last; ++j) {
    const int part = f.part_of(j), both = (255 * part + half_pixel) >> subpixel_bits,
              upper = (c * part + half_pixel) >> subpixel_bits;
    put(j, row, both - upper);
    put(j, row + 1, upper);
    c += static_cast<int>(quotient);
    remainder += rest;
    if (remainder >= d) {
      remainder -= d;
      ++c;
    }
    if (c >= 255) {
      c -= 255;
      ++row;
    }
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <CoveredCellSink Sink>
constexpr void line_wu(cell a, cell b, const cell_window& window, Sink&& sink, const line_options& options) {
  const auto centre = [](int v) { return std::int64_t{v} * one_pixel + half_pixel; };
  const int beyond_b = options.ends == line_ends::closed ? half_pixel : -half_pixel;
  detail::wu_walk(
      detail::wu_frame_of(centre(a.x), centre(a.y), centre(b.x), centre(b.y), options.ties, half_pixel, beyond_b),
      window, sink);
}

template <CoveredCellSink Sink>
constexpr void line_wu(const subpixel& a, const subpixel& b, const cell_window& window, Sink&& sink,
                       const line_options& options) {
  detail::wu_walk(detail::wu_frame_of(a.x, a.y, b.x, b.y, options.ties, 0, 0), window, sink);
}

template <WritableRaster R, ScreenPosition P, CoveragePaintFor<R> Paint>
constexpr bool draw_line_wu(R& raster, const P& a, const P& b, const Paint& paint, const line_options& options) {
  const auto mix_in = [&](cell c, std::uint8_t coverage) { paint_pixel(raster, c.x, c.y, paint, coverage); };
  if constexpr (std::same_as<P, cell> || CellPosition<P>) {
    line_wu(as_cell(a), as_cell(b), window_of(raster), mix_in, options);
  } else if constexpr (std::same_as<P, subpixel>) {
    line_wu(a, b, window_of(raster), mix_in, options);
  } else {
    const auto [finite, in_reach, from, to] = detail::snap_line(a, b);
    if (!finite) return false;
    if (in_reach) line_wu(from, to, window_of(raster), mix_in, options);
  }
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg
