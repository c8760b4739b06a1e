// SPDX-License-Identifier: MIT
// The determinant of floats up to size four from an exact sum of its products: correctly rounded, and its sign, which
// says whether a matrix is singular and whether it turns left into right.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/exact_minors.hpp>

namespace irg::inline IRG_ABI {

/// The number nearest to the determinant of `a`.
/// gives   infinity when it is too large for T; what determinant gives when an entry is NaN or infinite
/// exact   correctly rounded, ties to even, for all finite entries; 0 also for one that is too small for T
/// cost    N! exact products
template <Floating T, int N>
  requires(N <= 4)
[[nodiscard]] constexpr T determinant_exact(const mat<T, N, N>& a) noexcept {
  if (!detail::entries_finite<T>(a, N, N)) return determinant(a);
  return detail::round_exact_sum<T>(detail::exact_determinant<N>([&](int r, int c) { return widened(a(r, c)); }));
}

/// The sign of the determinant of `a`: 1, -1 where `a` turns left into right, 0 exactly where it is singular.
/// gives   0 when an entry is NaN or infinite
/// exact   for all finite entries
/// cost    N! exact products
template <Floating T, int N>
  requires(N <= 4)
[[nodiscard]] constexpr int determinant_sign(const mat<T, N, N>& a) noexcept {
  if (!detail::entries_finite<T>(a, N, N)) return 0;
  return detail::exact_determinant<N>([&](int r, int c) { return widened(a(r, c)); }).sign();
}

}  // namespace irg::inline IRG_ABI
