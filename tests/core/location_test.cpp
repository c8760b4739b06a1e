// SPDX-License-Identifier: MIT
#include <irg/core/location.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("location: from outside to inside, the boundary in the middle") {
  CHECK_BOTH((irg::location::outside < irg::location::boundary && irg::location::boundary < irg::location::inside));
  CHECK_BOTH(irg::location{} == irg::location::boundary);
}

}  // namespace
