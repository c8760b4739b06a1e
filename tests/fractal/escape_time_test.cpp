// SPDX-License-Identifier: MIT
#include <irg/fractal/escape_time.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include <irg/fractal/mandelbrot.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::escape_count;
using irg::escape_orbit;
using irg::make_escape_limit;
using irg::point;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

// The limit is right where the root of `square` is no longer below the radius, and that of the number before it is.
template <class T>
bool separates(T radius) {
  const T square = make_escape_limit(radius, 1).square;
  if (square == std::numeric_limits<T>::infinity()) return std::sqrt(std::numeric_limits<T>::max()) < radius;
  return !(std::sqrt(square) < radius) && (square == 0 || std::sqrt(std::nextafter(square, T(0))) < radius);
}

template <class T>
void try_radii(int least, int most) {
  test::random r(11);
  for (int i = 0; i < 20000; ++i)
    REQUIRE(separates(static_cast<T>(std::ldexp(1 + r.unit(), static_cast<int>(r.integer(least, most))))));
}

struct burning_ship {
  point<double, 2> c;
  constexpr point<double, 2> operator()(const point<double, 2>& z) const {
    const double x = z.x < 0 ? -z.x : z.x, y = z.y < 0 ? -z.y : z.y;
    return {irg::product(x, x) - irg::product(y, y) + c.x, irg::product(2 * x, y) + c.y};
  }
};

constexpr auto doubling = [](const point<double, 2>& z) { return point<double, 2>{2 * z.x, 2 * z.y}; };

}  // namespace

TEST_CASE("make_escape_limit: |z|^2 against it decides as the rounded root does, for radii of every size") {
  try_radii<double>(-1074, 1022);
  try_radii<float>(-149, 126);
  for (const double radius : {100.0, 2.0, 1.0, 1.5, 0x1p512, 0x1.fffffffffffffp511, 0x1p500, 0x1.0000000000001p500,
                              4.9e-324, 1.7976931348623157e308, 1e154, 1.4e154})
    CHECK(separates(radius));
  CHECK_BOTH(make_escape_limit(100.0, 16).most == 16);
  CHECK_BOTH(make_escape_limit(0.0, 16).square == 0);
  CHECK_BOTH(make_escape_limit(-3.0, 16).square == 0);
  CHECK_BOTH(make_escape_limit(inf, 16).square == inf);
  CHECK(make_escape_limit(not_a_number, 16).square == 0);
}

TEST_CASE("escape_count: any map; the last step counts as staying") {
  constexpr auto eight = make_escape_limit(8.0, 10);
  CHECK_BOTH(escape_count(doubling, point<double, 2>{1, 0}, eight) == 2);  // 2, 4, 8: |z| = 8 is outside
  CHECK_BOTH((escape_orbit(doubling, point<double, 2>{1, 0}, eight) == irg::escape_end<double>{2, {8, 0}}));
  CHECK_BOTH(escape_count(doubling, point<double, 2>{0, 0}, eight) == 10);
  CHECK_BOTH(escape_count(doubling, point<double, 2>{5, 0}, eight) == 0);
  CHECK_BOTH(escape_count(doubling, point<double, 2>{1, 0}, make_escape_limit(8.0, 2)) == 2);  // most, too
  CHECK_BOTH(escape_count(doubling, point<double, 2>{1, 0}, make_escape_limit(8.0, 0)) == 0);
  CHECK_BOTH(escape_count(doubling, point<double, 2>{0, 0}, make_escape_limit(0.0, 9)) == 0);
  CHECK(escape_count(doubling, point<double, 2>{not_a_number, 0}, eight) == 0);
  CHECK_BOTH(escape_count(burning_ship{{-1.75, -0.03}}, point<double, 2>{0, 0}, make_escape_limit(2.0, 100)) > 5);
}
