// SPDX-License-Identifier: MIT
// Determinant and inverse of a matrix as exact values would be rounded.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/exact_minors.hpp>
#include <irg/math/detail/exact_system.hpp>
#include <irg/math/mat.hpp>

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

/// The matrix that undoes `a`, for the exact values of its entries.
/// gives   nothing exactly when the determinant is zero, when an entry is NaN or infinite, or when the inverse has an
///         entry that is too large for T
/// exact   every entry is correctly rounded, ties to even, subnormal ones too, whatever the condition
/// cost    the exact determinant and N^2 exact minors. Up to a condition of 10^12 inverse_accurate gives the same
///         sooner: this is for worse matrices and for singular ones
template <Floating T, int N>
  requires(N >= 2 && N <= 4)
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse_exact(const mat<T, N, N>& a) noexcept {
  if (!detail::entries_finite<T>(a, N, N)) return std::nullopt;
  const auto entry = [&](int r, int c) { return widened(a(r, c)); };
  const detail::exact_system<N, decltype(entry)> system(entry);
  if (system.is_singular()) return std::nullopt;
  mat<T, N, N> x{};
  for (int r = 0; r < N; ++r)
    for (int c = 0; c < N; ++c) x(r, c) = system.template inverse_entry<T>(r, c);
  if (!detail::entries_finite<T>(x, N, N)) return std::nullopt;
  return x;
}

}  // namespace irg::inline IRG_ABI
