// SPDX-License-Identifier: MIT
// Pictures of sub-pixel, dashed and thick lines, circles and ellipses: few pixels, enlarged, with the true shape on top.
#pragma once

#include <cmath>

#include <irg/colour/srgb.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/raster/circle_midpoint.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/ellipse_midpoint.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_styled.hpp>
#include <irg/raster/line_subpixel.hpp>
#include <irg/raster/line_thick.hpp>

#include "enlarged.hpp"

namespace line_variants {

using namespace enlarging;
constexpr irg::rgba8 blue{120, 166, 212, 255}, red{216, 128, 106, 255}, light{236, 228, 208, 255};

inline irg::cell place(double x, double y, int size) {
  return {static_cast<int>(std::floor(x * size)), static_cast<int>(std::floor(y * size))};
}

inline irg::cell place(irg::subpixel p, int size) { return place(p.x / 256.0, p.y / 256.0, size); }

// The same two lines by both rules; the diamonds are drawn that decide the right one.
inline picture subpixel() {
  constexpr int size = 20, columns = 17, rows = 11;
  picture both(2 * columns * size + 21, rows * size + 1, paper);
  const irg::subpixel ends[][2] = {
      {{300, 420}, {3980, 1250}}, {{420, 900}, {1500, 2640}}, {{2300, 2400}, {3700, 1700}}};
  for (const bool diamonds : {false, true}) {
    picture small(columns, rows, paper);
    for (int i = 0; i < 3; ++i)
      irg::draw_line_subpixel(small, ends[i][0], ends[i][1], i == 1 ? red : blue,
                              {.rule = diamonds ? irg::line_rule::diamond_exit : irg::line_rule::nearest});
    picture big = enlarged(small, size);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const irg::cell c{x * size + size / 2, y * size + size / 2};
        if (diamonds)
          for (int k = 0; k < 4; ++k)
            irg::draw_line(big,
                           {c.x + (k == 0   ? -10
                                   : k == 2 ? 10
                                            : 0),
                            c.y + (k == 1   ? -10
                                   : k == 3 ? 10
                                            : 0)},
                           {c.x + (k == 3   ? -10
                                   : k == 1 ? 10
                                            : 0),
                            c.y + (k == 0   ? -10
                                   : k == 2 ? 10
                                            : 0)},
                           pale);
        else
          irg::fill_circle(big, c, 1, pale);
      }
    for (const auto& e : ends) {
      irg::draw_line(big, place(e[0], size), place(e[1], size), ink);
      irg::fill_circle(big, place(e[0], size), 3, ink);
      irg::draw_circle(big, place(e[1], size), 3, ink);
    }
    for (int y = 0; y < big.height(); ++y)
      for (int x = 0; x < big.width(); ++x) both(x + (diamonds ? columns * size + 20 : 0), y) = big(x, y);
  }
  return both;
}

inline picture styled() {
  picture small(72, 40, paper);
  const std::uint32_t dashes[] = {6, 3}, dash_dot[] = {7, 2, 1, 2}, dots[] = {1, 2};
  const irg::cell bends[] = {{3, 20}, {22, 3}, {40, 10}, {50, 28}, {69, 4}};
  int offset = 0;
  for (const auto& runs : {irg::dash_runs{dashes}, irg::dash_runs{dash_dot}, irg::dash_runs{dots}}) {
    std::uint64_t phase = 0;
    const irg::line_options half_open{.ends = irg::line_ends::half_open};
    for (int i = 0; i < 4; ++i)
      phase = irg::draw_line_styled(small, {bends[i].x, bends[i].y + offset}, {bends[i + 1].x, bends[i + 1].y + offset},
                                    irg::line_dashes{runs, phase, half_open}, offset == 5 ? red : ink);
    offset += 5;
  }
  irg::draw_line_styled(small, {3, 38}, {68, 38}, irg::line_dashes{irg::dash_mask{0x6f6f}}, blue);
  return enlarged(small, 9);
}

