// SPDX-License-Identifier: MIT
#include <irg/shade/per_channel.hpp>

#include <limits>

#include "support/check_both.hpp"

namespace {

using light = irg::rgb<float>;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

TEST_CASE("per_channel: one number, or each channel with its like") {
  constexpr auto product = [](float a, float b) { return a * b; };
  CHECK_BOTH(irg::per_channel(product, 3.0f, 0.5f) == 1.5f);
  CHECK_BOTH(irg::per_channel(product, light{1, 2, 3}, light{4, 5, 6}) == light{4, 10, 18});
  CHECK_BOTH(irg::per_channel([](float a) { return -a; }, light{1, 2, 3}) == light{-1, -2, -3});
  CHECK_BOTH(irg::per_channel([](float a, float b, float c) { return a + b * c; }, light{1, 2, 3}, light{1, 1, 1},
                              light{0, 1, 2}) == light{1, 3, 5});
}

TEST_CASE("largest_channel: of numbers and colours, NaN passed over") {
  CHECK_BOTH(irg::largest_channel(1.0f, 2.0f) == 2);
  CHECK_BOTH(irg::largest_channel(1.0f, light{0.5f, 3, -7}) == 3);
  CHECK_BOTH(irg::largest_channel(9.0f, light{0.5f, 3, -7}) == 9);
  CHECK_BOTH(irg::largest_channel(0.0f, light{no_number, 0.25f, no_number}) == 0.25f);
  CHECK_BOTH(irg::largest_channel(1.0f, no_number) == 1);
}

}  // namespace
