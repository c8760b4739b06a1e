// SPDX-License-Identifier: MIT
#include <irg/geometry/polygon_centroid.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"
#include "support/ulp.hpp"

namespace {

using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
using V = std::vector<P>;

TEST_CASE("polygon_centroid: by hand, holes, every number type") {
  constexpr std::array<P, 4> square{P{1, 1}, P{3, 1}, P{3, 5}, P{1, 5}};
  CHECK_BOTH(irg::polygon_centroid(square) == P{2, 3});
  CHECK_BOTH(irg::polygon_centroid_fast(square) == P{2, 3});
  CHECK_BOTH(irg::polygon_centroid(std::array{I{0, 0}, I{0, 3}, I{6, 0}}) == P{2, 1});
  CHECK_BOTH(irg::polygon_centroid(std::array{I{0, 0}, I{1, 0}, I{0, 1}}) == P{1.0 / 3, 1.0 / 3});
  // an L of three squares
  CHECK(irg::polygon_centroid(V{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) == P{5.0 / 6, 5.0 / 6});
  // a square of side 6 without one of side 2 at (1, 3)
  const std::vector<V> frame{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{0, 2}, {0, 4}, {2, 4}, {2, 2}}};
  CHECK(irg::polygon_centroid(frame) == P{(36.0 * 3 - 4) / 32, 3});
  using Q = irg::point<test::rational, 2>;
  CHECK(irg::polygon_centroid(std::array{Q{0, 0}, Q{1, 0}, Q{0, {1, 2}}}) == Q{{1, 3}, {1, 6}});
  using F = irg::point<float, 2>;
  CHECK_BOTH(irg::polygon_centroid(std::array{F{0, 0}, F{1, 0}, F{0, 1}}) == F{1.0f / 3, 1.0f / 3});
}

TEST_CASE("polygon_centroid: polygons without area, no numbers, all exponents") {
  for (const V& flat :
       {V{}, V{{1, 2}}, V{{1, 2}, {3, 4}}, V{{1, 1}, {2, 2}, {5, 5}}, V{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}) {
    CHECK(!irg::polygon_centroid(flat));
    CHECK(!irg::polygon_centroid_fast(flat));
  }
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK(!irg::polygon_centroid(V{{0, 0}, {1, 0}, {bad, 1}}));
  for (const double scale : {0x1p-1074, 0x1p-1000, 0x1p-300, 1.0, 0x1p400, 0x1p1020}) {
    const auto at = [&](double x, double y) { return P{x * scale, y * scale}; };
    CHECK(irg::polygon_centroid(V{at(0, 0), at(3, 0), at(0, 6)}) == at(1, 2));
    CHECK(irg::polygon_centroid(V{{0, 0}, {3, 0}, {0, 6 * scale}}) == P{1, 2 * scale});
  }
  constexpr double most = std::numeric_limits<double>::max();
  CHECK_BOTH(irg::polygon_centroid(std::array{P{-most, -most}, P{most, -most}, P{most, most}, P{-most, most}}) ==
             P{0, 0});
}

TEST_CASE("polygon_centroid: subnormal coordinates are rounded once, lengths of subnormal edges in the end alone") {
  constexpr double least = 0x1p-1074;
  // y is 2/3 and 4/3 of the smallest number
  CHECK_BOTH(irg::polygon_centroid(std::array{P{0, 0}, P{3, 0}, P{0, 2 * least}}) == P{1, least});
  CHECK_BOTH(irg::polygon_centroid(std::array{P{0, 0}, P{3, 0}, P{0, 4 * least}}) == P{1, least});
  CHECK_BOTH(irg::polygon_centroid(std::array{P{0, 0x1p-1022}, P{0x1p-1000, 0x1p-1022}, P{0, 0x1p-1022 + 2 * least}}) ==
             P{0x1p-1000 / 3, 0x1p-1022 + least});
  // four edges of 1.414 each
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{0, least}, P{-least, 0}, P{0, -least}, P{least, 0}}) == 6 * least);
  // a third of the smallest number is lost, not two thirds
  constexpr std::array found{P{-0x33fap-1074, -0x2083208b3a6p-1074}, P{0x1cbp-1074, 0x1cp-1074},
                             P{0x16d25p-1074, -0x8e7p-1074}, P{0x1965f1f645bp-1074, -0xc9p-1074}};
  CHECK_BOTH(irg::polygon_centroid(found)->y == -0xad6602e9c7p-1074);
}

