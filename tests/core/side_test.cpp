// SPDX-License-Identifier: MIT
#include <irg/core/side.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("side: the sign of the equation") {
  CHECK_BOTH((static_cast<irg::side>(-1) == irg::side::below && static_cast<irg::side>(1) == irg::side::above));
  CHECK_BOTH(irg::side{} == irg::side::on);
}

}  // namespace
