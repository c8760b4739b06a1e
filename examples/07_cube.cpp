// SPDX-License-Identifier: MIT
// 07_cube - from space to the screen: a camera's matrix, clip space, the division by w, the viewport; faces that turn
// away are left out. Every face is filled with its number.
// previous: 06_depth, next: 08_teapot
#include <cstdio>
#include <string_view>

#include <irg/mesh/shapes.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/scene/camera.hpp>

#include "support/step.hpp"

int main(int argc, char** argv) {
  program::step(argc, argv, "07_cube",
                "from space to the screen: a camera's matrix, clip space, the division by w, the viewport; faces that "
                "turn away are left out");
  const irg::mesh<double> cube = irg::shape_cube<double>();  // 8 vertices, 12 triangles, counter-clockwise from outside
  irg::camera<double> camera;
  camera.eye = {2.4, 2.1, 3.0};
  camera.target = {0.5, 0.5, 0.5};
  camera.near_distance = 0.1;

  constexpr int width = 44, height = 22;  // a character is twice as high as wide
  irg::image<char> picture(width, height, '.');
  irg::image<float> depth(width, height, irg::nearer_is_greater::farthest);
  const auto mapping = irg::map_to_screen<double>({width, height});
  const irg::mat<double, 4, 4> to_clip = irg::view_projection(camera, 1.0);
  int front_faces = 0;

  for (std::size_t f = 0; f < cube.face_count(); ++f) {
    irg::screen_vertex v[3];
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = irg::to_screen(to_clip * cube.positions[cube.corner(f, k).position], mapping);
    // Seen from outside the corners run counter-clockwise, on the screen too.
    if (irg::orientation_of(v[0].position, v[1].position, v[2].position) != irg::orientation::counter_clockwise)
      continue;
    ++front_faces;
    irg::shade_triangle(picture, depth, {v[0], v[1], v[2]}, irg::solid_shader<char>{static_cast<char>('a' + f)});
  }

  for (int y = 0; y < height; ++y) std::printf("%.*s\n", width, picture.row(y));
  std::printf("%d of 12 triangles face the eye\n", front_faces);
  const std::string_view row_7(picture.row(7), width), row_17(picture.row(17), width);
  return front_faces == 6 && row_7 == ".........llfffffffffffeeeeeeeeeddd.........." &&
                 row_17 == "....................kkkkdc.................."
             ? 0
             : 1;
}
