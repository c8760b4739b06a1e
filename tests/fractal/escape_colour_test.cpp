// SPDX-License-Identifier: MIT
#include <irg/fractal/escape_colour.hpp>

#include <cmath>
#include <limits>

#include <irg/fractal/mandelbrot.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

TEST_CASE("escape_colour: black for what stays, the palette's stops sixteen counts apart") {
  CHECK_BOTH((irg::escape_colour(200, 200) == irg::rgba8{0, 0, 0, 255}));
  CHECK_BOTH((irg::escape_colour(0, 0) == irg::rgba8{0, 0, 0, 255}));
  CHECK_BOTH((irg::escape_colour(0, 200) == irg::rgba8{18, 32, 74, 255}));
  CHECK_BOTH((irg::escape_colour(16, 200) == irg::rgba8{62, 130, 180, 255}));
  CHECK_BOTH((irg::escape_colour(32, 200) == irg::rgba8{238, 240, 230, 255}));
  CHECK_BOTH((irg::escape_colour(48, 200) == irg::rgba8{226, 160, 62, 255}));
  CHECK_BOTH((irg::escape_colour(64, 200) == irg::rgba8{120, 36, 52, 255}));
  CHECK_BOTH((irg::escape_colour(80, 200) == irg::rgba8{18, 32, 74, 255}));
  CHECK_BOTH((irg::escape_colour(8, 200) == irg::rgba8{40, 81, 127, 255}));  // 128/255 of the way
}

using irg::escape_end;
using irg::make_escape_limit;
using irg::smooth_count;

namespace {

// The potential's logarithm: the limit of log2(log radius) - log2(2^-n log |z|), n steps later, far outside.
double smooth_by_potential(long double cx, long double cy, double radius) {
  long double x = 0, y = 0;
  int n = 0;
  for (; x * x + y * y < 1e60L; ++n) {
    const long double next = x * x - y * y + cx;
    y = 2 * x * y + cy;
    x = next;
  }
  return static_cast<double>(n + std::log2(std::log(static_cast<long double>(radius))) -
                             std::log2(std::log(x * x + y * y) / 2));
}

}  // namespace

TEST_CASE("smooth_count: the logarithm of the potential, for any radius") {
  test::random r(8);
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const irg::point<double, 2> c{-2.5 + 4 * r.unit(), -1.5 + 3 * r.unit()};
    const double radius = std::ldexp(1 + r.unit(), static_cast<int>(r.integer(10, 100)));
    const auto limit = make_escape_limit(radius, 300);
    const auto end = irg::escape_orbit(irg::square_plus<double>{c}, irg::point<double, 2>{0, 0}, limit);
    const double smooth = smooth_count(end, radius, 300);
    if (end.count == 300) {
      CHECK(smooth == 300);
      continue;
    }
    if (end.count > 40) continue;  // there the orbits of doubles and long doubles part
    ++compared;
    CHECK(std::abs(smooth - smooth_by_potential(static_cast<long double>(c.x), static_cast<long double>(c.y), radius)) <
          1e-5);
    CHECK((smooth > end.count - 1e-5 && smooth < end.count + 1 + 1e-5));
  }
  CHECK(compared > 1500);
}

TEST_CASE("smooth_count: ends") {
  CHECK_BOTH(smooth_count(escape_end<double>{5, {16, 0}}, 16.0, 9) == 6);
  CHECK_BOTH(smooth_count(escape_end<double>{5, {0, -256}}, 16.0, 9) == 5);
  CHECK_BOTH(smooth_count(escape_end<float>{5, {0, -256}}, 16.0f, 9) == 5);
  CHECK_BOTH(smooth_count(escape_end<double>{9, {1, 1}}, 16.0, 9) == 9);
  CHECK_BOTH(smooth_count(escape_end<double>{0, {1, 1}}, 16.0, 0) == 0);
  CHECK(smooth_count(escape_end<double>{3, {1e200, 0}}, 16.0, 9) == 9);
  // The largest square that is no infinity, to the last bit: a count like others.
  constexpr irg::point<double, 2> largest{0x1.fae147ae147adp+511, 0x1.20e7ec86e0b33p+509};
  static_assert(irg::product(largest.x, largest.x) + irg::product(largest.y, largest.y) ==
                std::numeric_limits<double>::max());
  CHECK_BOTH(smooth_count(escape_end<double>{20, largest}, 0x1p256, 40) == 20);
  CHECK(smooth_count(escape_end<double>{3, {std::numeric_limits<double>::quiet_NaN(), 0}}, 16.0, 9) == 9);
}
