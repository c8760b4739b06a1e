// SPDX-License-Identifier: MIT
// Pictures of the view chapter: one cube in every projection, its shadow on a floor, boxes against a frustum, a window
// in a viewport. Included by pictures.cpp.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/image.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/axonometry.hpp>
#include <irg/view/frustum.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/oblique.hpp>
#include <irg/view/plane_projection.hpp>
#include <irg/view/viewport.hpp>
#include <irg/view/window_to_viewport.hpp>

#include "enlarged.hpp"

namespace projection_pictures {

using namespace enlarging;
using point3 = irg::point<double, 3>;
using point2 = irg::point<double, 2>;
using vec3 = irg::vec<double, 3>;
using mat4 = irg::mat<double, 4, 4>;
using window = irg::view_window<double>;
inline constexpr irg::rgba8 light{238, 226, 206, 255}, middle{214, 178, 138, 255}, dark{160, 116, 82, 255},
    shade{206, 204, 200, 255}, green{108, 168, 108, 255}, red{204, 96, 72, 255}, blue{92, 142, 196, 255},
    pale_blue{206, 222, 238, 255};

inline irg::cell cell_at(const point3& p) {
  return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))};
}

// The polygon's picture, filled and with its edges drawn.
inline void polygon(picture& onto, const irg::viewport<double>& view, const mat4& to_clip,
                    const std::vector<point3>& corners, irg::rgba8 fill, irg::rgba8 edge) {
  std::vector<irg::point<float, 2>> ring;
  for (const point3& p : corners) {
    const point3 q = to_pixels(view, to_clip * p);
    ring.push_back({static_cast<float>(q.x), static_cast<float>(q.y)});
  }
  irg::fill_convex(onto, ring, fill);
  for (std::size_t i = 0; i < corners.size(); ++i)
    irg::draw_line(onto, cell_at(to_pixels(view, to_clip * corners[i])),
                   cell_at(to_pixels(view, to_clip * corners[(i + 1) % corners.size()])), edge);
}

// The six faces of the cube from -1 to 1: two on each axis, counter-clockwise seen from outside.
inline std::array<std::vector<point3>, 6> cube_faces() {
  std::array<std::vector<point3>, 6> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int k = 0; k < 4; ++k) {
        const double u = k == 0 || k == 3 ? -1 : 1, v = k < 2 ? -1 : 1;
        point3 p{};
        p[axis] = side ? 1 : -1;
        p[(axis + 1) % 3] = side ? u : v;
        p[(axis + 2) % 3] = side ? v : u;
        faces[static_cast<std::size_t>(2 * axis + side)].push_back(p);
      }
  return faces;
}

// The faces that are seen: a convex body hides its own others only.
inline void cube(picture& onto, const irg::viewport<double>& view, const mat4& to_clip) {
  const auto faces = cube_faces();
  for (std::size_t f = 0; f < 6; ++f) {
    const point3 a = to_pixels(view, to_clip * faces[f][0]), b = to_pixels(view, to_clip * faces[f][1]),
                 c = to_pixels(view, to_clip * faces[f][2]);
    const double turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (turn < -1e-6) polygon(onto, view, to_clip, faces[f], f / 2 == 0 ? dark : f / 2 == 1 ? light : middle, ink);
  }
}

// By angle, one vanishing point (a window off centre), orthographic from the front, isometric;
// dimetric, trimetric, cavalier, cabinet.
inline picture every_projection() {
  constexpr int size = 200;
  picture p(4 * size, 2 * size, paper);
  const window half{-2, 2, -2, 2};
  const auto from = [](const vec3& direction, double away) {
    return irg::look_at(irg::to_point(irg::normalized(direction) * away), point3{}, vec3{0, 1, 0});
  };
  const auto parallel = [&](const vec3& direction) {
    return irg::orthographic(half, -10, 10) * irg::axonometric_view(direction);
  };
  const auto slanted = [&](double factor) {
    return irg::oblique(irg::oblique_depth<double>{irg::radians(45.0), factor, 1}, window{-1.9, 2.9, -1.9, 2.9}, -10,
                        10);
  };
  // Seen from 4 to the right and 3 above, with the picture plane still parallel to the front.
  const auto one_point =
      irg::perspective(window{-5.57, -1.57, -4.71, -0.71}, 5, 1, 20) * irg::translation(vec3{-4, -3, -6});
  const std::array<mat4, 8> views{irg::perspective(irg::radians(46.0), 1, 1, 20) * from({1, 0.8, 1.6}, 5),
                                  one_point,
                                  parallel({0, 0, 1}),
                                  parallel(irg::isometric<double>().to_viewer),
                                  parallel(irg::dimetric<double>().to_viewer),
                                  parallel(irg::trimetric<double>().to_viewer),
                                  slanted(irg::cavalier_factor<double>),
                                  slanted(irg::cabinet_factor<double>)};
  for (int i = 0; i < 8; ++i)
    cube(p, {size * (i % 4) + 10.0, size * (i / 4) + 10.0, size - 20.0, size - 20.0},
         views[static_cast<std::size_t>(i)]);
  return p;
}

