// SPDX-License-Identifier: MIT
#include <irg/geometry/line.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::hpoint;
using irg::intersection_point;
using irg::line;
using irg::line_through;
using irg::line_value;
using irg::point;
using irg::side;
using irg::vertical_side_of;
using test::rational;

namespace {

using P = point<double, 2>;
using H = hpoint<double, 2>;
using L = line<double>;
using I = point<int, 2>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();

}  // namespace

TEST_CASE("line: the course's values") {
  CHECK_BOTH(line_through(H{1, 1, 1}, H{4, 3, 1}) == L{-2, 3, -1});
  CHECK_BOTH(line_through(H{4, 3, 1}, H{1, 1, 1}) == L{2, -3, 1});
  CHECK_BOTH(line_through(H{2, 2, 2}, H{4, 3, 1}) == L{-4, 6, -2});
  CHECK_BOTH(line_through(H{0, 5, 1}, H{0, 1, 1}) == L{4, 0, 0});
  CHECK_BOTH(line_through(P{1, 1}, P{4, 3}) == L{-2, 3, -1});
  CHECK_BOTH(line_through(I{4, 3}, I{1, 1}) == line<int>{2, -3, 1});
  constexpr line<rational> l{-2, 3, -1};
  CHECK_BOTH(line_value(l, point<rational, 2>{1, 3}) == rational(6));
  CHECK_BOTH(line_value(l, point<rational, 2>{4, 3}) == rational(0));
  CHECK_BOTH(line_value(l, point<rational, 2>{rational(5, 2), 2}) == rational(0));
  CHECK_BOTH(line_value(l, point<rational, 2>{4, 0}) == rational(-9));
  CHECK_BOTH(line_value(L{2, -3, 1}, P{1, 3}) == -6);
  CHECK_BOTH(line_value(L{2, -3, 1}, H{2, 6, 2}) == -12);
  CHECK_BOTH(intersection_point(L{1, 2, 3}, L{1, 2, -5}) == H{-16, 8, 0});  // parallel: a point at infinity
  CHECK_BOTH(intersection_point(L{2, -1, 0}, L{1, 1, -3}) == H{3, 6, 3});
  CHECK_BOTH(to_cartesian(*intersection_point(L{2, -1, 0}, L{1, 1, -3})) == P{1, 2});
}

TEST_CASE("line: equal points, NaN, ends of the range") {
  CHECK_BOTH(!line_through(P{1, 2}, P{1, 2}));
  CHECK_BOTH(!line_through(H{1, 2, 1}, H{-2, -4, -2}));
  CHECK_BOTH(!line_through(P{1, not_a_number}, P{1, 2}));
  CHECK_BOTH(!line_through(P{1, 2}, P{1, std::numeric_limits<double>::infinity()}));
  CHECK_BOTH(line_through(H{1, 0, 0}, H{0, 1, 0}) == L{0, 0, 1});  // the line at infinity
  CHECK_BOTH(!intersection_point(L{1, 2, 3}, L{2, 4, 6}));
  CHECK_BOTH(!intersection_point(L{1, 2, not_a_number}, L{2, 4, 6}));
  CHECK_BOTH(line_through(P{0, 0}, P{5e-324, 5e-324}) == L{-0x1p0, 0x1p0, 0});
  constexpr L wide = *line_through(P{-huge, huge}, P{huge, huge});
  CHECK_BOTH(wide.a == 0);
  CHECK_BOTH(-wide.c / wide.b == huge);
}

TEST_CASE("line: above and below are not left and right") {
  constexpr L forward{-2, 3, -1}, backward{2, -3, 1};
  CHECK_BOTH(vertical_side_of(forward, P{1, 3}) == side::above);
  CHECK_BOTH(vertical_side_of(backward, P{1, 3}) == side::above);  // on the right of it
  CHECK_BOTH(vertical_side_of(forward, P{4, 3}) == side::on);
  CHECK_BOTH(vertical_side_of(backward, P{4, 0}) == side::below);
  CHECK_BOTH(vertical_side_of(L{4, 0, 0}, P{4, 0}) == std::nullopt);
  CHECK_BOTH(vertical_side_of(L{1, -1, 0}, P{1, 1 + 0x1p-52}) == side::above);
  CHECK_BOTH(vertical_side_of(L{huge, -huge, 0}, P{huge, huge}) == side::on);
  CHECK_BOTH(vertical_side_of(line<int>{2, -3, 1}, I{1, 3}) == side::above);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("line: half an ulp from the exact coefficients") {
  using E = test::exact;
  test::random r(31);
  double worst = 0;
  for (const test::spread kind :
       {test::spread::unit, test::spread::small_integers, test::spread::tenths, test::spread::tiny_steps})
    for (int i = 0; i < test::trials(500); ++i) {
      double c[6];
      E e[6];
      for (int k = 0; k < 6; ++k) c[k] = test::any_coordinate<double>(r, kind), e[k] = E(c[k]);
      const auto through = line_through(P{c[0], c[1]}, P{c[2], c[3]});
      if (through) {
        worst = std::fmax(worst, test::error_in_ulp(through->a, e[1] - e[3]));
        worst = std::fmax(worst, test::error_in_ulp(through->b, e[2] - e[0]));
        worst = std::fmax(worst, test::error_in_ulp(through->c, e[0] * e[3] - e[2] * e[1]));
      }
      const auto common = intersection_point(L{c[0], c[1], c[2]}, L{c[3], c[4], c[5]});
      if (!common) continue;
      worst = std::fmax(worst, test::error_in_ulp(common->x, e[1] * e[5] - e[2] * e[4]));
      worst = std::fmax(worst, test::error_in_ulp(common->y, e[2] * e[3] - e[0] * e[5]));
      worst = std::fmax(worst, test::error_in_ulp(common->z, e[0] * e[4] - e[1] * e[3]));
    }
  MESSAGE("worst ", worst, " ulp");
  CHECK(worst <= 0.501);
}
#endif

TEST_CASE("line_through: of points of short integers") {
  using S = irg::point<short, 2>;
  CHECK_BOTH(*irg::line_through(S{1, 1}, S{4, 3}) == irg::line<short>{-2, 3, -1});
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("line_through, intersection_point: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  using line = irg::line<T>;
  sweep(
      named<T>("line_through"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 2>(r, which);
        return off_from_line<T>(line_through(p[0], p[1]),
                                minors({of(p[0].x), of(p[0].y), E(1)}, {of(p[1].x), of(p[1].y), E(1)}));
      },
      3000);
  sweep(
      named<T>("line_through and intersection_point, homogeneous"), 0.501,
      [&](test::random& r, sizes which) {
        auto c = numbers<T, 6>(r, which);
        if (r.integer(0, 3) == 0) c[4] = c[1], c[3] = c[0];
        const irg::hpoint<T, 2> p{c[0], c[1], c[2]}, q{c[3], c[4], c[5]};
        const auto e = rationals(c);
        const auto want = minors({e[0], e[1], e[2]}, {e[3], e[4], e[5]});
        const auto common = intersection_point(line{c[0], c[1], c[2]}, line{c[3], c[4], c[5]});
        const auto as_line = common ? std::optional(line{common->x, common->y, common->z}) : std::nullopt;
        return std::fmax(off_from_line<T>(line_through(p, q), want), off_from_line<T>(as_line, want));
      },
      3000);
}

#endif
