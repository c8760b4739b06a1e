// SPDX-License-Identifier: MIT
// Lengths and dot products of registers of vectors, rounded as length and dot round those of one.
#pragma once

#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lanes.hpp>

namespace irg::detail {

/// A register of sums of two numbers.
template <class F>
struct lane_sum {
  F value, error;
};

inline namespace IRG_ABI {

template <int N>
IRG_INLINE pack<double, N> dot_of(const triple_lanes<double, N>& a, const triple_lanes<double, N>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <int N>
IRG_INLINE triple_lanes<double, N> divided(const triple_lanes<double, N>& a, const pack<double, N>& by) noexcept {
  return {a.x / by, a.y / by, a.z / by};
}

/// Where length_of is right: the greatest coordinate is from 2^-100 to 2^100.
template <int N>
IRG_INLINE mask_of_lanes<double, N> is_moderate(const triple_lanes<double, N>& v) noexcept {
  using F = pack<double, N>;
  using f = lanes<F>;
  const F x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z), most = f::broadcast(0x1p100);
  return (x <= most) & (y <= most) & (z <= most) & (f::broadcast(0x1p-100) <= high_of(x, high_of(y, z)));
}

template <class F>
IRG_INLINE lane_sum<F> two_sum_of(const F& a, const F& b) noexcept {
  const F sum = a + b, b_part = sum - a, a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}
template <class F>
IRG_INLINE lane_sum<F> fast_two_sum_of(const F& large, const F& little) noexcept {
  const F sum = large + little;
  return {sum, little - (sum - large)};
}
template <class F>
IRG_INLINE lane_sum<F> square_of(const F& a) noexcept {
  const F value = a * a;
  if constexpr (has_fused_multiply_add) {
    return {value, fused_multiply_add(a, a, -value)};
  } else {
    const F scaled = a * 134217729.0, high = scaled - (scaled - a), low = a - high;  // 2^27 + 1
    return {value, ((high * high - value) + high * low + low * high) + low * low};
  }
}
template <class F>
IRG_INLINE lane_sum<F> sum_of(const lane_sum<F>& a, const lane_sum<F>& b) noexcept {
  const lane_sum<F> heads = two_sum_of(a.value, b.value);
  return fast_two_sum_of(heads.value, heads.error + (a.error + b.error));
}

/// The lengths of vectors of moderate size, as hypot of three.
/// source  Borges 2019 (the correction of the root)
template <int N>
IRG_INLINE pack<double, N> length_of(const triple_lanes<double, N>& v) noexcept {
  using F = pack<double, N>;
  const F x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z);
  const F xy = high_of(x, y), second = low_of(x, y), largest = high_of(xy, z), third = low_of(xy, z);
  const lane_sum<F> square = sum_of(sum_of(square_of(largest), square_of(second)), square_of(third));
  const F root = square_root_instruction(square.value);
  const lane_sum<F> back = square_of(root);
  return root + ((square.value - back.value) - back.error + square.error) / (root + root);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
