// SPDX-License-Identifier: MIT
// The parts of a floating-point number: its sign, exponent and bits, and products with powers of two, in constant
// evaluation, too.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/contraction.hpp>
#include <irg/core/instructions.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/core/scalar.hpp>

namespace irg {

/// x = significand * 2^exponent with 1 <= |significand| < 2.
struct scaled_number {
  double significand;
  int exponent;
  bool operator==(const scaled_number&) const = default;
};

inline namespace IRG_ABI {

/// Greater than every number.
template <Floating T>
inline constexpr T infinity = std::numeric_limits<T>::infinity();
/// A quiet NaN.
template <Floating T>
inline constexpr T not_a_number = std::numeric_limits<T>::quiet_NaN();

/// The bits of a number, and the number of some bits.
[[nodiscard]] IRG_INLINE constexpr std::uint64_t bits_of(double x) noexcept { return std::bit_cast<std::uint64_t>(x); }
[[nodiscard]] IRG_INLINE constexpr double from_bits(std::uint64_t bits) noexcept { return std::bit_cast<double>(bits); }

/// Whether the sign bit is set, which tells -0 from 0.
[[nodiscard]] IRG_INLINE constexpr bool is_negative(double x) noexcept { return (bits_of(x) >> 63) != 0; }
[[nodiscard]] IRG_INLINE constexpr bool is_negative(float x) noexcept {
  return (std::bit_cast<std::uint32_t>(x) >> 31) != 0;
}

/// The magnitude of x with the sign of y.
[[nodiscard]] IRG_INLINE constexpr double with_sign(double x, double y) noexcept {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return from_bits((bits_of(x) & ~sign) | (bits_of(y) & sign));
}

/// Whether x is NaN.
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr bool is_nan(T x) noexcept {
  return x != x;
}

/// Whether x is 0 or 2^low <= |x| < 2^high. Told from the bits without asking whether they are zero: clang makes a
/// comparison of doubles of such a question, and that takes subnormal numbers for zero where the processor is told to.
/// needs   -1022 <= low < high <= 1024
template <int Low, int High>
[[nodiscard]] IRG_INLINE constexpr bool is_zero_or_within(double x) noexcept {
  constexpr std::uint64_t low = std::uint64_t{Low + 1023} << 53, high = std::uint64_t{High + 1023} << 53;
  const std::uint64_t size = bits_of(x) << 1;
  return size - 1 >= low - 1 && size < high;
}

/// Whether x is 0 or 2^low <= |x|.
template <int Low>
[[nodiscard]] IRG_INLINE constexpr bool is_zero_or_from(double x) noexcept {
  constexpr std::uint64_t low = std::uint64_t{Low + 1023} << 53;
  return (bits_of(x) << 1) - 1 >= low - 1;
}

/// x as a double, made of its bits where the processor might take it for zero.
[[nodiscard]] IRG_INLINE constexpr double exactly_widened(double x) noexcept { return x; }
[[nodiscard]] IRG_INLINE constexpr double exactly_widened(float x) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  if ((bits >> 23 & 0xff) != 0) return widened(x);
  const double size = static_cast<double>(bits & 0x7fffff) * 0x1p-149;
  return bits >> 31 != 0 ? -size : size;
}

/// x as a number of type T; infinity where it is too large, without an overflow that constant evaluation refuses.
/// exact   correctly rounded
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T narrowed(double x) noexcept {
  if constexpr (std::is_same_v<T, float>) {
    constexpr double first_infinite = 0x1.ffffffp127;
    if (magnitude(x) >= first_infinite) return x > 0 ? infinity<float> : -infinity<float>;
  }
  return converted<T>(x);
}

/// The T nearest to x + rest; infinity where that is too large.
/// needs   a rest too small to change the double x; its sign alone counts
/// exact   correctly rounded: once, also where x is a sum rounded and rest what that left
template <Floating T>
[[nodiscard]] constexpr T rounded_once(double x, double rest) noexcept {
  if constexpr (std::is_same_v<T, double>) {
    return x;
  } else {
    // An inexact double is made odd: the float nearest to it is then the one nearest to the sum.
    const std::uint64_t bits = bits_of(x);
    if (rest == 0 || x == 0 || (bits & 1) != 0) return narrowed<T>(x);
    return narrowed<T>(from_bits((rest < 0) == (x < 0) ? bits + 1 : bits - 1));
  }
}

/// x = +-significand * 2^(place + integer_parts<T>::least).
template <Floating T>
struct integer_parts {
  using bits_type = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;
  static constexpr int least = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;  // -149 or -1074
  bits_type significand;
  int place;
  bool negative;
  bool operator==(const integer_parts&) const = default;
};

/// x as an integer times a power of two, told from its bits: no mode of the processor reaches it.
/// needs   x finite
/// shape   place 0 or more; significand 0 for zeros, at least 2^23 (double: 2^52) where place is not 0
/// exact   always
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr integer_parts<T> integer_parts_of(T x) noexcept {
  using bits_type = typename integer_parts<T>::bits_type;
  constexpr int places = std::numeric_limits<T>::digits - 1;
  constexpr bits_type one = bits_type{1} << places, fields = 2 * std::numeric_limits<T>::max_exponent - 1;
  const auto bits = std::bit_cast<bits_type>(x);
  const bits_type fraction = bits & (one - 1), field = (bits >> places) & fields;
  return {field == 0 ? fraction : fraction | one, field == 0 ? 0 : static_cast<int>(field) - 1,
          bits >> (8 * sizeof(T) - 1) != 0};
}

/// 2^k.
/// needs   -1074 <= k <= 1023
[[nodiscard]] IRG_INLINE constexpr double power_of_two(int k) noexcept {
  return k >= -1022 ? from_bits(static_cast<std::uint64_t>(k + 1023) << 52) : from_bits(std::uint64_t{1} << (k + 1074));
}

/// x as a significand and a power of two.
/// needs   x finite and not zero
[[nodiscard]] IRG_INLINE constexpr scaled_number decompose(double x) noexcept {
  const bool is_subnormal = magnitude(x) < 0x1p-1022;
  const std::uint64_t bits = bits_of(is_subnormal ? x * 0x1p54 : x);
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  return {from_bits((bits & 0x800fffffffffffffu) | 0x3ff0000000000000u), biased - 1023 - (is_subnormal ? 54 : 0)};
}

/// The exponent e of x: 2^e <= |x| < 2^(e + 1).
/// needs   x finite and not zero
[[nodiscard]] IRG_INLINE constexpr int exponent_of(double x) noexcept {
  const int field = static_cast<int>((bits_of(x) >> 52) & 0x7ff);
  return field != 0 ? field - 1023 : decompose(x).exponent;
}

/// A power of two p with 1 <= x*p < 4, or 2^1023 for subnormal x.
/// needs   0 < x < infinity
[[nodiscard]] IRG_INLINE constexpr double normalizing_power_of_two(double x) noexcept {
  const std::uint64_t exponent = bits_of(x) >> 52;
  return from_bits((exponent < 2045 ? 2046 - exponent : std::uint64_t{1}) << 52);
}

/// x * 2^e for any e, rounded once.
[[nodiscard]] IRG_INLINE constexpr double times_power_of_two(double x, int e) noexcept {
  const int field = static_cast<int>((bits_of(x) >> 52) & 0x7ff);
  if (field != 0 && field + e > 0 && field < 0x7ff && field + e < 0x7ff)
    return from_bits(bits_of(x) + (static_cast<std::uint64_t>(e) << 52));
  if (x == 0 || !is_finite(x)) return x;
  const scaled_number parts = decompose(x);
  const int exponent = parts.exponent + e;
  if (exponent > 1023) return with_sign(infinity<double>, x);
  if (exponent >= -1074) return parts.significand * power_of_two(exponent);
  if (exponent < -1075) return with_sign(0.0, x);
  return parts.significand * 0.5 * 0x1p-1074;
}

}  // namespace IRG_ABI
}  // namespace irg
