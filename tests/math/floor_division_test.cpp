// SPDX-License-Identifier: MIT
#include <irg/math/floor_division.hpp>

#include <cstdint>
#include <limits>

#include "support/check_both.hpp"

namespace {

TEST_CASE("floor_div, ceil_div: by hand, at the ends and of 128 bits") {
  CHECK_BOTH(irg::floor_div(7, 2) == 3);
  CHECK_BOTH(irg::floor_div(-7, 2) == -4);
  CHECK_BOTH(irg::floor_div(-8, 2) == -4);
  CHECK_BOTH(irg::ceil_div(7, 2) == 4);
  CHECK_BOTH(irg::ceil_div(-7, 2) == -3);
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min(),
                         most = std::numeric_limits<std::int64_t>::max();
  CHECK_BOTH(irg::floor_div(least, std::int64_t{1}) == least);
  CHECK_BOTH(irg::floor_div(least, most) == -2);
  CHECK_BOTH(irg::ceil_div(least, most) == -1);
  CHECK_BOTH(irg::ceil_div(most, most - 1) == 2);
  CHECK_BOTH(irg::floor_div(-(irg::int128{1} << 100), irg::int128{3}) * 3 == -(irg::int128{1} << 100) - 2);
}

TEST_CASE("floor_div, ceil_div: quotients that the remainder's sign tells (oracle)") {
  for (int n = -200; n <= 200; ++n)
    for (int d = 1; d <= 30; ++d) {
      const int floor = irg::floor_div(n, d), ceil = irg::ceil_div(n, d);
      REQUIRE(floor * d <= n);
      REQUIRE((floor + 1) * d > n);
      REQUIRE(ceil * d >= n);
      REQUIRE((ceil - 1) * d < n);
    }
}

}  // namespace
