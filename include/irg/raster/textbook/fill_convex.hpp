// SPDX-License-Identifier: MIT
// The lecture's fill of a convex polygon, in its own words: each edge is a left or a right one; in each row L is the
// greatest crossing with a left edge, D the least with a right edge, and the cells from L to D are drawn. Cells are the
// points of the integer grid. What the lecture leaves open, which cells L and D themselves bring, is sample_rule.
//
// It is meant for reading and for comparison: every row asks every edge. fill_convex is the one for drawing.
#pragma once

#include <cstdint>

#include <irg/core/ring.hpp>
#include <irg/math/floor_division.hpp>
#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::textbook {

/// Which cells a row from L to D has; L and D are rarely integers.
enum class sample_rule {
  course,  // the rule of lectures: ceil(L) to floor(D), drawn if L < D: a row that is one point is left out
  closed,  // ceil(L) to floor(D), drawn if L <= D: all cells inside and on the boundary
  rounded,  // both ends rounded to the nearest integer, halves up, drawn if L < D
  half_open,  // L <= x < D in the rows y_min <= y < y_max: polygons side by side share no cell and leave none out
};

/// A ring whose vertices are cells, or positions in 1/256 of a cell.
template <class R>
concept LatticeRing = PolygonRing<R> && (std::same_as<ring_point<R>, cell> || std::same_as<ring_point<R>, subpixel>);

}  // namespace irg::textbook

namespace irg::detail::inline IRG_ABI {

// Where a row crosses an edge, n / d in 1/256, d > 0: 82 and 41 bits at most.
struct textbook_crossing {
  int128 n;
  std::int64_t d;
  friend constexpr bool operator<(const textbook_crossing& p, const textbook_crossing& q) noexcept {
    return p.n * q.d < q.n * p.d;
  }
};

// The cells [first, last) of a row from L to D.
struct textbook_run {
  std::int64_t first = 0, last = 0;
};
constexpr textbook_run textbook_cells(const textbook_crossing& l, const textbook_crossing& d,
                                      textbook::sample_rule rule) noexcept {
  const int128 l_unit = int128{l.d} * one_pixel, d_unit = int128{d.d} * one_pixel;
  const bool rounded = rule == textbook::sample_rule::rounded;
  if (rule == textbook::sample_rule::closed ? d < l : !(l < d)) return {};
  const int128 first = rounded ? floor_div(2 * l.n + l_unit, 2 * l_unit) : ceil_div(l.n, l_unit);
  const int128 last = rounded                                    ? floor_div(2 * d.n + d_unit, 2 * d_unit) + 1
                      : rule == textbook::sample_rule::half_open ? ceil_div(d.n, d_unit)
                                                                 : floor_div(d.n, d_unit) + 1;
  return {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook::inline IRG_ABI {

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
  struct vertex {
    std::int64_t x, y;  // in 1/256
  };
  const auto at = [&](std::size_t i) {
    const auto p = ring_vertex(ring, i);
    const std::int64_t unit = std::same_as<ring_point<Ring>, cell> ? one_pixel : 1;
    return vertex{p.x * unit, p.y * unit};
  };
  std::int64_t x_min = at(0).x, x_max = x_min, y_min = at(0).y, y_max = y_min;
  int128 double_area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const vertex p = at(i), q = at(i + 1);
    x_min = lesser(x_min, p.x), x_max = greater(x_max, p.x);
    y_min = lesser(y_min, p.y), y_max = greater(y_max, p.y);
    double_area += int128{p.x} * q.y - int128{q.x} * p.y;
  }
  const std::int64_t unit = one_pixel, up_to = rule == sample_rule::half_open ? y_max - 1 : y_max;
  const std::int64_t y_first = greater<std::int64_t>(ceil_div(y_min, unit), window.y_first);
  const std::int64_t y_last = lesser<std::int64_t>(floor_div(up_to, unit) + 1, window.y_last);
  for (std::int64_t y = y_first; y < y_last; ++y) {
    detail::textbook_crossing l{x_min, 1}, d{x_max, 1};
    for (std::size_t i = 0; i < n; ++i) {
      const vertex p = at(i), q = at(i + 1);
      const std::int64_t a = p.y - q.y, b = q.x - p.x;  // a x + b y + c = 0
      if (a == 0) continue;
      const int128 c = int128{p.x} * q.y - int128{q.x} * p.y, along = -int128{b} * (y * unit) - c;
      const detail::textbook_crossing x =
          a > 0 ? detail::textbook_crossing{along, a} : detail::textbook_crossing{-along, -a};
      if ((a < 0) == (double_area <= 0))  // rises, and the polygon runs clockwise, y up; or neither
        l = greater(l, x);
      else
        d = lesser(d, x);
    }
    const detail::textbook_run run = detail::textbook_cells(l, d, rule);
    const std::int64_t first = greater<std::int64_t>(run.first, window.x_first);
    const std::int64_t last = lesser<std::int64_t>(run.last, window.x_last);
    if (first < last) sink(span_of_cells{static_cast<int>(y), static_cast<int>(first), static_cast<int>(last)});
  }
}

/// Paints the convex polygon's cells; row y of the raster is y of the polygon.
/// needs   as convex_spans
/// gives   as convex_spans
/// exact   as convex_spans
/// cost    as convex_spans
template <WritableRaster R, LatticeRing Ring, PaintFor<R> Paint = pixel_of<R>>
constexpr void fill_convex(R& raster, const Ring& ring, sample_rule rule, const Paint& paint) {
  convex_spans(ring, rule, window_of(raster), [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

}  // namespace irg::textbook::inline IRG_ABI
