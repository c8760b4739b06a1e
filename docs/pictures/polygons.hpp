// SPDX-License-Identifier: MIT
// Pictures of the polygon algorithms: points against rings, hulls, triangles, cuts, overlaps, centres.
#pragma once

#include <cmath>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_centroid.hpp>
#include <irg/geometry/polygons_overlap.hpp>
#include <irg/geometry/split_polygon.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/image.hpp>

#include "enlarged.hpp"

namespace polygon_pictures {

using namespace enlarging;
using P = irg::point<double, 2>;
using ring = std::vector<P>;
using rings = std::vector<ring>;
constexpr irg::rgba8 blue{120, 166, 212, 255}, red{204, 96, 72, 255}, light_blue{206, 222, 240, 255},
    light_red{240, 210, 200, 255};

// A part of a picture in which y points up.
struct board {
  picture& p;
  int left, bottom;
  double scale;
  P at(const P& q) const { return {left + q.x * scale, bottom - q.y * scale}; }
  irg::cell cell(const P& q) const {
    return {static_cast<int>(std::floor(at(q).x + 0.5)), static_cast<int>(std::floor(at(q).y + 0.5))};
  }
  void fill(const rings& polygon, irg::rgba8 colour) const {
    rings placed = polygon;
    for (ring& r : placed)
      for (P& q : r) q = at(q);
    irg::fill_polygon(p, placed, irg::fill_rule::even_odd, colour);
  }
  void outline(const ring& r, irg::rgba8 colour) const {
    for (std::size_t i = 0; i < r.size(); ++i) irg::draw_line(p, cell(r[i]), cell(r[(i + 1) % r.size()]), colour);
  }
  void dots(const ring& r, int radius, irg::rgba8 colour) const {
    for (const P& q : r) dot(p, cell(q), radius, colour);
  }
};

// Two rings that run the same way, and a pentagram: what is inside by either rule.
inline picture rules() {
  picture p(640, 200, paper);
  rings polygon{{}, {{14, 1.5}, {19, 1.5}, {19, 8}, {14, 8}}, {{15.5, 3}, {17.5, 3}, {17.5, 6.5}, {15.5, 6.5}}};
  for (int i = 0; i < 5; ++i)
    polygon[0].push_back(
        {6 + 4.6 * std::cos(1.5707963 + i * 2.5132741), 4.6 + 4.6 * std::sin(1.5707963 + i * 2.5132741)});
  for (int k = 0; k < 2; ++k) {
    const board b{p, 320 * k, 195, 16};
    for (double y = 0.5; y < 12; y += 0.75)
      for (double x = 0.5; x < 20; x += 0.75) {
        const auto where =
            irg::point_in_polygon(polygon, P{x, y}, k == 0 ? irg::fill_rule::even_odd : irg::fill_rule::non_zero);
        dot(p, b.cell({x, y}), 3, where == irg::point_location::inside ? blue : pale);
      }
    for (const ring& r : polygon) b.outline(r, ink);
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
  b.fill({of(irg::side_points::leave_out)}, light_blue);
  b.outline(of(irg::side_points::leave_out), ink);
  b.dots(points, 3, ink);
  b.dots(of(irg::side_points::keep), 5, red);
  b.dots(of(irg::side_points::leave_out), 5, blue);
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
    b.fill(polygon, light_blue);
    for (const auto& t : triangles) b.outline({all[t[0]], all[t[1]], all[t[2]]}, blue);
    for (const ring& r : polygon) b.outline(r, ink);
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
  const board b{p, 10, 235, 15};
  b.fill({comb}, pale);
  b.outline(comb, ink);
  irg::draw_line(p, b.cell(from), b.cell(over), red);
  const auto parts = irg::split_polygon(comb, from, over);
  const board upper{p, 440, 105, 7}, lower{p, 440, 225, 7};
  for (const ring& r : parts.front) upper.fill({r}, light_blue), upper.outline(r, ink), upper.dots(r, 2, ink);
  for (const ring& r : parts.back) lower.fill({r}, light_red), lower.outline(r, ink), lower.dots(r, 2, ink);
  return p;
}

inline picture overlaps() {
  picture p(640, 190, paper);
  const ring bay{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
  const ring tongue{{4.5, 4}, {5.5, 10}, {3.5, 10}};
  for (int k = 0; k < 3; ++k) {
    const board b{p, 30 + 210 * k, 170, 15};
    ring moved = tongue;
    for (P& q : moved) q.y -= k;
    const auto found = irg::polygons_overlap(bay, moved);
    b.fill({bay}, light_blue);
    b.fill({moved}, found == irg::polygon_overlap::separate   ? pale
                    : found == irg::polygon_overlap::touching ? light_red
                                                              : red);
    b.outline(bay, ink);
    b.outline(moved, ink);
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
    const board b{p, 30 + 210 * k++, 155, 15};
    b.fill(polygon, light_blue);
    for (const ring& r : polygon) b.outline(r, ink);
    dot(p, b.cell(*irg::polygon_centroid(polygon)), 5, red);
  }
  return p;
}

}  // namespace polygon_pictures
