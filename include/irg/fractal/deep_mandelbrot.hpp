// SPDX-License-Identifier: MIT
// Deep zooms into the Mandelbrot set: one orbit with many digits, and every pixel as a small distance from it.
//
// With Z the orbit of the centre C and z = Z + d that of c = C + e:  d' = (2 Z + d) d + e, in doubles. Where |z| < |d|
// the difference has lost digits against z ("glitch"): from there on z itself is the distance, from the orbit's begin.
// So |Z| <= 2 |z| wherever a sum is used, and what a sum cancels is at most a bit or two.
#pragma once

#include <vector>

#include <irg/fractal/escape_picture.hpp>
#include <irg/math/fixed_point.hpp>

namespace irg {

/// A deep picture: its pixels are squares, and their middle is the centre.
/// needs   a centre of size below 2^30; pixels of 2^70 units of the centre's last place or more, and of 2^-450 or more
template <int N>
struct deep_escape_job {
  fixed_point<N> re{}, im{};  // the centre
  double pixel = 0;  // the side of a pixel in the plane
  escape_limit<double> limit{};
};

/// What became of a deep picture's pixels.
struct deep_escape_stats {
  std::int64_t reference = 0;  // steps of the orbit with many digits
  std::int64_t rebased = 0;  // how often a glitch was detected, and cured
  constexpr bool operator==(const deep_escape_stats&) const = default;
};

/// A pixel's count, and how many glitches were cured on the way.
struct perturbed_count {
  int count = 0, rebased = 0;
  constexpr bool operator==(const perturbed_count&) const = default;
};

inline namespace IRG_ABI {

/// The orbit 0, c, c^2 + c, ... in doubles, computed with many digits: until beyond 2^20, or `most` steps.
/// shape   two points at least
/// needs   |re|, |im| < 2^30
/// exact   an error of some units of the last place, which grows as the orbit's derivative
/// cost    three products of N words a step; allocates the orbit
template <int N>
constexpr std::vector<point<double, 2>> reference_orbit(const fixed_point<N>& re, const fixed_point<N>& im, int most) {
  std::vector<point<double, 2>> orbit(1, point<double, 2>{0, 0});
  fixed_point<N> x, y;
  for (int k = 0; k < most || k == 0; ++k) {
    const fixed_point<N> xy = x * y, difference = x * x - y * y;
    x = difference + re;
    y = xy + xy + im;
    orbit.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (!(detail::squared_size(orbit.back().x, orbit.back().y) < 0x1p40)) break;
  }
  return orbit;
}

/// The count of the number at an offset from the orbit's own.
/// needs   an orbit of at least limit.most steps, or one that left, as reference_orbit gives it
/// gives   as mandelbrot_count
/// exact   in doubles, but relative to the distance: digits are lost only as the orbit itself loses them
/// cost    7 products a step
/// source  Martin 2013; Zhuoran 2021
template <Floating T>
constexpr perturbed_count perturbed_mandelbrot_count(const std::vector<point<T, 2>>& orbit, const point<T, 2>& offset,
                                                     const escape_limit<T>& limit) noexcept {
  IRG_EXPECTS(orbit.size() >= 2);
  perturbed_count result{limit.most, 0};
  point<T, 2> d{T(0), T(0)};
  std::size_t m = 0;
  for (int k = 0; k < limit.most; ++k) {
    const T sx = orbit[m].x + orbit[m].x + d.x, sy = orbit[m].y + orbit[m].y + d.y;
    d = {product(sx, d.x) - product(sy, d.y) + offset.x, product(sx, d.y) + product(sy, d.x) + offset.y};
    ++m;
    const T x = orbit[m].x + d.x, y = orbit[m].y + d.y, size = detail::squared_size(x, y);
    if (!(size < limit.square)) {
      result.count = k;
      break;
    }
    if (size < detail::squared_size(d.x, d.y) || (m + 1 == orbit.size() && k + 1 < limit.most)) {
      d = {x, y};
      m = 0;
      ++result.rebased;
    }
  }
  return result;
}

/// The counts of the Mandelbrot set in every pixel about a centre of many digits.
/// shape   a raster of integers of any size; the number of pixel (x, y) is the centre and the offset
///         ((x - (width - 1)/2) pixel, ((height - 1)/2 - y) pixel), rounded
/// gives   the same for every executor
/// exact   as perturbed_mandelbrot_count
/// cost    one orbit of many digits, and one of doubles for each pixel; allocates the first, and a number per row
/// source  Martin 2013; Zhuoran 2021
template <CountRaster R, int N, Executor E = sequential>
constexpr deep_escape_stats draw_deep_mandelbrot(R& counts, const deep_escape_job<N>& job, const E& executor = {}) {
  const int width = width_of(counts), height = height_of(counts);
  if (width < 1 || height < 1) return {};
  const auto orbit = reference_orbit(job.re, job.im, job.limit.most);
  std::vector<std::int64_t> rebased(static_cast<std::size_t>(height), std::int64_t{0});
  executor(rebased.size(), [&](std::size_t i) {
    const int y = static_cast<int>(i);
    const double im = product((height - 1) * 0.5 - y, job.pixel);
    for (int x = 0; x < width; ++x) {
      const point<double, 2> offset{product(x - (width - 1) * 0.5, job.pixel), im};
      const perturbed_count c = perturbed_mandelbrot_count(orbit, offset, job.limit);
      set_pixel(counts, x, y, static_cast<pixel_of<R>>(c.count));
      rebased[i] += c.rebased;
    }
  });
  deep_escape_stats stats{static_cast<std::int64_t>(orbit.size()) - 1, 0};
  for (const std::int64_t n : rebased) stats.rebased += n;
  return stats;
}

}  // namespace IRG_ABI
}  // namespace irg
