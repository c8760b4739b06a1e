// SPDX-License-Identifier: MIT
// Decimal text to float, double and integers: correctly rounded, without locale, memory or global state, the same in
// constant evaluation and at run time.
//
// Three ways lead to the nearest number, each exact where it is taken: one division or product of two exact doubles; a
// 128-bit quotient or product; a quotient of naturals of up to 2816 bits.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/scalar.hpp>
#include <irg/math/detail/natural.hpp>

namespace irg {

/// What became of a decimal text.
enum class decimal_status {
  ok,         ///< the nearest number
  none,       ///< no number stands there
  overflow,   ///< larger than every finite number of the type: infinity, or the last integer
  underflow,  ///< not zero, but nearest to zero
};

/// A number read from text, and where the text after it begins.
template <class T>
struct decimal_result {
  T value{};
  const char* end = nullptr;
  decimal_status status = decimal_status::none;
};

namespace detail {
inline namespace IRG_ABI {

/// A decimal text taken apart: mantissa * 10^exponent, or more when digits were cut off.
struct decimal_text {
  const char* end;                // after the number; where it began when there is none
  const char* digits = nullptr;   // all its digits, perhaps with a point among them
  const char* digits_end = nullptr;
  std::uint64_t mantissa = 0;     // the first 19 significant digits
  std::int64_t exponent = 0;
  bool negative = false;
  bool cut = false;               // digits that are not 0 follow the mantissa's
};

constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
constexpr unsigned digit_value(char c) noexcept { return static_cast<unsigned>(c - '0'); }

// Larger exponents decide nothing: no text that fits memory has so many digits.
inline constexpr std::int64_t exponent_limit = std::int64_t{1} << 60;

/// Reads e+5 and the like at p; returns p when no exponent stands there.
constexpr const char* scan_exponent(const char* p, const char* last, std::int64_t& exponent) noexcept {
  if (p == last || (*p != 'e' && *p != 'E')) return p;
  const char* q = p + 1;
  const bool negative = q != last && *q == '-';
  if (q != last && (*q == '-' || *q == '+')) ++q;
  if (q == last || !is_digit(*q)) return p;
  std::int64_t value = 0;
  for (; q != last && is_digit(*q); ++q)
    if (value < exponent_limit / 16) value = value * 10 + digit_value(*q);
  exponent = negative ? -value : value;
  return q;
}

/// Finds the first 19 significant digits of a text that has more digits than that.
constexpr void cut_mantissa(decimal_text& text) noexcept {
  text.mantissa = 0;
  for (const char* p = text.digits; p != text.digits_end; ++p) {
    if (*p == '.') continue;
    if (text.mantissa < 1'000'000'000'000'000'000u)
      text.mantissa = text.mantissa * 10 + digit_value(*p);
    else {
      ++text.exponent;
      text.cut = text.cut || *p != '0';
    }
  }
}

constexpr decimal_text scan_decimal(const char* first, const char* last) noexcept {
  decimal_text text{first};
  const char* p = first;
  text.negative = p != last && *p == '-';
  if (p != last && (*p == '-' || *p == '+')) ++p;
  text.digits = p;
  std::uint64_t mantissa = 0;  // wraps when there are more than 19 digits, and is not used then
  while (p != last && is_digit(*p)) mantissa = mantissa * 10 + digit_value(*p++);
  std::int64_t count = p - text.digits, fraction = 0;
  if (p != last && *p == '.') {
    const char* const after_point = ++p;
    while (p != last && is_digit(*p)) mantissa = mantissa * 10 + digit_value(*p++);
    fraction = p - after_point;
    count += fraction;
  }
  if (count == 0) return text;
  text.digits_end = p;
  text.mantissa = mantissa;
  text.end = scan_exponent(p, last, text.exponent);
  text.exponent -= fraction;
  if (count > 19) cut_mantissa(text);
  return text;
}

/// The T nearest to significand * 2^exponent, ties to even; infinity beyond the largest.
/// needs   significand > 0; inexact: the true value is a little larger, by less than the significand's last bit, and
///         the significand has more bits than T by two or more
template <Floating T>
constexpr T nearest(std::uint64_t significand, int exponent, bool inexact) noexcept {
  using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  constexpr int precision = std::numeric_limits<T>::digits;
  constexpr int lowest = std::numeric_limits<T>::min_exponent - precision;  // of the last bit of subnormals
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
  return std::bit_cast<T>(static_cast<bits>((static_cast<std::uint64_t>(exponent - lowest) << (precision - 1)) + kept));
}

inline constexpr double powers_of_ten[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// By one operation on exact doubles.
/// needs   mantissa <= 2^53, abs(exponent) <= 22
/// gives   whether `value` is the nearest T; a float is refused where the double's own rounding may have decided
template <Floating T>
constexpr bool nearest_by_double(std::uint64_t mantissa, int exponent, T& value) noexcept {
  const double m = static_cast<double>(mantissa);
  const double d = exponent < 0 ? m / powers_of_ten[-exponent] : m * powers_of_ten[exponent];
  value = static_cast<T>(d);
  if constexpr (sizeof(T) == 4) {
    // d lies between 1e-22 and 1e38, where floats are normal. Its low 29 bits are what the second rounding cuts off.
    return (std::bit_cast<std::uint64_t>(d) & 0x1fffffffu) != 0x10000000u;
  }
  return true;
}

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 uint128;

/// By one operation on 128-bit integers.
/// needs   mantissa > 0, abs(exponent) <= 27
template <Floating T>
constexpr T nearest_by_128_bits(std::uint64_t mantissa, int exponent) noexcept {
  const int zeros = std::countl_zero(mantissa);
  const std::uint64_t m = mantissa << zeros;
  if (exponent >= 0) {
    const uint128 p = uint128{m} * powers_of_five[exponent];
    const std::uint64_t high = static_cast<std::uint64_t>(p >> 64), low = static_cast<std::uint64_t>(p);
    if (high == 0) return nearest<T>(low, exponent - zeros, false);
    const int room = std::countl_zero(high);
    const std::uint64_t top = static_cast<std::uint64_t>((p << room) >> 64);
    return nearest<T>(top, exponent - zeros + 64 - room, (low << room) != 0);
  }
  const std::uint64_t power = powers_of_five[-exponent];
  const int power_zeros = std::countl_zero(power);
  const uint128 numerator = uint128{m} << 63;
  const std::uint64_t denominator = power << power_zeros;  // 2^63 or more: the quotient has 63 or 64 bits
  const std::uint64_t q = static_cast<std::uint64_t>(numerator / denominator);
  return nearest<T>(q, exponent + power_zeros - zeros - 63, numerator != uint128{q} * denominator);
}
#endif

/// The significant digits of a text as a natural, and their number; 801 when there are more than 800. A number halfway
/// between two doubles has at most 768 of them, so all that must be known of digits beyond the 800th is whether one of
/// them is not 0: a 1 in the 801st place says so.
constexpr int load_digits(const decimal_text& text, natural& a) noexcept {
  int count = 0;
  std::uint32_t chunk = 0, chunk_power = 1;
  for (const char* p = text.digits; p != text.digits_end && count <= 800; ++p) {
    if (*p == '.' || (count == 0 && *p == '0')) continue;
    if (count == 800 && *p == '0') continue;
    chunk = chunk * 10 + (count == 800 ? 1 : digit_value(*p));
    chunk_power *= 10;
    ++count;
    if (chunk_power == 1'000'000'000u) {
      a.multiply_add(chunk_power, chunk);
      chunk = 0;
      chunk_power = 1;
    }
  }
  a.multiply_add(chunk_power, chunk);
  return count;
}

/// By naturals: right for every text.
/// needs   mantissa > 0, -345 <= exponent <= 310
template <Floating T>
constexpr T nearest_by_naturals(const decimal_text& text) noexcept {
  natural a;
  std::int64_t exponent = text.exponent;
  if (text.cut)
    exponent -= load_digits(text, a) - 19;  // the mantissa's exponent belongs to the 19th digit
  else
    a = natural::from(text.mantissa);
  natural b = natural::from(1);
  int binary = static_cast<int>(exponent);  // value = a / b * 2^binary from here on
  if (binary >= 0)
    a.multiply_power_of_five(binary);
  else
    b.multiply_power_of_five(-binary);
  const int spare = a.bit_length() - b.bit_length() - 63;
  const int b_shift = spare > 0 ? spare : 0, a_shift = spare > 0 ? 0 : -spare;
  const int align = (32 - (b.bit_length() + b_shift) % 32) % 32;
  b.shift_left(b_shift + align);
  a.shift_left(a_shift + align);
  const natural_quotient q = divide(a, b);
  return nearest<T>(q.value, binary + b_shift - a_shift, q.inexact);
}

template <Floating T>
constexpr T magnitude(const decimal_text& text) noexcept {
  if (text.mantissa == 0 || text.exponent < -345) return T{0};
  if (text.exponent > 310) return std::numeric_limits<T>::infinity();
  if (!text.cut) {
    const int exponent = static_cast<int>(text.exponent);
    T value{};
    if (text.mantissa <= std::uint64_t{1} << 53 && exponent >= -22 && exponent <= 22 &&
        nearest_by_double(text.mantissa, exponent, value))
      return value;
#ifdef __SIZEOF_INT128__
    if (exponent >= -27 && exponent <= 27) return nearest_by_128_bits<T>(text.mantissa, exponent);
#endif
  }
  return nearest_by_naturals<T>(text);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The number nearest to the decimal text at the head of [first, last).
/// shape   [+-] digits [. digits] [e [+-] digits], a digit before or after the point; blanks, nan, inf and hexadecimal
///         numbers are no part of it. The longest such text is read: of "1e" it is "1"
/// gives   none, and end == first, when no such text stands there; overflow with an infinite value; underflow with a
///         zero of the text's sign
/// exact   correctly rounded to T, ties to even, for any number of digits
/// cost    a few ns for up to 19 digits and exponents within 27; about a microsecond otherwise; linear in the digits
/// source  Clinger 1990, How to Read Floating Point Numbers Accurately (the first way)
template <Floating T>
constexpr decimal_result<T> parse_decimal(const char* first, const char* last) noexcept {
  const detail::decimal_text text = detail::scan_decimal(first, last);
  if (text.digits_end == nullptr) return {T{0}, first, decimal_status::none};
  const T value = detail::magnitude<T>(text);
  decimal_status status = decimal_status::ok;
  if (value > (std::numeric_limits<T>::max)()) status = decimal_status::overflow;
  if (value == T{0} && text.mantissa != 0) status = decimal_status::underflow;
  return {text.negative ? -value : value, text.end, status};
}

/// The integer that the decimal digits at the head of [first, last) write.
/// shape   [+-] digits; a minus sign only where I is signed
/// gives   none, and end == first, when no digits stand there; overflow with the nearest I when it does not fit
/// exact   always
template <std::integral I>
constexpr decimal_result<I> parse_integer(const char* first, const char* last) noexcept {
  const char* p = first;
  const bool negative = std::is_signed_v<I> && p != last && *p == '-';
  if (negative || (p != last && *p == '+')) ++p;
  if (p == last || !detail::is_digit(*p)) return {I{0}, first, decimal_status::none};
  constexpr std::uint64_t max = static_cast<std::uint64_t>((std::numeric_limits<I>::max)());
  const std::uint64_t limit = negative ? max + 1 : max;
  std::uint64_t value = 0;
  bool fits = true;
  for (; p != last && detail::is_digit(*p); ++p) {
    const unsigned digit = detail::digit_value(*p);
    fits = fits && value <= (limit - digit) / 10;
    if (fits) value = value * 10 + digit;
  }
  if (!fits) value = limit;
  // Through the unsigned type, where -2^63 has no overflow.
  return {static_cast<I>(negative ? 0 - value : value), p, fits ? decimal_status::ok : decimal_status::overflow};
}

}  // namespace IRG_ABI
}  // namespace irg
