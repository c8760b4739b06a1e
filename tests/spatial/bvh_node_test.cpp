// SPDX-License-Identifier: MIT
#include <irg/spatial/bvh_node.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("bvh_node: leaves and what they hold") {
  using node = irg::bvh_node;
  CHECK_BOTH(node::is_leaf(node::leaf_of(5, 3)));
  CHECK_BOTH(!node::is_leaf(5));
  CHECK_BOTH(node::number_of(node::leaf_of(5, 3)) == 5);
  CHECK_BOTH(node::count_of(node::leaf_of(5, 3)) == 3);
  CHECK_BOTH(node::first_place(node::leaf_of(5, 3)) == 20);
  CHECK_BOTH(node::last_place(node::leaf_of(5, 3)) == 22);
  CHECK_BOTH(irg::bvh{} == irg::bvh{});
}

TEST_CASE("bvh_node: each bound in a place of its own; a tree that was not built has units of 1") {
  constexpr auto filled = [] {
    irg::bvh_node n{};
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < irg::bvh_node::width; ++k) {
        n.low(axis, k) = static_cast<float>(10 * axis + k);
        n.high(axis, k) = static_cast<float>(100 + 10 * axis + k);
      }
    return n;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 8; ++k) {
      const irg::bvh_node n = filled();
      CHECK(n.low(axis, k) == static_cast<float>(10 * axis + k));
      CHECK(n.high(axis, k) == static_cast<float>(100 + 10 * axis + k));
      CHECK(n.bounds[axis * 8 + k] == n.low(axis, k));
      CHECK(n.bounds[24 + axis * 8 + k] == n.high(axis, k));
    }
  CHECK_BOTH(filled().high(2, 7) == 127);
  CHECK_BOTH(irg::bvh{}.scale == 1);
}

}  // namespace
