// SPDX-License-Identifier: MIT
// The header of a PLY file: its elements and their properties, as the body has them one after another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/io/detail/text_cursor.hpp>
#include <irg/io/mesh_options.hpp>

namespace irg::detail {

/// The types of numbers that PLY has.
enum class ply_type : std::uint8_t { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The properties that irg knows by name; tu to tt are texture_u, texture_v, texture_s and texture_t. One of the pairs
/// from s on is read, and one of the two lists of corners: when the header has been read, that pair has the roles s and
/// t, that list the role indices, and the others are unread. x to t are the places of a vertex's numbers.
enum class ply_role : std::uint8_t { x, y, z, nx, ny, nz, s, t, u, v, tu, tv, ts, tt, indices, index, unread };
inline constexpr std::size_t ply_numbers = 8;

struct ply_property {
  ply_type type = ply_type::none;
  ply_type count = ply_type::none;  // of a list's length; none: the property is one number
  ply_role role = ply_role::unread;
};

enum class ply_kind { vertex, face, other };

template <class Property = ply_property>
struct IRG_APART ply_element {
  ply_kind kind = ply_kind::other;
  std::uint64_t count = 0;
  std::vector<Property> properties;
  std::uint32_t roles = 0;  // bit r: some property has the role r

  constexpr bool has(ply_role first, ply_role last) const noexcept {
    for (auto r = static_cast<unsigned>(first); r <= static_cast<unsigned>(last); ++r)
      if ((roles >> r & 1) == 0) return false;
    return true;
  }

