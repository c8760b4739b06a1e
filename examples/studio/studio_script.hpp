// SPDX-License-Identifier: MIT
// Events of the studio as text, one on a line: what a script says, what a window makes of keys, and what the file of a
// state is made of. docs/render/studio.md has the words.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/text_cursor.hpp>
#include "studio_events.hpp"

namespace irg {

/// What a line asks for: an event, or something with a file, which is the caller's to do.
enum class studio_action { event, load, save, restore, picture };

/// A line of a script.
/// shape   `event` for an event; `file` for all else; `name`, which may be empty, for load; `view`, absent for both
///         views, for picture; line and column, from 1, where the line begins
template <Floating T>
struct studio_command {
  studio_action action = studio_action::event;
  studio_event<T> event{drop_body{}};
  part_name file, name;
  std::optional<studio_view> view;
  std::size_t line = 0, column = 0;
};

inline namespace IRG_ABI {

/// The commands of a script, a line each; # begins a comment.
/// gives   the first error with line and column: a word that is not known, a number that is none or not finite, a
///         transformation without a matrix, a line that ends too early or goes on. Whether a body of a name is there
///         only apply_event() knows
/// exact   numbers are correctly rounded to T
/// cost    linear; no line is kept
template <Floating T = double>
[[nodiscard]] constexpr result<std::vector<studio_command<T>>> read_studio_script(std::string_view text);

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

inline constexpr std::array<std::string_view, 2> studio_view_names{"main", "outer"};
inline constexpr std::array<std::string_view, 2> studio_stage_names{"before", "after"};
inline constexpr std::array<std::string_view, 2> display_names{"off", "on"};
inline constexpr std::array<std::string_view, 4> studio_part_names{"points", "edges", "faces", "backs"};
inline constexpr std::array<std::string_view, 4> studio_helper_names{"axes", "camera-axes", "camera", "pyramid"};
inline constexpr std::array<std::string_view, 4> studio_shading_names{"none", "flat", "gouraud", "phong"};

template <Floating T>
struct studio_script_reader {
  text_cursor cursor;

  constexpr explicit studio_script_reader(std::string_view text) noexcept : cursor(text, '#') {}

  constexpr bool follows(const char* message) noexcept {
    return cursor.skip_blanks() || cursor.fail(cursor.at, message);
  }

  /// A word, or what stands between quotes on one line. A star outside of them is no name.
  constexpr bool text(part_name& into, const char* message) {
    if (!follows(message)) return false;
    if (*cursor.at != '"') {
      into = part_name(cursor.word());
      return true;
    }
    const char* const first = ++cursor.at;
    while (!cursor.at_end() && *cursor.at != '"' && !is_line_break(*cursor.at)) ++cursor.at;
    if (cursor.at_end() || *cursor.at != '"') return cursor.fail(first - 1, "quotes do not end on their line");
    into = part_name(std::string_view(first, static_cast<std::size_t>(cursor.at - first)));
    if (into.empty()) return cursor.fail(first - 1, message);
    ++cursor.at;
    return cursor.at_word_end() || cursor.fail(cursor.at, "expected a blank behind quotes");
  }
  constexpr bool name(part_name& into) {
    const bool star = cursor.skip_blanks() && *cursor.at == '*';
    if (!text(into, "expected the name of a body, or * for all")) return false;
    if (star && into.size() == 1) into = {};
    return true;
  }

  constexpr bool number(T& into) noexcept {
    return follows("line ends where a number is expected") && cursor.number_here(into);
  }
  template <class V>
  constexpr bool triple(V& into) noexcept {
    return number(into[0]) && number(into[1]) && number(into[2]);
  }
  /// The place in a list, which a line counts from 1.
  constexpr bool place(std::size_t& into, const char* message = "transformations are counted from 1") noexcept {
    if (!follows("line ends where a number is expected")) return false;
    const char* const start = cursor.at;
    std::int64_t n = 0;
    if (!cursor.integer(n)) return false;
    if (n < 1) return cursor.fail(start, message);
    into = static_cast<std::size_t>(n) - 1;
    return true;
  }
  constexpr bool channel(std::uint8_t& into) noexcept {
    if (!follows("line ends where a number is expected")) return false;
    const char* const start = cursor.at;
    std::int64_t n = 0;
    if (!cursor.integer(n)) return false;
    if (n < 0 || n > 255) return cursor.fail(start, "part of a colour is not from 0 to 255");
    into = static_cast<std::uint8_t>(n);
    return true;
  }
  /// One of the words, as a value of their enum.
  template <class E, std::size_t N>
  constexpr bool choice(E& into, const std::array<std::string_view, N>& words, const char* message) noexcept {
    if (!follows(message)) return false;
    const char* const start = cursor.at;
    const std::string_view word = cursor.word();
    for (std::size_t i = 0; i < N; ++i)
      if (words[i] == word) return into = static_cast<E>(i), true;
    return cursor.fail(start, message);
  }
  constexpr bool view(studio_view& into) noexcept {
    return choice(into, studio_view_names, "view is neither main nor outer");
  }
  constexpr bool stage(studio_stage& into) noexcept {
    return choice(into, studio_stage_names, "expected before or after");
  }
  constexpr bool how(display& into) noexcept { return choice(into, display_names, "expected on or off"); }

  constexpr bool transformation(studio_transformation<T>& t) noexcept {
    constexpr const char* message = "transformation is not known";
    if (!follows(message)) return false;
    const char* const start = cursor.at;
    const std::string_view word = cursor.word();
    std::size_t k = 0;
    while (k < studio_maps.size() && studio_maps[k].name != word) ++k;
    if (k == studio_maps.size()) return cursor.fail(start, message);
    t.kind = static_cast<studio_map>(k);
    for (std::size_t i = 0; i < studio_maps[k].numbers; ++i)
      if (!number(t.numbers[i])) return false;
    return matrix_of(t).has_value() || cursor.fail(start, sentence_of(studio_status::no_matrix));
  }

  constexpr bool projection(studio_event<T>& out) {
    studio_view v{};
    constexpr const char* message = "projection is not known";
    if (!view(v) || !follows(message)) return false;
    const char* const start = cursor.at;
    const std::string_view word = cursor.word();
    set_projection<T> e{v};
    if (word == "isometric" || word == "dimetric" || word == "trimetric") {
      out = see_along<T>{v, (word[0] == 'i'   ? isometric<T>()
                             : word[0] == 'd' ? dimetric<T>()
                                              : trimetric<T>())
                                .to_viewer};
      return true;
    }
    if (word == "orthographic")
      e.kind = projection_kind::orthographic;
    else if (word == "cavalier" || word == "cabinet" || word == "oblique") {
      e.kind = projection_kind::oblique;
      if (word == "cavalier") e.oblique_factor = cavalier_factor<T>;
      if ((word == "oblique" || cursor.skip_blanks()) && !number(e.oblique_degrees)) return false;
      if (word == "oblique" && !number(e.oblique_factor)) return false;
    } else if (word != "perspective") {
      return cursor.fail(start, message);
    }
    out = e;
    return true;
  }

  /// Reads what stands behind the first word into an event of type E.
  template <class E, class... Read>
  constexpr bool event(studio_event<T>& out, const Read&... read) {
    E e{};
    if (!(read(e) && ...)) return false;
    out = std::move(e);
    return true;
  }

  constexpr bool command(studio_command<T>& c) {
    const char* const start = cursor.at;
    const std::string_view word = cursor.word();
    studio_event<T>& out = c.event;
    const auto named = [&](auto& e) { return name(e.name); };
    const auto viewed = [&](auto& e) { return view(e.view); };
    const auto staged = [&](auto& e) { return stage(e.stage); };
    const auto shown = [&](auto& e) { return how(e.how); };
    const auto file = [&](studio_action action) {
      c.action = action;
      return text(c.file, "expected the name of a file");
    };
    if (word == "load")
      return file(studio_action::load) && (!cursor.skip_blanks() || text(c.name, "expected the name of a body"));
    if (word == "save") return file(studio_action::save);
    if (word == "restore") return file(studio_action::restore);
    if (word == "picture") {
      studio_view v{};
      if (!file(studio_action::picture)) return false;
      if (!cursor.skip_blanks()) return true;
      if (!view(v)) return false;
      c.view = v;
      return true;
    }
    if (word == "drop") return event<drop_body>(out, named);
    if (word == "show")
      return event<show_part>(
          out, named,
          [&](auto& e) { return choice(e.part, studio_part_names, "part is none of points, edges, faces, backs"); },
          shown);
    if (word == "shade")
      return event<shade_body>(out, named, [&](auto& e) {
        return choice(e.shading, studio_shading_names, "shading is none of none, flat, gouraud, phong");
      });
    if (word == "opacity") return event<set_opacity<T>>(out, named, [&](auto& e) { return number(e.opacity); });
    if (word == "colour")
      return event<colour_body>(out, named, [&](auto& e) {
        e.colour.a = 255;
        return channel(e.colour.r) && channel(e.colour.g) && channel(e.colour.b);
      });
    if (word == "add")
      return event<add_transformation<T>>(out, named, staged,
                                          [&](auto& e) { return transformation(e.transformation); });
    if (word == "change")
      return event<change_transformation<T>>(
          out, named, staged, [&](auto& e) { return place(e.which) && transformation(e.transformation); });
    if (word == "move")
      return event<move_transformation>(out, named, staged, [&](auto& e) { return place(e.from) && place(e.to); });
    if (word == "remove")
      return event<remove_transformation>(out, named, staged, [&](auto& e) { return place(e.which); });
    if (word == "aim")
      return event<aim_camera<T>>(out, viewed, [&](auto& e) {
        return triple(e.eye) && triple(e.target) && (!cursor.skip_blanks() || triple(e.up));
      });
    if (word == "orbit")
      return event<orbit_camera<T>>(out, viewed, [&](auto& e) {
        return number(e.azimuth_degrees) && number(e.elevation_degrees) && (!cursor.skip_blanks() || number(e.factor));
      });
    if (word == "project") return projection(out);
    if (word == "pyramid")
      return event<set_pyramid<T>>(out, viewed, [&](auto& e) {
        view_pyramid<T>& p = e.pyramid;
        return number(p.distance) && number(p.width) && number(p.height) && number(p.near_distance) &&
               number(p.far_distance);
      });
    if (word == "helper")
      return event<show_helper>(
          out, viewed,
          [&](auto& e) {
            return choice(e.helper, studio_helper_names, "helper is none of axes, camera-axes, camera, pyramid");
          },
          shown);
    const auto at = [&](hpoint<T, 3>& p) { return number(p.x) && number(p.y) && number(p.z) && number(p.w); };
    if (word == "light") return event<set_light<T>>(out, [&](auto& e) { return at(e.lamp) && number(e.ambient); });
    if (word == "ambient") return event<set_ambient<T>>(out, [&](auto& e) { return number(e.ambient); });
    const auto lamp_number = [&](auto& e) { return place(e.which, "lamps are counted from 1"); };
    if (word == "lamp")
      return event<set_lamp<T>>(out, lamp_number, [&](auto& e) {
        rgb<T>& i = e.lamp.intensity;
        return at(e.lamp.position) && (!cursor.skip_blanks() || (number(i.r) && number(i.g) && number(i.b)));
      });
    if (word == "drop-lamp") return event<drop_lamp>(out, lamp_number);
    return cursor.fail(start, "line begins with a word that is not known");
  }
};

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr result<std::vector<studio_command<T>>> read_studio_script(std::string_view text) {
  std::vector<studio_command<T>> commands;
  text = detail::without_byte_order_mark(text);
  detail::studio_script_reader<T> reader(text);
  detail::text_cursor& cursor = reader.cursor;
  for (const char* last = cursor.at; cursor.skip_space(); last = cursor.at) {
    const auto behind = static_cast<std::size_t>(last - text.data());
    const parse_error here = detail::error_at(text.substr(behind), cursor.at, "");
    studio_command<T> c;
    c.line = here.line + (commands.empty() ? 0 : commands.back().line - 1);
    c.column = here.column;
    if (!reader.command(c)) return detail::error_at(text, cursor.place, cursor.message);
    if (cursor.skip_blanks()) return detail::error_at(text, cursor.at, "line goes on behind its end");
    commands.push_back(std::move(c));
  }
  return commands;
}

}  // namespace IRG_ABI
}  // namespace irg
