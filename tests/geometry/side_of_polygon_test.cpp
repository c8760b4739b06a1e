// SPDX-License-Identifier: MIT
#include <irg/geometry/side_of_polygon.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using irg::side;
using irg::side_of_polygon;
using H = irg::hpoint<double, 3>;
using P = irg::point<double, 3>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

// A quadrilateral in a plane whose coordinates' products round.
constexpr std::array<P, 4> tall{{{0.1, 0.7, 0.3}, {1.1, 0.7, 0.3}, {1.1, 1e9, 0.3}, {0.1, 1e9, 0.3}}};

TEST_CASE("side_of_polygon: above, below, on; from infinitely far") {
  CHECK_BOTH(side_of_polygon(tall, H{1e-9, 1e17, 0.3, 1}) == side::on);
  CHECK_BOTH(side_of_polygon(tall, H{1e-9, 1e17, 0.30000000000000004, 1}) == side::above);
  CHECK_BOTH(side_of_polygon(tall, H{1e-9, 1e17, 0.29999999999999993, 1}) == side::below);
  CHECK_BOTH(side_of_polygon(tall, H{5, 7, -1e-300, 0}) == side::below);
  CHECK_BOTH(side_of_polygon(tall, H{5, 7, 0, 0}) == side::on);
  CHECK_BOTH(side_of_polygon(tall, H{0.25, 0.5, 0.25, 0.5}) == side::above);  // (0.5, 1, 0.5)
}

TEST_CASE("side_of_polygon: concave, not plane, degenerate, not finite") {
  constexpr std::array<P, 5> arrow{{{0, 0, 0}, {4, -3, 0}, {1, 0, 0}, {4, 3, 0}, {3, 3, 1e-9}}};
  CHECK_BOTH(side_of_polygon(arrow, H{0, 0, 2, 1}) == side::above);
  CHECK_BOTH(side_of_polygon(std::array<P, 2>{{{0, 0, 0}, {1, 0, 0}}}, H{0, 0, 2, 1}) == side::on);
  CHECK_BOTH(side_of_polygon(std::array<P, 3>{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, H{0, 0, 2, 1}) == side::on);
  CHECK_BOTH(side_of_polygon(std::array<P, 3>{{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}}, H{0, 0, 2, 1}) == side::on);
  CHECK_BOTH(side_of_polygon(std::array<P, 3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, H{0, 0, inf, 1}) == side::on);
}

TEST_CASE("side_of_polygon: beyond the range of the rounded stage") {
  constexpr double most = (std::numeric_limits<double>::max)(), least = std::numeric_limits<double>::denorm_min();
  constexpr std::array<P, 4> huge{{{-most, -most, 0}, {most, -most, 0}, {most, most, 0}, {-most, most, 0}}};
  CHECK_BOTH(side_of_polygon(huge, H{most, most, least, most}) == side::above);
  CHECK_BOTH(side_of_polygon(huge, H{-most, most, -least, least}) == side::below);
  CHECK_BOTH(side_of_polygon(huge, H{-most, most, 0, 1}) == side::on);
}

#ifdef IRG_HAVE_MPFR
// By rationals, with Newell's normal as the sum of the cross products of neighbouring vertices themselves.
TEST_CASE_TEMPLATE("side_of_polygon: coordinates of every size, and points in the plane but for roundings", T, double,
                   float) {
  using E = test::exact;
  test::random r(9);
  int on = 0;
  for (const test::spread kind : test::all_spreads)
    for (int trial = 0; trial < test::trials(300); ++trial) {
      const auto any = [&] { return test::any_coordinate<T>(r, kind); };
      const std::size_t n = 3 + static_cast<std::size_t>(trial % 3);
      std::vector<irg::point<T, 3>> p;
      for (std::size_t k = 0; k < n; ++k) p.push_back({any(), any(), trial % 5 == 0 ? T(1) : any()});
      const T weight = trial % 4 == 0 ? T(0) : trial % 4 == 1 ? std::abs(any()) : T(1);
      irg::hpoint<T, 3> q{any(), any(), trial % 7 == 0 ? T(1) : any(), weight};
      if (trial % 3 == 0) {
        const T u = static_cast<T>(r.unit()), v = static_cast<T>(r.unit());
        for (int i = 0; i < 3; ++i) {
          const T x = p[0][i] + u * (p[1][i] - p[0][i]) + v * (p[2][i] - p[0][i]);
          if (std::isfinite(x)) (i == 0 ? q.x : i == 1 ? q.y : q.z) = x;
        }
      }
      const auto at = [&](std::size_t k, int i) { return E(static_cast<double>(p[k % n][i])); };
      E value(0);
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        E normal(0);
        for (std::size_t v = 0; v < n; ++v) normal = normal + at(v, j) * at(v + 1, k) - at(v, k) * at(v + 1, j);
        value = value + normal * (E(static_cast<double>(q[i])) - E(static_cast<double>(q.w)) * at(0, i));
      }
      const side where = side_of_polygon(p, q);
      CHECK(static_cast<int>(where) == value.sign());
      on += where == side::on;
    }
  CHECK(on > 100);
}
#endif

}  // namespace
