// SPDX-License-Identifier: MIT
// A house of cells and portals: what may be seen from a room, what an eye sees, and the picture from that eye. Included
// by pictures.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/io/plan_text.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/render/render_rooms.hpp>
#include <irg/scene/room_mesh.hpp>
#include <irg/visibility/potentially_visible.hpp>

#include "enlarged.hpp"

namespace portal_pictures {

using namespace enlarging;
constexpr irg::rgba8 wall{60, 66, 84, 255}, dark{168, 168, 164, 255}, seen{186, 206, 226, 255}, own{150, 188, 224, 255},
    lit{255, 232, 158, 255}, eye_colour{204, 96, 72, 255};

// Seven rooms with thick walls; doorways are cells.
inline irg::cell_plan<double> house() {
  constexpr std::string_view text =
      "cell hall 0 0 6 0 6 4 0 4\n"
      "cell d1 6 1.5 6.4 1.5 6.4 2.5 6 2.5\n"
      "cell middle 6.4 0 11 0 11 5 6.4 5\n"
      "cell d2 11 1.6 11.4 1.6 11.4 2.8 11 2.8\n"
      "cell east 11.4 0 16 0 16 6 11.4 6\n"
      "cell d3 9 5 10.2 5 10.2 5.4 9 5.4\n"
      "cell north 7 5.4 11 5.4 11 10 7 10\n"
      "cell d4 1 4 2 4 2 4.4 1 4.4\n"
      "cell bath 0 4.4 3 4.4 3 7 0 7\n"
      "cell d5 6 8 7 8 7 9 6 9\n"
      "cell study 3.4 4.4 6 4.4 6 10 3.4 10\n"
      "cell d6 13 6 14 6 14 6.4 13 6.4\n"
      "cell garden 11.4 6.4 16 6.4 16 10 11.4 10\n"
      "heights d1 0 0.8\nheights d2 0 0.8\nheights d3 0 0.8\nheights d4 0 0.8\nheights d5 0 0.8\nheights d6 0 0.8\n"
      "portal hall d1 6 1.5 6 2.5\nportal d1 middle 6.4 1.5 6.4 2.5\n"
      "portal middle d2 11 1.6 11 2.8\nportal d2 east 11.4 1.6 11.4 2.8\n"
      "portal middle d3 9 5 10.2 5\nportal d3 north 9 5.4 10.2 5.4\n"
      "portal hall d4 1 4 2 4\nportal d4 bath 1 4.4 2 4.4\n"
      "portal north d5 7 8 7 9\nportal d5 study 6 8 6 9\n"
      "portal east d6 13 6 14 6\nportal d6 garden 13 6.4 14 6.4\n";
  return irg::read_plan(text)->plan;
}

inline constexpr int unit = 20, margin = 10;
inline irg::point<double, 2> place_of(int x, int y, int height) {
  return {(x - margin + 0.5) / unit, (height - margin - y - 0.5) / unit};
}
inline irg::cell pixel_of(const irg::point<double, 2>& p, int height) {
  return {margin + static_cast<int>(p.x * unit), height - margin - static_cast<int>(p.y * unit)};
}

// The plan with each point of a cell in the colour that colour_of(cell, point) gives.
template <class ColourOf>
picture drawn(const irg::cell_plan<double>& plan, const ColourOf& colour_of) {
  picture p(16 * unit + 2 * margin, 10 * unit + 2 * margin, wall);
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) {
      const auto at = place_of(x, y, p.height());
      for (std::uint32_t c = 0; c < plan.cells.size(); ++c)
        if (irg::point_in_convex_polygon(plan.cells[c].corners, at) == irg::location::inside)
          p(x, y) = colour_of(c, at);
    }
  return p;
}

// Above: what may be seen from the hall, and what the eye in it sees. Below: the picture from that eye, and the pixels
// that each room has in it.
inline picture rooms() {
  const irg::cell_plan<double> plan = house();
  const irg::portal_graph<double> doors(plan);
  const irg::visible_sets sets = irg::potentially_visible(doors);
  const irg::point<double, 2> eye{1.5, 1.1};
  std::vector<std::vector<irg::view_wedge<double>>> wedges(plan.cells.size());
  irg::view_through_portals(doors, 0, {eye, irg::view_reach::all_round, {}, {}},
                            [&](std::uint32_t c, const irg::view_wedge<double>& w) { wedges[c].push_back(w); });
  const picture from_hall = drawn(plan, [&](std::uint32_t c, const auto&) {
    return c == 0 ? own : sets.seen.is_full({static_cast<int>(c), 0, 0}) ? seen : dark;
  });
  picture from_eye = drawn(plan, [&](std::uint32_t c, const auto& at) {
    for (const auto& w : wedges[c])
      if (c == 0 || (irg::orient2d(eye, w.right, at) >= 0 && irg::orient2d(eye, at, w.left) >= 0)) return lit;
    return dark;
  });
  dot(from_eye, pixel_of(eye, from_eye.height()), 5, eye_colour);

  irg::scene<double> world;
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c) {
    irg::object<double> room;
    room.shape = irg::room_mesh(plan, doors, c);
    constexpr irg::rgb<double> colours[] = {
        {0.62, 0.78, 0.92}, {0.5, 0.48, 0.46}, {0.95, 0.85, 0.6}, {0.5, 0.48, 0.46}, {0.85, 0.6, 0.52}};
    room.surface.ambient = room.surface.diffuse = c < 5 ? colours[c] : irg::rgb<double>{0.7, 0.8, 0.68};
    world.objects.push_back(room);
  }
  world.ambient = {0.45, 0.45, 0.45};
  world.lights.push_back({{-0.3, -0.55, 0.75, 0.0}, {0.6, 0.6, 0.6}});
  world.view.eye = {eye.x, eye.y, 0.5};
  world.view.target = {6.4, 2, 0.45};
  world.view.up = {0, 0, 1};
  world.view.vertical_angle = 0.62;
  irg::prepared_rooms<double> building{plan, doors, irg::prepare_scene(world)};
  picture view(from_eye.width(), from_eye.height(), paper);
  irg::image<float> depth(view.width(), view.height(), 0.0f);
  irg::render_options options;
  options.style = irg::picture_style::flat;
  irg::render(building, {view, depth}, options);
  picture windows = view;
  for (const irg::cell_window& w : irg::visible_rooms(plan, doors, world.view, {view.width(), view.height()})) {
    if (w.empty()) continue;
    for (int x = w.x_first; x < w.x_last; ++x) windows(x, w.y_first) = windows(x, w.y_last - 1) = eye_colour;
    for (int y = w.y_first; y < w.y_last; ++y) windows(w.x_first, y) = windows(w.x_last - 1, y) = eye_colour;
  }
  picture p(2 * view.width() + 12, 2 * view.height() + 12, paper);
  paste(p, from_hall, 0, 0);
  paste(p, from_eye, view.width() + 12, 0);
  paste(p, view, 0, view.height() + 12);
  paste(p, windows, view.width() + 12, view.height() + 12);
  return p;
}

}  // namespace portal_pictures
