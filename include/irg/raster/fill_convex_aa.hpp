// SPDX-License-Identifier: MIT
// Convex polygons with smooth edges: the coverage of a pixel is the area of the polygon within it.
//
// Edges that two polygons share stay visible as seams, because coverage is used as opacity: half of one colour and then
// half of the next leave a quarter of what was there before. Where polygons tile a region, fill_convex.hpp is right.
#pragma once

#include <irg/core/sinks.hpp>
#include <irg/raster/blend_span.hpp>
#include <irg/raster/detail/area_ring_kernel.hpp>

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
constexpr bool convex_coverage(const Ring& ring, const cell_window& window, Sink&& sink) {
  return detail::send_convex_areas(ring, window, sink);
}

/// Paints a convex polygon, each pixel as far as it is covered.
/// gives   false, and nothing painted, when a vertex is NaN, infinite or more than snap_limit pixels from the origin
/// exact   the pixels that convex_coverage and blend_span make
template <WritableRaster R, FillableRing Ring, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool fill_convex_aa(R& raster, const Ring& ring, const Paint& paint) {
  const cell_window w = window_of(raster);
  if constexpr (RowRaster<R> && !CoverageBlendFunction<Paint, R>)
    return detail::mix_convex_areas(raster, ring, static_cast<pixel_of<R>>(paint), w);
  else
    return convex_coverage(ring, w, [&](const coverage_span& span) { blend_span(raster, span, paint); });
}

}  // namespace IRG_ABI
}  // namespace irg
