// SPDX-License-Identifier: MIT
// draw_line: the pixels of a straight line, written to a raster.
//
// line_bresenham says which cells they are. Where rows of pixels lie in memory at one distance the kernel writes the
// same cells without asking for each; a level line is one run of pixels.
#pragma once

#include <irg/raster/subpixel.hpp>
#include <irg/raster/detail/line_kernel.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/paint.hpp>

namespace irg::inline IRG_ABI {

/// Paints the pixels of the line from a to b, in the order from a to b.
/// gives   nothing when the line misses the raster's window; a function paint is called once per pixel
/// exact   for all int coordinates the cells of line_bresenham with the same options
/// cost    one division per line that lies in the raster, at most five otherwise, and one store per visible pixel
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_line(R& raster, cell a, cell b, const Paint& paint, const line_options& options = {}) {
  const cell_window visible = window_of(raster);
  if constexpr (RowRaster<R> && !BlendFunction<Paint, R>) {
    if (a.y == b.y)
      return detail::draw_level_line(raster, a, b, visible, options.ends, static_cast<pixel_of<R>>(paint));
  }
  if constexpr (EvenRowRaster<R>) {
    if (!std::is_constant_evaluated()) {
      if constexpr (BlendFunction<Paint, R>) {
        detail::walk_line_in(raster, a, b, visible, options, [&](pixel_of<R>* p) {
          *p = static_cast<pixel_of<R>>(paint(static_cast<const pixel_of<R>&>(*p)));
        });
      } else {
        const auto value = static_cast<pixel_of<R>>(paint);
        detail::walk_line_in(raster, a, b, visible, options, [value](pixel_of<R>* p) { *p = value; });
      }
      return;
    }
  }
  line_bresenham(a, b, visible, [&](cell c) { paint_pixel(raster, c.x, c.y, paint); }, options);
}

/// The same between positions of another type.
template <WritableRaster R, CellPosition P, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_line(R& raster, const P& a, const P& b, const Paint& paint, const line_options& options = {}) {
  draw_line(raster, as_cell(a), as_cell(b), paint, options);
}

}  // namespace irg::inline IRG_ABI
