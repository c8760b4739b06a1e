// SPDX-License-Identifier: MIT
// Which pixels a triangle covers: those whose centre lies inside, or on a top or left edge. Decided in integers, so
// triangles that share an edge never share a pixel and never leave one out.
//
// An edge from a to b has the edge function E(p) = (b - a) x (p - a): positive on the inside, zero on the edge, linear
// in p. All centres agree in the low 8 bits of E, so E = 256 * F + rest with one `rest` per edge and F an integer that
// changes by -dy per pixel to the right and by dx per pixel down. F >= 0 decides coverage: `rest` absorbs both the low
// bits and the tie rule. F needs 8 bits less than E, so 32 bits serve triangles whose box has up to 4 million pixels.
#pragma once

#include <cstdint>

#include <irg/core/sinks.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/math/floor_division.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/window.hpp>

namespace irg {

/// One edge of a triangle, ready to walk over pixels.
struct triangle_edge {
  std::int64_t at_origin = 0;  // F at pixel (0, 0)
  std::int32_t right = 0, down = 0;  // change of F per pixel
  std::int32_t rest = 0;  // E = 256 * F + rest, 0 <= rest <= 256

  /// F at pixel (x, y): the pixel's centre is on the edge's inner side exactly when it is not negative.
  IRG_INLINE constexpr std::int64_t operator()(int x, int y) const noexcept {
    return at_origin + std::int64_t{right} * x + std::int64_t{down} * y;
  }
  bool operator==(const triangle_edge&) const = default;
};

/// A triangle ready to be walked over.
/// shape   edge[i] is opposite to vertex i; vertices 1 and 2 are exchanged when `flipped`, so that all edges have
///         their inner side on the right
struct triangle_coverage {
  triangle_edge edge[3];
  std::int64_t double_area = 0;  // in (1/256 pixel)^2; 0 for a triangle that covers nothing because it has no inside
  cell_window bounds{};  // no covered pixel lies outside
  bool flipped = false;
  bool operator==(const triangle_coverage&) const = default;
};

inline namespace IRG_ABI {

/// Twice the area of a triangle in (1/256 pixel)^2: positive when a, b, c run clockwise on the screen (y down).
/// exact   for coordinates within snap_limit
[[nodiscard]] IRG_INLINE constexpr std::int64_t twice_signed_area(const subpixel& a, const subpixel& b,
                                                                  const subpixel& c) noexcept {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// Which way round a triangle runs as it is seen on the screen (y down).
[[nodiscard]] IRG_INLINE constexpr orientation orientation_of(const subpixel& a, const subpixel& b,
                                                              const subpixel& c) noexcept {
  const std::int64_t area = twice_signed_area(a, b, c);
  return area > 0 ? orientation::clockwise : area < 0 ? orientation::counter_clockwise : orientation::degenerate;
}

/// The top-left rule: whether an edge that runs by (dx, dy), its inner side on the right (clockwise, y down), owns the
/// centres that lie on it. A left edge (upwards) does, and a top edge (level, to the right).
/// shape   integers, or registers of them; a mask for these
template <class J>
[[nodiscard]] IRG_INLINE constexpr auto is_top_left(const J& dx, const J& dy) noexcept {
  return dy < ((J{} < dx) & 1);  // dy < 0, or dy == 0 and 0 < dx
}

/// The first pixel of a row or column whose centre is at or after v.
/// shape   v in 1/256 pixel, a number or a register of them
/// needs   |v| at most snap_limit pixels
template <class J>
[[nodiscard]] IRG_INLINE constexpr J first_centre(const J& v) noexcept {
  return (v + (half_pixel - 1)) >> subpixel_bits;
}

/// One past the last pixel of a row or column whose centre is at or before v.
/// shape   as first_centre
template <class J>
[[nodiscard]] IRG_INLINE constexpr J last_centre(const J& v) noexcept {
  return (v + (one_pixel - half_pixel)) >> subpixel_bits;
}

/// The pixels whose centres lie in the box of three places, its borders included.
/// gives   an empty window where there are none
[[nodiscard]] IRG_INLINE constexpr cell_window centres_within(const subpixel& a, const subpixel& b,
                                                              const subpixel& c) noexcept {
  const std::int32_t left = minimum(minimum(a.x, b.x), c.x), right = maximum(maximum(a.x, b.x), c.x);
  const std::int32_t top = minimum(minimum(a.y, b.y), c.y), bottom = maximum(maximum(a.y, b.y), c.y);
  return {first_centre(left), first_centre(top), last_centre(right), last_centre(bottom)};
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// The edge from a to b with the inner side on the right.
IRG_INLINE constexpr triangle_edge make_edge(const subpixel& a, const subpixel& b) noexcept {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t at_first_centre = dx * (half_pixel - a.y) - dy * (half_pixel - a.x);
  const std::int64_t inside_if_not_negative = at_first_centre - 1 + (is_top_left(dx, dy) ? 1 : 0);
  const std::int64_t f = inside_if_not_negative >> subpixel_bits;  // rounds down
  return {f, static_cast<std::int32_t>(-dy), static_cast<std::int32_t>(dx),
          static_cast<std::int32_t>(at_first_centre - f * one_pixel)};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The coverage of the triangle a, b, c, whichever way round it is given.
/// needs   coordinates within snap_limit pixels of the origin
/// gives   double_area 0 and empty bounds when the corners are collinear or coincide
/// exact   coverage is decided without rounding
/// source  Pineda 1988; Giesen 2013 for dropping the common low bits
[[nodiscard]] IRG_INLINE constexpr triangle_coverage cover_triangle(subpixel a, subpixel b, subpixel c) noexcept {
  triangle_coverage t;
  t.double_area = twice_signed_area(a, b, c);
  if (t.double_area == 0) return t;
  t.flipped = t.double_area < 0;
  if (t.flipped) {
    t.double_area = -t.double_area;
    const subpixel swap = b;
    b = c;
    c = swap;
  }
  t.edge[0] = detail::make_edge(b, c);
  t.edge[1] = detail::make_edge(c, a);
  t.edge[2] = detail::make_edge(a, b);
  t.bounds = centres_within(a, b, c);
  return t;
}

/// Whether the triangle covers pixel (x, y).
[[nodiscard]] IRG_INLINE constexpr bool covers(const triangle_coverage& t, int x, int y) noexcept {
  return t.double_area != 0 && t.edge[0](x, y) >= 0 && t.edge[1](x, y) >= 0 && t.edge[2](x, y) >= 0;
}

/// The covered pixels of row y, cut to the columns [x_first, x_last).
/// gives   an empty span when there are none, as in an empty range
/// cost    one division per edge that ends the span
[[nodiscard]] constexpr span_of_cells covered_span(const triangle_coverage& t, int y, int x_first,
                                                   int x_last) noexcept {
  // first and last stay within [x_first, x_last], as does what is computed there.
  const std::int64_t left = minimum(x_first, x_last), right = x_last;
  std::int64_t first = x_first, last = t.double_area == 0 ? left : right;
  for (const triangle_edge& e : t.edge) {
    const std::int64_t f = e(0, y);
    if (e.right > 0) {
      if (f + e.right * first < 0)  // the smallest x with f + right * x >= 0
        first = minimum(-floor_div(f, std::int64_t{e.right}), right);
    } else if (e.right < 0) {
      if (f + e.right * (last - 1) < 0)  // one past the greatest such x
        last = maximum(floor_div(f, -std::int64_t{e.right}) + 1, left);
    } else if (f < 0) {
      last = left;
    }
  }
  first = minimum(first, right);
  return {y, static_cast<int>(first), static_cast<int>(maximum(first, last))};
}

/// Calls sink(span) for every row of covered pixels in the window, from top to bottom.
/// gives   no call for a degenerate triangle or one outside the window
/// cost    two divisions per row, sometimes three
template <SpanSink Sink>
constexpr void covered_spans(const triangle_coverage& t, const cell_window& window, Sink&& sink) {
  const cell_window w = intersect(t.bounds, window);
  for (int y = w.y_first; y < w.y_last; ++y) {
    const span_of_cells span = covered_span(t, y, w.x_first, w.x_last);
    if (span.x_first < span.x_last) sink(span);
  }
}

/// Whether the triangle covers all pixels of a window, none, or possibly some.
/// shape   any window of ints, that of the whole range included
/// gives   inside exactly if every pixel of the window is covered; outside if the rectangle of the window's pixel
///         centres and the triangle do not meet, so surely none is; crossing for the rest, which may still cover no
///         centre: a sliver may pass between them. An empty window, and any window of a triangle without area: outside
/// exact   decided in integers; neither outside nor inside is missed in the sense above
/// cost    some 30 integer operations; windows outside of the bounds four comparisons
/// source  Pineda 1988; the separating axis theorem
[[nodiscard]] constexpr containment classify(const triangle_coverage& t, const cell_window& w) noexcept {
  // Edge functions are linear, so that the least and the greatest value in a window are those of two of its corners.
  // Two convex shapes that do not meet are parted along a side of one of them: of the rectangle (the bounds) or of the
  // triangle (an edge function that is negative in all corners).
  //
  // No overflow: positions lie within 2^29, so |right|, |down| <= 2^30 and |at_origin| <= 2^52 + 1, which the value of
  // an edge function at any pixel of 32 bits, at most 2 * 2^61 + 2^52 + 1, leaves below 2^63.
  if (w.empty() || t.double_area == 0 || intersect(t.bounds, w).empty()) return containment::outside;
  bool inside = true;
  for (const triangle_edge& e : t.edge) {
    const int left = w.x_first, right = w.x_last - 1, top = w.y_first, bottom = w.y_last - 1;
    const bool grows_right = e.right > 0, grows_down = e.down > 0;
    if (e(grows_right ? right : left, grows_down ? bottom : top) < 0) return containment::outside;
    inside = inside && e(grows_right ? left : right, grows_down ? top : bottom) >= 0;
  }
  return inside ? containment::inside : containment::crossing;
}

IRG_RENAMED(signed_double_area, twice_signed_area)

}  // namespace IRG_ABI
}  // namespace irg
