// SPDX-License-Identifier: MIT
// The studio's panel of a view's properties: the camera, how it projects, helpers, the looks of a body, light, files.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "studio_panels.hpp"

namespace program {

namespace panel {

inline constexpr std::array<const char*, 4> part_names{"points", "edges", "faces", "backs"};
inline constexpr std::array<const char*, 4> helper_names{"axes", "camera-axes", "camera", "pyramid"};
inline constexpr std::array<const char*, 4> shading_names{"none", "flat", "gouraud", "phong"};

inline std::string switched(irg::display d) { return d == irg::display::shown ? " off" : " on"; }

inline std::string aim_line(const std::string& view, const irg::studio_camera<double>& c) {
  return "aim " + view + words_of(c.eye) + words_of(c.target) + words_of(c.up);
}

inline void camera_rows(panel_rows& rows, const irg::studio<double>& s, const studio_choice& choice) {
  const irg::studio_camera<double>& c = s.of(choice.view);
  const std::string view = name_of(choice.view);
  const auto triple = [&](const char* label, const auto& part) {
    row_writer row(rows);
    row.label(label, 70);
    for (int k = 0; k < 3; ++k)
      row.value(
          part(c)[k], 86,
          [&](double v) {
            auto other = c;
            part(other)[k] = v;
            return aim_line(view, other);
          },
          by(0.25));
  };
  triple("eye", [](auto& one) -> auto& { return one.eye; });
  triple("target", [](auto& one) -> auto& { return one.target; });
  triple("up", [](auto& one) -> auto& { return one.up; });
  const irg::camera_frame<double> f = irg::look_at_frame(c.eye, c.target, c.up);
  const std::pair<const char*, irg::vec<double, 3>> axes[] = {
      {"x axis", f.right}, {"y axis", f.up}, {"z axis", f.forward}};
  for (const auto& [label, axis] : axes) {
    row_writer row(rows);
    row.label(label, 70);
    for (int k = 0; k < 3; ++k) row.reading(shown(axis[k], 3), 86);
  }
}

inline void projection_rows(panel_rows& rows, const irg::studio<double>& s, const studio_choice& choice) {
  const irg::studio_camera<double>& c = s.of(choice.view);
  const std::string view = name_of(choice.view), start = "project " + view + " ";
  row_writer kinds(rows);
  kinds.label("project", 70);
  constexpr std::pair<const char*, int> main_kinds[] = {{"perspective", 92}, {"orthographic", 100}, {"oblique", 66}};
  for (int k = 0; k < 3; ++k)
    kinds.change(main_kinds[k].first, main_kinds[k].second, static_cast<int>(c.projection) == k,
                 start + main_kinds[k].first +
                     (k == 2 ? words_of(std::array{c.oblique_degrees, c.oblique_factor}) : std::string()));
  row_writer more(rows);
  more.skip(12);
  for (const char* kind : {"cavalier", "cabinet", "isometric", "dimetric", "trimetric"})
    more.button(kind, 63, start + kind);
  const auto oblique = [&](double angle, double factor) {
    return start + "oblique " + shortest(angle) + " " + shortest(factor);
  };
  row_writer(rows)
      .label("oblique", 70)
      .reading("angle", 47)
      .value(
          c.oblique_degrees, 82, [&](double v) { return oblique(v, c.oblique_factor); }, by(5))
      .reading("factor", 47)
      .value(c.oblique_factor, 82, [&](double v) { return oblique(c.oblique_degrees, v); }, by(0.1));
  const irg::view_pyramid<double>& p = c.pyramid;
  const std::array<double, 5> numbers{p.distance, p.width, p.height, p.near_distance, p.far_distance};
  row_writer names(rows);
  names.label("pyramid", 70);
  for (const char* name : {"screen", "width", "height", "near", "far"}) names.reading(name, 52);
  row_writer pyramid(rows);
  pyramid.skip(70);
  for (std::size_t k = 0; k < 5; ++k)
    pyramid.value(
        numbers[k], 52,
        [&](double v) {
          auto other = numbers;
          other[k] = v;
          return "pyramid " + view + words_of(other);
        },
        grown);
  row_writer helpers(rows);
  helpers.label("show", 70);
  constexpr int widths[] = {46, 92, 60, 60};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string name(helper_names[k]);
    helpers.change(name, widths[k], c.helpers[k] == irg::display::shown,
                   joined({"helper ", view, " ", name, switched(c.helpers[k])}));
  }
}

inline void look_rows(panel_rows& rows, const body& b) {
  const std::string name = quoted(b);
  row_writer(rows).heading("Body " + std::string(b.body.name));
  row_writer parts(rows);
  parts.label("show", 70);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string part(part_names[k]);
    parts.change(part, 66, b.parts[k] == irg::display::shown, joined({"show ", name, " ", part, switched(b.parts[k])}));
  }
  row_writer shades(rows);
  shades.label("shade", 70);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string shade(shading_names[k]);
    shades.change(shade, 66, static_cast<std::size_t>(b.shading) == k, joined({"shade ", name, " ", shade}));
  }
  const irg::rgba8 colour = b.body.surfaces.empty() ? irg::stored_surface<double>{}.colour : b.body.surfaces[0].colour;
  const std::array<double, 3> channels{double(colour.r), double(colour.g), double(colour.b)};
  row_writer row(rows);
  row.label("opacity", 70);
  row.value(b.opacity, 54, [&](double v) { return "opacity " + name + " " + shortest(v); }, by_within(0.1, 0, 1));
  row.reading("colour", 66);
  for (std::size_t k = 0; k < 3; ++k)
    row.value(
        channels[k], 48,
        [&](double v) {
          auto other = channels;
          other[k] = v;
          return "colour " + name + words_of(other);
        },
        by_within(15, 0, 255));
}

