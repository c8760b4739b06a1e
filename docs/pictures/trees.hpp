// SPDX-License-Identifier: MIT
// Trees of boxes, and rays through them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/spatial/triangle_bvh.hpp>
#include <irg/trace/along_ray.hpp>
#include <irg/visibility/visible_points.hpp>

#include "sketch.hpp"

namespace tree_pictures {

using namespace sketching;
using flat_boxes = std::vector<irg::box<double, 3>>;

// Boxes along a wave, in three sizes.
inline flat_boxes wave() {
  flat_boxes boxes;
  for (int i = 0; i < 90; ++i) {
    const double u = i / 89.0, x = 24 + 332 * u, y = 150 + 90 * irg::sin(7 * u) + 34 * irg::sin(61.0 * i);
    const double half = i % 9 == 0 ? 11 : i % 3 == 0 ? 6 : 3.5;
    boxes.push_back({{x - half, y - half, 0}, {x + half, y + half, 0}});
  }
  return boxes;
}

inline void frames(picture& p, const irg::bvh& tree, std::uint32_t at, int level, double left) {
  const std::array colours{red, irg::rgba8{214, 140, 40, 255}, green, grey};
  for (int k = 0; k < irg::bvh_node::width; ++k) {
    const irg::bvh_node& n = tree.nodes[at];
    if (n.child[k] == irg::no_index) continue;
    const double x0 = static_cast<double>(n.low(0, k)) / tree.scale + left,
                 y0 = static_cast<double>(n.low(1, k)) / tree.scale,
                 x1 = static_cast<double>(n.high(0, k)) / tree.scale + left,
                 y1 = static_cast<double>(n.high(1, k)) / tree.scale;
    const double out = 5.0 - 2 * level;
    outline(p, {{x0 - out, y0 - out}, {x1 + out, y0 - out}, {x1 + out, y1 + out}, {x0 - out, y1 + out}},
            level == 0 ? 2 : 1.2, colours[static_cast<std::size_t>(level)]);
    if (!irg::bvh_node::is_leaf(n.child[k])) frames(p, tree, n.child[k], level + 1, left);
  }
}

// The same boxes in trees by area and by place.
inline picture levels() {
  picture p(780, 300, white);
  const flat_boxes boxes = wave();
  for (int side = 0; side < 2; ++side) {
    const double left = side * 400.0;
    for (const auto& b : boxes)
      area(p,
           {{b.low.x + left, b.low.y},
            {b.high.x + left, b.low.y},
            {b.high.x + left, b.high.y},
            {b.low.x + left, b.high.y}},
           with_opacity(blue, 150));
    const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes),
                                         {side == 0 ? irg::bvh_method::surface_area : irg::bvh_method::morton});
    frames(p, tree, 0, 0, left);
  }
  return p;
}

// The leaves of the same slats in trees by area and with spatial splits.
inline picture parts() {
  picture p(620, 240, white);
  using corners = std::array<irg::point<double, 3>, 3>;
  std::vector<corners> slats;
  for (int i = 0; i < 20; ++i) {
    const double x = 15 + 8.0 * i;
    slats.push_back({{{x, 20, 0}, {x + 110, 220, 0}, {x + 4, 20, 0}}});
  }
  for (int side = 0; side < 2; ++side) {
    const double left = side * 315.0;
    for (const corners& t : slats)
      area(p, {{t[0].x + left, t[0].y}, {t[1].x + left, t[1].y}, {t[2].x + left, t[2].y}}, blue);
    irg::bvh_options config{side == 0 ? irg::bvh_method::surface_area : irg::bvh_method::spatial_splits};
    config.spare = 4;
    const irg::triangle_bvh<double> tree(std::span<const corners>{slats}, config);
    for (const irg::bvh_node& n : tree.tree().nodes)
      for (int k = 0; k < irg::bvh_node::width; ++k) {
        if (n.child[k] == irg::no_index || !irg::bvh_node::is_leaf(n.child[k])) continue;
        const double scale = 1 / tree.tree().scale, x0 = static_cast<double>(n.low(0, k)) * scale + left,
                     y0 = static_cast<double>(n.low(1, k)) * scale,
                     x1 = static_cast<double>(n.high(0, k)) * scale + left,
                     y1 = static_cast<double>(n.high(1, k)) * scale;
        outline(p, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, 1.5, red);
      }
  }
  return p;
}

inline std::vector<std::array<irg::point<double, 3>, 3>> triangles_of(const irg::mesh<double>& body) {
  const irg::mesh<double> m = irg::triangulated(body);
  std::vector<std::array<irg::point<double, 3>, 3>> all;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    all.push_back({m.positions[m.corner(f, 0).position], m.positions[m.corner(f, 1).position],
                   m.positions[m.corner(f, 2).position]});
  return all;
}

