// SPDX-License-Identifier: MIT
// scaled_double_double: a double-double and a power of two, a real number to some 106 bits of any exponent: what
// values_of gives of a polynomial in doubles.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/float_bits.hpp>

namespace irg {

/// The real number (high + low) * 2^exponent.
/// shape   high is high + low rounded
struct scaled_double_double {
  double high = 0, low = 0;
  int exponent = 0;

  constexpr scaled_double_double() = default;
  IRG_INLINE constexpr explicit scaled_double_double(double x) noexcept : high(x) {}
  IRG_INLINE constexpr scaled_double_double(double h, double l, int e) noexcept : high(h), low(l), exponent(e) {}
  IRG_INLINE constexpr scaled_double_double(const exact_sum<double>& x, int e) noexcept
      : high(x.value), low(x.error), exponent(e) {}
  bool operator==(const scaled_double_double&) const = default;
};

namespace detail::inline IRG_ABI {

IRG_INLINE constexpr unrounded parts_of(const scaled_double_double& x) noexcept { return {x.high, x.low}; }

// Whether products and quotients with another such number stay far within the range as they are.
IRG_INLINE constexpr bool is_middling(double x) noexcept {
  const double size = magnitude(x);
  return size > 0x1p-200 && size < 0x1p200;
}

// Numbers of any exponent come here with 1 <= |high| < 2, so that their products and quotients stay in range.
constexpr scaled_double_double normalized_number(const scaled_double_double& x) noexcept {
  if (x.high == 0) return x;
  const int exponent = decompose(x.high).exponent;
  const double scale = power_of_two(-exponent);
  return {x.high * scale, x.low * scale, x.exponent + exponent};
}

IRG_INLINE constexpr scaled_double_double tamed_number(const scaled_double_double& x) noexcept {
  return x.exponent == 0 && is_middling(x.high) ? x : normalized_number(x);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

[[nodiscard]] constexpr scaled_double_double operator-(const scaled_double_double& a) noexcept {
  return {-a.high, -a.low, a.exponent};
}

/// a * b to some 100 bits.
[[nodiscard]] constexpr scaled_double_double operator*(const scaled_double_double& a,
                                                       const scaled_double_double& b) noexcept {
  const scaled_double_double x = detail::tamed_number(a), y = detail::tamed_number(b);
  return {detail::multiply(detail::parts_of(x), detail::parts_of(y)), x.exponent + y.exponent};
}

/// a - b, to some 100 bits unless they cancel.
[[nodiscard]] constexpr scaled_double_double operator-(const scaled_double_double& a,
                                                       const scaled_double_double& b) noexcept {
  const scaled_double_double x = detail::normalized_number(a), y = detail::normalized_number(b);
  if (y.high == 0) return x;
  if (x.high == 0) return -y;
  const int apart = x.exponent - y.exponent;
  if (apart > 200) return x;
  if (apart < -200) return -y;
  const double scale = power_of_two(-apart);
  return {detail::accurate_sum(detail::parts_of(x), {-(y.high * scale), -(y.low * scale)}), x.exponent};
}

/// a + b, to some 100 bits unless they cancel.
[[nodiscard]] constexpr scaled_double_double operator+(const scaled_double_double& a,
                                                       const scaled_double_double& b) noexcept {
  return a - -b;
}

[[nodiscard]] constexpr bool operator<(const scaled_double_double& a, const scaled_double_double& b) noexcept {
  return (a - b).high < 0;
}

/// a/b to some 100 bits.
/// needs   b is not zero
[[nodiscard]] constexpr scaled_double_double operator/(const scaled_double_double& a,
                                                       const scaled_double_double& b) noexcept {
  const scaled_double_double x = detail::tamed_number(a), y = detail::tamed_number(b);
  const auto quotient = detail::divide(detail::parts_of(x), detail::parts_of(y));
  return {detail::renormalised(quotient), x.exponent - y.exponent};
}

/// -1, 0 or 1, as x is negative, zero or positive.
template <Scalar T>
[[nodiscard]] IRG_INLINE constexpr int sign_of(const T& x) noexcept {
  if constexpr (std::is_same_v<T, scaled_double_double>)
    return x.high < 0 ? -1 : x.high > 0 ? 1 : 0;
  else
    return x < T(0) ? -1 : T(0) < x ? 1 : 0;
}

/// The square root to some 100 bits.
/// needs   x is not negative
[[nodiscard]] constexpr scaled_double_double sqrt(const scaled_double_double& a) noexcept {
  scaled_double_double x = detail::tamed_number(a);
  if (x.high <= 0) return {};
  if ((x.exponent & 1) != 0) x = {x.high * 2, x.low * 2, x.exponent - 1};
  return {detail::renormalised(detail::unrounded_sqrt(detail::parts_of(x))), x.exponent / 2};
}

/// The number as T; infinity beyond the range.
/// exact   within 0.501 ulp, where the result is subnormal, too
template <Floating T>
[[nodiscard]] constexpr T rounded_to(const scaled_double_double& x) noexcept {
  if (x.exponent == 0 && magnitude(x.high) > 0x1p-1000) return converted<T>(x.high);
  const scaled_double_double y = detail::normalized_number(x);
  if (y.high == 0) return T(0);
  double value = y.exponent < 0 ? 0.0 : y.high < 0 ? -infinity<double> : infinity<double>;
  if (y.exponent >= -1022 && y.exponent <= 1023) value = y.high * power_of_two(y.exponent);
  if (y.exponent < -1022 && y.exponent > -1080) {
    value = y.high * 0x1p-1000 * power_of_two(y.exponent + 1000);
    // `high` has been rounded before: where it is halfway between two numbers, `low` tells which one is nearer.
    const double rest = y.high - value * 0x1p1000 * power_of_two(-y.exponent - 1000);
    if (magnitude(rest) == power_of_two(-1075 - y.exponent) && y.low != 0 && (rest > 0) == (y.low > 0))
      value = value + (rest > 0 ? 0x1p-1074 : -0x1p-1074);
  }
  return converted<T>(value);
}
template <Scalar T>
  requires(!Floating<T>)
[[nodiscard]] IRG_INLINE constexpr T rounded_to(const T& x) noexcept {
  return x;
}

/// The T nearest to each coordinate.
template <Coordinates P, Coordinates V>
  requires(size_of<P> == size_of<V> && requires(const scalar_of<V> x) { rounded_to<scalar_of<P>>(x); })
[[nodiscard]] constexpr P rounded_coordinates(const V& v) noexcept {
  return generate_coordinates<P>([&](int i) { return rounded_to<scalar_of<P>>(coordinate(v, i)); });
}

/// All v as T, multiplied by one power of two where one of them is beyond the range, or the largest of the first
/// `Leading` so small that its last digits are.
template <Floating T, std::size_t Leading, std::size_t Size>
[[nodiscard]] constexpr std::array<T, Size> rounded_together(std::array<scaled_double_double, Size> v) noexcept {
  constexpr int highest = std::numeric_limits<T>::max_exponent - 3;
  constexpr int lowest = std::numeric_limits<T>::min_exponent + std::numeric_limits<T>::digits;
  int largest = -1000000, leading = -1000000;
  for (std::size_t i = 0; i < Size; ++i) {
    v[i] = detail::normalized_number(v[i]);
    if (v[i].high == 0) continue;
    largest = maximum(largest, v[i].exponent);
    if (i < Leading) leading = maximum(leading, v[i].exponent);
  }
  int shift = 0;
  if (largest > highest)
    shift = highest - largest;
  else if (leading < lowest)
    shift = minimum(-leading, highest - largest);
  std::array<T, Size> out{};
  for (std::size_t i = 0; i < Size; ++i) {
    v[i].exponent += shift;
    out[i] = rounded_to<T>(v[i]);
  }
  return out;
}
template <Scalar T, std::size_t Leading, std::size_t Size>
  requires(!Floating<T>)
[[nodiscard]] constexpr std::array<T, Size> rounded_together(const std::array<T, Size>& v) noexcept {
  return v;
}

}  // namespace IRG_ABI
}  // namespace irg
