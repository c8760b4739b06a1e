// SPDX-License-Identifier: MIT
// B-splines and NURBS: a cubic with its basis functions below, and a circle beside the spline of the same points; a
// cubic refined and in pieces; a Bezier curve with its box, nearest places and
// crossings; joints.
// Included by pictures.cpp.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include <irg/curve/bezier_queries.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_knots.hpp>
#include <irg/curve/curve_joint.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/draw_line.hpp>

#include "enlarged.hpp"

namespace splines {

using namespace enlarging;
using P = irg::point<double, 2>;

constexpr irg::rgba8 colours[] = {{48, 90, 140, 255},  {204, 96, 72, 255},  {72, 140, 88, 255},  {150, 96, 160, 255},
                                  {190, 140, 40, 255}, {92, 142, 196, 255}, {120, 120, 120, 255}};

inline irg::cell cell(const P& p) { return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))}; }

// Joins f(0), f(1/n), ..., f(1).
template <class F>
void draw(picture& p, irg::rgba8 colour, const F& f) {
  constexpr int steps = 240;
  irg::cell last = cell(f(0.0));
  for (int k = 1; k <= steps; ++k) {
    const irg::cell next = cell(f(k / double{steps}));
    irg::draw_line(p, last, next, colour);
    last = next;
  }
}

template <std::size_t N>
void control_polygon(picture& p, const std::array<P, N>& points) {
  for (std::size_t i = 0; i + 1 < N; ++i) irg::draw_line(p, cell(points[i]), cell(points[i + 1]), pale);
  for (const P& c : points) dot(p, cell(c), 3, ink);
}

// A cubic whose knot at 2 is a double one, and its seven basis functions over the same stretch.
inline void cubic(picture& p) {
  constexpr std::array<double, 11> knots{0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3};
  constexpr std::array<P, 7> points{P{30, 190}, P{50, 40},  P{150, 30}, P{180, 190},
                                    P{230, 60}, P{320, 30}, P{350, 180}};
  const irg::bspline_knots<double, 3> u(knots);
  control_polygon(p, points);
  draw(p, colours[1], [&](double t) { return *irg::bspline_point(u, points, 3 * t); });
  for (const double t : {1.0, 2.0}) dot(p, cell(*irg::bspline_point(u, points, t)), 4, colours[0]);
  for (std::size_t i = 0; i < points.size(); ++i)
    draw(p, colours[i], [&](double t) {
      const auto basis = *irg::bspline_basis(u, 3 * t);
      const double value = basis.first <= i && i <= basis.first + 3 ? basis.value[i - basis.first] : 0;
      return P{30 + 320 * t, 310 - 90 * value};
    });
}