inline void light_rows(panel_rows& rows, const irg::studio<double>& s) {
  row_writer first(rows);
  first.heading("Light", 70).label("everywhere", 78);
  first.value(s.ambient, 54, [](double v) { return "ambient " + shortest(v); }, by_within(0.05, 0, 1));
  first.skip(8).button("+ lamp", 60, "lamp " + std::to_string(s.lamps.size() + 1) + " 5 10 8 1 0.5 0.5 0.5");
  if (s.lamps.empty()) return;
  row_writer names(rows);
  names.label("lamp", 34);
  for (const char* name : {"x", "y", "z", "w", "red", "green", "blue"}) names.reading(name, 39);
  for (std::size_t i = 0; i < s.lamps.size(); ++i) {
    const irg::light<double>& l = s.lamps[i];
    const std::array<double, 7> numbers{l.position.x,  l.position.y,  l.position.z, l.position.w,
                                        l.intensity.r, l.intensity.g, l.intensity.b};
    row_writer row(rows);
    row.label(std::to_string(i + 1), 34);
    for (std::size_t k = 0; k < 7; ++k)
      row.value(
          numbers[k], 39,
          [&](double v) {
            auto other = numbers;
            other[k] = v;
            return "lamp " + std::to_string(i + 1) + words_of(other);
          },
          [&](double v, int way) {
            return k < 3 ? next_of(v, 0.5, way) : k == 3 ? (v == 0 ? 1.0 : 0.0) : by_within(0.1, 0, 1)(v, way);
          });
    row.skip(4).button("x", 20, "drop-lamp " + std::to_string(i + 1));
  }
}

}  // namespace panel

/// The panel of a view's properties, of the looks of the chosen body, of light, and of files.
inline panel_rows view_panel(const irg::studio<double>& s, const studio_choice& choice) {
  using namespace panel;
  panel_rows rows;
  row_writer views(rows);
  views.heading("View", 140);
  for (const studio_view view : {studio_view::main, studio_view::outer}) {
    studio_choice other = choice;
    other.view = view;
    views.choose(std::string(name_of(view)) + " camera", 96, view == choice.view ? cell_look::on : cell_look::off,
                 other);
  }
  camera_rows(rows, s, choice);
  projection_rows(rows, s, choice);
  if (choice.body < s.bodies.size()) look_rows(rows, s.bodies[choice.body]);
  row_writer(rows)
      .heading("Files", 70)
      .button("save", 66, "save studio.xml")
      .button("restore", 66, "restore studio.xml")
      .button("picture", 66, "picture studio.png");
  light_rows(rows, s);
  return rows;
}

}  // namespace program
