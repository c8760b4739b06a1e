// SPDX-License-Identifier: MIT
// Escape counts of every pixel: of the Mandelbrot set, of a Julia set.
#pragma once

#include <concepts>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/fractal/detail/escape_row_kernel.hpp>

namespace irg {

/// A raster of counts.
template <class R>
concept CountRaster = RowRaster<R> && std::integral<pixel_of<R>> && (sizeof(pixel_of<R>) >= 2);

namespace detail {
inline namespace IRG_ABI {

template <class R, class T, class Orbits, class E>
constexpr escape_stats draw_counts_of(R& counts, const escape_job<T>& job, const Orbits& orbits, const E& executor) {
  IRG_EXPECTS(width_of(counts) == job.plane.width && height_of(counts) == job.plane.height);
  constexpr int band = 16;  // rows of a task
  const int height = height_of(counts);
  std::vector<escape_stats> of_band(static_cast<std::size_t>((height + band - 1) / band), escape_stats{});
  executor(of_band.size(), [&](std::size_t i) {
    const int first = static_cast<int>(i) * band, last = lesser(first + band, height);
    const auto row_at = [&](int y) { return raster_traits<R>::row(counts, y); };
    of_band[i] = escape_band<pixel_of<R>>(row_at, first, last, job, orbits);
  });
  escape_stats stats;
  for (const escape_stats& s : of_band) stats += s;
  return stats;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The counts of the Mandelbrot set in every pixel, and what was skipped.
/// shape   a raster of the plane's width and height, whose pixels hold numbers up to the limit's `most`
/// exact   those of mandelbrot_count of the pixel's number, with skips on and off, in lanes and one by one
/// cost    the orbits; allocates a few numbers per row
/// source  Mandelbrot 1980; Brent 1980 for cycles
template <CountRaster R, Floating T, Executor E = sequential>
constexpr escape_stats draw_mandelbrot(R& counts, const escape_job<T>& job, const E& executor = {}) {
  return detail::draw_counts_of(counts, job, detail::mandelbrot_orbits<T>{}, executor);
}

/// The counts of the Julia set of z^2 + c in every pixel, and what was skipped.
/// shape   as draw_mandelbrot
/// exact   those of julia_count of the pixel's number, with skips on and off, in lanes and one by one
template <CountRaster R, Floating T, Executor E = sequential>
constexpr escape_stats draw_julia(R& counts, const escape_job<T>& job, const point<T, 2>& c, const E& executor = {}) {
  return detail::draw_counts_of(counts, job, detail::julia_orbits<T>{c}, executor);
}

}  // namespace IRG_ABI
}  // namespace irg
