// SPDX-License-Identifier: MIT
// The floating-point number nearest to a decimal text.
//
// 19 digits times 128 bits of the power of ten bound the number from below and from above, so closely that both bounds
// nearly always have the same nearest floating-point number. Where they have not, those two are neighbours, and an
// exact comparison with the middle between them decides.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/detail/decimal_scan.hpp>

namespace irg::detail::inline IRG_ABI {

template <Floating T>
using bits_of_decimal = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

/// The exponent of the last bit of T's subnormals.
template <Floating T>
inline constexpr int lowest_exponent = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;

/// The T nearest to significand * 2^exponent, ties to even; infinity beyond the largest.
/// needs   significand > 0; inexact: the true value is a little larger, by less than the significand's last bit, and
///         the significand has more bits than T by two or more
template <Floating T>
constexpr T nearest(std::uint64_t significand, int exponent, bool inexact) noexcept {
  constexpr int precision = std::numeric_limits<T>::digits;
  constexpr int lowest = lowest_exponent<T>;
  constexpr int highest = std::numeric_limits<T>::max_exponent - precision;
  const int zeros = std::countl_zero(significand);
  significand <<= zeros;
  exponent -= zeros;
  int drop = 64 - precision;
  if (exponent + drop < lowest) drop = lowest - exponent;
  if (drop > 64) return T{0};
  std::uint64_t kept = drop == 64 ? 0 : significand >> drop;
  const std::uint64_t rest = drop == 64 ? significand : significand << (64 - drop);  // in units of 2^-64 of kept's
  constexpr std::uint64_t half = std::uint64_t{1} << 63;
  if (rest > half || (rest == half && (inexact || (kept & 1) != 0))) ++kept;
  exponent += drop;
  if (kept >> precision != 0) {
    kept >>= 1;
    ++exponent;
  }
  if (exponent > highest) return std::numeric_limits<T>::infinity();
  // A normal number's leading bit adds the 1 that its exponent field lacks here; a subnormal has neither.
  return std::bit_cast<T>(
      static_cast<bits_of_decimal<T>>((static_cast<std::uint64_t>(exponent - lowest) << (precision - 1)) + kept));
}

inline constexpr double double_powers_of_ten[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// By one operation on exact doubles.
/// needs   mantissa <= 2^53, abs(exponent) <= 22
/// gives   whether `value` is the nearest T; a float is refused where the double's own rounding may have decided
template <Floating T>
constexpr bool nearest_by_double(std::uint64_t mantissa, int exponent, T& value) noexcept {
  const double m = static_cast<double>(mantissa);
  const double d = exponent < 0 ? m / double_powers_of_ten[-exponent] : m * double_powers_of_ten[exponent];
  value = converted<T>(d);
  if constexpr (sizeof(T) == 4) {
    // d lies between 1e-22 and 1e38, where floats are normal. Its low 29 bits are what the second rounding cuts off.
    return (std::bit_cast<std::uint64_t>(d) & 0x1fffffffu) != 0x10000000u;
  }
  return true;
}

/// By dropping bits, for most normal numbers: whether it could be done.
/// needs   the number more than significand * 2^exponent and less than (significand + 2) * 2^exponent; 63 or 64 bits
template <Floating T>
constexpr bool nearest_by_bits(std::uint64_t significand, int exponent, T& value) noexcept {
  constexpr int precision = std::numeric_limits<T>::digits;
  const int drop = 63 - precision + static_cast<int>(significand >> 63);
  const std::uint64_t half = std::uint64_t{1} << (drop - 1), rest = significand & (2 * half - 1);
  const int field = exponent + drop - lowest_exponent<T>;
  if (field < 0 || field > 2 * std::numeric_limits<T>::max_exponent - 3 || rest == half - 1) return false;
  const std::uint64_t kept = ((significand >> (drop - 1)) + 1) >> 1;  // its leading bit adds 1 to the exponent field
  value =
      std::bit_cast<T>(static_cast<bits_of_decimal<T>>((static_cast<std::uint64_t>(field) << (precision - 1)) + kept));
  return true;
}

/// The first `limit` significant digits of a text as a natural, and one more, a 1, if any other that follows is not 0;
/// returns how many they are.
constexpr int load_digits(const decimal_text& text, int limit, natural& a) noexcept {
  int count = 0;
  std::uint64_t chunk = 0, chunk_power = 1;
  const auto append = [&](std::uint64_t digits, std::uint64_t power, int n) {
    if (chunk_power > 10'000'000'000'000'000'000u / power) {
      a.multiply_add(chunk_power, chunk);
      chunk = 0;
      chunk_power = 1;
    }
    chunk = chunk * power + digits;
    chunk_power *= power;
    count += n;
  };
  const char* p = skip_zeros(text.digits, text.digits_end);
  while (p != text.digits_end && count < limit) {
    if (text.digits_end - p >= 8 && count <= limit - 8) {
      const std::uint64_t eight = load_eight(p);
      if (are_digits(eight)) {
        append(value_of_eight(eight), 100'000'000, 8);
        p += 8;
        continue;
      }
    }
    if (*p != '.') append(digit_value(*p), 10, 1);
    ++p;
  }
  if (skip_zeros(p, text.digits_end) != text.digits_end) append(1, 10, 1);
  a.multiply_add(chunk_power, chunk);
  return count;
}

/// `below` or the next larger number, whichever is nearer to the text's number; by naturals, right for every text.
/// needs   a number between those two, mantissa > 0, -345 <= exponent <= 310
template <Floating T>
IRG_NOINLINE constexpr T nearest_by_naturals(const decimal_text& text, T below) noexcept {
  constexpr int fraction_bits = std::numeric_limits<T>::digits - 1;
  const std::uint64_t bits = std::bit_cast<bits_of_decimal<T>>(below);
  const int field = static_cast<int>(bits >> fraction_bits);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << fraction_bits) - 1);
  const std::uint64_t significand = field == 0 ? fraction : fraction | (std::uint64_t{1} << fraction_bits);
  const int middle_exponent = lowest_exponent<T> + (field == 0 ? 1 : field) - 2;
  natural middle = natural::from(2 * significand + 1), a;
  int exponent = static_cast<int>(text.exponent);
  if (text.cut) {
    // The middle is a multiple of 2^middle_exponent, so of that power of ten when this is negative, or of 1: of digits
    // beyond that place it matters only whether all are 0. The mantissa's exponent is the 19th digit's.
    const int limit = exponent + 19 - (middle_exponent < 0 ? middle_exponent : 0);
    exponent += 19 - load_digits(text, limit, a);
  } else {
    a = natural::from(text.mantissa);
  }
  if (exponent >= 0)
    a.multiply_power_of_five(exponent);
  else
    middle.multiply_power_of_five(-exponent);
  const int order = compare_shifted(a, exponent - middle_exponent, middle);
  const bool up = order > 0 || (order == 0 && (bits & 1) != 0);
  return std::bit_cast<T>(static_cast<bits_of_decimal<T>>(bits + (up ? 1 : 0)));
}

