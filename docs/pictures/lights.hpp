// SPDX-License-Identifier: MIT
// A ball under lamps about it, and depths without colours. Included by pictures.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include <irg/geometry/box.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/draw_depth.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/render.hpp>
#include <irg/shade/light_placement.hpp>

#include "enlarged.hpp"

namespace light_pictures {

using namespace enlarging;

// The same ball under a lamp that goes round it, comes nearer and stands at infinity.
inline picture around() {
  constexpr int size = 200;
  constexpr double far_away = std::numeric_limits<double>::infinity();
  const irg::polar_coordinates<double> places[] = {
      {4, 0.8, 0.6}, {4, -0.8, 0.6}, {1.6, 0.8, 0.6}, {far_away, 0.8, 0.6}};
  const char* const names[] = {"{4, 0.8, 0.6}", "{4, -0.8, 0.6}", "{1.6, 0.8, 0.6}", "{infinity, 0.8, 0.6}"};
  picture all(4 * size, size + 30, paper);
  for (int i = 0; i < 4; ++i) {
    irg::scene<double> scene;
    scene.objects.push_back({irg::shape_sphere<double>({.slices = 48, .stacks = 24})});
    scene.lights = {irg::light_around(irg::point<double, 3>{0, 0, 0}, places[i], irg::rgb<double>{0.8, 0.8, 0.75})};
    scene.ambient = {0.1, 0.1, 0.12};
    scene.view = irg::camera_around(irg::point<double, 3>{0, 0, 0}, 1.1, irg::vec<double, 3>{0, 0.15, 1}, 0.7, 1.0);
    picture p(size, size);
    irg::image<float> depth(size, size);
    irg::render(scene, {p, depth}, {.style = irg::picture_style::phong});
    paste(all, p, size * i, 0);
    irg::draw_text(all, names[i], irg::point<double, 2>(size * i + size / 2, size + 18),
                   {.size = 16, .along = irg::text_along::centre}, ink);
  }
  return all;
}

// The depths of the teapot for a lamp in front and one at the side: what a shadow asks, nearer darker.
inline picture depths() {
  constexpr int width = 360, height = 270;
  const auto teapot = irg::shape_teapot<double>();
  const auto body = irg::make_drawable(teapot);
  const auto ball = irg::bounding_sphere_of(teapot);
  const auto mapping = irg::map_to_screen<double>({width, height});
  picture all(2 * width + 12, height, paper);
  int left = 0;
  for (const irg::vec<double, 3> from : {irg::vec<double, 3>{0.3, 0.6, 1.6}, irg::vec<double, 3>{-1.6, 0.5, 0.4}}) {
    const auto eye = irg::camera_around(ball.centre, 0.8 * ball.radius, from, 0.7, 4.0 / 3);
    const auto vertices = irg::project_vertices<double>(std::span<const irg::point<double, 3>>(body.positions),
                                                        irg::view_projection(eye, 4.0 / 3), mapping);
    irg::image<float> depth(width, height);
    irg::draw_depth(depth, irg::projected_triangles{vertices, body.triangles, mapping},
                    {.clear = irg::clearing::before_drawing});
    float nearest = 0, farthest = 1;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (const float d = depth(x, y); d != 0) nearest = std::max(nearest, d), farthest = std::min(farthest, d);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (const float d = depth(x, y); d != 0) {
          const auto v = static_cast<std::uint8_t>(30 + 190 * (nearest - d) / (nearest - farthest));
          all(left + x, y) = {v, v, v, 255};
        }
    left += width + 12;
  }
  return all;
}

}  // namespace light_pictures
