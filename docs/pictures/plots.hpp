// SPDX-License-Identifier: MIT
// Surfaces with axes; the floating horizon in vectors. Included by pictures.cpp.
#pragma once

#include <limits>

#include <irg/hidden/plot_surface.hpp>
#include <irg/hidden/height_grid.hpp>
#include <irg/hidden/horizon_curves.hpp>
#include <irg/math/hypot.hpp>

#include "enlarged.hpp"

namespace plot_pictures {

using namespace enlarging;

inline double ripple(double x, double z) {
  const double r = irg::hypot(x, z);
  return 3 * irg::cos(2 * r) / (1 + r);
}

inline picture surfaces() {
  constexpr int width = 320, height = 250;
  picture p(2 * width, height, paper);
  const irg::sample_range range{-4, 4, 19};
  const auto whole = irg::sample_heights(ripple, range, range);
  const auto holed = irg::sample_heights(
      [](double x, double z) {
        return irg::hypot(x - 1, z + 2) < 1.1 ? std::numeric_limits<double>::quiet_NaN() : ripple(x, z);
      },
      range, range);
  irg::surface_plot_options options{.width = width, .height = height, .text_size = 11};
  const auto show = [&](const irg::height_grid& g, int left) {
    picture one(width, height, paper);
    irg::draw_plot(one, irg::plot_surface(g.surface(), options).value);
    paste(p, one, left, 0);
  };
  options.style = irg::surface_style::facets;
  options.x = "length", options.y = "height", options.z = "width";
  show(whole, 0);
  options.style = irg::surface_style::lines, options.azimuth_degrees = -30;
  show(holed, width);
  return p;
}

// The parts of curves about the column `middle`: seen ones by their height, hidden ones as dashes.
inline void draw_curves(picture& p, const irg::horizon_curve_points& c, irg::point<double, 2> middle,
                        irg::drawn_parts which) {
  irg::visible_curves(
      c.points,
      [&](const irg::edge_part& e) {
        const auto a = c.points[e.edge], b = c.points[e.edge + 1];
        const auto at = [&](double t) {
          return irg::point<double, 2>{middle.x + a.x + (b.x - a.x) * t, middle.y - a.y - (b.y - a.y) * t};
        };
        const double lift = c.heights[e.edge];
        if (e.visibility == irg::line_visibility::visible)
          irg::draw_line_aa(p, at(e.from), at(e.to), irg::height_colour((lift + 0.6) / 1.6));
        else if (e.edge % 4 < 2)
          irg::draw_line_aa(p, at(e.from), at(e.to), irg::rgba8{206, 200, 190, 255});
      },
      which);
}

inline picture horizon_lines() {
  picture p(750, 165, paper);
  const auto height = [](double x, double z) {
    const double r = irg::hypot(9 * (x - 0.5), 9 * (z - 0.5));
    return irg::cos(2 * r) / (1 + r);
  };
  const auto holed = [&](double x, double z) {
    return irg::hypot(x - 0.6, z - 0.25) < 0.13 ? std::numeric_limits<double>::quiet_NaN() : height(x, z);
  };
  irg::horizon_view view{170, 75, irg::radians(29.0), irg::radians(40.0), 17, 65};
  draw_curves(p, irg::horizon_curves_of(holed, view), {90, 150}, irg::drawn_parts::visible);
  draw_curves(p, irg::horizon_curves_of(height, view), {335, 150}, irg::drawn_parts::all);
  view.width = 210, view.height = 70;
  draw_curves(p, irg::horizon_curves_from(height, view, {-0.4, 2.1, -0.7}), {625, -55}, irg::drawn_parts::visible);
  return p;
}

}  // namespace plot_pictures
