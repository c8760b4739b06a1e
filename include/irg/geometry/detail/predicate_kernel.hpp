// SPDX-License-Identifier: MIT
// What the exact predicates share: tables of coordinates, and doubles as integers. The exact stages multiply all
// coordinates by one power of two, which changes no sign, so that they become integers of one or two words. Where a
// coordinate does not, because exponents lie too far apart, the stages say so and the next one decides.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <irg/core/contract.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/math/wide_int.hpp>

namespace irg::detail {

// Number types every value of which is a double.
template <class T>
inline constexpr bool fits_double = Floating<T> || (std::is_integral_v<T> && sizeof(T) <= 4);

// The coordinates of M points of D dimensions, point by point.
template <class T, int M, int D>
struct point_table {
  T v[static_cast<unsigned>(M * D)];
  IRG_INLINE constexpr const T& operator()(int i, int k) const noexcept { return v[i * D + k]; }
};

inline namespace IRG_ABI {

// Whether rounded stages must be left out: overflow, which they are proof against, is an error there.
IRG_INLINE constexpr bool in_constant_evaluation() noexcept { return std::is_constant_evaluated(); }

// The coordinates of points of one type as numbers N.
template <class N, Point P, std::same_as<P>... Ps>
IRG_INLINE constexpr auto table_of(const P& first, const Ps&... others) {
  constexpr int count = 1 + static_cast<int>(sizeof...(Ps)), size = size_of<P>;
  const P* const points[] = {&first, &others...};
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return point_table<N, count, size>{{static_cast<N>(coordinate(*points[I / size], I % size))...}};
  }(std::make_integer_sequence<int, count * size>{});
}

// The points but the last, seen from the last one.
template <class T, int M, int D>
IRG_INLINE constexpr point_table<T, M - 1, D> relative_to_last(const point_table<T, M, D>& t) {
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return point_table<T, M - 1, D>{{(t.v[I] - t.v[(M - 1) * D + I % D])...}};
  }(std::make_integer_sequence<int, (M - 1) * D>{});
}

// The same coordinates as numbers N.
template <class N, class T, int M, int D>
IRG_INLINE constexpr point_table<N, M, D> widened(const point_table<T, M, D>& t) {
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return point_table<N, M, D>{{N(t.v[I])...}};
  }(std::make_integer_sequence<int, M * D>{});
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
  for (int i = 1; i < M; ++i) largest = greater(largest, magnitude(t(i, k)));
  return largest;
}

// The largest |x[i]|; halves are compared by themselves, so that they need not wait for each other.
template <int N>
IRG_INLINE constexpr double largest_magnitude(const double* x) noexcept {
  if constexpr (N == 1)
    return magnitude(x[0]);
  else
    return greater(largest_magnitude<N / 2>(x), largest_magnitude<N - N / 2>(x + N / 2));
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
    const integer_double part = integer_parts(c);
    if (part.significand != 0 && part.place > largest) largest = part.place;
  }
  for (int i = 0; i < M * D; ++i) {
    const integer_double part = integer_parts(x.v[i]);
    const int shift = part.place - largest + 72;  // 53 bits and these make 125
    const wide_unsigned size = part.significand;
    if (part.significand == 0) continue;
    if (shift < 0 && (shift <= -64 || size >> -shift << -shift != size)) return false;
    const auto value = static_cast<wide_signed>(shift < 0 ? size >> -shift : size << shift);
    integers.v[i] = part.negative ? -value : value;
  }
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
