// SPDX-License-Identifier: MIT
#include <irg/geometry/sign_of.hpp>

#include "support/check_both.hpp"

TEST_CASE("sign_of and quotient_of are found by their former path") {
  CHECK_BOTH(irg::sign_of<1>([](const auto& x, const auto& y) { return x - y; }, 2.0, 3.0) == -1);
}
