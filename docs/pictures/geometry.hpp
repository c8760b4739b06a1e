// SPDX-License-Identifier: MIT
// Pictures of lines, orders and boxes: sides and parameters of a line, points in order, distances from a line, boxes
// around shapes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/compare.hpp>
#include <irg/geometry/compare_distance_to.hpp>
#include <irg/geometry/line.hpp>
#include <irg/geometry/parametric_line.hpp>
#include <irg/geometry/polygons_overlap.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/side_of_line.hpp>

#include "sketch.hpp"

namespace geometry_pictures {

using namespace sketching;
using irg::product;

// A place of a part of the picture whose y points up; one unit is one pixel.
struct sheet {
  double left, bottom;
  point2 at(const point2& q) const { return {left + q.x, bottom - q.y}; }
  point2 from(int x, int y) const { return {x + 0.5 - left, bottom - (y + 0.5)}; }
};

// The line through two points: its sides and distances, and its points by their parameters.
inline picture lines() {
  constexpr int panel = 310, height = 230;
  picture p(2 * panel + 20, height, paper);
  const point2 a{90, 60}, b{220, 135};
  const sheet left{0, height}, right{panel + 20, height};
  const irg::line<double> l = *irg::line_through(a, b);
  const vec2 normal = irg::normalized(vec2{l.a, l.b});
  const double length = irg::length(vec2{l.a, l.b});
  const auto ends = [&](const sheet& s) {
    return ring{s.at(irg::point_between(a, b, -0.68)), s.at(irg::point_between(a, b, 1.67))};
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < panel; ++x) {
      const point2 q = left.from(x, y);
      const bool second = static_cast<int>(std::floor(std::fabs(irg::line_value(l, q)) / length / 25)) % 2 == 1;
      const int side = irg::sign_of(irg::side_of_line(l, q));
      p(x, y) = side > 0 ? (second ? irg::rgba8{184, 208, 234, 255} : light_blue)
                         : (second ? irg::rgba8{232, 194, 180, 255} : light_red);
    }
  stroke(p, ends(left), 1.5, ink);
  arrow(p, left.at(a), left.at(irg::point_between(a, b, 0.94)), 3, ink);
  const point2 middle = irg::point_between(a, b, 0.5);
  arrow(p, left.at(middle), left.at(middle + normal * 50.0), 3, blue);
  for (const point2& q : {a, b}) mark(p, left.at(q), 4.5, ink);
  stroke(p, ends(right), 1.5, grey);
  arrow(p, right.at(a), right.at(irg::point_between(a, b, 0.92)), 3, ink);
  for (int k = -2; k <= 6; ++k) {
    const double t = k / 4.0;
    const auto part = irg::part_of_line(t);
    mark(p, right.at(irg::point_between(a, b, t)), k == 0 || k == 4 ? 7 : 4.5,
         part == irg::line_part::segment        ? ink
         : part == irg::line_part::before_start ? red
                                                : blue);
  }
  return p;
}

// The signs over a grid of doubles, steps of 2^-53 apart from `first` on, each as a square: positive ones blue, zeros
// yellow, negative ones red.
template <class Sign>
void signs(picture& p, int left, int size, int zoom, const point2& first, const Sign& sign) {
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double s = sign(point2{first.x + (x / zoom) * 0x1p-53, first.y + (y / zoom) * 0x1p-53});
      p(left + x, size - 1 - y) = s > 0 ? irg::rgba8{92, 142, 196, 255} : s < 0 ? irg::rgba8{204, 96, 72, 255} : yellow;
    }
}

// The signs of 0.6x + 0.7y + c for c close to -1.3, near that line: from rounded operations, and exactly.
inline picture sides() {
  constexpr int size = 256, gap = 16, zoom = 8;
  constexpr irg::line<double> l{0.6, 0.7, -1.3 + 11 * 0x1p-52};
  constexpr point2 first{1 - 34 * 0x1p-53, 1 - 34 * 0x1p-53};
  picture p(2 * size + gap, size, white);
  signs(p, 0, size, zoom, first, [&](const point2& q) { return (product(l.a, q.x) + product(l.b, q.y)) + l.c; });
  signs(p, size + gap, size, zoom, first,
        [&](const point2& q) { return static_cast<double>(irg::sign_of(irg::side_of_line(l, q))); });
  return p;
}

inline std::vector<point2> scattered(int count) {
  std::vector<point2> points;
  std::uint32_t state = 5;
  const auto next = [&](double range) {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>(state >> 8) / 0x1p24 * range;
  };
  while (static_cast<int>(points.size()) < count) {
    const point2 q{12 + next(176), 12 + next(176)};
    if (std::all_of(points.begin(), points.end(), [&](const point2& r) { return irg::length(q - r) > 15; }))
      points.push_back(q);
  }
  return points;
}

// From dark blue through green to yellow and red.
inline irg::rgba8 rank_colour(double t) {
  constexpr irg::rgba8 ramp[] = {{40, 60, 120, 255}, {50, 140, 150, 255}, {230, 190, 70, 255}, {200, 60, 40, 255}};
  const int i = std::min(static_cast<int>(t * 3), 2);
  return irg::mix(ramp[i], ramp[i + 1], static_cast<std::uint8_t>((t * 3 - i) * 255));
}

