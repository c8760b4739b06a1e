// SPDX-License-Identifier: MIT
// Signs of predicates on a lattice, as they are and with simulation of simplicity: no point is left without one.
// Included by number_and_geometry_pages.cpp.
#pragma once

#include <irg/geometry/simulation_of_simplicity.hpp>
#include <irg/raster/circle_midpoint.hpp>
#include <irg/raster/draw_line.hpp>

#include "enlarged.hpp"

namespace simulated_simplicity {

using namespace enlarging;
using place = irg::point<int, 2>;

// One square for each point of the lattice, y up: blue where the sign is 1, red where it is -1, empty where it is 0; the
// points that the predicate finds in special position are darker.
template <class Sign, class Plain>
picture panel(int size, const Sign& sign, const Plain& plain) {
  constexpr int points = 13;
  constexpr irg::rgba8 blue{150, 188, 224, 255}, red{232, 160, 140, 255}, dark_blue{50, 104, 168, 255},
      dark_red{184, 70, 46, 255};
  picture small(points, points, paper);
  for (int y = 0; y < points; ++y)
    for (int x = 0; x < points; ++x) {
      const int s = sign(place{x, y});
      if (s != 0)
        small(x, points - 1 - y) = plain(place{x, y}) != 0 ? s > 0 ? blue : red : s > 0 ? dark_blue : dark_red;
    }
  return enlarged(small, size);
}

inline picture signs() {
  constexpr int size = 18, points = 13;
  constexpr place a{2, 3}, b{8, 6}, on[3] = {{11, 6}, {6, 11}, {3, 2}};  // of the circle of radius 5 round (6, 6)
  const auto turn = [=](place p) { return irg::orient2d(a, b, p); };
  const auto turn_sos = [=](place p) { return irg::orient2d_sos(a, b, p); };
  const auto inside = [=](place p) { return irg::in_circle(on[0], on[1], on[2], p); };
  const auto inside_sos = [=](place p) { return irg::in_circle_sos(on[0], on[1], on[2], p); };
  picture panels[] = {panel(size, turn, turn), panel(size, turn_sos, turn), panel(size, inside, inside),
                      panel(size, inside_sos, inside)};
  const auto centre = [](place p) { return irg::cell{p.x * size + size / 2, (points - 1 - p.y) * size + size / 2}; };
  picture all(4 * points * size + 61, points * size + 1, paper);
  for (int i = 0; i < 4; ++i) {
    if (i < 2)
      irg::draw_line(panels[i], centre({0, 2}), centre({12, 8}), ink);
    else
      irg::draw_circle(panels[i], centre({6, 6}), 5 * size, ink);
    for (const place p : {i < 2 ? a : on[0], i < 2 ? b : on[1], i < 2 ? b : on[2]}) dot(panels[i], centre(p), 4, ink);
    paste(all, panels[i], i * (points * size + 20), 0);
  }
  return all;
}

}  // namespace simulated_simplicity
