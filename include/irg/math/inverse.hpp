// SPDX-License-Identifier: MIT
// The inverse of a square matrix in three tiers: by cofactors for inner loops; with a bound for its error; and by
// elimination with corrections in twice the precision, right to the last place up to conditions of 5e14. Where a tier
// cannot tell a matrix from a singular one, the result is absent. inverse_exact (math/inverse_exact.hpp) decides
// exactly.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/elimination.hpp>
#include <irg/math/detail/inverse_kernel.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/mat.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

// The inverse by cofactors; zero when the determinant is below `least`.
template <class T, int N>
IRG_INLINE constexpr mat<T, N, N> inverse_by_cofactors(const mat<T, N, N>& a, T least) noexcept {
  if constexpr (N == 4) {
    mat<T, 4, 4> result{};
    inverse4(a.m, result.m, least);
    return result;
  } else {
    const mat<T, N, N> cofactors = cofactor_matrix(a);
    const T det = sum_of_products<N>([&](int k) { return a(0, k); }, [&](int k) { return cofactors(0, k); });
    return transpose(cofactors) * inverse_factor(det, least);
  }
}

// Gives x, an inverse of a by cofactors, the last row and the last column 0 ... 0 1 where a has it: the inverse of an
// affine matrix is affine, without rounding.
template <class T, int N>
IRG_INLINE constexpr void keep_affine(const mat<T, N, N>& a, mat<T, N, N>& x) noexcept {
  bool row = a(N - 1, N - 1) == T(1), column = row;
  for (int i = 0; i < N - 1; ++i) {
    row = row && a(N - 1, i) == T(0);
    column = column && a(i, N - 1) == T(0);
  }
  for (int i = 0; i < N; ++i) {
    if (row) x(N - 1, i) = i == N - 1 ? T(1) : T(0);
    if (column) x(i, N - 1) = i == N - 1 ? T(1) : T(0);
  }
}

// Whether some entry that is not zero is below 2^-16 of another one.
template <Floating T, int N>
constexpr bool has_mixed_sizes(const mat<T, N, N>& a) noexcept {
  T least = infinity<T>, largest = T(0);
  for (int i = 0; i < N * N; ++i) {
    const T size = magnitude(a(i / N, i % N));
    largest = greater(size, largest);
    if (size != T(0)) least = lesser(size, least);
  }
  return least < largest * static_cast<T>(0x1p-16);
}

// Puts the inverse by cofactors into x, and says whether it is one: whether a * x differs from the identity by no more
// than 3 u times the condition number. False for numbers of a size that the cofactors, or a * x, might not fit.
template <Floating T, int N>
IRG_INLINE constexpr bool inverse_is_easy(const mat<T, N, N>& a, mat<T, N, N>& x) noexcept {
  constexpr bool is_double = std::same_as<T, double>;
  constexpr T largest = static_cast<T>(is_double ? 0x1p150 : 0x1p20),
              least = static_cast<T>(is_double ? 0x1p-300 : 0x1p-40);
  constexpr T epsilon = std::numeric_limits<T>::epsilon();
  const T size = norm_1(a);
  if (!(size <= largest)) return false;
  x = inverse_by_cofactors(a, least);
  const T condition = product(size, norm_1(x));
  if (!(condition * (T(N) * epsilon) < T(1))) return false;
  mat<T, N, N> rest = a * x;
  for (int i = 0; i < N; ++i) rest(i, i) = rest(i, i) - T(1);
  if (!(norm_1(rest) <= T(1.5) * epsilon * condition)) return false;
  keep_affine(a, x);
  return true;
}

// The entries of x, the inverse of s.a, that have to be found in another way, as bits r N + c: those that are doubtful,
// unless they are rounding errors of terms so large that no scaling makes more of them: below
// 4 N u of |x| * |s.a| * |x|.
template <int N>
constexpr unsigned doubtful_entries(const scaled_system<N>& s, const mat<double, N, N>& x, double condition) noexcept {
  const auto sizes = [](const mat<double, N, N>& m) {
    return filled_mat<double, N, N>([&](int r, int c) { return magnitude(m(r, c)); });
  };
  unsigned which = 0;
  double largest[static_cast<std::size_t>(N)]{};
  for (int c = 0; c < N; ++c) {
    for (int r = 0; r < N; ++r) largest[c] = greater(largest[c], magnitude(x(r, c)));
    for (int r = 0; r < N; ++r) which |= is_doubtful(x(r, c), largest[c], condition, s.sizes) ? 1u << (r * N + c) : 0;
  }
  if (which == 0) return 0;
  const mat<double, N, N> terms = sizes(x) * sizes(s.a) * sizes(x);
  for (int i = 0; i < N * N; ++i) {
    const double error = product(largest[i % N], product(condition, 0x1p-110));
    if (magnitude(x(i / N, i % N)) + error < product(terms(i / N, i % N), smallest_condition(N))) which &= ~(1u << i);
  }
  return which;
}

