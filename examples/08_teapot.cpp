// SPDX-License-Identifier: MIT
// 08_teapot - the Utah teapot, lit, as a PNG: teapot.png, or the file named on the command line.
// previous: 07_cube, next: 09_shader
#include <cstdio>

#include <irg/io/image_file.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/render.hpp>

#include "support/step.hpp"

int main(int argc, char** argv) {
  const std::string file = program::step(argc, argv, "08_teapot", "the Utah teapot, lit, as a PNG", "teapot.png");
  irg::scene<double> scene;
  scene.objects.push_back({irg::shape_teapot<double>()});
  scene.objects[0].surface = {{0.1, 0.2, 0.3}, {0.25, 0.5, 0.75}, {0.4, 0.4, 0.4}, 50.0};  // ambient, diffuse, specular
  scene.lights = {{{-0.4, 1.0, 0.7, 0.0}, {1.0, 1.0, 1.0}},  // weight 0: at infinity
                  {{4.0, 1.0, 1.0, 1.0}, {0.3, 0.2, 0.1}}};
  scene.ambient = {0.3, 0.3, 0.3};

  const auto ball = irg::bounding_sphere_of(scene.objects[0].shape);
  scene.view =
      irg::camera_around(ball.centre, ball.radius, irg::vec<double, 3>{0.6, 0.6, 1.6}, irg::radians(40.0), 4.0 / 3.0);

  irg::image<irg::rgba8> picture(640, 480);
  irg::image<float> depth(640, 480);
  const irg::render_counts stats = irg::render(scene, {picture, depth}, {.style = irg::picture_style::phong});

  if (const auto saved = irg::save_image(file, picture); !saved)
    program::fail("08_teapot", saved.error().message + (": " + file));
  std::printf("%lld triangles, %lld of them facing away; %lld pixels drawn; %s\n",
              static_cast<long long>(stats.triangles), static_cast<long long>(stats.skipped.backface),
              static_cast<long long>(stats.drawn), file.c_str());
  return stats.drawn > 50000 && stats.skipped.backface > stats.triangles / 3 ? 0 : 1;
}
