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
#include <irg/io/detail/text_place.hpp>
#include <irg/io/file.hpp>
#include <irg/io/mtl.hpp>
#include <irg/io/obj.hpp>
#include <irg/io/obj_write.hpp>
#include <irg/io/off.hpp>
#include <irg/io/ply.hpp>
#include <irg/io/stl.hpp>
#if IRG_BODIES
#include <irg/io/detail/text_cursor.hpp>
#endif

namespace irg {

/// The mesh files that irg reads and writes.
enum class mesh_format { obj, stl, ply, off, body_xml };

/// The endings of their names, for messages.
inline constexpr const char* mesh_endings = ".obj, .stl, .ply, .off or .xml";

inline namespace IRG_COMPILED_ABI {

/// The format of a mesh file's bytes: XML by its first character, PLY and OFF by their first word, STL by the word
/// solid or by the length that binary STL states in its bytes; everything else is OBJ, which has no mark of its own.
/// gives   a format for all bytes: whether they are such a file, its reader says
/// cost    constant, but for blanks and comments before the first word
template <class Text = std::string_view>
[[nodiscard]] IRG_API mesh_format mesh_format_of(std::type_identity_t<Text> bytes) noexcept;

/// The bytes of a file that describes the mesh in the given format.
/// gives   the error of the format's writer, and one for an encoding that it does not have: OBJ, OFF and XML are text
template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_mesh(
    const mesh<T>& m, mesh_format format, mesh_encoding encoding = mesh_encoding::text);

}  // namespace IRG_COMPILED_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API result<mesh<T>> read_mesh_as(std::string_view bytes, mesh_format format);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The mesh that the bytes of a file describe, whichever format it is; the bodies of an XML file are its parts.
/// gives   the error of the format's reader, with its place
/// exact   as read_obj, read_stl, read_ply, read_off and read_body_xml with their defaults
template <Floating T = double>
[[nodiscard]] constexpr result<mesh<T>> read_mesh(std::string_view bytes) {
  return detail::read_mesh_as<T>(bytes, mesh_format_of(bytes));
}

/// The same of a file whose name asks for a format. The content decides what is read; where nothing can be, the name
/// decides whose sentence is given.
/// gives   the error of the reader that is named; of the content's own where OBJ is named, which has no mark. A text in
///         which OBJ finds no vertex is no OBJ where another format is named
/// cost    a second reading where the first fails
template <Floating T = double>
[[nodiscard]] constexpr result<mesh<T>> read_mesh(std::string_view bytes, mesh_format named) {
  const mesh_format found = mesh_format_of(bytes);
  auto read = detail::read_mesh_as<T>(bytes, found);
  const bool is_no_obj = read && found == mesh_format::obj && read->positions.empty();
  if ((read && !is_no_obj) || named == found || named == mesh_format::obj) return read;
  return detail::read_mesh_as<T>(bytes, named);
}

/// The format that a file's name asks for by its ending, in either case; absent when it is none of mesh_endings.
[[nodiscard]] constexpr std::optional<mesh_format> mesh_format_of_name(std::string_view path) noexcept {
  if (detail::has_ending(path, ".obj")) return mesh_format::obj;
  if (detail::has_ending(path, ".stl")) return mesh_format::stl;
  if (detail::has_ending(path, ".ply")) return mesh_format::ply;
  if (detail::has_ending(path, ".off")) return mesh_format::off;
  if (detail::has_ending(path, ".xml")) return mesh_format::body_xml;
  return std::nullopt;
}

/// The mesh in a file, whichever format it is. No other file is opened, whatever this one names.
/// gives   the error of load_file or of a format's reader, that of its name's ending where it has one
/// cost    the file's size in memory beside what the reader takes
template <Floating T = double>
result<mesh<T>> load_mesh(const std::string& path) {
  const auto bytes = load_file(path);
  if (!bytes) return bytes.error();
  const std::string_view text(*bytes);
  const std::optional<mesh_format> named = mesh_format_of_name(path);
  return named ? read_mesh<T>(text, *named) : read_mesh<T>(text);
}

/// The materials that an OBJ file's libraries hold; only libraries in the file's own folder are opened.
/// gives   the error of load_file or read_mtl; an error, and nothing opened, for a name that leads elsewhere, which
///         ./NAME does not
template <Floating T = double>
result<std::vector<mtl_material<T>>> load_materials(const std::string& path) {
  const auto text = load_file(path);
  if (!text) return text.error();
  const std::size_t slash = path.find_last_of("/\\");
  const std::string folder = slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
  return read_materials<T>(std::string_view(*text),
                           [&](std::string_view name) { return load_file(folder + std::string(name)); });
}

/// Writes a mesh file in the format that its name's ending asks for: true when that succeeded, else the reason, and
/// then the path is as it was before.
template <Floating T>
[[nodiscard]] result<void> save_mesh(const std::string& path, const mesh<T>& m,
                                     mesh_encoding encoding = mesh_encoding::text) {
  const std::optional<mesh_format> format = mesh_format_of_name(path);
  if (!format) return parse_error{0, 0, "body's file name must end in .obj, .stl, .ply, .off or .xml"};
  const auto bytes = encode_mesh(m, *format, encoding);
  if (!bytes) return parse_error{0, 0, bytes.error().message};
  return save_file(path, std::span<const std::uint8_t>(*bytes));
}

/// The old form of save_mesh: the reason of a failure, where save_mesh is true when the file was written.
template <Floating T>
[[nodiscard, deprecated("irg: use save_mesh, which is true when the file was written")]] std::optional<parse_error>
write_mesh(const std::string& path, const mesh<T>& m, mesh_encoding encoding = mesh_encoding::text) {
  const result<void> saved = save_mesh(path, m, encoding);
  return saved ? std::nullopt : std::optional(saved.error());
}

}  // namespace IRG_ABI

