// SPDX-License-Identifier: MIT
// Words and numbers appended to the bytes of a file; numbers with the fewest digits that lead back to them.
#pragma once

#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include <irg/math/decimal.hpp>

namespace irg::detail::inline IRG_ABI {

template <class Bytes>
constexpr void append_text(Bytes& out, std::string_view text) {
  for (const char c : text) out.push_back(static_cast<typename Bytes::value_type>(c));
}

template <class Bytes, Floating T>
constexpr void append_number(Bytes& out, T x) {
  char text[longest_decimal<T>] = {};
  append_text(out, {text, static_cast<std::size_t>(*print_decimal(text, text + sizeof text, x) - text)});
}
template <class Bytes, std::integral J>
constexpr void append_number(Bytes& out, J n) {
  char text[20] = {};
  append_text(out, {text, static_cast<std::size_t>(*print_integer(text, text + sizeof text, n) - text)});
}

/// Appends texts and numbers, one after the other.
template <class Bytes, class... Parts>
constexpr void append_all(Bytes& out, const Parts&... parts) {
  const auto append_one = [&out](const auto& part) {
    if constexpr (std::is_convertible_v<decltype(part), std::string_view>)
      append_text(out, part);
    else
      append_number(out, part);
  };
  (append_one(parts), ...);
}

/// Appends numbers, a blank before each that does not begin a line.
template <class Bytes, class Vector>
constexpr void append_numbers(Bytes& out, const Vector& v, int count) {
  for (int i = 0; i < count; ++i) {
    if (!out.empty() && out.back() != '\n') out.push_back(' ');
    append_number(out, v[i]);
  }
}

/// Appends a name as the rest of a line: line breaks and zeros in it become blanks.
template <class Bytes, class Name>
constexpr void append_line_of(Bytes& out, const Name& name) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name.data()[i];
    out.push_back(static_cast<typename Bytes::value_type>(c == '\n' || c == '\r' || c == '\0' ? ' ' : c));
  }
}

}  // namespace irg::detail::inline IRG_ABI
