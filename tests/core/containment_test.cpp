// SPDX-License-Identifier: MIT
#include <irg/core/containment.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("containment: from outside to inside, in this order") {
  CHECK_BOTH(irg::containment{} == irg::containment::outside);
  CHECK_BOTH(irg::containment::outside < irg::containment::crossing);
  CHECK_BOTH(irg::containment::crossing < irg::containment::inside);
}

}  // namespace
