// SPDX-License-Identifier: MIT
// Bodies as XML, in the form of the thesis: points, edges, faces, colours and surfaces, read and written. Works on
// memory only. docs/io/body_xml.md has the schema.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/core/result.hpp>
#include <irg/io/detail/body_xml_reader.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/scene/stored_body.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The bodies that an XML text describes, in its order.
/// needs   the text in memory, in UTF-8; it is not kept
/// gives   the first error with line and column: XML that is not well-formed, a document type, an entity, text that no
///         element with a prefix holds, more than 32 elements within each other or 32 attributes, an unknown element or
///         attribute without a prefix, a number, an index, a colour that is none. Each body's mesh passes validate()
/// exact   numbers are correctly rounded to T
/// cost    linear; no recursion; memory at most 64 times the text and 1 MiB
/// source  XML 1.0; Hank n.d., 3.1 (what is stored; it prints no schema, this one is irg's own)
template <Floating T = double>
[[nodiscard]] constexpr result<std::vector<stored_body<T>>> read_body_xml(std::string_view text) {
  if (const auto too_long = detail::refuse_long_file(text)) return *too_long;
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return parse_error{0, 0, "text is UTF-16, but bodies are read as UTF-8"};
  text = detail::without_byte_order_mark(text);
  if (const std::size_t bad = detail::first_bad_byte(text); bad != text.size())
    return detail::error_at(text, text.data() + bad, "byte is no part of a character of UTF-8 that XML allows");
  detail::body_xml_reader<T> reader(text);
  if (!reader.document()) return detail::error_at(text, reader.xml.cursor.place, reader.xml.cursor.message);
  return std::move(reader.bodies);
}

/// One mesh of several bodies; each is a part, whose object is the body's name.
/// needs   fewer than 2^32 points and corners in all
template <Floating T>
[[nodiscard]] constexpr mesh<T> mesh_of_bodies(const std::vector<stored_body<T>>& bodies) {
  mesh<T> all;
  for (const stored_body<T>& b : bodies) {
    const auto points = static_cast<std::uint32_t>(all.positions.size());
    const auto corners = static_cast<std::uint32_t>(all.corners.size());
    const std::size_t faces = all.face_count();
    for (const point<T, 3>& p : b.shape.positions) all.positions.push_back(p);
    for (const mesh_corner& c : b.shape.corners)
      all.corners.push_back({c.position + points, mesh_corner::none, mesh_corner::none});
    for (std::size_t f = 1; f < b.shape.face_starts.size(); ++f)
      all.face_starts.push_back(b.shape.face_starts[f] + corners);
    if (b.shape.face_count() != 0) all.parts.push_back({b.name, {}, {}, faces, b.shape.face_count()});
  }
  return all;
}

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

/// Appends a value in quotes, with references for what would end it or change on reading.
template <class Bytes>
constexpr void append_value(Bytes& out, std::string_view value) {
  append_text(out, "\"");
  for (const char c : value) {
    switch (c) {
      case '&': append_text(out, "&amp;"); break;
      case '<': append_text(out, "&lt;"); break;
      case '"': append_text(out, "&quot;"); break;
      case '\t': append_text(out, "&#9;"); break;
      case '\n': append_text(out, "&#10;"); break;
      case '\r': append_text(out, "&#13;"); break;
      default: out.push_back(static_cast<std::uint8_t>(c));
    }
  }
  append_text(out, "\"");
}

template <Floating T>
constexpr std::optional<encode_error> refuse_body(const stored_body<T>& b) noexcept {
  if (const auto refused = refuse_mesh(b.shape)) return refused;
  const std::string_view name = b.name;
  if (first_bad_byte(name) != name.size()) return encode_error{"body's name holds bytes that XML does not allow"};
  for (const stored_edge& e : b.edges)
    if (e.from >= b.shape.positions.size() || e.to >= b.shape.positions.size())
      return encode_error{"body has an edge without a point"};
  if (b.surface_of_face.size() != b.shape.face_count())
    return encode_error{"body has not one entry of surface_of_face for each face"};
  for (const std::uint32_t s : b.surface_of_face)
    if (s != stored_body<T>::no_surface && s >= b.surfaces.size())
      return encode_error{"body has a face whose surface does not exist"};
  for (const stored_surface<T>& s : b.surfaces) {
    const material<T>& m = s.reflection;
    for (const T x : {m.ambient.r, m.ambient.g, m.ambient.b, m.diffuse.r, m.diffuse.g, m.diffuse.b, m.specular.r,
                      m.specular.g, m.specular.b})
      if (!(x >= 0 && is_finite(x))) return encode_error{"body has a surface whose shares of the light are none"};
    if (!(m.shininess > 0 && is_finite(m.shininess)))
      return encode_error{"body has a surface whose shininess is not larger than 0"};
  }
  return std::nullopt;
}

