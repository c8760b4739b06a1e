// SPDX-License-Identifier: MIT
// STL's two forms, told apart by the length that the binary one states, and read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/io/detail/byte_cursor.hpp>
#include <irg/io/detail/text_cursor.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

inline constexpr std::size_t stl_head = 84, stl_triangle = 50;

/// Whether the bytes have the length that binary STL states in them. No text has: its bytes, taken as a count, make
/// more than 4 GiB of triangles.
constexpr bool has_length_of_binary_stl(std::string_view bytes) noexcept {
  return bytes.size() >= stl_head &&
         bytes.size() == stl_head + stl_triangle * ordered_bits<4>(bytes.data() + 80, byte_order::little);
}

/// Whether bytes that do not begin with the word solid are a text none the less: no control characters up to where
/// binary STL has its count, which would make more than 4 GiB, and no byte 0 anywhere.
constexpr bool is_text_for_stl(std::string_view bytes) noexcept {
  for (const char c : bytes.substr(0, stl_head))
    if ((static_cast<unsigned char>(c) < 0x20 && !is_blank(c) && !is_line_break(c)) || c == '\x7f') return false;
  return bytes.find('\0') == std::string_view::npos;
}

/// Whether the bytes are to be read as binary STL: they have its length, or neither begin with the word solid nor are a
/// text.
constexpr bool is_binary_stl(std::string_view bytes) noexcept {
  if (has_length_of_binary_stl(bytes)) return true;
  text_cursor text(bytes, '\0');
  return text.skip_space() && !is_word(text.word(), "solid") && !is_text_for_stl(bytes);
}

/// Adds the face of the last three positions.
template <Floating T>
constexpr void add_stl_face(mesh<T>& m) {
  const auto count = static_cast<std::uint32_t>(m.positions.size());
  add_face(m, std::initializer_list<std::uint32_t>{count - 3, count - 2, count - 1});
}

template <Floating T>
constexpr std::optional<parse_error> read_binary_stl(std::string_view bytes, mesh<T>& into) {
  if (bytes.size() < stl_head) return parse_error{0, bytes.size() + 1, "file is too short for STL, or no STL at all"};
  const std::uint64_t count = ordered_bits<4>(bytes.data() + 80, byte_order::little);
  if (bytes.size() != stl_head + stl_triangle * count)
    return error_at_byte(bytes, bytes.data() + 80,
                         bytes.size() < stl_head + stl_triangle * count
                             ? "file is too short for the number of triangles that stands here"
                             : "file is too long for the number of triangles that stands here");
  into.positions.reserve(3 * static_cast<std::size_t>(count));
  into.corners.reserve(3 * static_cast<std::size_t>(count));
  into.face_starts.reserve(static_cast<std::size_t>(count) + 1);
  const char* p = bytes.data() + stl_head;
  for (std::uint64_t f = 0; f < count; ++f, p += stl_triangle) {
    for (std::size_t k = 1; k <= 3; ++k) {
      point<T, 3> position;
      for (std::size_t i = 0; i < 3; ++i) {
        const char* const at = p + 12 * k + 4 * i;
        const float x = load_float(at, byte_order::little);
        if (!is_finite(x)) return error_at_byte(bytes, at, "number is not finite");
        position[static_cast<int>(i)] = converted<T>(x);
      }
      into.positions.push_back(position);
    }
    add_stl_face(into);
  }
  return std::nullopt;
}

/// Reads ASCII STL: solids of facets.
template <Floating T>
struct stl_text_reader {
  text_cursor cursor;
  mesh<T> read{};
  bool has_names = false;

  constexpr explicit stl_text_reader(std::string_view text) noexcept : cursor(text, '\0') {}

  constexpr bool text() {
    if (!cursor.skip_space()) return cursor.fail(cursor.at, "text has no word solid");
    while (cursor.skip_space())
      if (!expect("solid", "expected the word solid") || !solid()) return false;
    if (!has_names) read.parts.clear();
    return true;
  }

  constexpr bool expect(std::string_view word, const char* message) noexcept {
    if (!cursor.skip_space()) return cursor.fail(cursor.at, "text ends within a solid");
    const char* const start = cursor.at;
    return is_word(cursor.word(), word) || cursor.fail(start, message);
  }

  constexpr bool solid() {
    const std::string_view name = cursor.rest_of_line();
    const std::size_t first = read.face_count();
    for (;;) {
      if (!cursor.skip_space()) return cursor.fail(cursor.at, "text ends within a solid");
      const char* const start = cursor.at;
      const std::string_view word = cursor.word();
      if (is_word(word, "endsolid")) break;
      if (!is_word(word, "facet")) return cursor.fail(start, "expected facet or endsolid");
      if (!facet()) return false;
    }
    cursor.skip_to_line_end();
    if (read.face_count() == first) return true;
    read.parts.push_back({name, {}, {}, first, read.face_count() - first});
    has_names = has_names || !name.empty();
    return true;
  }

  constexpr bool facet() {
    if (!expect("normal", "expected the word normal")) return false;
    for (int i = 0; i < 3; ++i)  // whatever they are: writers put nan there, and worse
      if (cursor.word_in_line().empty()) return cursor.fail(cursor.at, "normal has fewer than three numbers");
    if (!expect("outer", "expected outer loop") || !expect("loop", "expected outer loop")) return false;
    for (int k = 0; k < 3; ++k) {
      if (!expect("vertex", "expected the word vertex: a facet has three")) return false;
      point<T, 3> position;
      for (int i = 0; i < 3; ++i)
        if (!cursor.number(position[i])) return false;
      read.positions.push_back(position);
    }
    if (!expect("endloop", "expected endloop: a facet has three vertices")) return false;
    if (!expect("endfacet", "expected endfacet")) return false;
    add_stl_face(read);
    return true;
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
