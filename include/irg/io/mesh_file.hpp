// SPDX-License-Identifier: MIT
// Meshes from files of any format that irg reads, known by their content, and to files by their name.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <irg/io/body_xml.hpp>
#include <irg/io/file.hpp>
#include <irg/io/obj.hpp>
#include <irg/io/off.hpp>
#include <irg/io/ply.hpp>
#include <irg/io/stl.hpp>

namespace irg {

/// The mesh files that irg reads.
enum class mesh_format { obj, stl, ply, off, body_xml };

inline namespace IRG_ABI {

/// The format of a mesh file's bytes: XML by its first character, PLY and OFF by their first word, STL by the word
/// solid or by the length that binary STL states in its bytes; everything else is OBJ, which has no mark of its own.
/// gives   a format for all bytes: whether they are such a file, its reader says
/// cost    constant, but for blanks and comments before the first word
constexpr mesh_format mesh_format_of(std::string_view bytes) noexcept {
  if (detail::has_length_of_binary_stl(bytes)) return mesh_format::stl;
  bytes = detail::without_byte_order_mark(bytes);
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return mesh_format::ply;
  detail::text_cursor text(bytes, '#');
  if (text.skip_space() && *text.at == '<') return mesh_format::body_xml;
  const detail::off_header off = detail::off_header_of(bytes.substr(static_cast<std::size_t>(text.at - bytes.data())));
  if (off.length != 0) return mesh_format::off;
  if (detail::is_word(text.word(), "solid")) return mesh_format::stl;
  return mesh_format::obj;
}

/// The mesh that the bytes of a file describe, whichever format it is; the bodies of an XML file are its parts.
/// gives   the error of the format's reader, with its place
/// exact   as read_obj, read_stl, read_ply, read_off and read_body_xml with their defaults
template <Floating T = double>
constexpr result<mesh<T>> read_mesh(std::string_view bytes) {
  switch (mesh_format_of(bytes)) {
    case mesh_format::stl: return read_stl<T>(bytes);
    case mesh_format::ply: return read_ply<T>(bytes);
    case mesh_format::off: return read_off<T>(bytes);
    case mesh_format::body_xml: {
      const auto bodies = read_body_xml<T>(bytes);
      if (!bodies) return bodies.error();
      return mesh_of_bodies(*bodies);
    }
    case mesh_format::obj: break;
  }
  return read_obj<T>(bytes);
}

/// The mesh in a file, whichever format it is. No other file is opened, whatever this one names.
/// gives   the error of read_file or of the format's reader
/// cost    the file's size in memory beside what the reader takes
template <Floating T = double>
result<mesh<T>> load_mesh(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return read_mesh<T>(std::string_view(*bytes));
}

}  // namespace IRG_ABI
}  // namespace irg
