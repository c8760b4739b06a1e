// SPDX-License-Identifier: MIT
#include <irg/fractal/mandelbrot.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::make_escape_limit;
using irg::mandelbrot_count;
using irg::mandelbrot_part;
using irg::mandelbrot_part_of;
using irg::point;

namespace {

using C = point<double, 2>;

// The loop as the course prints it, with a root in it.
int printed_count(double cx, double cy, double eps, int most) {
  double x = 0, y = 0;
  int k = -1;
  do {
    ++k;
    const double xx = irg::product(x, x), yy = irg::product(y, y), xy = irg::product(2 * x, y);
    x = xx - yy + cx;
    y = xy + cy;
  } while (std::sqrt(irg::product(x, x) + irg::product(y, y)) < eps && k < most);
  return k;
}

}  // namespace

TEST_CASE("mandelbrot_count: single points of the course") {
  constexpr auto limit = make_escape_limit(100.0, 16);
  constexpr struct {
    C c;
    int k;
  } rows[] = {{{0, 0}, 16}, {{-1, 0}, 16},   {{-2, 0}, 16}, {{0.25, 0}, 16}, {{1, 0}, 4},   {{0.5, 0}, 6},
              {{0, 1}, 16}, {{-1.5, -1}, 4}, {{100, 0}, 0}, {{99, 0}, 1},    {{0.3, 0}, 14}};
  for (const auto& row : rows) CHECK(mandelbrot_count(row.c, limit) == row.k);
  static_assert(mandelbrot_count(C{1, 0}, limit) == 4 && mandelbrot_count(C{0, 1}, limit) == 16);
  CHECK_BOTH(mandelbrot_count(C{0.3, 0}, make_escape_limit(100.0, 14)) == 14);
  CHECK_BOTH(mandelbrot_count(C{0.3, 0}, make_escape_limit(100.0, 13)) == 13);
  CHECK(mandelbrot_count(C{std::numeric_limits<double>::quiet_NaN(), 0}, limit) == 0);
  CHECK(mandelbrot_count(C{1e300, 1e300}, limit) == 0);
}

TEST_CASE("mandelbrot_count: the printed loop, for points and radii of all sizes") {
  test::random r(5);
  for (int i = 0; i < 20000; ++i) {
    const double reach = std::ldexp(1.0, static_cast<int>(r.integer(-60, 3)));
    const double cx = -0.5 + (2 * r.unit() - 1) * reach, cy = (2 * r.unit() - 1) * reach;
    const double eps = i % 3 == 0 ? 2 : std::ldexp(1 + r.unit(), static_cast<int>(r.integer(-20, 500)));
    const int most = static_cast<int>(r.integer(0, 60));
    REQUIRE(mandelbrot_count(C{cx, cy}, make_escape_limit(eps, most)) == printed_count(cx, cy, eps, most));
  }
}

TEST_CASE("mandelbrot_part_of: nothing outside is said to be inside, and little inside is missed") {
  CHECK_BOTH(mandelbrot_part_of(C{0, 0}) == mandelbrot_part::cardioid);
  CHECK_BOTH(mandelbrot_part_of(C{-1, 0.2}) == mandelbrot_part::disc);
  CHECK_BOTH(mandelbrot_part_of(C{0.25, 0}) == mandelbrot_part::elsewhere);   // the cusp
  CHECK_BOTH(mandelbrot_part_of(C{-0.75, 0}) == mandelbrot_part::elsewhere);  // where they touch
  CHECK_BOTH(mandelbrot_part_of(C{-1.25, 0}) == mandelbrot_part::elsewhere);
  CHECK_BOTH(mandelbrot_part_of(point<float, 2>{0, 0}) == mandelbrot_part::cardioid);
  // The border of the cardioid is e/2 - e^2/4 for |e| = 1, that of the disc -1 + e/4.
  for (int i = 0; i < 2000; ++i) {
    const double angle = 6.283185307179586 * i / 2000;
    const auto on_border = [&](double size, bool disc) {
      const double x = size * std::cos(angle), y = size * std::sin(angle);
      return disc ? C{x / 4 - 1, y / 4} : C{x / 2 - (x * x - y * y) / 4, y / 2 - x * y / 2};
    };
    for (const bool disc : {false, true}) {
      REQUIRE(mandelbrot_part_of(on_border(1 + 1e-9, disc)) == mandelbrot_part::elsewhere);
      REQUIRE(mandelbrot_part_of(on_border(1, disc)) == mandelbrot_part::elsewhere);
      REQUIRE(mandelbrot_part_of(on_border(0.7, disc)) == (disc ? mandelbrot_part::disc : mandelbrot_part::cardioid));
      REQUIRE(mandelbrot_count(on_border(0.999, disc), make_escape_limit(2.0, 5000)) == 5000);
    }
  }
}
