// SPDX-License-Identifier: MIT
// Boxes for trees, and what a tree is asked to be.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/spatial/bvh.hpp>

#include "support/random.hpp"

namespace test {

/// Boxes with corners on a lattice of s: some flat, some equal, some points.
template <class T>
constexpr std::vector<irg::box<T, 3>> lattice_boxes(random& r, std::size_t count, double s, int reach = 8) {
  std::vector<irg::box<T, 3>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    irg::box<T, 3> b;
    for (int axis = 0; axis < 3; ++axis) {
      const auto low = r.integer(-reach, reach), high = low + (r.integer(0, 2) == 0 ? 0 : r.integer(0, 3));
      b.low[axis] = static_cast<T>(static_cast<double>(low) * s);
      b.high[axis] = static_cast<T>(static_cast<double>(high) * s);
    }
    boxes.push_back(b);
  }
  return boxes;
}

/// The numbers of levels below a node; a node or primitive that occurs twice, or a box that is not round its primitive,
/// makes it -1000.
template <class T>
constexpr int depth_of(const irg::bvh& tree, std::span<const irg::box<T, 3>> boxes, std::vector<int>& seen,
                       std::uint32_t at = 0) {
  int depth = 0;
  for (int k = 0; k < irg::bvh_node::width; ++k) {
    const std::uint32_t child = tree.nodes[at].child[k];
    if (child == irg::no_index) continue;
    if (!irg::bvh_node::is_leaf(child)) {
      if (child <= at || child >= tree.nodes.size()) return -1000;
      depth = std::max(depth, 1 + depth_of<T>(tree, boxes, seen, child));
      continue;
    }
    for (std::uint32_t i = irg::bvh_node::first_place(child); i <= irg::bvh_node::last_place(child); ++i) {
      const irg::box<T, 3>& b = boxes[tree.order[i]];
      if (++seen[tree.order[i]] != 1) return -1000;
      for (int axis = 0; axis < 3; ++axis)
        if (static_cast<double>(tree.nodes[at].low(axis, k)) > static_cast<double>(b.low[axis]) * tree.scale ||
            static_cast<double>(tree.nodes[at].high(axis, k)) < static_cast<double>(b.high[axis]) * tree.scale)
          return -1000;
    }
  }
  return depth;
}

// What a ray from below along z asks of a tree until z, by each box looked at alone.
inline irg::ray_counts asked_along_z(const irg::bvh& tree, double x, double y, double until) {
  irg::ray_counts counts{1, 0, 0, 0};
  if (tree.nodes.empty()) return counts;
  const auto is_in = [&](double v, float low, float high) {
    return static_cast<double>(low) <= v * tree.scale && v * tree.scale <= static_cast<double>(high);
  };
  std::vector<std::uint32_t> waiting{0};
  while (!waiting.empty()) {
    const irg::bvh_node& node = tree.nodes[waiting.back()];
    waiting.pop_back();
    ++counts.nodes;
    for (int k = 0; k < irg::bvh_node::width; ++k) {
      const std::uint32_t child = node.child[k];
      if (child == irg::no_index || !is_in(x, node.low(0, k), node.high(0, k)) ||
          !is_in(y, node.low(1, k), node.high(1, k)) || until * tree.scale < static_cast<double>(node.low(2, k)))
        continue;
      if (!irg::bvh_node::is_leaf(child)) {
        waiting.push_back(child);
        continue;
      }
      ++counts.leaves;
      counts.primitives += irg::bvh_node::count_of(child);
    }
  }
  return counts;
}

}  // namespace test
