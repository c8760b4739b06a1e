// SPDX-License-Identifier: MIT
// XML taken apart into elements and their attributes, one after another, for formats that keep everything in
// attributes.
//
// Nothing is expanded: documents with a type declaration, entities of their own or text between elements are refused,
// and nothing is kept but the names of the elements that are open, of which there may be so many and no more. Text that
// nobody is to read can be passed over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <irg/core/config.hpp>
#include <irg/io/detail/text_cursor.hpp>
#include <irg/math/decimal_digit.hpp>
#include <irg/mesh/part_name.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// UTF-8 as XML allows it: no byte that belongs to none of its characters, no control character but tab and line ends.

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

/// An attribute as it stands in the text, references in its value unresolved.
struct xml_attribute {
  std::string_view name, value;
};

enum class xml_event { begin, end, done, error };

inline namespace IRG_ABI {

inline constexpr std::size_t xml_depth = 32, xml_attributes = 32;

constexpr bool begins_xml_name(char c) noexcept {
  return is_letter(c) || c == '_' || c == ':' || static_cast<unsigned char>(c) >= 0x80;
}
constexpr bool continues_xml_name(char c) noexcept {
  return begins_xml_name(c) || is_decimal_digit(c) || c == '-' || c == '.';
}

/// The character that a reference behind & stands for, and where the text goes on; 0 when it is none that is read: the
/// five names of XML and numbers.
struct xml_reference {
  std::uint32_t character = 0;
  std::size_t length = 0;  // without the &, with the ;
};
constexpr xml_reference reference_at(std::string_view text) noexcept {
  constexpr struct {
    std::string_view name;
    char character;
  } known[] = {{"amp;", '&'}, {"lt;", '<'}, {"gt;", '>'}, {"quot;", '"'}, {"apos;", '\''}};
  for (const auto& k : known)
    if (text.starts_with(k.name)) return {static_cast<unsigned char>(k.character), k.name.size()};
  if (!text.starts_with("#")) return {};
  const bool hexadecimal = text.starts_with("#x");
  std::size_t at = hexadecimal ? 2 : 1;
  const std::size_t first = at;
  std::uint32_t c = 0;
  for (; at < text.size() && c < 0x110000; ++at) {
    const char d = text[at], lower = static_cast<char>(d | 0x20);
    if (is_decimal_digit(d))
      c = c * (hexadecimal ? 16 : 10) + decimal_digit_value(d);
    else if (hexadecimal && lower >= 'a' && lower <= 'f')
      c = c * 16 + 10 + static_cast<std::uint32_t>(lower - 'a');
    else
      break;
  }
  if (at == first || at == text.size() || text[at] != ';' || !is_xml_character(c)) return {};
  return {c, at + 1};
}

/// The value of an attribute with its references resolved, a blank for each line break, of which CR LF is one, and tab.
constexpr part_name resolved_value(std::string_view value) {
  part_name out;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const char c = value[i];
    if (c == '&') {
      const xml_reference r = reference_at(value.substr(i + 1));
      append_character(out, r.character);
      i += r.length;
    } else if (c != '\r' || !value.substr(i + 1).starts_with('\n')) {
      out.push_back(is_line_break(c) || c == '\t' ? ' ' : c);
    }
  }
  return out;
}

/// Goes through a text element by element.
struct xml_reader {
  text_cursor cursor;
  std::array<xml_attribute, xml_attributes> attributes{};
  std::size_t attribute_count = 0;
  std::string_view name{};  // of the element that began or ended last
  std::size_t depth = 0;
  bool passes_over_text = false;  // and character data; otherwise they are errors

  /// needs   a text without bad bytes (first_bad_byte)
  constexpr explicit xml_reader(std::string_view text) noexcept : cursor(text, '\0') {}

