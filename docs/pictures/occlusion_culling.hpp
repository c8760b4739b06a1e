// SPDX-License-Identifier: MIT
// What occlusion culling leaves out: a picture, and its objects seen from above. Included by pictures.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/math/trigonometry.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/render/render.hpp>
#include <irg/view/affine.hpp>

#include "enlarged.hpp"

namespace occlusion_culling_pictures {

using namespace enlarging;
using irg::vec;

inline irg::object<double> wall(double x_first, double x_last, double z) {
  irg::object<double> o;
  o.shape.positions = {{x_first, 0, z}, {x_last, 0, z}, {x_last, 2.4, z}, {x_first, 2.4, z}};
  for (std::uint32_t i = 0; i < 4; ++i) o.shape.corners.push_back({i, irg::no_index});
  o.shape.face_starts = {0, 4};
  o.surface.ambient = o.surface.diffuse = {0.62, 0.58, 0.5};
  return o;
}

// Two walls, and balls before, between and behind them.
inline irg::scene<double> walls_and_balls() {
  irg::scene<double> s;
  s.view.eye = {0.6, 1.4, 9};
  s.view.target = {0, 0.9, 0};
  s.view.vertical_angle = irg::radians(42.0);
  s.lights = {{{-0.5, 1, 0.8, 0}, {0.8, 0.8, 0.8}}};
  s.ambient = {0.25, 0.25, 0.25};
  s.objects = {wall(-4.6, -0.7, 2), wall(0.5, 3.4, 1)};
  const auto ball = irg::shape_sphere<double>({.slices = 24, .stacks = 16});
  for (int k = 0; k < 7; ++k)
    for (int i = 0; i < 13; ++i) {
      irg::object<double> o{ball, irg::translation(vec<double, 3>{(i - 6) * 0.95, 0.35, 3.5 - k * 1.3}) *
                                      irg::scaling(vec<double, 3>{0.3, 0.3, 0.3})};
      o.surface.ambient = o.surface.diffuse = {0.8, 0.45, 0.3};
      s.objects.push_back(o);
    }
  return s;
}

inline picture seen_from_above() {
  constexpr int width = 420, height = 300, scale = 33;
  const irg::scene<double> s = walls_and_balls();
  picture seen(width, height), above(width, height, paper), both(2 * width + 8, height, irg::rgba8{255, 255, 255, 255});
  irg::image<float> depth(width, height);
  irg::render(s, {seen, depth}, {.style = irg::picture_style::gouraud});

  std::vector<irg::drawable<double>> bodies;
  std::vector<irg::occludable_object<double>> objects;
  for (const irg::object<double>& o : s.objects)
    bodies.push_back(irg::make_drawable(irg::transformed(o.shape, o.placement)));
  for (const irg::drawable<double>& b : bodies) {
    irg::box<double, 3> box;
    for (const auto& p : b.positions) box = irg::bounding_box(box, p);
    objects.push_back({box, b.positions, b.triangles});
  }
  irg::occlusion_culling<double> culling(irg::view_projection(s.view, 1.0 * width / height), {width, height});
  const auto visible = culling.visible_objects(objects);

  const auto place = [&](double x, double z) {
    return irg::cell{width / 2 + static_cast<int>(x * scale), 170 + static_cast<int>(z * scale / 1.5)};
  };
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const irg::box<double, 3>& b = objects[i].bounds;
    const irg::cell low = place(b.low.x, b.low.z), high = place(b.high.x, b.high.z);
    bool is_visible = false;
    for (const std::uint32_t v : visible) is_visible = is_visible || v == i;
    const irg::rgba8 colour = i < 2                  ? ink
                              : culling.is_beyond(b) ? irg::rgba8{170, 168, 162, 255}
                              : is_visible           ? irg::rgba8{204, 96, 72, 255}
                                                     : irg::rgba8{40, 130, 70, 255};
    for (int y = low.y - (i < 2); y <= high.y + (i < 2); ++y) irg::fill_span(above, {y, low.x, high.x + 1}, colour);
  }
  // The borders of what is seen.
  const double reach = 1.0 * width / height * irg::tan(s.view.vertical_angle / 2);
  const vec<double, 3> ahead = s.view.target - s.view.eye;
  const irg::cell eye = place(s.view.eye.x, s.view.eye.z);
  for (const double side : {-reach, reach}) {
    const irg::cell end =
        place(s.view.eye.x + 1.7 * (ahead.x - side * ahead.z), s.view.eye.z + 1.7 * (ahead.z + side * ahead.x));
    irg::draw_line(above, eye, end, irg::rgba8{150, 150, 170, 255});
  }
  paste(both, seen, 0, 0);
  paste(both, above, width + 8, 0);
  return both;
}

}  // namespace occlusion_culling_pictures
