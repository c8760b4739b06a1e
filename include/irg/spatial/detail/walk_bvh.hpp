// SPDX-License-Identifier: MIT
// The way of a ray through a bvh: what is near first, or in any order.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/spatial/detail/walk_bvh_kernel.hpp>

namespace irg::detail::inline IRG_ABI {

/// Calls visit(child) for the leaves that the ray meets, those near its beginning first; visit may make r.high less.
template <box_arithmetic A = box_arithmetic::portable, class Visit, RayCounts C>
constexpr void walk_near_to_far(const bvh& tree, box_ray& r, C& counts, const Visit& visit) {
  if (tree.nodes.empty()) return;
  if (walks_in_lanes())
    walk_sorted<pack<float, native_lanes<float>>, A>(tree.nodes.data(), r, visit, counts);
  else
    walk_sorted<float, A>(tree.nodes.data(), r, visit, counts);
}

/// Calls visit(child) for the leaves that the ray meets, in any order, until it gives true.
/// gives   whether it has
template <box_arithmetic A = box_arithmetic::portable, class Visit, RayCounts C>
constexpr bool walk_anyhow(const bvh& tree, const box_ray& r, C& counts, const Visit& visit) {
  if (tree.nodes.empty()) return false;
  if (walks_in_lanes()) return walk_unsorted<pack<float, native_lanes<float>>, A>(tree.nodes.data(), r, visit, counts);
  return walk_unsorted<float, A>(tree.nodes.data(), r, visit, counts);
}

// Whether the leaf with this place of the order is the first of those with its primitive for which meets(box) holds.
// A leaf whose box is met is come to: the boxes round it are met by the same arithmetic.
template <class Meets>
IRG_INLINE constexpr bool is_first_met(const bvh& tree, std::uint32_t place, const Meets& meets) {
  if (tree.earlier.empty()) return true;
  for (std::uint32_t i = tree.earlier[place]; i != no_index; i = tree.earlier[i])
    if (meets(tree.boxes[i / bvh_node::block])) return false;
  return true;
}
template <box_arithmetic A>
constexpr bool meets_one_box(const bvh& tree, const box_ray& r, std::uint32_t box) noexcept {
  const auto meets = [&]<class F>(const F&) {
    float times[bvh_node::width];
    const unsigned bits = meet_boxes(tree.nodes[box / bvh_node::width], widen_box_ray<F, A>(r), r.high, times);
    return (bits >> box % bvh_node::width & 1) != 0;
  };
  return walks_in_lanes() ? meets(pack<float, native_lanes<float>>{}) : meets(0.0f);
}
template <box_arithmetic A = box_arithmetic::portable>
IRG_INLINE constexpr bool is_first_met(const bvh& tree, std::uint32_t place, const box_ray& r) {
  return is_first_met(tree, place, [&](std::uint32_t box) { return meets_one_box<A>(tree, r, box); });
}

}  // namespace irg::detail::inline IRG_ABI
