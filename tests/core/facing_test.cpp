// SPDX-License-Identifier: MIT
#include <irg/core/facing.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("facing: the values are signs, and culling left out means backs") {
  CHECK_BOTH((static_cast<irg::facing>(-1) == irg::facing::back && static_cast<irg::facing>(1) == irg::facing::front));
  CHECK_BOTH(irg::facing{} == irg::facing::edge_on);
  CHECK_BOTH(irg::face_culling{} == irg::face_culling::back);
}

}  // namespace