// The same points in the order of their coordinates, of their way along a line, of their distance from a point; behind
// every tenth a line of equals.
inline picture orders() {
  constexpr int panel = 200, gap = 20;
  picture p(3 * panel + 2 * gap, panel, paper);
  const point2 a{15, 60}, b{185, 130}, centre{80, 90};
  const vec2 along = irg::normalized(b - a), across{-along.y, along.x};
  const sheet s{0, panel};
  for (int k = 0; k < 3; ++k) {
    picture part(panel, panel, paper);
    auto points = scattered(70);
    std::sort(points.begin(), points.end(), [&](const point2& q, const point2& r) {
      return (k == 0   ? irg::compare_lexicographic(q, r)
              : k == 1 ? irg::order_along_line(a, b, q, r)
                       : irg::compare_distance(centre, q, r)) < 0;
    });
    for (std::size_t i = 9; i < points.size(); i += 10) {
      const point2& q = points[i];
      if (k == 0) stroke(part, {s.at({q.x, -10}), s.at({q.x, 210})}, 1, grey);
      if (k == 1) stroke(part, {s.at(q - across * 400.0), s.at(q + across * 400.0)}, 1, grey);
      if (k == 2) outline(part, circle(s.at(centre), irg::length(q - centre)), 1, grey);
    }
    if (k == 1) arrow(part, s.at(a), s.at(b), 2.5, ink);
    if (k == 2) mark(part, s.at(centre), 5, ink);
    for (std::size_t i = 0; i < points.size(); ++i)
      disc(part, s.at(points[i]), 4.5, rank_colour(static_cast<double>(i) / static_cast<double>(points.size() - 1)));
    paste(p, part, k * (panel + gap), 0);
  }
  return p;
}

// Pixels that are nearer to a line than a point is, and those that are not; next to such a border, steps of 2^-53
// apart, the same from rounded operations and exactly.
inline picture nearer() {
  constexpr int size = 200, gap = 20;
  constexpr irg::rgba8 near{174, 194, 220, 255}, far{226, 172, 156, 255};
  picture p(3 * size + 2 * gap, size, white);
  const point2 a{20, 70}, b{180, 130}, v{130, 160};
  const sheet s{0, size};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) p(x, y) = irg::compare_distance_to_line(a, b, v, s.from(x, y)) > 0 ? near : far;
  stroke(p, {s.at(irg::point_between(a, b, -0.12)), s.at(irg::point_between(a, b, 1.12))}, 2.5, ink);
  for (const point2& q : {a, b}) disc(p, s.at(q), 4, ink);
  mark(p, s.at(v), 5, red);
  const point2 c{12, 12}, d{25, 24.5}, e{0.5 + 0x1p-49, 0.5 + 0x1p-49};
  const auto twice_area = [&](const point2& q) {
    return std::fabs(product(d.x - c.x, q.y - c.y) - product(d.y - c.y, q.x - c.x));
  };
  signs(p, size + gap, size, 4, {0.5, 0.5}, [&](const point2& q) { return twice_area(e) - twice_area(q); });
  signs(p, 2 * (size + gap), size, 4, {0.5, 0.5},
        [&](const point2& q) { return static_cast<double>(irg::compare_distance_to_line(c, d, e, q)); });
  return p;
}

// Shapes and the boxes around them: apart; boxes that overlap though the shapes do not; shapes that overlap.
inline picture boxes() {
  constexpr irg::rgba8 shared{246, 196, 178, 255};
  picture p(640, 160, paper);
  const ring star{{30, 60}, {24, 39}, {6, 36}, {22, 26}, {18, 5}, {33, 20}, {52, 10}, {44, 29}, {56, 44}, {37, 41}};
  const ring sickle{{0, 112}, {50, 92}, {82, 52}, {90, 0}, {116, 30}, {110, 78}, {74, 114}, {34, 128}};
  const struct {
    vec2 star, sickle;
  } places[] = {{{0, 15}, {72, 10}}, {{44, 16}, {40, 14}}, {{88, 48}, {40, 14}}};
  for (int k = 0; k < 3; ++k) {
    const sheet s{10.0 + 215 * k, 152};
    ring first, second;
    for (const point2& q : star) first.push_back(q + places[k].star);
    for (const point2& q : sickle) second.push_back(q + places[k].sickle);
    const auto b = irg::bounding_box(first), c = irg::bounding_box(second);
    const auto ring_of = [&](const irg::box<double, 2>& box) {
      return ring{s.at(irg::corner(box, 0)), s.at(irg::corner(box, 1)), s.at(irg::corner(box, 3)),
                  s.at(irg::corner(box, 2))};
    };
    const bool over = irg::overlap(b, c);
    const auto meet = irg::polygons_overlap(first, second);
    for (const auto& box : {b, c}) area(p, ring_of(box), light_blue);
    if (over)
      area(p,
           ring_of({{std::max(b.low.x, c.low.x), std::max(b.low.y, c.low.y)},
                    {std::min(b.high.x, c.high.x), std::min(b.high.y, c.high.y)}}),
           shared);
    for (const auto& box : {b, c}) outline(p, ring_of(box), 1.5, over ? red : blue);
    for (ring* shape : {&second, &first}) {
      for (point2& q : *shape) q = s.at(q);
      area(p, *shape, meet == irg::polygon_overlap::separate ? with_opacity(ink, 190) : with_opacity(red, 190));
    }
  }
  return p;
}

}  // namespace geometry_pictures
