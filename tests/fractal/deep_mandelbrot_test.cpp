// SPDX-License-Identifier: MIT
#include <irg/fractal/deep_mandelbrot.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>

#include <irg/core/threads.hpp>
#include <irg/fractal/mandelbrot.hpp>

#include "fractal/deep_pictures.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

using irg::deep_escape_job;
using irg::draw_deep_mandelbrot;
using irg::image;
using irg::make_escape_limit;

namespace {

using digits = test::deep_digits;
using deep_job = test::deep_job;
using test::descended;

bool is_release_tier() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

#ifdef IRG_HAVE_MPFR
template <class T = double>
int wrong_counts(const deep_job& job, int pixels, bool has_colours = true) {
  image<int> counts(pixels, pixels);
  irg::draw_deep_mandelbrot<T>(counts, job);
  test::big_orbit oracle;
  int wrong = 0, least = job.limit.most, greatest = 0;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const double right = (x - (pixels - 1) * 0.5) * job.pixel, up = ((pixels - 1) * 0.5 - y) * job.pixel;
      const int k = oracle.count(job, right, up);
      wrong += counts(x, y) != k;
      least = k < least ? k : least;
      greatest = k > greatest ? k : greatest;
    }
  return !has_colours || least < greatest ? wrong : -1;  // one colour is no picture
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
    CHECK(rounded <= pixels * pixels / 20);
    CHECK(test::enough(is_release_tier() || rounded == 0));
    MESSAGE("width ", width, ": ", rounded, " of ", pixels * pixels, " counts differ in doubles");
  }
}

// A hundred thousand counts: what a glitch that nobody noticed would show in.
TEST_CASE("draw_deep_mandelbrot: no undetected glitch 1e-50 wide") {
  test::random r(50);
  const int pixels = is_release_tier() ? 317 : 24;
  const deep_job job = descended(r, 1e-50, pixels, is_release_tier() ? 5000 : 2500);
  CHECK(wrong_counts<irg::double_double>(job, pixels) == 0);
  const int rounded = wrong_counts(job, pixels);
  CHECK(rounded >= 0);
  CHECK(rounded <= pixels * pixels / 100);
  MESSAGE(rounded, " of ", pixels * pixels, " counts differ in doubles");
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

// |Z| is the radius to the last bit of a double, and to the last of 320: the side of a pixel only its offset tells.
TEST_CASE("draw_deep_mandelbrot: orbits that touch the border of the disc") {
  struct {
    double re, im, square;  // of a centre, one of whose first points is of that squared length
  } constexpr touching[] = {{-2, 0, 4},
                            {0.75, 1, 1.5625},
                            {0, 1, 2},
                            {0, 2, 20},
                            {-1, 0.5, 1.25},
                            {1, 0, 0x1.9p4},
                            {1024, 0, 1049600.0 * 1049600.0},
                            {3e5, 4e5, 25e10},
                            {0x1p25, 0, 0x1p50 * ((0x1p25 + 1) * (0x1p25 + 1))},
                            {3 * 0x1p-60, 0x1p-58, 25 * 0x1p-120}};
  for (const auto& t : touching)
    for (const double pixel : {1e-18, 1e-20, 1e-50, 1e-70})
      for (const double aside : {0x1p-9, 0.3, -1.7}) {
        const double side = pixel * (t.re * t.re < 0x1p-100 ? 0x1p-60 : 1);
        const deep_job job{
            digits(t.re) + digits(aside * side), digits(t.im) - digits(aside * side / 2), side, {t.square, 12}};
        CHECK(wrong_counts(job, 7) == 0);
        CHECK(wrong_counts<irg::double_double>(job, 5) == 0);
      }
  // Centres of the issue: -2 within 4e-16.
  for (const char* const re : {"-1.9999999999999999", "-2.0000000000000001", "-1.99999999999999999999999999"}) {
    const deep_job job{*irg::parse_fixed_point<6>(re), digits(0.0), 1e-20, make_escape_limit(2.0, 200)};
    CHECK(wrong_counts(job, 9, false) == 0);
  }
  // Any centre, and the radius of one of its points as a double has it: a picture on one side of the border.
  test::random r(77);
  for (int i = test::trials(100); i > 0; --i) {
    const auto coordinate = [&] { return digits(3 * r.unit() - 1.5) + digits(0x1p-60 * r.unit()); };
    deep_job job{coordinate(), coordinate(), std::ldexp(1.0, -static_cast<int>(r.integer(60, 200))), {4, 20}};
    const auto orbit = irg::reference_orbit(job.re, job.im, job.limit);
    const auto& z = orbit[static_cast<std::size_t>(r.integer(1, static_cast<std::int64_t>(orbit.size()) - 1))];
    job.limit.square = irg::product(z.x, z.x) + irg::product(z.y, z.y);
    CHECK(wrong_counts(job, 3, false) == 0);
    CHECK(wrong_counts<irg::double_double>(job, 2, false) == 0);
  }
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
  CHECK(draw_deep_mandelbrot(none, deep_job{}) == irg::deep_escape_counts{});
}

// The orbit that all pixels share ends where it has left 2^20; pixels whose disc is larger go on by themselves.
TEST_CASE("draw_deep_mandelbrot: discs far larger than the orbit that is kept") {
  for (const double radius : {0x1p19, 0x1p21, 1e9, 1e40, 1e150})
    for (const double re : {0.3, 1.0, -2.5, 1000.0}) {
      const auto limit = make_escape_limit(radius, 60);
      image<int> counts(5, 5);
      draw_deep_mandelbrot(counts, deep_job{digits(re), digits(0.0), 0.125, limit});
      for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x)
          CHECK(counts(x, y) ==
                irg::mandelbrot_count(irg::point<double, 2>{re + (x - 2) * 0.125, (2 - y) * 0.125}, limit));
    }
}
