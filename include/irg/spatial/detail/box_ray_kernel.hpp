// SPDX-License-Identifier: MIT
// The arithmetic of making rays ready for boxes, in lanes.
#pragma once

#include <limits>
#include <type_traits>

#include <irg/core/lanes.hpp>

namespace irg::detail {

template <class F>
struct box_ray_axes {
  F near_gain, far_gain, near_offset, far_offset;
  bool stands;  // on some axis it has hardly a direction
};

struct box_ray_numbers {
  float near_gain[4], far_gain[4], near_offset[4], far_offset[4];
};

// Where a direction is less, its largest coordinate being 1 or more, no reciprocal is taken.
inline constexpr float standing_direction = 0x1p-100f;

inline namespace IRG_ABI {

// How far an origin's float may be off, and what products with the reciprocal lose: origins nearer to 0 than 2^-53,
// where floats would be finer than 2^-76, count as that far.
template <class F>
IRG_INLINE constexpr F step_of_origin(const F& o) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  return high_of(magnitude(o) * all(0x1p-21f), all(0x1p-74f));
}

// D holds floats or doubles, as many as there are in F floats. Beyond the range of floats an origin is the last of
// them.
template <class F, class D>
IRG_INLINE constexpr box_ray_axes<F> set_up_axes(const D& origin, const D& direction) noexcept {
  using number = typename lanes<D>::scalar;
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  const auto limit = [](float x) { return lanes<D>::broadcast(static_cast<number>(x)); };
  const F o = converted<float>(low_of(high_of(origin, limit(-0x1.fffffep127f)), limit(0x1.fffffep127f)));
  const F d = converted<float>(direction);
  const auto stands = magnitude(d) < all(standing_direction);
  const F gain = all(1.0f) / select(stands, all(1.0f), d);
  const F to_origin = o * gain, slack = step_of_origin(o) * magnitude(gain);
  const F longer = all(1 + 0x1p-20f);
  return {gain, gain * longer, (-to_origin) - slack, (slack - to_origin) * longer, any_lane(stands)};
}

// Whether origins in the tree's units and directions are such that they need no scaling; NaN is not: high_of gives its
// second number where either is NaN.
template <class F>
IRG_INLINE constexpr auto middling_axes(const F& origin, const F& direction) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  return both(high_of(magnitude(direction), magnitude(origin)) <= all(0x1p20f), magnitude(direction) >= all(0x1p-60f));
}
IRG_INLINE constexpr bool are_middling(const float (&origin)[3], const float (&direction)[3]) noexcept {
  if (std::is_constant_evaluated())
    return middling_axes(origin[0], direction[0]) && middling_axes(origin[1], direction[1]) &&
           middling_axes(origin[2], direction[2]);
  return all_lanes(middling_axes(pack_of(origin[0], origin[1], origin[2], 0.0f),
                                 pack_of(direction[0], direction[1], direction[2], 1.0f)));
}

// Gives whether the ray has hardly a direction along some axis.
template <class T>
IRG_INLINE constexpr bool set_up_box_ray(const T (&origin)[3], const T (&direction)[3], box_ray_numbers& b) noexcept {
  if (std::is_constant_evaluated()) {
    bool stands = false;
    for (int i = 0; i < 3; ++i) {
      const box_ray_axes<float> axis = set_up_axes<float>(origin[i], direction[i]);
      b.near_gain[i] = axis.near_gain;
      b.far_gain[i] = axis.far_gain;
      b.near_offset[i] = axis.near_offset;
      b.far_offset[i] = axis.far_offset;
      stands = stands || axis.stands;
    }
    return stands;
  }
  const auto axes = set_up_axes<pack<float, 4>>(pack_of(origin[0], origin[1], origin[2], T(0)),
                                                pack_of(direction[0], direction[1], direction[2], T(1)));
  using f = lanes<pack<float, 4>>;
  f::store(b.near_gain, axes.near_gain);
  f::store(b.far_gain, axes.far_gain);
  f::store(b.near_offset, axes.near_offset);
  f::store(b.far_offset, axes.far_offset);
  return axes.stands;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
