// SPDX-License-Identifier: MIT
// blend_span: paint over a run of pixels that are covered in part. The innermost kernel of every anti-aliased line and
// fill.
#pragma once

#include <cstddef>

#include <irg/core/sinks.hpp>
#include <irg/raster/detail/mix_kernel.hpp>
#include <irg/raster/fill_span.hpp>

namespace irg::inline IRG_ABI {

/// Paints those pixels of a run that lie in the raster, each as far as its coverage says: a value is mixed in
/// (colour/mix.hpp), a function f(there, coverage) is called once for each pixel whose coverage is not 0.
/// shape   span.coverage points to one coverage for each column of the span, or is null: all are 255
/// gives   nothing when the span is empty or misses the raster; pixels of coverage 0 keep their value
/// exact   the same bytes from the plain loop and from lanes
/// cost    rows of pixels of four 8-bit channels: a register at a time; runs without coverages: as fill_span
template <WritableRaster R, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr void blend_span(R& raster, const coverage_span& span, const Paint& paint) {
  const cell_window w = window_of(raster);
  if (span.y < w.y_first || span.y >= w.y_last) return;
  const int first = maximum(span.x_first, w.x_first);
  const int last = minimum(span.x_last, w.x_last);
  if (first >= last) return;
  if constexpr (CoverageBlendFunction<Paint, R>) {
    for (int x = first; x < last; ++x)
      paint_pixel(raster, x, span.y, paint,
                  span.coverage == nullptr ? std::uint8_t{255} : span.coverage[std::int64_t{x} - span.x_first]);
  } else {
    const pixel_of<R> value = static_cast<pixel_of<R>>(paint);
    if (span.coverage == nullptr) return fill_span(raster, {span.y, first, last}, value);
    const std::uint8_t* const coverage = span.coverage + (std::int64_t{first} - span.x_first);
    if constexpr (RowRaster<R>)
      mix_pixels(raster_traits<R>::row(raster, span.y) + first, static_cast<std::size_t>(last - first), coverage,
                 value);
    else
      for (int x = first; x < last; ++x) paint_pixel(raster, x, span.y, value, coverage[x - first]);
  }
}

}  // namespace irg::inline IRG_ABI
