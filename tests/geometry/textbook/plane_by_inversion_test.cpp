// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/plane_by_inversion.hpp>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::plane;
using test::rational;

namespace {

using Q = irg::hpoint<rational, 3>;
using H = irg::hpoint<double, 3>;

}  // namespace

TEST_CASE("textbook::plane_by_inversion: the course's values") {
  constexpr Q a{1, 0, 0, 1}, b{0, 2, 0, 1}, c{0, 0, 3, 1};
  // As printed, with D = 5 in the matrix: the last coefficient is 1/5.
  constexpr auto printed = irg::textbook::plane_by_inversion(a, b, c, 5);
  CHECK_BOTH(printed.value == plane<rational>{rational(-1, 5), rational(-1, 10), rational(-1, 15), rational(1, 5)});
}

TEST_CASE("textbook::plane_by_inversion: where there is none") {
  CHECK_BOTH(irg::textbook::plane_by_inversion(H{1, 0, 1, 1}, H{0, 1, 1, 1}, H{1, 1, 2, 1}, 1).status ==
             irg::inversion_outcome::through_origin);
  CHECK_BOTH(irg::textbook::plane_by_inversion(H{1, 0, 0, 1}, H{2, 0, 0, 1}, H{3, 0, 0, 1}, 1).status ==
             irg::inversion_outcome::collinear);
  // A divisor of subnormal size leaves no D: 1/D is beyond the range.
  CHECK_BOTH(irg::textbook::plane_by_inversion(H{1, 0, 0, 1}, H{0, 2, 0, 1}, H{0, 0, 3, 1}, 0x1p1023).status ==
             irg::inversion_outcome::plane);
}
