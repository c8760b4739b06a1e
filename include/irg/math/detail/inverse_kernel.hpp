// SPDX-License-Identifier: MIT
// The inverse of a 4x4 matrix by minors: e(i, j) = (p(j) * m(j) - q(j) * n(j)) + s(j) * o(j), three entries of row j^1
// times 2x2 minors of the two rows that j is not in, with signs, over the determinant. The plain body, which constant
// evaluation takes, and two bodies in lanes have the same bits.
#pragma once

#include <concepts>
#include <cstddef>

#include <irg/math/detail/mat_kernel.hpp>

namespace irg::detail::inline IRG_ABI {

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

}  // namespace irg::detail::inline IRG_ABI
