// SPDX-License-Identifier: MIT
// The inverse of a square matrix in three tiers: by cofactors for inner loops; with a bound for its error; and by
// elimination with corrections in twice the precision, right to the last place up to conditions of 5e14. Where a tier
// cannot tell a matrix from a singular one, the result is absent. inverse_exact (math/exact_matrix.hpp) decides
// exactly.
#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/elimination.hpp>
#include <irg/math/detail/mat_kernel.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/mat.hpp>

namespace irg::inline IRG_ABI {

/// The matrix that undoes `a`, by cofactors: for inner loops and matrices that are far from singular.
/// needs   entries that are 0 or of a size between 2^-250 and 2^250 (float: 2^-30 and 2^30)
/// gives   infinite or NaN entries when the determinant, as computed, is 0; no other way to tell a singular matrix
/// exact   relative errors of a few u times the condition number where the determinant is not small beside the products
///         it is the sum of (motions, scalings, cameras); else they grow with the square of the condition number
/// cost    one division
template <Floating T, int N>
  requires(N == 2 || N == 3 || N == 4)
[[nodiscard]] constexpr mat<T, N, N> inverse_fast(const mat<T, N, N>& a) noexcept;

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
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse(const mat<T, N, N>& a) noexcept;

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
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse_accurate(const mat<T, N, N>& a) noexcept;

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

// `inverse` where cofactors will not do, and inverse_accurate.
template <Floating T, int N>
  requires(N >= 2 && N <= 4)
IRG_API std::optional<mat<T, N, N>> hard_inverse(const mat<T, N, N>& a) noexcept;
template <Floating T, int N>
  requires(N >= 2 && N <= 4)
IRG_API std::optional<mat<T, N, N>> accurate_inverse(const mat<T, N, N>& a) noexcept;

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// The inverse of a 4x4 matrix by minors: e(i, j) = (p(j) * m(j) - q(j) * n(j)) + s(j) * o(j), three entries of row j^1
// times 2x2 minors of the two rows that j is not in, with signs, over the determinant. The plain body, which constant
// evaluation takes, and two bodies in lanes have the same bits.

// What minors are multiplied by: 1 over the determinant, or 0 when that is below `least`.
template <class T>
IRG_INLINE constexpr T inverse_factor(T determinant, T least) noexcept {
  return magnitude(determinant) < least ? T(0) : T(1) / determinant;
}

template <class T>
constexpr void inverse4_plain(const T (&a)[4][4], T (&out)[4][4], T least) noexcept {
  // Columns k < l of the minors, and which minors and columns an entry in row i takes.
  constexpr int left[] = {0, 0, 0, 1, 1, 2}, right[] = {1, 2, 3, 2, 3, 3};
  constexpr int columns[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  constexpr int minors[4][3] = {{5, 4, 3}, {5, 2, 1}, {4, 2, 0}, {3, 1, 0}};
  T upper[6]{}, lower[6]{};
  for (int i = 0; i < 6; ++i) {
    upper[i] = product(a[0][left[i]], a[1][right[i]]) - product(a[0][right[i]], a[1][left[i]]);
    lower[i] = product(a[2][left[i]], a[3][right[i]]) - product(a[2][right[i]], a[3][left[i]]);
  }
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const T* m = j < 2 ? lower : upper;
      const T* row = a[j ^ 1];
      const auto term = [&](int k) { return product(row[columns[i][k]], m[minors[i][k]]); };
      out[i][j] = (term(0) - term(1)) + term(2);
    }
  const T determinant = (product(out[0][0], a[0][0]) - product(out[0][1], a[1][0])) +
                        (product(out[0][2], a[2][0]) - product(out[0][3], a[3][0]));
  const T factor = inverse_factor(determinant, least);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) out[i][j] = product(out[i][j], (i + j) % 2 == 0 ? factor : -factor);
}