template <class Bytes, Floating T>
constexpr void write_surface(Bytes& out, const stored_surface<T>& s) {
  append_text(out, "      <surface colour=\"#");
  for (const std::uint8_t byte : {s.colour.r, s.colour.g, s.colour.b, s.colour.a})
    for (const int digit : {byte >> 4, byte & 15})
      out.push_back(static_cast<std::uint8_t>(digit < 10 ? '0' + digit : 'a' + digit - 10));
  const auto share = [&](std::string_view name, const rgb<T>& c) {
    append_text(out, name);
    append_number(out, c.r);
    append_text(out, " ");
    append_number(out, c.g);
    append_text(out, " ");
    append_number(out, c.b);
  };
  share("\" ambient=\"", s.reflection.ambient);
  share("\" diffuse=\"", s.reflection.diffuse);
  share("\" specular=\"", s.reflection.specular);
  append_text(out, "\" shininess=\"");
  append_number(out, s.reflection.shininess);
  append_text(out, "\"/>\n");
}

template <class Bytes, Floating T>
constexpr void write_body(Bytes& out, const stored_body<T>& b) {
  append_text(out, "  <body name=");
  append_value(out, b.name);
  append_text(out, ">\n    <surfaces>\n");
  for (const stored_surface<T>& s : b.surfaces) write_surface(out, s);
  append_text(out, "    </surfaces>\n    <points>\n");
  for (const point<T, 3>& p : b.shape.positions)
    for (int i = 0; i < 3; ++i) {
      append_text(out, i == 0 ? "      <point x=\"" : i == 1 ? "\" y=\"" : "\" z=\"");
      append_number(out, p[i]);
      if (i == 2) append_text(out, "\"/>\n");
    }
  append_text(out, "    </points>\n    <edges>\n");
  for (const stored_edge& e : b.edges) {
    append_text(out, "      <edge points=\"");
    append_number(out, e.from);
    append_text(out, " ");
    append_number(out, e.to);
    append_text(out, "\"/>\n");
  }
  append_text(out, "    </edges>\n    <faces>\n");
  for (std::size_t f = 0; f < b.shape.face_count(); ++f) {
    append_text(out, "      <face points=\"");
    for (std::size_t k = 0; k < b.shape.face_size(f); ++k) {
      if (k != 0) append_text(out, " ");
      append_number(out, b.shape.corner(f, k).position);
    }
    if (b.surface_of_face[f] != stored_body<T>::no_surface) {
      append_text(out, "\" surface=\"");
      append_number(out, b.surface_of_face[f]);
    }
    append_text(out, "\"/>\n");
  }
  append_text(out, "    </faces>\n  </body>\n");
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The bytes of an XML file that describes the bodies, in UTF-8.
/// gives   an error when a body's mesh does not pass validate(), an edge or a face names what does not exist, a share
///         of the light is negative or not finite, or a name holds bytes that XML does not allow
/// exact   read_body_xml<T> of the bytes gives the same bodies again, if their meshes have positions and faces only
/// cost    linear
/// source  XML 1.0
template <Floating T>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_body_xml(
    std::span<const stored_body<T>> bodies) {
  for (const stored_body<T>& b : bodies)
    if (const auto refused = detail::refuse_body(b)) return *refused;
  std::vector<std::uint8_t> out;
  detail::append_text(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<bodies>\n");
  for (const stored_body<T>& b : bodies) detail::write_body(out, b);
  detail::append_text(out, "</bodies>\n");
  return out;
}
template <Floating T>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_body_xml(
    const std::vector<stored_body<T>>& bodies) {
  return encode_body_xml(std::span<const stored_body<T>>(bodies));
}

}  // namespace IRG_ABI
}  // namespace irg
