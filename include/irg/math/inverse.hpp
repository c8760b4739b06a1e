// SPDX-License-Identifier: MIT
// The inverse of a square matrix in three tiers: by cofactors for inner loops; with a bound for its error; and by
// elimination with corrections in twice the precision, right to the last place up to conditions of 5e14. Where a tier
// cannot tell a matrix from a singular one, the result is absent. inverse_exact (math/inverse_exact.hpp) decides
// exactly.
#pragma once

#include <optional>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/elimination.hpp>
#include <irg/math/detail/inverse_kernel.hpp>
#include <irg/math/detail/inverse_steps.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/mat.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The matrix that undoes `a`, by cofactors: for inner loops and matrices that are far from singular.
/// needs   entries that are 0 or of a size between 2^-250 and 2^250 (float: 2^-30 and 2^30)
/// gives   infinite or NaN entries when the determinant, as computed, is 0; no other way to tell a singular matrix
/// exact   relative errors of a few u times the condition number where the determinant is not small beside the products
///         it is the sum of (motions, scalings, cameras); else they grow with the square of the condition number
/// cost    one division
template <Floating T, int N>
  requires(N == 2 || N == 3 || N == 4)
[[nodiscard]] constexpr mat<T, N, N> inverse_fast(const mat<T, N, N>& a) noexcept {
  return detail::inverse_by_cofactors(a, T(0));
}

template <Floating T, int N>
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse_accurate(const mat<T, N, N>& a) noexcept;

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// `inverse` where cofactors will not do.
template <Real T, int N>
IRG_NOINLINE constexpr std::optional<mat<T, N, N>> inverse_by_elimination(const mat<T, N, N>& a) noexcept {
  if (!entries_finite<T>(a, N, N)) return std::nullopt;
  mat<T, N, N> left = a, right = identity<T, N>();
  const bool is_regular = gauss_jordan<T>(left, right, N);
  // A pivot that overflows leaves zeros in `right`, and a NaN in `left`.
  const bool fits = entries_finite<T>(left, N, N) && entries_finite<T>(right, N, N);
  if (is_regular && fits && inverse_has_digits<T>(a, right, N)) return right;
  if constexpr (Floating<T>)
    if (!fits || has_mixed_sizes(a)) return inverse_accurate(a);
  return std::nullopt;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The matrix that undoes `a`.
/// gives   nothing for a singular matrix. In floats also nothing when the result would have no correct digit (see
///         `exact`), when an entry is NaN or infinite, or when the inverse has an entry that is too large for T
/// exact   in rationals. In floats the error is at most 8 u times the condition number, relative to the inverse, in
///         norm_1; what decides whether a digit is correct, the largest sum of |x_ij * a_ji| over j for x = the
///         inverse, must stay below 1/(2 N u). It does not depend on how rows and columns are scaled.
///         An affine matrix, one whose last row is 0 ... 0 1, has an inverse with exactly this last row
/// cost    in floats up to size 4 that of inverse_fast and of a matrix product, which shows whether the result is good
///         enough; where it is not, and for others, Gauss-Jordan elimination with partial pivoting, 2 N^3 operations;
///         where that fails and entries differ by more than 2^16, or it overflows, inverse_accurate
/// source  Higham 2002, ch. 14; Bauer 1963 for the condition
template <Real T, int N>
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse(const mat<T, N, N>& a) noexcept {
  if constexpr (Floating<T> && N >= 2 && N <= 4) {
    std::optional<mat<T, N, N>> result(std::in_place);
    if (detail::inverse_is_easy(a, *result)) return result;
  }
  return detail::inverse_by_elimination(a);
}

/// The matrix that undoes `a`, right to the last place however close to singular `a` is, up to a limit.
/// gives   nothing where double cannot tell the matrix from a singular one: when its condition number, rows and columns
///         scaled by powers of two to be of one size, reaches 1/(4 N u), 5e14 for N = 4 (u = 2^-53, float too); when an
///         entry is NaN or infinite; when the inverse has an entry that is too large for T. Up to N = 4 it is the best
///         of all scalings that counts
/// exact   the error of an entry is at most 1.1 u times the largest entry of its column (after the scaling of rows); up
///         to a condition of 1e12, entries that are not below 2^-8 of that are within 0.51 ulp; up to N = 4 all that
///         after any scaling that leaves the condition number below the limit
/// cost    about 35 times that of `inverse`: elimination in double, then each column is corrected with residuals in
///         twice the precision; floats are inverted in double
/// source  Higham 2002, ch. 12; Demmel et al. 2006
template <Floating T, int N>
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse_accurate(const mat<T, N, N>& a) noexcept {
  const auto wide = detail::filled_mat<double, N, N>([&](int r, int c) { return widened(a(r, c)); });
  if (!detail::entries_finite<double>(wide, N, N)) return std::nullopt;
  const auto s = detail::factor_scaled(wide, detail::scaling::by_largest);
  mat<T, N, N> result{};
  if (!detail::refined_inverse(s, wide, result)) {
    if (!s.sizes.may_hide_regular()) return std::nullopt;
    if constexpr (N <= 4) {
      const double part = detail::smallest_condition(N);
      if (!detail::put_exact_inverse(wide, detail::all_of<N * N>, part, result)) return std::nullopt;
    } else if (!detail::refined_inverse(detail::factor_scaled(wide, detail::scaling::by_means), wide, result)) {
      return std::nullopt;
    }
  }
  if (!detail::entries_finite<T>(result, N, N)) return std::nullopt;
  return result;
}

}  // namespace IRG_ABI
}  // namespace irg
