// SPDX-License-Identifier: MIT
// The counts of one row of pixels.
#pragma once

#include <bit>
#include <type_traits>

#include <irg/fractal/detail/escape_kernel.hpp>
#include <irg/fractal/escape_job.hpp>
#include <irg/fractal/julia.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// What differs between the two pictures of z^2 + c: which of z and c is the pixel.
template <class T>
struct mandelbrot_orbits {
  static constexpr bool has_interior = true;
  IRG_INLINE constexpr int operator()(const point<T, 2>& at, const escape_limit<T>& limit) const noexcept {
    return mandelbrot_count(at, limit);
  }
  template <class F>
  IRG_INLINE void begin(const F& real, const F& imaginary, F& x, F& y, F& cx, F& cy) const noexcept {
    x = y = lanes<F>::broadcast(T(0));
    cx = real;
    cy = imaginary;
  }
};
template <class T>
struct julia_orbits {
  static constexpr bool has_interior = false;
  point<T, 2> c;
  IRG_INLINE constexpr int operator()(const point<T, 2>& at, const escape_limit<T>& limit) const noexcept {
    return julia_count(at, c, limit);
  }
  template <class F>
  IRG_INLINE void begin(const F& real, const F& imaginary, F& x, F& y, F& cx, F& cy) const noexcept {
    x = real;
    y = imaginary;
    cx = lanes<F>::broadcast(c.x);
    cy = lanes<F>::broadcast(c.y);
  }
};

// Whether points of the cardioid and the disc need no orbit: theirs stay in |z| <= 2, but may leave a smaller disc.
template <class Orbits, class T>
constexpr bool skips_interior(const escape_job<T>& job) noexcept {
  return Orbits::has_interior && job.skip.interior == skipping::on && T(4) <= job.limit.square;
}

// One row, pixel by pixel.
template <class T, class Orbits, class P>
constexpr escape_stats escape_row_plainly(P* row, int y, int x_first, const escape_job<T>& job, const Orbits& orbits) {
  escape_stats stats{job.plane.width - x_first, 0, 0};
  const bool skips = skips_interior<Orbits>(job);
  for (int x = x_first; x < job.plane.width; ++x) {
    const point<T, 2> at = job.plane.at(x, y);
    const bool known = skips && mandelbrot_part_of(at) != mandelbrot_part::elsewhere;
    stats.interior += known;
    row[x] = static_cast<P>(known ? job.limit.most : orbits(at, job.limit));
  }
  return stats;
}

// One row in lanes, and what is left of it pixel by pixel.
template <class T, class Orbits, class P>
IRG_NOINLINE escape_stats escape_row_in_lanes(P* row, int y, const escape_job<T>& job, const Orbits& orbits) {
  using F = pack<T, widest_lanes<T>>;
  using f = lanes<F>;
  constexpr unsigned packs = sizeof(F) == 64 ? 4 : 2;
  using kernel = escape_kernel<F, packs>;
  using mask = typename kernel::mask;
  const bool skips = skips_interior<Orbits>(job);
  const F margin = f::broadcast(T(0) - static_cast<T>(interior_margin)),
          imaginary = f::broadcast(job.plane.imaginary(static_cast<T>(y)));
  escape_stats stats;
  int x = 0;
  for (; job.plane.width - x >= kernel::count; x += kernel::count) {
    kernel k;
    int known = 0;
    for (unsigned p = 0; p < packs; ++p) {
      const F real = job.plane.real(f::ramp() + f::broadcast(static_cast<T>(x + static_cast<int>(p) * f::count)));
      orbits.begin(real, imaginary, k.x[p], k.y[p], k.cx[p], k.cy[p]);
      k.inside[p] = lanes<mask>::broadcast(-1);
      k.counts[p] = lanes<mask>::broadcast(0);
      if (!skips) continue;
      const mask inner = (outside_cardioid(real, imaginary) < margin) | (outside_disc(real, imaginary) < margin);
      known += std::popcount(mask_bits(inner));
      k.inside[p] = ~inner;
      k.counts[p] = select(inner, lanes<mask>::broadcast(job.limit.most), k.counts[p]);
    }
    stats += {kernel::count, known, k.run(job.limit, job.skip.cycles == skipping::on)};
    for (unsigned p = 0; p < packs; ++p)
      for (int i = 0; i < f::count; ++i)
        row[x + static_cast<int>(p) * f::count + i] = static_cast<P>(lane(k.counts[p], i));
  }
  return stats += escape_row_plainly(row, y, x, job, orbits);
}

template <class T, class Orbits, class P>
constexpr escape_stats escape_row(P* row, int y, const escape_job<T>& job, const Orbits& orbits) {
  if (std::is_constant_evaluated()) return escape_row_plainly(row, y, 0, job, orbits);
  return escape_row_in_lanes(row, y, job, orbits);
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
