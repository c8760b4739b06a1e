// SPDX-License-Identifier: MIT
// PLY, Stanford's polygon file format: ASCII or binary bytes of either order to mesh<T>, and back. Works on memory
// only. Which elements and properties are read is listed in docs/io/ply.md; all others are passed over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/io/detail/byte_cursor.hpp>
#include <irg/io/detail/text_cursor.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/detail/vertex_layout.hpp>
#endif

namespace irg::inline IRG_COMPILED_ABI {

/// The mesh that a PLY file describes.
/// shape   its vertices' positions in order, with normals (nx, ny, nz) and texture coordinates (the first whole pair of
///         s t, u v, texture_u texture_v, texture_s texture_t) where vertices have them, and the polygons of its faces;
///         corners name the normal and the texture coordinate of their own vertex
/// needs   the bytes in memory; they are not kept
/// gives   the first error with line and column, in a binary body line 0 and the byte, in place of a half-read mesh.
///         The mesh passes validate()
/// exact   ASCII numbers are correctly rounded to T, whatever type the header declares; binary ones are kept or, for a
///         narrower T, rounded once
/// cost    linear; memory at most 64 times the file and 1 MiB, whatever the header claims
/// source  Turk 1994
template <Floating T = double>
[[nodiscard]] IRG_API result<mesh<T>> read_ply(std::string_view bytes);

/// The bytes of a PLY file that describes the mesh.
/// shape   a vertex for each position, more where its corners differ in normal or texture coordinate; an attribute that
///         some corner lacks is left out, and so are the names of parts, for which PLY has no place. Without faces,
///         normals are those of the positions if they are as many, and so are texture coordinates
/// gives   an error when the mesh does not pass validate(). Counts of corners are uchar up to 255, then int; indices
///         are int below 2^31
/// exact   read_ply<T> of the bytes gives the same mesh again, in all three encodings, if there are no parts, and as
///         many normals as positions, each corner naming that of its position's number, or none, and so texture
///         coordinates
/// cost    linear; O(n log n) where there are normals or texture coordinates
/// source  Turk 1994
template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_ply(
    const mesh<T>& m, mesh_encoding encoding = mesh_encoding::text);

}  // namespace irg::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail {

// The header of a PLY file: its elements and their properties, as the body has them one after another.

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

// The body of a PLY file, element by element as the header lists them. One text reads both forms: a source gives the
// next number, from words or from bytes.

/// Numbers as words, one after another.
struct ply_text_source {
  text_cursor cursor;

  constexpr const char* next() noexcept {
    cursor.skip_space();
    return cursor.at;
  }
  template <Floating T>
  constexpr bool number(ply_type, T& into) noexcept {
    return cursor.number(into);
  }
  constexpr bool whole(ply_type, std::int64_t& into) noexcept { return cursor.integer(into); }
  constexpr bool skip(ply_type) noexcept {
    if (!cursor.skip_space()) return cursor.fail(cursor.at, "text ends where a number is expected");
    cursor.word();
    return true;
  }
  constexpr bool skip(ply_type type, std::uint64_t count) noexcept {
    for (std::uint64_t i = 0; i < count; ++i)
      if (!skip(type)) return false;
    return true;
  }
};

/// Numbers as bytes.
struct ply_byte_source {
  text_cursor cursor;
  byte_order order;

  constexpr const char* next() const noexcept { return cursor.at; }
  static constexpr std::size_t size(ply_type t) noexcept {
    constexpr std::uint8_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(t)];
  }
  constexpr bool has(std::uint64_t bytes) noexcept {
    return static_cast<std::uint64_t>(cursor.last - cursor.at) >= bytes ||
           cursor.fail(cursor.last, "file ends where a number is expected");
  }
  constexpr bool whole(ply_type t, std::int64_t& into) noexcept {
    if (!has(size(t))) return false;
    switch (t) {
      case ply_type::int8:
        into = static_cast<std::uint8_t>(ordered_bits<1>(cursor.at, order));
        if (into > 127) into -= 256;
        break;
      case ply_type::uint8: into = static_cast<std::uint8_t>(ordered_bits<1>(cursor.at, order)); break;
      case ply_type::int16: into = static_cast<std::int16_t>(ordered_bits<2>(cursor.at, order)); break;
      case ply_type::uint16: into = static_cast<std::uint16_t>(ordered_bits<2>(cursor.at, order)); break;
      case ply_type::int32: into = static_cast<std::int32_t>(ordered_bits<4>(cursor.at, order)); break;
      default: into = static_cast<std::uint32_t>(ordered_bits<4>(cursor.at, order)); break;
    }
    cursor.at += size(t);
    return true;
  }
  template <Floating T>
  constexpr bool number(ply_type t, T& into) noexcept {
    if (!has(size(t))) return false;
    const char* const start = cursor.at;
    if (is_whole(t)) {
      std::int64_t n = 0;
      whole(t, n);
      into = converted<T>(static_cast<double>(n));
      return true;
    }
    cursor.at += size(t);
    const double x = t == ply_type::float32 ? converted<double>(load_float(start, order)) : load_double(start, order);
    if (!is_finite(x)) return cursor.fail(start, "number is not finite");
    if constexpr (sizeof(T) == 4)  // half a unit beyond the largest float
      if (!(x > -0x1.ffffffp127 && x < 0x1.ffffffp127)) return cursor.fail(start, "number is too large");
    into = converted<T>(x);
    return true;
  }
  constexpr bool skip(ply_type t) noexcept { return skip(t, 1); }
  constexpr bool skip(ply_type t, std::uint64_t count) noexcept {
    if (!has(count * size(t))) return false;  // lists are shorter than 2^32
    cursor.at += count * size(t);
    return true;
  }
};

