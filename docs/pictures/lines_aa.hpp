// SPDX-License-Identifier: MIT
// Pictures of the antialiased lines: the pixels, enlarged. Included by pictures.cpp.
#pragma once

#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/line_wu.hpp>

#include "enlarged.hpp"

namespace lines_aa {

using namespace enlarging;
inline constexpr irg::rgba8 blue{92, 142, 196, 255}, red{204, 96, 72, 255};

// Wu's two cells per column, with the true line over them.
inline picture wu() {
  constexpr int size = 16;
  picture small(36, 15, paper);
  constexpr irg::cell ends[][2] = {{{1, 1}, {34, 5}}, {{1, 13}, {24, 7}}, {{27, 13}, {31, 8}}};
  for (const auto& e : ends) irg::draw_line_wu(small, e[0], e[1], ink);
  picture big = enlarged(small, size);
  for (const auto& e : ends) {
    const auto middle = [](irg::cell c) { return irg::cell{c.x * size + size / 2, c.y * size + size / 2}; };
    irg::line_bresenham(middle(e[0]), middle(e[1]), irg::window_of(big), [&](irg::cell c) { big(c.x, c.y) = red; });
  }
  return big;
}

// Rectangles of several widths and both caps, with their centre lines over them.
inline picture area() {
  constexpr int size = 16, one = irg::one_pixel;
  picture small(40, 20, paper);
  struct line {
    irg::subpixel a, b;
    irg::line_aa_options options;
    irg::rgba8 colour;
  };
  constexpr auto p = [](double x, double y) { return irg::subpixel{irg::snap(x), irg::snap(y)}; };
  constexpr line lines[] = {{p(1.5, 1.5), p(19.3, 6.2), {}, ink},
                            {p(1.5, 6), p(19.3, 10.7), {2 * one}, ink},
                            {p(2.5, 13.25), p(15.5, 16.75), {4 * one}, blue},
                            {p(22.6, 16.5), p(26.1, 2.5), {}, ink},
                            {p(31.0, 3.5), p(36.5, 7.25), {4 * one, irg::line_aa_caps::square}, blue},
                            {p(30.5, 14.0), p(37.5, 14.0), {3 * one / 2}, ink},
                            {p(30.5, 17.5), p(37.5, 17.5), {one / 2}, ink}};
  for (const line& l : lines) irg::draw_line_aa(small, l.a, l.b, l.colour, l.options);
  picture big = enlarged(small, size);
  for (const line& l : lines) {
    const auto scaled = [](irg::subpixel s) { return irg::cell{s.x * size / one, s.y * size / one}; };
    irg::line_bresenham(scaled(l.a), scaled(l.b), irg::window_of(big), [&](irg::cell c) { big(c.x, c.y) = red; });
  }
  return big;
}

}  // namespace lines_aa
