// SPDX-License-Identifier: MIT
// The steps of inverse.hpp.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/elimination.hpp>
#include <irg/math/detail/inverse_kernel.hpp>
#include <irg/math/detail/norm_kernel.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/mat.hpp>

namespace irg::detail::inline IRG_ABI {

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

}  // namespace irg::detail::inline IRG_ABI
