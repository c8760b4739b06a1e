// SPDX-License-Identifier: MIT
// Bodies as XML, in the form of the thesis: points, edges, faces, colours and surfaces, read and written. Works on
// memory only. docs/io/body_xml.md has the schema.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/scene/stored_body.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/detail/xml_reader.hpp>
#include <irg/math/decimal_digit.hpp>
#endif

namespace irg::inline IRG_COMPILED_ABI {

/// The bodies that an XML text describes, in its order.
/// needs   the text in memory, in UTF-8; it is not kept
/// gives   the first error with line and column: XML that is not well-formed, a document type, an entity, text that no
///         element with a prefix holds, more than 32 elements within each other or 32 attributes, an unknown element or
///         attribute without a prefix, a number, an index, a colour that is none. Each body's mesh passes validate()
/// exact   numbers are correctly rounded to T
/// cost    linear; no recursion; memory at most 64 times the text and 1 MiB
/// source  XML 1.0; Hank n.d., 3.1 (what is stored; it prints no schema, this one is irg's own)
template <Floating T = double>
[[nodiscard]] IRG_API result<std::vector<stored_body<T>>> read_body_xml(std::string_view text);

/// The bytes of an XML file that describes the bodies, in UTF-8.
/// gives   an error when a body's mesh does not pass validate(), an edge or a face names what does not exist, a share
///         of the light is negative or not finite, or a name holds bytes that XML does not allow
/// exact   read_body_xml<T> of the bytes gives the same bodies again, if their meshes have positions and faces only
/// cost    linear
/// source  XML 1.0
template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_body_xml(
    std::span<const stored_body<T>> bodies);

}  // namespace irg::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_body_xml(
    const std::vector<stored_body<T>>& bodies) {
  return encode_body_xml(std::span<const stored_body<T>>(bodies));
}