// In registers of four.
template <class T>
IRG_INLINE void inverse4_by_fours(const T (&a)[4][4], T (&out)[4][4], T least) noexcept {
  using F = pack<T, 4>;
  const four_columns<T> c = columns_of(a[0]);
  // Twice each: entries of rows 2 and 0, and of rows 3 and 1, so that minors come out as lower, lower, upper, upper.
  F x[4], y[4], p[4];
  for (int k = 0; k < 4; ++k) {
    x[k] = shuffled<2, 2, 0, 0>(c.column[k]);
    y[k] = shuffled<3, 3, 1, 1>(c.column[k]);
    p[k] = shuffled<1, 0, 3, 2>(c.column[k]);
  }
  const auto det = [&](int k, int l) { return x[k] * y[l] - x[l] * y[k]; };
  const F m01 = det(0, 1), m02 = det(0, 2), m03 = det(0, 3), m12 = det(1, 2), m13 = det(1, 3), m23 = det(2, 3);
  const F e0 = (p[1] * m23 - p[2] * m13) + p[3] * m12, e1 = (p[0] * m23 - p[2] * m03) + p[3] * m02,
          e2 = (p[0] * m13 - p[1] * m03) + p[3] * m01, e3 = (p[0] * m12 - p[1] * m02) + p[2] * m01;
  const F terms = e0 * c.column[0];
  const F swapped = shuffled<1, 0, 3, 2>(terms);
  const F halves = terms - swapped;
  const T factor = inverse_factor(halves[0] + halves[2], least);
  const F even = pack_of(factor, -factor, factor, -factor), odd = pack_of(-factor, factor, -factor, factor);
  lanes<F>::store(out[0], e0 * even);
  lanes<F>::store(out[1], e1 * odd);
  lanes<F>::store(out[2], e2 * even);
  lanes<F>::store(out[3], e3 * odd);
}

// In one register of sixteen floats.
template <std::same_as<float> T>
IRG_INLINE void inverse4_in_one(const T (&a)[4][4], T (&out)[4][4], T least) noexcept {
  using F = pack<T, 16>;
  const F rows = lanes<F>::load(a[0]);
  // Lanes 0 to 5: minors 01 02 03 12 13 23 of the upper rows; 8 to 13: of the lower ones.
  const F x = shuffled<0, 0, 0, 1, 1, 2, 0, 0, 8, 8, 8, 9, 9, 10, 8, 8>(rows);
  const F y = shuffled<5, 6, 7, 6, 7, 7, 5, 5, 13, 14, 15, 14, 15, 15, 13, 13>(rows);
  const F z = shuffled<1, 2, 3, 2, 3, 3, 1, 1, 9, 10, 11, 10, 11, 11, 9, 9>(rows);
  const F w = shuffled<4, 4, 4, 5, 5, 6, 4, 4, 12, 12, 12, 13, 13, 14, 12, 12>(rows);
  const F minors = x * y - z * w;
  const F p0 = shuffled<5, 1, 13, 9, 4, 0, 12, 8, 4, 0, 12, 8, 4, 0, 12, 8>(rows);
  const F p1 = shuffled<6, 2, 14, 10, 6, 2, 14, 10, 5, 1, 13, 9, 5, 1, 13, 9>(rows);
  const F p2 = shuffled<7, 3, 15, 11, 7, 3, 15, 11, 7, 3, 15, 11, 6, 2, 14, 10>(rows);
  const F m0 = shuffled<13, 13, 5, 5, 13, 13, 5, 5, 12, 12, 4, 4, 11, 11, 3, 3>(minors);
  const F m1 = shuffled<12, 12, 4, 4, 10, 10, 2, 2, 10, 10, 2, 2, 9, 9, 1, 1>(minors);
  const F m2 = shuffled<11, 11, 3, 3, 9, 9, 1, 1, 8, 8, 0, 0, 8, 8, 0, 0>(minors);
  const F e = (p0 * m0 - p1 * m1) + p2 * m2;
  const F first = shuffled<0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12, 0, 4, 8, 12>(rows);
  const F terms = e * first;
  const F swapped = shuffled<1, 0, 3, 2, 1, 0, 3, 2, 1, 0, 3, 2, 1, 0, 3, 2>(terms);
  const F halves = terms - swapped;
  const F crossed = shuffled<2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1>(halves);
  const T factor = inverse_factor((halves + crossed)[0], least);
  constexpr T p = 1, n = -1;
  const F signs = pack_of(p, n, p, n, n, p, n, p, p, n, p, n, n, p, n, p);
  lanes<F>::store(out[0], e * (signs * lanes<F>::broadcast(factor)));
}

