// SPDX-License-Identifier: MIT
// STL, the triangles of machines that build: ASCII or binary bytes to mesh<T>, and back. Works on memory only.
//
// STL knows no shared vertices: each triangle states its three positions anew. Equal ones become one here unless the
// options say otherwise. What is accepted and refused is listed in docs/io/stl.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/byte_cursor.hpp>
#include <irg/io/detail/stl_reader.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/mesh/merge_positions.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/mesh/validate.hpp>

namespace irg {

/// What becomes of equal positions: one that all name, or one for each corner as the file has them.
enum class stl_positions { shared, separate };

struct stl_options {
  stl_positions positions = stl_positions::shared;
};

inline namespace IRG_ABI {

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
[[nodiscard]] constexpr result<mesh<T>> read_stl(std::string_view bytes, stl_options options = {}) {
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
  if (options.positions == stl_positions::shared) read = merge_positions(std::move(read));
  return read;
}

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

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
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_stl(
    const mesh<T>& m, mesh_encoding encoding = mesh_encoding::text) {
  if (const auto refused = detail::refuse_mesh(m)) return *refused;
  if (encoding == mesh_encoding::big_endian) return encode_error{"binary STL is little endian, not big endian"};
  if (m.corners.size() - 2 * m.face_count() > 0xffffffffu / 3) return encode_error{"mesh has too many triangles"};
  const mesh<T> triangles = triangulate(m);
  std::vector<std::uint8_t> out;
  if (encoding != mesh_encoding::text) {
    if (const auto refused = detail::write_binary_stl(out, triangles)) return *refused;
    return out;
  }
  for (const mesh_part& part : triangles.parts) detail::write_stl_solid(out, triangles, part);
  if (triangles.parts.empty()) detail::write_stl_solid(out, triangles, {{}, {}, {}, 0, triangles.face_count()});
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
