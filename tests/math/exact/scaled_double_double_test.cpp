// SPDX-License-Identifier: MIT
#include <irg/math/exact/scaled_double_double.hpp>

#include <array>
#include <limits>
#include <type_traits>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"

namespace {

using irg::scaled_double_double;
constexpr scaled_double_double of(double x, int exponent = 0) { return {x, 0, exponent}; }

}  // namespace

TEST_CASE("scaled double-doubles: the four operations far beyond the range of double") {
  static_assert(irg::Scalar<scaled_double_double>);
  CHECK_BOTH(irg::rounded_to<double>(of(1.5, 5000) * of(3, -4999)) == 9.0);
  CHECK_BOTH(irg::rounded_to<double>(of(1, 3000) / of(4, 3001)) == 0.125);
  CHECK_BOTH(irg::rounded_to<double>(of(1, 60) - of(1, 0)) == 0x1p60 - 1);
  CHECK_BOTH(irg::sign_of(of(1, 300) - of(1, 900)) == -1);
  CHECK_BOTH(of(1, -900) < of(1, -899));
  CHECK_BOTH(irg::sign_of(of(0)) == 0);
  CHECK_BOTH(irg::rounded_to<double>(sqrt(of(2.25, 2000)) * of(1, -1000)) == 1.5);
  CHECK_BOTH(irg::rounded_to<double>(of(1, 2000)) == std::numeric_limits<double>::infinity());
  CHECK_BOTH(irg::rounded_to<double>(of(-1, -1074)) == -0x1p-1074);
  CHECK_BOTH(irg::rounded_to<float>(of(1, 2)) == 4.0f);
}

TEST_CASE("scaled double-doubles: vectors rounded one by one and together") {
  const irg::vec<scaled_double_double, 3> v{of(3), of(-6), of(1)};
  CHECK(irg::rounded_coordinates<irg::point<double, 3>>(v / of(4)) == irg::point<double, 3>{0.75, -1.5, 0.25});
  constexpr auto together = irg::rounded_together<double, 2>(std::array{of(1, 1500), of(1, 1499), of(1, 10)});
  static_assert(together[0] == 2 * together[1] && together[0] > 0x1p1000 && together[2] > 0 && together[2] < 0x1p-400);
}
