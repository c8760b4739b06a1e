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

// Where a walk stands: what waits, the next on top.
struct bvh_walk {
  std::uint64_t waiting[bvh_waiting];
  std::uint64_t* top;
};

// The next leaf in the order of times; none at the end, and for an empty box that a ray meets whose times are not
// numbers. It stands apart from what is done with leaves, so that a ray's
// numbers stay in registers from node to node.
template <class F, box_arithmetic A>
IRG_INLINE constexpr std::uint32_t next_leaf(const bvh_node* nodes, const box_ray& r, bvh_walk& walk) noexcept {
  const wide_box_ray<F, A> wide = widen_box_ray<F, A>(r);
  const float high = r.high;
  std::uint64_t* top = walk.top;
  const auto pop = [&]() IRG_INLINE_LAMBDA {
    std::uint64_t next = 0;
    do {
      if (top == walk.waiting) return bvh_node::none;
      next = *--top;
    } while (high < std::bit_cast<float>(static_cast<std::uint32_t>(next >> 32)));
    return static_cast<std::uint32_t>(next);
  };
  std::uint32_t at = pop();
  while (!bvh_node::is_leaf(at)) {
    const bvh_node& node = nodes[at];
    float times[bvh_node::width];
    unsigned bits = meet_boxes(node, wide, high, times);
    if (bits == 0) {
      at = pop();
      continue;
    }
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
  }
  walk.top = top;
  return at;
}

template <class F, box_arithmetic A, class Visit>
IRG_INLINE constexpr void walk_sorted(const bvh_node* nodes, const box_ray& r, const Visit& visit) {
  bvh_walk walk;
  walk.top = walk.waiting;
  *walk.top++ = 0;
  for (;;) {
    const std::uint32_t leaf = next_leaf<F, A>(nodes, r, walk);
    if (leaf != bvh_node::none)
      visit(leaf);
    else if (walk.top == walk.waiting)
      return;
  }
}

// The children of a node that are leaves: a bit for each.
template <class F>
IRG_INLINE constexpr unsigned leaves_of(const bvh_node& node) noexcept {
  using I = typename lanes<F>::template rebind<std::uint32_t>;
  unsigned bits = 0;
  for (int k = 0; k < bvh_node::width; k += lanes<F>::count)
    if constexpr (lanes<F>::count == 1)
      bits |= (node.child[k] >> 31) << k;
    else
      bits |= static_cast<unsigned>(mask_bits(bits_as<std::int32_t>(lanes<I>::load(node.child + k)) < 0)) << k;
  return bits;
}

// Leaves at once, then nodes, of which one does not wait.
template <class F, box_arithmetic A, class Visit>
IRG_INLINE constexpr bool walk_unsorted(const bvh_node* nodes, const box_ray& r, const Visit& visit) {
  const wide_box_ray<F, A> wide = widen_box_ray<F, A>(r);
  std::uint32_t waiting[bvh_waiting];
  std::uint32_t* top = waiting;
  std::uint32_t at = 0;
  for (;;) {
    const bvh_node& node = nodes[at];
    const auto child = [&node](unsigned bits) { return node.child[static_cast<unsigned>(std::countr_zero(bits))]; };
    float times[bvh_node::width];
    const unsigned bits = meet_boxes(node, wide, r.high, times), leaves = leaves_of<F>(node);
    for (unsigned rest = bits & leaves; rest != 0; rest &= rest - 1)
      if (child(rest) != bvh_node::none && visit(child(rest))) return true;
    unsigned rest = bits & ~leaves;
    if (rest == 0) {
      if (top == waiting) return false;
      at = *--top;
      continue;
    }
    at = child(rest);
    for (rest &= rest - 1; rest != 0; rest &= rest - 1) *top++ = child(rest);
  }
}

IRG_INLINE constexpr bool walks_in_packets() noexcept { return !std::is_constant_evaluated(); }
IRG_INLINE constexpr bool walks_in_lanes() noexcept { return has_lanes && !std::is_constant_evaluated(); }

}  // namespace IRG_ABI
}  // namespace irg::detail
