// SPDX-License-Identifier: MIT
// The way of a ray through a bvh: what is near first, or in any order.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/spatial/detail/walk_bvh_kernel.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// Calls visit(child) for the leaves that the ray meets, those near its beginning first; visit may make r.high less.
template <box_arithmetic A = box_arithmetic::portable, class Visit>
constexpr void walk_near_to_far(const bvh& tree, box_ray& r, const Visit& visit) {
  if (tree.nodes.empty()) return;
  if (walks_in_lanes())
    walk_sorted<pack<float, native_lanes<float>>, A>(tree.nodes.data(), r, visit);
  else
    walk_sorted<float, A>(tree.nodes.data(), r, visit);
}

/// Calls visit(child) for the leaves that the ray meets, in any order, until it gives true.
/// gives   whether it has
template <box_arithmetic A = box_arithmetic::portable, class Visit>
constexpr bool walk_anyhow(const bvh& tree, const box_ray& r, const Visit& visit) {
  if (tree.nodes.empty()) return false;
  if (walks_in_lanes()) return walk_unsorted<pack<float, native_lanes<float>>, A>(tree.nodes.data(), r, visit);
  return walk_unsorted<float, A>(tree.nodes.data(), r, visit);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