// out = the inverse of a by minors; not finite when the determinant, as computed, is 0; zero when it is below `least`.
template <class T>
IRG_INLINE constexpr void inverse4(const T (&a)[4][4], T (&out)[4][4], T least = T(0)) noexcept {
  if constexpr (has_row_lanes<T>) {
    if (!std::is_constant_evaluated()) {
      if constexpr (widest_lanes<T> == 16)
        return inverse4_in_one(a, out, least);
      else
        return inverse4_by_fours(a, out, least);
    }
  }
  return inverse4_plain(a, out, least);
}

// norm_1 of a matrix of four rows of four less `Diagonal` in its diagonal, as many columns at once as a register holds:
// bit for bit the plain one.
template <int Diagonal, class T>
IRG_INLINE T norm_1_in_lanes(const T (&a)[4][4]) noexcept {
  constexpr int count = has_row_lanes<T> ? 4 : 2;
  using F = lanes<pack<T, count>>;
  const auto sums_from = [&](int column) IRG_INLINE_LAMBDA {
    const auto row = [&](int r) IRG_INLINE_LAMBDA {
      const auto entries = F::load(a[r] + column);
      if constexpr (Diagonal == 0)
        return magnitude(entries);
      else
        return magnitude(entries - F::generate([&](int i) { return column + i == r ? T(Diagonal) : T(0); }));
    };
    return ((row(0) + row(1)) + row(2)) + row(3);
  };
  if constexpr (count == 4) {
    const auto sums = sums_from(0), pairs = maximum(shuffled<2, 3, 2, 3>(sums), sums);
    return maximum(pairs[0], pairs[1]);
  } else {
    const auto pairs = maximum(sums_from(0), sums_from(2));
    return maximum(pairs[0], pairs[1]);
  }
}
template <int Diagonal, class T, int N>
IRG_INLINE constexpr T norm_1_less(mat<T, N, N> a) noexcept {
  if constexpr (has_lanes && Floating<T> && N == 4)
    if (!std::is_constant_evaluated()) return norm_1_in_lanes<Diagonal>(a.m);
  if constexpr (Diagonal != 0)
    for (int i = 0; i < N; ++i) a(i, i) = a(i, i) - T(Diagonal);
  return norm_1(a);
}

// Whether the norm of a may be compared with a bound: constant evaluation refuses sums that overflow or are NaN, and so
// must see first that no entry is beyond the bound.
template <Floating T, int N>
IRG_INLINE constexpr bool norm_may_be_taken(const mat<T, N, N>& a, T bound) noexcept {
  if (!std::is_constant_evaluated()) return true;
  for (const auto& row : a.m)
    for (const T& entry : row)
      if (!(magnitude(entry) <= bound)) return false;
  return true;
}

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
    largest = maximum(size, largest);
    if (size != T(0)) least = minimum(size, least);
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
  if (!norm_may_be_taken(a, largest)) return false;
  const T size = norm_1_less<0>(a);
  if (!(size <= largest)) return false;
  x = inverse_by_cofactors(a, least);
  const T condition = product(size, norm_1_less<0>(x));
  if (!(condition * (T(N) * epsilon) < T(1))) return false;
  mat<T, N, N> rest = a * x;
  if (!(norm_1_less<1>(rest) <= T(1.5) * epsilon * condition)) return false;
  if (a(N - 1, N - 1) == T(1)) keep_affine(a, x);
  return true;
}

