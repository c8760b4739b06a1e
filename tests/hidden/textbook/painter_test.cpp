// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/painter.hpp>

#include <limits>

#include "support/check_both.hpp"

namespace {

using points = std::vector<irg::point<double, 3>>;

TEST_CASE("textbook::painter_order: by the centres' distance, not by depth; equally far ones by number") {
  constexpr auto order = [](const points& centres, const irg::point<double, 3>& camera) {
    return irg::textbook::painter_order(centres, camera);
  };
  using numbers = std::vector<std::uint32_t>;
  CHECK_BOTH(order({{0, 0, 1}, {9, 0, 2}, {0, 0, 5}}, {0, 0, 0}) == numbers{1, 2, 0});
  CHECK_BOTH(order({{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}, {0, 0, 0}) == numbers{0, 1, 2});
  CHECK_BOTH(order({}, {0, 0, 0}).empty());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), large = 1.7e308;
  CHECK_BOTH(order({{nan, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 0, 0}) == numbers{2, 1});
  // Their distances are infinite, or 0, as doubles.
  CHECK_BOTH(order({{large, 0, 0}, {large, large, 0}, {-large, large, large}}, {-large, 0, 0}) == numbers{1, 0, 2});
  CHECK_BOTH(order({{1e-320, 0, 0}, {2e-320, 0, 0}}, {0, 0, 0}) == numbers{1, 0});
}

}  // namespace
