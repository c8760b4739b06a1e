// SPDX-License-Identifier: MIT
#include <irg/geometry/intersect_planes.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::flat_relation;
using irg::intersect_planes;
using irg::parametric_line;
using irg::plane;
using irg::point;
using irg::three_planes_relation;
using test::rational;

namespace {

using P = point<double, 3>;
using L = plane<double>;
using Q = point<rational, 3>;
constexpr auto none = flat_relation::none, crossing = flat_relation::crossing, parallel = flat_relation::parallel,
               coincident = flat_relation::coincident;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();

}  // namespace

TEST_CASE("intersect_planes: two planes by hand") {
  CHECK_BOTH(intersect_planes(L{0, 0, 1, 0}, L{1, 0, 0, -1}).line == parametric_line<double, 3>{{1, 0, 0}, {0, 1, 0}});
  CHECK_BOTH(intersect_planes(L{1, 0, 0, -1}, L{0, 1, 0, -2}).line == parametric_line<double, 3>{{1, 2, 0}, {0, 0, 1}});
  using R = plane<rational>;
  CHECK_BOTH(intersect_planes(R{0, 0, 1, 0}, R{1, 1, 1, -3}).line ==
             parametric_line<rational, 3>{{rational(3, 2), rational(3, 2), 0}, {-1, 1, 0}});
  CHECK_BOTH(intersect_planes(L{1, 2, 3, 4}, L{2, 4, 6, 9}).relation == parallel);
  CHECK_BOTH(intersect_planes(L{1, 2, 3, 4}, L{-2, -4, -6, -8}).relation == coincident);
  CHECK_BOTH(intersect_planes(L{0, 0, 0, 4}, L{2, 4, 6, 9}).relation == none);
  CHECK_BOTH(intersect_planes(L{1, 2, 3, not_a_number}, L{2, 4, 7, 9}).relation == none);
  CHECK_BOTH(intersect_planes(L{1, 2, 3, not_a_number}, L{2, 4, 6, 9}).relation == none);
  CHECK_BOTH(intersect_planes(L{1, 0, 0, huge}, L{1, 0x1p-52, 0, huge}).line.origin == P{-huge, 0, 0});
  CHECK_BOTH(intersect_planes(L{huge, 0, 0, 0}, L{0, huge, 0, 0}).line.direction.z > 0);
  CHECK_BOTH(intersect_planes(L{5e-324, 0, 0, 0}, L{0, 5e-324, 0, 0}).line.direction == irg::vec<double, 3>{0, 0, 1});
}

TEST_CASE("intersect_planes: three planes") {
  using R = three_planes_relation;
  constexpr auto of = [](const L& a, const L& b, const L& c) constexpr { return intersect_planes(a, b, c); };
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 1, 0, -2}, {0, 0, 1, -3}).at == P{1, 2, 3});
  CHECK_BOTH(of({1, 1, 0, -3}, {1, -1, 0, 1}, {1, 1, 1, -6}).at == P{1, 2, 3});
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 1, 0, -2}, {1, 1, 0, -3}).relation == R::line);
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 1, 0, -2}, {1, 1, 0, -3}).line == parametric_line<double, 3>{{1, 2, 0}, {0, 0, 1}});
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 1, 0, -2}, {1, 1, 0, -4}).relation == R::prism);
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 1, 0, -2}, {2, 0, 0, -4}).relation == R::parallel);
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 1, 0, -2}, {2, 0, 0, -2}).relation == R::line);
  CHECK_BOTH(of({1, 0, 0, -1}, {-1, 0, 0, 1}, {2, 0, 0, -2}).relation == R::coincident);
  CHECK_BOTH(of({1, 0, 0, -1}, {-1, 0, 0, 1}, {2, 0, 0, -3}).relation == R::parallel);
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 0, 0, 1}, {2, 0, 0, -3}).relation == R::none);
  CHECK_BOTH(of({1, 0, 0, -1}, {0, 1, 0, not_a_number}, {2, 0, 1, -3}).relation == R::none);
}

