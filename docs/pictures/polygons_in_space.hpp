// SPDX-License-Identifier: MIT
// Pictures of polygons in space: seen along the three axes, and Newell's plane of one that is not flat. Included by
// pictures.cpp.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <irg/geometry/flat_ring.hpp>
#include <irg/geometry/textbook/planes.hpp>
#include <irg/geometry/plane.hpp>

#include "board.hpp"

namespace polygons_in_space {

using namespace sketching;
using P = point2;
constexpr irg::rgba8 sky{150, 188, 224, 255};
using Q = point3;
using V = vec3;
using space_ring = std::vector<Q>;

// Space as seen from above and in front: x to the lower left, y to the right, z up.
inline P seen(const Q& q) { return {-0.62 * q.x + 0.92 * q.y, -0.42 * q.x - 0.2 * q.y + q.z}; }
inline ring seen(const space_ring& r) {
  ring flat;
  for (const Q& q : r) flat.push_back(seen(q));
  return flat;
}

// A polygon, its shadows along the three axes on the walls of a box, and the largest of them as a ring of the plane.
inline picture shadows() {
  picture p(640, 300, paper);
  const board b{p, 190, 175, 25};
  constexpr double depth = 7, width = 8, height = 6;
  const space_ring walls[] = {{{0, 0, 0}, {0, width, 0}, {0, width, height}, {0, 0, height}},
                              {{0, 0, 0}, {depth, 0, 0}, {depth, 0, height}, {0, 0, height}},
                              {{0, 0, 0}, {depth, 0, 0}, {depth, width, 0}, {0, width, 0}}};
  const P outline[] = {{1.5, 1.5}, {6, 2}, {6, 6.5}, {3.8, 4}, {1.5, 7}};
  space_ring polygon;
  for (const P& q : outline) polygon.push_back({q.x, q.y, 5.1 - 0.42 * q.x + 0.12 * q.y});
  const int axis = irg::dropped_axis(polygon).value_or(2);
  for (const space_ring& wall : walls) {
    b.fill(seen(wall), {243, 242, 238, 255});
    b.outline(seen(wall), 1, {206, 204, 198, 255});
  }
  for (int k = 0; k < 3; ++k) {
    const irg::flat_ring flat(polygon, k);
    space_ring shadow;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const P q = flat[i];
      shadow.push_back(k == 0 ? Q{0, q.x, q.y} : k == 1 ? Q{q.y, 0, q.x} : Q{q.x, q.y, 0});
    }
    b.fill(seen(shadow), k == axis ? sky : irg::rgba8{212, 210, 205, 255});
    b.outline(seen(shadow), 1.5, k == axis ? blue : grey);
    if (k == axis)
      for (std::size_t i = 0; i < polygon.size(); ++i) b.line(seen(polygon[i]), seen(shadow[i]), 1, blue);
  }
  b.fill(seen(polygon), with_opacity(red, 120));
  b.edges(seen(polygon), 2, red);
  b.dots(seen(polygon), 3.5, ink);
  const board plan{p, 425, 275, 27};
  const irg::flat_ring flat(polygon, axis);
  ring view;
  for (std::size_t i = 0; i < flat.size(); ++i) view.push_back(flat[i]);
  plan.fill(view, sky);
  plan.edges(view, 2, blue);
  plan.dots(view, 3.5, ink);
  return p;
}

// A ring of six vertices, in turn above and below Newell's plane through their centroid, and its normal.
inline picture newell() {
  picture p(640, 300, paper);
  const board b{p, 320, 170, 51};
  space_ring polygon;
  for (int i = 0; i < 6; ++i) {
    const double angle = i * 1.0471975511965976;
    polygon.push_back({3.4 * std::cos(angle), 4.4 * std::sin(angle), i % 2 == 0 ? 0.8 : -0.8});
  }
  const irg::plane<double> plane = *irg::newell_plane_through_centroid(polygon);
  const V normal = irg::normal_of(plane);
  const double length = std::sqrt(irg::dot(normal, normal));
  const auto foot = [&](const Q& q) { return q - normal * (irg::plane_value(plane, q) / (length * length)); };
  space_ring feet;
  V sum{0, 0, 0};
  for (const Q& q : polygon) {
    feet.push_back(foot(q));
    sum = sum + (q - polygon[0]);
  }
  const Q centroid = polygon[0] + sum * (1.0 / 6);
  b.fill(seen(feet), light_blue);
  b.outline(seen(feet), 1, blue);
  b.outline(seen(polygon), 2.5, ink);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const bool above = irg::side_of(plane, polygon[i]) == irg::side::above;
    b.line(seen(polygon[i]), seen(feet[i]), 2, above ? blue : red);
    b.dot(seen(polygon[i]), 5, above ? blue : red);
    const auto corner =
        irg::plane_through(irg::ring_vertex(polygon, i + 5), polygon[i], irg::ring_vertex(polygon, i + 1));
    const V across = irg::normal_of(*corner);
    arrow(p, b.at(seen(polygon[i])), b.at(seen(polygon[i] + across * (1.3 / std::sqrt(irg::dot(across, across))))), 1.5,
          grey);
  }
  arrow(p, b.at(seen(centroid)), b.at(seen(centroid + normal * (2.6 / length))), 3, blue);
  b.dot(seen(centroid), 4, ink);
  return p;
}

}  // namespace polygons_in_space
