// SPDX-License-Identifier: MIT
#include <irg/visibility/guard_result.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("guard_result: what is not said is done, and empty") {
  CHECK(irg::guard_cover<float>{} == irg::guard_cover<float>{irg::guard_status::done, {}, 0, {}});
  CHECK(irg::guarded_part<double>{} == irg::guarded_part<double>{{}, 0});
}

}  // namespace
