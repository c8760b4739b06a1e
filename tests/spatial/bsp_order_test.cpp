// SPDX-License-Identifier: MIT
#include <irg/spatial/bsp_order.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("bsp_order: a place is nowhere until it is found") {
  CHECK_BOTH(irg::bsp_place{} == irg::bsp_place{irg::bsp_none, 0});
  CHECK_BOTH(irg::bsp_place{1, 0} != irg::bsp_place{1, -1});
  CHECK_BOTH(irg::bsp_choice{}.candidates > 0);
}

}  // namespace
