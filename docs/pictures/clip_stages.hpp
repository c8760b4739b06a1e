// SPDX-License-Identifier: MIT
// Sutherland and Hodgman's clipping, boundary by boundary. Included by number_and_geometry_pages.cpp.
#pragma once

#include <algorithm>
#include <array>

#include <irg/geometry/textbook/clip_sutherland_hodgman.hpp>

#include "board.hpp"

namespace clip_stages {

using namespace sketching;
using P = point2;

// A triangle after each of four boundaries of a window: blue what is left, red the boundary and the cuts it made; grey
// what it took away, and the side it takes away from.
inline picture triangle() {
  picture p(640, 150, paper);
  // x >= 0, x <= 4, y >= 0, y <= 3.
  constexpr std::array<irg::line<double>, 4> boundaries{{{1, 0, 0}, {-1, 0, 4}, {0, 1, 0}, {0, -1, 3}}};
  constexpr double left = -1.5, right = 5.5, low = -0.7, high = 5.6;
  const ring taken[] = {{{left, low}, {0, low}, {0, high}, {left, high}},
                        {{4, low}, {right, low}, {right, high}, {4, high}},
                        {{left, low}, {right, low}, {right, 0}, {left, 0}},
                        {{left, 3}, {right, 3}, {right, high}, {left, high}}};
  const P ends[][2] = {{{0, low}, {0, high}}, {{4, low}, {4, high}}, {{left, 0}, {right, 0}}, {{left, 3}, {right, 3}}};
  ring before{{-1, 1}, {5, 1}, {2, 5}};
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const board b{p, 38.0 + 160 * static_cast<double>(k), 131, 21};
    const ring after = irg::textbook::clip_stage(before, boundaries[k]);
    b.fill(taken[k], {234, 232, 227, 255});
    b.fill(before, {204, 203, 200, 255});
    b.fill(after, light_blue);
    b.outline({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 1, grey);
    b.outline(after, 2, blue);
    b.line(ends[k][0], ends[k][1], 2, red);
    for (const P& v : after) b.dot(v, 4, std::find(before.begin(), before.end(), v) == before.end() ? red : ink);
    before = after;
  }
  return p;
}

}  // namespace clip_stages
