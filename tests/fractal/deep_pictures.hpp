// SPDX-License-Identifier: MIT
// Deep pictures of the border of the Mandelbrot set, and their true counts.
#pragma once

#include <irg/fractal/deep_mandelbrot.hpp>
#include <irg/raster/image.hpp>

#include "support/random.hpp"
#ifdef IRG_HAVE_MPFR
#include "support/fixed_point_mpfr.hpp"
#endif

namespace test {

using deep_digits = irg::fixed_point<6>;
using deep_job = irg::deep_escape_job<6>;

// A place near the border: from picture to picture, half as wide, to one that stays long, but no
// longer than a bound that grows slowly: there the border is always in the picture.
inline deep_job descended(random& r, double width, int pixels, int most) {
  deep_job job{deep_digits(-0.5), deep_digits(0.0), 0.25, irg::make_escape_limit(2.0, most)};
  for (int bound = 20; job.pixel * pixels > width; job.pixel /= 2, bound += 8) {
    job.limit.most = bound;
    irg::image<int> counts(9, 9);
    irg::draw_deep_mandelbrot(counts, job);
    int best = -1, at_x = 4, at_y = 4;
    for (int i = 0; i < 40; ++i) {
      const int x = static_cast<int>(r.integer(0, 8)), y = static_cast<int>(r.integer(0, 8));
      if (counts(x, y) < bound && counts(x, y) > best) {
        best = counts(x, y);
        at_x = x;
        at_y = y;
      }
    }
    job.re = job.re + deep_digits((at_x - 4) * job.pixel);
    job.im = job.im + deep_digits((4 - at_y) * job.pixel);
  }
  job.limit.most = most;
  return job;
}

#ifdef IRG_HAVE_MPFR
// Counts of numbers of 500 bits.
class big_orbit {
public:
  big_orbit() {
    for (mpfr_ptr v : all) mpfr_init2(v, 500);
  }
  ~big_orbit() {
    for (mpfr_ptr v : all) mpfr_clear(v);
  }
  big_orbit(const big_orbit&) = delete;
  big_orbit& operator=(const big_orbit&) = delete;

  int count(const deep_job& job, double right, double up) {
    set_to_fixed_point(cx, job.re);
    set_to_fixed_point(cy, job.im);
    mpfr_add_d(cx, cx, right, MPFR_RNDN);
    mpfr_add_d(cy, cy, up, MPFR_RNDN);
    for (mpfr_ptr v : {x, y, xx, yy}) mpfr_set_zero(v, 1);
    for (int k = 0; k < job.limit.most; ++k) {
      mpfr_mul(y, x, y, MPFR_RNDN);
      mpfr_mul_2ui(y, y, 1, MPFR_RNDN);
      mpfr_add(y, y, cy, MPFR_RNDN);
      mpfr_sub(x, xx, yy, MPFR_RNDN);
      mpfr_add(x, x, cx, MPFR_RNDN);
      mpfr_sqr(xx, x, MPFR_RNDN);
      mpfr_sqr(yy, y, MPFR_RNDN);
      mpfr_add(size, xx, yy, MPFR_RNDN);
      if (mpfr_cmp_d(size, job.limit.square) >= 0) return k;
    }
    return job.limit.most;
  }

private:
  mpfr_t cx, cy, x, y, xx, yy, size;
  mpfr_ptr all[7] = {cx, cy, x, y, xx, yy, size};
};
#endif

}  // namespace test
