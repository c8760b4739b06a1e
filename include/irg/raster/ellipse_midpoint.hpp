// SPDX-License-Identifier: MIT
// ellipse_midpoint: the cells of an ellipse with axes along x and y, each once; ellipse_spans: the cells inside. Whole
// centre and radii.
//
// Seen from the centre, a quarter of the ellipse is flatter than 45 degrees up to x_t = a^2 / sqrt(a^2 + b^2) and
// steeper below y_t = b^2 / sqrt(a^2 + b^2). Every column k <= x_t has the cell at the height m nearest to the ellipse,
// (2m - 1)^2 a^2 < 4 b^2 (a^2 - k^2) < (2m + 1)^2 a^2, and every row up to y_t likewise. The middle one is never an
// equality: with a^2 = k^2 + z^2 the reduced fraction z / a has an odd denominator, so b * z / a is not half-way
// between integers. Where the two arcs meet, the cell diagonally beyond both is added when it is the nearest one of its
// column or of its row; without it some ellipses would have a hole there.
#pragma once

#include <irg/raster/detail/conic_arc.hpp>
#include <irg/raster/detail/ellipse_midpoint_steps.hpp>
#include <irg/raster/fill_span.hpp>

namespace irg {

inline namespace IRG_ABI {

/// Calls sink(cell) for the cells of the ellipse around a cell that lie in the window, each once, in no stated order.
/// shape   8-connected, symmetric in x and in y; one cell per column, the nearest to the true ellipse, where that is
///         flatter than 45 degrees, elsewhere one per row; equal radii give circle_midpoint
/// gives   no call when a radius is negative; a line when one is 0, the centre's cell when both are
/// exact   for all int centres and radii; clipped cells are the unclipped ellipse's
/// cost    two additions and a product per visible cell, at most four square roots and divisions for each of eight
///         arcs, whatever the radii; in 128 bits when a radius is 32768 or more
/// source  Pitteway 1967 and Van Aken 1984 for the midpoint test
template <CellSink Sink>
constexpr void ellipse_midpoint(const cell& centre, int radius_x, int radius_y, const cell_window& window,
                                Sink&& sink) {
  if (window.empty() || radius_x < 0 || radius_y < 0) return;
  if (radius_x == 0 || radius_y == 0)
    detail::flat_ellipse_spans(centre, radius_x, radius_y, window, [&](const span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x) sink(cell{x, s.y});
    });
  else if (detail::is_small_ellipse(radius_x, radius_y))
    detail::ellipse_outline<std::int64_t>(centre, radius_x, radius_y, window, sink);
  else
    detail::ellipse_outline<int128>(centre, radius_x, radius_y, window, sink);
}

/// Calls sink(span) for the rows in the window of the filled ellipse around a cell, from top to bottom.
/// shape   the cells with (x / radius_x)^2 + (y / radius_y)^2 <= 1, counted from the centre
/// gives   no call when a radius is negative; a line when one is 0, the centre's cell when both are
/// exact   for all int centres and radii
/// cost    one square root and one division per visible row, in 128 bits when a radius is 32768 or more
template <SpanSink Sink>
constexpr void ellipse_spans(const cell& centre, int radius_x, int radius_y, const cell_window& window, Sink&& sink) {
  if (radius_x < 0 || radius_y < 0) return;
  if (radius_x == 0 || radius_y == 0)
    detail::flat_ellipse_spans(centre, radius_x, radius_y, window, sink);
  else if (detail::is_small_ellipse(radius_x, radius_y))
    detail::full_ellipse_spans<std::int64_t>(centre, radius_x, radius_y, window, sink);
  else
    detail::full_ellipse_spans<int128>(centre, radius_x, radius_y, window, sink);
}

/// Paints the pixels of the ellipse, each once.
/// exact   the cells of ellipse_midpoint
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_ellipse(R& raster, const cell& centre, int radius_x, int radius_y, const Paint& paint) {
  ellipse_midpoint(centre, radius_x, radius_y, window_of(raster),
                   [&](const cell& c) { paint_pixel(raster, c.x, c.y, paint); });
}

/// Paints the pixels of the filled ellipse, each once.
/// exact   the spans of ellipse_spans
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void fill_ellipse(R& raster, const cell& centre, int radius_x, int radius_y, const Paint& paint) {
  ellipse_spans(centre, radius_x, radius_y, window_of(raster),
                [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

}  // namespace IRG_ABI
}  // namespace irg
