// SPDX-License-Identifier: MIT
// The lecture's fill of a convex polygon, in its own words: in each row L is the greatest crossing with a left edge, D
// the least with a right edge, and the cells from L to D, points of the integer grid, are drawn. What the lecture
// leaves open, which cells L and D themselves bring, is sample_rule. Every row asks every edge: irg::fill_convex is
// for drawing.
#pragma once

#include <cstdint>

#include <irg/core/ring.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/textbook/sample_rule.hpp>

namespace irg::textbook {

/// A ring whose vertices are cells, or positions in 1/256 of a cell.
template <class R>
concept LatticeRing = PolygonRing<R> && (std::same_as<ring_point<R>, cell> || std::same_as<ring_point<R>, subpixel>);

inline namespace IRG_ABI {

/// Calls sink(span) for every row of the convex polygon's cells that lie in the window, by rising y.
/// needs   a convex ring, either way round, of any vertices of the type; of one that is not convex the common part of
///         its edges' half-planes comes out, within its extents
/// gives   no call for an empty ring. Rings without area: a level segment has the row from x_min to x_max (not with
///         half_open), another segment and a point only what `closed` finds on them
/// exact   crossings are compared and rounded as fractions
/// cost    one pass over the edges per row of the polygon in the window, in 128-bit arithmetic
/// source  Mihajlovic 2016, 3.4: L is the maximum over left edges (y_i < y_i+1 when clockwise, y up), D the minimum
///         over right edges, edges taken as endless lines, horizontal ones skipped
template <LatticeRing Ring, SpanSink Sink>
constexpr void convex_spans(const Ring& ring, sample_rule rule, const cell_window& window, Sink&& sink) {
  const std::size_t n = ring_size(ring);
  if (n == 0 || window.empty()) return;
  const auto at = [&](std::size_t i) {  // in 1/256
    const auto p = ring_vertex(ring, i);
    const std::int64_t unit = std::same_as<ring_point<Ring>, cell> ? one_pixel : 1;
    return point<std::int64_t, 2>{p.x * unit, p.y * unit};
  };
  std::int64_t x_min = at(0).x, x_max = x_min, y_min = at(0).y, y_max = y_min;
  int128 double_area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = at(i), q = at(i + 1);
    x_min = minimum(x_min, p.x);
    x_max = maximum(x_max, p.x);
    y_min = minimum(y_min, p.y);
    y_max = maximum(y_max, p.y);
    double_area += int128{p.x} * q.y - int128{q.x} * p.y;
  }
  const std::int64_t unit = one_pixel, up_to = rule == sample_rule::half_open ? y_max - 1 : y_max;
  const std::int64_t y_last = minimum<std::int64_t>(floor_div(up_to, unit) + 1, window.y_last);
  for (std::int64_t y = maximum<std::int64_t>(ceil_div(y_min, unit), window.y_first); y < y_last; ++y) {
    row_crossing l{x_min, 1}, d{x_max, 1};
    for (std::size_t i = 0; i < n; ++i) {
      const auto p = at(i), q = at(i + 1);
      const std::int64_t a = p.y - q.y, b = q.x - p.x;  // a x + b y + c = 0
      if (a == 0) continue;
      const int128 c = int128{p.x} * q.y - int128{q.x} * p.y, along = -int128{b} * (y * unit) - c;
      const row_crossing x = a > 0 ? row_crossing{along, a} : row_crossing{-along, -a};
      if ((a < 0) == (double_area <= 0))  // rises, and the polygon runs clockwise, y up; or neither
        l = maximum(l, x);
      else
        d = minimum(d, x);
    }
    const row_cells row = cells_of_row(l, d, rule);
    const std::int64_t first = maximum<std::int64_t>(row.first, window.x_first);
    const std::int64_t last = minimum<std::int64_t>(row.last, window.x_last);
    if (first < last) sink(span_of_cells{static_cast<int>(y), static_cast<int>(first), static_cast<int>(last)});
  }
}

/// Paints the cells of convex_spans; row y of the raster is y of the polygon.
template <WritableRaster R, LatticeRing Ring, PaintFor<R> Paint = pixel_of<R>>
constexpr void fill_convex(R& raster, const Ring& ring, sample_rule rule, const Paint& paint) {
  convex_spans(ring, rule, window_of(raster), [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
