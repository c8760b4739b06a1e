// SPDX-License-Identifier: MIT
#include <irg/geometry/boolean_operation.hpp>

#include "support/check_both.hpp"

TEST_CASE("boolean_operation: four operations, told apart") {
  using enum irg::boolean_operation;
  CHECK_BOTH(intersection != unite);
  CHECK_BOTH(difference != symmetric_difference);
}
