// SPDX-License-Identifier: MIT
// bvh: a tree of boxes round boxes (bounding volume hierarchy), eight to a node, for rays against anything that has a
// box. Its boxes are floats that stand round the given ones, so that no ray misses what it would meet; what is met is
// decided by whoever owns the primitives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/spatial/bvh_node.hpp>
#include <irg/spatial/detail/bvh_cutter.hpp>

namespace irg {

/// How a bvh is built: by the estimated cost of rays (surface area heuristic, in bins), or by place alone, along a
/// curve through space (Morton order): in a third of the time, for rays that take some more; or by cost with primitives
/// cut where their boxes overlap (spatial splits): in some twelve times the time, for long and slanting primitives.
enum class bvh_method { surface_area, morton, spatial_splits };

struct bvh_config {
  bvh_method method = bvh_method::surface_area;
  int bins = 16;  // 2 to 32: places along each axis at which a split is tried, in ranges of many primitives
  float spare = 1;  // spatial splits, 0 to 4: at most so many more references than primitives, as a share of them
  float overlap = 1e-5f;  // and tried where two halves' boxes have that share of the whole area in common
};

namespace detail {
inline namespace IRG_ABI {

// make_cut(scale) gives what cuts primitives.
template <Floating T, class E, class MakeCut>
constexpr bvh build_tree(std::span<const box<T, 3>> boxes, const bvh_config& config, const E& executor,
                         const MakeCut& make_cut) {
  bvh tree;
  std::vector<bvh_item> items = make_items(boxes, tree, executor);
  if (items.empty()) return tree;
  const int bins = clamp(config.bins, 2, 32);
  if (config.method == bvh_method::morton)
    build_by_morton(tree, items, executor);
  else if (config.method == bvh_method::surface_area)
    build_by_area(tree, items, bins, executor);
  else
    build_by_cuts(tree, items, {boxes.size(), bins, config.spare, config.overlap}, make_cut(tree.scale), executor);
  return tree;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The tree over boxes; primitive i is the one in boxes[i].
/// needs   fewer than 2^28 boxes, with spatial splits references to them
/// gives   a tree without nodes where there is no box to hold. Boxes that are empty, and those with a coordinate that
///         is NaN or infinite, are left out: no ray meets them. Flat boxes count as any other. Where many centres are
///         one, their boxes are halved as they come, so that the depth is at most 3 log2(n) + 18 for every input
///         With spatial splits a box may be in several leaves, in parts that cover it together
/// exact   the same tree, bit for bit, for every executor, compiler and instruction set
/// cost    O(n log n); allocates some 200 bytes a box, of which 100 stay. With threads, but for the first splits
/// source  Wald 2007 (bins); Wald, Benthin and Boulos 2008 (wide nodes); Lauterbach et al. 2009 (Morton order);
///         Stich, Friedrich and Dietrich 2009 (spatial splits)
template <Floating T, Executor E = sequential>
[[nodiscard]] constexpr bvh build_bvh(std::span<const box<T, 3>> boxes, const bvh_config& config = {},
                                      const E& executor = {}) {
  return detail::build_tree(boxes, config, executor, [](double) { return detail::box_cut{}; });
}

/// Fits the tree to boxes that have moved: what is in a node stays in it.
/// needs   as many boxes as the tree was built of. Those that were left out stay out; those that are to be left out now
///         are met by no ray
/// gives   a tree that holds all boxes as they are now. Rays take longer the more the order of places has changed: then
///         build it anew
/// exact   the same for every compiler and instruction set
/// cost    linear, a tenth of building it; nothing allocated
template <Floating T>
constexpr void refit(bvh& tree, std::span<const box<T, 3>> boxes) {
  detail::rescale(tree, boxes);
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    bvh_node& node = tree.nodes[n];
    for (int k = 0; k < bvh_node::width; ++k) {
      const std::uint32_t child = node.child[k];
      if (child == bvh_node::none) continue;
      if (bvh_node::is_leaf(child)) {
        detail::bvh_item around = detail::empty_item();
        for (std::uint32_t i = bvh_node::first_place(child); i <= bvh_node::last_place(child); ++i)
          detail::grow(around, detail::item_of(boxes[tree.order[i]], 0, tree.scale));
        detail::set_child(node, k, child, around);
      } else {
        detail::set_child(node, k, child, detail::box_round(tree.nodes[child]));
      }
    }
  }
}

}  // namespace IRG_ABI
}  // namespace irg
