// SPDX-License-Identifier: MIT
#include <irg/math/exact/nearest_float.hpp>

#include <limits>

#include "support/check_both.hpp"

TEST_CASE("compare_numbers: integers, floats, zeros, subnormal numbers, infinities") {
  constexpr double least = std::numeric_limits<double>::denorm_min(),
                   infinite = std::numeric_limits<double>::infinity();
  CHECK_BOTH(irg::compare_numbers(1, 2) == -1);
  CHECK_BOTH(irg::compare_numbers(2, 2) == 0);
  CHECK_BOTH(irg::compare_numbers(0.0, -0.0) == 0);
  CHECK_BOTH(irg::compare_numbers(least, 0.0) == 1);
  CHECK_BOTH(irg::compare_numbers(-least, least) == -1);
  CHECK_BOTH(irg::compare_numbers(-least, -2 * least) == 1);
  CHECK_BOTH(irg::compare_numbers(-infinite, infinite) == -1);
  CHECK_BOTH(irg::compare_numbers(1.5f, 1.25f) == 1);
  CHECK_BOTH(irg::compare_numbers(-1.5f, 1.25f) == -1);
}
