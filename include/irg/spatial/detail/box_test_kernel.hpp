// SPDX-License-Identifier: MIT
// Which of a node's eight boxes a ray meets, in lanes.
#pragma once

#include <cstddef>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/spatial/bvh_node.hpp>
#include <irg/spatial/detail/box_ray.hpp>

namespace irg::detail {

// The parts of a box_ray in all lanes.
template <class F>
struct wide_box_ray {
  F near_origin[3], far_origin[3], near_gain[3], far_gain[3], low;
  std::ptrdiff_t near_at[3], far_at[3];  // the places of the faces that are asked, from bounds[0][0] on
};

inline namespace IRG_ABI {

template <class F>
IRG_INLINE constexpr wide_box_ray<F> widen_box_ray(const box_ray& r) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  return {{all(r.near_origin[0]), all(r.near_origin[1]), all(r.near_origin[2])},
          {all(r.far_origin[0]), all(r.far_origin[1]), all(r.far_origin[2])},
          {all(r.near_gain[0]), all(r.near_gain[1]), all(r.near_gain[2])},
          {all(r.far_gain[0]), all(r.far_gain[1]), all(r.far_gain[2])},
          all(r.low),
          {r.near_at[0], r.near_at[1], r.near_at[2]},
          {r.far_at[0], r.far_at[1], r.far_at[2]}};
}

/// A bit for each box that the ray meets not after `high`, and when it does into `times`.
// A NaN that stands first in low_of and high_of is passed over; one that stands second takes the other limit with it,
// which makes the box larger at worst.
template <class F>
IRG_INLINE constexpr unsigned meet_boxes(const bvh_node& node, const wide_box_ray<F>& r, float high,
                                         float* times) noexcept {
  unsigned bits = 0;
  for (int k = 0; k < bvh_node::width; k += lanes<F>::count) {
    const auto nearby = [&](int i) {
      return (lanes<F>::load(node.bounds + r.near_at[i] + k) - r.near_origin[i]) * r.near_gain[i];
    };
    const auto distant = [&](int i) {
      return (lanes<F>::load(node.bounds + r.far_at[i] + k) - r.far_origin[i]) * r.far_gain[i];
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
