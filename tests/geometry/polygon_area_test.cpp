// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/polygon.hpp>
#include <irg/geometry/polygon_area.hpp>

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
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

TEST_CASE("polygon_area: the course's values, both ways round, holes, every number type") {
  constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};
  CHECK_BOTH(irg::polygon_area(course) == -38750);
  CHECK_BOTH(irg::polygon_area_exact(course) == -38750);
  CHECK_BOTH(irg::polygon_area_fast(course) == -38750);
  constexpr std::array<I, 4> whole{I{50, 200}, I{150, 350}, I{300, 150}, I{100, 50}};
  CHECK_BOTH(irg::twice_signed_area(whole) == -77500);
  CHECK_BOTH(irg::polygon_area(whole) == -38750.0);
  const std::vector<std::vector<P>> frame{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}};
  CHECK(irg::polygon_area(frame) == 72);
  CHECK(irg::polygon_area_exact(frame) == 72);
  CHECK(irg::polygon_area_fast(frame) == 72);
  using Q = irg::point<test::rational, 2>;
  CHECK(irg::polygon_area(std::array{Q{0, 0}, Q{{1, 3}, 0}, Q{0, {1, 5}}}) == test::rational{1, 30});
  using L = irg::point<std::int64_t, 2>;
  constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max(),
                         low = std::numeric_limits<std::int64_t>::min();
  CHECK_BOTH(irg::polygon_area(std::array{L{low, low}, L{high, low}, L{high, high}, L{low, high}}) == 0x1p128);
  CHECK_BOTH(irg::polygon_area(std::array{L{low, low}, L{high - 1, high}, L{high, high}}) == -0x1p63);
  CHECK_BOTH(irg::polygon_area(std::array{I{-2147483647 - 1, 0}, I{2147483647, 0}, I{0, 1}}) == 2147483647.5);
}

TEST_CASE("polygon_area: degenerate and hostile input") {
  using V = std::vector<P>;
  for (const V& flat :
       {V{}, V{{1, 2}}, V{{1, 2}, {3, 4}}, V{{1, 1}, {2, 2}, {5, 5}}, V{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}) {
    CHECK(irg::polygon_area(flat) == 0);
    CHECK(irg::polygon_area_exact(flat) == 0);
    CHECK(irg::polygon_area_fast(flat) == 0);
  }
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(std::isnan(irg::polygon_area(V{{0, 0}, {1, 0}, {bad, 1}})));
    CHECK(std::isnan(irg::polygon_area_exact(V{{bad, 0}, {1, 0}, {1, 1}})));
  }
  CHECK_BOTH(irg::polygon_area(std::array{P{0, 0}, P{1e120, 0}, P{1, 1e300}}) > most);
  CHECK_BOTH(irg::polygon_area(std::array{P{0, 0}, P{1, 0}, P{1, 1e300}}) == 5e299);
  CHECK_BOTH(irg::polygon_area(std::array{P{-most, 0}, P{most, 0}, P{0, least}}) ==
             0x1p-50 - 0x1p-103);  // most * least
  CHECK(irg::polygon_area(V{{-most, -most}, {most, -most}, {0, most}}) == std::numeric_limits<double>::infinity());
  CHECK_BOTH(irg::polygon_area(std::array{P{0, 0}, P{0x1p-500, 0}, P{0, 0x1p-573}}) == least);  // half of it, and more:
  CHECK_BOTH(irg::polygon_area(std::array{P{0, 0}, P{0x1p-500, 0}, P{0, 0x1p-574}}) == 0);  // to even
  CHECK_BOTH(irg::polygon_area(std::array{P{0, 0}, P{0x1.8p-500, 0}, P{0, 0x1p-574}}) == least);
  // twice the area overflows, the area does not
  CHECK_BOTH(irg::polygon_area(std::array{P{0, 0}, P{0x1p1023, 0}, P{0, 0x1.8p0}}) == 0x1.8p1022);
  CHECK_BOTH(irg::polygon_area(std::array{P{0, 0}, P{0x1p1023, 0}, P{0x1p1023, 1.5}, P{0, 1.5}}) == 0x1.8p1023);
}

