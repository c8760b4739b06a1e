// SPDX-License-Identifier: MIT
// A rippled surface by the floating horizon: one family of curves, both, and the source's points; both families laid
// over each other, which is wrong.
#pragma once

#include <irg/hidden/horizon_surface.hpp>
#include <irg/hidden/textbook/floating_horizon.hpp>
#include <irg/math/hypot.hpp>
#include <irg/raster/draw_line.hpp>

#include "enlarged.hpp"

namespace horizon_pictures {

using namespace enlarging;

inline double ripples(double u, double v) {
  const double r = irg::hypot(9 * (u - 0.5), 9 * (v - 0.5));
  return irg::cos(2 * r) / (1 + r);
}

template <class Horizon>
void draw_surface(picture& p, const irg::horizon_view& view, Horizon horizon, int left) {
  draw_horizon_surface(horizon, ripples, view, [&](const irg::cell& a, const irg::cell& b, irg::horizon_side side) {
    const auto place = [&](const irg::cell& c) { return irg::cell{left + c.x, 130 - c.y}; };
    irg::draw_line(p, place(a), place(b), side == irg::horizon_side::upper ? ink : irg::rgba8{176, 84, 60, 255});
  });
}

// Curves of constant z with the points that the source sets first, then with lines; both families.
inline picture surfaces() {
  picture p(900, 140, paper);
  irg::horizon_view view{210, 90, irg::radians(29.0), irg::radians(40.0), 29};
  view.families = irg::horizon_curves::constant_z;
  using irg::textbook::horizon_rule;
  draw_surface(p, view, irg::textbook::floating_horizon(irg::horizon_width(view), horizon_rule::points), 5);
  draw_surface(p, view, irg::floating_horizon(irg::horizon_width(view)), 305);
  view.families = irg::horizon_curves::both;
  draw_surface(p, view, irg::floating_horizon(irg::horizon_width(view)), 605);
  return p;
}

// Above: curves of constant z, and of constant x. Below: the two laid over each other, red where the right picture has no line; that
// picture.
inline picture laid_over() {
  constexpr int width = 400, height = 250;
  irg::horizon_view view{280, 175, irg::radians(29.0), irg::radians(40.0), 19};
  const auto draw = [&](picture& p, irg::horizon_curves families) {
    view.families = families;
    irg::floating_horizon horizon(irg::horizon_width(view));
    draw_horizon_surface(horizon, ripples, view, [&](const irg::cell& a, const irg::cell& b, irg::horizon_side) {
      irg::draw_line(p, irg::cell{a.x + 8, 232 - a.y}, irg::cell{b.x + 8, 232 - b.y}, ink);
    });
  };
  picture of_z(width, height, paper), of_x = of_z, over = of_z, right = of_z;
  draw(of_z, irg::horizon_curves::constant_z);
  draw(of_x, irg::horizon_curves::constant_x);
  draw(over, irg::horizon_curves::constant_z);
  draw(over, irg::horizon_curves::constant_x);
  draw(right, irg::horizon_curves::both);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (over(x, y) == ink && !(right(x, y) == ink)) over(x, y) = irg::rgba8{204, 40, 40, 255};
  picture p(2 * width, 2 * height, paper);
  paste(p, of_z, 0, 0);
  paste(p, of_x, width, 0);
  paste(p, over, 0, height);
  paste(p, right, width, height);
  return p;
}

}  // namespace horizon_pictures