// The teapot by rays: left how its first triangle is turned, right how many triangles each ray crosses.
inline picture through() {
  picture p(640, 260, white);
  const auto all = triangles_of(irg::shape_teapot<double>({.subdivisions = 8}));
  const irg::triangle_bvh<double> tree(std::span<const std::array<irg::point<double, 3>, 3>>{all});
  const std::array<irg::rgba8, 9> counts{{{255, 255, 255, 255},
                                          {222, 90, 70, 255},
                                          {214, 226, 240, 255},
                                          {222, 90, 70, 255},
                                          {150, 184, 222, 255},
                                          {222, 90, 70, 255},
                                          {84, 132, 190, 255},
                                          {222, 90, 70, 255},
                                          {30, 70, 130, 255}}};
  for (int y = 0; y < 260; ++y)
    for (int x = 0; x < 320; ++x) {
      const irg::ray<double, 3> r{{(x - 159.5) / 46, (129.5 - y) / 46 + 4.55, 20}, {0.0, -0.15, -1.0}};
      if (const auto hit = irg::closest_hit(tree, r)) {
        const auto& t = all[hit->triangle];
        const irg::vec<double, 3> n = irg::normalized(irg::cross(t[1] - t[0], t[2] - t[0]));
        const double light = irg::dot(n, irg::normalized(irg::vec<double, 3>{-0.5, 0.7, 0.6}));
        const auto shade = [&](double most) {
          return static_cast<std::uint8_t>(most * (0.3 + 0.7 * irg::clamped(light, 0.0, 1.0)));
        };
        p(x, y) = {shade(232), shade(168), shade(96), 255};
      }
      std::size_t crossed = 0;
      irg::all_hits(tree, r, [&](const irg::triangle_hit&) { ++crossed; });
      p(x + 320, y) = counts[crossed < 8 ? crossed : 8];
    }
  return p;
}

// Two triangles that share a side, cut into pixels: which of them a ray through each point crosses.
inline picture shares() {
  picture p(420, 240, white);
  const irg::point<double, 3> a{1, 1, 0}, b{6, 1, 0}, c{6, 5, 0}, d{1, 5, 0};
  const auto screen = [](double x, double y) { return point2{20 + 54 * x, 230 - 40 * y}; };
  area(p, {screen(1, 1), screen(6, 1), screen(6, 5)}, with_opacity(blue, 60));
  area(p, {screen(1, 1), screen(6, 5), screen(1, 5)}, with_opacity(green, 60));
  outline(p, {screen(1, 1), screen(6, 1), screen(6, 5), screen(1, 5)}, 1.2, grey);
  stroke(p, {screen(1, 1), screen(6, 5)}, 1.2, grey);
  for (int i = 0; i <= 14; ++i)
    for (int j = 0; j <= 10; ++j) {
      const irg::ray<double, 3> r{{i * 0.5, i % 5 == 2 ? 1 + (i * 0.5 - 1) * 0.8 : j * 0.5 + 0.5, 3}, {0, 0, -1}};
      const int crossed = irg::intersect_triangle(r, a, b, c) ? 1 : irg::intersect_triangle(r, a, c, d) ? 2 : 0;
      disc(p, screen(r.origin.x, r.origin.y), 3.6,
           crossed == 1   ? blue
           : crossed == 2 ? green
                          : irg::rgba8{200, 200, 200, 255});
    }
  return p;
}

// Sheets from the side, and rays among them: what they cross, and their longest free runs.
inline picture runs() {
  picture p(620, 200, white);
  std::vector<std::array<irg::point<double, 3>, 3>> sheets;
  for (int i = 0; i < 26; ++i) {
    const double x = 30 + 22.5 * i + 6 * irg::sin(9.0 * i), y = 100 + 70 * irg::sin(5.0 * i),
                 half = 22 + 10 * irg::sin(3.0 * i);
    sheets.push_back({{{x, y - half, -50}, {x + 8, y + half, -50}, {x + 4, y, 50}}});
    stroke(p, {{x + 2, y - half / 2}, {x + 6, y + half / 2}}, 2.5, grey);
  }
  const irg::triangle_bvh<double> tree(std::span<const std::array<irg::point<double, 3>, 3>>{sheets});
  for (int k = 0; k < 5; ++k) {
    const irg::ray<double, 3> r{{10, 30.0 + 35 * k, 0}, {600, 0, 0}, 0, 1};
    const auto at = [&](double t) { return point2{r.origin.x + 600 * t, r.origin.y}; };
    const irg::free_run run = irg::longest_free_run(tree, r, 30.0 / 600);
    stroke(p, {at(0), at(1)}, 1, light_red);
    stroke(p, {at(run.from), at(run.to)}, 3, green);
    for (int i = 0; i <= run.steps; ++i) disc(p, at(run.from + i * 30.0 / 600), 2.6, green);
    for (const irg::triangle_hit& h : irg::sorted_hits(tree, r)) disc(p, at(h.at.t), 3.2, red);
  }
  return p;
}

// Points of a lattice that hide each other from a viewer.
inline picture points_seen() {
  picture p(460, 300, white);
  std::vector<point2> points;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 15; ++i)
      if ((i * 7 + j * 5) % 4 != 0) points.push_back({20.0 + 30 * i, 20.0 + 32 * j});
  const point2 viewer{200, 148};
  const auto seen = irg::visible_points(std::span<const point2>(points), viewer);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (seen[i] != 0) stroke(p, {viewer, points[i]}, 0.6, light_blue);
  for (std::size_t i = 0; i < points.size(); ++i)
    disc(p, points[i], seen[i] != 0 ? 4 : 3, seen[i] != 0 ? blue : irg::rgba8{190, 190, 188, 255});
  disc(p, viewer, 5, red);
  return p;
}

}  // namespace tree_pictures
