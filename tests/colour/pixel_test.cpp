// SPDX-License-Identifier: MIT
#include <irg/colour/pixel.hpp>

#include <bit>
#include <sstream>
#include <type_traits>

#include "support/check_both.hpp"

namespace {

static_assert(sizeof(irg::rgba8) == 4 && sizeof(irg::bgra8) == 4 && sizeof(irg::rgb8) == 3 && sizeof(irg::bgr8) == 3);
static_assert(std::is_trivially_copyable_v<irg::rgba8> && std::is_aggregate_v<irg::rgb<float>>);

struct bytes {
  std::uint8_t at[4];
};

TEST_CASE("pixels: channels lie in memory in the order of the name; opaque unless said otherwise") {
  CHECK_BOTH(std::bit_cast<bytes>(irg::rgba8{1, 2, 3, 4}).at[0] == 1);
  CHECK_BOTH(std::bit_cast<bytes>(irg::rgba8{1, 2, 3}).at[3] == 255);
  CHECK_BOTH(std::bit_cast<bytes>(irg::bgra8{.b = 1, .g = 2, .r = 3}).at[2] == 3);
  CHECK_BOTH(irg::bgr8{.b = 1, .g = 2, .r = 3}.r == 3);
}

TEST_CASE("pixels: written by red, green, blue and opacity, as numbers") {
  std::ostringstream out;
  out << irg::rgba8{1, 2, 3} << irg::bgra8{.b = 3, .g = 2, .r = 65, .a = 4} << irg::bgr8{.b = 3, .g = 2, .r = 1}
      << irg::rgb8{7, 8, 9} << irg::rgb<float>{0.5f, 1, 2};
  CHECK(out.str() == "(1, 2, 3, 255)(65, 2, 3, 4)(1, 2, 3)(7, 8, 9)(0.5, 1, 2)");
}

TEST_CASE("rgb: light adds up, channel by channel, also past 1") {
  CHECK_BOTH(irg::rgb<double>{0.5, 1.0, 0.25} + irg::rgb<double>{0.5, 1.0, 0.5} == irg::rgb<double>{1.0, 2.0, 0.75});
  CHECK_BOTH(!(irg::rgb<int>{1, 2, 3} == irg::rgb<int>{1, 2, 4}));
}

}  // namespace
