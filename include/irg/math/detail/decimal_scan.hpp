// SPDX-License-Identifier: MIT
// A decimal text taken apart into digits and exponent, eight digits at a time where there are so many.
#pragma once

#include <cstdint>

#include <irg/math/detail/digits_kernel.hpp>
#include <irg/math/detail/natural.hpp>

namespace irg::detail {

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

inline namespace IRG_ABI {

constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
constexpr unsigned digit_value(char c) noexcept { return static_cast<unsigned>(c - '0'); }

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
  if (q == last || !is_digit(*q)) return p;
  std::int64_t value = 0;
  for (; q != last && is_digit(*q); ++q)
    if (value < exponent_limit / 16) value = value * 10 + digit_value(*q);
  exponent = negative ? -value : value;
  return q;
}

/// The digits at p, appended to the mantissa, which wraps when there are too many; returns their end.
constexpr const char* scan_digits(const char* p, const char* last, std::uint64_t& mantissa) noexcept {
  for (; p != last && is_digit(*p); ++p) mantissa = mantissa * 10 + digit_value(*p);
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
    if (*p != '.') mantissa = mantissa * 10 + digit_value(*p);
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

}  // namespace IRG_ABI
}  // namespace irg::detail