  constexpr xml_event next() noexcept {
    if (is_empty_) {
      is_empty_ = false;
      return close();
    }
    for (bool first = !has_begun_;; first = false) {
      has_begun_ = true;
      if (!cursor.skip_space()) return finish();
      const char* const start = cursor.at;
      if (*start != '<') {
        if (!passes_over_text) return wrong(start, "text stands where only elements may stand");
        if (!text()) return xml_event::error;
        continue;
      }
      const char second = cursor.last - start > 1 ? start[1] : '\0';
      if (second != '?' && second != '!') return second == '/' ? end_tag(start) : begin_tag(start);
      if (take("<?")) {
        if (!instruction(first && start == first_)) return xml_event::error;
      } else if (take("<!--")) {
        if (!comment()) return xml_event::error;
      } else if (!passes_over_text || !take("<![CDATA[")) {
        return wrong(start, "document types, entities and character data are not read");
      } else if (!character_data()) {
        return xml_event::error;
      }
    }
  }

  /// The value of the attribute of that name; data() is null when there is none.
  constexpr std::string_view attribute(std::string_view wanted) const noexcept {
    for (std::size_t i = 0; i < attribute_count; ++i)
      if (attributes[i].name == wanted) return attributes[i].value;
    return {};
  }

private:
  constexpr xml_event wrong(const char* place, const char* message) noexcept {
    cursor.fail(place, message);
    return xml_event::error;
  }
  constexpr bool take(std::string_view mark) noexcept {
    if (!std::string_view(cursor.at, static_cast<std::size_t>(cursor.last - cursor.at)).starts_with(mark)) return false;
    cursor.at += mark.size();
    return true;
  }
  constexpr std::string_view rest() const noexcept {
    return {cursor.at, static_cast<std::size_t>(cursor.last - cursor.at)};
  }

  constexpr xml_event finish() noexcept {
    if (depth != 0) return wrong(cursor.at, "text ends before its elements do");
    return has_root_ ? xml_event::done : wrong(cursor.at, "text has no element");
  }
  constexpr xml_event close() noexcept {
    name = open_[--depth];
    return xml_event::end;
  }

  /// Up to the next tag.
  constexpr bool text() noexcept {
    for (; !cursor.at_end() && *cursor.at != '<'; ++cursor.at) {
      if (*cursor.at == '&' && reference_at(rest().substr(1)).length == 0)
        return cursor.fail(cursor.at, "entity is none of the five that are read");
      if (*cursor.at == ']' && rest().starts_with("]]>"))
        return cursor.fail(cursor.at, "end of character data stands in text");
    }
    return true;
  }
  constexpr bool character_data() noexcept {
    const std::size_t end = rest().find("]]>");
    if (end == std::string_view::npos) return cursor.fail(cursor.last, "character data do not end");
    cursor.at += end + 3;
    return true;
  }

  constexpr bool comment() noexcept {
    const std::size_t dashes = rest().find("--");
    if (dashes == std::string_view::npos) return cursor.fail(cursor.last, "comment does not end");
    cursor.at += dashes + 2;
    return take(">") || cursor.fail(cursor.at - 2, "two dashes stand within a comment");
  }

  /// The declaration at the head of the text, or something meant for another program, which is passed over.
  constexpr bool instruction(bool at_head) noexcept {
    const char* const start = cursor.at;
    const std::string_view target = word_of_name();
    if (target.empty()) return cursor.fail(start, "expected a name");
    if (is_word(target, "xml")) return at_head ? declaration() : cursor.fail(start, "declaration is not at the head");
    if (!cursor.at_word_end() && !rest().starts_with("?>"))
      return cursor.fail(cursor.at, "expected a blank behind the name of an instruction");
    const std::size_t end = rest().find("?>");
    if (end == std::string_view::npos) return cursor.fail(cursor.last, "instruction does not end");
    cursor.at += end + 2;
    return true;
  }
  constexpr bool declaration() noexcept {
    if (!read_attributes()) return false;
    if (!take("?>")) return cursor.fail(cursor.at, "declaration does not end");
    std::size_t known = 0;
    for (const std::string_view wanted : {"version", "encoding", "standalone"})
      if (known < attribute_count && attributes[known].name == wanted) ++known;
    if (known < attribute_count)
      return cursor.fail(attributes[known].name.data(),
                         "declaration has version, encoding and standalone, in this order");
    const std::string_view version = attribute("version"), encoding = attribute("encoding");
    const std::string_view standalone = attribute("standalone");
    if (version.size() < 3 || !version.starts_with("1.") || version.find_first_not_of("0123456789", 2) != version.npos)
      return cursor.fail(version.data() != nullptr ? version.data() : cursor.at, "version of XML is not 1");
    if (standalone.data() != nullptr && standalone != "yes" && standalone != "no")
      return cursor.fail(standalone.data(), "standalone is neither yes nor no");
    return encoding.data() == nullptr || is_word(encoding, "utf-8") || is_word(encoding, "us-ascii") ||
           cursor.fail(encoding.data(), "encoding is not UTF-8");
  }

