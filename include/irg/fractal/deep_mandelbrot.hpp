// SPDX-License-Identifier: MIT
// Deep zooms into the Mandelbrot set: one orbit with many digits, and every pixel as a small distance from it.
//
// With Z the orbit of the centre C and z = Z + d that of c = C + e:  d' = (2 Z + d) d + e, in doubles. Where |z| < |d|
// the difference has lost digits against z ("glitch"): from there on z itself is the distance, from the orbit's begin.
// So |Z| <= 2 |z| wherever a sum is used, and what a sum cancels is at most a bit or two.
#pragma once

#include <vector>

#include <irg/fractal/escape_picture.hpp>
#include <irg/math/double_double.hpp>
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

namespace detail {

// The numbers that distances are kept in.
template <class T>
concept PerturbedNumber = std::same_as<T, double> || std::same_as<T, double_double>;

inline namespace IRG_ABI {

template <class T>
IRG_INLINE constexpr T unfused_product(const T& a, const T& b) noexcept {
  if constexpr (Floating<T>)
    return product(a, b);
  else
    return a * b;
}
template <class T>
IRG_INLINE constexpr T squared_norm(const T& x, const T& y) noexcept {
  return unfused_product(x, x) + unfused_product(y, y);
}
template <class T, int N>
constexpr T rounded_fixed(const fixed_point<N>& x) noexcept {
  const auto high = static_cast<double>(x);
  if constexpr (std::same_as<T, double>)
    return high;
  else
    return {high, static_cast<double>(x - fixed_point<N>(high))};
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The orbit 0, c, c^2 + c, ... in doubles or double_doubles, computed with many digits: until beyond 2^20, or `most`
/// steps.
/// shape   reference_orbit(re, im, most), reference_orbit<double_double>(re, im, most); two points at least
/// needs   |re|, |im| < 2^30
/// exact   an error of some units of the last place, which grows as the orbit's derivative
/// cost    three products of N words a step; allocates the orbit
template <Real T = double, int N>
  requires detail::PerturbedNumber<T>
[[nodiscard]] constexpr std::vector<point<T, 2>> reference_orbit(const fixed_point<N>& re, const fixed_point<N>& im,
                                                                 int most) {
  std::vector<point<T, 2>> orbit(1, point<T, 2>{T(0), T(0)});
  fixed_point<N> x, y;
  for (int k = 0; k < most || k == 0; ++k) {
    const fixed_point<N> xy = x * y, difference = x * x - y * y;
    x = difference + re;
    y = xy + xy + im;
    orbit.push_back({detail::rounded_fixed<T>(x), detail::rounded_fixed<T>(y)});
    if (!(detail::squared_norm(orbit.back().x, orbit.back().y) < T(0x1p40))) break;
  }
  return orbit;
}

/// The count of the number at an offset from the orbit's own.
/// needs   an orbit of at least limit.most steps, or one that left, as reference_orbit gives it
/// gives   as mandelbrot_count
/// exact   each step rounds the distance, relative to its length: in doubles long orbits beside the border amplify that
///         into other counts, some tenths of a per cent of them; in double_doubles none were seen
/// cost    7 products a step; in double_doubles some 15 times as long
/// source  Martin 2013; Zhuoran 2021
template <Real T>
  requires detail::PerturbedNumber<T>
[[nodiscard]] constexpr perturbed_count perturbed_mandelbrot_count(const std::vector<point<T, 2>>& orbit,
                                                                   const point<T, 2>& offset,
                                                                   const escape_limit<double>& limit) noexcept {
  IRG_EXPECTS(orbit.size() >= 2);
  perturbed_count result{limit.most, 0};
  point<T, 2> d{T(0), T(0)};
  std::size_t m = 0;
  for (int k = 0; k < limit.most; ++k) {
    const T sx = orbit[m].x + orbit[m].x + d.x, sy = orbit[m].y + orbit[m].y + d.y;
    const auto times = [](const T& a, const T& b) { return detail::unfused_product(a, b); };
    d = {times(sx, d.x) - times(sy, d.y) + offset.x, times(sx, d.y) + times(sy, d.x) + offset.y};
    ++m;
    const T x = orbit[m].x + d.x, y = orbit[m].y + d.y, size = detail::squared_norm(x, y);
    if (!(size < T(limit.square))) {
      result.count = k;
      break;
    }
    if (size < detail::squared_norm(d.x, d.y) || (m + 1 == orbit.size() && k + 1 < limit.most)) {
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
/// exact   as perturbed_mandelbrot_count; draw_deep_mandelbrot<double_double>(counts, job) where single counts matter
/// cost    one orbit of many digits, and one of doubles for each pixel; allocates the first, and a number per row
/// source  Martin 2013; Zhuoran 2021
template <Real T = double, CountRaster R, int N, Executor E = sequential>
  requires detail::PerturbedNumber<T>
constexpr deep_escape_stats draw_deep_mandelbrot(R& counts, const deep_escape_job<N>& job, const E& executor = {}) {
  const int width = width_of(counts), height = height_of(counts);
  if (width < 1 || height < 1) return {};
  const auto orbit = reference_orbit<T>(job.re, job.im, job.limit.most);
  std::vector<std::int64_t> rebased(static_cast<std::size_t>(height), std::int64_t{0});
  executor(rebased.size(), [&](std::size_t i) {
    const int y = static_cast<int>(i);
    const double im = product((height - 1) * 0.5 - y, job.pixel);
    for (int x = 0; x < width; ++x) {
      const point<T, 2> offset{T(product(x - (width - 1) * 0.5, job.pixel)), T(im)};
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
