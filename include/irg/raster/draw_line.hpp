// SPDX-License-Identifier: MIT
// draw_line: the pixels of a straight line, written to a raster.
#pragma once

#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/paint.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Paints the pixels of the line from a to b that lie in the window.
/// exact   the cells of line_bresenham with the same options
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_line(R& raster, cell a, cell b, const Paint& paint, const cell_window& window,
                         const line_options& options = {}) {
  line_bresenham(
      a, b, intersect(window, window_of(raster)), [&](cell c) { paint_pixel(raster, c.x, c.y, paint); }, options);
}

/// Paints the pixels of the line from a to b.
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_line(R& raster, cell a, cell b, const Paint& paint, const line_options& options = {}) {
  draw_line(raster, a, b, paint, window_of(raster), options);
}

}  // namespace IRG_ABI
}  // namespace irg
