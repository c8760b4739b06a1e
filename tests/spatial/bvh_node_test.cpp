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

}  // namespace
