// SPDX-License-Identifier: MIT
// What polynomials of points and vectors of the plane and of space share, and questions about what comes out of them.
#pragma once

#include <array>
#include <cstddef>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/compiled_numbers.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

/// v . v, or x * x.
template <class N>
IRG_INLINE constexpr N squared(const N& x) noexcept {
  return x * x;
}
template <class N, int D>
IRG_INLINE constexpr N squared(const vec<N, D>& v) noexcept {
  return dot(v, v);
}

/// Whether all numbers are zero.
template <Scalar V>
IRG_INLINE constexpr bool is_zero(const V& x) noexcept {
  return sign_of(x) == 0;
}
template <Coordinates V>
IRG_INLINE constexpr bool is_zero(const V& v) noexcept {
  for (int i = 0; i < size_of<V>; ++i)
    if (sign_of(coordinate(v, i)) != 0) return false;
  return true;
}

/// Which coordinate has the largest magnitude, 0 to 2.
template <class V>
constexpr int largest_coordinate(const vec<V, 3>& v) noexcept {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (sign_of(v[i] * v[i] - v[k] * v[k]) > 0) k = i;
  return k;
}

}  // namespace irg::detail::inline IRG_ABI
