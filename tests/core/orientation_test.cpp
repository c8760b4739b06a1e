// SPDX-License-Identifier: MIT
#include <irg/core/orientation.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("orientation: the sign of the area") {
  CHECK_BOTH(static_cast<irg::orientation>(1) == irg::orientation::counter_clockwise);
  CHECK_BOTH(static_cast<irg::orientation>(-1) == irg::orientation::clockwise);
  CHECK_BOTH(irg::orientation{} == irg::orientation::degenerate);
}

}  // namespace