// Nine points on a square: with the weights of a circle, and with equal ones.
inline void circle(picture& p) {
  constexpr std::array<double, 12> knots{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  const double half = std::sqrt(0.5);
  const std::array<double, 9> weights{1, half, 1, half, 1, half, 1, half, 1};
  constexpr std::array<P, 9> points{P{630, 165}, P{630, 45},  P{510, 45},  P{390, 45}, P{390, 165},
                                    P{390, 285}, P{510, 285}, P{630, 285}, P{630, 165}};
  const irg::bspline_knots<double, 2> u(knots);
  control_polygon(p, points);
  draw(p, colours[0], [&](double t) { return *irg::bspline_point(u, points, 4 * t); });
  draw(p, colours[1], [&](double t) { return *irg::nurbs_point(u, points, std::span<const double>(weights), 4 * t); });
}

inline picture both() {
  picture p(660, 330, paper);
  cubic(p);
  circle(p);
  return p;
}

// One cubic three times: its control polygon with that after three more knots, that of its pieces, and of degree 4.
inline picture other_knots() {
  picture p(990, 250, paper);
  constexpr std::array<double, 10> knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  constexpr std::array<double, 3> more{0.5, 1.5, 2.5};
  for (int k = 0; k < 3; ++k) {
    const double x = 330 * k;
    const std::array<P, 6> points{P{x + 25, 215},  P{x + 50, 45},   P{x + 140, 25},
                                  P{x + 175, 225}, P{x + 265, 225}, P{x + 300, 45}};
    const irg::bspline_knots<double, 3> u(knots);
    control_polygon(p, points);
    draw(p, colours[1], [&](double t) { return *irg::bspline_point(u, points, 3 * t); });
    std::array<double, 8> scratch{};
    const auto polygon = [&](std::span<const P> c, irg::rgba8 colour) {
      for (std::size_t i = 0; i + 1 < c.size(); ++i) irg::draw_line(p, cell(c[i]), cell(c[i + 1]), colour);
      for (const P& q : c) dot(p, cell(q), 3, colour);
    };
    if (k == 0) {
      std::array<double, 13> merged{};
      std::array<P, 9> refined{};
      static_cast<void>(irg::insert_knots(u, more, merged));
      irg::bspline_refine(u, points, irg::bspline_knots<double, 3>(merged), refined, scratch);
      polygon(refined, colours[0]);
    } else if (k == 1) {
      std::array<P, 4> piece{};
      std::size_t count = 0;
      irg::bspline_bezier_pieces(u, points, scratch, piece, [&](double, double, std::span<const P> c) {
        polygon(c, colours[count++ % 2 == 0 ? 0 : 2]);
      });
    } else {
      std::array<double, 22> raised{};
      const auto list = std::span<const double>(raised).first(irg::elevated_knots(u, raised));
      const irg::bspline_knots<double, 4> elevated(list);
      std::array<P, 9> result{};
      irg::bspline_elevate(u, points, elevated, result, scratch);
      polygon(std::span<const P>(result).first(elevated.size()), colours[3]);
    }
  }
  return p;
}

// A curve of degree 5 in its box, its places nearest to three points, and where a line crosses it.
inline picture queries() {
  picture p(560, 300, paper);
  constexpr std::array<P, 6> points{P{60, 230}, P{40, -60}, P{250, 60}, P{230, 420}, P{500, 330}, P{500, 40}};
  std::array<irg::vec<double, 1>, 48> scratch{};
  std::array<P, 6> work{};
  control_polygon(p, points);
  const auto box = irg::bezier_box(points, scratch);
  const std::array<P, 5> sides{box.low, P{box.high.x, box.low.y}, box.high, P{box.low.x, box.high.y}, box.low};
  for (std::size_t i = 0; i < 4; ++i) irg::draw_line(p, cell(sides[i]), cell(sides[i + 1]), colours[6]);
  const P a{20, 120}, b{540, 190};
  irg::draw_line(p, cell(a), cell(b), colours[4]);
  draw(p, colours[1], [&](double t) { return irg::bezier_point(points, t); });
  for (const P& q : {P{120, 200}, P{310, 100}, P{430, 90}}) {
    const auto place = irg::bezier_nearest(points, q, scratch, work);
    irg::draw_line(p, cell(q), cell(place.point), colours[0]);
    dot(p, cell(q), 4, colours[0]);
    dot(p, cell(place.point), 3, colours[0]);
  }
  irg::bezier_line_intersections(points, a, b, scratch, [&](const irg::root_interval<double>& z) {
    dot(p, cell(irg::bezier_point(points, z.middle())), 4, colours[2]);
  });
  return p;
}

// Two cubics that meet in five ways; the points are placed by what continuity_of says of them.
inline picture joints() {
  picture p(760, 190, paper);
  using enum irg::curve_continuity;
  const std::array<P, 4> first{P{15, 160}, P{20, 60}, P{50, 60}, P{75, 90}};
  const std::array<P, 4> second[] = {{P{75, 105}, P{90, 160}, P{120, 150}, P{135, 40}},
                                     {P{75, 90}, P{80, 160}, P{120, 150}, P{135, 40}},
                                     {P{75, 90}, P{87.5, 105}, P{120, 150}, P{135, 40}},
                                     {P{75, 90}, P{100, 120}, P{120, 170}, P{135, 40}},
                                     {P{75, 90}, P{100, 120}, P{120, 180}, P{135, 40}}};
  const irg::curve_continuity expected[] = {apart, position, direction, first_derivative, second_derivative};
  for (int k = 0; k < 5; ++k) {
    const P shift{150.0 * k, 0};
    const auto moved = [&](std::array<P, 4> c) {
      for (P& q : c) q.x += shift.x;
      return c;
    };
    const auto a = moved(first), b = moved(second[k]);
    const bool is_right = irg::continuity_of(a, b) == expected[k];
    control_polygon(p, a);
    control_polygon(p, b);
    draw(p, colours[0], [&](double t) { return irg::bezier_point(a, t); });
    draw(p, colours[is_right ? 1 : 6], [&](double t) { return irg::bezier_point(b, t); });
    dot(p, cell(a[3]), 4, colours[2]);
  }
  return p;
}

}  // namespace splines
