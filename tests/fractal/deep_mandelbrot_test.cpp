// SPDX-License-Identifier: MIT
#include <irg/fractal/deep_mandelbrot.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>

#include <irg/core/threads.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#ifdef IRG_HAVE_MPFR
#include "support/fixed_point_mpfr.hpp"
#endif

using irg::deep_escape_job;
using irg::draw_deep_mandelbrot;
using irg::fixed_point;
using irg::image;
using irg::make_escape_limit;

namespace {

using digits = fixed_point<6>;
using deep_job = deep_escape_job<6>;

// A place near the border: from picture to picture, half as wide, to one that stays long, but no
// longer than a bound that grows slowly: there the border is always in the picture.
deep_job descended(test::random& r, double width, int pixels, int most) {
  deep_job job{digits(-0.5), digits(0.0), 0.25, make_escape_limit(2.0, most)};
  for (int bound = 20; job.pixel * pixels > width; job.pixel /= 2, bound += 8) {
    job.limit.most = bound;
    image<int> counts(9, 9);
    draw_deep_mandelbrot(counts, job);
    int best = -1, at_x = 4, at_y = 4;
    for (int i = 0; i < 40; ++i) {
      const int x = static_cast<int>(r.integer(0, 8)), y = static_cast<int>(r.integer(0, 8));
      if (counts(x, y) < bound && counts(x, y) > best) {
        best = counts(x, y);
        at_x = x;
        at_y = y;
      }
    }
    job.re = job.re + digits((at_x - 4) * job.pixel);
    job.im = job.im + digits((4 - at_y) * job.pixel);
  }
  job.limit.most = most;
  return job;
}

bool is_release_tier() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

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
    test::set_to_fixed_point(cx, job.re);
    test::set_to_fixed_point(cy, job.im);
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

template <class T = double>
int wrong_counts(const deep_job& job, int pixels) {
  image<int> counts(pixels, pixels);
  irg::draw_deep_mandelbrot<T>(counts, job);
  big_orbit oracle;
  int wrong = 0, least = job.limit.most, greatest = 0;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const double right = (x - (pixels - 1) * 0.5) * job.pixel, up = ((pixels - 1) * 0.5 - y) * job.pixel;
      const int k = oracle.count(job, right, up);
      wrong += counts(x, y) != k;
      least = k < least ? k : least;
      greatest = k > greatest ? k : greatest;
    }
  return least < greatest ? wrong : -1;  // one colour is no picture
}
#endif

}  // namespace

#ifdef IRG_HAVE_MPFR
TEST_CASE("draw_deep_mandelbrot: the counts of MPFR, at widths down to 1e-80") {
  test::random r(11);
  for (const double width : {1e-2, 1e-13, 1e-24, 1e-50, 1e-80}) {
    const int pixels = is_release_tier() ? 64 : 9;
    const deep_job job = descended(r, width, pixels, is_release_tier() ? 20000 : 3000);
    const int wrong = wrong_counts<irg::double_double>(job, pixels);
    CHECK_MESSAGE(wrong == 0, "width " << width << ": " << wrong << " of counts to " << job.limit.most);
    // Doubles are rounded more than orbits of thousands of steps forgive.
    const int rounded = wrong_counts(job, pixels);
    CHECK(rounded >= 0);
    CHECK(rounded <= (is_release_tier() ? pixels * pixels / 20 : 0));
    MESSAGE("width ", width, ": ", rounded, " of ", pixels * pixels, " counts differ in doubles");
  }
}

TEST_CASE("draw_deep_mandelbrot: about i, whose orbit stays on the border, and off the set") {
  for (const double pixel : {1e-3, 1e-20, 1e-50, 1e-85}) {
    CHECK(wrong_counts({digits(0.0), digits(1.0), pixel, make_escape_limit(2.0, 2000)}, 7) == 0);
    CHECK(wrong_counts({digits(-2.0), digits(pixel / 3), pixel, make_escape_limit(100.0, 2000)}, 7) == 0);
  }
  CHECK(wrong_counts({digits(-0.5), digits(0.0), 0.5, make_escape_limit(2.0, 200)}, 9) == 0);  // centre in the set
  CHECK(wrong_counts({digits(3.0), digits(1.0), 0.75, make_escape_limit(5.0, 200)}, 9) == 0);  // centre far outside
  CHECK(wrong_counts({digits(0.5), digits(0.5), 0.25, make_escape_limit(0.7, 200)}, 9) == 0);
}
#endif

TEST_CASE("draw_deep_mandelbrot: glitches are met and cured, the same in threads") {
  test::random r(5);
  const deep_job job = descended(r, 1e-20, 41, 4000);
  image<int> alone(41, 23), together(41, 23);
  const auto stats = draw_deep_mandelbrot(alone, job);
  CHECK(stats.rebased > 0);
  CHECK(stats.reference > 10);
  CHECK(draw_deep_mandelbrot(together, job, irg::parallel{3}) == stats);
  CHECK(alone == together);
}

TEST_CASE("draw_deep_mandelbrot: degenerate pictures") {
  constexpr auto one = [](double re, double pixel, double radius, int most) {
    image<int> counts(1, 1);
    draw_deep_mandelbrot(counts, deep_job{digits(re), digits(0.0), pixel, make_escape_limit(radius, most)});
    return counts(0, 0);
  };
  static_assert(one(0.3, 0, 100, 16) == 14 && one(1, 0, 100, 16) == 4 && one(0, 1, 2, 40) == 40);
  CHECK_BOTH(one(-2, 0, 100, 16) == 16);
  CHECK_BOTH(one(0, 0, 2, 0) == 0);
  CHECK_BOTH(one(0, 0, 0, 9) == 0);
  CHECK_BOTH(one(1e9, 0, 2, 9) == 0);
  CHECK(one(0.3, std::numeric_limits<double>::quiet_NaN(), 2, 9) == 0);
  image<int> none(0, 5);
  CHECK(draw_deep_mandelbrot(none, deep_job{}) == irg::deep_escape_stats{});
}
