// SPDX-License-Identifier: MIT
#include <irg/math/constants.hpp>

#include <numbers>

#include "support/check_both.hpp"

static_assert(std::is_same_v<decltype(irg::pi<float>), const float>);

TEST_CASE("constants are rounded to nearest, each type on its own") {
  CHECK_BOTH(irg::pi<double> == 0x1.921fb54442d18p+1);
  CHECK_BOTH(irg::pi<float> == 0x1.921fb6p+1f);
  CHECK_BOTH(irg::two_pi<double> == 2 * irg::pi<double>);
  CHECK_BOTH(irg::half_pi<double> == irg::pi<double> / 2);
  CHECK_BOTH(irg::half_pi<float> == irg::pi<float> / 2);
  CHECK_BOTH(irg::e<double> == std::numbers::e);
  CHECK_BOTH(irg::e<float> == std::numbers::e_v<float>);
  CHECK_BOTH(irg::sqrt_3<double> == std::numbers::sqrt3);
  CHECK_BOTH(irg::golden_ratio<double> == std::numbers::phi);
}