TEST_CASE("polygon_centroid: far from the origin, against rationals") {
  test::random random(101);
  double worst = 0, worst_fast = 0;
  for (int t = 0; t < 3000; ++t) {
    // coordinates that are integers of 2^-2, offset by up to 10^15; the centroid from the integers about the origin
    const auto offset = static_cast<double>(std::int64_t{1} << random.integer(0, 49));
    std::vector<irg::point<test::rational, 2>> exact;
    V ring;
    for (auto n = random.integer(3, 7); n > 0; --n) {
      const std::int64_t x = random.integer(-20, 20), y = random.integer(-20, 20);
      exact.push_back({test::rational(x, 4), test::rational(y, 4)});
      ring.push_back({offset + static_cast<double>(x) / 4, offset + static_cast<double>(y) / 4});
    }
    const auto expected = irg::polygon_centroid(exact);
    const auto found = irg::polygon_centroid(ring);
    REQUIRE(found.has_value() == expected.has_value());
    if (!found) continue;
    const auto fast = irg::polygon_centroid_fast(ring);
    REQUIRE(fast.has_value());
    for (int k = 0; k < 2; ++k) {
      const test::rational whole = (*expected)[k] + test::rational(static_cast<std::int64_t>(offset));
      const auto size = std::fabs(static_cast<double>(whole));
      if (size == 0) REQUIRE((*found)[k] == 0);
      if (size < 0x1p-8) continue;
      const double ulp = std::nextafter(size, 0x1p60) - size;
      const auto off = [&](double v) { return std::fabs(static_cast<double>(test::rational::of(v) - whole)) / ulp; };
      worst = std::max(worst, off((*found)[k]));
      worst_fast = std::max(worst_fast, off((*fast)[k]));
    }
  }
  MESSAGE("ulp off: default ", worst, ", fast ", worst_fast);
  CHECK(worst <= 0.52);
}

TEST_CASE("polygon_perimeter: all rings; within 2 ulp; any exponent") {
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{0, 0}, P{3, 0}, P{3, 4}}) == 12);
  CHECK(irg::polygon_perimeter(std::vector<V>{{{0, 0}, {3, 0}, {3, 4}}, {{9, 9}, {9, 10}}}) == 14);
  CHECK(irg::polygon_perimeter(V{}) == 0);
  CHECK(irg::polygon_perimeter(V{{7, 8}}) == 0);
  CHECK(irg::polygon_perimeter(V{{0, 0}, {3 * 0x1p-1074, 0}, {3 * 0x1p-1074, 4 * 0x1p-1074}}) == 12 * 0x1p-1074);
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity(),
                   most = (std::numeric_limits<double>::max)();
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{0, 0}, P{0x1p1023, 0}, P{0, 0x1p1023}}) == inf);
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{-most, 0}, P{most, 0}}) == inf);
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{most, most}, P{0, 0}}) == inf);
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{most, 0}, P{most / 2, 0}}) == most);
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{0, 0}, P{undefined, 0}, P{0, 1}}) != 0);
  CHECK(std::isnan(irg::polygon_perimeter(V{{0, 0}, {undefined, 0}, {0, 1}})));
  CHECK(std::isnan(irg::polygon_perimeter(V{{0, inf}, {undefined, 0}, {0, 1}})));
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{0, inf}, P{1, inf}, P{0, 0}}) == inf);
  CHECK_BOTH(irg::polygon_perimeter(std::array{P{0, -inf}}) == inf);
  test::random random(102);
  double worst = 0;
  for (int t = 0; t < 200; ++t) {
    V ring;
    for (int i = 0; i < 1000; ++i) {
      const double x = random.unit();
      ring.push_back({x, random.unit()});
    }
    long double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const P &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const long double dx = static_cast<long double>(q.x) - static_cast<long double>(p.x),
                        dy = static_cast<long double>(q.y) - static_cast<long double>(p.y);
      sum += std::sqrt(dx * dx + dy * dy);
    }
    const double expected = static_cast<double>(sum), ulp = std::nextafter(expected, 1e300) - expected;
    worst = std::max(worst, std::fabs(irg::polygon_perimeter(ring) - expected) / ulp);
  }
  MESSAGE("perimeters of 1000 edges: ", worst, " ulp off");
  CHECK(worst <= 2);
}

}  // namespace

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("polygon_centroid, polygon_perimeter: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  test::real sum, x, y;
  sweep(
      named<T>("polygon_centroid"), 0.52,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        const E twice = twice_area(ring);
        const auto got = irg::polygon_centroid(ring);
        if (got.has_value() != (twice.sign() != 0)) return wrong;
        if (!got) return 0.0;
        E moment[2] = {0, 0};
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto &p = ring[i], &q = after(ring, i);
          const E dx = of(p.x) - of(q.x), dy = of(q.y) - of(p.y);
          moment[0] = moment[0] + dy * (of(p.x) * of(p.x) + of(p.x) * of(q.x) + of(q.x) * of(q.x));
          moment[1] = moment[1] + dx * (of(p.y) * of(p.y) + of(p.y) * of(q.y) + of(q.y) * of(q.y));
        }
        double worst = 0;
        for (int k = 0; k < 2; ++k) {
          worst = std::fmax(worst, quotient_error((*got)[k], moment[k], twice * 3));
        }
        return worst;
      },
      2000);
  sweep(
      named<T>("polygon_perimeter"), 2,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        mpfr_set_zero(sum, 1);
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto &p = ring[i], &q = after(ring, i);
          if (!std::isfinite(q.x - p.x) || !std::isfinite(q.y - p.y)) return 0.0;
          mpfr_set_d(x, static_cast<double>(q.x), MPFR_RNDN), mpfr_sub_d(x, x, static_cast<double>(p.x), MPFR_RNDN);
          mpfr_set_d(y, static_cast<double>(q.y), MPFR_RNDN), mpfr_sub_d(y, y, static_cast<double>(p.y), MPFR_RNDN);
          mpfr_hypot(x, x, y, MPFR_RNDN);
          mpfr_add(sum, sum, x, MPFR_RNDN);
        }
        return test::ulp_error(irg::polygon_perimeter(ring), sum);
      },
      2000);
}

#endif
