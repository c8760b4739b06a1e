// SPDX-License-Identifier: MIT
#include <irg/fractal/distance_estimate.hpp>

#include <cmath>
#include <limits>

#include <irg/fractal/julia.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::julia_distance;
using irg::make_escape_limit;
using irg::mandelbrot_distance;

namespace {

using C = irg::point<double, 2>;

constexpr bool holds(const irg::escape_distance<double>& e, double distance) {
  return e.at_least <= distance * (1 + 1e-7) && distance <= e.at_most * (1 + 1e-7);
}

// No number of a fine grid within the lower bound about c stays.
void try_neighbourhood(const C& c) {
  const double far = mandelbrot_distance(c, make_escape_limit(1e6, 3000)).at_least;
  REQUIRE(far > 0);
  double nearest = 1e9;
  for (int i = -60; i <= 60; ++i)
    for (int k = -60; k <= 60; ++k) {
      const C p{c.x + far * i / 50, c.y + far * k / 50};
      if (mandelbrot_count(p, make_escape_limit(2.0, 3000)) == 3000)
        nearest = std::fmin(nearest, std::hypot(p.x - c.x, p.y - c.y));
    }
  CHECK(nearest >= far);
}

}  // namespace

TEST_CASE("mandelbrot_distance: left of -2, where the nearest number of the set is known") {
  constexpr auto limit = make_escape_limit(1e8, 500);
  for (double d = 1e-9; d < 1e9; d *= 7) {
    CHECK(holds(mandelbrot_distance(C{-2 - d, 0}, limit), d));
  }
  for (float d = 1e-4f; d < 1e4f; d *= 7) {
    const float x = -2 - d;
    const auto far = mandelbrot_distance(irg::point<float, 2>{x, 0}, make_escape_limit(1e6f, 500));
    const double distance = -2 - static_cast<double>(x);
    CHECK(holds({far.count, static_cast<double>(far.at_least) * 0.999, static_cast<double>(far.at_most) * 1.001},
                distance));
  }
}

TEST_CASE("mandelbrot_distance: no number of the set within the lower bound") {
  test::random r(4);
  for (int tried = 0; tried < 12;) {
    const C c{3 * r.unit() - 2, 2.4 * r.unit() - 1.2};
    const int k = mandelbrot_count(c, make_escape_limit(2.0, 300));
    if (k < 6 || k >= 300) continue;
    ++tried;
    try_neighbourhood(c);
  }
}

TEST_CASE("julia_distance: about the disc, and about the interval from -2 to 2") {
  constexpr auto limit = make_escape_limit(1e8, 2000);
  test::random r(9);
  for (int i = 0; i < 500; ++i) {
    const double turn = 6.3 * r.unit(), far = std::ldexp(1 + r.unit(), static_cast<int>(r.integer(0, 12)) - 11);
    const C on_circle{(1 + far) * std::cos(turn), (1 + far) * std::sin(turn)};
    CHECK(holds(julia_distance(on_circle, C{0, 0}, limit), std::hypot(on_circle.x, on_circle.y) - 1));
    const C z{5 * r.unit() - 2.5, far};
    const double beyond = std::fmax(std::fabs(z.x) - 2, 0);
    CHECK(holds(julia_distance(z, C{-2, 0}, limit), std::hypot(beyond, z.y)));
  }
}

TEST_CASE("escape distances: their counts, what stays, extremes; in constant evaluation") {
  constexpr auto limit = make_escape_limit(1000.0, 100);
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  static_assert(mandelbrot_distance(C{-1, 0}, limit) == irg::escape_distance<double>{100, 0, 0});
  static_assert(mandelbrot_distance(C{1, 1}, limit).count == mandelbrot_count(C{1, 1}, limit));
  CHECK_BOTH(mandelbrot_distance(C{0.3, 0.5}, make_escape_limit(1000.0, 0)) == irg::escape_distance<double>{0, 0, 0});
  CHECK_BOTH(julia_distance(C{0, 0}, C{0, 0}, limit).at_most == 0);
  for (const C c : {C{nan, 0}, C{0, nan}, C{inf, 0}, C{0, -inf}, C{1e200, 0}})
    CHECK(mandelbrot_distance(c, limit) == irg::escape_distance<double>{0, 0, 0});
  // Orbits whose derivative leaves the doubles.
  const auto deep = mandelbrot_distance(C{0.25 + 1e-9, 1e-300}, make_escape_limit(1000.0, 1000000));
  CHECK(deep.count > 90000);
  CHECK(deep.at_least < 2 * std::pow(1e-9, 1.5));  // in the cardioid's cusp, whose border is y = 2 (x - 1/4)^1.5
  CHECK(deep.at_most > std::pow(1e-9, 1.5));
  test::random r(1);
  for (int i = 0; i < 1000; ++i) {
    const C c{3 * r.unit() - 2, 2 * r.unit() - 1}, z{2 * r.unit() - 1, 2 * r.unit() - 1};
    REQUIRE(mandelbrot_distance(c, limit).count == mandelbrot_count(c, limit));
    REQUIRE(julia_distance(z, c, limit).count == julia_count(z, c, limit));
  }
}
