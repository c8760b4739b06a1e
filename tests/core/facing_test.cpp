// SPDX-License-Identifier: MIT
#include <irg/core/facing.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("facing: options left out mean fronts, and backs left out") {
  CHECK_BOTH(irg::facing{} == irg::facing::front);
  CHECK_BOTH(irg::face_culling{} == irg::face_culling::back);
}

}  // namespace
