// SPDX-License-Identifier: MIT
// Decimal text to float, double and integers and back: correctly rounded one way, the fewest digits the other; without
// locale, memory or global state, the same in constant evaluation and at run time.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include <irg/core/lane_masks.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/decimal_digit.hpp>
#include <irg/math/detail/decimal_nearest.hpp>

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

  /// Whether the value is the nearest number.
  IRG_INLINE constexpr explicit operator bool() const noexcept { return status == decimal_status::ok; }
};

/// The length of the longest text that print_decimal writes.
template <Floating T>
inline constexpr int longest_decimal = sizeof(T) == 4 ? 15 : 24;

inline namespace IRG_COMPILED_ABI {

/// The number nearest to the decimal text at the head of [first, last).
/// shape   [+-] digits [. digits] [e [+-] digits], a digit before or after the point; blanks, nan, inf and hexadecimal
///         numbers are no part of it. The longest such text is read: of "1e" it is "1"
/// gives   none, and end == first, when no such text stands there; overflow with an infinite value; underflow with a
///         zero of the text's sign
/// exact   correctly rounded to T, ties to even, for any number of digits
/// cost    15 to 50 ns for up to 19 digits, 240 ns for 120 beside the middle of two doubles; linear in the digits
/// source  Lemire 2021 (the bounds); Clinger 1990 (the exact comparison)
template <Floating T>
[[nodiscard]] IRG_API decimal_result<T> parse_decimal(const char* first, const char* last) noexcept;

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Which of the 64 bytes at p are digits: one bit each, the first byte's the lowest.
/// exact   always
/// cost    3 ns
[[nodiscard]] IRG_INLINE constexpr std::uint64_t digit_bits(const char* p) noexcept;

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
  return unsigned_value<T>(text);
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
  if (p == last || !is_decimal_digit(*p)) return {J{0}, first, decimal_status::none};
  constexpr std::uint64_t max = static_cast<std::uint64_t>((std::numeric_limits<J>::max)());
  const std::uint64_t limit = negative ? max + 1 : max;
  std::uint64_t value = 0;
  bool fits = true;
  for (; p != last && is_decimal_digit(*p); ++p) {
    const unsigned digit = decimal_digit_value(*p);
    fits = fits && value <= (limit - digit) / 10;
    if (fits) value = value * 10 + digit;
  }
  if (!fits) value = limit;
  // Through the unsigned type, where -2^63 has no overflow.
  return {static_cast<J>(negative ? 0 - value : value), p, fits ? decimal_status::ok : decimal_status::overflow};
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// Writes the shortest decimal text that reads as `value` again: the end of that text.
/// shape   [-] digits [. digits] [e (+|-) digits], of the fewest digits that lead back, and of those the ones nearest
///         to the value. As 12300, 12.3, 0.0123 or 1.23e+45, whichever is shorter, without an exponent when equally
///         long; an exponent has two digits at least. Whole numbers without an exponent are written to their last
///         digit. -0 is "-0", infinities are "inf" and "-inf", NaN is "nan" whatever its sign
/// gives   nothing, and nothing written, when there is not enough room; longest_decimal<T> bytes always are
/// exact   parse_decimal<T> gives the same bits for every finite value
/// cost    20 to 80 ns
/// source  Giulietti 2020
template <Floating T>
IRG_API std::optional<char*> print_decimal(char* first, char* last, T value) noexcept;

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Writes an integer in decimal: the end of its text.
/// gives   nothing, and nothing written, when there is not enough room; 20 bytes always are
/// exact   always
template <std::integral J>
constexpr std::optional<char*> print_integer(char* first, char* last, J value) noexcept;

/// The same of a text in one piece.
template <class T>
  requires requires(const char* p) { irg::parse_decimal<T>(p, p); }
[[nodiscard]] constexpr decimal_result<T> parse_decimal(std::string_view text) noexcept {
  return irg::parse_decimal<T>(text.data(), text.data() + text.size());
}

/// The text that print_decimal writes to the head of `room`.
/// gives   an empty text, and nothing written, when there is not enough room
template <class T>
  requires requires(char* p, T value) { irg::print_decimal(p, p, value); }
constexpr std::string_view print_decimal(std::span<char> room, T value) noexcept {
  char* const first = room.data();
  const std::optional<char*> last = irg::print_decimal(first, first + room.size(), value);
  return {first, last ? static_cast<std::size_t>(*last - first) : 0};
}

}  // namespace IRG_ABI

