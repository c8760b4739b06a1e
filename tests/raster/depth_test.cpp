// SPDX-License-Identifier: MIT
#include <irg/raster/depth.hpp>

#include <limits>

#include "support/check_both.hpp"

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

static_assert(irg::DepthOrder<irg::nearer_is_greater> && irg::DepthOrder<irg::nearer_is_less> &&
              irg::DepthOrder<irg::drawing_order>);
static_assert(!irg::DepthOrder<int>);

TEST_CASE("depth orders: strict, so that the first of two equal depths stays; NaN is never nearer") {
  CHECK_BOTH(irg::nearer_is_greater::nearer(0.5f, 0.25f));
  CHECK_BOTH(!irg::nearer_is_greater::nearer(0.5f, 0.5f));
  CHECK_BOTH(!irg::nearer_is_greater::nearer(nan, 0.5f));
  CHECK_BOTH(irg::nearer_is_less::nearer(0.25f, 0.5f));
  CHECK_BOTH(!irg::nearer_is_less::nearer(0.5f, 0.5f));
  CHECK_BOTH(!irg::nearer_is_less::nearer(nan, 0.5f));
  CHECK_BOTH(irg::drawing_order::nearer(0.25f, 0.5f));
  CHECK_BOTH(irg::drawing_order::nearer(0.5f, 0.5f));
}

TEST_CASE("depth orders: everything drawn is nearer than the cleared buffer") {
  CHECK_BOTH(irg::nearer_is_greater::nearer(1e-45f, irg::nearer_is_greater::farthest));
  CHECK_BOTH(irg::nearer_is_less::nearer(0.99999994f, irg::nearer_is_less::farthest));
  CHECK_BOTH(irg::drawing_order::nearer(0.0f, irg::drawing_order::farthest));
}

}  // namespace
