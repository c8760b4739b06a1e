// SPDX-License-Identifier: MIT
// Gaussian elimination on anything that gives its entries by a(row, column), be its size fixed or not: what mat, matrix
// and the solvers share. Sizes are passed; they are constants where the type is of fixed size.
#pragma once

#include <limits>

#include <irg/core/contraction.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/float_bits.hpp>

namespace irg::detail::inline IRG_ABI {

template <class T>
IRG_INLINE constexpr T entry_size(const T& x) noexcept {
  if constexpr (Floating<T>)
    return magnitude(x);
  else
    return x < T(0) ? -x : x;
}

template <class T, class M>
constexpr bool entries_finite(const M& a, int rows, int columns) noexcept {
  if constexpr (Floating<T>)
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        if (!is_finite(a(r, c))) return false;
  return true;
}

// The row from k to n - 1 whose entry in column k is largest.
template <class M>
constexpr int pivot_row(const M& a, int k, int n) noexcept {
  int best = k;
  for (int r = k + 1; r < n; ++r)
    if (entry_size(a(best, k)) < entry_size(a(r, k))) best = r;
  return best;
}

template <class M>
constexpr void swap_entries(M& a, int r, int c, int s, int d) noexcept {
  const auto kept = a(r, c);
  a(r, c) = a(s, d);
  a(s, d) = kept;
}
template <class M>
constexpr void swap_rows(M& a, int r, int s, int columns) noexcept {
  for (int c = 0; c < columns && r != s; ++c) swap_entries(a, r, c, s, c);
}

// Row r minus f times row k, from column `first` on.
template <class T, class M>
constexpr void subtract_row(M& a, int r, const T& f, int k, int first, int columns) noexcept {
  for (int c = first; c < columns; ++c) a(r, c) = a(r, c) - product(f, a(k, c));
}

// The determinant of the n x n matrix that `rest` was.
template <class T, class M>
constexpr T eliminated_determinant(M& rest, int n) noexcept {
  T factor = T(1);
  for (int k = 0; k < n; ++k) {
    const int pivot = pivot_row(rest, k, n);
    if (rest(pivot, k) == T(0)) return T(0);
    if (pivot != k) factor = -factor;
    swap_rows(rest, k, pivot, n);
    factor = product(factor, rest(k, k));
    for (int r = k + 1; r < n; ++r) subtract_row(rest, r, T(rest(r, k) / rest(k, k)), k, k, n);
  }
  return factor;
}

// Turns `left` into the identity and `right`, the identity, into the inverse of what `left` was (n x n); false when it
// meets a column of zeros.
template <class T, class M>
constexpr bool gauss_jordan(M& left, M& right, int n) noexcept {
  for (int k = 0; k < n; ++k) {
    const int pivot_at = pivot_row(left, k, n);
    swap_rows(left, k, pivot_at, n);
    swap_rows(right, k, pivot_at, n);
    const T pivot = left(k, k);
    if (pivot == T(0)) return false;
    for (int c = 0; c < n; ++c) {
      left(k, c) = left(k, c) / pivot;
      right(k, c) = right(k, c) / pivot;
    }
    for (int r = 0; r < n; ++r) {
      if (r == k) continue;
      const T f = left(r, k);
      subtract_row(left, r, f, k, 0, n);
      subtract_row(right, r, f, k, 0, n);
    }
  }
  return true;
}

// Whether every row of x, the computed inverse of a, has a correct digit: the largest sum of |x_ij * a_ji| over j, a
// condition that does not depend on how rows and columns are scaled, is below 1/(2 n u) (Bauer 1963).
template <class T, class M>
constexpr bool inverse_has_digits(const M& a, const M& x, int n) noexcept {
  if constexpr (Floating<T>)
    for (int i = 0; i < n; ++i) {
      T condition = T(0);
      for (int j = 0; j < n; ++j) condition = condition + product(entry_size(x(i, j)), entry_size(a(j, i)));
      if (!(condition * (T(n) * std::numeric_limits<T>::epsilon()) < T(1))) return false;
    }
  return true;
}

}  // namespace irg::detail::inline IRG_ABI
