// SPDX-License-Identifier: MIT
// PLY, Stanford's polygon file format: ASCII or binary bytes of either order to mesh<T>, and back. Works on memory
// only. Which elements and properties are read is listed in docs/io/ply.md; all others are passed over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/ply_reader.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/detail/vertex_layout.hpp>
#include <irg/io/mesh_options.hpp>

namespace irg {
inline namespace IRG_ABI {

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
[[nodiscard]] constexpr result<mesh<T>> read_ply(std::string_view bytes) {
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

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

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
      append_text(out, "property ");
      append_text(out, type);
      append_text(out, name);
    }
  };
  append_text(out, encoding == mesh_encoding::text            ? "ply\nformat ascii 1.0\nelement vertex "
                   : encoding == mesh_encoding::little_endian ? "ply\nformat binary_little_endian 1.0\nelement vertex "
                                                              : "ply\nformat binary_big_endian 1.0\nelement vertex ");
  append_number(out, v.vertices.size());
  append_text(out, "\n");
  properties({" x\n", " y\n", " z\n"});
  if (v.normals) properties({" nx\n", " ny\n", " nz\n"});
  if (v.texcoords) properties({" s\n", " t\n"});
  append_text(out, "element face ");
  append_number(out, faces);
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
}  // namespace detail

inline namespace IRG_ABI {

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
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_ply(
    const mesh<T>& m, mesh_encoding encoding = mesh_encoding::text) {
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
    detail::write_ply_body(m, v, lists.count, put, [&] { detail::append_text(out, "\n"), first = true; });
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

}  // namespace IRG_ABI
}  // namespace irg