/// Reads the body from `source`, or stops with its message.
template <Floating T, class Source, class Element>
struct ply_body_reader {
  Source source;
  const ply_header<Element>& header;
  mesh<T> read{};
  std::uint64_t vertex_count = 0;

  constexpr bool body() {
    for (const Element& e : header.elements)
      if (e.kind == ply_kind::vertex) vertex_count = e.count;
    for (const Element& e : header.elements) {
      if (e.properties.empty()) continue;  // nothing stands in the file, however many there are
      const bool good = e.kind == ply_kind::vertex ? vertices(e) : e.kind == ply_kind::face ? faces(e) : others(e);
      if (!good) return false;
    }
    if (source.next() != source.cursor.last)
      return source.cursor.fail(source.next(), "file goes on after the last element");
    return true;
  }

  constexpr bool skip(const ply_property& p) noexcept {
    if (p.count == ply_type::none) return source.skip(p.type);
    std::int64_t count = 0;
    return length(p, count) && source.skip(p.type, static_cast<std::uint64_t>(count));
  }

  constexpr bool length(const ply_property& p, std::int64_t& count) noexcept {
    const char* const start = source.next();
    if (!source.whole(p.count, count)) return false;
    if (count < 0) return source.cursor.fail(start, "length of a list is negative");
    return count <= 0xffffffff || source.cursor.fail(start, "list is longer than the file");
  }

  constexpr bool others(const Element& e) noexcept {
    for (std::uint64_t i = 0; i < e.count; ++i)
      for (const ply_property& p : e.properties)
        if (!skip(p)) return false;
    return true;
  }

  constexpr bool vertices(const Element& e) {
    const bool normals = e.has(ply_role::nx, ply_role::nz), texcoords = e.has(ply_role::s, ply_role::t);
    for (std::uint64_t i = 0; i < e.count; ++i) {
      std::array<T, ply_numbers> n{};
      for (const ply_property& p : e.properties) {
        const auto place = static_cast<std::size_t>(p.role);
        if (!(place < ply_numbers ? source.number(p.type, n[place]) : skip(p))) return false;
      }
      read.positions.push_back({n[0], n[1], n[2]});
      if (normals) read.normals.push_back({n[3], n[4], n[5]});
      if (texcoords) read.texcoords.push_back({n[6], n[7]});
    }
    return true;
  }

  constexpr bool faces(const Element& e) {
    for (std::uint64_t i = 0; i < e.count; ++i)
      for (const ply_property& p : e.properties)
        if (!(p.role == ply_role::indices ? face(p) : skip(p))) return false;
    return true;
  }

  constexpr bool face(const ply_property& p) {
    const char* const start = source.next();
    std::int64_t count = 0;
    if (!length(p, count)) return false;
    if (count < 3) return source.cursor.fail(start, "face has fewer than three corners");
    for (std::int64_t k = 0; k < count; ++k) {
      const char* const place = source.next();
      std::int64_t index = 0;
      if (!source.whole(p.type, index)) return false;
      if (index < 0) return source.cursor.fail(place, "index of a vertex is negative");
      if (static_cast<std::uint64_t>(index) >= vertex_count)
        return source.cursor.fail(place, "face index is not smaller than the number of vertices");
      read.corners.push_back({static_cast<std::uint32_t>(index), no_index, no_index});
    }
    read.face_starts.push_back(static_cast<std::uint32_t>(read.corners.size()));
    return true;
  }

  /// Vertices have one normal and one texture coordinate each.
  constexpr void name_attributes() noexcept {
    for (mesh_corner& c : read.corners) {
      if (!read.normals.empty()) c.normal = c.position;
      if (!read.texcoords.empty()) c.texcoord = c.position;
    }
  }
};

/// The types of a face's list as they are written: the usual ones, which every reader knows, as long as they suffice.
/// Some readers take no uint for a count, and some none for an index.
struct ply_lists {
  ply_type count, index;
};
constexpr ply_lists ply_lists_of(std::uint64_t most_corners, std::uint64_t vertices) noexcept {
  constexpr std::uint64_t half = std::uint64_t{1} << 31;
  const ply_type count = most_corners < half ? ply_type::int32 : ply_type::uint32;
  return {most_corners < 256 ? ply_type::uint8 : count, vertices <= half ? ply_type::int32 : ply_type::uint32};
}

