// SPDX-License-Identifier: MIT
#include <irg/geometry/plane_through_points.hpp>

#include <array>
#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::hpoint;
using irg::plane;
using irg::plane_at;
using irg::plane_through;
using irg::plane_through_accurate;
using irg::point;
using irg::vec;
using test::rational;

namespace {

using P = point<double, 3>;
using H = hpoint<double, 3>;
using L = plane<double>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();

}  // namespace

TEST_CASE("plane_through_accurate: the course's values") {
  CHECK_BOTH(plane_through_accurate(P{1, 0, 0}, P{0, 2, 0}, P{0, 0, 3}) == L{6, 3, 2, -6});
  CHECK_BOTH(plane_through_accurate(P{1, 0, 1}, P{0, 1, 1}, P{1, 1, 2}) == L{1, 1, -1, 0});
  CHECK_BOTH(plane_through_accurate(P{0, 0, 4}, P{1, 0, 4}, P{0, 1, 4}) == L{0, 0, 1, -4});
  CHECK_BOTH(!plane_through_accurate(P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}));
  using Q = point<rational, 3>;
  CHECK_BOTH(plane_through_accurate(Q{1, 0, 0}, Q{0, 2, 0}, Q{0, 0, 3}) == plane<rational>{6, 3, 2, -6});
}

TEST_CASE("plane_through: homogeneous points") {
  CHECK_BOTH(plane_through(H{1, 0, 0, 1}, H{0, 2, 0, 1}, H{0, 0, 3, 1}) == L{6, 3, 2, -6});
  CHECK_BOTH(plane_through(H{1, 0, 1, 1}, H{0, 1, 1, 1}, H{1, 1, 2, 1}) == L{1, 1, -1, 0});  // through the origin
  CHECK_BOTH(plane_through(H{2, 0, 0, 2}, H{0, 2, 0, 1}, H{0, 0, 3, 1}) == L{12, 6, 4, -12});
  CHECK_BOTH(plane_through(H{0, 0, 4, 1}, H{1, 0, 0, 0}, H{0, 1, 0, 0}) == L{0, 0, 1, -4});  // two directions
  CHECK_BOTH(!plane_through(H{1, 2, 3, 1}, H{2, 4, 6, 2}, H{0, 0, 1, 1}));                   // one point twice
  CHECK_BOTH(!plane_through(H{0, 0, 0, 1}, H{1, 1, 1, 1}, H{2, 2, 2, 1}));
  CHECK_BOTH(!plane_through(H{1, 0, 0, 0}, H{0, 1, 0, 0}, H{0, 0, 1, 0}));  // the plane at infinity
  CHECK_BOTH(!plane_through(H{1, 0, 0, 1}, H{0, not_a_number, 0, 1}, H{0, 0, 1, 1}));
}

TEST_CASE("plane_at: a point and a normal") {
  CHECK_BOTH(plane_at(P{1, 2, 3}, vec<double, 3>{0, 0, 2}) == L{0, 0, 2, -6});
  CHECK_BOTH(!plane_at(P{1, 2, 3}, vec<double, 3>{0, -0.0, 0}));
  CHECK_BOTH(!plane_at(P{1, not_a_number, 3}, vec<double, 3>{0, 1, 0}));
}

TEST_CASE("plane_at: what has no plane, and other numbers") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  CHECK_BOTH(!plane_at(P{1, 2, 3}, vec<double, 3>{0, infinite, 0}));
  CHECK_BOTH(!plane_at(P{infinite, 2, 3}, vec<double, 3>{0, 0, 1}));
  CHECK_BOTH(plane_at(P{0, 0, 0}, vec<double, 3>{0, 0, 5e-324}) == L{0, 0, 5e-324, 0});
  CHECK_BOTH(plane_at(P{1, 10, 100}, vec<double, 3>{2, 3, 4}) == L{2, 3, 4, -432});
  // 1 + 2^-53 - 1: where a sum in doubles loses what is left.
  CHECK_BOTH(plane_at(P{1, 0x1p-53, -1}, vec<double, 3>{1, 1, 1}) == L{1, 1, 1, -0x1p-53});
  CHECK_BOTH(plane_at(point<rational, 3>{1, {1, 3}, 2}, vec<rational, 3>{3, 1, {1, 2}}) ==
             plane<rational>{3, 1, {1, 2}, {-13, 3}});
}

