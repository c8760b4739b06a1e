// SPDX-License-Identifier: MIT
// A rippled surface by the floating horizon: one family of curves, both, and the source's points.
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

}  // namespace horizon_pictures