#ifdef IRG_HAVE_MPFR
// The exact area, rounded: sums in rationals, to the nearest double or float by MPFR.
template <class T>
T oracle(const std::vector<irg::point<T, 2>>& r) {
  mpq_t sum, a, b;
  mpq_inits(sum, a, b, nullptr);
  for (std::size_t i = 0; i < r.size(); ++i) {
    const auto &p = r[i], &q = r[(i + 1) % r.size()];
    const auto add = [&](T x, T y, bool minus) {
      mpq_set_d(a, static_cast<double>(x));
      mpq_set_d(b, static_cast<double>(y));
      mpq_mul(a, a, b);
      (minus ? mpq_sub : mpq_add)(sum, sum, a);
    };
    add(p.x, q.y, false);
    add(q.x, p.y, true);
  }
  mpq_div_2exp(sum, sum, 1);
  mpfr_t f;
  mpfr_init2(f, std::numeric_limits<T>::digits);
  mpfr_set_q(f, sum, MPFR_RNDN);
  const double nearest = mpfr_get_d(f, MPFR_RNDN);
  mpfr_clear(f);
  mpq_clears(sum, a, b, nullptr);
  return static_cast<T>(nearest);
}

template <class T>
void against_rationals(std::uint64_t seed, int trials) {
  test::random random(seed);
  double worst = 0, worst_fast = 0, worst_textbook = 0;
  long exact_wrong = 0;
  for (int t = 0; t < trials; ++t) {
    // a ring of size 1, offset by up to 10^15 (float: 10^6); or on a line but for the last bits
    const double offset = std::ldexp(1.0, static_cast<int>(random.integer(0, std::is_same_v<T, double> ? 50 : 20)));
    std::vector<irg::point<T, 2>> r;
    for (auto n = random.integer(3, 12); n > 0; --n) {
      const double x = random.unit(), y = t % 3 == 0 ? x * 0.3 : random.unit();
      r.push_back({static_cast<T>(offset + x), static_cast<T>(t % 2 ? offset + y : y)});
    }
    const T expected = oracle(r);
    if (expected == 0) {
      REQUIRE(irg::polygon_area(r) == 0);
      REQUIRE(irg::polygon_area_exact(r) == 0);
      continue;
    }
    exact_wrong += irg::polygon_area_exact(r) != expected;
    const T size = expected < 0 ? -expected : expected, ulp = std::nextafter(size, size * 2) - size;
    const auto off = [&](T v) { return std::fabs(static_cast<double>(v - expected)) / static_cast<double>(ulp); };
    worst = std::max(worst, off(irg::polygon_area(r)));
    if (t % 3 != 0) {
      worst_fast = std::max(worst_fast, off(irg::polygon_area_fast(r)));
      worst_textbook = std::max(worst_textbook, off(irg::textbook::polygon_area(r)));
    }
  }
  MESSAGE(trials, " rings: exact wrong ", exact_wrong, "; ulp off: default ", worst, ", fast ", worst_fast,
          ", textbook ", worst_textbook);
  CHECK(exact_wrong == 0);
  CHECK(worst <= 1);  // of the rounded value: the neighbour where the exact one is near the middle
}

TEST_CASE("polygon_area: against rationals, at offsets up to 10^15, nearly flat") {
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 300'000 : 5000;
  against_rationals<double>(91, trials);
  against_rationals<float>(92, trials);
}

TEST_CASE_TEMPLATE("polygon_area: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("polygon_area"), 0.51,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        return error_in_ulp(irg::polygon_area(ring), twice_area(ring).times_power_of_two(-1));
      },
      2000);
  sweep(
      named<T>("polygon_area_exact"), 0,
      [&](test::random& r, sizes which) {
        const auto ring = any_ring<T>(r, which);
        return irg::polygon_area_exact(ring) == test::nearest<T>(twice_area(ring).times_power_of_two(-1)) ? 0.0 : wrong;
      },
      2000);
  sweep(
      named<T>("polygon_area_fast and _textbook"), 1,
      [](test::random& r, sizes) {
        std::vector<point<T, 2>> ring(static_cast<std::size_t>(r.integer(3, 6)));
        const int reach = sizeof(T) == 4 ? 30 : 250;
        for (auto& p : ring)
          for (int k = 0; k < 2; ++k)
            p[k] = static_cast<T>(std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-reach, reach))));
        E triangles = 0, products = 0;  // in size
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto &p = ring[i], &q = after(ring, i);
          products = products + abs(of(p.x) * of(q.y)) + abs(of(q.x) * of(p.y));
          const E ux = of(p.x) - of(ring[0].x), uy = of(p.y) - of(ring[0].y);
          const E vx = of(q.x) - of(ring[0].x), vy = of(q.y) - of(ring[0].y);
          triangles = triangles + (abs(ux * vy) + abs(uy * vx)).times_power_of_two(-1);
        }
        const E area = twice_area(ring).times_power_of_two(-1);
        const auto n = static_cast<double>(ring.size());
        return std::fmax(share_of(irg::polygon_area_fast(ring), area, n + 4, triangles),
                         share_of(irg::textbook::polygon_area(ring), area, n + 1, products));
      },
      3000);
}
#endif

}  // namespace
