// SPDX-License-Identifier: MIT
// The sign of the determinant of points, of the sums of their squares (with two points more than dimensions) and ones,
// whatever the exponents: rounded, with exponents that never end, and as an exact sum. Both take the determinant apart
// into products of coordinates, no differences: no two of its products are made of the same numbers, so that where the
// exponents lie far apart one product is far larger than the others, and rounded numbers tell.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/config.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact_sum.hpp>

namespace irg::detail {

// The coordinates of M points of D dimensions, point by point.
template <class T, int M, int D>
struct point_table {
  T v[static_cast<unsigned>(M * D)];
  IRG_INLINE constexpr const T& operator()(int i, int k) const noexcept { return v[i * D + k]; }
};

// value * 2^exponent, rounded; `size` is what the value would be if all products in it were positive, at least 1 unless
// everything in it is zero. What becomes smaller than 2^-1000 beside the rest is lost, which does not count.
struct IRG_APART ranged_number {
  double value, size;
  int exponent;

  // From its bits, for processors that take subnormal numbers for zero.
  IRG_INLINE static constexpr ranged_number of(double x) noexcept {
    const std::uint64_t bits = bits_of(x), sign = bits >> 63 << 63;
    std::uint64_t fraction = bits & 0xfffffffffffffu;
    int field = static_cast<int>(bits >> 52 & 0x7ff);
    if (field == 0) {
      if (fraction == 0) return {0, 0, -(1 << 16)};  // lower than of any product of numbers that are not zero
      const int shift = std::countl_zero(fraction) - 11;
      fraction = fraction << shift & 0xfffffffffffffu;
      field = 1 - shift;
    }
    const double size = from_bits(fraction | std::uint64_t{1023} << 52);
    return {from_bits(bits_of(size) | sign), size, field - 1023};
  }
  IRG_INLINE constexpr ranged_number operator-() const noexcept { return {-value, size, exponent}; }
  IRG_INLINE friend constexpr ranged_number operator+(const ranged_number& a, const ranged_number& b) noexcept {
    const int top = greater(a.exponent, b.exponent);
    const auto power = [&](int e) {
      return from_bits(static_cast<std::uint64_t>(1023 + greater(e - top, -1000)) << 52);
    };
    const double x = power(a.exponent), y = power(b.exponent);
    return {a.value * x + b.value * y, a.size * x + b.size * y, top};
  }
  IRG_INLINE friend constexpr ranged_number operator*(const ranged_number& a, const ranged_number& b) noexcept {
    return {a.value * b.value, a.size * b.size, a.exponent + b.exponent};
  }
};

inline namespace IRG_ABI {

// Point by point: the determinants of the first n columns and any n rows, each by its last column from those before.
// At most 16 roundings lie on the way of a product (for spheres: the sum of squares 3, the area of x and y 2, then 1
// and the terms but one for each column, 3, 4 and 4), so that the value is off by less than 17u times the size.
template <int M, int D>
constexpr bool ranged_sign(const point_table<double, M, D>& t, int& sign) noexcept {
  constexpr unsigned all = (1u << M) - 1;
  ranged_number column[static_cast<unsigned>(M - 1)][static_cast<unsigned>(M)]{};
  for (int i = 0; i < M; ++i) {
    for (int k = 0; k < D; ++k) column[k][i] = ranged_number::of(t(i, k));
    if constexpr (M == D + 2) {
      ranged_number sum = column[0][i] * column[0][i];
      for (int k = 1; k < D; ++k) sum = sum + column[k][i] * column[k][i];
      column[D][i] = sum;
    }
  }
  ranged_number minor[all + 1]{};
  for (unsigned rows = 1; rows <= all; ++rows) {
    const int k = std::popcount(rows) - 1;
    ranged_number sum{0, 0, -(1 << 20)};
    int place = k;
    for (int i = 0; i < M; ++i) {
      if ((rows >> i & 1) == 0) continue;
      const ranged_number& rest = minor[rows & ~(1u << i)];
      const ranged_number term = k == 0 ? column[0][i] : k == M - 1 ? rest : column[k][i] * rest;
      sum = sum + (place-- % 2 == 0 ? term : -term);
    }
    minor[rows] = sum;
  }
  const ranged_number& whole = minor[all];
  sign = whole.value < 0 ? -1 : 1;
  return magnitude(whole.value) > whole.size * 0x1p-48;
}

// Adds the products that begin with x, which the points `used` gave, one for each column; then come the squares, where
// there are any, and the last point has the 1.
template <int K, int M, int D, class... X>
constexpr void add_products(exact_accumulator<K>& sum, const point_table<double, M, D>& t, unsigned used, bool minus,
                            X... x) noexcept {
  constexpr int column = static_cast<int>(sizeof...(X));
  if constexpr (column == D && M == D + 1) {
    minus ? sum.subtract(x...) : sum.add(x...);
  } else {
    for (int i = 0; i < M; ++i) {
      if ((used >> i & 1) != 0) continue;
      if constexpr (column < D)
        add_products(sum, t, used | 1u << i, minus, x..., t(i, column));
      else
        for (int k = 0; k < D; ++k) minus ? sum.subtract(x..., t(i, k), t(i, k)) : sum.add(x..., t(i, k), t(i, k));
      minus = !minus;
    }
  }
}
template <int M, int D>
constexpr int sum_sign(const point_table<double, M, D>& t) noexcept {
  exact_accumulator<M == D + 2 ? D + 2 : D> sum;
  add_products(sum, t, 0, false);
  return sum.sign();
}

}  // namespace IRG_ABI
}  // namespace irg::detail