  /// Gives the roles from `first` on to the first of the groups of `size` spellings, up to `last`, that is complete;
  /// what else stands there of them is unread.
  constexpr void choose(ply_role first, ply_role last, unsigned size) noexcept {
    const auto begin = static_cast<unsigned>(first), end = static_cast<unsigned>(last) + 1, all = (1u << size) - 1;
    unsigned chosen = begin;
    while (chosen < end && (roles >> chosen & all) != all) chosen += size;
    roles &= ~((1u << end) - (1u << begin));
    if (chosen < end) roles |= all << begin;
    for (Property& p : properties) {
      const auto role = static_cast<unsigned>(p.role);
      if (role < begin || role >= end) continue;
      const bool is_read = role >= chosen && role < chosen + size;
      p.role = is_read ? static_cast<ply_role>(role - chosen + begin) : ply_role::unread;
    }
  }
};

inline namespace IRG_ABI {

constexpr ply_type ply_type_of(std::string_view name) noexcept {
  constexpr std::string_view names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                           {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                           {"float", "float32"}, {"double", "float64"}};
  for (std::size_t i = 0; i < 8; ++i)
    if (name == names[i][0] || name == names[i][1]) return static_cast<ply_type>(i + 1);
  return ply_type::none;
}
constexpr bool is_whole(ply_type t) noexcept { return t < ply_type::float32; }

constexpr ply_role ply_role_of(ply_kind kind, std::string_view name, bool is_list) noexcept {
  constexpr std::string_view names[] = {"x",           "y",         "z",         "nx",        "ny",
                                        "nz",          "s",         "t",         "u",         "v",
                                        "texture_u",   "texture_v", "texture_s", "texture_t", "vertex_indices",
                                        "vertex_index"};
  constexpr auto lists = static_cast<std::size_t>(ply_role::indices);
  if (kind != (is_list ? ply_kind::face : ply_kind::vertex)) return ply_role::unread;
  for (std::size_t i = is_list ? lists : 0; i < (is_list ? lists + 2 : lists); ++i)
    if (name == names[i]) return static_cast<ply_role>(i);
  return ply_role::unread;
}

/// Reads the header; afterwards the cursor stands at the body's first byte.
template <class Element>
struct ply_header {
  text_cursor cursor;
  mesh_encoding encoding = mesh_encoding::text;
  std::vector<Element> elements{};
  bool has_vertices = false, has_faces = false;

  constexpr explicit ply_header(std::string_view bytes) noexcept : cursor(bytes, '\0') {}

  /// Where a line ends is settled by the first one: after a lone CR, a binary body may begin with the byte of LF.
  constexpr bool end_line() noexcept {
    if (cursor.skip_blanks()) return cursor.fail(cursor.at, "expected the end of the line");
    if (cursor.at_end()) return cursor.fail(cursor.at, "text ends within the header");
    const bool carriage_return = *cursor.at == '\r';
    ++cursor.at;
    if (first_line_) line_feeds_ = !carriage_return || (!cursor.at_end() && *cursor.at == '\n');
    first_line_ = false;
    if (carriage_return && line_feeds_ && !cursor.at_end() && *cursor.at == '\n') ++cursor.at;
    return true;
  }

  constexpr bool read() {
    const char* const head = cursor.at;
    if (cursor.word() != "ply") return cursor.fail(head, "file does not begin with the word ply");
    if (!end_line() || !format() || !end_line()) return false;
    for (;;) {
      const std::string_view word = cursor.word_in_line();
      const char* const start = cursor.at - word.size();
      if (word == "end_header") break;
      if (word == "comment" || word == "obj_info")
        cursor.skip_to_line_end();
      else if (word == "element" ? !element() : word == "property" ? !property(start) : !word.empty())
        return cursor.message != nullptr ? false : cursor.fail(start, "expected element, property or end_header");
      if (!end_line()) return false;
    }
    return end_line() && check(cursor.at);
  }

  constexpr bool format() noexcept {
    std::string_view word = cursor.word_in_line();
    if (word != "format") return cursor.fail(cursor.at - word.size(), "expected the format in the second line");
    word = cursor.word_in_line();
    if (word == "binary_little_endian")
      encoding = mesh_encoding::little_endian;
    else if (word == "binary_big_endian")
      encoding = mesh_encoding::big_endian;
    else if (word != "ascii")
      return cursor.fail(cursor.at - word.size(), "format is none of ascii and the two binary ones");
    word = cursor.word_in_line();
    return word == "1.0" || cursor.fail(cursor.at - word.size(), "version of the format is not 1.0");
  }

  constexpr bool element() {
    const std::string_view name = cursor.word_in_line();
    Element e;
    e.kind = name == "vertex" ? ply_kind::vertex : name == "face" ? ply_kind::face : ply_kind::other;
    if (name.empty()) return cursor.fail(cursor.at, "element has no name");
    bool& seen = e.kind == ply_kind::vertex ? has_vertices : has_faces;
    if (e.kind != ply_kind::other && seen) return cursor.fail(cursor.at - name.size(), "element stands there twice");
    if (e.kind != ply_kind::other) seen = true;
    if (name == "tristrips") return cursor.fail(cursor.at - name.size(), "strips of triangles are not read");
    if (!cursor.skip_blanks()) return cursor.fail(cursor.at, "element has no count");
    std::int64_t count = 0;
    const char* const start = cursor.at;
    if (!cursor.integer(count)) return false;
    if (count < 0) return cursor.fail(start, "count of an element is negative");
    e.count = static_cast<std::uint64_t>(count);
    elements.push_back(static_cast<Element&&>(e));
    return true;
  }

  constexpr bool type(ply_type& into) noexcept {
    const std::string_view word = cursor.word_in_line();
    into = ply_type_of(word);
    return into != ply_type::none || cursor.fail(cursor.at - word.size(), "expected the type of a number");
  }

  constexpr bool property(const char* start) {
    if (elements.empty()) return cursor.fail(start, "property stands before the first element");
    Element& e = elements.back();
    ply_property p;
    const char* const before = cursor.at;
    const bool is_list = cursor.word_in_line() == "list";
    if (!is_list) cursor.at = before;
    if (is_list && !type(p.count)) return false;
    if (is_list && !is_whole(p.count)) return cursor.fail(start, "length of a list is no whole number");
    if (!type(p.type)) return false;
    const std::string_view name = cursor.word_in_line();
    if (name.empty()) return cursor.fail(cursor.at, "property has no name");
    p.role = ply_role_of(e.kind, name, is_list);
    const std::uint32_t role = std::uint32_t{1} << static_cast<unsigned>(p.role);
    if (p.role != ply_role::unread && (e.roles & role) != 0) return cursor.fail(start, "property stands there twice");
    if (is_list && p.role != ply_role::unread && !is_whole(p.type))
      return cursor.fail(start, "indices are no whole numbers");
    e.roles |= role;
    e.properties.push_back(p);
    return true;
  }

  constexpr bool check(const char* place) noexcept {
    for (Element& e : elements) {
      e.choose(ply_role::nx, ply_role::nz, 3);
      e.choose(ply_role::s, ply_role::tt, 2);
      e.choose(ply_role::indices, ply_role::index, 1);
      if (e.kind == ply_kind::vertex && e.count > 0 && !e.has(ply_role::x, ply_role::z))
        return cursor.fail(place, "vertices have no x, y and z");
      if (e.kind == ply_kind::face && e.count > 0 && !e.has(ply_role::indices, ply_role::indices))
        return cursor.fail(place, "faces have no list vertex_indices");
    }
    return has_vertices || cursor.fail(place, "there is no element vertex");
  }

private:
  bool first_line_ = true, line_feeds_ = true;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
