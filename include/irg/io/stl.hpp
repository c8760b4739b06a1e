// SPDX-License-Identifier: MIT
// STL, the triangles of machines that build: ASCII or binary bytes to mesh<T>, and back. Works on memory only.
//
// STL knows no shared vertices: each triangle states its three positions anew. Equal ones become one here unless the
// options say otherwise. What is accepted and refused is listed in docs/io/stl.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
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
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/merge_positions.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/mesh/validate.hpp>
#endif

namespace irg {

/// What becomes of equal positions: one that all name, or one for each corner as the file has them.
enum class stl_positions { shared, separate };

struct stl_options {
  stl_positions positions = stl_positions::shared;
  bool operator==(const stl_options&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// The mesh that an STL file describes, ASCII or binary.
/// shape   triangles; positions in the order in which the file names them first; one part for each solid with triangles
///         when any of them has a name
/// needs   the bytes in memory; they are not kept
/// gives   the first error with line and column, in binary files line 0 and the byte, in place of a half-read mesh. The
///         mesh passes validate(). Normals are not kept: the corners state them, and writers are careless with them
/// exact   ASCII numbers are correctly rounded to T, binary ones kept or, for a narrower T, rounded once
/// cost    linear; O(n log n) with shared positions; memory at most 16 times the file and 1 MiB
/// source  StereoLithography
template <Floating T = double>
[[nodiscard]] IRG_API result<mesh<T>> read_stl(std::string_view bytes, stl_options options = {});

/// The bytes of an STL file that describes the mesh; polygons become triangles (triangulate).
/// gives   an error when the mesh does not pass validate(), when there are more than 1,431,655,765 triangles, and for
///         binary files when a position is beyond the range of float. Little endian is STL's only binary order, big is
///         refused
/// exact   read_stl of the ASCII bytes gives the same mesh again, if it is of triangles, without normals and texture
///         coordinates, positions are distinct and stand in the order of their first use, and all parts have faces and
///         an object's name alone, without line breaks and bytes 0 and without blanks at its ends; of the binary bytes,
///         if T is float and there are no parts. Normals are written for other readers: zero where a triangle has none
/// cost    linear, after triangulate
/// source  StereoLithography
template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_stl(
    const mesh<T>& m, mesh_encoding encoding = mesh_encoding::text);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// STL's two forms, told apart by the length that the binary one states, and read.

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

template <Floating T>
constexpr vec<T, 3> stl_normal(const mesh<T>& m, std::size_t f) noexcept {
  const std::optional<vec<T, 3>> normal = face_normal(m, f);
  return normal ? *normal : vec<T, 3>{};
}

template <class Bytes, Floating T>
constexpr void write_stl_triangle(Bytes& out, const mesh<T>& m, std::size_t f) {
  append_text(out, "facet normal");
  append_numbers(out, stl_normal(m, f), 3);
  append_text(out, "\nouter loop\n");
  for (std::size_t k = 0; k < 3; ++k) {
    append_text(out, "vertex");
    append_numbers(out, m.positions[m.corner(f, k).position], 3);
    append_text(out, "\n");
  }
  append_text(out, "endloop\nendfacet\n");
}

/// Writes the triangles first to last - 1 as a solid; its name is the part's object, group or material.
template <class Bytes, Floating T>
constexpr void write_stl_solid(Bytes& out, const mesh<T>& m, const mesh_part& part) {
  const part_name& name = !part.object.empty() ? part.object : !part.group.empty() ? part.group : part.material;
  for (const std::string_view word : {"solid", "endsolid"}) {
    append_text(out, word);
    if (!name.empty()) append_text(out, " ");
    append_line_of(out, name);
    append_text(out, "\n");
    if (word == "endsolid") break;
    for (std::size_t f = part.first_face; f < part.first_face + part.face_count; ++f) write_stl_triangle(out, m, f);
  }
}

/// Whether a number becomes a finite float.
template <Floating T>
constexpr bool fits_float(const point<T, 3>& p) noexcept {
  constexpr T beyond = T(0x1.ffffffp127);  // what rounds to the largest float lies below it
  for (int i = 0; i < 3; ++i)
    if constexpr (sizeof(T) > 4)
      if (!(p[i] > -beyond && p[i] < beyond)) return false;
  return true;
}

template <class Bytes, Floating T>
constexpr std::optional<encode_error> write_binary_stl(Bytes& out, const mesh<T>& m) {
  for (const point<T, 3>& p : m.positions)
    if (!fits_float(p)) return encode_error{"position is too large for the 32-bit floats of binary STL"};
  append_text(out, "binary STL");
  while (out.size() < 80) out.push_back(std::uint8_t{' '});
  append_bytes<4>(out, m.face_count(), byte_order::little);
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto put = [&](const auto& v) {
      for (int i = 0; i < 3; ++i) append_bytes(out, converted<float>(v[i]), byte_order::little);
    };
    put(stl_normal(m, f));
    for (std::size_t k = 0; k < 3; ++k) put(m.positions[m.corner(f, k).position]);
    append_bytes<2>(out, 0, byte_order::little);
  }
  return std::nullopt;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API result<mesh<T>> read_stl(std::string_view bytes, stl_options options) {
  if (const auto too_long = detail::refuse_long_file(bytes)) return *too_long;
  const std::string_view text =
      detail::has_length_of_binary_stl(bytes) ? bytes : detail::without_byte_order_mark(bytes);
  mesh<T> read;
  if (detail::is_binary_stl(text)) {
    if (const auto wrong = detail::read_binary_stl(text, read))
      return parse_error{0, wrong->column + (bytes.size() - text.size()), wrong->message};
  } else {
    if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos)
      return detail::error_at_byte(bytes, bytes.data() + nul,
                                   "byte 0 stands in text, and binary STL would have another length");
    detail::stl_text_reader<T> reader(text);
    if (!reader.text()) return detail::error_at(text, reader.cursor.place, reader.cursor.message);
    read = std::move(reader.read);
  }
  if (options.positions == stl_positions::shared) read = with_merged_positions(std::move(read));
  return read;
}

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_stl(const mesh<T>& m,
                                                                                 mesh_encoding encoding) {
  if (const auto refused = detail::refuse_mesh(m)) return *refused;
  if (encoding == mesh_encoding::big_endian) return encode_error{"binary STL is little endian, not big endian"};
  if (m.corners.size() - 2 * m.face_count() > 0xffffffffu / 3) return encode_error{"mesh has too many triangles"};
  const mesh<T> triangles = triangulated(m);
  std::vector<std::uint8_t> out;
  if (encoding != mesh_encoding::text) {
    if (const auto refused = detail::write_binary_stl(out, triangles)) return *refused;
    return out;
  }
  for (const mesh_part& part : triangles.parts) detail::write_stl_solid(out, triangles, part);
  if (triangles.parts.empty()) detail::write_stl_solid(out, triangles, {{}, {}, {}, 0, triangles.face_count()});
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
