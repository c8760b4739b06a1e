// SPDX-License-Identifier: MIT
// OFF, Geomview's object file format: text or binary bytes to mesh<T>, and back. Works on memory only. Normals and
// texture coordinates of vertices are read (NOFF, STOFF), colours are read past (COFF, or unannounced). docs/io/off.md
// lists the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/off_reader.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/detail/vertex_layout.hpp>
#include <irg/io/mesh_options.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The mesh that an OFF file describes.
/// shape   its vertices' positions in order, with their normals and texture coordinates where the first word promises
///         them, and its polygons; corners name the normal and the texture coordinate of their own vertex
/// needs   the bytes in memory; they are not kept
/// gives   the first error with line and column, in a binary body line 0 and the byte, in place of a half-read mesh.
///         The mesh passes validate()
/// exact   decimal numbers are correctly rounded to T, binary ones kept
/// cost    linear; memory at most 64 times the file and 1 MiB, whatever its counts claim
/// source  Geomview
template <Floating T = double>
[[nodiscard]] constexpr result<mesh<T>> read_off(std::string_view bytes) {
  if (const auto too_long = detail::refuse_long_file(bytes)) return *too_long;
  const std::string_view text = detail::without_byte_order_mark(bytes);
  detail::off_reader<T> reader(text);
  if (reader.file()) return std::move(reader.read);
  if (!reader.in_text) return detail::error_at_byte(bytes, reader.cursor.place, reader.cursor.message);
  return detail::error_at(text, reader.cursor.place, reader.cursor.message);
}

/// The bytes of an OFF file that describes the mesh, as text: OFF, NOFF, STOFF or STNOFF.
/// shape   a vertex for each position, more where its corners differ in normal or texture coordinate; an attribute that
///         some corner lacks is left out, and so are the names of parts, for which OFF has no place. Without faces,
///         normals are those of the positions if they are as many, and so are texture coordinates
/// gives   an error when the mesh does not pass validate()
/// exact   read_off<T> of the bytes gives the same mesh again, if there are no parts, and as many normals as positions,
///         each corner naming that of its position's number, or none, and so texture coordinates
/// cost    linear; O(n log n) where there are normals or texture coordinates
/// source  Geomview
template <Floating T>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_off(const mesh<T>& m) {
  if (const auto refused = detail::refuse_mesh(m)) return *refused;
  const auto v = detail::vertices_to_write(m);
  std::vector<std::uint8_t> out;
  if (v.texcoords) detail::append_text(out, "ST");
  detail::append_text(out, v.normals ? "NOFF\n" : "OFF\n");
  detail::append_number(out, v.vertices.size());
  detail::append_text(out, " ");
  detail::append_number(out, m.face_count());
  detail::append_text(out, " 0\n");
  for (const mesh_corner& c : v.vertices) {
    detail::append_numbers(out, m.positions[c.position], 3);
    if (v.normals) detail::append_numbers(out, detail::normal_to_write(m, c), 3);
    if (v.texcoords) detail::append_numbers(out, detail::texcoord_to_write(m, c), 2);
    detail::append_text(out, "\n");
  }
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    detail::append_number(out, m.face_size(f));
    detail::append_numbers(out, v.of_corner.data() + m.face_starts[f], static_cast<int>(m.face_size(f)));
    detail::append_text(out, "\n");
  }
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
