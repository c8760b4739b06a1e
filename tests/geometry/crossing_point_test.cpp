// SPDX-License-Identifier: MIT
#include <irg/geometry/crossing_point.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "support/check_both.hpp"
#include "support/mixed_magnitudes.hpp"
#include "support/big_rational.hpp"

namespace {

using place = irg::point<double, 2>;
using line = irg::segment<double, 2>;

TEST_CASE("intersection_point: ordinary, degenerate and hostile lines") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK_BOTH(irg::intersection_point(line{{0, 0}, {3, 3}}, line{{0, 2}, {2, 0}}) == place{1, 1});
  CHECK_BOTH(irg::intersection_point(line{{0, 0}, {1, 1}}, line{{5, 0}, {5, 1}}) == place{5, 5});
  CHECK_BOTH(!irg::intersection_point(line{{0, 0}, {1, 1}}, line{{1, 0}, {2, 1}}));
  CHECK_BOTH(!irg::intersection_point(line{{0, 0}, {0, 0}}, line{{1, 0}, {2, 1}}));
  CHECK_BOTH(irg::intersection_point(line{{-most, -most}, {most, most}}, line{{least, most}, {least, -most}}) ==
             place{least, least});
}

#ifdef IRG_HAVE_MPFR
template <class T>
int wrong_crossings(test::random& r, test::mixed::sizes sizes, int times) {
  using number = test::big_rational;
  int wrong = 0;
  for (int i = 0; i < times; ++i) {
    T c[8];
    for (T& x : c) x = i % 5 == 0 ? static_cast<T>(r.integer(-3, 3)) : test::mixed::number<T>(r, sizes);
    const auto at = irg::intersection_point(irg::segment<T, 2>{{c[0], c[1]}, {c[2], c[3]}},
                                            irg::segment<T, 2>{{c[4], c[5]}, {c[6], c[7]}});
    number x[8];
    for (int k = 0; k < 8; ++k) x[k] = number(static_cast<double>(c[k]));
    const number ux = x[2] - x[0], uy = x[3] - x[1], vx = x[6] - x[4], vy = x[7] - x[5], across = ux * vy - uy * vx;
    if (across.sign() == 0) {
      wrong += at.has_value();
      continue;
    }
    const number t = ((x[4] - x[0]) * vy - (x[5] - x[1]) * vx) / across, want[2] = {x[0] + t * ux, x[1] + t * uy};
    constexpr T most = std::numeric_limits<T>::max();
    for (int k = 0; k < 2 && at; ++k) {
      const T near_by = test::nearest<T>(want[k]);
      wrong += !((*at)[k] == (near_by > most ? most : near_by < -most ? -most : near_by));
    }
    wrong += !at;
  }
  return wrong;
}

TEST_CASE("intersection_point: the nearest number to the exact one, for coordinates of all sizes") {
  test::random r(5);
  for (const auto sizes : test::mixed::all_sizes) {
    CHECK(wrong_crossings<double>(r, sizes, 300) == 0);
    CHECK(wrong_crossings<float>(r, sizes, 300) == 0);
  }
}
#endif

using S = irg::segment<double, 2>;
using F = irg::segment<float, 2>;
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
constexpr S across{{0, 0}, {4, 0}}, upward{{2, -3}, {2, 3}};

static_assert(irg::side_of_crossing(across, upward, S{{0, -1}, {1, -1}}) == irg::side::above);
static_assert(irg::side_of_crossing(upward, across, S{{1, -1}, {0, -1}}) == irg::side::below);
static_assert(irg::side_of_crossing(across, upward, S{{0, -2}, {4, 2}}) == irg::side::on);
static_assert(irg::side_of_crossing(F{{0, 0}, {4, 0}}, F{{2, -3}, {2, 3}}, F{{0, -1}, {1, -1}}) == irg::side::above);
static_assert(!irg::side_of_crossing(across, S{{0, 1}, {1, 1}}, upward));
static_assert(!irg::side_of_crossing(across, across, upward) &&
              !irg::side_of_crossing(across, S{{2, 0}, {2, 0}}, upward));
static_assert(irg::side_of_crossing(across, upward, S{{7, 7}, {7, 7}}) == irg::side::on);
static_assert(irg::side_of_crossing(S{{-most, -most}, {most, most}}, S{{-most, most}, {most, -most}},
                                    S{{-1, -least}, {1, -least}}) == irg::side::above);
static_assert(!irg::side_of_crossing(across, upward, S{{0, std::numeric_limits<double>::quiet_NaN()}, {1, 0}}));

TEST_CASE("side_of_crossing: what the compiler found is what runs") {
  S wide{{-most, -most}, {most, most}}, of{{-1, -least}, {1, -least}};
  CHECK(irg::side_of_crossing(wide, S{{-most, most}, {most, -most}}, of) == irg::side::above);
  CHECK(!irg::side_of_crossing(wide, wide, of));
  CHECK(irg::side_of_crossing(across, upward, S{{0, -2}, {4, 2}}) == irg::side::on);
}

#ifdef IRG_HAVE_MPFR
using Q = test::big_rational;

// Coefficients of the line through the ends, and the determinant of three such lines: Cramer's rule.
struct rational_line {
  Q a, b, c;
  explicit rational_line(const S& s)
      : a(Q(s.a[1]) - Q(s.b[1])), b(Q(s.b[0]) - Q(s.a[0])), c(-(a * Q(s.a[0]) + b * Q(s.a[1]))) {}
};
std::optional<irg::side> by_cramer(const S& first, const S& second, const S& of) {
  const rational_line l(first), m(second), n(of);
  const Q w = l.a * m.b - l.b * m.a;
  if (w.sign() == 0) return std::nullopt;
  const Q x = (l.b * m.c - l.c * m.b) / w, y = (l.c * m.a - l.a * m.c) / w;
  return static_cast<irg::side>((n.a * x + n.b * y + n.c).sign());
}

TEST_CASE("side_of_crossing: as Cramer's rule in rationals says, small integers to 600 decades") {
  std::mt19937_64 random(20261123);
  int on = 0, none = 0, sides[2] = {0, 0};
  for (int i = 0; i < 4000; ++i) {
    const auto number = [&] {
      const int whole = static_cast<int>(random() % 9) - 4;
      if (i % 2 == 0) return static_cast<double>(whole);
      const int exponent = i % 4 == 1 ? static_cast<int>(random() % 1990) - 995 : static_cast<int>(random() % 3) - 60;
      return std::ldexp(whole + static_cast<double>(random() >> 12) * 0x1p-52, exponent);
    };
    double v[12];
    for (double& x : v) x = number();
    const S first{{v[0], v[1]}, {v[2], v[3]}}, second{{v[4], v[5]}, {v[6], v[7]}};
    // Every third line starts in a common end: the crossing lies on it or next to it.
    const S of = i % 3 == 0 ? S{{v[0], v[1]}, {v[10], v[11]}} : S{{v[8], v[9]}, {v[10], v[11]}};
    const S met = i % 3 == 0 ? S{{v[0], v[1]}, {v[6], v[7]}} : second;
    const auto expected = by_cramer(first, met, of);
    REQUIRE(irg::side_of_crossing(first, met, of) == expected);
    REQUIRE(irg::side_of_crossing(met, first, of) == expected);
    if (!expected)
      ++none;
    else if (*expected == irg::side::on)
      ++on;
    else
      ++sides[*expected == irg::side::above];
  }
  CHECK(on > 500);
  CHECK(none > 50);
  CHECK(sides[0] > 500);
  CHECK(sides[1] > 500);
}
#endif

}  // namespace