template <Floating T, class Bytes, class Layout>
constexpr void write_ply_header(Bytes& out, const Layout& v, std::size_t faces, ply_lists lists,
                                mesh_encoding encoding) {
  const std::string_view type = sizeof(T) == 4 ? "float" : "double";
  const auto properties = [&](std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      append_all(out, "property ", type, name);
    }
  };
  append_text(out, encoding == mesh_encoding::text            ? "ply\nformat ascii 1.0\nelement vertex "
                   : encoding == mesh_encoding::little_endian ? "ply\nformat binary_little_endian 1.0\nelement vertex "
                                                              : "ply\nformat binary_big_endian 1.0\nelement vertex ");
  append_all(out, v.vertices.size(), "\n");
  properties({" x\n", " y\n", " z\n"});
  if (v.normals) properties({" nx\n", " ny\n", " nz\n"});
  if (v.texcoords) properties({" s\n", " t\n"});
  append_all(out, "element face ", faces);
  append_text(out, lists.count == ply_type::uint8   ? "\nproperty list uchar "
                   : lists.count == ply_type::int32 ? "\nproperty list int "
                                                    : "\nproperty list uint ");
  append_text(
      out, lists.index == ply_type::int32 ? "int vertex_indices\nend_header\n" : "uint vertex_indices\nend_header\n");
}

/// Writes the numbers of the body through put(number), which looks at the number's type, and end(), which ends an
/// element.
template <Floating T, class Layout, class Put, class End>
constexpr void write_ply_body(const mesh<T>& m, const Layout& v, ply_type count_type, const Put& put, const End& end) {
  const auto put_all = [&](const auto& numbers, int count) {
    for (int i = 0; i < count; ++i) put(numbers[i]);
  };
  for (const mesh_corner& c : v.vertices) {
    put_all(m.positions[c.position], 3);
    if (v.normals) put_all(normal_to_write(m, c), 3);
    if (v.texcoords) put_all(texcoord_to_write(m, c), 2);
    end();
  }
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    if (const auto corners = static_cast<std::uint32_t>(m.face_size(f)); count_type == ply_type::uint8)
      put(static_cast<std::uint8_t>(corners));
    else
      put(corners);
    for (std::size_t k = 0; k < m.face_size(f); ++k) put(v.of_corner[m.face_starts[f] + k]);
    end();
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API result<mesh<T>> read_ply(std::string_view bytes) {
  if (const auto too_long = detail::refuse_long_file(bytes)) return *too_long;
  const std::string_view text = detail::without_byte_order_mark(bytes);
  using element = detail::ply_element<>;
  detail::ply_header<element> header(text);
  if (!header.read()) return detail::error_at(text, header.cursor.place, header.cursor.message);
  const auto finish = [&](auto reader, auto error, std::string_view counted) -> result<mesh<T>> {
    if (!reader.body()) return error(counted, reader.source.cursor.place, reader.source.cursor.message);
    reader.name_attributes();
    return std::move(reader.read);
  };
  if (header.encoding == mesh_encoding::text)
    return finish(detail::ply_body_reader<T, detail::ply_text_source, element>{{header.cursor}, header},
                  detail::error_at, text);
  const bool little = header.encoding == mesh_encoding::little_endian;
  const detail::ply_byte_source source{header.cursor, little ? detail::byte_order::little : detail::byte_order::big};
  return finish(detail::ply_body_reader<T, detail::ply_byte_source, element>{source, header}, detail::error_at_byte,
                bytes);
}

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_ply(const mesh<T>& m,
                                                                                 mesh_encoding encoding) {
  if (const auto refused = detail::refuse_mesh(m)) return *refused;
  const auto v = detail::vertices_to_write(m);
  std::size_t most_corners = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    most_corners = m.face_size(f) > most_corners ? m.face_size(f) : most_corners;
  const detail::ply_lists lists = detail::ply_lists_of(most_corners, v.vertices.size());
  std::vector<std::uint8_t> out;
  detail::write_ply_header<T>(out, v, m.face_count(), lists, encoding);
  if (encoding == mesh_encoding::text) {
    bool first = true;
    const auto put = [&](auto number) {
      if (!first) detail::append_text(out, " ");
      first = false;
      detail::append_number(out, number);
    };
    detail::write_ply_body(m, v, lists.count, put, [&] {
      detail::append_text(out, "\n");
      first = true;
    });
    return out;
  }
  const auto order = encoding == mesh_encoding::big_endian ? detail::byte_order::big : detail::byte_order::little;
  const auto put = [&](auto number) {
    if constexpr (std::floating_point<decltype(number)>)
      detail::append_bytes(out, number, order);
    else
      detail::append_bytes<static_cast<int>(sizeof number)>(out, number, order);
  };
  detail::write_ply_body(m, v, lists.count, put, [] {});
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