#ifdef IRG_HAVE_MPFR
namespace {
using E = test::exact;
E of(double x) { return E(x); }
E determinant(const E (&m)[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
}  // namespace

TEST_CASE("intersect_planes: positions against rationals, all magnitudes") {
  test::random r(29);
  double worst = 0;
  int wrong = 0, points = 0, lines = 0, none_of_them = 0;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(150); ++i) {
      L p[3];
      double c[3][4];
      for (int k = 0; k < 3; ++k) {
        for (double& x : c[k]) x = test::any_coordinate<double>(r, kind);
        if (i % 4 == 1 && k == 2)
          for (int l = 0; l < 4; ++l) c[2][l] = c[0][l] + c[1][l];  // one pencil, but for rounding
        if (i % 8 == 2 && k == 1)
          for (int l = 0; l < 3; ++l) c[1][l] = -2 * c[0][l];
        p[k] = {c[k][0], c[k][1], c[k][2], c[k][3]};
      }
      bool usable = true;
      for (const auto& row : c) {
        for (const double x : row) usable = usable && std::isfinite(x);
        usable = usable && (row[0] != 0 || row[1] != 0 || row[2] != 0);
      }
      if (!usable) continue;
      // Two planes: the nearest point x satisfies both equations and is at right angles to the direction.
      const auto two = intersect_planes(p[0], p[1]);
      E u[3];
      for (int k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        u[k] = of(c[0][a]) * of(c[1][b]) - of(c[0][b]) * of(c[1][a]);
      }
      const bool crosses = u[0].sign() != 0 || u[1].sign() != 0 || u[2].sign() != 0;
      wrong += crosses != (two.relation == crossing);
      const auto solve = [&](const E(&rows)[3][3], const E(&right)[3], int column) {
        E m[3][3];
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) m[a][b] = b == column ? right[a] : rows[a][b];
        return determinant(m) / determinant(rows);
      };
      if (crosses && two.relation == crossing) {
        ++lines;
        E rows[3][3], right[3] = {-of(c[0][3]), -of(c[1][3]), E(0)};
        for (int k = 0; k < 3; ++k) rows[0][k] = of(c[0][k]), rows[1][k] = of(c[1][k]), rows[2][k] = u[k];
        for (int k = 0; k < 3; ++k)
          worst = std::fmax(worst, test::error_in_ulp(two.line.origin[k], solve(rows, right, k)));
      }
      const auto three = intersect_planes(p[0], p[1], p[2]);
      E rows[3][3], right[3];
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) rows[k][l] = of(c[k][l]);
        right[k] = -of(c[k][3]);
      }
      const bool meets = determinant(rows).sign() != 0;
      wrong += meets != (three.relation == three_planes_relation::point);
      none_of_them += !meets;
      if (!meets || three.relation != three_planes_relation::point) continue;
      ++points;
      for (int k = 0; k < 3; ++k) worst = std::fmax(worst, test::error_in_ulp(three.at[k], solve(rows, right, k)));
    }
  MESSAGE(points, " points, ", lines, " lines, ", none_of_them, " without a point, worst ", worst, " ulp");
  CHECK(wrong == 0);
  CHECK(worst <= 0.501);
  CHECK(points > 400);
  CHECK(lines > 400);
}

TEST_CASE_TEMPLATE("intersect_planes: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  using test::mixed::determinant;
  sweep(
      named<T>("intersect_planes, the line"), 0.501,
      [](test::random& r, sizes which) {
        auto c = numbers<T, 8>(r, which);
        if (r.integer(0, 2) == 0) c[4] = c[0], c[5] = c[1];
        const auto e = rationals(c);
        const std::array<E, 3> n{e[0], e[1], e[2]}, m{e[4], e[5], e[6]}, u = minors(n, m);
        const auto got = intersect_planes(irg::plane<T>{c[0], c[1], c[2], c[3]}, irg::plane<T>{c[4], c[5], c[6], c[7]});
        if ((got.relation == irg::flat_relation::crossing) != !all_zero(u)) return wrong;
        if (all_zero(u)) return 0.0;
        const auto& along = got.line.direction;
        double worst = error_together<T, 3>({along.x, along.y, along.z}, u, 3);
        const E whole = determinant(n, m, u);
        const std::array<std::array<E, 3>, 3> rows{{n, m, u}};
        for (std::size_t k = 0; k < 3; ++k) {
          const E over = replaced(rows, {-e[3], -e[7], E(0)}, k);
          worst = std::fmax(worst, quotient_error(got.line.origin[static_cast<int>(k)], over, whole));
        }
        return worst;
      },
      1000);
}
#endif
