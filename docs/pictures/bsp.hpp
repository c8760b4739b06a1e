// SPDX-License-Identifier: MIT
// A plan of walls as a BSP tree divides it: the pieces in their order from an eye, and the lines that divide the plane;
// and a scene in space.
#pragma once

#include <string>
#include <vector>

#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/spatial/bsp_tree_2d.hpp>
#include <irg/spatial/bsp_tree_3d.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>

#include "sketch.hpp"

namespace bsp_pictures {

using namespace sketching;
using wall = irg::segment<double, 2>;

inline std::vector<wall> walls() {
  return {{{60, 150}, {300, 150}}, {{110, 50}, {240, 80}},  {{90, 230}, {170, 300}},
          {{200, 30}, {230, 310}}, {{330, 60}, {290, 220}}, {{250, 260}, {350, 290}}};
}

inline void order_from(picture& p, const point2& eye, double left) {
  const auto given = walls();
  const irg::bsp_tree_2d<double> tree(given, {.candidates = 1});
  const auto at = [&](const point2& q) { return point2{q.x + left, q.y}; };
  const irg::box<double, 2> panel{{0, 0}, {380, 340}};
  for (const irg::bsp_node_2d& n : tree.nodes()) {
    const wall& w = given[n.segment];
    const vec2 along = (w.b - w.a) * 20.0;
    if (const auto line = irg::clip_line_liang_barsky(w.a - along, w.b + along, panel))
      stroke(p, {at(line->first), at(line->second)}, 1, with_opacity(grey, 150));
  }
  int number = 0;
  tree.visit(eye, irg::bsp_order::back_to_front, [&](const irg::bsp_piece_2d& piece) {
    const wall w = tree.rounded(piece);
    const vec2 shorter = irg::normalized(w.b - w.a) * 3.0;
    stroke(p, {at(w.a + shorter), at(w.b - shorter)}, 3.2, blue);
    const point2 middle = w.a + (w.b - w.a) * 0.5;
    disc(p, at(middle), 8.5, white);
    irg::draw_text(p, std::to_string(++number), at({middle.x, middle.y}),
                   {.size = 12, .along = irg::text_along::centre, .across = irg::text_across::middle},
                   irg::rgba8{40, 40, 40, 255});
  });
  disc(p, at(eye), 5, red);
}

inline picture orders() {
  picture p(780, 340, white);
  order_from(p, {40, 320}, 0);
  order_from(p, {350, 130}, 400);
  return p;
}

// Two balls in each other and three rods in turn.
struct bodies {
  std::vector<point3> corners;
  std::vector<irg::triangle_indices> triangles;
  std::vector<irg::rgba8> colours;

  void add(const irg::mesh<double>& body, const vec3& to, irg::rgba8 colour) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (const point3& p : body.positions) corners.push_back(p + to);
    const irg::mesh<double> cut = irg::triangulated(body);
    for (std::size_t f = 0; f < cut.face_count(); ++f) {
      triangles.push_back(
          {{first + cut.corner(f, 0).position, first + cut.corner(f, 1).position, first + cut.corner(f, 2).position}});
      colours.push_back(colour);
    }
  }
};

inline bodies scene_in_space() {
  bodies s;
  s.add(irg::shape_sphere<double>({.slices = 16, .stacks = 8}), {0.55, 0, 0.1}, {120, 150, 212, 255});
  s.add(irg::shape_sphere<double>({.slices = 16, .stacks = 8}), {-0.55, 0.2, -0.1}, {204, 96, 72, 255});
  for (int i = 0; i < 3; ++i) {
    const double turn = irg::two_pi<double> * i / 3, c = irg::cos(turn), d = irg::sin(turn);
    const auto at = [&](double along, double across, double height) {
      return point3{c * along - d * (across + 1.0), d * along + c * (across + 1.0), height};
    };
    const auto first = static_cast<std::uint32_t>(s.corners.size());
    for (const point3& p : {at(-2.6, -0.22, -0.5), at(2.6, -0.22, 0.5), at(2.6, 0.22, 0.5), at(-2.6, 0.22, -0.5)})
      s.corners.push_back(p);
    s.triangles.push_back({{first, first + 1, first + 2}});
    s.triangles.push_back({{first, first + 2, first + 3}});
    s.colours.insert(s.colours.end(), 2, {236, 190, 96, 255});
  }
  return s;
}

inline picture order_in_space() {
  picture p(720, 340, white);
  const bodies s = scene_in_space();
  const irg::bsp_tree_3d<double> tree(s.corners, s.triangles);
  int panel = 0;
  for (const point3& eye : {point3{2.5, -6.5, 4.5}, point3{-6.4, 1.9, -7.6}}) {
    const auto to_clip =
        irg::perspective(0.62, 360.0 / 340, 0.1, 100.0) * irg::look_at(eye, point3{0, 0, 0}, vec3{0, 0, 1});
    int number = 0;
    tree.visit(eye, irg::bsp_order::back_to_front, [&](const irg::bsp_piece_3d& piece) {
      ring outline;
      for (const point3& q : tree.rounded(piece)) {
        const auto c = to_clip * q;
        outline.push_back({180 + 180 * c.x / c.w + 360 * panel, 170 - 170 * c.y / c.w});
      }
      if (outline.size() < 3) return;
      const int shade = 62 + 38 * (number++ * 5 % 8) / 7;
      irg::rgba8 colour = s.colours[piece.triangle];
      for (std::uint8_t* part : {&colour.r, &colour.g, &colour.b})
        *part = static_cast<std::uint8_t>(*part * shade / 100);
      irg::fill_polygon(p, outline, irg::fill_rule::non_zero, colour);
    });
    ++panel;
  }
  return p;
}

}  // namespace bsp_pictures
