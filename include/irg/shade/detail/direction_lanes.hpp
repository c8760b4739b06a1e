// SPDX-License-Identifier: MIT
// Lengths and dot products of registers of vectors, rounded as length and dot round those of one.
#pragma once

#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lanes.hpp>
#include <irg/math/length.hpp>

namespace irg::detail {

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

template <int N>
IRG_INLINE pack<double, N> grid_below_root(const pack<double, N>& square) noexcept {
  return bits_as<double>(((bits_as<std::uint64_t>(square) >> 1) & exponent_of_grid) + offset_of_grid);
}

/// The lengths of vectors of moderate size, as hypot of three.
template <int N>
IRG_INLINE pack<double, N> length_of(const triple_lanes<double, N>& v) noexcept {
  using F = pack<double, N>;
  const F x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z), square = sum_of_squares(x, y, z);
  const F root = square_root_instruction(square);
  const F rest = rest_of_squares_one_by_one(root, grid_below_root(square), x, y, z);
  return root + rest * (lanes<F>::broadcast(0.5) / root);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
