#include <cstdio>
#include <irg/io/image_file.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/render/render_traced.hpp>

int main() {
  irg::scene<double> world;
  world.objects.push_back({irg::shape_teapot<double>()});
  world.lights = {{{-0.4, 1, 0.7, 0}, {0.7, 0.8, 0.9}}};
  world.view.eye = {3, 5, 9};
  irg::image<irg::rgba8> picture(64, 48);
  irg::render_traced(world, picture);
  return irg::save_image("traced.png", picture) ? 0 : 1;
}
