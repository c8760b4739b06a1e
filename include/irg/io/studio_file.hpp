// SPDX-License-Identifier: MIT
// The state of a studio as XML: the bodies as in any file of bodies, and the events, line by line, that make the rest
// of the state. Other readers of bodies pass over the events, whose elements have a prefix.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/io/body_xml.hpp>
#include <irg/io/studio_script.hpp>
#include <irg/io/detail/studio_file_steps.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The bytes of an XML file that holds the whole state of a studio, in UTF-8; read_body_xml reads its bodies.
/// gives   the error of encode_body_xml: a studio that apply_event() has made has none but for names that are no UTF-8
/// exact   read_studio<T> of the bytes gives the same studio
/// cost    linear
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

/// The studio that an XML text holds. A file of bodies alone is one, too: its bodies in a new studio.
/// gives   the first error with line and column: of the bodies as read_body_xml; an event that is none, names a file or
///         cannot be. No part of a state comes out
/// exact   numbers are correctly rounded to T
/// cost    linear, and for each event the number of bodies
template <Floating T = double>
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
