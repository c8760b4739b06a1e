// SPDX-License-Identifier: MIT
// The bodies of an XML text, as docs/io/body_xml.md describes it. Elements and attributes of other namespaces are
// passed over with all they hold; unknown ones without a prefix are errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/io/detail/xml_reader.hpp>
#include <irg/math/decimal_digit.hpp>
#include <irg/scene/stored_body.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

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
    const std::int64_t count = indices("points", b.shape.positions.size(), no_point, [&](std::uint32_t i) {
      b.shape.corners.push_back({i, mesh_corner::none, mesh_corner::none});
    });
    if (count < 0) return false;
    if (count < 3) return fail(start, "face has fewer than three corners");
    b.shape.face_starts.push_back(static_cast<std::uint32_t>(b.shape.corners.size()));
    std::uint32_t which = stored_body<T>::no_surface;
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

}  // namespace IRG_ABI
}  // namespace irg::detail
