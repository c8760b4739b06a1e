// SPDX-License-Identifier: MIT
// The state of a studio as XML: the bodies as in any file of bodies, and the events, line by line, that make the rest
// of the state. Other readers of bodies pass over the events, whose elements have a prefix.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/io/body_xml.hpp>

#include "studio_script.hpp"

namespace irg {
inline namespace IRG_ABI {

/// The bytes of an XML file that holds the whole state of a studio, in UTF-8; read_body_xml reads its bodies.
/// gives   the error of encode_body_xml: a studio that apply_event() has made has none but for names that are no UTF-8
/// exact   read_studio<T> of the bytes gives the same studio
/// cost    linear
template <Floating T>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_studio(const studio<T>& s);

/// The studio that an XML text holds. A file of bodies alone is one, too: its bodies in a new studio.
/// gives   the first error with line and column: of the bodies as read_body_xml; an event that is none, names a file or
///         cannot be. No part of a state comes out
/// exact   numbers are correctly rounded to T
/// cost    linear, and for each event the number of bodies
template <Floating T = double>
[[nodiscard]] constexpr result<studio<T>> read_studio(std::string_view text);

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

/// Writes the lines of events, each as an element.
template <Floating T>
struct studio_writer {
  using bytes = std::vector<std::uint8_t>;
  bytes out{};

  /// A line of words, names in quotes and numbers.
  template <class... Words>
  constexpr void line(const Words&... words) {
    bytes one;
    (word(one, words), ...);
    append_text(out, "    <studio:event line=");
    append_value(out, std::string_view(reinterpret_cast<const char*>(one.data()), one.size()));
    append_text(out, "/>\n");
  }
  static constexpr void word(bytes& to, std::string_view w) {
    if (!to.empty()) append_text(to, " ");
    append_text(to, w);
  }
  static constexpr void word(bytes& to, const char* w) { word(to, std::string_view(w)); }
  static constexpr void word(bytes& to, const part_name& name) {
    append_text(to, " \"");
    append_text(to, name);
    append_text(to, "\"");
  }
  static constexpr void word(bytes& to, T x) { append_numbers(to, &x, 1); }
  static constexpr void word(bytes& to, std::size_t n) { append_numbers(to, &n, 1); }
  static constexpr void word(bytes& to, const point<T, 3>& p) { append_numbers(to, p, 3); }
  static constexpr void word(bytes& to, const vec<T, 3>& v) { append_numbers(to, v, 3); }
  static constexpr void word(bytes& to, const std::array<T, 4>& p) { append_numbers(to, p.data(), 4); }
  static constexpr void word(bytes& to, const studio_transformation<T>& t) {
    const studio_map_form& form = studio_maps[static_cast<std::size_t>(t.kind)];
    word(to, form.name);
    append_numbers(to, t.numbers.data(), static_cast<int>(form.numbers));
  }
  template <class E, std::size_t N>
  static constexpr std::string_view name_of(const std::array<std::string_view, N>& names, E e) noexcept {
    return names[static_cast<std::size_t>(e)];
  }

  constexpr void body(const studio_body<T>& b) {
    const part_name& name = b.body.name;
    for (std::size_t i = 0; i < b.parts.size(); ++i)
      line("show", name, studio_part_names[i], name_of(display_names, b.parts[i]));
    line("shade", name, name_of(studio_shading_names, b.shading));
    line("opacity", name, b.opacity);
    for (std::size_t i = 0; i < b.transformations.size(); ++i)
      for (const studio_transformation<T>& t : b.transformations[i]) line("add", name, studio_stage_names[i], t);
  }

  // A white lamp alone is one line, which readers before several lamps know, too.
  constexpr void lamps(const std::vector<light<T>>& all, T ambient) {
    const auto place = [&](std::size_t i) {
      const hpoint<T, 3>& p = all[i].position;
      return std::array<T, 4>{p.x, p.y, p.z, p.w};
    };
    const bool plain = all.size() == 1 && all[0].intensity == rgb<T>{T(1), T(1), T(1)};
    if (plain) return line("light", place(0), ambient);
    line("ambient", ambient);
    if (all.empty()) line("drop-lamp", std::size_t{1});
    for (std::size_t i = 0; i < all.size(); ++i) {
      const rgb<T>& colour = all[i].intensity;
      line("lamp", i + 1, place(i), colour.r, colour.g, colour.b);
    }
  }

  // The camera must be one behind each line. So the oblique projection comes first, before an eye and a pyramid that
  // make every factor possible, and a pyramid that no perspective has comes behind a parallel projection, at the
  // smaller of two distances; one of a perspective, behind its eye. The projection that is used comes last.
  constexpr void camera(std::string_view view, const studio_camera<T>& c) {
    const view_pyramid<T>& p = c.pyramid;
    const auto aim = [&] { line("aim", view, c.eye, c.target, c.up); };
    const bool in_perspective = c.projection == projection_kind::perspective;
    const bool aims_first = in_perspective || length(c.target - c.eye) < T(1);
    line("aim", view, point<T, 3>{T(0), T(0), T(1)}, point<T, 3>{});
    line("pyramid", view, T(1), T(4), T(4), T(1), T(2));
    line("project", view, "oblique", c.oblique_degrees, c.oblique_factor);
    line("project", view, in_perspective ? "perspective" : "orthographic");
    if (aims_first) aim();
    line("pyramid", view, p.distance, p.width, p.height, p.near_distance, p.far_distance);
    if (!aims_first) aim();
    if (c.projection == projection_kind::oblique) line("project", view, "oblique", c.oblique_degrees, c.oblique_factor);
    for (std::size_t i = 0; i < c.helpers.size(); ++i)
      line("helper", view, studio_helper_names[i], name_of(display_names, c.helpers[i]));
  }
};

/// Where the name of a body's element stands in the text.
/// needs   a text that read_body_xml reads, with more bodies than `number`
constexpr const char* place_of_body(std::string_view text, std::size_t number) noexcept {
  xml_reader xml(text);
  xml.passes_over_text = true;
  for (;;)
    if (xml.next() == xml_event::begin && xml.name == "body" && xml.depth <= 2 && number-- == 0) return xml.name.data();
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_studio(const studio<T>& s) {
  std::vector<stored_body<T>> bodies;
  bodies.reserve(s.bodies.size());
  for (const studio_body<T>& b : s.bodies) bodies.push_back(b.body);
  auto xml = encode_body_xml(bodies);
  if (!xml) return xml.error();
  constexpr std::string_view end = "</bodies>\n";
  detail::studio_writer<T> writer{std::move(*xml)};
  writer.out.resize(writer.out.size() - end.size());
  detail::append_text(writer.out, "  <studio:state xmlns:studio=\"urn:irg:studio\">\n");
  for (std::size_t i = 0; i < s.cameras.size(); ++i) writer.camera(detail::studio_view_names[i], s.cameras[i]);
  writer.lamps(s.lamps, s.ambient);
  for (const studio_body<T>& b : s.bodies) writer.body(b);
  detail::append_text(writer.out, "  </studio:state>\n");
  detail::append_text(writer.out, end);
  return std::move(writer.out);
}

template <Floating T>
[[nodiscard]] constexpr result<studio<T>> read_studio(std::string_view text) {
  auto bodies = read_body_xml<T>(text);
  if (!bodies) return bodies.error();
  studio<T> s;
  text = detail::without_byte_order_mark(text);
  for (std::size_t i = 0; i < bodies->size(); ++i)
    if (const studio_status bad = apply_event(s, load_body<T>{std::move((*bodies)[i])}); bad != studio_status::done)
      return detail::error_at(text, detail::place_of_body(text, i), sentence_of(bad));
  detail::xml_reader xml(text);  // which read_body_xml has found to be sound
  xml.passes_over_text = true;
  for (detail::xml_event e = xml.next(); e != detail::xml_event::done; e = xml.next()) {
    if (e == detail::xml_event::error) return detail::error_at(text, xml.cursor.place, xml.cursor.message);
    if (e != detail::xml_event::begin || xml.name != "studio:event") continue;
    const std::string_view line = xml.attribute("line");
    const char* const place = line.data() == nullptr ? xml.name.data() : line.data();
    const auto fail = [&](const char* message) { return detail::error_at(text, place, message); };
    const auto commands = read_studio_script<T>(std::string_view(detail::resolved_value(line)));
    if (!commands) return fail(commands.error().message);
    if (commands->size() != 1 || (*commands)[0].action != studio_action::event) return fail("line is not one event");
    if (const studio_status bad = apply_event(s, (*commands)[0].event); bad != studio_status::done)
      return fail(sentence_of(bad));
  }
  return s;
}

}  // namespace IRG_ABI
}  // namespace irg
