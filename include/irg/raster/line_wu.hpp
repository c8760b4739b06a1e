// SPDX-License-Identifier: MIT
// line_wu: an antialiased line of two cells per step of its longer axis, whose coverages add up to 255. In integers.
//
// Along its longer axis the line visits one column of cells after the other (rows, for steep lines). In the middle of
// column j it passes between the centres of the cells k and k + 1, at y = k + f, 0 <= f < 1, an exact fraction. 255 * y
// rounded to the nearest integer is 255 * k + c: cell k gets 255 - c, cell k + 1 gets c. That rounded value goes from
// column to column by a quotient and a remainder, so it never drifts.
#pragma once

#include <irg/core/coordinates.hpp>
#include <irg/raster/detail/floor_division.hpp>
#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/detail/line_wu_steps.hpp>
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
constexpr void line_wu(cell a, cell b, const cell_window& window, Sink&& sink, const line_options& options = {}) {
  const auto centre = [](int v) { return std::int64_t{v} * one_pixel + half_pixel; };
  const int beyond_b = options.ends == line_ends::closed ? half_pixel : -half_pixel;
  detail::wu_walk(
      detail::wu_frame_of(centre(a.x), centre(a.y), centre(b.x), centre(b.y), options.ties, half_pixel, beyond_b),
      window, sink);
}

/// The same with ends between pixels: the line stops at a and b.
/// shape   a column that the line does not cross whole counts for the part that it does: its coverages add up to
///         255 * part, rounded
/// gives   no call for a zero-length line; options.ends is not read
/// exact   for all int coordinates; the line is taken in the middle of each column, also where it ends before that
template <CoveredCellSink Sink>
constexpr void line_wu(const subpixel& a, const subpixel& b, const cell_window& window, Sink&& sink,
                       const line_options& options = {}) {
  detail::wu_walk(detail::wu_frame_of(a.x, a.y, b.x, b.y, options.ties, 0, 0), window, sink);
}

/// Mixes the paint into the cells of line_wu, each as far as it is covered.
/// gives   false and nothing drawn when a coordinate is NaN or infinite
/// exact   a line that ends beyond snap_limit is cut there first, which moves it by at most 1/512 pixel on each axis
template <WritableRaster R, ScreenPosition P, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_wu(R& raster, const P& a, const P& b, const Paint& paint, const line_options& options = {}) {
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