/// The T nearest to the text's number without its sign.
template <Floating T>
constexpr T magnitude(const decimal_text& text) noexcept {
  // The mantissa is less than 10^19.
  if (text.mantissa == 0 || text.exponent < -342) return T{0};
  if (text.exponent > 308) return std::numeric_limits<T>::infinity();
  const int n = static_cast<int>(text.exponent);
  T value{};
  if (!text.cut && text.mantissa <= std::uint64_t{1} << 53 && n >= -22 && n <= 22 &&
      nearest_by_double(text.mantissa, n, value))
    return value;
  const int zeros = std::countl_zero(text.mantissa);
  const std::uint64_t m = text.mantissa << zeros;
  const word_pair power = power_of_five_to_128_bits(n);
  const word_pair lower_part = multiply_words(m, power.low);
  const word_pair product = multiply_words(m, power.high, lower_part.high);  // and below it lower_part.low
  const int exponent = floor_log2_of_power_of_five(n) + n - zeros + 1;  // of the last bit of product.high
  if (!text.cut && is_exact_to_128_bits(n))
    return nearest<T>(product.high, exponent, (product.low | lower_part.low) != 0);
  // The number is larger than the product. What the power lacks is less than 1, so what the product lacks is less than
  // m in its lowest word; what is left of the digits is less than one unit of the mantissa.
  if (!text.cut && nearest_by_bits(product.high, exponent, value)) return value;
  const T below = nearest<T>(product.high, exponent, true);
  const std::uint64_t room = text.cut ? (std::uint64_t{1} << zeros) + 1 : product.low >= ~std::uint64_t{1} ? 1 : 0;
  if (room == 0) return below;
  const std::uint64_t larger = product.high + room;
  if (nearest<T>(larger >= room ? larger : ~std::uint64_t{0}, exponent, true) == below) return below;
  return nearest_by_naturals(text, below);
}

}  // namespace irg::detail::inline IRG_ABI
