// SPDX-License-Identifier: MIT
// The shape of a thick line as four half-planes and up to two discs, each decided at pixel centres in integers.
//
// With d = b - a, p is inside the strip of width w around the line when |(p - a) x d| <= w/2 * |d|, and between square
// ends when (p - a) . d lies w/2 * |d| beyond them at most. That product is irrational, but the left sides are
// integers: only floor(sqrt(w^2 * d.d)), and whether the root is exact, matter. So every edge becomes
// a * x + b * y <= c in integers, x and y being the pixel. An edge that goes exactly through a centre owns it when it
// is a left or a level top edge, and a disc owns the left half of its circle without the highest and the lowest point:
// strokes that touch share no pixel and leave none out.
#pragma once

#include <irg/raster/detail/floor_division.hpp>
#include <irg/raster/detail/integer_sqrt.hpp>
#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/line_pen.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The integers [first, last).
template <class J>
struct stroke_range {
  J first, last;

  // Keeps the v with a * v <= c.
  IRG_INLINE constexpr void cut(std::int64_t a, J c) noexcept {
    if (a > 0)
      last = lesser(last, static_cast<J>(floor_div<J>(c, a) + 1));
    else if (a < 0)
      first = greater(first, static_cast<J>(-floor_div<J>(c, -a)));
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
      x.last = lesser(x.last, static_cast<J>(at + 1));
    else if (side < 0)
      x.first = greater(x.first, static_cast<J>(-at));
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
    stroke_range<J> y{greater<J>(y_first, w.y_first), lesser<J>(y_last, w.y_last)};
    const int bounding = discs > 0 ? lesser(edges, 2) : edges;
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
  s.y_first = (snapped(lesser(p.ay, p.by)) - reach + half_pixel - 1) >> subpixel_bits;
  s.y_last = ((snapped(greater(p.ay, p.by)) + reach - half_pixel) >> subpixel_bits) + 1;
  return s;
}

// Adds a disc's pixels of row y to the others; what the parts of a stroke cover of a row has no gap.
template <class J>
IRG_INLINE constexpr void add_disc(stroke_range<J>& x, const stroke_disc& disc, J y, const cell_window& w) noexcept {
  const stroke_range<std::int64_t> chord = disc.row(static_cast<std::int64_t>(y));
  const J first = greater<J>(chord.first, w.x_first), last = lesser<J>(chord.last, w.x_last);
  if (first >= last) return;
  const bool only = x.first >= x.last;
  x = {only ? first : lesser(x.first, first), only ? last : greater(x.last, last)};
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

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
