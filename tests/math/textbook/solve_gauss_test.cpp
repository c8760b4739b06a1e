// SPDX-License-Identifier: MIT
#include <irg/math/textbook/solve_gauss.hpp>

#include <cmath>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::mat;
using irg::vec;
using test::rational;

TEST_CASE("textbook::solve_gauss: Hank's values") {
  using R = rational;
  CHECK_BOTH(*irg::textbook::solve_gauss(mat<R, 3, 4>{{{2, 1, -1, 8}, {-3, -1, 2, -11}, {-2, 1, 2, -3}}}) ==
             vec<R, 3>{2, 3, -1});
  CHECK_BOTH(*irg::textbook::solve_gauss(mat<R, 3, 4>{{{0, 2, 1, 7}, {1, 1, 1, 6}, {2, 0, -1, -1}}}) ==
             vec<R, 3>{1, 2, 3});
  CHECK_BOTH(!irg::textbook::solve_gauss(mat<R, 2, 3>{{{1, 2, 3}, {2, 4, 6}}}));
  // Small is called singular, which it is not; a smaller threshold finds the solution.
  constexpr mat<double, 2, 3> tiny{{{1e-7, 0, 1e-7}, {0, 1e-7, 1e-7}}};
  CHECK_BOTH(!irg::textbook::solve_gauss(tiny));
  CHECK_BOTH(*irg::textbook::solve_gauss(tiny, 1e-30) == vec<double, 2>{1, 1});
  CHECK_BOTH(solve_gauss(tiny).x == vec<double, 2>{1, 1});
  // A pivot that is only just no zero costs digits: 1/(1 - 1e-5) is 1.0000100001000010...
  constexpr auto rough = *irg::textbook::solve_gauss(mat<double, 2, 3>{{{1e-5, 1, 1}, {1, 1, 2}}});
  CHECK_BOTH((rough.x == 1.0000100000906968 && rough.y == 0.999989999899999));
  CHECK(std::abs(solve_gauss(mat<double, 2, 3>{{{1e-5, 1, 1}, {1, 1, 2}}}).x.x - 1 / (1 - 1e-5)) < 3e-16);
}

TEST_CASE("textbook::back_substitution: Hank's values, wrong as printed") {
  using R = rational;
  CHECK_BOTH(irg::textbook::back_substitution(mat<R, 2, 3>{{{1, 2, 5}, {0, 3, 6}}}) == vec<R, 2>{R(2, 9), R(1, 2)});
}