// Puts the inverse of a into x, s being a scaled and factored; false when double cannot tell a from a singular matrix.
template <Floating T, int N>
constexpr bool refined_inverse(const scaled_system<N>& s, const mat<double, N, N>& a, mat<T, N, N>& x) noexcept {
  if (!s.has_factors) return false;
  mat<double, N, N> scaled{};
  const double size = norm_1(s.a), largest_column = 1 / smallest_condition(N) / size;
  double largest = 0;
  for (int c = 0; c < N; ++c) {
    vec<double, N> unit{}, column{}, tail{};
    unit[c] = 1;
    if (!refine(s, unit, column, tail) || !(size_1(column) < largest_column)) return false;
    largest = greater(largest, size_1(column));
    for (int r = 0; r < N; ++r) {
      scaled(r, c) = column[r];
      x(r, c) = scaled_back<T>(column[r], tail[r], -s.column_exponent[r] - s.row_exponent[c]);
    }
  }
  if constexpr (N <= 4)
    if (s.sizes.is_mixed())
      if (const unsigned which = doubtful_entries(s, scaled, product(size, largest)); which != 0)
        return put_exact_inverse(a, which, smallest_condition(N), x);
  return true;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The matrix that undoes `a`, by cofactors: for inner loops and matrices that are far from singular.
/// needs   entries that are 0 or of a size between 2^-250 and 2^250 (float: 2^-30 and 2^30)
/// gives   infinite or NaN entries when the determinant, as computed, is 0; no other way to tell a singular matrix
/// exact   relative errors of a few u times the condition number where the determinant is not small beside the products
///         it is the sum of (motions, scalings, cameras); else they grow with the square of the condition number
/// cost    one division
template <Floating T, int N>
  requires(N == 2 || N == 3 || N == 4)
constexpr mat<T, N, N> inverse_fast(const mat<T, N, N>& a) noexcept {
  return detail::inverse_by_cofactors(a, T(0));
}

template <Floating T, int N>
constexpr std::optional<mat<T, N, N>> inverse_accurate(const mat<T, N, N>& a) noexcept;

/// The matrix that undoes `a`.
/// gives   nothing for a singular matrix. In floats also nothing when the result would have no correct digit (see
///         `exact`), when an entry is NaN or infinite, or when the inverse has an entry that is too large for T
/// exact   in rationals. In floats the error is at most 8 u times the condition number, relative to the inverse, in
///         norm_1; what decides whether a digit is correct, the largest sum of |x_ij * a_ji| over j for x = the
///         inverse, must stay below 1/(2 N u). It does not depend on how rows and columns are scaled.
///         An affine matrix, one whose last row is 0 ... 0 1, has an inverse with exactly this last row
/// cost    in floats up to size 4 that of inverse_fast and of a matrix product, which shows whether the result is good
///         enough; where it is not, and for others, Gauss-Jordan elimination with partial pivoting, 2 N^3 operations;
///         where that fails and entries differ by more than 2^16, inverse_accurate
/// source  Higham 2002, ch. 14; Bauer 1963 for the condition
template <Real T, int N>
constexpr std::optional<mat<T, N, N>> inverse(const mat<T, N, N>& a) noexcept {
  if constexpr (Floating<T> && N >= 2 && N <= 4)
    if (mat<T, N, N> x{}; detail::inverse_is_easy(a, x)) return x;
  if (!detail::entries_finite<T>(a, N, N)) return std::nullopt;
  mat<T, N, N> left = a, right = identity<T, N>();
  if (detail::gauss_jordan<T>(left, right, N) && detail::entries_finite<T>(right, N, N) &&
      detail::inverse_has_digits<T>(a, right, N))
    return right;
  if constexpr (Floating<T>)
    if (detail::has_mixed_sizes(a)) return inverse_accurate(a);
  return std::nullopt;
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
constexpr std::optional<mat<T, N, N>> inverse_accurate(const mat<T, N, N>& a) noexcept {
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
