// SPDX-License-Identifier: MIT
// Deep zooms into the Mandelbrot set: one orbit with many digits, and every pixel as a small distance from it.
//
// With Z the orbit of the centre C and z = Z + d that of c = C + e:  d' = (2 Z + d) d + e, in doubles. Where |z| < |d|
// the difference has lost digits against z ("glitch"): from there on z itself is the distance, from the orbit's begin.
// So |Z| <= 2 |z| wherever a sum is used, and what a sum cancels is at most a bit or two.
//
// Where |z| is within a few units of the last place of the radius, the sum Z + d cannot tell on which side: there the
// radius^2 - |Z|^2 that the many digits gave is compared with 2 Z.d + |d|^2, which is as precise as d.
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
  bool operator==(const deep_escape_job&) const = default;
};

/// What became of a deep picture's pixels.
struct deep_escape_counts {
  std::int64_t reference = 0;  // steps of the orbit with many digits
  std::int64_t rebased = 0;  // how often a glitch was detected, and cured
  bool operator==(const deep_escape_counts&) const = default;
};

/// A point Z of an orbit of many digits, and radius^2 - |Z|^2, both rounded at the end.
template <class T>
struct reference_point {
  T x{}, y{}, room{};
  bool operator==(const reference_point&) const = default;
};

/// A pixel's count, and how many glitches were cured on the way.
struct perturbed_count {
  int count = 0, rebased = 0;
  bool operator==(const perturbed_count&) const = default;
};

namespace detail::inline IRG_ABI {

// The numbers that distances are kept in.
template <class T>
concept PerturbedNumber = std::same_as<T, double> || std::same_as<T, double_double>;

template <class T, int N>
constexpr T rounded_fixed(const fixed_point<N>& x) noexcept {
  const auto high = static_cast<double>(x);
  if constexpr (std::same_as<T, double>)
    return high;
  else
    return {high, static_cast<double>(x - fixed_point<N>(high))};
}

// x^2 with all its 128 (N - 1) places, times 2^-64.
template <int N>
constexpr fixed_point<2 * N> whole_square(const fixed_point<N>& x) noexcept {
  return fixed_point<2 * N>::made_of(x.units * x.units);
}
// x^2 as the product of fixed_points has it, from all its places.
template <int N>
constexpr fixed_point<N> cut_square(const fixed_point<2 * N>& whole) noexcept {
  fixed_point<N> p;
  for (int i = 0; i < N; ++i) p.units.word[i] = whole.units.word[i + N - 1];
  return p;
}

// An orbit ends at the latest where its points are no factors of fixed_points any more. So the last one is shorter than
// 2^61, and what a point would be that follows upon it is longer than 2^59.
inline constexpr double last_square = 0x1p60, largest_room_square = 0x1p118;
// x less a part of it that is more than a sum of T rounds: a squared length below that is surely below x.
template <class T>
constexpr T surely_below(double x) noexcept {
  if constexpr (std::same_as<T, double>)
    return x * (1 - 0x1p-40);
  else
    return {x, x * -0x1p-90};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The orbit 0, c, c^2 + c, ... in doubles or double_doubles, computed with many digits: until beyond the radius and
/// beyond 2^20, or limit.most steps.
/// shape   reference_orbit(re, im, limit), reference_orbit<double_double>(re, im, limit); two points at least
/// needs   |re|, |im| < 2^30
/// exact   an error of some units of the last place, which grows as the orbit's derivative; with radii to 2^59 the room
///         to the radius is rounded from all its digits
/// cost    three products of N words a step; allocates the orbit
template <Real T = double, int N>
  requires detail::PerturbedNumber<T>
[[nodiscard]] constexpr std::vector<reference_point<T>> reference_orbit(const fixed_point<N>& re,
                                                                        const fixed_point<N>& im,
                                                                        const escape_limit<double>& limit) {
  std::vector<reference_point<T>> orbit(1, reference_point<T>{T(0), T(0), T(limit.square)});
  const bool is_near = limit.square < detail::largest_room_square;
  const double end = minimum(maximum(limit.square, 0x1p40), detail::last_square);
  const fixed_point<2 * N> square(is_near ? limit.square * 0x1p-64 : 0);
  fixed_point<N> x, y;
  fixed_point<2 * N> xx, yy;
  for (int k = 0; k < limit.most || k == 0; ++k) {
    const fixed_point<N> xy = x * y;
    x = detail::cut_square<N>(xx) - detail::cut_square<N>(yy) + re;
    y = xy + xy + im;
    xx = detail::whole_square(x), yy = detail::whole_square(y);
    reference_point<T> z{detail::rounded_fixed<T>(x), detail::rounded_fixed<T>(y), T(limit.square)};
    const T size = detail::squared_size(z.x, z.y);
    z.room = is_near ? detail::rounded_fixed<T>(square - (xx + yy)) * T(0x1p64) : z.room - size;
    orbit.push_back(z);
    if (!(size < T(end))) break;
  }
  return orbit;
}

/// The count of the number at an offset from the orbit's own.
/// needs   an orbit of this limit, as reference_orbit gives it
/// gives   as mandelbrot_count
/// exact   each step rounds the distance, relative to its length, and by that alone counts may differ: in doubles long
///         orbits beside the border amplify it into other counts, 2.8 % of those to 20000 steps at worst; in
///         double_doubles none were seen
/// cost    7 products a step; in double_doubles some 15 times as long
/// source  Martin 2013; Zhuoran 2021
template <Real T>
  requires detail::PerturbedNumber<T>
[[nodiscard]] constexpr perturbed_count perturbed_mandelbrot_count(const std::vector<reference_point<T>>& orbit,
                                                                   const point<T, 2>& offset,
                                                                   const escape_limit<double>& limit) noexcept {
  IRG_EXPECTS(orbit.size() >= 2);
  const T surely_inside = detail::surely_below<T>(limit.square);
  perturbed_count result{limit.most, 0};
  point<T, 2> d{T(0), T(0)};
  const reference_point<T>*const first = orbit.data(), *const last = first + (orbit.size() - 1), *at = first;
  for (int k = 0; k < limit.most; ++k) {
    const T sx = at->x + at->x + d.x, sy = at->y + at->y + d.y;
    d = {product(sx, d.x) - product(sy, d.y) + offset.x, product(sx, d.y) + product(sy, d.x) + offset.y};
    ++at;
    const T x = at->x + d.x, y = at->y + d.y, size = detail::squared_size(x, y);
    const T length = detail::squared_size(d.x, d.y);
    if (!(size < surely_inside)) {
      const T across = product(at->x, d.x) + product(at->y, d.y);
      const bool is_doubtful = length < size && product(size, detail::surely_below<T>(1)) < T(limit.square);
      if (!(is_doubtful ? across + across + length < at->room : size < T(limit.square))) {
        result.count = k;
        break;
      }
    }
    if (size < length || (at == last && k + 1 < limit.most)) {
      d = {x, y};
      at = first;
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
constexpr deep_escape_counts draw_deep_mandelbrot(R& counts, const deep_escape_job<N>& job, const E& executor = {}) {
  const int width = width_of(counts), height = height_of(counts);
  if (width < 1 || height < 1) return {};
  const auto orbit = reference_orbit<T>(job.re, job.im, job.limit);
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
  deep_escape_counts stats{static_cast<std::int64_t>(orbit.size()) - 1, 0};
  for (const std::int64_t n : rebased) stats.rebased += n;
  return stats;
}

}  // namespace IRG_ABI
}  // namespace irg
