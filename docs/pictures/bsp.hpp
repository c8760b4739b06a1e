// SPDX-License-Identifier: MIT
// A plan of walls as a BSP tree divides it: the pieces in their order from an eye, and the lines that divide the plane.
#pragma once

#include <string>
#include <vector>

#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/spatial/bsp_tree_2d.hpp>

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

}  // namespace bsp_pictures
