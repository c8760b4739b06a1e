// SPDX-License-Identifier: MIT
// UTF-8 as XML allows it: no byte that belongs to none of its characters, no control character but tab and line ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <irg/core/config.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// Whether XML 1.0 has the character of this number.
constexpr bool is_xml_character(std::uint32_t c) noexcept {
  if (c < 0x20) return c == '\t' || c == '\n' || c == '\r';
  return c < 0xd800 || (c >= 0xe000 && c < 0xfffe) || (c >= 0x10000 && c < 0x110000);
}

/// The length of the character at the head of the text; 0 when no character of XML stands there in its shortest form.
constexpr std::size_t length_of_character(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned head = byte(0);
  if (head < 0x80) return is_xml_character(head) ? 1 : 0;
  const std::size_t length = head < 0xc2 ? 0 : head < 0xe0 ? 2 : head < 0xf0 ? 3 : head < 0xf5 ? 4 : 0;
  if (length == 0 || text.size() < length) return 0;
  std::uint32_t c = head & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    c = c << 6 | (byte(i) & 0x3fu);
  }
  const std::uint32_t least = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
  return c >= least && is_xml_character(c) ? length : 0;
}

/// Where the first byte stands that is no part of a character; the text's size when there is none.
constexpr std::size_t first_bad_byte(std::string_view text) noexcept {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of_character(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return text.size();
}

/// Appends a character.
/// needs   is_xml_character(c)
template <class Text>
constexpr void append_character(Text& out, std::uint32_t c) {
  const auto put = [&](std::uint32_t byte) { out.push_back(static_cast<char>(static_cast<unsigned char>(byte))); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xc0 | c >> 6);
  } else {
    if (c < 0x10000) {
      put(0xe0 | c >> 12);
    } else {
      put(0xf0 | c >> 18);
      put(0x80 | (c >> 12 & 0x3f));
    }
    put(0x80 | (c >> 6 & 0x3f));
  }
  put(0x80 | (c & 0x3f));
}

}  // namespace IRG_ABI
}  // namespace irg::detail
