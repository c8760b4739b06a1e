// SPDX-License-Identifier: MIT
// Pictures of lines in geometry: what two segments have in common, the part of a triangle that is nearest, the smallest
// circle around points. Included by number_and_geometry_pages.cpp.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <irg/geometry/closest_point.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/smallest_sphere.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_aa.hpp>

#include "enlarged.hpp"

namespace lines_geometry {

using namespace enlarging;
using point2 = irg::point<double, 2>;
using point3 = irg::point<double, 3>;
inline constexpr irg::rgba8 red{204, 76, 58, 255}, blue{62, 112, 176, 255}, grey{150, 150, 148, 255};

inline irg::cell cell_of(const point2& p) {
  return {static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))};
}

inline void stroke(picture& p, const point2& a, const point2& b, int width, irg::rgba8 colour) {
  irg::draw_line_aa(p, a, b, colour, {.width = width * irg::one_pixel});
}

// Pairs of segments, and in red what they have in common.
inline picture segments() {
  picture p(720, 150, paper);
  const std::array<std::array<point2, 4>, 5> pairs{{{point2{20, 120}, {120, 30}, {30, 30}, {110, 125}},
                                                    {point2{20, 120}, {120, 30}, {75, 70.5}, {120, 120}},
                                                    {point2{25, 75}, {75, 30}, {75, 30}, {110, 120}},
                                                    {point2{20, 120}, {90, 57}, {60, 84}, {120, 30}},
                                                    {point2{20, 110}, {110, 29}, {40, 125}, {130, 44}}}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    auto q = pairs[i];
    for (point2& v : q) v.x += static_cast<double>(i) * 142;
    stroke(p, q[0], q[1], 2, blue);
    stroke(p, q[2], q[3], 2, grey);
    const auto m = irg::intersect_segments(q[0], q[1], q[2], q[3]);
    if (m.relation == irg::segment_relation::overlap) stroke(p, m.first, m.last, 4, red);
    if (m.relation != irg::segment_relation::none) {
      dot(p, cell_of(m.first), 4, red);
      dot(p, cell_of(m.last), 4, red);
    }
  }
  return p;
}

// Each pixel in the colour of the part of the triangle that is nearest to it; lines lead to the nearest points.
inline picture regions() {
  picture p(480, 320, paper);
  const point3 a{150, 220, 0}, b{330, 250, 0}, c{230, 70, 0};
  const irg::rgba8 colours[] = {{238, 210, 150, 255}, {214, 224, 240, 255}, {214, 240, 220, 255}, {240, 216, 220, 255},
                                {186, 204, 232, 255}, {190, 228, 200, 255}, {232, 194, 200, 255}};
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) {
      const auto m = *irg::closest_point_on_triangle(a, b, c, {x + 0.5, y + 0.5, 0});
      p(x, y) = colours[static_cast<int>(m.region)];
    }
  for (const auto& edge : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
    stroke(p, {edge[0].x, edge[0].y}, {edge[1].x, edge[1].y}, 2, ink);
  for (const point3& q :
       {point3{60, 280, 0}, {430, 280, 0}, {236, 24, 0}, {240, 300, 0}, {380, 130, 0}, {110, 90, 0}}) {
    const point3 at = irg::closest_point_on_triangle(a, b, c, q)->at;
    stroke(p, {q.x, q.y}, {at.x, at.y}, 1, red);
    dot(p, cell_of({q.x, q.y}), 3, red);
    dot(p, cell_of({at.x, at.y}), 3, red);
  }
  return p;
}

// Points, the smallest circle around them, and in red the points it rests on.
inline picture circle() {
  picture p(480, 320, paper);
  std::vector<point2> points;
  for (int i = 0; i < 60; ++i) {
    const double angle = i * 2.399963, reach = 16 * std::sqrt(static_cast<double>(i));
    points.push_back({240 + 1.15 * reach * std::cos(angle), 160 + 0.9 * reach * std::sin(angle)});
  }
  points.push_back({170, 281});
  const auto ball = *irg::smallest_sphere(points);
  point2 last{ball.centre.x + ball.radius, ball.centre.y};
  for (int i = 1; i <= 180; ++i) {
    const double angle = i * 3.14159265358979 / 90;
    const point2 next{ball.centre.x + ball.radius * std::cos(angle), ball.centre.y + ball.radius * std::sin(angle)};
    stroke(p, last, next, 2, blue);
    last = next;
  }
  for (const point2& q : points) {
    const double distance = std::hypot(q.x - ball.centre.x, q.y - ball.centre.y);
    const bool carries = std::fabs(distance - ball.radius) < 1e-9;
    dot(p, cell_of(q), carries ? 5 : 2, carries ? red : ink);
  }
  dot(p, cell_of(ball.centre), 2, blue);
  return p;
}

}  // namespace lines_geometry
