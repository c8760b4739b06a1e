// SPDX-License-Identifier: MIT
// line_thick: the pixels whose centres lie in a line of a given width, row by row; polyline_thick: in a chain of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <irg/math/floor_division.hpp>
#include <irg/raster/detail/integer_sqrt.hpp>
#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/line_style.hpp>

namespace irg::inline IRG_ABI {

/// Calls sink(span) for the pixels in the window whose centres lie in the thick line from a to b, from top to bottom.
/// shape   one span per row: butt caps give the rectangle of the pen's width around the line, square caps one longer by
///         half the width at both ends, round caps all points within half the width of the line
/// units   points in pixels, snapped to 1/256 pixel once; pixel (0, 0) has its centre at (128, 128) of these
/// gives   false, and no call, when a position that is no cell cannot be snapped; else true. No call for a width of 0
///         or less, nor for a == b with butt caps; a == b gives a disc with round caps and a square along the axes with
///         square caps
/// exact   for all cells; decided without rounding; a centre exactly on the outline belongs to the line when the
///         outline is a left or a level top edge there, so that lines which touch share no pixel and leave none out;
///         the highest and the lowest point of a round cap do not belong to it
/// cost    some twenty divisions per line, a dozen additions and, with round caps, two square roots per visible row;
///         divides in 128 bits when the end cells are out of reach of snap()
template <ScreenPosition P, SpanSink Sink>
constexpr bool line_thick(const P& a, const P& b, const line_pen& pen, const cell_window& window, Sink&& sink);

/// Calls sink(span) for the pixels in the window whose centres lie in the thick line through all points, each pixel
/// once, from top to bottom and from left to right.
/// shape   the union of the thick lines between successive points, with a disc at every point between; the caps are
///         those of the first and the last point. Repeat the first point, with round caps, for a closed line.
/// needs   coordinates within snap_limit pixels of the origin
/// gives   no call for no point or a width of 0 or less; points that are all equal give what line_thick gives for them
/// exact   each part as line_thick; spans of a row neither overlap nor touch
/// cost    allocates the visible spans of all parts and sorts them
template <SpanSink Sink>
constexpr void polyline_thick(std::span<const subpixel> points, const line_pen& pen, const cell_window& window,
                              Sink&& sink);

/// Paints the pixels of the thick line from a to b, each once.
/// gives   false, and no pixel, when line_thick does
/// exact   the spans of line_thick
template <WritableRaster R, ScreenPosition P, PaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_thick(R& raster, const P& a, const P& b, const line_pen& pen, const Paint& paint) {
  return line_thick(a, b, pen, window_of(raster), [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

/// Paints the pixels of the thick line through all points, each once.
/// exact   the spans of polyline_thick
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_polyline_thick(R& raster, std::span<const subpixel> points, const line_pen& pen,
                                   const Paint& paint) {
  polyline_thick(points, pen, window_of(raster), [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The shape of a thick line as four half-planes and up to two discs, each decided at pixel centres in integers.
//
// With d = b - a, p is inside the strip of width w around the line when |(p - a) x d| <= w/2 * |d|, and between square
// ends when (p - a) . d lies w/2 * |d| beyond them at most. That product is irrational, but the left sides are
// integers: only floor(sqrt(w^2 * d.d)), and whether the root is exact, matter. So every edge becomes
// a * x + b * y <= c in integers, x and y being the pixel. An edge that goes exactly through a centre owns it when it
// is a left or a level top edge, and a disc owns the left half of its circle without the highest and the lowest point:
// strokes that touch share no pixel and leave none out.

// The integers [first, last).
template <class J>
struct stroke_range {
  J first, last;

  // Keeps the v with a * v <= c.
  IRG_INLINE constexpr void cut(std::int64_t a, J c) noexcept {
    if (a > 0)
      last = minimum(last, static_cast<J>(floor_div<J>(c, a) + 1));
    else if (a < 0)
      first = maximum(first, static_cast<J>(-floor_div<J>(c, -a)));
    else if (c < 0)
      last = first;
  }
};

// The pixels with a * x + b * y <= c.
template <class J>
struct stroke_edge {
  std::int64_t a, b;
  J c;
};

// An edge carried from row to row without dividing: at = floor((c - b * y) / |a|), or c - b * y when a is 0.
template <class J>
struct stroke_edge_walk {
  J at = 0, rest = 0, step = 0, step_rest = 0, size = 1;
  int side = 0;  // 1: a right side, whose last pixel is `at`; -1: a left side, whose first one is -at; 0: level

  IRG_INLINE constexpr stroke_edge_walk() noexcept = default;
  constexpr stroke_edge_walk(const stroke_edge<J>& e, J y) noexcept
      : size(e.a > 0   ? e.a
             : e.a < 0 ? -e.a
                       : 1),
        side(e.a > 0   ? 1
             : e.a < 0 ? -1
                       : 0) {
    const J value = e.c - static_cast<J>(e.b) * y, fall = -e.b;
    at = floor_div(value, size);
    rest = value - at * size;
    step = floor_div(fall, size);
    step_rest = fall - step * size;
  }
  IRG_INLINE constexpr void cut(stroke_range<J>& x) const noexcept {
    if (side > 0)
      x.last = minimum(x.last, static_cast<J>(at + 1));
    else if (side < 0)
      x.first = maximum(x.first, static_cast<J>(-at));
    else if (at < 0)
      x.last = x.first;
  }
  IRG_INLINE constexpr void next_row() noexcept {
    const J more = rest + step_rest;
    const bool carry = more >= size;
    at += step + (carry ? 1 : 0);
    rest = carry ? more - size : more;
  }
};

// A disc around (x, y), all in 1/256 pixel.
struct stroke_disc {
  std::int64_t x, y, width;

  IRG_INLINE constexpr stroke_range<std::int64_t> row(std::int64_t r) const noexcept {
    const std::int64_t centre = r * one_pixel + half_pixel;
    const std::int64_t from_y = 2 * (centre < y ? y - centre : centre - y);
    if (from_y >= width) return {0, 0};
    const std::int64_t square = width * width - from_y * from_y;
    const std::int64_t chord = floor_sqrt(square), open_chord = chord * chord == square ? chord - 1 : chord;
    return {(x - chord / 2 + half_pixel - 1) >> subpixel_bits,
            ((x + open_chord / 2 - half_pixel) >> subpixel_bits) + 1};
  }
};

// Two ends in multiples of 2^-bits pixel: pixel 0 has its centre at 128 with 8 bits, at 0 with none.
struct thick_stroke_ends {
  std::int64_t ax, ay, bx, by;
};

template <class J>
struct thick_stroke {
  stroke_edge<J> edge[4] = {};  // both sides, then the start and the end
  int edges = 0, discs = 0;
  stroke_disc disc[2] = {};
  std::int64_t y_first = 0, y_last = 0;  // no row outside has a pixel

  // The rows in which the stroke may have a pixel inside of the window.
  constexpr stroke_range<J> rows(const cell_window& w) const noexcept {
    stroke_range<J> y{maximum<J>(y_first, w.y_first), minimum<J>(y_last, w.y_last)};
    const int bounding = discs > 0 ? minimum(edges, 2) : edges;
    for (int k = 0; k < bounding; ++k) {
      const stroke_edge<J>& e = edge[k];
      y.cut(e.b, e.c - static_cast<J>(e.a) * (e.a > 0 ? w.x_first : w.x_last - 1));
    }
    return y;
  }
};

// The edges of the rectangle around a line of direction (dx, dy); length_squared is 0 when the line is a point.
template <class J, int Bits>
constexpr void set_stroke_edges(thick_stroke<J>& s, const thick_stroke_ends& p, std::int64_t dx, std::int64_t dy,
                                J length_squared, std::int64_t width, line_caps start, line_caps end) noexcept {
  constexpr std::int64_t centre = (1 << Bits) / 2;
  const uint128 square = static_cast<uint128>(width) * static_cast<uint128>(width) *
                         static_cast<uint128>(static_cast<J>(dx) * dx + static_cast<J>(dy) * dy);
  const uint128 root = floor_sqrt_wide(square);
  // w/2 * |d| in units of the edges' values, which are (2^-bits pixel)^2, for edges that own their points and others
  const J half = static_cast<J>(root >> (9 - Bits)),
          open_half = static_cast<J>((root - (root * root == square)) >> (9 - Bits));
  const J across = static_cast<J>(centre - p.ax) * dy - static_cast<J>(centre - p.ay) * dx;  // of pixel (0, 0)
  const J along = static_cast<J>(centre - p.ax) * dx + static_cast<J>(centre - p.ay) * dy;
  const auto set = [&](int k, std::int64_t a, std::int64_t b, J at_zero, J beyond, bool plus_half) {
    const bool owns_its_points = a < 0 || (a == 0 && b < 0);
    const J limit = beyond + (plus_half ? (owns_its_points ? half : open_half) : (owns_its_points ? J{0} : J{-1}));
    s.edge[k] = {a, b, (limit - at_zero) >> Bits};
  };
  set(0, dy, -dx, across, 0, true);
  set(1, -dy, dx, -across, 0, true);
  set(2, -dx, -dy, -along, 0, start == line_caps::square);
  set(3, dx, dy, along, length_squared, end == line_caps::square);
  s.edges = 4;
}

// The stroke from a to b. J holds 4 * (the difference of two coordinates)^2.
template <class J, int Bits>
constexpr thick_stroke<J> thick_stroke_of(const thick_stroke_ends& p, std::int64_t width, line_caps start,
                                          line_caps end) noexcept {
  thick_stroke<J> s;
  if (width <= 0) return s;
  const std::int64_t dx = p.bx - p.ax, dy = p.by - p.ay;
  const bool is_point = dx == 0 && dy == 0;
  if (!is_point)
    set_stroke_edges<J, Bits>(s, p, dx, dy, static_cast<J>(dx) * dx + static_cast<J>(dy) * dy, width, start, end);
  else if (start == line_caps::square)
    set_stroke_edges<J, Bits>(s, p, 1, 0, 0, width, start, end);
  const auto snapped = [](std::int64_t v) { return Bits == 0 ? v * one_pixel + half_pixel : v; };
  if (start == line_caps::round) s.disc[s.discs++] = {snapped(p.ax), snapped(p.ay), width};
  if (end == line_caps::round) s.disc[s.discs++] = {snapped(p.bx), snapped(p.by), width};
  if (s.edges == 0 && s.discs == 0) return s;
  const std::int64_t reach = start == line_caps::square || end == line_caps::square ? width : width / 2 + 1;
  s.y_first = (snapped(minimum(p.ay, p.by)) - reach + half_pixel - 1) >> subpixel_bits;
  s.y_last = ((snapped(maximum(p.ay, p.by)) + reach - half_pixel) >> subpixel_bits) + 1;
  return s;
}

// Adds a disc's pixels of row y to the others; what the parts of a stroke cover of a row has no gap.
template <class J>
IRG_INLINE constexpr void add_disc(stroke_range<J>& x, const stroke_disc& disc, J y, const cell_window& w) noexcept {
  const stroke_range<std::int64_t> chord = disc.row(static_cast<std::int64_t>(y));
  const J first = maximum<J>(chord.first, w.x_first), last = minimum<J>(chord.last, w.x_last);
  if (first >= last) return;
  const bool only = x.first >= x.last;
  x = {only ? first : minimum(x.first, first), only ? last : maximum(x.last, last)};
}

// Calls sink(span) for the stroke's pixels in the window, row by row.
template <class J, SpanSink Sink>
constexpr void stroke_spans(const thick_stroke<J>& s, const cell_window& window, Sink&& sink) {
  if (window.empty()) return;
  const stroke_range<J> rows = s.rows(window);
  if (rows.first >= rows.last) return;
  stroke_edge_walk<J> edge[4];
  for (int k = 0; k < s.edges; ++k) edge[k] = {s.edge[k], rows.first};
  for (J y = rows.first; y < rows.last; ++y) {
    stroke_range<J> x{window.x_first, s.edges == 0 ? window.x_first : window.x_last};
    for (int k = 0; k < s.edges; ++k) {
      edge[k].cut(x);
      edge[k].next_row();
    }
    for (int k = 0; k < s.discs; ++k) add_disc(x, s.disc[k], y, window);
    if (x.first < x.last) sink(span_of_cells{static_cast<int>(y), static_cast<int>(x.first), static_cast<int>(x.last)});
  }
}

constexpr thick_stroke<std::int64_t> thick_stroke_between(const subpixel& a, const subpixel& b, std::int32_t width,
                                                          line_caps start, line_caps end) noexcept {
  return thick_stroke_of<std::int64_t, subpixel_bits>({a.x, a.y, b.x, b.y}, width, start, end);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <ScreenPosition P, SpanSink Sink>
constexpr bool line_thick(const P& a, const P& b, const line_pen& pen, const cell_window& window, Sink&& sink) {
  if (can_snap(a) && can_snap(b))
    detail::stroke_spans(detail::thick_stroke_between(snap(a), snap(b), pen.width, pen.caps, pen.caps), window, sink);
  else if constexpr (CellOrPosition<P>) {
    const cell from = as_cell(a), to = as_cell(b);
    detail::stroke_spans(
        detail::thick_stroke_of<int128, 0>({from.x, from.y, to.x, to.y}, pen.width, pen.caps, pen.caps), window, sink);
  } else
    return false;
  return true;
}

template <SpanSink Sink>
constexpr void polyline_thick(std::span<const subpixel> points, const line_pen& pen, const cell_window& window,
                              Sink&& sink) {
  std::vector<span_of_cells> spans;
  const auto keep = [&](const span_of_cells& s) { spans.push_back(s); };
  std::size_t last = points.size();  // the end of the line's last part that is longer than a point
  while (last > 1 && points[last - 1] == points[last - 2]) --last;
  std::size_t from = 0;
  for (std::size_t to = 1; to < last; ++to) {
    if (points[to] == points[from]) continue;
    const line_caps start = from == 0 ? pen.caps : line_caps::round;
    const line_caps end = to + 1 == last ? pen.caps : line_caps::round;
    detail::stroke_spans(detail::thick_stroke_between(points[from], points[to], pen.width, start, end), window, keep);
    from = to;
  }
  if (from == 0 && !points.empty()) line_thick(points[0], points[0], pen, window, keep);
  std::sort(spans.begin(), spans.end(), [](const span_of_cells& p, const span_of_cells& q) {
    return p.y != q.y ? p.y < q.y : p.x_first < q.x_first;
  });
  for (std::size_t i = 0; i < spans.size();) {
    span_of_cells merged = spans[i++];
    for (; i < spans.size() && spans[i].y == merged.y && spans[i].x_first <= merged.x_last; ++i)
      merged.x_last = maximum(merged.x_last, spans[i].x_last);
    sink(merged);
  }
}

}  // namespace irg::inline IRG_ABI
