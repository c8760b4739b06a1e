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
#include <irg/raster/fill_span.hpp>

namespace irg::inline IRG_ABI {

/// Calls sink(cell) for the cells of the ellipse around a cell that lie in the window, each once, in no stated order.
/// shape   8-connected, symmetric in x and in y; one cell per column, the nearest to the true ellipse, where that is
///         flatter than 45 degrees, elsewhere one per row; equal radii give circle_midpoint
/// gives   no call when a radius is negative; a line when one is 0, the centre's cell when both are
/// exact   for all int centres and radii; clipped cells are the unclipped ellipse's
/// cost    two additions and a product per visible cell, at most four square roots and divisions for each of eight
///         arcs, whatever the radii; in 128 bits when a radius is 32768 or more
/// source  Pitteway 1967 and Van Aken 1984 for the midpoint test
template <CellSink Sink>
constexpr void ellipse_midpoint(const cell& centre, int radius_x, int radius_y, const cell_window& window, Sink&& sink);

/// Calls sink(span) for the rows in the window of the filled ellipse around a cell, from top to bottom.
/// shape   the cells with (x / radius_x)^2 + (y / radius_y)^2 <= 1, counted from the centre
/// gives   no call when a radius is negative; a line when one is 0, the centre's cell when both are
/// exact   for all int centres and radii
/// cost    one square root and one division per visible row, in 128 bits when a radius is 32768 or more
template <SpanSink Sink>
constexpr void ellipse_spans(const cell& centre, int radius_x, int radius_y, const cell_window& window, Sink&& sink);

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

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The ellipse with radius p along and q aside, both positive; J holds 4 * p^2 * q^2.
template <class J>
struct ellipse_radii {
  std::int64_t p, q;

  // 4 q^2 (p^2 - k^2) - (2m - 1)^2 p^2: positive when the ellipse at k is above m - 1/2.
  constexpr J excess(std::int64_t k, std::int64_t m) const noexcept {
    const J odd = 2 * m - 1, along = static_cast<J>(p) * p;
    return 4 * (static_cast<J>(q) * q) * (along - static_cast<J>(k) * k) - odd * odd * along;
  }
  constexpr J step() const noexcept { return 4 * (static_cast<J>(q) * q); }
  constexpr J drop() const noexcept { return 8 * (static_cast<J>(p) * p); }
  // The nearest height at k, 0 <= k <= p.
  constexpr std::int64_t height(std::int64_t k) const noexcept {
    const J along = static_cast<J>(p) * p;
    const std::int64_t m =
        floor_sqrt(static_cast<std::int64_t>(static_cast<J>(q) * q * (along - static_cast<J>(k) * k) / along));
    return excess(k, m + 1) > 0 ? m + 1 : m;
  }
  // How many k >= 0 have a height of m or more.
  constexpr std::int64_t reach(std::int64_t m) const noexcept {
    if (m <= 0 || m > q) return m <= 0 ? p + 1 : 0;
    return floor_sqrt(static_cast<std::int64_t>((excess(0, m) - 1) / step())) + 1;
  }
  // One past the last k of the flat part.
  constexpr std::int64_t flat_end() const noexcept {
    const J pp = static_cast<J>(p) * p, qq = static_cast<J>(q) * q;
    return floor_sqrt(static_cast<std::int64_t>(pp * pp / (pp + qq))) + 1;
  }
};

template <class J, CellSink Sink>
constexpr void ellipse_outline(const cell& centre, std::int64_t a, std::int64_t b, const cell_window& w, Sink&& sink) {
  const ellipse_radii<J> columns{a, b}, rows{b, a};
  const std::int64_t x = columns.flat_end(), y = rows.flat_end();  // the first ones that the arcs leave out
  const bool same_last_cell = columns.height(x - 1) == y - 1 && rows.height(y - 1) == x - 1;
  const bool corner = (x <= a && columns.height(x) == y) || (y <= b && rows.height(y) == x);
  for_mirrored_arcs(centre, false, [&](const conic_arc& arc) {
    emit_arc(arc, columns, x, w, sink);
    const step_range along = arc.along(w), aside = arc.aside(w);
    if (corner && x >= along.first && x < along.last && y >= aside.first && y < aside.last) sink(arc.at(x, y));
  });
  for_mirrored_arcs(centre, true,
                    [&](const conic_arc& arc) { emit_arc(arc, rows, same_last_cell ? y - 1 : y, w, sink); });
}

// Radii for which 64 bits hold 4 * a^2 * b^2.
IRG_INLINE constexpr bool is_small_ellipse(int a, int b) noexcept { return a < (1 << 15) && b < (1 << 15); }

// An ellipse with a radius of 0 is a line along an axis.
template <SpanSink Sink>
constexpr void flat_ellipse_spans(const cell& centre, std::int64_t a, std::int64_t b, const cell_window& w,
                                  Sink&& sink) {
  symmetric_spans(centre, b, w, sink, [a](std::int64_t) { return a; });
}

template <class J, SpanSink Sink>
constexpr void full_ellipse_spans(const cell& centre, std::int64_t a, std::int64_t b, const cell_window& w,
                                  Sink&& sink) {
  const J aa = static_cast<J>(a) * a, bb = static_cast<J>(b) * b;
  symmetric_spans(centre, b, w, sink, [&](std::int64_t dy) {
    return floor_sqrt(static_cast<std::int64_t>(aa * (bb - static_cast<J>(dy) * dy) / bb));
  });
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

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

}  // namespace irg::inline IRG_ABI
