// SPDX-License-Identifier: MIT
// The loops of the way through a bvh.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include <irg/core/lane_memory.hpp>
#include <irg/spatial/detail/box_test_kernel.hpp>

namespace irg::detail {

/// Stands for ray_counts where nobody asks for them: no code is made.
struct uncounted {};
inline constexpr uncounted not_counted{};

template <class C>
concept RayCounts = std::same_as<C, ray_counts> || std::same_as<C, const uncounted>;

inline namespace IRG_ABI {

template <RayCounts C>
IRG_INLINE constexpr void count_rays(C& counts, [[maybe_unused]] std::uint64_t rays) noexcept {
  if constexpr (std::same_as<C, ray_counts>) counts.rays += rays;
}
template <RayCounts C>
IRG_INLINE constexpr void count_node(C& counts) noexcept {
  if constexpr (std::same_as<C, ray_counts>) ++counts.nodes;
}
template <RayCounts C>
IRG_INLINE constexpr void count_leaf(C& counts, [[maybe_unused]] std::uint32_t leaf) noexcept {
  if constexpr (std::same_as<C, ray_counts>) {
    ++counts.leaves;
    counts.primitives += bvh_node::count_of(leaf);
  }
}

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

// The leaf that comes next in the order of times, from `at` on; none at the end, and for an empty box that a ray meets
// whose times are not numbers. It stands apart from what is done with leaves, so that a ray's numbers stay in registers
// from node to node.
template <class F, box_arithmetic A, RayCounts C>
IRG_INLINE constexpr std::uint32_t next_leaf(const bvh_node* nodes, const box_ray& r, std::uint32_t at, bvh_walk& walk,
                                             C& counts) noexcept {
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
  while (!bvh_node::is_leaf(at)) {
    const bvh_node& node = nodes[at];
    count_node(counts);
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

template <class F, box_arithmetic A, class Visit, RayCounts C = const uncounted>
IRG_INLINE constexpr void walk_sorted(const bvh_node* nodes, const box_ray& r, const Visit& visit,
                                      C& counts = not_counted) {
  bvh_walk walk;
  walk.top = walk.waiting;
  std::uint32_t at = 0;
  for (;;) {
    const std::uint32_t leaf = next_leaf<F, A>(nodes, r, at, walk, counts);
    if (leaf != bvh_node::none) {
      count_leaf(counts, leaf);
      visit(leaf);
    }
    for (;;) {
      if (walk.top == walk.waiting) return;
      const std::uint64_t next = *--walk.top;
      if (r.high < std::bit_cast<float>(static_cast<std::uint32_t>(next >> 32))) continue;
      at = static_cast<std::uint32_t>(next);
      break;
    }
  }
}

// The children whose bits are set, one behind the other from `to` on, where there is room for all.
template <class F>
IRG_INLINE constexpr void put_met(std::uint32_t* to, const bvh_node& node, unsigned bits) noexcept {
  if constexpr (lanes<F>::count == bvh_node::width) {
    store_compressed(to, lanes<pack<std::uint32_t, bvh_node::width>>::load(node.child), bits);
  } else {
    for (int k = 0; k < bvh_node::width; ++k) {
      *to = node.child[k];
      to += bits >> k & 1;
    }
  }
}

// The last child that is met comes next, or what waits on top where none is: both are known without a branch, which
// would be guessed wrong at most nodes. So all wait for a moment, and the next is taken from the node itself. Below
// stands what tells the end; an empty box that a ray meets whose times are not numbers is told from that.
template <class F, box_arithmetic A, class Visit, RayCounts C = const uncounted>
IRG_INLINE constexpr bool walk_unsorted(const bvh_node* nodes, const box_ray& r, const Visit& visit,
                                        C& counts = not_counted) {
  const wide_box_ray<F, A> wide = widen_box_ray<F, A>(r);
  std::uint32_t waiting[bvh_waiting + bvh_node::width];
  waiting[0] = bvh_node::none;
  const float high = r.high;
  std::uint32_t* top = waiting + 1;
  std::uint32_t at = 0;
  for (;;) {
    while (!bvh_node::is_leaf(at)) {
      const bvh_node& node = nodes[at];
      const std::uint32_t waits = top[-1];
      count_node(counts);
      float times[bvh_node::width];
      const unsigned bits = meet_boxes(node, wide, high, times);
      const std::uint32_t met = node.child[static_cast<unsigned>(std::bit_width(bits | 1)) - 1];
      put_met<F>(top, node, bits);
      top += std::popcount(bits) - 1;
      at = bits != 0 ? met : waits;
    }
    if (at != bvh_node::none) {
      count_leaf(counts, at);
      if (visit(at)) return true;
    } else if (top == waiting) {
      return false;
    }
    at = *--top;
  }
}

IRG_INLINE constexpr bool walks_in_packets() noexcept { return !std::is_constant_evaluated(); }
IRG_INLINE constexpr bool walks_in_lanes() noexcept { return has_lanes && !std::is_constant_evaluated(); }

}  // namespace IRG_ABI
}  // namespace irg::detail