TEST_CASE("plane_through_accurate: ends of the range") {
  constexpr auto wide = *plane_through_accurate(P{huge, 0, 0}, P{0, huge, 0}, P{0, 0, huge});
  CHECK_BOTH(wide.a == wide.b);
  CHECK_BOTH(wide.b == wide.c);
  CHECK_BOTH(wide.a > 0);
  CHECK_BOTH(-wide.d / wide.a == huge);
  constexpr auto small = *plane_through_accurate(P{5e-324, 0, 0}, P{0, 5e-324, 0}, P{0, 0, 5e-324});
  CHECK_BOTH(small.a == 1);
  CHECK_BOTH(small.d == -5e-324);
  // One step off the line: a plane, and the right one.
  CHECK_BOTH(plane_through_accurate(P{0, 0, 0}, P{1, 1, 0}, P{2, 2 + 0x1p-51, 0}) == L{0, 0, 0x1p-51, 0});
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("plane_at: d is half an ulp from the exact one, at mixed magnitudes") {
  using E = test::exact;
  test::random r(6);
  double worst = 0;
  int planes = 0;
  const auto mixed = [&] { return std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-300, 300))); };
  for (int i = 0; i < test::trials(3000); ++i) {
    P p;
    vec<double, 3> n;
    for (int k = 0; k < 3; ++k) p[k] = mixed(), n[k] = mixed();
    if (i % 3 == 0) p[2] = -(p[0] * n[0] + p[1] * n[1]) / n[2];  // all but cancelled
    E d = 0;
    for (int k = 0; k < 3; ++k) d = d - E(p[k]) * E(n[k]);
    const auto got = plane_at(p, n);
    if (!got) continue;
    ++planes;
    CHECK((got->a == n[0] && got->b == n[1] && got->c == n[2]));
    if (d.sign() == 0 ? got->d != 0 : std::isfinite(d.rounded()) && std::fabs(d.rounded()) > 1e-307)
      worst = std::fmax(worst, test::error_in_ulp(got->d, d));
  }
  CHECK(worst <= 0.501);
  CHECK(planes > 2900);
}

TEST_CASE("plane_through_accurate: half an ulp from the exact coefficients") {
  using E = test::exact;
  test::random r(5);
  double worst = 0;
  int wrong = 0, planes = 0, collinear = 0;
  for (const test::spread kind : {test::spread::unit, test::spread::small_integers, test::spread::tenths,
                                  test::spread::tiny_steps, test::spread::wide, test::spread::subnormal})
    for (int i = 0; i < test::trials(300); ++i) {
      P p[3];
      for (P& q : p)
        for (int k = 0; k < 3; ++k)
          q[k] = test::any_coordinate<double>(r, kind) * (kind == test::spread::wide ? 0x1p-300 : 1);
      if (i % 4 == 0) p[2] = p[0] + (p[1] - p[0]) * 0.5;  // collinear, but for rounding
      E e[3][3], n[3];
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) e[k][l] = E(p[k][l]);
      E d = 0;
      for (int k = 0; k < 3; ++k) {  // sums over the edges, as Newell has them, halved
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        for (int l = 0; l < 3; ++l) n[k] = n[k] + e[l][u] * e[(l + 1) % 3][v] - e[l][v] * e[(l + 1) % 3][u];
        d = d - n[k] * e[1][k];
      }
      const auto got = plane_through_accurate(p[0], p[1], p[2]);
      const bool is_line = n[0].sign() == 0 && n[1].sign() == 0 && n[2].sign() == 0;
      wrong += is_line != !got;
      if (!got) {
        ++collinear;
        continue;
      }
      ++planes;
      // Where the coefficients were scaled, the factor is a power of two.
      int factor = 0;
      const double c[4] = {got->a, got->b, got->c, got->d};
      int k = 0;
      for (int l = 1; l < 3; ++l)
        if (std::fabs(c[l]) > std::fabs(c[k])) k = l;
      E want = n[k];
      while (want.rounded() == 0 || std::fabs(want.rounded()) < std::fabs(c[k]) * 0.7)
        want = want.times_power_of_two(1), ++factor;
      while (std::fabs(want.rounded()) > std::fabs(c[k]) * 1.4) want = want.times_power_of_two(-1), --factor;
      for (int l = 0; l < 4; ++l)
        worst = std::fmax(worst, test::error_in_ulp(c[l], (l < 3 ? n[l] : d).times_power_of_two(factor)));
    }
  MESSAGE(planes, " planes, ", collinear, " lines, worst ", worst, " ulp");
  CHECK(wrong == 0);
  CHECK(worst <= 0.501);
  CHECK(planes > 500);
  CHECK(collinear > 100);
}
#endif

TEST_CASE("plane_through: of points of short integers") {
  using S = irg::point<short, 3>;
  CHECK_BOTH(*irg::plane_through(S{0, 0, 1}, S{2, 0, 1}, S{0, 3, 1}) == irg::plane<short>{0, 0, 6, -6});
  CHECK_BOTH(*irg::plane_through_accurate(S{0, 0, 1}, S{2, 0, 1}, S{0, 3, 1}) == irg::plane<short>{0, 0, 6, -6});
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("plane_through_accurate, plane_at: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("plane_through_accurate"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto row = [&](std::size_t i) { return std::array<E, 4>{of(p[i].x), of(p[i].y), of(p[i].z), E(1)}; };
        return off_from_plane<T>(plane_through_accurate(p[0], p[1], p[2]), plane_coefficients(row(0), row(1), row(2)));
      },
      3000);
  sweep(
      named<T>("plane_at"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 2>(r, which);
        const auto got = plane_at(p[0], to_vec(p[1]));
        const E d = -dot(exactly(p[0]), exactly(p[1]));
        if (!got) return p[1] == point<T, 3>{0, 0, 0} ? 0.0 : wrong;
        return got->a == p[1].x && got->b == p[1].y && got->c == p[1].z ? error_in_ulp(got->d, d) : wrong;
      },
      3000);
}

#endif

TEST_CASE("plane_through: points in braces are of doubles") {
  CHECK_BOTH(irg::plane_through({1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == irg::plane<double>{1, 1, 1, -1});
  CHECK_BOTH(irg::plane_through_accurate({1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == irg::plane<double>{1, 1, 1, -1});
}