// The entries of x, the inverse of s.a, that have to be found in another way, as bits r N + c: those that are doubtful,
// unless they are rounding errors of terms so large that no scaling makes more of them: below
// 4 N u of |x| * |s.a| * |x|.
template <int N>
constexpr unsigned doubtful_entries(const scaled_system<N>& s, const mat<double, N, N>& x, double condition) noexcept {
  const auto sizes = [](const mat<double, N, N>& m) {
    return generate_mat<double, N, N>([&](int r, int c) { return magnitude(m(r, c)); });
  };
  unsigned which = 0;
  double largest[static_cast<std::size_t>(N)]{};
  for (int c = 0; c < N; ++c) {
    for (int r = 0; r < N; ++r) largest[c] = maximum(largest[c], magnitude(x(r, c)));
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
    largest = maximum(largest, size_1(column));
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

// `inverse` where cofactors will not do.
template <Real T, int N>
IRG_NOINLINE constexpr std::optional<mat<T, N, N>> inverse_by_elimination(const mat<T, N, N>& a) noexcept {
  if (!entries_finite<T>(a, N, N)) return std::nullopt;
  mat<T, N, N> left = a, right = identity_matrix<T, N>();
  const bool is_regular = gauss_jordan<T>(left, right, N);
  // A pivot that overflows leaves zeros in `right`, and a NaN in `left`.
  const bool fits = entries_finite<T>(left, N, N) && entries_finite<T>(right, N, N);
  if (is_regular && fits && inverse_has_digits<T>(a, right, N)) return right;
  if constexpr (Floating<T>)
    if (!fits || has_mixed_sizes(a)) return inverse_accurate(a);
  return std::nullopt;
}

template <Floating T, int N>
constexpr std::optional<mat<T, N, N>> find_accurate_inverse(const mat<T, N, N>& a) noexcept {
  const auto wide = generate_mat<double, N, N>([&](int r, int c) { return widened(a(r, c)); });
  if (!entries_finite<double>(wide, N, N)) return std::nullopt;
  const auto s = factor_scaled(wide, scaling::by_largest);
  mat<T, N, N> result{};
  if (!refined_inverse(s, wide, result)) {
    if (!s.sizes.may_hide_regular()) return std::nullopt;
    if constexpr (N <= 4) {
      const double part = smallest_condition(N);
      if (!put_exact_inverse(wide, all_of<N * N>, part, result)) return std::nullopt;
    } else if (!refined_inverse(factor_scaled(wide, scaling::by_means), wide, result)) {
      return std::nullopt;
    }
  }
  if (!entries_finite<T>(result, N, N)) return std::nullopt;
  return result;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T, int N>
  requires(N == 2 || N == 3 || N == 4)
[[nodiscard]] constexpr mat<T, N, N> inverse_fast(const mat<T, N, N>& a) noexcept {
  return detail::inverse_by_cofactors(a, T(0));
}

template <Real T, int N>
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse(const mat<T, N, N>& a) noexcept {
  if constexpr (Floating<T> && N >= 2 && N <= 4) {
    std::optional<mat<T, N, N>> result(std::in_place);
    if (detail::inverse_is_easy(a, *result)) return result;
    return detail::hard_inverse(a);
  } else {
    return detail::inverse_by_elimination(a);
  }
}

template <Floating T, int N>
[[nodiscard]] constexpr std::optional<mat<T, N, N>> inverse_accurate(const mat<T, N, N>& a) noexcept {
  if constexpr (N >= 2 && N <= 4)
    return detail::accurate_inverse(a);
  else
    return detail::find_accurate_inverse(a);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
  requires(N >= 2 && N <= 4)
IRG_API std::optional<mat<T, N, N>> hard_inverse(const mat<T, N, N>& a) noexcept {
  return inverse_by_elimination(a);
}
template <Floating T, int N>
  requires(N >= 2 && N <= 4)
IRG_API std::optional<mat<T, N, N>> accurate_inverse(const mat<T, N, N>& a) noexcept {
  return find_accurate_inverse(a);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
