// SPDX-License-Identifier: MIT
// The minimax test on triangles: rectangles apart, rectangles that overlap though the triangles do not, and triangles
// that do. Included by pictures.cpp.
#pragma once

#include <irg/geometry/minimax.hpp>

#include "sketch.hpp"

namespace rectangle_pictures {

using namespace sketching;

inline picture minimax() {
  constexpr int panel = 230, height = 200;
  picture p(3 * panel, height, paper);
  const ring fixed{{20, 30}, {130, 90}, {40, 170}};
  const ring others[] = {
      {{150, 40}, {215, 110}, {160, 160}}, {{120, 20}, {210, 30}, {90, 60}}, {{90, 60}, {205, 90}, {100, 150}}};
  for (int i = 0; i < 3; ++i) {
    const auto moved = [&](ring r) {
      for (point2& q : r) q.x += panel * i;
      return r;
    };
    const ring a = moved(fixed), b = moved(others[i]);
    const irg::rgba8 colour = irg::rectangles_overlap(a, b) ? red : green;
    for (const ring& r : {a, b}) {
      area(p, r, with_opacity(blue, 70));
      outline(p, r, 1.6, ink);
      const auto e = irg::rectangle_of(r);
      outline(p, ring{e.low, {e.high.x, e.low.y}, e.high, {e.low.x, e.high.y}}, 1.6, colour);
    }
  }
  return p;
}

}  // namespace rectangle_pictures
