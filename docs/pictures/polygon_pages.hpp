// SPDX-License-Identifier: MIT
// Pictures of what polygons are asked: sides of edges, orientation, convexity, points in convex polygons, many points
// against a line. Included by number_and_geometry_pages.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <irg/geometry/orient2d_batch.hpp>
#include <irg/geometry/edge_equation.hpp>
#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/raster/line_aa.hpp>

#include "board.hpp"

namespace polygon_pages {

using namespace sketching;
using P = point2;
constexpr irg::rgba8 sky{150, 188, 224, 255}, rose{228, 166, 152, 255};

// The sides of all edges, for a convex polygon and for one with a reflex vertex.
inline picture edges() {
  picture p(640, 300, paper);
  const ring polygons[] = {{{2.5, 2}, {7.5, 1.5}, {10, 5}, {7, 9}, {2, 7.5}},
                           {{2, 1.5}, {9.5, 1.5}, {9.5, 9}, {6, 4.6}, {2, 8.5}}};
  constexpr irg::rgba8 denied{240, 176, 120, 255};
  constexpr irg::rgba8 outside[] = {
      {244, 243, 239, 255}, {244, 243, 239, 255}, {233, 231, 226, 255}, {221, 219, 213, 255}};
  for (int k = 0; k < 2; ++k) {
    const ring& polygon = polygons[k];
    const irg::cell_window panel{325 * k, 0, 325 * k + 315, 300};
    const board b{p, 325.0 * k, 290, 26};
    for (int y = panel.y_first; y < panel.y_last; ++y)
      for (int x = panel.x_first; x < panel.x_last; ++x) {
        const P q = b.back({x + 0.5, y + 0.5});
        int against = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i)
          against += irg::line_value(irg::edge_through(polygon[i], irg::ring_vertex(polygon, i + 1)), q) < 0;
        const bool in = irg::point_in_polygon(polygon, q) == irg::location::inside;
        p(x, y) = in ? against == 0 ? sky : denied : outside[std::min(against, 3)];
      }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const P from = polygon[i], to = irg::ring_vertex(polygon, i + 1), far = from + (to - from) * 20.0,
              before = from + (to - from) * -20.0, middle = from + (to - from) * 0.5;
      irg::draw_line_aa(irg::within(p, panel), b.at(before), b.at(far), grey);
      b.edge(from, to, 2, ink);
      const auto equation = irg::edge_through(from, to);
      const double length = std::hypot(equation.a, equation.b);
      arrow(p, b.at(middle), b.at(middle + vec2{equation.a, equation.b} * (0.95 / length)), 2, red);
    }
    b.dots(polygon, 4, ink);
  }
  return p;
}

inline irg::rgba8 colour_of(irg::orientation o) {
  return o == irg::orientation::clockwise ? red : o == irg::orientation::degenerate ? grey : blue;
}
inline irg::rgba8 tint_of(irg::orientation o) { return o == irg::orientation::clockwise ? light_red : light_blue; }

// A clockwise ring, the same after its repair, and a figure of eight whose halves cancel.
inline picture orientation() {
  picture p(640, 200, paper);
  const ring given{{1, 4.5}, {3.5, 9}, {5.5, 6}, {10, 8}, {8, 1.5}, {3, 1}};
  const ring eight{{1, 2}, {10, 8}, {10, 2}, {1, 8}},
      halves[] = {{{1, 2}, {5.5, 5}, {1, 8}}, {{5.5, 5}, {10, 8}, {10, 2}}};
  ring repaired = given;
  irg::make_counter_clockwise(repaired);
  const auto show = [&](const board& b, const ring& r, std::initializer_list<ring> parts) {
    for (const ring& part : parts) b.fill(part, tint_of(irg::orientation_of(part)));
    b.edges(r, 2, colour_of(irg::orientation_of(r)), r.size() == 4 ? 0.75 : 0.6);
    b.dots(r, 3.5, ink);
    b.dot(r[0], 7, ink);
    b.dot(r[0], 4, paper);
  };
  show({p, 10, 190, 18}, given, {given});
  show({p, 222, 190, 18}, repaired, {repaired});
  show({p, 434, 190, 18}, eight, {halves[0], halves[1]});
  return p;
}

