// SPDX-License-Identifier: MIT
#include <irg/raster/fill_rule.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("fill_rule: the two rules are told apart") {
  CHECK_BOTH(irg::fill_rule::even_odd != irg::fill_rule::non_zero);
}

}  // namespace
