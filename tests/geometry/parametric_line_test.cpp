// SPDX-License-Identifier: MIT
#include <irg/geometry/parametric_line.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/endless_number.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::homogeneous_line;
using irg::hpoint;
using irg::line_part;
using irg::parametric_line_through;
using irg::part_of_line;
using irg::point;
using irg::point_at;
using irg::point_between;
using irg::vec;
using test::rational;

namespace {
using P2 = point<double, 2>;
using P3 = point<double, 3>;
constexpr double undefined_number = std::numeric_limits<double>::quiet_NaN(),
                 huge = (std::numeric_limits<double>::max)();
}  // namespace

TEST_CASE("parametric_line: the course's values") {
  using Q = point<rational, 2>;
  constexpr auto line = *parametric_line_through(Q{1, 1}, Q{4, 3});
  CHECK_BOTH(point_at(line, -1) == Q{-2, -1});
  CHECK_BOTH(point_at(line, 0) == Q{1, 1});
  CHECK_BOTH(point_at(line, rational(1, 2)) == Q{rational(5, 2), 2});
  CHECK_BOTH(point_at(line, 1) == Q{4, 3});
  CHECK_BOTH(point_at(line, 2) == Q{7, 5});
  // The matrix of columns (B - A | A).
  constexpr auto m = columns_of(line);
  CHECK_BOTH(m == irg::mat<rational, 2, 2>{{{3, 1}, {2, 1}}});
}

TEST_CASE("parametric_line: homogeneous points") {
  constexpr homogeneous_line<double, 2> even{{1, 1, 1}, {4, 3, 1}}, uneven{{2, 2, 2}, {4, 3, 1}};
  CHECK_BOTH(point_at(even, 0.5) == hpoint<double, 2>{2.5, 2, 1});
  CHECK_BOTH(point_at(even, 2) == hpoint<double, 2>{7, 5, 1});
  // (1, 1) has weight 2: half the parameter is a third of the way, not half of it.
  CHECK_BOTH(to_cartesian(point_at(uneven, 0.5)) == P2{2, 2.5 / 1.5});
}

TEST_CASE("parametric_line: parts, equal points, NaN") {
  CHECK_BOTH(part_of_line(-0.001) == line_part::before_start);
  CHECK_BOTH(part_of_line(0.0) == line_part::segment);
  CHECK_BOTH(part_of_line(1.0) == line_part::segment);
  CHECK_BOTH(part_of_line(1.001) == line_part::after_end);
  CHECK_BOTH(part_of_line(undefined_number) == line_part::after_end);
  CHECK_BOTH(!parametric_line_through(P3{1, 2, 3}, P3{1, 2, 3}));
  CHECK_BOTH(!parametric_line_through(P2{0.0, 1}, P2{-0.0, 1}));
  CHECK_BOTH(!parametric_line_through(P3{1, undefined_number, 3}, P3{1, 2, 4}));
  constexpr double infinite_number = std::numeric_limits<double>::infinity();
  CHECK_BOTH(!parametric_line_through(P3{1, infinite_number, 3}, P3{2, infinite_number, 4}));
  CHECK_BOTH(!parametric_line_through(P2{0, 0}, P2{-infinite_number, 4}));
  CHECK_BOTH(parametric_line_through(P2{0, 0}, P2{5e-324, 0})->direction == vec<double, 2>{5e-324, 0});
}

TEST_CASE("point_between: numbers of other libraries") {
  using E = test::endless;
  CHECK(point_between(point<E, 2>{E(1), E(2)}, point<E, 2>{E(2), E(9)}, E(1) / E(2)) ==
        point<E, 2>{E(3) / E(2), E(11) / E(2)});
}

TEST_CASE("point_between: ends are exact, nothing overflows") {
  CHECK_BOTH(point_between(P2{0.1, huge}, P2{0.3, -huge}, 0) == P2{0.1, huge});
  CHECK_BOTH(point_between(P2{0.1, huge}, P2{0.3, -huge}, 1) == P2{0.3, -huge});
  CHECK_BOTH(point_between(P2{0.1, huge}, P2{0.3, -huge}, 0.5) == P2{0.2, 0});
  CHECK_BOTH(point_between(point<float, 2>{1, 2}, point<float, 2>{2, 4}, 0.25f) == point<float, 2>{1.25f, 2.5f});
  const P2 undefined = point_between(P2{0, undefined_number}, P2{1, 1}, 0.5);
  CHECK(undefined.x == 0.5);
  CHECK(undefined.y != undefined.y);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("point_between: half an ulp from the exact point") {
  test::random r(3);
  double worst = 0;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(1000); ++i) {
      const double a = test::any_coordinate<double>(r, kind), b = test::any_coordinate<double>(r, kind), t = r.unit();
      const test::exact want = test::exact(a) + test::exact(t) * (test::exact(b) - test::exact(a));
      worst = std::fmax(worst, test::error_in_ulp(point_between(P2{a, 0}, P2{b, 0}, t).x, want));
    }
  CHECK(worst <= 0.501);
}

TEST_CASE_TEMPLATE("point_between: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("point_between"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 2>(r, which);
        const T t = r.integer(0, 1) == 0 ? static_cast<T>(r.unit()) : number<T>(r, which);
        const auto got = point_between(p[0], p[1], t);
        const auto along = [&](int k) { return of(p[0][k]) * (E(1) - of(t)) + of(p[1][k]) * of(t); };
        return std::fmax(error_in_ulp(got.x, along(0)), error_in_ulp(got.y, along(1)));
      },
      3000);
}
#endif
