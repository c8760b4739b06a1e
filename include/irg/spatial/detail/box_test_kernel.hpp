// SPDX-License-Identifier: MIT
// Which of a node's eight boxes a ray meets, in lanes.
#pragma once

#include <cstddef>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/spatial/bvh_node.hpp>
#include <irg/spatial/detail/box_ray.hpp>

namespace irg::detail {

// How b * gain + offset is computed: rounded twice everywhere, so that what a user's test is asked about is the same on
// every processor, or once where that is one instruction, for tests that give the same whatever they are asked.
enum class box_arithmetic { portable, fused };

// The parts of a box_ray in all lanes.
template <class F, box_arithmetic A>
struct wide_box_ray {
  F near_gain[3], far_gain[3], near_offset[3], far_offset[3], low;
  std::ptrdiff_t near_at[3], far_at[3];
};

inline namespace IRG_ABI {

template <class F, box_arithmetic A>
IRG_INLINE constexpr wide_box_ray<F, A> widen_box_ray(const box_ray& r) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  return {{all(r.near_gain[0]), all(r.near_gain[1]), all(r.near_gain[2])},
          {all(r.far_gain[0]), all(r.far_gain[1]), all(r.far_gain[2])},
          {all(r.near_offset[0]), all(r.near_offset[1]), all(r.near_offset[2])},
          {all(r.far_offset[0]), all(r.far_offset[1]), all(r.far_offset[2])},
          all(r.low),
          {r.near_at[0], r.near_at[1], r.near_at[2]},
          {r.far_at[0], r.far_at[1], r.far_at[2]}};
}

template <box_arithmetic A, class F>
IRG_INLINE constexpr F time_at_face(const F& bound, const F& gain, const F& offset) noexcept {
  if (A == box_arithmetic::fused && !std::is_constant_evaluated()) return fused_multiply_add(bound, gain, offset);
  if constexpr (lanes<F>::count == 1)
    return product(bound, gain) + offset;
  else
    return bound * gain + offset;
}

/// A bit for each box that the ray meets not after `high`, and when it does into `times`.
// A NaN that stands first in low_of and high_of is passed over; one that stands second takes the other limit with it,
// which makes the box larger at worst.
template <class F, box_arithmetic A>
IRG_INLINE constexpr unsigned meet_boxes(const bvh_node& node, const wide_box_ray<F, A>& r, float high,
                                         float* times) noexcept {
  unsigned bits = 0;
  for (int k = 0; k < bvh_node::width; k += lanes<F>::count) {
    const auto nearby = [&](int i) {
      return time_at_face<A>(lanes<F>::load(node.bounds + r.near_at[i] + k), r.near_gain[i], r.near_offset[i]);
    };
    const auto distant = [&](int i) {
      return time_at_face<A>(lanes<F>::load(node.bounds + r.far_at[i] + k), r.far_gain[i], r.far_offset[i]);
    };
    const F first = high_of(high_of(nearby(0), nearby(1)), high_of(nearby(2), r.low));
    const F last = low_of(low_of(distant(0), distant(1)), low_of(distant(2), lanes<F>::broadcast(high)));
    lanes<F>::store(times + k, first);
    bits |= static_cast<unsigned>(mask_bits(first <= last)) << k;
  }
  return bits;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
