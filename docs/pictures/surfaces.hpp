// SPDX-License-Identifier: MIT
// Surfaces made of curves: turned, ruled, swept. Included by pictures.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <irg/curve/bspline_surface.hpp>
#include <irg/curve/curve_frame.hpp>
#include <irg/curve/surface_nets.hpp>
#include <irg/curve/surface_trimming.hpp>
#include <irg/math/trigonometry.hpp>

#include "sketch.hpp"

namespace surface_pictures {

using namespace sketching;
using hpoint2 = irg::hpoint<double, 2>;
using hpoint3 = irg::hpoint<double, 3>;

// Space seen from afar, turned about y, then tipped towards the viewer; z of the result is nearness.
struct far_view {
  point2 centre;
  double unit, yaw, pitch;
  point3 turned(const point3& p) const {
    const double x = irg::cos(yaw) * p.x + irg::sin(yaw) * p.z, z = irg::cos(yaw) * p.z - irg::sin(yaw) * p.x;
    return {x, irg::cos(pitch) * p.y - irg::sin(pitch) * z, irg::sin(pitch) * p.y + irg::cos(pitch) * z};
  }
  point2 at(const point3& p) const {
    const point3 q = turned(p);
    return {centre.x + unit * q.x, centre.y - unit * q.y};
  }
};

inline irg::rgba8 shaded(irg::rgba8 colour, double light) {
  const auto part = [&](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::clamp(c * (0.35 + 0.65 * light), 0.0, 255.0));
  };
  return {part(colour.r), part(colour.g), part(colour.b), 255};
}

// Facets given by corners, the farthest first, with their edges.
struct facets {
  far_view view;
  std::vector<std::vector<point3>> all{};
  void draw(picture& p, irg::rgba8 colour, double edge) {
    const auto nearness = [&](const std::vector<point3>& f) {
      double sum = 0;
      for (const point3& q : f) sum += view.turned(q).z;
      return sum / static_cast<double>(f.size());
    };
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return nearness(a) < nearness(b); });
    for (const auto& f : all) {
      ring outline_of;
      for (const point3& q : f) outline_of.push_back(view.at(q));
      const auto n =
          irg::try_normalized(cross(view.turned(f[1]) - view.turned(f[0]), view.turned(f[2]) - view.turned(f[0])));
      const vec3 light = irg::normalized(vec3{-0.4, 0.7, 0.8});
      area(p, outline_of, shaded(colour, n ? std::fabs(dot(*n, light)) : 1));
      outline(p, outline_of, edge, shaded(colour, 0.05));
    }
  }
};

// The cells of a lattice of n by m on a surface.
template <class Surface>
inline void add_cells(facets& f, int n, int m, const Surface& at) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) f.all.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
}

inline void vase(picture& p) {
  const std::vector<hpoint2> profile{{0, -1.5, 1},  {1.4, -1.5, 1}, {1.2, 0, 1},
                                     {0.1, 0.3, 1}, {0.5, 1.2, 1},  {0.8, 1.5, 1}};
  const std::array<double, 10> knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  const auto round = irg::circle_knots<double>();
  std::vector<hpoint3> net(9 * profile.size());
  irg::revolution_net<double>(profile, net);
  const irg::bspline_surface<hpoint3, 2, 3> s{
      irg::bspline_knots<double, 2>(round), irg::bspline_knots<double, 3>(knots), {net, profile.size()}};
  facets f{{{170, 220}, 105, 0.3, 0.45}};
  add_cells(f, 24, 12, [&](int i, int j) { return *irg::nurbs_surface_point(s, i / 6., j / 4.); });
  f.draw(p, {214, 150, 110, 255}, 1.5);
}

inline void ruled(picture& p) {
  const auto knots = irg::circle_knots<double>();
  const std::array<double, 4> straight{0, 0, 1, 1};
  const auto low = irg::circle_points(point2{0, 0}, 1.2), high = low;
  std::array<hpoint3, 9> first{}, second{};
  for (std::size_t i = 0; i < 9; ++i) {  // the upper circle is turned by a quarter
    first[i] = {low[i].x, -1.4 * low[i][2], low[i].y, low[i][2]};
    second[i] = {high[i].y, 1.4 * high[i][2], -high[i].x, high[i][2]};
  }
  std::array<hpoint3, 18> net{};
  irg::ruled_net<hpoint3>(first, second, net);
  const irg::bspline_surface<hpoint3, 2, 1> s{
      irg::bspline_knots<double, 2>(knots), irg::bspline_knots<double, 1>(straight), {net, 2}};
  facets f{{{500, 220}, 110, 0.4, 0.4}};
  add_cells(f, 24, 4, [&](int i, int j) { return *irg::nurbs_surface_point(s, i / 6., j / 4.); });
  f.draw(p, {120, 160, 205, 255}, 1.5);
}

