// SPDX-License-Identifier: MIT
// A rippled grid surface from its corner, from its side, from above and from below: what is seen.
#pragma once

#include <vector>

#include <irg/hidden/grid_surface.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/view/look_at.hpp>

#include "enlarged.hpp"

namespace grid_pictures {

using namespace enlarging;

struct heights_on_grid {
  std::vector<double> places{}, heights{};
};

inline heights_on_grid rippled_grid() {
  constexpr int side = 24;
  heights_on_grid g;
  for (int i = 0; i <= side; ++i) g.places.push_back(i);
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j) {
      const double r = irg::hypot(9 * (i / 24.0 - 0.5), 9 * (j / 24.0 - 0.5));
      g.heights.push_back(6 * irg::cos(2 * r) / (1 + r));
    }
  return g;
}

// One eye's picture about the column `middle`.
inline void draw_view(picture& p, const heights_on_grid& g, const irg::point<double, 3>& eye, int middle) {
  const auto to_eye = irg::look_at(eye, irg::point<double, 3>{12, 0, 12}, irg::vec<double, 3>{0, 1, 0.001});
  const auto seen = [&](int i, int j) {
    const std::size_t at = static_cast<std::size_t>(i) * g.places.size() + static_cast<std::size_t>(j);
    return irg::vec<double, 3>{g.places[static_cast<std::size_t>(i)], g.heights[at],
                               g.places[static_cast<std::size_t>(j)]};
  };
  const auto place = [&](const irg::vec<double, 3>& v) {
    const auto q = to_eye * irg::vec<double, 4>{v.x, v.y, v.z, 1};
    return irg::point<double, 2>{middle - 260 * q.x / q.z, 95 + 260 * q.y / q.z};
  };
  const irg::grid_surface surface{g.places, g.places, g.heights};
  const auto draw_part = [&](const irg::grid_edge_part& e) {
    const auto a = seen(e.i1, e.j1), b = seen(e.i2, e.j2);
    const auto at = [&](double t) { return place(a * (1 - t) + b * t); };
    irg::draw_line_aa(p, at(e.from), at(e.to), ink);
  };
  static_cast<void>(irg::visible_grid_edges(surface, eye, draw_part));  // a grid, and an eye beside it
}

inline picture views() {
  picture p(1000, 190, paper);
  const heights_on_grid g = rippled_grid();
  draw_view(p, g, {-14, 17, -18}, 125);
  draw_view(p, g, {12, 8, -24}, 375);
  draw_view(p, g, {12, 40, 12}, 625);
  draw_view(p, g, {-14, -17, -18}, 875);
  return p;
}

}  // namespace grid_pictures
