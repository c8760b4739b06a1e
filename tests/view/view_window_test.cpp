// SPDX-License-Identifier: MIT
#include <irg/view/view_window.hpp>

#include <type_traits>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::centred_window;
using irg::view_window;
using test::rational;

TEST_CASE("view_window: centred, in every life and any number type") {
  CHECK_BOTH(centred_window(8.0, 6) == view_window<double>{-4, 4, -3, 3});
  CHECK_BOTH(centred_window(rational{7}, 3) == view_window<rational>{{-7, 2}, {7, 2}, {-3, 2}, {3, 2}});
  CHECK_BOTH(centred_window(-2.0f, 0) == view_window<float>{1, -1, 0, 0});  // mirrored, without height
  static_assert(std::is_aggregate_v<view_window<int>>);
}