  constexpr std::string_view word_of_name() noexcept {
    const char* const start = cursor.at;
    if (cursor.at != cursor.last && begins_xml_name(*cursor.at))
      while (cursor.at != cursor.last && continues_xml_name(*cursor.at)) ++cursor.at;
    return {start, static_cast<std::size_t>(cursor.at - start)};
  }

  constexpr xml_event end_tag(const char* start) noexcept {
    cursor.at += 2;
    const std::string_view ending = word_of_name();
    if (depth == 0 || ending != open_[depth - 1]) return wrong(start, "element ends that is not the last one begun");
    cursor.skip_space();
    if (!take(">")) return wrong(cursor.at, "expected the end of a tag");
    return close();
  }

  constexpr xml_event begin_tag(const char* start) noexcept {
    ++cursor.at;
    if (has_root_ && depth == 0) return wrong(start, "text goes on after its first element");
    name = word_of_name();
    if (name.empty()) return wrong(cursor.at, "expected the name of an element");
    if (depth == xml_depth) return wrong(start, "elements are nested too deeply");
    if (!read_attributes()) return xml_event::error;
    is_empty_ = take("/");
    if (!take(">")) return wrong(cursor.at, "expected an attribute or the end of a tag");
    has_root_ = true;
    open_[depth++] = name;
    return xml_event::begin;
  }

  constexpr bool read_attributes() noexcept {
    attribute_count = 0;
    for (;;) {
      const char* const before = cursor.at;
      if (!cursor.skip_space() || !begins_xml_name(*cursor.at)) return true;
      const char* const start = cursor.at;
      if (start == before) return cursor.fail(start, "expected a blank before an attribute");
      const std::string_view attribute_name = word_of_name();
      if (attribute(attribute_name).data() != nullptr) return cursor.fail(start, "attribute stands there twice");
      if (attribute_count == xml_attributes) return cursor.fail(start, "element has too many attributes");
      cursor.skip_space();
      if (!take("=")) return cursor.fail(cursor.at, "expected = behind the name of an attribute");
      cursor.skip_space();
      if (!value_of(attribute_name)) return false;
    }
  }

  constexpr bool value_of(std::string_view attribute_name) noexcept {
    const char quote = cursor.at_end() ? '\0' : *cursor.at;
    if (quote != '"' && quote != '\'') return cursor.fail(cursor.at, "expected a value in quotes");
    const char* const first = ++cursor.at;
    for (;; ++cursor.at) {
      if (cursor.at_end()) return cursor.fail(cursor.at, "value does not end");
      if (*cursor.at == quote) break;
      if (*cursor.at == '<') return cursor.fail(cursor.at, "value holds the character <");
      if (*cursor.at == '&' && reference_at(rest().substr(1)).length == 0)
        return cursor.fail(cursor.at, "entity is none of the five that are read");
    }
    attributes[attribute_count++] = {attribute_name, {first, static_cast<std::size_t>(cursor.at - first)}};
    ++cursor.at;
    return true;
  }

  std::array<std::string_view, xml_depth> open_{};
  bool is_empty_ = false, has_root_ = false, has_begun_ = false;
  const char* first_ = cursor.at;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
