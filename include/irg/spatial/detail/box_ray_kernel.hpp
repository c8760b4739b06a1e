// SPDX-License-Identifier: MIT
// The arithmetic of making rays ready for boxes, in lanes.
#pragma once

#include <limits>
#include <type_traits>

#include <irg/core/lanes.hpp>

namespace irg::detail {

template <class F>
struct box_ray_axes {
  F near_origin, far_origin, near_gain, far_gain;
  bool stands;  // on some axis it has hardly a direction
};

inline namespace IRG_ABI {

// D holds doubles, as many as there are in F floats. Beyond the range of floats an origin is between its last number
// and infinity; what is nearer to 0 than 2^-76, where floats would be finer than 2^-100, is between that and 0.
template <class F, class D>
IRG_INLINE constexpr box_ray_axes<F> set_up_axes(const D& origin, const D& direction) noexcept {
  const auto all = [](float x) { return lanes<F>::broadcast(x); };
  const auto limit = [](double x) { return lanes<D>::broadcast(x); };
  const F o = converted<float>(low_of(high_of(origin, limit(-0x1.fffffep127)), limit(0x1.fffffep127)));
  const F step = high_of(magnitude(o) * all(0x1p-23f), all(0x1p-76f));
  const F low = o - step, high = o + step;
  const F d = converted<float>(direction);
  const auto backwards = d < all(0.0f);
  const F along = magnitude(d);
  const auto stands = along < all(0x1p-126f);
  const F gain = all(1.0f) / select(stands, all(1.0f), along);
  const F size = select(stands, all(std::numeric_limits<float>::infinity()), gain);
  const F nearby = size * all(1 - 0x1p-21f), distant = size * all(1 + 0x1p-20f);
  return {select(backwards, low, high), select(backwards, high, low), select(backwards, -nearby, nearby),
          select(backwards, -distant, distant), any_lane(stands)};
}

// Gives whether the ray has hardly a direction along some axis.
IRG_INLINE constexpr bool set_up_box_ray(const double (&origin)[3], const double (&direction)[3], float* near_origin,
                                         float* far_origin, float* near_gain, float* far_gain) noexcept {
  if (std::is_constant_evaluated()) {
    bool stands = false;
    for (int i = 0; i < 3; ++i) {
      const box_ray_axes<float> axis = set_up_axes<float>(origin[i], direction[i]);
      near_origin[i] = axis.near_origin;
      far_origin[i] = axis.far_origin;
      near_gain[i] = axis.near_gain;
      far_gain[i] = axis.far_gain;
      stands = stands || axis.stands;
    }
    return stands;
  }
  const auto axes = set_up_axes<pack<float, 4>>(pack_of(origin[0], origin[1], origin[2], 0.0),
                                                pack_of(direction[0], direction[1], direction[2], 1.0));
  using f = lanes<pack<float, 4>>;
  f::store(near_origin, axes.near_origin);
  f::store(far_origin, axes.far_origin);
  f::store(near_gain, axes.near_gain);
  f::store(far_gain, axes.far_gain);
  return axes.stands;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