#if IRG_BODIES
namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API result<mesh<T>> read_mesh_as(std::string_view bytes, mesh_format format) {
  switch (format) {
    case mesh_format::stl: return read_stl<T>(bytes);
    case mesh_format::ply: return read_ply<T>(bytes);
    case mesh_format::off: return read_off<T>(bytes);
    case mesh_format::body_xml: {
      const auto bodies = read_body_xml<T>(bytes);
      if (!bodies) return bodies.error();
      return to_mesh(*bodies);
    }
    case mesh_format::obj: break;
  }
  return read_obj<T>(bytes);
}

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_COMPILED_ABI {

template <class Text>
[[nodiscard]] IRG_API mesh_format mesh_format_of(std::type_identity_t<Text> bytes) noexcept {
  if (detail::has_length_of_binary_stl(bytes)) return mesh_format::stl;
  bytes = detail::without_byte_order_mark(bytes);
  if (detail::text_cursor(bytes, '\0').word() == "ply") return mesh_format::ply;
  detail::text_cursor text(bytes, '#');
  if (text.skip_space() && *text.at == '<') return mesh_format::body_xml;
  const detail::off_header off = detail::off_header_of(bytes.substr(static_cast<std::size_t>(text.at - bytes.data())));
  if (off.length != 0) return mesh_format::off;
  if (detail::is_word(text.word(), "solid")) return mesh_format::stl;
  return mesh_format::obj;
}

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_mesh(const mesh<T>& m, mesh_format format,
                                                                                  mesh_encoding encoding) {
  if (format == mesh_format::stl) return encode_stl(m, encoding);
  if (format == mesh_format::ply) return encode_ply(m, encoding);
  if (encoding != mesh_encoding::text) return encode_error{"format has no binary form that is written"};
  if (format == mesh_format::off) return encode_off(m);
  if (format == mesh_format::obj) return encode_obj(m);
  if (const auto refused = detail::refuse_mesh(m)) return *refused;
  return encode_body_xml(std::vector{store_body<T>("body", m)});
}

}  // namespace IRG_COMPILED_ABI
#endif
}  // namespace irg