namespace detail {

// The fewest decimal digits that lead back to a floating-point number, and their text.

/// digits * 10^exponent.
struct short_decimal {
  std::uint64_t digits;
  int exponent;
};

/// significand * 2^exponent, the significand with all of T's bits unless subnormal.
struct binary_parts {
  std::uint64_t significand;
  int exponent;
  bool lowest_of_binade;  // the neighbour below is nearer than the one above
};

inline namespace IRG_ABI {

struct ten_powers {
  std::uint64_t value[20]{1};
  constexpr ten_powers() noexcept {
    for (int i = 1; i < 20; ++i) value[i] = value[i - 1] * 10;
  }
};
inline constexpr ten_powers powers_of_ten{};

/// How many digits v has; 1 for 0.
constexpr int digit_count(std::uint64_t v) noexcept {
  const int guess = ((64 - std::countl_zero(v | 1)) * 1233) >> 12;  // or one more
  return guess + (v == 0 || v >= powers_of_ten.value[guess] ? 1 : 0);
}

inline constexpr char pairs_of_digits[] =
    "0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849"
    "5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899";

constexpr void write_pair(char* p, std::uint32_t v) noexcept {
  p[0] = pairs_of_digits[2 * v];
  p[1] = pairs_of_digits[2 * v + 1];
}

/// Writes the lowest `count` digits of v, which has no more, before `end`; returns where they begin.
constexpr char* write_digits(char* end, std::uint64_t v, int count) noexcept {
  for (; count >= 8; count -= 8) {
    const std::uint32_t eight = static_cast<std::uint32_t>(v % 100'000'000), high = eight / 10'000,
                        low = eight % 10'000;
    v /= 100'000'000;
    end -= 8;
    write_pair(end, high / 100);
    write_pair(end + 2, high % 100);
    write_pair(end + 4, low / 100);
    write_pair(end + 6, low % 100);
  }
  std::uint32_t rest = static_cast<std::uint32_t>(v);
  for (; count >= 2; count -= 2) {
    write_pair(end -= 2, rest % 100);
    rest /= 100;
  }
  if (count == 1) *--end = static_cast<char>('0' + rest % 10);
  return end;
}

IRG_INLINE std::uint64_t digit_bits_in_lanes(const char* p) noexcept {
  using bytes = pack<std::uint8_t, native_bytes>;
  // 70 more makes digits the largest numbers of 8 bits with a sign.
  const auto more = lanes<bytes>::broadcast(70);
  const auto largest = lanes<pack<std::int8_t, native_bytes>>::broadcast(117);
  const auto bits = [&](int i) IRG_INLINE_LAMBDA {
    return std::uint64_t{mask_bits(bits_as<std::int8_t>(lanes<bytes>::load_bytes(p + i) + more) > largest)} << i;
  };
  static_assert(native_bytes == 16 || native_bytes == 32);
  if constexpr (native_bytes == 32) return bits(0) | bits(32);
  return bits(0) | bits(16) | bits(32) | bits(48);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

[[nodiscard]] IRG_INLINE constexpr std::uint64_t digit_bits(const char* p) noexcept {
  if (!std::is_constant_evaluated()) return detail::digit_bits_in_lanes(p);
  std::uint64_t bits = 0;
  for (int i = 0; i < 64; ++i) bits |= std::uint64_t{p[i] >= '0' && p[i] <= '9' ? 1u : 0u} << i;
  return bits;
}

template <std::integral J>
constexpr std::optional<char*> print_integer(char* first, char* last, J value) noexcept {
  const bool negative = value < J{0};
  const std::uint64_t bits = static_cast<std::uint64_t>(value), magnitude = negative ? 0 - bits : bits;
  const int count = detail::digit_count(magnitude);
  if (last - first < count + (negative ? 1 : 0)) return std::nullopt;
  if (negative) *first++ = '-';
  detail::write_digits(first + count, magnitude, count);
  return first + count;
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

/// needs   value finite; its sign is left out
template <Floating T>
constexpr binary_parts binary_parts_of(T value) noexcept {
  constexpr int fraction_bits = std::numeric_limits<T>::digits - 1;
  const std::uint64_t bits = std::bit_cast<bits_of_decimal<T>>(value);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << fraction_bits) - 1);
  const int field = static_cast<int>(bits >> fraction_bits) & (2 * std::numeric_limits<T>::max_exponent - 1);
  if (field == 0) return {fraction, lowest_exponent<T>, false};
  return {fraction | (std::uint64_t{1} << fraction_bits), lowest_exponent<T> + field - 1, fraction == 0 && field > 1};
}

/// m times a power of ten over 2^128, rounded to odd: cut off, and the last bit set where something was cut off. So it
/// compares with even integers as the exact product does.
/// needs   `power` not cut off but rounded up; m < 2^60. An exact product that is no integer differs from integers by
///         2^-66 or more (scripts/generate/powers_of_five.py looks); one that is an integer is exceeded by less than m
constexpr std::uint64_t product_rounded_to_odd(std::uint64_t m, word_pair power) noexcept {
  const word_pair low = multiply_words(m, power.low);
  const word_pair high = multiply_words(m, power.high, low.high);
  return high.high | (high.low != 0 || low.low >= m ? 1u : 0u);
}

/// The decimal number of fewest digits among those that are nearer to a floating-point number than to its neighbours,
/// and of those the nearest. It may end in zeros.
/// needs   significand > 0
/// source  Giulietti 2020
constexpr short_decimal shortest_decimal(const binary_parts& v) noexcept {
  // Between the middles to both neighbours there are 1 to 10 multiples of 10^k, and 0 or 1 of 10^(k + 1).
  const int k = (v.exponent * 1262611 - (v.lowest_of_binade ? 524031 : 0)) >> 22;
  const int shift = v.exponent + floor_log2_of_power_of_ten(-k) + 1;
  word_pair power = power_of_five_to_128_bits(-k);
  if (!is_exact_to_128_bits(-k) && ++power.low == 0) ++power.high;
  // The number and the middles, in quarters of 10^k. A middle belongs to the number with the even significand.
  const std::uint64_t quarters = v.significand << 2, odd = v.significand & 1;
  const std::uint64_t low = product_rounded_to_odd((quarters - (v.lowest_of_binade ? 1 : 2)) << shift, power) + odd;
  const std::uint64_t here = product_rounded_to_odd(quarters << shift, power);
  const std::uint64_t high = product_rounded_to_odd((quarters + 2) << shift, power) - odd;
  const std::uint64_t s = here / 4, tens = s / 10;
  const bool tens_below = low <= 40 * tens, tens_above = 40 * tens + 40 <= high;
  if (tens_below != tens_above) return {tens + (tens_above ? 1 : 0), k + 1};
  const bool below = low <= 4 * s, above = 4 * s + 4 <= high;
  if (below != above) return {s + (above ? 1 : 0), k};
  const std::uint64_t half = 4 * s + 2;
  return {s + (here > half || (here == half && s % 2 == 1) ? 1 : 0), k};
}

/// The same number without zeros at its end. What is a multiple of 10^n, times the inverse of 5^n modulo 2^64 and
/// rotated right by n, is the quotient; for all other numbers this is more than any quotient.
/// needs   digits < 10^16, or the last one not 0
constexpr short_decimal without_zeros(short_decimal d) noexcept {
  const auto strip = [&d](std::uint64_t inverse_of_power_of_five, std::uint64_t power_of_ten, int n) {
    const std::uint64_t quotient = std::rotr(d.digits * inverse_of_power_of_five, n);
    if (quotient > ~std::uint64_t{0} / power_of_ten) return;
    d.digits = quotient;
    d.exponent += n;
  };
  if (d.digits % 2 != 0) return d;
  constexpr std::uint64_t i1 = 0xcccccccccccccccdu, i2 = i1 * i1, i4 = i2 * i2, i8 = i4 * i4;
  strip(i8, 100'000'000, 8);
  strip(i4, 10'000, 4);
  strip(i2, 100, 2);
  strip(i1, 10, 1);
  return d;
}

/// The fewest digits of a floating-point number, the last one not 0.
/// needs   significand > 0
constexpr short_decimal shortest_digits(const binary_parts& v) noexcept {
  // A whole number below 2^53 (2^24) is its own: others that lead back to it have a fraction.
  if (v.exponent <= 0 && v.exponent > -64 && std::countr_zero(v.significand) >= -v.exponent)
    return without_zeros({v.significand >> -v.exponent, 0});
  return without_zeros(shortest_decimal(v));
}

/// A whole number of `count` digits and `d.exponent` places behind them, to its last digit, which the shortest decimal
/// number leaves open beyond 2^53 (2^24).
/// needs   d.exponent >= 0, and 10^d.exponent a 64-bit number
constexpr char* write_whole(char* p, const binary_parts& v, const short_decimal& d, int count) noexcept {
  const std::uint64_t power = powers_of_ten.value[d.exponent];
  // Modulo 2^64, where the difference, less than one unit of d's last place, is right.
  const std::uint64_t exact = v.exponent > 0 ? v.significand << v.exponent : v.significand >> -v.exponent;
  std::uint64_t rest = exact - d.digits * power, head = d.digits;
  if (rest >> 63 != 0) {
    --head;
    rest += power;
  }
  write_digits(p + count, head, count);
  write_digits(p + count + d.exponent, rest, d.exponent);
  return p + count + d.exponent;
}

/// As 12300, 12.3, 0.00123 or 1.23e+45, whichever is shortest; without an exponent when both are equally long.
/// needs   room for 23 bytes at p, v.significand > 0
constexpr char* write_shortest(char* p, const binary_parts& v) noexcept {
  const short_decimal d = shortest_digits(v);
  const int n = digit_count(d.digits), scale = n - 1 + d.exponent;  // of the first digit
  const int scale_digits = scale <= -100 || scale >= 100 ? 3 : 2;
  const int plain = d.exponent >= 0 ? n + d.exponent : scale >= 0 ? n + 1 : n + 1 - scale;
  if (plain <= n + (n > 1 ? 1 : 0) + 2 + scale_digits) {
    if (d.exponent >= 0) return write_whole(p, v, d, n);
    char* const digits = write_digits(p + plain, d.digits, n);
    char* const point = scale >= 0 ? p + scale + 1 : p + 1;
    for (char* q = p; q != digits; ++q) *q = '0';
    if (scale >= 0)
      for (char* q = p; q != point; ++q) *q = q[1];
    *point = '.';
    return p + plain;
  }
  write_digits(p + 1 + n, d.digits, n);
  *p = p[1];
  if (n > 1) p[1] = '.';
  p += n > 1 ? n + 1 : 1;
  *p++ = 'e';
  *p++ = scale < 0 ? '-' : '+';
  write_digits(p + scale_digits, static_cast<std::uint64_t>(scale < 0 ? -scale : scale), scale_digits);
  return p + scale_digits;
}

/// Any value's text.
/// needs   room for 24 bytes at p
template <Floating T>
constexpr char* write_value(char* p, T value) noexcept {
  const auto put = [&p](const char* text) {
    while (*text != 0) *p++ = *text++;
    return p;
  };
  if (value != value) return put("nan");
  if (std::bit_cast<bits_of_decimal<T>>(value) >> (8 * sizeof(T) - 1) != 0) *p++ = '-';
  constexpr T largest = (std::numeric_limits<T>::max)();
  if (value > largest || value < -largest) return put("inf");
  const binary_parts parts = binary_parts_of(value);
  return parts.significand == 0 ? put("0") : write_shortest(p, parts);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API decimal_result<T> parse_decimal(const char* first, const char* last) noexcept {
  const detail::decimal_text text = detail::scan_decimal(first, last);
  if (text.digits_end == nullptr) return {T{0}, first, decimal_status::none};
  using bits_type = detail::bits_of_decimal<T>;
  const bits_type bits = std::bit_cast<bits_type>(unsigned_value<T>(text));
  decimal_status status = decimal_status::ok;
  if (bits == std::bit_cast<bits_type>(std::numeric_limits<T>::infinity())) status = decimal_status::overflow;
  if (bits == 0 && text.mantissa != 0) status = decimal_status::underflow;
  const bits_type sign = static_cast<bits_type>(text.negative ? 1 : 0) << (8 * sizeof(T) - 1);
  return {std::bit_cast<T>(bits | sign), text.end, status};
}

template <Floating T>
IRG_API std::optional<char*> print_decimal(char* first, char* last, T value) noexcept {
  if (last - first >= longest_decimal<T>) return detail::write_value(first, value);
  char text[longest_decimal<T>] = {};
  char* const end = detail::write_value(text, value);
  if (end - text > last - first) return std::nullopt;
  for (const char* p = text; p != end; ++p) *first++ = *p;
  return first;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
