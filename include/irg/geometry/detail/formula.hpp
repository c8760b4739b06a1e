// SPDX-License-Identifier: MIT
// The little vector algebra that formulas for evaluate() are written in: arrays of any number type.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <irg/core/coordinates.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/geometry/detail/evaluate.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// All coordinates, one argument after the other.
template <class T, Coordinates... C>
constexpr auto gathered(const C&... c) noexcept {
  std::array<T, static_cast<std::size_t>((size_of<C> + ...))> all{};
  std::size_t next = 0;
  const auto append = [&](const auto& v) {
    for (int i = 0; i < size_of<std::remove_cvref_t<decltype(v)>>; ++i) all[next++] = coordinate(v, i);
  };
  (append(c), ...);
  return all;
}

/// Numbers first, first + 1, ... of x.
template <std::size_t D, class N, std::size_t Size>
constexpr std::array<N, D> part_of(const std::array<N, Size>& x, std::size_t first) noexcept {
  std::array<N, D> part{};
  for (std::size_t i = 0; i < D; ++i) part[i] = x[first + i];
  return part;
}

template <class N, std::size_t D>
constexpr auto difference_of(const std::array<N, D>& a, const std::array<N, D>& b) noexcept {
  std::array<std::remove_cvref_t<decltype(a[0] - b[0])>, D> difference{};
  for (std::size_t i = 0; i < D; ++i) difference[i] = a[i] - b[i];
  return difference;
}
template <class N, std::size_t D>
constexpr std::array<N, D> sum_of(const std::array<N, D>& a, const std::array<N, D>& b) noexcept {
  std::array<N, D> sum{};
  for (std::size_t i = 0; i < D; ++i) sum[i] = a[i] + b[i];
  return sum;
}
template <class N, std::size_t D>
constexpr std::array<N, D> multiple_of(const std::array<N, D>& a, const N& s) noexcept {
  std::array<N, D> multiple{};
  for (std::size_t i = 0; i < D; ++i) multiple[i] = a[i] * s;
  return multiple;
}
template <class N, std::size_t D>
constexpr N dot_of(const std::array<N, D>& a, const std::array<N, D>& b) noexcept {
  N sum = a[0] * b[0];
  for (std::size_t i = 1; i < D; ++i) sum = sum + a[i] * b[i];
  return sum;
}
/// The cross product; in the plane its one coordinate across it.
template <class N>
constexpr std::array<N, 1> cross_of(const std::array<N, 2>& a, const std::array<N, 2>& b) noexcept {
  return {a[0] * b[1] - a[1] * b[0]};
}
template <class N>
constexpr std::array<N, 3> cross_of(const std::array<N, 3>& a, const std::array<N, 3>& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class N, std::size_t A, std::size_t B>
constexpr std::array<N, A + B> joined(const std::array<N, A>& a, const std::array<N, B>& b) noexcept {
  std::array<N, A + B> all{};
  for (std::size_t i = 0; i < A; ++i) all[i] = a[i];
  for (std::size_t i = 0; i < B; ++i) all[A + i] = b[i];
  return all;
}

/// Whether numbers first .. first + count - 1 are zero.
template <class V, std::size_t Size>
constexpr bool are_zero(const std::array<V, Size>& v, std::size_t first, std::size_t count) noexcept {
  for (std::size_t i = first; i < first + count; ++i)
    if (known_sign(v[i]) != 0) return false;
  return true;
}

/// Which of the numbers first .. first + 2 has the largest magnitude, 0 to 2.
template <class V, std::size_t Size>
constexpr std::size_t largest_of_three(const std::array<V, Size>& v, std::size_t first) noexcept {
  const auto is_larger = [](const V& a, const V& b) { return known_sign(a * a - b * b) > 0; };
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (is_larger(v[first + i], v[first + k])) k = i;
  return k;
}

/// The point whose coordinates are v[first + i] / divisor.
template <Coordinates P, class V, std::size_t Size>
constexpr P coordinates_over(const std::array<V, Size>& v, std::size_t first, const V& divisor) noexcept {
  return generate_coordinates<P>(
      [&](int i) { return rounded_to<scalar_of<P>>(v[first + static_cast<std::size_t>(i)] / divisor); });
}

/// All v as T, multiplied by one power of two where one of them is beyond the range, or the largest of the first
/// `Leading` so small that its last digits are.
template <Floating T, std::size_t Leading, std::size_t Size>
constexpr std::array<T, Size> rounded_together(std::array<known_number, Size> v) noexcept {
  constexpr int highest = std::numeric_limits<T>::max_exponent - 3;
  constexpr int lowest = std::numeric_limits<T>::min_exponent + std::numeric_limits<T>::digits;
  int largest = -1000000, leading = -1000000;
  for (std::size_t i = 0; i < Size; ++i) {
    v[i] = normalized_number(v[i]);
    if (v[i].high == 0) continue;
    largest = greater(largest, v[i].exponent);
    if (i < Leading) leading = greater(leading, v[i].exponent);
  }
  int shift = 0;
  if (largest > highest)
    shift = highest - largest;
  else if (leading < lowest)
    shift = lesser(-leading, highest - largest);
  std::array<T, Size> out{};
  for (std::size_t i = 0; i < Size; ++i) {
    v[i].exponent += shift;
    out[i] = rounded_to<T>(v[i]);
  }
  return out;
}
template <Scalar T, std::size_t Leading, std::size_t Size>
  requires(!Floating<T>)
constexpr std::array<T, Size> rounded_together(const std::array<T, Size>& v) noexcept {
  return v;
}

template <Coordinates P>
IRG_INLINE constexpr bool are_equal(const P& a, const P& b) noexcept {
  for (int i = 0; i < size_of<P>; ++i)
    if (!(coordinate(a, i) == coordinate(b, i))) return false;
  return true;
}
template <Coordinates P>
IRG_INLINE constexpr bool is_zero_vector(const P& a) noexcept {
  for (int i = 0; i < size_of<P>; ++i)
    if (!(coordinate(a, i) == scalar_of<P>(0))) return false;
  return true;
}

/// The coefficients of a plane as a vector.
template <Plane P>
IRG_INLINE constexpr std::array<plane_scalar<P>, 4> coefficients_of(const P& p) noexcept {
  return {plane_coefficient(p, 0), plane_coefficient(p, 1), plane_coefficient(p, 2), plane_coefficient(p, 3)};
}

}  // namespace IRG_ABI
}  // namespace irg::detail
