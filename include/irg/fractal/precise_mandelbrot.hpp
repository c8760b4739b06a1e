// SPDX-License-Identifier: MIT
// The Mandelbrot set in numbers of 106 bits, with a bound of the error beside each orbit: pictures 1e-13 to 1e-26 wide
// without an orbit of reference, and counts that are known to be true. What 106 bits cannot tell is computed again with
// 448 binary places.
#pragma once

#include <vector>

#include <irg/core/instructions.hpp>
#include <irg/fractal/escape_picture.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/fixed_point.hpp>

namespace irg {

/// A count, and whether no rounding can have changed it.
struct sure_count {
  int count = 0;
  bool is_sure = false;
  bool operator==(const sure_count&) const = default;
};

/// A picture of square pixels about a centre of 106 bits.
/// needs   a centre of size below 2^20
struct precise_escape_job {
  double_double re{}, im{};  // the centre
  double pixel = 0;  // the side of a pixel in the plane
  escape_limit<double> limit{};
  bool operator==(const precise_escape_job&) const = default;
};

/// What became of a precise picture's pixels.
struct precise_escape_counts {
  std::int64_t pixels = 0;  // all
  std::int64_t again = 0;  // computed with more digits
  std::int64_t unsure = 0;  // for which they were too few, too
  bool operator==(const precise_escape_counts&) const = default;
};

namespace detail::inline IRG_ABI {

// The square of 2^20, the largest radius that orbits in fixed_points are compared with.
inline constexpr double largest_fixed_square = 0x1p40;

// The orbit of 0 in numbers of type T. `rounded` bounds what a step rounds off, for |z|^2 + |z| + |c| of 1.
template <class T>
constexpr sure_count sure_orbit(const T& cx, const T& cy, const escape_limit<double>& limit, double rounded) noexcept {
  const T square(limit.square);
  const auto size_of = [](const T& a, const T& b) {
    return sqrt(squared_size(static_cast<double>(a), static_cast<double>(b))) * (1 + 0x1p-40);
  };
  const double c_size = size_of(cx, cy);
  T x{}, y{}, xx{}, yy{};
  double error = 0, z_size = 0;
  for (int k = 0; k < limit.most; ++k) {
    const T xy = x * y;
    x = xx - yy + cx;
    y = xy + xy + cy;
    error = (2 * z_size + error) * error + rounded * (z_size * z_size + z_size + c_size);
    z_size = size_of(x, y);
    // So far outside of the disc that the square may not fit a fixed_point.
    if (z_size > 0x1p30 && limit.square <= largest_fixed_square) return {k, error < 0.5 * z_size};
    xx = x * x;
    yy = y * y;
    const T beyond = xx + yy - square;
    const auto distant = static_cast<double>(beyond);
    const bool sure = magnitude(distant) >
                      ((2 * z_size + error) * error + rounded * (z_size * z_size + limit.square)) * (1 + 0x1p-30);
    if (!(distant < 0)) return {k, sure};
    if (!sure) return {k, false};
  }
  return {limit.most, true};
}

// What a step of each kind of number rounds off, in vectors: of double_doubles 5 * 2^-106 in a product, 3 in a sum.
inline constexpr double rounded_in_words = 0x1p-101;
inline constexpr int more_digits = 8;
inline constexpr double rounded_in_fixed = 0x1p-443;

template <class T>
constexpr fixed_point<more_digits> fixed_of(const T& v) noexcept {
  return fixed_point<more_digits>(v.high) + fixed_point<more_digits>(v.low);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// How many steps the orbit of 0 under z^2 + c takes, in numbers of 106 bits.
/// needs   |c| < 2^20 and a radius to 2^20, for a sure count
/// gives   as mandelbrot_count where it is sure; else the step at which a rounding might decide, and not sure. Nothing
///         is sure of NaN, or of an orbit that touches the disc's border
/// exact   what is sure is the count without any rounding
/// cost    some 15 times as long as in doubles
/// source  irg's own: an error e becomes 2 |z| e + e^2 and what the step rounds
template <class T = double_double>
[[nodiscard]] constexpr sure_count sure_mandelbrot_count(const point<T, 2>& c,
                                                         const escape_limit<double>& limit) noexcept {
  return detail::sure_orbit(c.x, c.y, limit, detail::rounded_in_words);
}

/// The counts of every pixel about a centre of 106 bits.
/// shape   a raster of integers of any size; the number of pixel (x, y) is the centre and the offset
///         ((x - (width - 1)/2) pixel, ((height - 1)/2 - y) pixel), each product rounded to a double
/// gives   the same for every executor; how many pixels took 448 binary places, and of how many the count may yet be
///         wrong: orbits of thousands of steps beside the border
/// exact   sure_mandelbrot_count, with 448 binary places where 106 bits are unsure and the radius is at most 2^20
/// cost    some 15 times as long as in doubles, ten times that for what is computed again; allocates a number per row
template <CountRaster R, Executor E = sequential>
constexpr precise_escape_counts draw_mandelbrot(R& counts, const precise_escape_job& job, const E& executor = {}) {
  const int width = width_of(counts), height = height_of(counts);
  if (width < 1 || height < 1) return {};
  const bool in_reach = magnitude(job.limit.square) <= detail::largest_fixed_square;
  std::vector<precise_escape_counts> of_row(static_cast<std::size_t>(height), precise_escape_counts{});
  executor(of_row.size(), [&](std::size_t i) {
    const int y = static_cast<int>(i);
    const double up = product((height - 1) * 0.5 - y, job.pixel);
    const double_double im = job.im + up;
    for (int x = 0; x < width; ++x) {
      const double right = product(x - (width - 1) * 0.5, job.pixel);
      const point<double_double, 2> c{job.re + right, im};  // the sum's rounding is less than a step's
      sure_count k = sure_mandelbrot_count(c, job.limit);
      if (!k.is_sure && in_reach && magnitude(c.x.high) < 0x1p20 && magnitude(c.y.high) < 0x1p20) {
        ++of_row[i].again;
        using fixed = fixed_point<detail::more_digits>;
        k = detail::sure_orbit(detail::fixed_of(job.re) + fixed(right), detail::fixed_of(job.im) + fixed(up), job.limit,
                               detail::rounded_in_fixed);
      }
      of_row[i].unsure += k.is_sure ? 0 : 1;
      set_pixel(counts, x, y, static_cast<pixel_of<R>>(k.count));
    }
  });
  precise_escape_counts stats{std::int64_t{width} * height, 0, 0};
  for (const precise_escape_counts& s : of_row) {
    stats.again += s.again;
    stats.unsure += s.unsure;
  }
  return stats;
}

}  // namespace IRG_ABI
}  // namespace irg
