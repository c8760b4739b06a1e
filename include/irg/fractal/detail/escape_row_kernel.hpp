// SPDX-License-Identifier: MIT
// The counts of one row of pixels.
#pragma once

#include <bit>
#include <cstdint>
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

// One row, pixel by pixel, for constant evaluation.
template <class T, class Orbits, class P>
constexpr escape_stats escape_row_plainly(P* row, int y, const escape_job<T>& job, const Orbits& orbits) {
  escape_stats stats{job.plane.width, 0, 0};
  const bool skips = skips_interior<Orbits>(job);
  for (int x = 0; x < job.plane.width; ++x) {
    const point<T, 2> at = job.plane.at(x, y);
    const bool known = skips && mandelbrot_part_of(at) != mandelbrot_part::elsewhere;
    stats.interior += known;
    row[x] = static_cast<P>(known ? job.limit.most : orbits(at, job.limit));
  }
  return stats;
}

// One row in lanes; those past its end have left before they begin.
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
  escape_stats stats{job.plane.width, 0, 0};
  for (std::int64_t x = 0; x < job.plane.width; x += kernel::count) {
    kernel k;
    const int here = static_cast<int>(lesser<std::int64_t>(kernel::count, job.plane.width - x));
    for (unsigned p = 0; p < packs; ++p) {
      using number = typename lanes<mask>::scalar;
      const mask in_row =
          lanes<mask>::ramp() < lanes<mask>::broadcast(static_cast<number>(here - static_cast<int>(p) * f::count));
      const F real = job.plane.real(f::ramp() + f::broadcast(static_cast<T>(x + static_cast<int>(p) * f::count)));
      orbits.begin(real, imaginary, k.x[p], k.y[p], k.cx[p], k.cy[p]);
      k.inside[p] = in_row;
      k.counts[p] = lanes<mask>::broadcast(0);
      if (!skips) continue;
      const mask inner =
          in_row & ((outside_cardioid(real, imaginary) < margin) | (outside_disc(real, imaginary) < margin));
      stats.interior += std::popcount(mask_bits(inner));
      k.inside[p] = in_row & ~inner;
      k.counts[p] = select(inner, lanes<mask>::broadcast(job.limit.most), k.counts[p]);
    }
    stats.cycles += k.run(job.limit, job.skip.cycles == skipping::on);
    for (int i = 0; i < here; ++i)
      row[x + i] = static_cast<P>(lane(k.counts[static_cast<unsigned>(i / f::count)], i % f::count));
  }
  return stats;
}

template <class T, class Orbits, class P>
constexpr escape_stats escape_row(P* row, int y, const escape_job<T>& job, const Orbits& orbits) {
  if (std::is_constant_evaluated()) return escape_row_plainly(row, y, job, orbits);
  return escape_row_in_lanes(row, y, job, orbits);
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
