// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>

#include <irg/colour/palette.hpp>

#include "support/check_both.hpp"

namespace {

using grey_palette = irg::cyclic_palette<std::uint8_t, 3>;

TEST_CASE("cyclic_palette: stops at their places, round and round, both ways") {
  constexpr grey_palette p{{0, 100, 200}, 4};
  for (int round = -5; round <= 5; ++round)
    for (int stop = 0; stop < 3; ++stop) CHECK(p(12 * round + 4 * stop) == 100 * stop);
  CHECK_BOTH(p(2) == 50);    // 128/255 of the way
  CHECK_BOTH(p(-2) == 100);  // from the last to the first
}

TEST_CASE("cyclic_palette: even steps") {
  for (const int steps : {1, 2, 3, 5, 16, 100, 255, 256, 257, 1000, 1 << 29}) {
    const irg::cyclic_palette<double, 2> p{{0.0, 1.0}, steps};
    for (int i = 0; i < 2 * steps; i += 1 + steps / 300) {
      const double up = static_cast<double>(i) / steps, tent = up <= 1 ? up : 2 - up;
      REQUIRE(std::abs(p(i) - tent) <= 1.0 / 255);
    }
  }
}

TEST_CASE("cyclic_palette: one colour, and the ends of int") {
  constexpr irg::cyclic_palette<irg::rgba8, 1> one{{irg::rgba8{1, 2, 3, 4}}, 7};
  constexpr int least = std::numeric_limits<int>::min(), greatest = std::numeric_limits<int>::max();
  CHECK_BOTH((one(least) == irg::rgba8{1, 2, 3, 4}));
  CHECK_BOTH((one(greatest) == irg::rgba8{1, 2, 3, 4}));
  constexpr grey_palette p{{10, 20, 30}, 1};
  CHECK_BOTH(p(least) == 20);     // -2^31 = 3 * -715827883 + 1
  CHECK_BOTH(p(greatest) == 20);  // 2^31 - 1 = 3 * 715827882 + 1
}

}  // namespace