/// One mesh of several bodies; each is a part, whose object is the body's name.
/// needs   fewer than 2^32 points and corners in all
template <Floating T>
[[nodiscard]] constexpr mesh<T> to_mesh(const std::vector<stored_body<T>>& bodies) {
  mesh<T> all;
  for (const stored_body<T>& b : bodies) {
    const auto points = static_cast<std::uint32_t>(all.positions.size());
    const auto corners = static_cast<std::uint32_t>(all.corners.size());
    const std::size_t faces = all.face_count();
    for (const point<T, 3>& p : b.shape.positions) all.positions.push_back(p);
    for (const mesh_corner& c : b.shape.corners) all.corners.push_back({c.position + points, no_index, no_index});
    for (std::size_t f = 1; f < b.shape.face_starts.size(); ++f)
      all.face_starts.push_back(b.shape.face_starts[f] + corners);
    if (b.shape.face_count() != 0) all.parts.push_back({b.name, {}, {}, faces, b.shape.face_count()});
  }
  return all;
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The bodies of an XML text, as docs/io/body_xml.md describes it. Elements and attributes of other namespaces are
// passed over with all they hold; unknown ones without a prefix are errors.

template <Floating T>
struct body_xml_reader {
  xml_reader xml;
  std::vector<stored_body<T>> bodies{};

  constexpr explicit body_xml_reader(std::string_view text) noexcept : xml(text) {}

  constexpr bool fail(const char* place, const char* message) noexcept { return xml.cursor.fail(place, message); }

  constexpr bool document() {
    if (xml.next() != xml_event::begin) return false;
    if (xml.name == "body") {
      if (!body()) return false;
    } else {
      if (xml.name != "bodies") return fail(xml.name.data(), "first element is neither bodies nor body");
      if (!only({})) return false;
      if (!children([&] { return xml.name == "body" ? body() : unknown(); })) return false;
    }
    return xml.next() == xml_event::done;
  }

  /// Calls child() for each element within the one that has begun, up to its end.
  template <class Child>
  constexpr bool children(const Child& child) {
    const std::size_t level = xml.depth;
    for (;;) {
      const xml_event e = xml.next();
      if (e == xml_event::end && xml.depth < level) return true;
      if (e == xml_event::end) continue;
      if (e != xml_event::begin) return false;
      if (xml.name.find(':') != std::string_view::npos ? !pass_over() : !child()) return false;
    }
  }
  constexpr bool pass_over() noexcept {
    xml.passes_over_text = true;
    for (const std::size_t level = xml.depth; xml.depth >= level;)
      if (const xml_event e = xml.next(); e == xml_event::error) return false;
    xml.passes_over_text = false;
    return true;
  }
  constexpr bool unknown() noexcept { return fail(xml.name.data(), "element is not known here"); }
  constexpr bool nothing_within() {
    return children([&] { return unknown(); });
  }

  /// Whether the element has no attributes but these and those of other namespaces.
  constexpr bool only(std::initializer_list<std::string_view> known) noexcept {
    for (std::size_t i = 0; i < xml.attribute_count; ++i) {
      const std::string_view name = xml.attributes[i].name;
      bool found = name.find(':') != std::string_view::npos || name == "xmlns";
      for (const std::string_view k : known) found = found || k == name;
      if (!found) return fail(name.data(), "attribute is not known here");
    }
    return true;
  }

  constexpr bool body() {
    if (!only({"name"})) return false;
    stored_body<T> b;
    b.name = resolved_value(xml.attribute("name"));
    bool has_points = false, has_faces = false;
    const char* const start = xml.name.data();
    const auto section = [&] {
      if (!only({})) return false;
      if (xml.name == "surfaces") return children([&] { return xml.name == "surface" ? surface(b) : unknown(); });
      if (xml.name == "edges") return children([&] { return xml.name == "edge" ? edge(b) : unknown(); });
      if (xml.name == "points") {
        has_points = true;
        return children([&] { return xml.name == "point" ? point_of(b) : unknown(); });
      }
      if (xml.name != "faces") return unknown();
      has_faces = true;
      return children([&] { return xml.name == "face" ? face(b) : unknown(); });
    };
    if (!children(section)) return false;
    if (!has_points || !has_faces) return fail(start, "body has no points or no faces");
    bodies.push_back(std::move(b));
    return true;
  }

  /// The numbers of an attribute, `count` of them.
  constexpr bool numbers(std::string_view attribute, T* into, int count) noexcept {
    const std::string_view value = xml.attribute(attribute);
    if (value.data() == nullptr) return fail(xml.name.data(), "element lacks an attribute");
    text_cursor text(value, '\0');
    for (int i = 0; i < count; ++i) {
      if (!text.skip_space()) return fail(text.at, "attribute has too few numbers");
      if (!text.number_here(into[i])) return fail(text.place, text.message);
    }
    return !text.skip_space() || fail(text.at, "attribute has too many numbers");
  }

  /// Calls take(index) for each number of an attribute, which must be smaller than the limit; says how many, -1 when
  /// one is not.
  template <class Take>
  constexpr std::int64_t indices(std::string_view attribute, std::size_t limit, const char* beyond, const Take& take) {
    const std::string_view value = xml.attribute(attribute);
    if (value.data() == nullptr) return fail(xml.name.data(), "element lacks an attribute"), -1;
    text_cursor text(value, '\0');
    std::int64_t count = 0;
    for (; text.skip_space(); ++count) {
      const char* const start = text.at;
      std::int64_t index = 0;
      if (!text.integer(index)) return fail(text.place, text.message), -1;
      if (index < 0 || static_cast<std::uint64_t>(index) >= limit) return fail(start, beyond), -1;
      take(static_cast<std::uint32_t>(index));
    }
    return count;
  }

  constexpr bool point_of(stored_body<T>& b) {
    if (!only({"x", "y", "z"})) return false;
    point<T, 3> p;
    if (!numbers("x", &p[0], 1) || !numbers("y", &p[1], 1) || !numbers("z", &p[2], 1)) return false;
    b.shape.positions.push_back(p);
    return nothing_within();
  }

  static constexpr const char* no_point = "point is none of those that stand before";

  constexpr bool edge(stored_body<T>& b) {
    if (!only({"points"})) return false;
    std::uint32_t ends[2] = {};
    std::size_t given = 0;
    const std::int64_t count = indices("points", b.shape.positions.size(), no_point, [&](std::uint32_t i) {
      if (given < 2) ends[given++] = i;
    });
    if (count < 0) return false;
    if (count != 2) return fail(xml.name.data(), "edge has other than two points");
    b.edges.push_back({ends[0], ends[1]});
    return nothing_within();
  }

  constexpr bool face(stored_body<T>& b) {
    if (!only({"points", "surface"})) return false;
    const char* const start = xml.name.data();
    const std::int64_t count = indices("points", b.shape.positions.size(), no_point,
                                       [&](std::uint32_t i) { b.shape.corners.push_back({i, no_index, no_index}); });
    if (count < 0) return false;
    if (count < 3) return fail(start, "face has fewer than three corners");
    b.shape.face_starts.push_back(static_cast<std::uint32_t>(b.shape.corners.size()));
    std::uint32_t which = no_index;
    if (xml.attribute("surface").data() != nullptr) {
      const char* const beyond = "surface is none of those that stand before";
      const std::int64_t named = indices("surface", b.surfaces.size(), beyond, [&](std::uint32_t i) { which = i; });
      if (named < 0) return false;
      if (named != 1) return fail(start, "face has other than one surface");
    }
    b.surface_of_face.push_back(which);
    return nothing_within();
  }

  constexpr bool surface(stored_body<T>& b) {
    if (!only({"colour", "ambient", "diffuse", "specular", "shininess"})) return false;
    stored_surface<T> s;
    const std::string_view colour = xml.attribute("colour");
    if (colour.data() != nullptr && !colour_of(colour, s.colour)) return false;
    const auto share = [&](std::string_view name, rgb<T>& into) {
      const std::string_view value = xml.attribute(name);
      T n[3] = {into.r, into.g, into.b};
      if (value.data() == nullptr) return true;
      if (!numbers(name, n, 3)) return false;
      if (n[0] < 0 || n[1] < 0 || n[2] < 0) return fail(value.data(), "share of the light is negative");
      into = {n[0], n[1], n[2]};
      return true;
    };
    material<T>& m = s.reflection;
    if (!share("ambient", m.ambient) || !share("diffuse", m.diffuse) || !share("specular", m.specular)) return false;
    const std::string_view shininess = xml.attribute("shininess");
    if (shininess.data() != nullptr && !numbers("shininess", &m.shininess, 1)) return false;
    if (!(m.shininess > 0)) return fail(shininess.data(), "shininess is not larger than 0");
    b.surfaces.push_back(s);
    return nothing_within();
  }

  /// #rrggbb or #rrggbbaa.
  constexpr bool colour_of(std::string_view value, rgba8& into) noexcept {
    std::uint8_t bytes[4] = {0, 0, 0, 255};
    bool good = (value.size() == 7 || value.size() == 9) && value[0] == '#';
    for (std::size_t i = 1; good && i < value.size(); ++i) {
      const char c = value[i], lower = static_cast<char>(c | 0x20);
      const bool letter = lower >= 'a' && lower <= 'f';
      good = letter || is_decimal_digit(c);
      const unsigned digit = letter ? static_cast<unsigned>(lower - 'a') + 10 : decimal_digit_value(c);
      std::uint8_t& byte = bytes[(i - 1) / 2];
      byte = static_cast<std::uint8_t>(i % 2 == 1 ? digit << 4 : byte | digit);
    }
    into = {bytes[0], bytes[1], bytes[2], bytes[3]};
    return good || fail(value.data(), "colour is not written as #rrggbb or #rrggbbaa");
  }
};

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
    if (s != no_index && s >= b.surfaces.size()) return encode_error{"body has a face whose surface does not exist"};
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
  const auto share = [&](std::string_view name, const rgb<T>& c) { append_all(out, name, c.r, " ", c.g, " ", c.b); };
  share("\" ambient=\"", s.reflection.ambient);
  share("\" diffuse=\"", s.reflection.diffuse);
  share("\" specular=\"", s.reflection.specular);
  append_all(out, "\" shininess=\"", s.reflection.shininess, "\"/>\n");
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
      append_all(out, i == 0 ? "      <point x=\"" : i == 1 ? "\" y=\"" : "\" z=\"", p[i]);
      if (i == 2) append_text(out, "\"/>\n");
    }
  append_text(out, "    </points>\n    <edges>\n");
  for (const stored_edge& e : b.edges) {
    append_all(out, "      <edge points=\"", e.from, " ", e.to, "\"/>\n");
  }
  append_text(out, "    </edges>\n    <faces>\n");
  for (std::size_t f = 0; f < b.shape.face_count(); ++f) {
    append_text(out, "      <face points=\"");
    for (std::size_t k = 0; k < b.shape.face_size(f); ++k) {
      if (k != 0) append_text(out, " ");
      append_number(out, b.shape.corner(f, k).position);
    }
    if (b.surface_of_face[f] != no_index) {
      append_all(out, "\" surface=\"", b.surface_of_face[f]);
    }
    append_text(out, "\"/>\n");
  }
  append_text(out, "    </faces>\n  </body>\n");
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<stored_body<T>>> read_body_xml(std::string_view text) {
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

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_body_xml(
    std::span<const stored_body<T>> bodies) {
  for (const stored_body<T>& b : bodies)
    if (const auto refused = detail::refuse_body(b)) return *refused;
  std::vector<std::uint8_t> out;
  detail::append_text(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<bodies>\n");
  for (const stored_body<T>& b : bodies) detail::write_body(out, b);
  detail::append_text(out, "</bodies>\n");
  return out;
}

IRG_RENAMED(mesh_of_bodies, to_mesh)

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
