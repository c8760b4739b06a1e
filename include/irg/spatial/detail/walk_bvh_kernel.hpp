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
  int top = 0;
  std::uint32_t at = 0;
  for (;;) {
    if (!bvh_node::is_leaf(at)) {
      const bvh_node& node = nodes[at];
      float times[bvh_node::width];
      unsigned bits = meet_boxes<F>(node, wide, r.high, times);
      if (bits != 0) {
        int k = std::countr_zero(bits);
        bits &= bits - 1;
        if (bits == 0) {
          at = node.child[k];
          continue;
        }
        const int base = top;
        waiting[top++] = waiting_child(node.child[k], times[k]);
        do {  // the latest lowest
          k = std::countr_zero(bits);
          bits &= bits - 1;
          const std::uint64_t child = waiting_child(node.child[k], times[k]);
          int i = top++;
          for (; i > base && waiting[i - 1] < child; --i) waiting[i] = waiting[i - 1];
          waiting[i] = child;
        } while (bits != 0);
        at = static_cast<std::uint32_t>(waiting[--top]);
        continue;
      }
    } else if (at != bvh_node::none) {
      visit(at);
    }
    std::uint64_t next = 0;
    do {
      if (top == 0) return;
      next = waiting[--top];
    } while (r.high < std::bit_cast<float>(static_cast<std::uint32_t>(next >> 32)));
    at = static_cast<std::uint32_t>(next);
  }
}

template <class F, class Visit>
IRG_INLINE constexpr bool walk_unsorted(const bvh_node* nodes, const box_ray& r, const Visit& visit) {
  const wide_box_ray<F> wide = widen_box_ray<F>(r);
  std::uint32_t waiting[bvh_waiting];
  int top = 0;
  waiting[top++] = 0;
  while (top > 0) {
    const std::uint32_t at = waiting[--top];
    if (bvh_node::is_leaf(at)) {
      if (at != bvh_node::none && visit(at)) return true;
      continue;
    }
    const bvh_node& node = nodes[at];
    float times[bvh_node::width];
    for (unsigned bits = meet_boxes<F>(node, wide, r.high, times); bits != 0; bits &= bits - 1)
      waiting[top++] = node.child[std::countr_zero(bits)];
  }
  return false;
}

IRG_INLINE constexpr bool walks_in_lanes() noexcept { return has_lanes && !std::is_constant_evaluated(); }

}  // namespace IRG_ABI
}  // namespace irg::detail