inline void swept(picture& p) {
  const auto place = [](int k) {
    const double t = k * 0.5;
    return point3{irg::cos(t), 0.16 * t - 1, irg::sin(t)};
  };
  constexpr int rows = 28;
  const std::vector<point2> section{{-0.3, -0.1}, {-0.3, 0.3}, {0.3, 0.3}, {0.3, -0.1}, {0, -0.3}, {-0.3, -0.1}};
  std::vector<point3> net;
  auto frame = *irg::frame_with_up(place(1) - place(0), vec3{0, 1, 0});
  for (int k = 0; k < rows; ++k) {
    net.resize(net.size() + section.size());
    irg::section_row<double>(frame, place(k), section, std::span(net).last(section.size()));
    frame = irg::rotation_minimizing_frame(frame, place(k + 1) - place(k), place(k + 2) - place(k));
  }
  std::vector<double> along(4, 0), round{0, 0, 0, 1, 2, 3, 4, 4, 4};
  for (int k = 1; k < rows - 3; ++k) along.push_back(k);
  along.resize(rows + 4, rows - 3);
  const irg::bspline_surface<point3, 3, 2> s{
      irg::bspline_knots<double, 3>(along), irg::bspline_knots<double, 2>(round), {net, section.size()}};
  facets f{{{830, 220}, 115, 0.2, 0.5}};
  add_cells(f, 40, 8, [&](int i, int j) { return *irg::bspline_surface_point(s, (rows - 3) * i / 40., j / 2.); });
  f.draw(p, {150, 180, 120, 255}, 1.2);
}

inline picture made_of_curves() {
  picture p(1000, 440, paper);
  vase(p);
  ruled(p);
  swept(p);
  return halved(p);
}

// Two patches that bend differently and share a border; a patch trimmed by a star with a hole.
inline picture tessellated() {
  picture p(980, 340, paper);
  const std::array<point3, 4> shared{point3{0, 0, 1.2}, {0, 0.9, 0.4}, {0, -0.9, -0.4}, {0, 0, -1.2}};
  std::vector<point3> calm(16), wild(16);
  constexpr std::array<std::array<double, 4>, 3> hills{
      {{1.2, -1.5, 1.6, -0.4}, {-1.8, 2.0, -1.4, 1.6}, {0.6, 0.2, 1.4, 0.1}}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const double x = 0.6 * static_cast<double>(i), bend = i > 0 ? hills[i - 1][j] : 0;
      calm[i * 4 + j] = i == 0 ? shared[3 - j] : point3{-x, 0.15 * shared[3 - j].y, shared[3 - j].z};
      wild[i * 4 + j] = i == 0 ? shared[j] : point3{x, bend, shared[j].z};
    }
  const far_view view{{270, 175}, 112, 0.25, 0.6};
  facets f{view};
  const auto put = [&](const auto& a, const auto& b, const auto& c) { f.all.push_back({a.point, b.point, c.point}); };
  irg::tessellate_within(irg::control_net<point3>{calm, 4}, 0.03, put);
  f.draw(p, {214, 150, 110, 255}, 1.3);
  f.all.clear();
  irg::tessellate_within(irg::control_net<point3>{wild, 4}, 0.15, put);
  f.draw(p, {120, 160, 205, 255}, 1.3);
  std::vector<ring> star(2);
  for (int k = 0; k < 10; ++k) {
    const double angle = irg::two_pi<double> * k / 10, far = k % 2 == 0 ? 0.49 : 0.3;
    star[0].push_back({0.5 + far * irg::cos(angle), 0.5 + far * irg::sin(angle)});
    star[1].push_back({0.5 + 0.13 * irg::cos(angle), 0.5 + 0.13 * irg::sin(angle)});
  }
  facets trimmed{{{740, 170}, 155, 0.5, 0.75}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      wild[i * 4 + j] = {0.8 * static_cast<double>(i) - 1.2, (i == 1 || i == 2) == (j == 1 || j == 2) ? 0.8 : -0.3,
                         1.2 - 0.8 * static_cast<double>(j)};
  irg::tessellate_trimmed(
      irg::control_net<point3>{wild, 4}, star, 0.03,
      [&](const auto& a, const auto& b, const auto& c) { trimmed.all.push_back({a.point, b.point, c.point}); });
  trimmed.draw(p, {150, 180, 120, 255}, 1.3);
  return halved(p);
}

}  // namespace surface_pictures
