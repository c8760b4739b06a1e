// SPDX-License-Identifier: MIT
// Convex polygons with smooth edges: the coverage of a pixel is the area of the polygon within it.
//
// Edges that two polygons share stay visible as seams, because coverage is used as opacity: half of one colour and then
// half of the next leave a quarter of what was there before. Where polygons tile a region, fill_convex.hpp is right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <irg/core/function_ref.hpp>
#include <irg/core/lanes.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/blend_span.hpp>
#include <irg/raster/detail/area_kernel.hpp>
#include <irg/raster/detail/area_targets.hpp>
#include <irg/raster/detail/compiled_rasters.hpp>
#include <irg/raster/detail/snapped_ring.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Calls sink(span) for runs of pixels of the window that a convex polygon covers, whole or in part, row by row from
/// top to bottom, left to right, no pixel twice. How a row is cut into runs is not promised; a coverage may be 0.
/// units   floating vertices in pixels, snapped to 1/256 as by snap(); subpixel vertices as they are
/// needs   a convex ring of either orientation
/// gives   false and no span when a vertex is NaN, infinite or more than snap_limit pixels from the origin; else true.
///         No span for rings of less than 3 vertices or without area. Of a ring that is not convex, some coverages in
///         the window
/// exact   coverage is the area within the pixel in 255ths, rounded to the nearest: within 0.00198 (1/256 is 0.0039) of
///         the exact area of the snapped polygon. No window changes a pixel within it; a polygon mirrored in x has
///         mirrored coverages, one shifted by whole pixels has shifted ones
/// cost    two divisions per edge; per row, a closed form for the pixels that edges cross; nothing is allocated
/// source  Catmull 1978 (areas add up); closed forms per edge and row
template <FillableRing Ring, CoverageSink Sink>
constexpr bool convex_coverage(const Ring& ring, const cell_window& window, Sink&& sink);

/// Paints a convex polygon, each pixel as far as it is covered.
/// gives   false, and nothing painted, when a vertex is NaN, infinite or more than snap_limit pixels from the origin
/// exact   the pixels that convex_coverage and blend_span make
template <WritableRaster R, FillableRing Ring, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool fill_convex_aa(R& raster, const Ring& ring, const Paint& paint);

}  // namespace IRG_ABI

