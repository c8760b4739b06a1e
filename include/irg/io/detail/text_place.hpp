// SPDX-License-Identifier: MIT
// What readers of text share: kinds of characters, and the place of an error as line and column.
#pragma once

#include <cstddef>
#include <string_view>

#include <irg/core/result.hpp>

namespace irg::detail::inline IRG_ABI {

constexpr bool is_line_break(char c) noexcept { return c == '\n' || c == '\r'; }
constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
constexpr bool is_letter(char c) noexcept { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The text behind the mark of UTF-8 that some editors put before it.
constexpr std::string_view without_byte_order_mark(std::string_view text) noexcept {
  return text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

/// The error for the byte at `place`: lines end with LF, CR or CR LF.
constexpr parse_error error_at(std::string_view text, const char* place, const char* message) noexcept {
  const char* line_start = text.data();
  std::size_t line = 1;
  for (const char* p = text.data(); p != place; ++p)
    if (*p == '\n' || (*p == '\r' && (p + 1 == place || p[1] != '\n'))) {
      ++line;
      line_start = p + 1;
    }
  return {line, static_cast<std::size_t>(place - line_start) + 1, message};
}

/// The error for a byte of a file that is no text.
constexpr parse_error error_at_byte(std::string_view bytes, const char* place, const char* message) noexcept {
  return {0, static_cast<std::size_t>(place - bytes.data()) + 1, message};
}

/// Why no finite number stands at p.
/// needs   p < last
constexpr const char* number_error(const char* p, const char* last) noexcept {
  if (last - p > 1 && (*p == '-' || *p == '+')) ++p;
  const bool infinite = last - p >= 3 && (*p | 0x20) == 'i' && (p[1] | 0x20) == 'n' && (p[2] | 0x20) == 'f';
  const bool nan = last - p >= 3 && (*p | 0x20) == 'n' && (p[1] | 0x20) == 'a' && (p[2] | 0x20) == 'n';
  return infinite || nan ? "number is not finite" : "expected a decimal number";
}

/// Whether two words are the same but for upper and lower case.
/// needs   `lower` has no capitals
constexpr bool is_word(std::string_view word, std::string_view lower) noexcept {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool capital = word[i] >= 'A' && word[i] <= 'Z';
    if ((capital ? static_cast<char>(word[i] - 'A' + 'a') : word[i]) != lower[i]) return false;
  }
  return true;
}

/// Whether the name ends so, in either case.
/// needs   `lower` has no capitals
constexpr bool has_ending(std::string_view name, std::string_view lower) noexcept {
  return name.size() >= lower.size() && is_word(name.substr(name.size() - lower.size()), lower);
}

}  // namespace irg::detail::inline IRG_ABI