// Four rings, blue when they are convex, and the turn at each vertex.
inline picture convexity() {
  picture p(640, 170, paper);
  ring pentagram;
  for (int i = 0; i < 5; ++i) {
    const double angle = 1.5707963267948966 + i * 2.5132741228718345;
    pentagram.push_back({4 + 4 * std::cos(angle), 4 + 4 * std::sin(angle)});
  }
  const ring rings[] = {{{1, 1}, {6, 0}, {8, 4}, {5, 8}, {0, 6}},
                        {{0, 0}, {4, 0}, {8, 0}, {8, 4}, {6, 6}, {4, 8}, {0, 8}, {0, 4}},
                        {{0, 1}, {8, 0}, {7, 8}, {4, 3}, {1, 8}},
                        pentagram};
  int k = 0;
  for (const ring& r : rings) {
    const board b{p, 20.0 + 160 * k++, 150, 15.5};
    const bool convex = irg::is_convex(r);
    b.fill(r, convex ? light_blue : light_red);
    b.outline(r, 2, convex ? blue : red);
    for (std::size_t i = 0; i < r.size(); ++i) {
      const int turn = irg::orient2d(irg::ring_vertex(r, i + r.size() - 1), r[i], irg::ring_vertex(r, i + 1));
      b.dot(r[i], 6, ink);
      b.dot(r[i], 4.5, turn > 0 ? blue : turn < 0 ? red : yellow);
    }
  }
  return p;
}

// The wedges among which the logarithmic search chooses, darker from step to step; the edge it ends at in red.
inline void search(const board& b) {
  ring r;
  for (int i = 0; i < 17; ++i) {
    const double angle = 3.4 + i * 6.283185307179586 / 17;
    r.push_back({6 + 5.4 * std::cos(angle), 5.3 + 4.6 * std::sin(angle)});
  }
  const P query{9.6, 6.25};
  constexpr irg::rgba8 steps[] = {{236, 241, 247, 255}, {212, 225, 240, 255}, {184, 206, 230, 255},
                                  {152, 184, 218, 255}, {116, 158, 206, 255}, {92, 142, 196, 255}};
  std::size_t low = 1, high = r.size() - 1;
  std::vector<std::size_t> asked{low, high};
  for (int step = 0;; ++step) {
    ring wedge{r[0]};
    for (std::size_t i = low; i <= high; ++i) wedge.push_back(r[i]);
    b.fill(wedge, steps[step]);
    if (high - low == 1) break;
    const std::size_t middle = low + (high - low) / 2;
    asked.push_back(middle);
    (irg::orient2d(r[0], r[middle], query) >= 0 ? low : high) = middle;
  }
  for (std::size_t i = 1; i < r.size(); ++i) b.line(r[0], r[i], 1, grey);
  for (const std::size_t i : asked) b.line(r[0], r[i], 2, ink);
  b.outline(r, 2, ink);
  b.line(r[low], r[high], 4, red);
  b.dots(r, 3.5, ink);
  b.dot(query, 6, paper);
  b.dot(query, 4.5, irg::point_in_convex_polygon(r, query) == irg::location::inside ? red : grey);
}

// Beside it the answers over a lattice: inside, boundary, outside.
inline picture convex_search() {
  constexpr int size = 18, columns = 17, rows = 16;
  using Q = irg::point<int, 2>;
  const std::array<Q, 7> r{Q{2, 5}, Q{5, 2}, Q{11, 2}, Q{15, 6}, Q{13, 12}, Q{7, 14}, Q{3, 10}};
  picture p(640, 300, paper), small(columns, rows, paper);
  search({p, 5, 295, 25.5});
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const auto where = irg::point_in_convex_polygon(r, Q{x, y});
      if (where != irg::location::outside) small(x, rows - 1 - y) = where == irg::location::inside ? sky : rose;
    }
  paste(p, enlarged(small, size), 325, 5);
  const board b{p, 325.0 + size / 2.0, 5 + (rows - 0.5) * size, size};
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) dot(p, {325 + x * size + size / 2, 5 + y * size + size / 2}, 1, ink);
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Q from = r[i], to = irg::ring_vertex(r, i + 1);
    b.line({from.x * 1.0, from.y * 1.0}, {to.x * 1.0, to.y * 1.0}, 1.5, ink);
  }
  return p;
}

// A third of the points of a lattice against the line through two of them.
inline picture batch() {
  picture p(640, 290, paper);
  const board b{p, 10, 280, 10};
  const P from{6, 4}, to{55, 25};
  std::vector<double> x, y;
  std::uint32_t state = 3;
  for (int j = 0; j <= 27; ++j)
    for (int i = 0; i <= 62; ++i) {
      state = state * 1664525u + 1013904223u;
      if ((state >> 24) % 3 == 0 || (3 * i - 7 * j == -10 && i != 6 && i != 55)) x.push_back(i), y.push_back(j);
    }
  std::vector<std::int8_t> signs(x.size());
  irg::orient2d_all(from, to, irg::point_columns{x, y}, signs);
  b.line(from + (to - from) * -0.2, from + (to - from) * 1.2, 1.5, ink);
  b.edge(from, to, 2.5, ink, 0.51);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (signs[i] != 0) b.dot({x[i], y[i]}, 3, signs[i] > 0 ? blue : red);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (signs[i] == 0) b.dot({x[i], y[i]}, 5.5, ink), b.dot({x[i], y[i]}, 4, yellow);
  for (const P& q : {from, to}) b.dot(q, 6, ink);
  return p;
}

}  // namespace polygon_pages
