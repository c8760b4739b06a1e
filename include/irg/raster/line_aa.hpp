// SPDX-License-Identifier: MIT
// line_aa: the exact area that a line of a given width covers of each pixel.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/detail/line_aa_shape.hpp>
#include <irg/raster/detail/line_aa_steps.hpp>
#include <irg/raster/detail/line_aa_writers.hpp>
#include <irg/raster/detail/snapped_line.hpp>

namespace irg {

inline namespace IRG_ABI {

/// Calls sink(coverage_span) for runs of pixels of the line's rectangle that lie in the window.
/// shape   the rectangle from a to b, half the width to either side, with the caps that the options say; each pixel in
///         at most one run, runs of at most 256 pixels, row by row; pixels at a run's ends may have coverage 0
/// needs   coordinates within snap_limit pixels, 0 < width <= max_line_aa_width
/// gives   false and no call otherwise; no call for a zero-length line with butt caps, a square with square ones
/// exact   coverage is 255 times the area of pixel and rectangle, rounded to an integer; it is at most 1/2 + 1/64 from
///         that, so each pixel is within 1/256 of its area. A clipped line has the unclipped line's coverages; mirrored
///         lines and lines moved by whole pixels have mirrored and moved ones; a to b has those of b to a
/// cost    a square root and a few divisions; then rows and pixels in the window only
/// source  Catmull 1978 for coverage as area; Green's theorem for the sum over edges
template <CoverageSink Sink>
constexpr bool line_aa(const subpixel& a, const subpixel& b, const cell_window& window, Sink&& sink,
                       const line_aa_options& options = {}) {
  if (!detail::aa_can_draw(a, b, options.width)) return false;
  if (std::is_constant_evaluated()) {
    detail::aa_span_writer<float, std::remove_reference_t<Sink>> writer{sink};
    if (!detail::aa_draw_slender(a, b, options, window, writer)) detail::aa_line(a, b, options, window, writer);
  } else {
    detail::aa_span_writer<detail::aa_lanes, std::remove_reference_t<Sink>> writer{sink};
    if (!detail::aa_draw_slender(a, b, options, window, writer)) detail::aa_line(a, b, options, window, writer);
  }
  return true;
}

/// Mixes the paint into the pixels of the line from a to b, as far as each is covered.
/// gives   false and nothing drawn when a coordinate is NaN or infinite or the width is out of range
/// exact   the coverages of line_aa; pixels as by paint_pixel, those of coverage 0 keep their value. A line that ends
///         beyond snap_limit is cut there first, which moves it by at most 1/512 pixel on each axis
template <WritableRaster R, ScreenPosition P, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_aa(R& raster, const P& a, const P& b, const Paint& paint,
                            const line_aa_options& options = {}) {
  const auto [finite, in_reach, from, to] = detail::snap_line(a, b);
  if (!finite || !detail::aa_can_draw(from, to, options.width)) return false;
  if (!in_reach) return true;
  const cell_window w = window_of(raster);
  if constexpr (RowRaster<R> && detail::mixes_in_lanes<pixel_of<R>> && !CoverageBlendFunction<Paint, R>) {
    if (!std::is_constant_evaluated()) {
      detail::aa_mix_line(raster, from, to, static_cast<pixel_of<R>>(paint), options, w);
      return true;
    }
  }
  const auto blend = [&](const coverage_span& s) {
    for (int x = s.x_first; x < s.x_last; ++x) paint_pixel(raster, x, s.y, paint, s.coverage[x - s.x_first]);
  };
  return line_aa(from, to, w, blend, options);
}

}  // namespace IRG_ABI
}  // namespace irg
