// SPDX-License-Identifier: MIT
// circle_midpoint: the cells of a circle, each once; circle_spans: the cells of a disc. Whole centre and radius.
//
// In the octant around an axis the circle has one cell per step k across that axis, at the height m nearest to
// sqrt(r^2 - k^2): m * (m - 1) < r^2 - k^2 <= m * (m + 1). There are no ties, because (m + 1/2)^2 is no integer. The
// octant ends with the last k <= m. So every cell can be named without walking to it.
#pragma once

#include <irg/raster/detail/conic_arc.hpp>
#include <irg/raster/fill_span.hpp>

namespace irg::detail::inline IRG_ABI {

struct circle_shape {
  std::int64_t r;

  constexpr std::int64_t excess(std::int64_t k, std::int64_t m) const noexcept {
    return r * r - k * k - m * (m - 1) - 1;
  }
  constexpr std::int64_t step() const noexcept { return 1; }
  constexpr std::int64_t drop() const noexcept { return 2; }
  constexpr std::int64_t height(std::int64_t k) const noexcept {
    const std::int64_t square = r * r - k * k, root = floor_sqrt(square);
    return square > root * root + root ? root + 1 : root;
  }
  constexpr std::int64_t reach(std::int64_t m) const noexcept {
    return m <= 0 ? r + 1 : m > r ? 0 : floor_sqrt(r * r - m * (m - 1) - 1) + 1;
  }
  // One past the last k of an octant.
  constexpr std::int64_t octant_end() const noexcept {
    const std::int64_t k = floor_sqrt(r * r / 2);
    return k + 1 <= r && height(k + 1) == k + 1 ? k + 2 : k + 1;
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// Calls sink(cell) for the cells of the circle around a cell that lie in the window, each once, in no stated order.
/// shape   8-connected, symmetric in x, in y and in x = y; where |x| <= |y| one cell per column, the nearest to the
///         true circle, elsewhere one per row
/// gives   no call for a negative radius, the centre's cell for radius 0
/// exact   for all int centres and radii; clipped cells are the unclipped circle's
/// cost    one addition per visible cell and at most five square roots for each of eight octants, whatever the radius
/// source  Bresenham 1977; the midpoint form after Pitteway 1967 and Van Aken 1984
template <CellSink Sink>
constexpr void circle_midpoint(const cell& centre, int radius, const cell_window& window, Sink&& sink) {
  if (window.empty() || radius < 0) return;
  const detail::circle_shape circle{radius};
  const std::int64_t end = circle.octant_end();
  // The cells on the diagonals belong to the octants that run along x; a circle of one cell has these only.
  const std::int64_t upright_end = circle.height(end - 1) == end - 1 ? end - 1 : end;
  for (const bool upright : {false, true})
    detail::for_mirrored_arcs(centre, upright, [&](const detail::conic_arc& arc) {
      detail::emit_arc(arc, circle, upright ? upright_end : end, window, sink);
    });
}

/// Calls sink(span) for the rows in the window of the disc around a cell, from top to bottom.
/// shape   the cells with x^2 + y^2 <= radius^2, counted from the centre
/// gives   no call for a negative radius, the centre's cell for radius 0
/// exact   for all int centres and radii
/// cost    one square root per visible row
template <SpanSink Sink>
constexpr void circle_spans(const cell& centre, int radius, const cell_window& window, Sink&& sink) {
  if (radius < 0) return;
  const std::int64_t r = radius;
  detail::symmetric_spans(centre, r, window, sink,
                          [r](std::int64_t dy) { return detail::floor_sqrt(r * r - dy * dy); });
}

/// Paints the pixels of the circle, each once.
/// exact   the cells of circle_midpoint
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_circle(R& raster, const cell& centre, int radius, const Paint& paint) {
  circle_midpoint(centre, radius, window_of(raster), [&](const cell& c) { paint_pixel(raster, c.x, c.y, paint); });
}

/// Paints the pixels of the disc, each once.
/// exact   the spans of circle_spans
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void fill_circle(R& raster, const cell& centre, int radius, const Paint& paint) {
  circle_spans(centre, radius, window_of(raster), [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

}  // namespace irg::inline IRG_ABI