// The cube and its shadows on the floor: of a lamp near by, and of the sun.
inline picture shadows() {
  picture p(800, 300, paper);
  const irg::plane<double> floor{0, 1, 0, 1};
  const irg::hpoint<double, 3> lamps[] = {{-2.4, 4, 1.5, 1}, {-0.8, 1.5, 0.4, 0}};
  for (int i = 0; i < 2; ++i) {
    const irg::viewport<double> view{400.0 * i, 0, 400, 300};
    const mat4 to_clip = irg::perspective(irg::radians(36.0), 4.0 / 3, 1, 50) *
                         irg::look_at(point3{2, 4.5, 9}, point3{0.7, -0.3, 0}, vec3{0, 1, 0});
    polygon(p, view, to_clip, {{-2, -1, 2.5}, {3.6, -1, 2.5}, {3.6, -1, -3}, {-2, -1, -3}}, {242, 240, 234, 255}, pale);
    const mat4 shadow = irg::shadow_matrix(floor, lamps[i]);
    for (const auto& face : cube_faces()) polygon(p, view, to_clip * shadow, face, shade, shade);
    cube(p, view, to_clip);
    if (lamps[i].w != 0) dot(p, cell_at(to_pixels(view, to_clip * lamps[i])), 5, red);
  }
  return p;
}

// A frustum from above, and boxes: green inside, red outside, blue across its boundary.
inline picture boxes() {
  constexpr int width = 640, height = 400;
  picture p(width, height, paper);
  const auto f = irg::frustum_of(irg::perspective(irg::radians(50.0), 1.4, 1.5, 8));
  const auto place = [&](double x, double z) { return point3{width / 2 + 42 * x, height - 20 + 42 * z, 0}; };
  const auto corners = irg::frustum_corners(f);
  const auto line = [&](int a, int b, irg::rgba8 colour) {
    const auto &u = corners->at[a], &v = corners->at[b];
    irg::draw_line(p, cell_at(place(u.x, u.z)), cell_at(place(v.x, v.z)), colour);
  };
  for (const auto& [a, b] : {std::array{0, 1}, std::array{1, 5}, std::array{5, 4}, std::array{4, 0}}) line(a, b, ink);
  dot(p, cell_at(place(0, 0)), 4, ink);
  for (int i = 0; i < 13; ++i)
    for (int k = 0; k < 8; ++k) {
      const double x = -6.6 + 1.05 * i, z = -8.6 + 1.05 * k;
      const irg::box<double, 3> b{{x - 0.3, -0.2, z - 0.3}, {x + 0.3, 0.2, z + 0.3}};
      const auto side = classify(f, b);
      const irg::rgba8 colour = side == irg::containment::inside    ? green
                                : side == irg::containment::outside ? red
                                                                    : blue;
      const auto low = cell_at(place(b.low.x, b.low.z)), high = cell_at(place(b.high.x, b.high.z));
      for (int y = low.y; y <= high.y; ++y) irg::fill_span(p, {y, low.x, high.x + 1}, colour);
    }
  for (const auto& [a, b] : {std::array{0, 1}, std::array{1, 5}, std::array{5, 4}, std::array{4, 0}}) line(a, b, ink);
  return p;
}

// A window with a circle in it, in a viewport twice as wide as high: stretched, whole, filling.
inline picture fits() {
  constexpr int width = 780, height = 150;
  picture p(width, height, paper);
  const window square{-1, 1, -1, 1};
  int i = 0;
  for (const auto fit : {irg::window_fit::stretch, irg::window_fit::whole, irg::window_fit::fill}) {
    const irg::viewport<double> view{20.0 + 260 * i++, 20, 220, 110};
    const irg::cell_window inner{static_cast<int>(view.x), 20, static_cast<int>(view.x) + 220, 130};
    for (int y = inner.y_first; y < inner.y_last; ++y) irg::fill_span(p, {y, inner.x_first, inner.x_last}, pale_blue);
    const auto m = irg::window_to_viewport(square, view, fit).value;
    for (int y = inner.y_first; y < inner.y_last; ++y)
      for (int x = inner.x_first; x < inner.x_last; ++x) {
        const point2 q = from_pixels(m, point2{x + 0.5, y + 0.5});
        if (std::abs(q.x) <= 1 && std::abs(q.y) <= 1) p(x, y) = {255, 255, 255, 255};
        if (q.x * q.x + q.y * q.y <= 0.64) p(x, y) = middle;
      }
    const irg::cell a{inner.x_first - 1, inner.y_first - 1}, c{inner.x_last, inner.y_last};
    for (const auto& [from, to] : {std::array{a, irg::cell{c.x, a.y}}, std::array{irg::cell{c.x, a.y}, c},
                                   std::array{c, irg::cell{a.x, c.y}}, std::array{irg::cell{a.x, c.y}, a}})
      irg::draw_line(p, from, to, ink);
  }
  return p;
}

}  // namespace projection_pictures
