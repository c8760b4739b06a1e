// SPDX-License-Identifier: MIT
// Pictures of the polygon algorithms: points against rings, hulls, triangles, cuts, overlaps, centres.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/edge_equation.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/polygon_centroid.hpp>
#include <irg/geometry/polygons_overlap.hpp>
#include <irg/geometry/split_polygon.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/raster/image.hpp>

#include "board.hpp"

namespace polygon_pictures {

using namespace sketching;
using P = point2;
using rings = std::vector<ring>;

// Two rings that run the same way, and a pentagram: what is inside by either rule.
inline picture rules() {
  picture p(640, 200, paper);
  rings polygon{{}, {{14, 1.5}, {19, 1.5}, {19, 8}, {14, 8}}, {{15.5, 3}, {17.5, 3}, {17.5, 6.5}, {15.5, 6.5}}};
  for (int i = 0; i < 5; ++i)
    polygon[0].push_back(
        {6 + 4.6 * std::cos(1.5707963 + i * 2.5132741), 4.6 + 4.6 * std::sin(1.5707963 + i * 2.5132741)});
  for (int k = 0; k < 2; ++k) {
    const board b{p, 320.0 * k, 195, 16};
    for (double y = 0.5; y < 12; y += 0.75)
      for (double x = 0.5; x < 20; x += 0.75) {
        const auto where =
            irg::point_in_polygon(polygon, P{x, y}, k == 0 ? irg::fill_rule::even_odd : irg::fill_rule::non_zero);
        const bool inside = where == irg::location::inside;
        b.dot({x, y}, inside ? 3.5 : 2, inside ? blue : pale);
      }
    for (const ring& r : polygon) b.outline(r, 1.5, ink);
  }
  return p;
}

inline picture hull() {
  picture p(640, 260, paper);
  const board b{p, 10, 250, 12};
  ring points{{4, 2}, {14, 2}, {24, 2}, {48, 6}, {50, 12}, {40, 18}, {12, 17}, {4, 11}, {4, 6.5}};
  std::uint32_t state = 7;
  for (int i = 0; i < 60; ++i) {
    state = state * 1664525u + 1013904223u;
    const double x = 6 + (state >> 16) % 420 / 10.0;
    state = state * 1664525u + 1013904223u;
    points.push_back({x, 4 + (state >> 16) % 120 / 10.0});
  }
  const auto of = [&](irg::side_points option) {
    ring out;
    for (const auto i : irg::convex_hull(points, option)) out.push_back(points[i]);
    return out;
  };
  const ring corners = of(irg::side_points::leave_out), all = of(irg::side_points::keep);
  // Points that are nearly on a side would look as if they were.
  std::erase_if(points, [&](const P& q) {
    if (std::find(all.begin(), all.end(), q) != all.end()) return false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto side = irg::edge_through(corners[i], irg::ring_vertex(corners, i + 1));
      if (irg::line_value(side, q) < 0.6 * std::hypot(side.a, side.b)) return true;
    }
    return false;
  });
  b.fill(corners, light_blue);
  b.outline(corners, 1.5, ink);
  b.dots(points, 3, ink);
  b.dots(all, 5.5, red);
  b.dots(corners, 5.5, blue);
  return p;
}

// A star by ears, and with a hole by the sweep.
inline picture triangles() {
  picture p(640, 300, paper);
  ring star;
  for (int i = 0; i < 18; ++i) {
    const double r = i % 2 == 0 ? 9 : i % 3 == 0 ? 4 : 6, a = 6.2831853 * (i + 0.25) / 18;
    star.push_back({10 + r * std::cos(a), 9.5 + r * std::sin(a)});
  }
  const ring hole{{9, 8}, {8.5, 11}, {11, 11.5}, {12, 8.5}};
  const auto draw = [&](const board& b, const rings& polygon,
                        const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    ring all;
    for (const ring& r : polygon) all.insert(all.end(), r.begin(), r.end());
    constexpr irg::rgba8 tints[] = {{206, 222, 240, 255}, {176, 204, 232, 255}, {226, 234, 244, 255}};
    std::size_t k = 0;
    for (const auto& t : triangles) b.fill({all[t[0]], all[t[1]], all[t[2]]}, tints[k++ % 3]);
    for (const auto& t : triangles) b.outline({all[t[0]], all[t[1]], all[t[2]]}, 1, blue);
    for (const ring& r : polygon) b.outline(r, 1.5, ink);
    b.dots(all, 3, ink);
  };
  draw({p, 5, 295, 15}, {star}, irg::triangulate_ear_clipping(star));
  draw({p, 325, 295, 15}, {star, hole}, irg::triangulate_monotone(rings{star, hole}).triangles);
  return p;
}

// A comb cut by a slanting line, its parts drawn apart.
inline picture cut() {
  picture p(640, 240, paper);
  const ring comb{{1, 1},   {27, 1}, {27, 12}, {23, 12}, {21, 4}, {18, 13},
                  {14, 13}, {13, 5}, {9, 11},  {5, 11},  {4, 3},  {1, 9}};
  const P from{0, 8}, over{28, 5};
  const auto parts = irg::split_polygon(comb, from, over);
  const board b{p, 10, 235, 15}, upper{p, 440, 105, 7}, lower{p, 440, 225, 7};
  const auto show = [&](const rings& side, const board& apart, irg::rgba8 colour) {
    for (const ring& r : side) {
      b.fill(r, colour);
      apart.fill(r, colour);
      apart.outline(r, 1, ink);
      apart.dots(r, 2.5, ink);
    }
  };
  show(parts.front, upper, light_blue);
  show(parts.back, lower, light_red);
  b.outline(comb, 1.5, ink);
  b.line(from, over, 2, red);
  return p;
}

inline picture overlaps() {
  picture p(640, 190, paper);
  const ring bay{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
  const ring tongue{{4.5, 4}, {5.5, 10}, {3.5, 10}};
  for (int k = 0; k < 3; ++k) {
    const board b{p, 30 + 210.0 * k, 170, 15};
    ring moved = tongue;
    for (P& q : moved) q.y -= k == 2 ? 2.6 : k;
    const auto found = irg::polygons_overlap(bay, moved);
    b.fill(bay, light_blue);
    b.fill(moved, found == irg::polygon_overlap::separate   ? pale
                  : found == irg::polygon_overlap::touching ? light_red
                                                            : red);
    b.outline(bay, 1.5, ink);
    b.outline(moved, 1.5, ink);
  }
  return p;
}

inline picture centres() {
  picture p(640, 170, paper);
  const rings polygons[] = {{{{0, 0}, {9, 0}, {9, 3}, {3, 3}, {3, 9}, {0, 9}}},
                            {{{0, 0}, {10, 0}, {5, 9}}},
                            {{{0, 0}, {11, 0}, {11, 9}, {0, 9}}, {{1, 1}, {1, 8}, {5, 8}, {5, 1}}}};
  int k = 0;
  for (const rings& polygon : polygons) {
    const board b{p, 30 + 210.0 * k++, 155, 15};
    b.fill_rings(polygon, light_blue);
    for (const ring& r : polygon) b.outline(r, 1.5, ink);
    b.dot(*irg::polygon_centroid(polygon), 5, red);
  }
  return p;
}

}  // namespace polygon_pictures
