// SPDX-License-Identifier: MIT
// Pictures of coordinates: named coordinate systems, homogeneous points as rays, projections of vectors, maps of a
// grid.
#pragma once

#include <array>
#include <vector>

#include <irg/math/coordinate_system.hpp>
#include <irg/math/homogeneous.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/transform_points.hpp>
#include <irg/math/vector_projection.hpp>

#include "sketch.hpp"

namespace space_pictures {

using namespace sketching;

// The axes of four systems, and in each the box from the origin to the point of the same coordinates.
inline picture systems() {
  constexpr int width = 160, height = 190;
  picture p(4 * width, height, paper);
  const irg::coordinate_system all[] = {irg::world_y_up, irg::world_z_up, irg::camera_left_handed, irg::screen_y_down};
  for (int i = 0; i < 4; ++i) {
    const irg::coordinate_system& system = all[i];
    if (irg::handedness_of(system) == irg::handedness::left)
      for (int y = 0; y < height; ++y) irg::fill_span(p, {y, i * width, (i + 1) * width}, {238, 233, 222, 255});
    const bool down = system == irg::screen_y_down, away = system.z == irg::axis_direction::away_from_viewer;
    const oblique_view view({i * width + (away ? 48.0 : 62.0), down ? 74.0 : 122.0}, 72, 42, 0.62);
    const auto place = [&](const point3& q) { return view.at(irg::convert(q, system, irg::world_y_up)); };
    const point3 far{0.65, 0.35, 0.2};
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        ring face;
        for (int k = 0; k < 4; ++k) {
          point3 q{};
          q[axis] = side * far[axis];
          q[(axis + 1) % 3] = k == 1 || k == 2 ? far[(axis + 1) % 3] : 0;
          q[(axis + 2) % 3] = k > 1 ? far[(axis + 2) % 3] : 0;
          face.push_back(place(q));
        }
        area(p, face, {216, 180, 120, 70});
        outline(p, face, 1, {190, 160, 110, 255});
      }
    const irg::rgba8 colours[] = {red, green, blue};
    for (int axis = 0; axis < 3; ++axis) {
      point3 tip{}, beyond{};
      tip[axis] = 1.05;
      beyond[axis] = 1.05;
      const point2 end = place(tip), start = place({});
      arrow(p, start, end, 2.5, colours[axis]);
      const vec2 along = irg::normalized(end - start);
      letter(p, "xyz"[axis], end + along * 11, 4.5, colours[axis]);
    }
    disc(p, place({}), 3, ink);
  }
  return p;
}

// Points (x, y, w) on rays through the plane w = 1, and a direction in the plane w = 0.
inline picture rays() {
  picture p(640, 300, paper);
  const oblique_view view({120, 232}, 108, 40, 0.5);
  const auto place = [&](const irg::hpoint<double, 2>& h) { return view.at({h[0], h[2], -h[1]}); };
  const auto plane = [&](double w, irg::rgba8 colour, irg::rgba8 edge) {
    const ring corners{place({-0.8, -0.6, w}), place({4.1, -0.6, w}), place({4.1, 1.3, w}), place({-0.8, 1.3, w})};
    area(p, corners, colour);
    outline(p, corners, 1.2, edge);
  };
  const auto position = [&](const irg::hpoint<double, 2>& h) {
    const auto q = *irg::try_to_cartesian(h);
    return place({q.x, q.y, 1});
  };
  const irg::hpoint<double, 2> direction{0.9, 0.28, 0};
  const std::array<irg::hpoint<double, 2>, 2> points{irg::hpoint<double, 2>{-0.5, 0.1, 1}, {0.35, 0.9, 1}};
  const irg::rgba8 colours[] = {red, green};
  const auto times = [](const irg::hpoint<double, 2>& h, double s) {
    return irg::hpoint<double, 2>{h[0] * s, h[1] * s, h[2] * s};
  };
  const auto weighted = [&](double w) { return irg::hpoint<double, 2>{direction[0], direction[1], w}; };
  plane(0, {232, 229, 222, 255}, grey);
  stroke(p, {place({0, 0, 0}), place({0, 0, 1})}, 1.2, grey);
  for (std::size_t i = 0; i < points.size(); ++i) {
    stroke(p, {place({0, 0, 0}), place(points[i])}, 2, colours[i]);
    mark(p, place(times(points[i], 0.5)), 3.5, colours[i]);
  }
  for (const double w : {1.0, 0.5, 0.25}) stroke(p, {place({0, 0, 0}), position(weighted(w))}, 1.5, blue);
  arrow(p, place({0, 0, 0}), place(direction), 3.5, ink);
  dashes(p, place(direction), place(weighted(1)), 1.5, grey);
  for (const double w : {0.5, 0.25}) mark(p, place(weighted(w)), 3.5, blue);
  disc(p, place({0, 0, 0}), 4, ink);
  plane(1, {150, 186, 224, 90}, blue);
  for (std::size_t i = 0; i < points.size(); ++i) {
    stroke(p, {place(points[i]), place(times(points[i], 1.5))}, 2, colours[i]);
    mark(p, place(times(points[i], 1.5)), 3.5, colours[i]);
    mark(p, position(points[i]), 6, colours[i]);
  }
  for (const double w : {1.0, 0.5, 0.25}) mark(p, position(weighted(w)), 6, blue);
  return p;
}

