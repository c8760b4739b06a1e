// SPDX-License-Identifier: MIT
// The floating-point number nearest to a decimal text.
//
// 19 digits times 128 bits of the power of ten bound the number from below and from above, so closely that both bounds
// nearly always have the same nearest floating-point number. Where they have not, those two are neighbours, and an
// exact comparison with the middle between them decides.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <irg/core/config.hpp>
#include <irg/core/conversion.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/decimal_digit.hpp>
#include <irg/math/detail/powers_of_five_table.hpp>
#include <irg/math/int128.hpp>

namespace irg::detail {

/// high * 2^64 + low.
struct word_pair {
  std::uint64_t high, low;
};

/// A decimal text taken apart: mantissa * 10^exponent, or more when digits were cut off.
struct decimal_text {
  const char* end;                // after the number; where it began when there is none
  const char* digits = nullptr;   // all its digits, perhaps with a point among them
  const char* digits_end = nullptr;
  const char* point = nullptr;    // that point
  std::uint64_t mantissa = 0;     // the first 19 significant digits
  std::int64_t exponent = 0;
  bool negative = false;
  bool cut = false;               // digits that are not 0 follow the mantissa's
};

inline namespace IRG_COMPILED_ABI {

/// The T nearest to the text's number without its sign.
template <Floating T>
IRG_API T unsigned_value(const decimal_text& text) noexcept;

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

// Powers of ten to 128 bits, which decide nearly always.

/// a * b + addend, which always fits.
IRG_INLINE constexpr word_pair multiply_words(std::uint64_t a, std::uint64_t b, std::uint64_t addend = 0) noexcept {
  const uint128 p = uint128{a} * b + addend;
  return {static_cast<std::uint64_t>(p >> 64), static_cast<std::uint64_t>(p)};
}

/// floor(log2(5^n)) and floor(log2(10^n)).
/// needs   -345 <= n <= 329
constexpr int floor_log2_of_power_of_five(int n) noexcept { return (n * 152170) >> 16; }
constexpr int floor_log2_of_power_of_ten(int n) noexcept { return (n * 217706) >> 16; }

/// 5^n / 2^(floor(log2(5^n)) - 127), cut off to an integer of 128 bits.
/// needs   lowest_power_of_five <= n <= highest_power_of_five
IRG_INLINE constexpr word_pair power_of_five_to_128_bits(int n) noexcept {
  const std::uint64_t* const entry = powers_of_five_to_128_bits + 2 * (n - lowest_power_of_five);
  return {entry[0], entry[1]};
}

/// Whether nothing was cut off.
constexpr bool is_exact_to_128_bits(int n) noexcept { return 0 <= n && n <= 55; }

// A natural number of bounded size on the stack, for the exact comparison of decimal text with binary numbers: as many
// operations as that needs and no more.

/// A natural number below 2^2816.
/// shape   words from low to high; the highest of `size` words is not 0; words from `size` on are 0
struct natural {
  static constexpr int capacity = 44;
  std::uint64_t words[capacity]{};
  int size = 0;

  /// needs   value > 0
  static constexpr natural from(std::uint64_t value) noexcept {
    natural n;
    n.words[0] = value;
    n.size = 1;
    return n;
  }

  constexpr void multiply_add(std::uint64_t factor, std::uint64_t addend) noexcept {
    std::uint64_t carry = addend;
    for (int i = 0; i < size; ++i) {
      const word_pair p = multiply_words(factor, words[i], carry);
      words[i] = p.low;
      carry = p.high;
    }
    if (carry != 0) words[size++] = carry;
  }

  constexpr void multiply_power_of_five(int exponent) noexcept {
    constexpr std::uint64_t largest = 7450580596923828125u;  // 5^27
    for (; exponent >= 27; exponent -= 27) multiply_add(largest, 0);
    multiply_add(power_of_five_to_128_bits(exponent).high >> (63 - floor_log2_of_power_of_five(exponent)), 0);
  }

  constexpr int bit_length() const noexcept { return size == 0 ? 0 : 64 * size - std::countl_zero(words[size - 1]); }

  constexpr void shift_left(int bits) noexcept {
    if (size == 0 || bits == 0) return;
    const int whole = bits / 64, part = bits % 64;
    const bool grows = part != 0 && words[size - 1] >> (64 - part) != 0;
    for (int i = size - (grows ? 0 : 1); i >= 0; --i) {
      const std::uint64_t high = i < size ? words[i] << part : 0;
      const std::uint64_t low = part != 0 && i > 0 ? words[i - 1] >> (64 - part) : 0;
      words[i + whole] = high | low;
    }
    for (int i = 0; i < whole; ++i) words[i] = 0;
    size += whole + (grows ? 1 : 0);
  }
};

/// -1, 0 or 1: a * 2^shift less than b, equal, more.
/// needs   a > 0, b > 0; shifts one of them, the shorter
constexpr int compare_shifted(natural& a, int shift, natural& b) noexcept {
  const int longer = a.bit_length() + shift - b.bit_length();
  if (longer != 0) return longer < 0 ? -1 : 1;
  if (shift > 0)
    a.shift_left(shift);
  else
    b.shift_left(-shift);
  for (int i = a.size - 1; i >= 0; --i)
    if (a.words[i] != b.words[i]) return a.words[i] < b.words[i] ? -1 : 1;
  return 0;
}

// A decimal text taken apart into digits and exponent, eight digits at a time where there are so many.

/// Eight bytes as a number, the first one lowest. Compilers do not always make one load of eight.
IRG_INLINE constexpr std::uint64_t load_eight(const char* p) noexcept {
  if (std::endian::native == std::endian::little && !std::is_constant_evaluated()) {
    std::uint64_t eight;
    std::memcpy(&eight, p, sizeof eight);
    return eight;
  }
  const auto byte = [p](int i) { return std::uint64_t{static_cast<unsigned char>(p[i])} << (8 * i); };
  return byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
}

/// Whether eight loaded bytes are digits: their upper halves are 3, also with 6 added.
constexpr bool are_digits(std::uint64_t eight) noexcept {
  constexpr std::uint64_t upper = 0xf0f0f0f0f0f0f0f0u;
  return (((eight & upper) | (((eight + 0x0606060606060606u) & upper) >> 4)) == 0x3333333333333333u);
}

/// The number that eight digits write, less '0' each: pairs of them, then fours, then all.
constexpr std::uint64_t value_of_values(std::uint64_t eight) noexcept {
  eight = (eight * 2561 >> 8) & 0x00ff00ff00ff00ffu;
  eight = (eight * 6553601 >> 16) & 0x0000ffff0000ffffu;
  return eight * 42949672960001u >> 32;
}

/// The number that eight loaded digits write.
constexpr std::uint64_t value_of_eight(std::uint64_t eight) noexcept {
  return value_of_values(eight - 0x3030303030303030u);
}

inline constexpr std::uint64_t small_powers_of_ten[9] = {1,       10,        100,        1'000,      10'000,
                                                         100'000, 1'000'000, 10'000'000, 100'000'000};

// Larger exponents decide nothing: no text that fits memory has so many digits.
inline constexpr std::int64_t exponent_limit = std::int64_t{1} << 60;

/// Reads e+5 and the like at p; returns p when no exponent stands there.
constexpr const char* scan_exponent(const char* p, const char* last, std::int64_t& exponent) noexcept {
  if (p == last || (*p != 'e' && *p != 'E')) return p;
  const char* q = p + 1;
  const bool negative = q != last && *q == '-';
  if (q != last && (*q == '-' || *q == '+')) ++q;
  if (q == last || !is_decimal_digit(*q)) return p;
  std::int64_t value = 0;
  for (; q != last && is_decimal_digit(*q); ++q)
    if (value < exponent_limit / 16) value = value * 10 + decimal_digit_value(*q);
  exponent = negative ? -value : value;
  return q;
}

/// The digits at p, appended to the mantissa, which wraps when there are too many; returns their end.
constexpr const char* scan_digits(const char* p, const char* last, std::uint64_t& mantissa) noexcept {
  for (; p != last && is_decimal_digit(*p); ++p) mantissa = mantissa * 10 + decimal_digit_value(*p);
  return p;
}

/// The same, faster where there are many.
constexpr const char* scan_many_digits(const char* p, const char* last, std::uint64_t& mantissa) noexcept {
  while (last - p >= 8) {
    const std::uint64_t eight = load_eight(p);
    if (!are_digits(eight)) break;
    mantissa = mantissa * 100'000'000 + value_of_eight(eight);
    p += 8;
  }
  return scan_digits(p, last, mantissa);
}

/// The first of the digits that is not 0.
constexpr const char* skip_zeros(const char* p, const char* digits_end) noexcept {
  while (digits_end - p >= 8 && load_eight(p) == 0x3030303030303030u) p += 8;
  while (p != digits_end && (*p == '0' || *p == '.')) ++p;
  return p;
}

/// Finds the first 19 significant digits of a text that has more digits than that, zeros in front among them.
constexpr void cut_mantissa(decimal_text& text) noexcept {
  std::uint64_t mantissa = 0;
  const char* p = skip_zeros(text.digits, text.digits_end);
  if (text.digits_end - p <= 19) return;
  for (; p != text.digits_end && mantissa < 1'000'000'000'000'000'000u; ++p)
    if (*p != '.') mantissa = mantissa * 10 + decimal_digit_value(*p);
  text.mantissa = mantissa;
  text.exponent += text.digits_end - p - (text.point != nullptr && text.point >= p ? 1 : 0);
  text.cut = skip_zeros(p, text.digits_end) != text.digits_end;
}

constexpr decimal_text scan_decimal(const char* first, const char* last) noexcept {
  decimal_text text{first};
  const char* p = first;
  text.negative = p != last && *p == '-';
  if (p != last && (*p == '-' || *p == '+')) ++p;
  text.digits = p;
  p = scan_digits(p, last, text.mantissa);
  std::int64_t count = p - text.digits, fraction = 0;
  if (p != last && *p == '.') {
    text.point = p;
    p = scan_many_digits(p + 1, last, text.mantissa);
    fraction = p - text.point - 1;
    count += fraction;
  }
  if (count == 0) return text;
  text.digits_end = p;
  text.end = scan_exponent(p, last, text.exponent);
  text.exponent -= fraction;
  if (count > 19) cut_mantissa(text);
  return text;
}

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
    if (*p != '.') append(decimal_digit_value(*p), 10, 1);
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

}  // namespace IRG_ABI
}  // namespace irg::detail

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API T unsigned_value(const decimal_text& text) noexcept {
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

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
