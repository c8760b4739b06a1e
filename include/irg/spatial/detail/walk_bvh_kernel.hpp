// SPDX-License-Identifier: MIT
// The loops of the way through a bvh.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include <irg/spatial/detail/box_test_kernel.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// A node leaves at most seven others waiting on each of the levels, of which there are at most 3*29 + 18.
inline constexpr int bvh_waiting = 7 * (3 * 29 + 18) + 8;

// A child and when the ray meets it, which is not before 0: in the order of times.
IRG_INLINE constexpr std::uint64_t waiting_child(std::uint32_t child, float time) noexcept {
  return std::uint64_t{std::bit_cast<std::uint32_t>(time)} << 32 | child;
}

template <class F, class Visit>
IRG_INLINE constexpr void walk_sorted(const bvh_node* nodes, box_ray& r, const Visit& visit) {
  const wide_box_ray<F> wide = widen_box_ray<F>(r);
  std::uint64_t waiting[bvh_waiting];
  std::uint64_t* top = waiting;
  std::uint32_t at = 0;
  for (;;) {
    if (!bvh_node::is_leaf(at)) {
      const bvh_node& node = nodes[at];
      float times[bvh_node::width];
      unsigned bits = meet_boxes<F>(node, wide, r.high, times);
      if (bits != 0) {
        unsigned k = static_cast<unsigned>(std::countr_zero(bits));
        bits &= bits - 1;
        if (bits == 0) {
          at = node.child[k];
          continue;
        }
        std::uint64_t nearest = waiting_child(node.child[k], times[k]);
        std::uint64_t* const base = top;
        do {  // the nearest is kept apart, the others stand with the latest lowest
          k = static_cast<unsigned>(std::countr_zero(bits));
          bits &= bits - 1;
          std::uint64_t child = waiting_child(node.child[k], times[k]);
          if (child < nearest) {
            const std::uint64_t farther = nearest;
            nearest = child;
            child = farther;
          }
          std::uint64_t* place = top++;
          for (; place != base && place[-1] < child; --place) *place = place[-1];
          *place = child;
        } while (bits != 0);
        at = static_cast<std::uint32_t>(nearest);
        continue;
      }
    } else if (at != bvh_node::none) {
      visit(at);
    }
    std::uint64_t next = 0;
    do {
      if (top == waiting) return;
      next = *--top;
    } while (r.high < std::bit_cast<float>(static_cast<std::uint32_t>(next >> 32)));
    at = static_cast<std::uint32_t>(next);
  }
}

template <class F, class Visit>
IRG_INLINE constexpr bool walk_unsorted(const bvh_node* nodes, const box_ray& r, const Visit& visit) {
  const wide_box_ray<F> wide = widen_box_ray<F>(r);
  std::uint32_t waiting[bvh_waiting];
  std::uint32_t* top = waiting;
  std::uint32_t at = 0;
  for (;;) {
    if (bvh_node::is_leaf(at)) {
      if (at != bvh_node::none && visit(at)) return true;
    } else {
      const bvh_node& node = nodes[at];
      float times[bvh_node::width];
      for (unsigned bits = meet_boxes<F>(node, wide, r.high, times); bits != 0; bits &= bits - 1)
        *top++ = node.child[static_cast<unsigned>(std::countr_zero(bits))];
    }
    if (top == waiting) return false;
    at = *--top;
  }
}

IRG_INLINE constexpr bool walks_in_lanes() noexcept { return has_lanes && !std::is_constant_evaluated(); }

}  // namespace IRG_ABI
}  // namespace irg::detail
