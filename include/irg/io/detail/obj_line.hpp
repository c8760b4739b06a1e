// SPDX-License-Identifier: MIT
// A line of an OBJ text taken apart at a go: where its digits end is found for all bytes together, so that no number
// waits for the end of the one before it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <irg/io/detail/text_place.hpp>
#include <irg/math/decimal.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// The words of one line: numbers with one blank or more between them.
struct obj_line {
  static constexpr int window = 64;  // longer lines are read with care
  static constexpr std::ptrdiff_t readable = window + 16;  // so many bytes from its beginning on

  const char* text;
  std::uint64_t others;  // where no digits stand, from `at` on, one bit a byte
  int at;                // how much has been read

  /// needs   `readable` bytes
  IRG_INLINE constexpr explicit obj_line(const char* line) noexcept : text(line), others(~digit_bits(line)), at(0) {}

  /// Moves over a byte that is no digit.
  IRG_INLINE constexpr void pass() noexcept {
    ++at;
    others &= others - 1;
  }
  IRG_INLINE constexpr void skip_blanks() noexcept {
    while (text[at] == ' ' && at < window) pass();  // more of them are read with care
  }
  IRG_INLINE constexpr bool at_word_end() const noexcept { return text[at] == ' ' || is_line_break(text[at]); }

  /// Moves over digits; says how many, a negative number or too many for one where the window ends.
  IRG_INLINE constexpr int digits() noexcept {
    const int end = std::countr_zero(others), count = end - at;
    at = end;
    return count;
  }

  /// The line's end, of which CR LF is one, or null when something else stands here.
  IRG_INLINE constexpr const char* end() const noexcept {
    const char* const p = text + at;
    return *p == '\n' ? p + 1 : *p != '\r' ? nullptr : p[1] == '\n' ? p + 2 : p + 1;
  }

  template <Floating T>
  IRG_INLINE constexpr bool number(T& into) noexcept {
    const bool negative = text[at] == '-';
    others &= negative ? others - 1 : ~std::uint64_t{0};
    at += negative ? 1 : 0;
    const char* const first = text + at;
    const int whole = digits();
    if (static_cast<unsigned>(whole) > 8) return false;
    std::uint64_t mantissa = value_of_digits(first, whole);
    int fraction = 0;
    if (text[at] == '.') {
      pass();
      const char* const rest = text + at;
      fraction = digits();
      if (static_cast<unsigned>(fraction) > 16) return false;
      const int first_digits = fraction < 8 ? fraction : 8;
      mantissa = value_of_digits(rest, first_digits, mantissa);
      if (fraction > 8) mantissa = value_of_digits(rest + 8, fraction - 8, mantissa);
    }
    if (static_cast<unsigned>(whole + fraction - 1) > 18 || !at_word_end()) return false;
    const T magnitude = decimal_fraction<T>(mantissa, fraction);
    into = negative ? -magnitude : magnitude;
    return true;
  }

  /// An index from 1 on, less 1; `most` is the largest so far.
  IRG_INLINE constexpr bool index(std::uint32_t& into, std::uint32_t& most) noexcept {
    const char* const first = text + at;
    const int count = digits();
    if (static_cast<unsigned>(count - 1) > 7) return false;
    const auto n = static_cast<std::uint32_t>(value_of_digits(first, count));
    into = n - 1;
    most = most < n ? n : most;
    return n != 0;
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
