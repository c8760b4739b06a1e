// SPDX-License-Identifier: MIT
#include <irg/fractal/precise_mandelbrot.hpp>

#include <cstdlib>
#include <limits>

#include <irg/core/threads.hpp>

#include "fractal/deep_pictures.hpp"
#include "support/check_both.hpp"

using irg::double_double;
using irg::image;
using irg::make_escape_limit;

namespace {

using C = irg::point<double_double, 2>;

#ifdef IRG_HAVE_MPFR
double_double rounded(const test::deep_digits& v) {
  const auto high = static_cast<double>(v);
  return double_double(high) + static_cast<double>(v - test::deep_digits(high));
}
test::deep_digits exact(const double_double& v) { return test::deep_digits(v.high) + test::deep_digits(v.low); }
#endif

}  // namespace

#ifdef IRG_HAVE_MPFR
TEST_CASE("draw_mandelbrot in double_doubles: the counts of MPFR, at widths down to 1e-24") {
  const bool all = std::getenv("IRG_RELEASE_TIER") != nullptr;
  test::random r(24);
  for (const double width : {1e-13, 1e-20, 1e-24}) {
    const int pixels = all ? 100 : 16;
    test::deep_job job = test::descended(r, width, pixels, all ? 5000 : 2000);
    job.pixel *= 0.7;  // so that 106 bits do not hold a pixel's number exactly
    const irg::precise_escape_job precise{rounded(job.re), rounded(job.im), job.pixel, job.limit};
    job.re = exact(precise.re), job.im = exact(precise.im);
    image<int> counts(pixels, pixels), together(pixels, pixels);
    const irg::precise_escape_counts stats = draw_mandelbrot(counts, precise);
    CHECK(draw_mandelbrot(together, precise, irg::parallel{2}) == stats);
    CHECK(counts == together);
    CHECK(stats.pixels == pixels * pixels);
    CHECK(stats.unsure == 0);
    test::big_orbit oracle;
    int wrong = 0, least = job.limit.most, greatest = 0;
    for (int y = 0; y < pixels; ++y)
      for (int x = 0; x < pixels; ++x) {
        const int k = oracle.count(job, (x - (pixels - 1) * 0.5) * job.pixel, ((pixels - 1) * 0.5 - y) * job.pixel);
        wrong += counts(x, y) != k;
        least = k < least ? k : least;
        greatest = k > greatest ? k : greatest;
      }
    CHECK(wrong == 0);
    CHECK(least < greatest);
    MESSAGE("width ", width, ": ", stats.again, " of ", stats.pixels, " computed again");
  }
}
#endif

TEST_CASE("sure_mandelbrot_count: as in doubles where nothing is rounded; what nothing is sure of") {
  using irg::sure_count;
  using irg::sure_mandelbrot_count;
  constexpr auto limit = make_escape_limit(100.0, 16);
  CHECK_BOTH(sure_mandelbrot_count(C{0.3, 0}, limit) == sure_count{14, true});
  CHECK_BOTH(sure_mandelbrot_count(C{1, 0}, limit) == sure_count{4, true});
  CHECK_BOTH(sure_mandelbrot_count(C{-1, 0}, make_escape_limit(2.5, 1000)) == sure_count{1000, true});
  CHECK_BOTH(sure_mandelbrot_count(C{0, 0}, make_escape_limit(2.0, 0)) == sure_count{0, true});
  CHECK_BOTH(sure_mandelbrot_count(C{0, 0}, make_escape_limit(0.0, 9)).count == 0);
  CHECK_BOTH(!sure_mandelbrot_count(C{-2, 0}, make_escape_limit(2.0, 1000)).is_sure);  // on the disc's border
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK(sure_mandelbrot_count(C{nan, 0}, limit) == sure_count{0, false});
  CHECK(sure_mandelbrot_count(C{inf, 0}, limit).count == 0);
  // A distance of 2^-90 from the set at -2, which doubles cannot tell.
  CHECK(sure_mandelbrot_count(C{double_double(-2, -0x1p-90), 0}, make_escape_limit(2.5, 1000)).count < 60);
  image<int> none(0, 3), one(1, 1);
  CHECK(draw_mandelbrot(none, irg::precise_escape_job{0, 0, 1, limit}) == irg::precise_escape_counts{});
  CHECK(draw_mandelbrot(one, irg::precise_escape_job{0.3, 0, 1e-30, limit}) == irg::precise_escape_counts{1, 0, 0});
  CHECK(one(0, 0) == 14);
  draw_mandelbrot(one, irg::precise_escape_job{nan, 0, 1, limit});
  CHECK(one(0, 0) == 0);
}

TEST_CASE("draw_mandelbrot in double_doubles: steps out of a disc so large that their squares fit no fixed_point") {
  using stats = irg::precise_escape_counts;
  image<int> one(1, 1);
  // c lies within the disc by less than 106 bits tell; its square plus c is near 2^38, and that one's square modulo
  // 2^64 is negative.
  const double_double c(600001.0, -0x1p-86);
  CHECK(draw_mandelbrot(one, irg::precise_escape_job{c, 0, 0x1p-90, {600001.0 * 600001.0, 40}}) == stats{1, 1, 0});
  CHECK(one(0, 0) == 1);
  const double inf = std::numeric_limits<double>::infinity();
  for (const double square : {inf, -inf, 0x1p70, std::numeric_limits<double>::quiet_NaN()}) {
    const stats s = draw_mandelbrot(one, irg::precise_escape_job{0.25, 0, 1, {square, 40}});
    CHECK(s.again == 0);
    CHECK(one(0, 0) == (square == 0x1p70 ? 40 : 0));
  }
}

TEST_CASE("draw_mandelbrot in double_doubles: right on the largest circle that more digits are taken for") {
  using stats = irg::precise_escape_counts;
  image<int> one(1, 1);
  for (const irg::point<double, 2> c : {irg::point<double, 2>{0x1p20, 0}, {0, 0x1p20}, {-0x1p20, 0}, {0, -0x1p20}}) {
    CHECK(draw_mandelbrot(one, irg::precise_escape_job{c.x, c.y, 1, make_escape_limit(0x1p20, 9)}) == stats{1, 0, 1});
    CHECK(one(0, 0) == 0);
  }
}
