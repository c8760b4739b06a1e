// SPDX-License-Identifier: MIT
// Pictures of text and of thick lines with joins. Included by pictures.cpp.
#pragma once

#include <string>
#include <vector>

#include <irg/raster/draw_text.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/stroke.hpp>

#include "enlarged.hpp"

namespace texts {

using namespace enlarging;
using position = irg::point<double, 2>;

// All glyphs, then a line at several sizes.
inline picture font() {
  picture p(960, 372, paper);
  double y = 4;
  const auto row = [&](double size, const std::string& text) {
    y += size;
    irg::draw_text(p, text, position{12, y}, {.size = size}, ink);
    y += 0.35 * size;
  };
  row(40, "ABCDEFGHIJKLMNOPQRSTUVWXYZ 01234");
  row(40, "abcdefghijklmnopqrstuvwxyz 56789");
  row(40, "!\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~ \u00b0\u00d7");
  row(40, "\u2190\u2191\u2192\u2193  a box for the others: \u00e9");
  for (const double size : {10.0, 12.0, 14.0, 16.0, 20.0, 28.0})
    row(size, "The horizon at 45\u00b0: z(x, y) = -1.25e+06, 640 \u00d7 480 \u2192 PNG");
  return p;
}

// A path with each join and cap, its centre line over it.
inline picture strokes() {
  picture p(720, 230, paper);
  constexpr irg::rgba8 blue{92, 142, 196, 255}, white{255, 255, 255, 255};
  constexpr irg::stroke_joins joins[] = {irg::stroke_joins::round, irg::stroke_joins::mitre, irg::stroke_joins::bevel};
  constexpr irg::line_caps caps[] = {irg::line_caps::round, irg::line_caps::square, irg::line_caps::butt};
  const char* const names[] = {"round joins and caps", "mitres, square caps", "bevels, butt caps"};
  for (int i = 0; i < 3; ++i) {
    const double x = 240 * i;
    const std::vector<position> path{{x + 40, 150}, {x + 80, 40}, {x + 130, 150}, {x + 160, 80}, {x + 205, 60}};
    irg::draw_stroke(p, path, {.width = 26, .joins = joins[i], .caps = caps[i]}, blue);
    irg::draw_stroke(p, path, {.width = 2}, white);
    irg::draw_text(p, names[i], position{x + 120, 212}, {.size = 18, .along = irg::text_along::centre}, ink);
  }
  return p;
}

}  // namespace texts
