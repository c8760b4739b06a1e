// SPDX-License-Identifier: MIT
// A place in a text of words and numbers, which moves on as they are read and stays where one is wrong.
#pragma once

#include <cstdint>
#include <string_view>

#include <irg/io/detail/text_place.hpp>
#include <irg/math/decimal.hpp>

namespace irg::detail::inline IRG_ABI {

/// The text from `at` on. What returns bool says whether it went well; `place` and `message` tell why when it did not.
struct text_cursor {
  const char* at = nullptr;
  const char* last = nullptr;
  char comment = '\0';  // what begins a comment to the end of its line; none when 0
  const char* place = nullptr;
  const char* message = nullptr;

  constexpr text_cursor(std::string_view text, char comment_begin) noexcept
      : at(text.data()), last(text.data() + text.size()), comment(comment_begin) {}

  constexpr bool fail(const char* where, const char* why) noexcept {
    place = where;
    message = why;
    return false;
  }

  constexpr bool at_end() const noexcept { return at == last; }
  constexpr bool at_comment() const noexcept { return at != last && comment != '\0' && *at == comment; }
  constexpr bool at_word_end() const noexcept {
    return at == last || is_blank(*at) || is_line_break(*at) || at_comment();
  }

  constexpr void skip_to_line_end() noexcept {
    while (at != last && !is_line_break(*at)) ++at;
  }
  /// Moves behind the end of the line; CR LF is one.
  constexpr void skip_line() noexcept {
    skip_to_line_end();
    if (at == last) return;
    const bool pair = *at == '\r' && last - at > 1 && at[1] == '\n';
    at += pair ? 2 : 1;
  }
  /// Over blanks, not over the end of the line; says whether something follows there.
  constexpr bool skip_blanks() noexcept {
    while (at != last && is_blank(*at)) ++at;
    return at != last && !is_line_break(*at) && !at_comment();
  }
  /// Over blanks, ends of lines and comments; says whether something follows.
  constexpr bool skip_space() noexcept {
    for (; at != last; ++at) {
      if (at_comment()) skip_to_line_end();
      if (at == last) return false;
      if (!is_blank(*at) && !is_line_break(*at)) return true;
    }
    return false;
  }

  /// The word that begins here, which may be empty.
  constexpr std::string_view word() noexcept {
    const char* const start = at;
    while (!at_word_end()) ++at;
    return {start, static_cast<std::size_t>(at - start)};
  }
  /// The next word of this line; empty when there is none.
  constexpr std::string_view word_in_line() noexcept { return skip_blanks() ? word() : std::string_view{}; }

  /// The rest of the line without the blanks around it.
  constexpr std::string_view rest_of_line() noexcept {
    while (at != last && is_blank(*at)) ++at;
    const char* const start = at;
    skip_to_line_end();
    const char* end = at;
    while (end != start && is_blank(end[-1])) --end;
    return {start, static_cast<std::size_t>(end - start)};
  }

  /// The number that stands here as a word of its own, finite.
  /// needs   something stands here
  template <Floating T>
  constexpr bool number_here(T& into) noexcept {
    const char* const start = at;
    const decimal_result<T> number = parse_decimal<T>(at, last);
    at = number.end;
    if (number.status == decimal_status::none || !at_word_end()) return fail(start, number_error(start, last));
    if (number.status == decimal_status::overflow) return fail(start, "number is too large");
    into = number.value;
    return true;
  }
  /// The next number, finite, wherever it stands.
  template <Floating T>
  constexpr bool number(T& into) noexcept {
    if (!skip_space()) return fail(at, "text ends where a number is expected");
    return number_here(into);
  }
  /// The next whole number, wherever it stands; numbers that are too large are the largest.
  constexpr bool integer(std::int64_t& into) noexcept {
    if (!skip_space()) return fail(at, "text ends where a whole number is expected");
    const char* const start = at;
    const decimal_result<std::int64_t> number = parse_integer<std::int64_t>(at, last);
    at = number.end;
    if (number.status == decimal_status::none || !at_word_end()) return fail(start, "expected a whole number");
    into = number.value;
    return true;
  }
};

}  // namespace irg::detail::inline IRG_ABI