inline void outline(picture& big, irg::subpixel a, irg::subpixel b, irg::line_pen pen, int size) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy), w = pen.width / 2.0;
  const double ux = dx / length, uy = dy / length, beyond = pen.caps == irg::line_caps::square ? w : 0;
  const auto corner = [&](irg::subpixel p, double along, double aside) {
    return place((p.x + along * ux - aside * uy) / 256, (p.y + along * uy + aside * ux) / 256, size);
  };
  irg::draw_line(big, corner(a, -beyond, w), corner(b, beyond, w), ink);
  irg::draw_line(big, corner(a, -beyond, -w), corner(b, beyond, -w), ink);
  if (pen.caps != irg::line_caps::round) {
    irg::draw_line(big, corner(a, -beyond, -w), corner(a, -beyond, w), ink);
    irg::draw_line(big, corner(b, beyond, -w), corner(b, beyond, w), ink);
    return;
  }
  for (int k = 0; k < 24; ++k) {
    const double s = irg::pi<double> * k / 24, t = irg::pi<double> * (k + 1) / 24;
    irg::draw_line(big, corner(b, w * irg::sin(s), w * irg::cos(s)), corner(b, w * irg::sin(t), w * irg::cos(t)), ink);
    irg::draw_line(big, corner(a, -w * irg::sin(s), w * irg::cos(s)), corner(a, -w * irg::sin(t), w * irg::cos(t)),
                   ink);
  }
}

inline picture thick() {
  constexpr int size = 12;
  picture small(60, 30, paper);
  const irg::line_caps caps[] = {irg::line_caps::butt, irg::line_caps::square, irg::line_caps::round};
  const irg::subpixel a{1200, 950}, b{3500, 2750};
  const auto moved = [](irg::subpixel p, int i) { return irg::subpixel{p.x + i * 2800, p.y}; };
  for (int i = 0; i < 3; ++i)
    irg::draw_line_thick(small, moved(a, i), moved(b, i), {.width = 1100, .caps = caps[i]}, i == 1 ? red : blue);
  const irg::subpixel bends[] = {{700, 6500}, {3400, 4600}, {6200, 6700}, {9600, 4200}, {14600, 6900}};
  irg::draw_polyline_thick(small, bends, {.width = 700, .caps = irg::line_caps::round}, light);
  picture big = enlarged(small, size);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 60; ++x) irg::fill_circle(big, {x * size + size / 2, y * size + size / 2}, 1, pale);
  for (int i = 0; i < 3; ++i) outline(big, moved(a, i), moved(b, i), {.width = 1100, .caps = caps[i]}, size);
  for (int i = 0; i < 4; ++i) outline(big, bends[i], bends[i + 1], {.width = 700, .caps = irg::line_caps::round}, size);
  return big;
}

inline void true_ellipse(picture& big, irg::cell centre, double a, double b, int size) {
  irg::cell last{};
  for (int k = 0; k <= 256; ++k) {
    const double t = irg::two_pi<double> * k / 256;
    const irg::cell next = place(centre.x + 0.5 + a * irg::cos(t), centre.y + 0.5 + b * irg::sin(t), size);
    if (k > 0) irg::draw_line(big, last, next, ink);
    last = next;
  }
}

inline picture circles() {
  constexpr int size = 12;
  picture small(58, 27, paper);
  irg::fill_circle(small, {43, 13}, 12, light);
  irg::draw_circle(small, {13, 13}, 12, blue);
  irg::draw_circle(small, {13, 13}, 7, red);
  irg::draw_circle(small, {13, 13}, 3, blue);
  irg::draw_circle(small, {13, 13}, 0, ink);
  irg::draw_circle(small, {29, 13}, 2, red);
  irg::draw_circle(small, {43, 13}, 9, red);
  picture big = enlarged(small, size);
  for (const int r : {12, 7, 3}) true_ellipse(big, {13, 13}, r, r, size);
  true_ellipse(big, {29, 13}, 2, 2, size);
  for (const int r : {12, 9}) true_ellipse(big, {43, 13}, r, r, size);
  return big;
}

inline picture ellipses() {
  constexpr int size = 12;
  picture small(60, 25, paper);
  irg::fill_ellipse(small, {45, 9}, 13, 7, light);
  const struct {
    irg::cell centre;
    int a, b;
    irg::rgba8 colour;
  } all[] = {{{15, 9}, 14, 8, blue}, {{15, 9}, 5, 7, red},    {{15, 9}, 2, 5, blue},
             {{29, 20}, 28, 1, red}, {{29, 23}, 28, 0, blue}, {{45, 9}, 13, 7, red}};
  for (const auto& e : all) irg::draw_ellipse(small, e.centre, e.a, e.b, e.colour);
  picture big = enlarged(small, size);
  for (const auto& e : all) true_ellipse(big, e.centre, e.a, e.b, size);
  return big;
}

}  // namespace line_variants
