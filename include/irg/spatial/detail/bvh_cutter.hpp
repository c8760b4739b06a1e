// SPDX-License-Identifier: MIT
// Building a bvh whose primitives may be cut: in several leaves, each time in a box round a part of them.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/spatial/detail/bvh_builder.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The parts of an item's box below and above a plane across an axis: of primitives that are known by their boxes alone.
struct box_cut {
  static constexpr bool cuts = true;

  template <class Item>
  constexpr void operator()(const Item& whole, int axis, float plane, Item& low, Item& high) const noexcept {
    const Item from = whole;
    low = high = from;
    low.v[4 + axis] = greater(from.v[4 + axis], 0.0f - plane);
    high.v[axis] = greater(from.v[axis], plane);
  }
};

// The same of triangles: boxes round what their corners and sides have on each side.
//
// A side from a to b meets the plane at a + (b - a) * share, where the share is off by 3u of itself (u = 2^-53), the
// difference by u and the product by u of what they are, and the sum by u of what it is. Coordinates are at most 1, so
// that is less than 12u, of 32u that boxes are made larger by.
template <class At>
struct triangle_cut {
  static constexpr bool cuts = true;
  const At& at;
  double scale;

  template <class Item>
  constexpr void operator()(const Item& whole, int axis, float plane, Item& low, Item& high) const noexcept {
    constexpr double slack = 0x1p-48;
    const Item from = whole;
    const auto& triangle = at(number_of(from));
    const double x = widened(plane);
    double corner[3][3]{};
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) corner[i][k] = exactly_widened(triangle[i][k]) * scale;
    extent below{}, above{};
    for (int i = 0; i < 3; ++i) {
      const double(&a)[3] = corner[i], (&b)[3] = corner[i == 2 ? 0 : i + 1];
      const double to_a = a[axis] - x, to_b = b[axis] - x;
      if (to_a <= 0) below.hold(a, 0);
      if (to_a >= 0) above.hold(a, 0);
      if (!((to_a < 0 && to_b > 0) || (to_a > 0 && to_b < 0))) continue;
      const double share = to_a / (a[axis] - b[axis]);
      double p[3]{};
      for (int k = 0; k < 3; ++k) p[k] = k == axis ? x : a[k] + product(b[k] - a[k], share);
      below.hold(p, slack);
      above.hold(p, slack);
    }
    limit(low, from, below);
    limit(high, from, above);
    low.v[4 + axis] = greater(low.v[4 + axis], 0.0f - plane);
    high.v[axis] = greater(high.v[axis], plane);
  }

private:
  struct extent {
    double low[3]{2, 2, 2}, high[3]{-2, -2, -2};

    constexpr void hold(const double (&p)[3], double off) noexcept {
      for (int k = 0; k < 3; ++k) {
        low[k] = lesser(low[k], p[k] - off);
        high[k] = greater(high[k], p[k] + off);
      }
    }
  };

  // What a part has in common with the whole.
  template <class Item>
  static constexpr void limit(Item& part, const Item& from, const extent& e) noexcept {
    part = from;
    for (int k = 0; k < 3; ++k) {
      part.v[k] = greater(from.v[k], float_below(e.low[k]));
      part.v[4 + k] = greater(from.v[4 + k], float_below(-e.high[k]));
    }
  }
};

// Which primitives have been met before among the leaves, and where.
template <std::same_as<bvh> Tree>
constexpr void list_references(Tree& tree, std::size_t primitives, std::size_t held) {
  std::size_t references = 0;
  for (const std::uint32_t number : tree.order) references += number != bvh_node::none ? 1u : 0u;
  if (references == held) return;
  std::vector<std::uint32_t> last(primitives, bvh_node::none);
  tree.earlier.resize(tree.order.size(), bvh_node::none);
  tree.boxes.resize(tree.order.size() / bvh_node::block, bvh_node::none);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    for (std::uint32_t k = 0; k < bvh_node::width; ++k) {
      const std::uint32_t child = tree.nodes[n].child[k];
      if (child == bvh_node::none || !bvh_node::is_leaf(child)) continue;
      for (std::uint32_t i = bvh_node::first_place(child); i <= bvh_node::last_place(child); ++i) {
        tree.earlier[i] = std::exchange(last[tree.order[i]], i);
        tree.boxes[i / bvh_node::block] = static_cast<std::uint32_t>(n) * bvh_node::width + k;
      }
    }
}

struct cut_limits {
  std::size_t primitives;
  int bins;
  float spare, overlap;  // as in bvh_config
};

template <class Cut, class E>
constexpr void build_by_cuts(bvh& tree, std::vector<bvh_item>& items, const cut_limits& limits, const Cut& cut,
                             const E& executor) {
  bvh_item all = empty_item();
  for (const bvh_item& i : items) grow(all, i);
  const std::size_t held = items.size();
  const double spare = clamp(widened(limits.spare), 0.0, 4.0);
  items.resize(held + static_cast<std::size_t>(static_cast<double>(held) * spare), bvh_item{});
  using splits = area_splits<bvh_item, Cut>;
  splits source(items, limits.bins, cut, limits.overlap * area_of(all));
  bvh_grower<splits>(source, tree, bvh_grain)(
      {0, static_cast<std::uint32_t>(items.size()), 0, static_cast<std::uint32_t>(held), 0, 0, 0}, executor);
  list_references(tree, limits.primitives, held);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
