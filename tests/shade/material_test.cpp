// SPDX-License-Identifier: MIT
#include <irg/shade/material.hpp>

#include <type_traits>

#include "support/check_both.hpp"
#include "support/rational.hpp"

TEST_CASE("material: a plain aggregate, of colours or of one channel") {
  using colours = irg::material<float>;
  using one_channel = irg::material<double, double>;
  static_assert(std::is_aggregate_v<colours> && std::is_trivially_copyable_v<colours>);
  static_assert(std::is_same_v<decltype(colours::diffuse), irg::rgb<float>>);
  static_assert(std::is_same_v<decltype(one_channel::diffuse), double>);
  static_assert(std::is_same_v<decltype(irg::material<test::rational>::diffuse), irg::rgb<test::rational>>);
  CHECK_BOTH(colours{} == colours{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1});
  CHECK_BOTH(one_channel{0.2, 0.5, 0.5, 2.0} != one_channel{0.2, 0.5, 0.5, 3.0});
}
