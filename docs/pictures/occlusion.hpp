// SPDX-License-Identifier: MIT
// What an occlusion mask holds and answers, and the numbers of a visibility buffer. Included by pictures.cpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/occlusion_mask.hpp>
#include <irg/render/visibility_buffer.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/projection.hpp>

#include "enlarged.hpp"

namespace occlusion_pictures {

using namespace enlarging;
constexpr int width = 112, height = 80, size = 6;

// A torus that stands before the eye, projected.
struct standing_torus {
  irg::drawable<double> body = irg::make_drawable(
      irg::transformed(irg::shape_torus<double>({.minor_radius = 0.45, .major_segments = 24, .minor_segments = 12}),
                       irg::translation(irg::vec<double, 3>{0, 0, -4.2}) * irg::rotation_x(1.1)));
  irg::mat<double, 4, 4> to_clip = irg::perspective(irg::radians(40.0), 1.4, 1.0, 100.0);
  irg::screen_mapping<double> mapping = irg::map_to_screen<double>({width, height});
  irg::projected_vertices<double> vertices =
      irg::project_vertices<double>(std::span<const irg::point<double, 3>>(body.positions), to_clip, mapping);
};

// The farthest depth of each block, nearer ones darker; boxes behind: red where the mask says visible, green where it
// says occluded.
inline picture mask() {
  const standing_torus torus;
  irg::occlusion_mask<> mask(width, height);
  mask.draw<double>(torus.vertices, torus.body.triangles, torus.mapping);
  picture small(width, height, paper);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto grey = [&](float depth) {
        return depth == 0 ? 0.0f : irg::clamped((depth - 0.16f) * 4.2f, 0.15f, 1.0f);
      };
      const float pixel = grey(mask.depth(x, y)), block = grey(mask.block_depth(x, y));
      const auto mixed = [&](int from, int pixels, int blocks) {
        return static_cast<std::uint8_t>(static_cast<float>(from) - pixel * static_cast<float>(pixels) -
                                         block * static_cast<float>(blocks));
      };
      small(x, y) = {mixed(250, 50, 110), mixed(249, 40, 90), mixed(246, 20, 50), 255};
    }
  picture big = enlarged(small, size);
  for (int k = 0; k <= width; k += 8)
    for (int y = 0; y < big.height(); ++y) big(k * size, y) = irg::rgba8{160, 160, 160, 255};
  for (int k = 0; k <= height; k += 8)
    for (int x = 0; x < big.width(); ++x) big(x, k * size) = irg::rgba8{160, 160, 160, 255};
  for (int i = 0; i < 7; ++i)
    for (int k = 0; k < 5; ++k) {
      const irg::point<double, 3> at{-3.2 + i * 1.07, -2.1 + k * 1.05, -7.0};
      const irg::box<double, 3> box{{at.x - 0.14, at.y - 0.14, at.z - 0.14}, {at.x + 0.14, at.y + 0.14, at.z + 0.14}};
      const irg::occlusion answer = mask.test(box, torus.to_clip);
      if (answer == irg::occlusion::outside) continue;
      const auto centre = irg::to_screen(torus.to_clip * at, torus.mapping).position;
      dot(big, {centre.x * size / 256, centre.y * size / 256}, 7,
          answer == irg::occlusion::visible ? irg::rgba8{204, 96, 72, 255} : irg::rgba8{40, 130, 70, 255});
    }
  return big;
}

// Numbers in false colours.
inline picture ids() {
  const standing_torus torus;
  irg::image<std::uint32_t> ids(width, height);
  irg::image<float> depth(width, height);
  irg::draw_visibility({ids, depth}, irg::projected_triangles{torus.vertices, torus.body.triangles, torus.mapping},
                       {.clear = irg::clearing::before_drawing});
  picture small(width, height, paper);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (ids(x, y) == irg::no_index) continue;
      const std::uint32_t mixed = (ids(x, y) + 1) * 2654435761u;
      small(x, y) = {static_cast<std::uint8_t>(90 + (mixed >> 8) % 140),
                     static_cast<std::uint8_t>(90 + (mixed >> 15) % 140),
                     static_cast<std::uint8_t>(90 + (mixed >> 22) % 140), 255};
    }
  return enlarged(small, size);
}

}  // namespace occlusion_pictures
