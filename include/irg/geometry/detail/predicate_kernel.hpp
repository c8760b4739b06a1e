// SPDX-License-Identifier: MIT
// What the exact predicates share: the stages that decide in turn. A predicate is the sign of the determinant of its
// points' coordinates, of the sums of their squares (for circles and spheres) and ones, so that the numbers of points
// and of dimensions tell which one it is. What a predicate has of its own are overloads for its table:
// difference_determinant, filtered_sign and compensated_sign.
//
// The stages of integers multiply all coordinates by one power of two, which changes no sign, so that they become
// integers of one or two words. Where a coordinate does not, because exponents lie too far apart, they leave it to the
// next stage.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/wide_int.hpp>
#if IRG_BODIES
#include <irg/core/contract.hpp>
#include <irg/math/exact_sum.hpp>
#endif

namespace irg::detail {

// The coordinates of M points of D dimensions, point by point.
template <class T, int M, int D>
struct point_table {
  T v[static_cast<unsigned>(M * D)];
  IRG_INLINE constexpr const T& operator()(int i, int k) const noexcept { return v[i * D + k]; }
};

inline namespace IRG_COMPILED_ABI {

// The sign of a predicate whose filter did not tell. Coordinates are passed in registers, so that nothing has to wait
// for the memory.
template <int M, int D, Floating... X>
IRG_API int exact_predicate(X... x) noexcept;

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

// Whether rounded stages must be left out: overflow, which they are proof against, is an error there.
IRG_INLINE constexpr bool in_constant_evaluation() noexcept { return std::is_constant_evaluated(); }

// The coordinates of points of one type as numbers N.
template <class N, Point P, std::same_as<P>... Ps>
IRG_INLINE constexpr auto table_of(const P& first, const Ps&... others) {
  constexpr int count = 1 + static_cast<int>(sizeof...(Ps)), size = size_of<P>;
  const P* const points[] = {&first, &others...};
  return [&]<int... J>(std::integer_sequence<int, J...>) IRG_INLINE_LAMBDA {
    return point_table<N, count, size>{{converted<N>(coordinate(*points[J / size], J % size))...}};
  }(std::make_integer_sequence<int, count * size>{});
}

// The points but the last, seen from the last one.
template <class T, int M, int D>
IRG_INLINE constexpr point_table<T, M - 1, D> relative_to_last(const point_table<T, M, D>& t) {
  return [&]<int... J>(std::integer_sequence<int, J...>) IRG_INLINE_LAMBDA {
    return point_table<T, M - 1, D>{{(t.v[J] - t.v[(M - 1) * D + J % D])...}};
  }(std::make_integer_sequence<int, (M - 1) * D>{});
}

template <class T>
IRG_INLINE constexpr int coordinate_sign(const T& v) noexcept {
  return v < T(0) ? -1 : T(0) < v ? 1 : 0;
}
template <int N>
IRG_INLINE constexpr int coordinate_sign(const wide_int<N>& v) noexcept {
  return v.sign();
}
// The sign of a number that is neither zero nor NaN.
IRG_INLINE constexpr int sign_of_nonzero(double x) noexcept {
  return 1 | static_cast<int>(static_cast<std::int64_t>(bits_of(x)) >> 63);
}

// The largest size of coordinate k.
template <int M, int D>
IRG_INLINE constexpr double reach(const point_table<double, M, D>& t, int k) noexcept {
  double largest = magnitude(t(0, k));
  for (int i = 1; i < M; ++i) largest = maximum(largest, magnitude(t(i, k)));
  return largest;
}

// The sign, for exact numbers: T holds the differences of coordinates, their products what they are made of.
template <class T, int M, int D>
IRG_INLINE constexpr int table_sign(const point_table<T, M, D>& t) {
  return coordinate_sign(difference_determinant(relative_to_last(t)));
}

template <Floating T, int M, int D>
IRG_INLINE constexpr int exact_predicate_of(const point_table<T, M, D>& t) noexcept {
  return [&]<int... J>(std::integer_sequence<int, J...>) {
    return exact_predicate<M, D>(t.v[J]...);
  }(std::make_integer_sequence<int, M * D>{});
}

// What the filters add to the largest differences along the axes, so that their bounds exceed what is lost where
// numbers are subnormal or taken for zero. That is 2^-1020 for a difference or a product of doubles; the product of
// `Degree` such numbers is 2^-960. Floats that are taken for zero make differences wrong by up to 2^-125: by 2^-65 of
// what they are with this number added, and the filters allow for 2^-50.
template <Floating T, int Degree>
inline constexpr double filter_least = std::is_same_v<T, float> ? 0x1p-60 : power_of_two(-960 / Degree);

// The predicate of M points.
template <Point P, std::same_as<P>... Ps>
IRG_INLINE constexpr int predicate(const P& first, const Ps&... others) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  using T = scalar_of<P>;
  constexpr bool is_round = static_cast<int>(sizeof...(Ps)) == size_of<P> + 1;
  if constexpr (Floating<T>) {
    constexpr double least = filter_least<T, size_of<P> + (is_round ? 2 : 0)>;
    if (!in_constant_evaluation())
      if (const int sign = filtered_sign(table_of<double>(first, others...), least); sign != 0) return sign;
    return exact_predicate_of(table_of<T>(first, others...));
  } else if constexpr (std::is_integral_v<T>) {
    using of_bytes = std::conditional_t<is_round, int128, std::int64_t>;
    using of_ints = std::conditional_t<is_round, wide_int<1>, int128>;
    using wide = std::conditional_t<sizeof(T) <= 2, of_bytes, std::conditional_t<sizeof(T) <= 4, of_ints, wide_int<2>>>;
    return table_sign(table_of<wide>(first, others...));
  } else {
    return table_sign(table_of<T>(first, others...));
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail

#if IRG_BODIES
namespace irg::detail {

// The sign of the determinant of points, of the sums of their squares (with two points more than dimensions) and ones,
// whatever the exponents: rounded, with exponents that never end, and as an exact sum. Both take the determinant apart
// into products of coordinates, no differences: no two of its products are made of the same numbers, so that where the
// exponents lie far apart one product is far larger than the others, and rounded numbers tell.

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
    const int top = maximum(a.exponent, b.exponent);
    const auto power = [&](int e) {
      return from_bits(static_cast<std::uint64_t>(1023 + maximum(e - top, -1000)) << 52);
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

// The same coordinates as numbers N.
template <class N, class T, int M, int D>
IRG_INLINE constexpr point_table<N, M, D> as_numbers(const point_table<T, M, D>& t) {
  return [&]<int... J>(std::integer_sequence<int, J...>) {
    return point_table<N, M, D>{{N(t.v[J])...}};
  }(std::make_integer_sequence<int, M * D>{});
}

// The largest |x[i]|; halves are compared by themselves, so that they need not wait for each other.
template <int N>
IRG_INLINE constexpr double largest_magnitude(const double* x) noexcept {
  if constexpr (N == 1)
    return magnitude(x[0]);
  else
    return maximum(largest_magnitude<N / 2>(x), largest_magnitude<N - N / 2>(x + N / 2));
}

template <int N>
IRG_INLINE constexpr bool are_finite(const double* x) noexcept {
  bool finite = true;
  for (int i = 0; i < N; ++i) finite = finite && is_finite(x[i]);
  return finite;
}

// The coordinates times 2^k with one k for all, as integers below 2^61 in size; whether that is possible. Neither
// subnormals nor a processor that takes them for zero get past the test: each integer must lead back to the bits it
// came from.
template <int M, int D>
IRG_INLINE constexpr bool to_words(const point_table<double, M, D>& x,
                                   point_table<std::int64_t, M, D>& integers) noexcept {
  IRG_EXPECTS(are_finite<M * D>(x.v));
  const std::uint64_t field = bits_of(largest_magnitude<M * D>(x.v)) >> 52;  // the exponent + 1023
  if (field - 61 > 2046 - 61) return false;
  const double scale = from_bits((2106 - field) << 52), back = from_bits((field - 60) << 52);
  std::uint64_t lost = 0;
  for (int i = 0; i < M * D; ++i) {
    integers.v[i] = static_cast<std::int64_t>(x.v[i] * scale);
    lost |= bits_of(static_cast<double>(integers.v[i]) * back) ^ bits_of(x.v[i]);
  }
  return lost << 1 == 0;  // the sign of a zero does not count
}

// The same with integers below 2^125, by integers alone.
template <int M, int D>
constexpr bool to_double_words(const point_table<double, M, D>& x, point_table<wide_int<2>, M, D>& integers) noexcept {
  int largest = 0;
  for (const double c : x.v) {
    const integer_parts<double> part = integer_parts_of(c);
    if (part.significand != 0 && part.place > largest) largest = part.place;
  }
  for (int i = 0; i < M * D; ++i) {
    const integer_parts<double> part = integer_parts_of(x.v[i]);
    const int shift = part.place - largest + 72;  // 53 bits and these make 125
    const uint128 size = part.significand;
    if (part.significand == 0) continue;
    if (shift < 0 && (shift <= -64 || ((size >> -shift) << -shift) != size)) return false;
    const auto value = static_cast<int128>(shift < 0 ? size >> -shift : size << shift);
    integers.v[i] = part.negative ? -value : value;
  }
  return true;
}

// What the determinant of all points is multiplied by to be the predicate.
template <int D>
inline constexpr int determinant_factor = D == 3 ? -1 : 1;

// The exact stages.
template <int M, int D>
IRG_INLINE constexpr bool sign_by_words(const point_table<double, M, D>& t, int& sign) noexcept {
  point_table<std::int64_t, M, D> n{};
  if (!to_words(t, n)) return false;
  sign = difference_determinant(as_numbers<wide_int<1>>(relative_to_last(n))).sign();
  return true;
}
template <int M, int D>
constexpr bool sign_by_double_words(const point_table<double, M, D>& t, int& sign) noexcept {
  point_table<wide_int<2>, M, D> n{};
  if (!to_double_words(t, n)) return false;
  sign = table_sign(n);
  return true;
}
template <int M, int D>
constexpr bool sign_by_range(const point_table<double, M, D>& t, int& sign) noexcept {
  if (!ranged_sign(t, sign)) return false;
  sign *= determinant_factor<D>;
  return true;
}
template <int M, int D>
constexpr int sign_by_sum(const point_table<double, M, D>& t) noexcept {
  return determinant_factor<D> * sum_sign(t);
}

// A predicate that has no rounded stage but the filter.
template <int M, int D>
IRG_INLINE constexpr int compensated_sign(const point_table<double, M, D>&) noexcept {
  return 0;
}

template <int M, int D, std::same_as<double>... X>
IRG_NOINLINE constexpr int sign_beyond_words(X... x) noexcept {
  const point_table<double, M, D> t{{x...}};
  int sign = 0;
  return sign_by_double_words(t, sign) || sign_by_range(t, sign) ? sign : sign_by_sum(t);
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <int M, int D, Floating... X>
IRG_NOINLINE IRG_API int exact_predicate(X... x) noexcept {
  const point_table<double, M, D> t{{exactly_widened(x)...}};
  int sign = 0;
  if (!in_constant_evaluation()) sign = compensated_sign(t);
  if (sign != 0 || sign_by_words(t, sign)) return sign;
  return sign_beyond_words<M, D>(exactly_widened(x)...);
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
