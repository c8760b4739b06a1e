// SPDX-License-Identifier: MIT
#include <irg/geometry/edge_equation.hpp>

#include <array>
#include <vector>

#include <irg/math/vec.hpp>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/rational.hpp"

namespace {

using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};

TEST_CASE("edge_through: the coefficients of the course's polygon") {
  using E = irg::edge_equation<double>;
  CHECK_BOTH(irg::edge_through(course[0], course[1]) == E{-150, 100, -12500});
  CHECK_BOTH(irg::edge_through(course[1], course[2]) == E{200, 150, -82500});
  CHECK_BOTH(irg::edge_through(course[2], course[3]) == E{100, -200, 0});
  CHECK_BOTH(irg::edge_through(course[3], course[0]) == E{-150, -50, 17500});
  CHECK_BOTH(irg::edge_through(I{3, 4}, I{3, 4}) == irg::edge_equation<int>{0, 0, 0});
}

TEST_CASE("edge_through: values of the criterion and of points") {
  using Q = irg::point<test::rational, 2>;
  constexpr std::array<Q, 4> ring{Q{50, 200}, Q{150, 350}, Q{300, 150}, Q{100, 50}};
  const auto value = [&](std::size_t i, const Q& p) {
    return irg::line_value(irg::edge_through(ring[i], ring[(i + 1) % 4]), p);
  };
  // V(i+2) against edge i: all negative, so clockwise; the reversed list has them positive.
  constexpr std::int64_t criterion[] = {-42500, -55000, -35000, -22500}, reversed[] = {55000, 42500, 22500, 35000};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(value(i, ring[(i + 2) % 4]) == test::rational(criterion[i]));
    const auto back = [&](std::size_t k) { return ring[3 - k % 4]; };
    CHECK(irg::line_value(irg::edge_through(back(i), back(i + 1)), back(i + 2)) == test::rational(reversed[i]));
  }
  const struct {
    Q p;
    std::int64_t values[4];
  } points[] = {{{150, 200}, {-15000, -22500, -25000, -15000}},
                {{100, 275}, {0, -21250, -45000, -11250}},
                {{50, 200}, {0, -42500, -35000, 0}},
                {{300, 350}, {-22500, 30000, -40000, -45000}},
                {{200, 100}, {-32500, -27500, 0, -17500}},
                {{0, 0}, {-12500, -82500, 0, 17500}},
                {{{401, 2}, 100}, {-32575, -27400, 50, -17575}},
                {{{399, 2}, 100}, {-32425, -27600, -50, -17425}}};
  for (const auto& [p, values] : points)
    for (std::size_t i = 0; i < 4; ++i) CHECK(value(i, p) == test::rational(values[i]));
}

TEST_CASE("edge_through: any number type") {
  using Q = irg::point<test::rational, 2>;
  CHECK(irg::edge_through(Q{{1, 3}, 0}, Q{0, {1, 2}}) == irg::edge_equation<test::rational>{{-1, 2}, {-1, 3}, {1, 6}});
  using F = irg::point<float, 2>;
  CHECK_BOTH(irg::edge_through(F{0x1p60f, 1}, F{1, 0x1p60f}).c == 0x1p120f);
}

}  // namespace

TEST_CASE("edge_through: of points of short integers") {
  using S = irg::point<short, 2>;
  CHECK_BOTH(irg::edge_through(S{1, 1}, S{4, 3}) == irg::edge_equation<short>{-2, 3, -1});
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("edge_through: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("edge_through"), 1,
      [](test::random& r, sizes which) {
        const auto p = points<T, 2, 2>(r, which);
        const auto e = irg::edge_through(p[0], p[1]);
        const E c = of(p[0].x) * of(p[1].y) - of(p[1].x) * of(p[0].y);
        if (e.a != test::nearest<T>(of(p[0].y) - of(p[1].y)) || e.b != test::nearest<T>(of(p[1].x) - of(p[0].x)))
          return wrong;
        const bool underflows = abs(c) < of(std::numeric_limits<T>::min());
        return error_in_ulp(e.c, c) - (underflows ? 2 : 0);
      },
      3000);
}

#endif