namespace detail {

inline namespace IRG_COMPILED_ABI {

template <CompiledVertex V>
IRG_API bool send_convex_ring(std::span<const V> ring, const cell_window& w,
                              const function_ref<void(const coverage_span&)>& sink);
template <CompiledPixel P, CompiledVertex V>
IRG_API bool mix_convex_ring(const image_view<P>& raster, std::span<const V> ring, const P& value,
                             const cell_window& w);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

// The rows of a convex polygon, one after the other: the easy ones (nearly all) a few columns at a time, each with the
// bits that area_row gives.

// Rows of steep edges that no window cuts. With less than a pack of columns covered in part on a side the columns are
// the same in each row and small, so that nothing is to be masked (uncovered_near).
template <int N>
struct steep_rows {
  using F = pack<float, N>;
  static constexpr int half = N / 2;
  F up, down, column, width, scale;
  bool very_steep, steep;  // at most half a pack of columns covered in part on a side; at most a pack

  IRG_INLINE steep_rows(const whole_edge_rows<F>& left, const whole_edge_rows<F>& right) noexcept
      : up(lanes<F>::ramp()), down(lanes<F>::broadcast(N - 1) - up) {
    const std::int64_t reach = maximum(left.reach, right.reach);
    very_steep = reach <= (half - 1) * area_one;
    steep = reach <= (N - 1) * area_one;
    const auto first = lanes<pack<std::int32_t, N>>::ramp() < half;
    column = select(first, up, down);
    width = select(first, left.width, right.width);
    scale = select(first, left.scale, right.scale);
  }

  // Sends the columns [x_first, x_last); false when this row is none of the easy ones.
  template <class Target>
  IRG_INLINE bool row(Target& target, const whole_edge_rows<F>& left, const whole_edge_rows<F>& right, int x_first,
                      int x_last) const {
    const F one = lanes<F>::broadcast(1);
    const int total = x_last - x_first;
    if (very_steep && total >= N) {  // both ends in one pack
      const std::int32_t l = area_rest(left.low), r = area_rest(right.low);
      pack<std::int32_t, N> rest;
      if constexpr (N == 4)
        rest = pack_of(l, l, r, r);
      else
        rest = pack_of(l, l, l, l, r, r, r, r);
      target.mix_ends(x_first, x_last,
                      coverage_of_area(one - uncovered_near(column, to_float(rest) * lanes<F>::broadcast(0x1p-20f),
                                                            width, scale, one)));
      return true;
    }
    if (steep && total >= 2 * N) {  // one end a pack
      target.mix_ends(x_first, x_last,
                      coverage_of_area(one - uncovered_near(up, left.rest(), left.width, left.scale, one)),
                      coverage_of_area(one - uncovered_near(down, right.rest(), right.width, right.scale, one)));
      return true;
    }
    if (steep && total <= N && total > 0) {  // the whole row in one pack
      const F from_right = lanes<F>::broadcast(static_cast<float>(total - N)) + down;
      target.mix_some(
          x_first, total,
          coverage_of_area(one - (uncovered_near(up, left.rest(), left.width, left.scale, one) +
                                  uncovered_near(from_right, right.rest(), right.width, right.scale, one))));
      return true;
    }
    return false;
  }
};

// A polygon of few columns and rows: what its sides leave uncovered is summed up edge by edge, for all columns at once.
// All positions are exact here, as in uncovered_near.
template <int N>
struct small_polygon {
  using F = pack<float, N>;
  static constexpr int packs = N == 4 ? 3 : 2, columns = packs * N, rows = 12;
  F sum[2][static_cast<unsigned>(rows)][static_cast<unsigned>(packs)];
  int used;  // packs

  IRG_INLINE static constexpr bool serves(int width, int height) noexcept { return width <= columns && height <= rows; }

  IRG_INLINE explicit small_polygon(int width) noexcept : used((width + N - 1) / N) {}

  // Adds a side of the ring, from its topmost vertex down.
  template <int Mirror, class Vertices>
  IRG_INLINE void add_side(const Vertices& vertex, std::size_t n, std::size_t topmost, bool forward, int row_first,
                           int x_first, std::int32_t bottom) noexcept {
    const F ramp = Mirror > 0 ? lanes<F>::ramp() : lanes<F>::broadcast(0) - lanes<F>::ramp();
    const F step = lanes<F>::broadcast(static_cast<float>(Mirror * N));
    const std::int32_t origin = (Mirror > 0 ? x_first : -1 - x_first);
    std::size_t i = topmost;
    subpixel b = vertex(i);
    b.x *= Mirror;
    int last_row = row_first - 1;  // the row of the piece before
    do {
      const subpixel a = b;
      i = next_vertex(i, n, forward);
      b = vertex(i);
      b.x *= Mirror;
      if (b.y <= a.y) continue;
      const area_edge edge(a, b);
      const F scale = lanes<F>::broadcast(edge.scale);
      int row = a.y >> subpixel_bits;
      std::int32_t y = a.y;
      std::int64_t from = area_position(a.x), next = edge.enters(row + 1);
      do {
        const std::int32_t lower = (row + 1) * one_pixel, stop = minimum(lower, b.y);
        const std::int64_t to = stop == lower ? next : area_position(b.x);
        const auto low = static_cast<std::int32_t>((minimum(from, to) >> 20) - (std::int64_t{origin} << 20));
        const auto reach = static_cast<std::int32_t>((from < to ? to - from : from - to) >> 20);
        const F rest = lanes<F>::broadcast(area_fraction(low)), width = lanes<F>::broadcast(area_fraction(reach));
        const F height = lanes<F>::broadcast(static_cast<float>(stop - y) * 0x1p-8f);
        F* const out = sum[Mirror > 0 ? 0 : 1][row - row_first];
        F column = ramp;
        const bool continues = y > row * one_pixel && last_row == row;  // a lower piece in a row that has one
        for (int k = 0; k < used; ++k) {
          const F uncovered = uncovered_near(column, rest, width, scale, height);
          out[k] = continues ? out[k] + uncovered : uncovered;
          column = column + step;
        }
        last_row = row;
        from = next;
        next += edge.advance;
        y = stop;
        ++row;
      } while (y < b.y);
    } while (b.y < bottom);
  }
};

// Sends the rows [row, stop) to the target, which the same two edges cross from top to bottom.
template <class F, class Target>
IRG_INLINE constexpr void whole_rows(Target& target, whole_edge_rows<F> left, whole_edge_rows<F> right, int row,
                                     int stop, const cell_window& w) {
  if constexpr (lanes<F>::count > 1) {
    const steep_rows<lanes<F>::count> steep(left, right);
    for (; row < stop; ++row) {
      const int x_first = area_column(left.low), x_last = -area_column(right.low);
      target.begin(row);
      if (x_first < w.x_first || x_last > w.x_last || !steep.row(target, left, right, x_first, x_last))
        area_row<F>(target, left.row(), right.row(), 1.0f, w);
      target.end();
      left.next();
      right.next();
    }
    return;
  }
  for (; row < stop; ++row) {
    target.begin(row);
    area_row<F>(target, left.row(), right.row(), 1.0f, w);
    target.end();
    left.next();
    right.next();
  }
}

// Sends the rows of a small polygon to the target; columns of its box that a row does not reach are sent, too.
// needs   the columns [x_first, x_last) and rows [row_first, row_last) of its box, the columns within the window
template <int N, class Vertices, class Target>
IRG_INLINE void small_area_rows(const Vertices& vertex, std::size_t n, const ring_extent<std::int32_t>& extent,
                                bool clockwise, int x_first, int x_last, int row_first, int row_last,
                                const cell_window& w, Target& target) {
  using F = pack<float, N>;
  small_polygon<N> polygon(x_last - x_first);
  polygon.template add_side<1>(vertex, n, extent.topmost, !clockwise, row_first, x_first, extent.bottom);
  polygon.template add_side<-1>(vertex, n, extent.topmost, clockwise, row_first, x_first, extent.bottom);
  const int stop = minimum(row_last, w.y_last);
  for (int row = maximum(row_first, w.y_first); row < stop; ++row) {
    const std::int32_t height = minimum(extent.bottom, (row + 1) * one_pixel) - maximum(extent.top, row * one_pixel);
    const F full = lanes<F>::broadcast(static_cast<float>(height) * 0x1p-8f);
    target.begin(row);
    for (int k = 0; k < polygon.used; ++k) {
      const int x = x_first + k * N, i = row - row_first;
      const pack<std::int32_t, N> c = coverage_of_area(full - (polygon.sum[0][i][k] + polygon.sum[1][i][k]));
      if (x + N <= x_last)
        target.mix_all(x, c);
      else
        target.mix_some(x, x_last - x, c);
    }
    target.end();
  }
}

// Sends every row of a ring to the target.
// needs   vertex(i) for i < n, n >= 3; clockwise: as seen on the screen
template <class F, class Vertices, class Target>
IRG_INLINE constexpr void area_rows(const Vertices& vertex, std::size_t n, const ring_extent<std::int32_t>& extent,
                                    bool clockwise, const cell_window& w, Target& target) {
  const int row_first = extent.top >> subpixel_bits, row_end = (extent.bottom + (one_pixel - 1)) >> subpixel_bits;
  if constexpr (lanes<F>::count > 1 && Target::takes_uncovered) {
    const int x_first = extent.left >> subpixel_bits, x_last = (extent.right + (one_pixel - 1)) >> subpixel_bits;
    if (small_polygon<lanes<F>::count>::serves(x_last - x_first, row_end - row_first) && x_first >= w.x_first &&
        x_last <= w.x_last)
      return small_area_rows<lanes<F>::count>(vertex, n, extent, clockwise, x_first, x_last, row_first, row_end, w,
                                              target);
  }
  area_side<1, Vertices> left(vertex, n, extent.topmost, !clockwise);
  area_side<-1, Vertices> right(vertex, n, extent.topmost, clockwise);
  int row = maximum(row_first, w.y_first);
  const int row_last = minimum(row_end, w.y_last);
  edge_pieces_row left_pieces, right_pieces;
  while (row < row_last) {
    const std::int32_t y = maximum(row * one_pixel, extent.top);
    if (left.b.y <= y) left.lead_on(y);
    if (right.b.y <= y) right.lead_on(y);
    const int stop = minimum(minimum(left.row_last, right.row_last), row_last);
    if (left.row_first <= row && right.row_first <= row && row < stop && left.suits_floats() && right.suits_floats()) {
      whole_rows<F>(target, whole_edge_rows<F>(left, row), whole_edge_rows<F>(right, row), row, stop, w);
      row = stop;
    } else {
      const std::int32_t y_last = minimum((row + 1) * one_pixel, extent.bottom);
      left.pieces(row, y, y_last, left_pieces);
      right.pieces(row, y, y_last, right_pieces);
      target.begin(row);
      area_row<F>(target, left_pieces, right_pieces, static_cast<float>(y_last - y) * 0x1p-8f, w);
      target.end();
      ++row;
    }
  }
}

// Convex rings: read, sent to a target of coverages, or mixed straight into pixels.

// The pixels that a ring of this extent may cover in part.
template <class J>
constexpr cell_window cells_of_extent(const ring_extent<J>& e) noexcept {
  const auto above = [](J v) { return (v + (one_pixel - 1)) >> subpixel_bits; };
  return {e.left >> subpixel_bits, e.top >> subpixel_bits, above(e.right), above(e.bottom)};
}

// Sends the rows of a convex ring to the target.
// needs   vertex(i) for i < n, n >= 3
template <class F, class Vertices, class Target>
IRG_INLINE constexpr void area_of_vertices(const Vertices& vertex, std::size_t n,
                                           const ring_extent<std::int32_t>& extent, const cell_window& w,
                                           Target& target) {
  if (extent.top >= extent.bottom || intersect(w, cells_of_extent(extent)).empty()) return;
  // Twice the area, modulo 2^64; of a convex ring it fits.
  std::uint64_t area = 0;
  subpixel a = vertex(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const subpixel b = vertex(i);
    area += static_cast<std::uint64_t>(std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x);
    a = b;
  }
  if (area != 0) area_rows<F>(vertex, n, extent, static_cast<std::int64_t>(area) > 0, w, target);
}

template <class F, FillableRing Ring, class Target>
IRG_INLINE constexpr bool area_of_ring(const Ring& ring, const cell_window& w, Target& target) {
  constexpr std::size_t kept = 16;  // vertices snapped once; longer rings are snapped twice
  subpixel snapped[kept];
  const std::size_t n = ring_size(ring);
  ring_extent<std::int32_t> extent;
  for (std::size_t i = 0; i < n; ++i) {
    if (reach_of_vertex(ring, i) != ring_reach::within_snap_limit) return false;
    const subpixel v = near_vertex(ring, i);
    if (i < kept) snapped[i] = v;
    extent.add(v, i);
  }
  if (n < 3) return true;
  if (n <= kept)
    area_of_vertices<F>([&](std::size_t i) { return snapped[i]; }, n, extent, w, target);
  else
    area_of_vertices<F>([&](std::size_t i) { return near_vertex(ring, i); }, n, extent, w, target);
  return true;
}

// Mixes a colour straight into rows.
template <class R, FillableRing Ring>
bool mix_ring_in_lanes(R& raster, const Ring& ring, const pixel_of<R>& value, const cell_window& w) {
  area_mix_target<R> target(raster, value);
  return area_of_ring<pack<float, mix_lanes>>(ring, w, target);
}

// Sends the coverages of a convex ring to a sink.
template <FillableRing Ring, class Sink>
constexpr bool send_convex_areas(const Ring& ring, const cell_window& w, Sink& sink) {
  area_span_target<Sink> target{sink};
  if (!std::is_constant_evaluated()) return area_of_ring<pack<float, native_lanes<float>>>(ring, w, target);
  return area_of_ring<float>(ring, w, target);
}

// Mixes a value into the pixels of a raster that has rows.
template <class R, FillableRing Ring>
constexpr bool mix_convex_areas(R& raster, const Ring& ring, const pixel_of<R>& value, const cell_window& w) {
  if constexpr (mixes_in_lanes<pixel_of<R>>) {
    if (!std::is_constant_evaluated()) return mix_ring_in_lanes(raster, ring, value, w);
  }
  const auto blend = [&](const coverage_span& span) { blend_span(raster, span, value); };
  return send_convex_areas(ring, w, blend);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <FillableRing Ring, CoverageSink Sink>
constexpr bool convex_coverage(const Ring& ring, const cell_window& window, Sink&& sink) {
  if constexpr (detail::draws_in_library && detail::CompiledRing<Ring>)
    return detail::send_convex_ring(std::span<const ring_point<Ring>>(ring), window,
                                    as_function<void(const coverage_span&)>(sink));
  else
    return detail::send_convex_areas(ring, window, sink);
}

template <WritableRaster R, FillableRing Ring, CoveragePaintFor<R> Paint>
constexpr bool fill_convex_aa(R& raster, const Ring& ring, const Paint& paint) {
  const cell_window w = window_of(raster);
  if constexpr (detail::draws_in_library && detail::CompiledRaster<R> && detail::CompiledRing<Ring> &&
                !CoverageBlendFunction<Paint, R>)
    return detail::mix_convex_ring(view_of(raster), std::span<const ring_point<Ring>>(ring),
                                   static_cast<pixel_of<R>>(paint), w);
  else if constexpr (RowRaster<R> && !CoverageBlendFunction<Paint, R>)
    return detail::mix_convex_areas(raster, ring, static_cast<pixel_of<R>>(paint), w);
  else
    return convex_coverage(ring, w, [&](const coverage_span& span) { blend_span(raster, span, paint); });
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <CompiledVertex V>
IRG_API bool send_convex_ring(std::span<const V> ring, const cell_window& w,
                              const function_ref<void(const coverage_span&)>& sink) {
  return send_convex_areas(ring, w, sink);
}

template <CompiledPixel P, CompiledVertex V>
IRG_API bool mix_convex_ring(const image_view<P>& raster, std::span<const V> ring, const P& value,
                             const cell_window& w) {
  image_view<P> target = raster;
  return mix_convex_areas(target, ring, value, w);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
