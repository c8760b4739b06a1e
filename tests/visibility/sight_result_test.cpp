// SPDX-License-Identifier: MIT
#include <irg/visibility/sight_result.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("sight_result: what is not said is closed, even-odd, done and nothing") {
  CHECK_BOTH(irg::sight_options{} == irg::sight_options{irg::obstacle_ends::closed, irg::fill_rule::even_odd});
  CHECK_BOTH(irg::sight_vertex<double>{} == irg::sight_vertex<double>{{0, 0}, irg::sight_stop::nothing, 0});
  CHECK(irg::visible_region<float>{} == irg::visible_region<float>{irg::visibility_status::ok, {}});
}

}  // namespace
