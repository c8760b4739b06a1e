// SPDX-License-Identifier: MIT
// Decimal text to float, double and integers and back: correctly rounded one way, the fewest digits the other; without
// locale, memory or global state, the same in constant evaluation and at run time.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

#include <irg/core/scalar.hpp>
#include <irg/math/detail/decimal_nearest.hpp>
#include <irg/math/detail/decimal_shortest.hpp>

namespace irg {

/// What became of a decimal text.
enum class [[nodiscard]] decimal_status {
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

/// The length of the longest text that print_decimal writes.
template <Floating T>
inline constexpr int longest_decimal = sizeof(T) == 4 ? 15 : 24;

inline namespace IRG_ABI {

/// The number nearest to the decimal text at the head of [first, last).
/// shape   [+-] digits [. digits] [e [+-] digits], a digit before or after the point; blanks, nan, inf and hexadecimal
///         numbers are no part of it. The longest such text is read: of "1e" it is "1"
/// gives   none, and end == first, when no such text stands there; overflow with an infinite value; underflow with a
///         zero of the text's sign
/// exact   correctly rounded to T, ties to even, for any number of digits
/// cost    15 to 50 ns for up to 19 digits, 240 ns for 120 beside the middle of two doubles; linear in the digits
/// source  Lemire 2021 (the bounds); Clinger 1990 (the exact comparison)
template <Floating T>
[[nodiscard]] constexpr decimal_result<T> parse_decimal(const char* first, const char* last) noexcept {
  const detail::decimal_text text = detail::scan_decimal(first, last);
  if (text.digits_end == nullptr) return {T{0}, first, decimal_status::none};
  using bits_type = detail::bits_of_decimal<T>;
  const bits_type bits = std::bit_cast<bits_type>(detail::magnitude<T>(text));
  decimal_status status = decimal_status::ok;
  if (bits == std::bit_cast<bits_type>(std::numeric_limits<T>::infinity())) status = decimal_status::overflow;
  if (bits == 0 && text.mantissa != 0) status = decimal_status::underflow;
  const bits_type sign = static_cast<bits_type>(text.negative ? 1 : 0) << (8 * sizeof(T) - 1);
  return {std::bit_cast<T>(bits | sign), text.end, status};
}

/// Which of the 64 bytes at p are digits: one bit each, the first byte's the lowest.
/// exact   always
/// cost    3 ns
[[nodiscard]] IRG_INLINE constexpr std::uint64_t digit_bits(const char* p) noexcept { return detail::digit_bits_of(p); }

/// The number that the digits of `before` and so many more at p write.
/// needs   0 <= count <= 8, and 8 bytes that may be read at p, whatever follows the digits; a number below 2^64
/// exact   always
/// cost    2 ns, the same for any count
[[nodiscard]] IRG_INLINE constexpr std::uint64_t value_of_digits(const char* p, int count,
                                                                 std::uint64_t before = 0) noexcept {
  const std::uint64_t values = detail::load_eight(p) ^ 0x3030303030303030u;
  if (count == 0) return before;
  return before * detail::small_powers_of_ten[count] + detail::value_of_values(values << ((64 - 8 * count) & 63));
}

/// mantissa / 10^decimals: what a text of so many digits behind the point writes.
/// needs   mantissa < 10^19, 0 <= decimals <= 19
/// exact   correctly rounded to T, ties to even, as parse_decimal
/// cost    3 ns, 12 beyond 2^53
/// source  Clinger 1990 (by one operation on exact numbers)
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T decimal_fraction(std::uint64_t mantissa, int decimals) noexcept {
  T value{};
  if (mantissa <= std::uint64_t{1} << 53 && detail::nearest_by_double(mantissa, -decimals, value)) return value;
  detail::decimal_text text{nullptr};
  text.mantissa = mantissa;
  text.exponent = -decimals;
  return detail::magnitude<T>(text);
}

/// The integer that the decimal digits at the head of [first, last) write.
/// shape   [+-] digits; a minus sign only where J is signed
/// gives   none, and end == first, when no digits stand there; overflow with the nearest J when it does not fit
/// exact   always
template <std::integral J>
[[nodiscard]] constexpr decimal_result<J> parse_integer(const char* first, const char* last) noexcept {
  const char* p = first;
  const bool negative = std::is_signed_v<J> && p != last && *p == '-';
  if (negative || (p != last && *p == '+')) ++p;
  if (p == last || !detail::is_digit(*p)) return {J{0}, first, decimal_status::none};
  constexpr std::uint64_t max = static_cast<std::uint64_t>((std::numeric_limits<J>::max)());
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
  return {static_cast<J>(negative ? 0 - value : value), p, fits ? decimal_status::ok : decimal_status::overflow};
}

/// Writes the shortest decimal text that reads as `value` again; returns its end.
/// shape   [-] digits [. digits] [e (+|-) digits], of the fewest digits that lead back, and of those the ones nearest
///         to the value. As 12300, 12.3, 0.0123 or 1.23e+45, whichever is shorter, without an exponent when equally
///         long; an exponent has two digits at least. Whole numbers without an exponent are written to their last
///         digit. -0 is "-0", infinities are "inf" and "-inf", NaN is "nan" whatever its sign
/// gives   first, and nothing written, when there is not enough room; longest_decimal<T> bytes always are
/// exact   parse_decimal<T> gives the same bits for every finite value
/// cost    20 to 80 ns
/// source  Giulietti 2020
template <Floating T>
constexpr char* print_decimal(char* first, char* last, T value) noexcept {
  if (last - first >= longest_decimal<T>) return detail::write_value(first, value);
  char text[longest_decimal<T>] = {};
  char* const end = detail::write_value(text, value);
  if (end - text > last - first) return first;
  for (const char* p = text; p != end; ++p) *first++ = *p;
  return first;
}

/// Writes an integer in decimal; returns the end of its text.
/// gives   first, and nothing written, when there is not enough room; 20 bytes always are
/// exact   always
template <std::integral J>
constexpr char* print_integer(char* first, char* last, J value) noexcept {
  const bool negative = value < J{0};
  const std::uint64_t bits = static_cast<std::uint64_t>(value), magnitude = negative ? 0 - bits : bits;
  const int count = detail::digit_count(magnitude);
  if (last - first < count + (negative ? 1 : 0)) return first;
  if (negative) *first++ = '-';
  detail::write_digits(first + count, magnitude, count);
  return first + count;
}

/// The same of a text in one piece.
template <class T>
  requires requires(const char* p) { parse_decimal<T>(p, p); }
[[nodiscard]] constexpr decimal_result<T> parse_decimal(std::string_view text) noexcept {
  return parse_decimal<T>(text.data(), text.data() + text.size());
}

/// The text that print_decimal writes to the head of `room`.
/// gives   an empty text, and nothing written, when there is not enough room
template <class T>
  requires requires(char* p, T value) { print_decimal(p, p, value); }
constexpr std::string_view print_decimal(std::span<char> room, T value) noexcept {
  char* const first = room.data();
  return {first, static_cast<std::size_t>(print_decimal(first, first + room.size(), value) - first)};
}

}  // namespace IRG_ABI
}  // namespace irg
