// SPDX-License-Identifier: MIT
// The pixels of a convex polygon: those whose centre lies inside, or on a top or left edge (triangle_coverage.hpp has
// the rule). Decided exactly, so polygons that tile a region have each of its pixels exactly once.
//
// Two edges are walked at a time, one down each side of the ring; the run between them is the polygon's row. That
// serves every ring that no level line crosses more than twice, convex or not; other rings are for fill_polygon.hpp.
#pragma once

#include <cstddef>
#include <span>

#include <irg/core/function_ref.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/convex_fill_kernel.hpp>
#include <irg/raster/detail/compiled_rasters.hpp>
#include <irg/raster/fill_span.hpp>

namespace irg::inline IRG_ABI {

/// Calls sink(span) for every row of covered pixels in the window, from top to bottom, one span a row.
/// units   floating vertices in pixels, snapped to 1/256 as by snap(); subpixel vertices as they are
/// needs   no level line crosses the ring more than twice, as with every convex ring; either orientation
/// gives   false and no span when a vertex is NaN, infinite or more than far_limit pixels from the origin; else true.
///         No span for rings of less than 3 vertices or without area. Of a ring that does not meet the need, at most
///         one span a row, from one of its edges to another
/// exact   coverage is decided without rounding after the vertices are snapped
/// cost    one division per edge that crosses a row of the window; nothing is allocated
template <FillableRing Ring, SpanSink Sink>
constexpr bool convex_spans(const Ring& ring, const cell_window& window, Sink&& sink) {
  const auto send = [&](int y, int first, int last) { sink(span_of_cells{y, first, last}); };
  if constexpr (detail::draws_in_library && detail::CompiledRing<Ring>)
    return detail::send_ring_runs(std::span<const ring_point<Ring>>(ring), window,
                                  as_function<void(int, int, int)>(send));
  else
    return detail::walk_ring(ring, window, send);
}

/// Paints the pixels of a convex polygon, each once.
/// gives   false, and nothing painted, when a vertex is NaN, infinite or more than far_limit pixels from the origin
template <WritableRaster R, FillableRing Ring, PaintFor<R> Paint = pixel_of<R>>
constexpr bool fill_convex(R& raster, const Ring& ring, const Paint& paint) {
  decltype(auto) prepared = detail::prepared_paint<R>(paint);
  if constexpr (detail::draws_in_library && detail::CompiledRaster<R> && detail::CompiledRing<Ring> &&
                !BlendFunction<Paint, R>) {
    return detail::paint_ring_runs(view_of(raster), std::span<const ring_point<Ring>>(ring), prepared,
                                   window_of(raster));
  } else {
    const std::ptrdiff_t ahead = detail::bytes_to_row_below(raster);
    return detail::walk_ring(ring, window_of(raster), [&](int y, int first, int last) {
      detail::paint_run(raster, y, first, last, prepared, ahead);
    });
  }
}

/// Paints the pixels of a triangle, each once.
/// shape   in bare braces corners in pixels, as doubles
/// gives   as fill_convex does
template <WritableRaster R, class P = point<double, 2>, PaintFor<R> Paint = pixel_of<R>>
  requires FillableRing<P[3]>
constexpr bool fill_triangle(R& raster, const P& a, const P& b, const P& c, const Paint& paint) {
  const P corners[3] = {a, b, c};
  return fill_convex(raster, corners, paint);
}

}  // namespace irg::inline IRG_ABI