// The part of a along b, and what is left of a; an acute angle and an obtuse one.
inline picture projection() {
  picture p(640, 230, paper);
  const struct {
    point2 origin;
    vec2 a, b;
  } cases[] = {{{40, 190}, {130, 150}, {250, 45}}, {{470, 165}, {-95, 95}, {130, 40}}};
  for (const auto& [origin, a, b] : cases) {
    const auto place = [&o = origin](const vec2& v) { return point2{o.x + v.x, o.y - v.y}; };
    const vec2 along = *irg::vector_projection(a, b), rest = a - along;
    const vec2 u = irg::normalized(b), n = irg::normalized(rest);
    stroke(p, {place(u * -120.0), place(u * 290.0)}, 1, pale);
    stroke(p,
           {place(along - u * 12.0 * (irg::dot(a, b) < 0 ? -1.0 : 1.0)),
            place(along - u * 12.0 * (irg::dot(a, b) < 0 ? -1.0 : 1.0) + n * 12.0), place(along + n * 12.0)},
           1.2, grey);
    arrow(p, place({}), place(b), 2.5, ink);
    arrow(p, place({}), place(along), 5, red);
    arrow(p, place(along), place(a), 2.5, green);
    arrow(p, place({}), place(a), 3, blue);
    disc(p, place({}), 4, ink);
  }
  return p;
}

// A grid as it is, under an affine map and under a projective one.
inline picture grids() {
  constexpr int n = 8, panel = 213, height = 220;
  picture p(3 * panel + 1, height, paper);
  using mat4 = irg::mat<double, 4, 4>;
  const mat4 maps[] = {irg::identity_matrix<double, 4>(),
                       {{{0.6, 0.36, 0, 0}, {0.28, 0.72, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}},
                       {{{1.05, 0.1, 0, 0.1}, {0.05, 1.2, 0, 0.42}, {0, 0, 1, 0}, {0.12, 0.52, 0, 1.4}}}};
  std::vector<point3> from;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) from.push_back({2.0 * x / n - 1, 2.0 * y / n - 1, 0});
  const char* const shape[] = {"........", "..####..", "..#.....", "..###...",
                               "..#.....", "..#.....", "..#.....", "........"};
  for (int k = 0; k < 3; ++k) {
    std::vector<irg::hpoint<double, 3>> to(from.size());
    irg::transform_points(maps[k], from, to);
    std::vector<point2> at;
    for (const auto& h : to) {
      const point3 q = irg::to_cartesian(h);
      at.push_back({k * panel + panel / 2.0 + 88 * q.x, height / 2.0 - 88 * q.y});
    }
    const auto corner = [&](int x, int y) { return at[static_cast<std::size_t>(y * (n + 1) + x)]; };
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        area(p, {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)},
             shape[n - 1 - y][x] == '#' ? red
             : (x + y) % 2              ? white
                                        : light_blue);
    for (int i = 0; i <= n; ++i) {
      stroke(p, {corner(i, 0), corner(i, n)}, 1.2, blue);
      stroke(p, {corner(0, i), corner(n, i)}, 1.2, blue);
    }
  }
  return p;
}

}  // namespace space_pictures
