// SPDX-License-Identifier: MIT
// render - a model file becomes a picture.
#include <string>

#include "support/command_line.hpp"
#include "support/rendering.hpp"
#include "support/run_or_fail.hpp"

namespace {

const std::string help = R"(render - draws a model into a picture

usage: render MODEL -o OUT [options]

  MODEL                a body as OBJ, STL, PLY, OFF or XML, or one of teapot, cube, sphere, torus
  -o OUT               the picture: .png, .ppm or .svg
)" + std::string(program::render_options_help);

void run(program::command_line& line) {
  program::render_settings s;
  while (!line.done()) s.read(line, line.take());
  if (s.model.empty()) line.fail("no model given; --help tells how");
  if (s.out.empty()) line.fail("no picture given; -o OUT.png names it");
  s.finish(line);
  program::expect_picture_name(line, s.out);
  program::timings ms;
  program::stopwatch watch;

  irg::scene<double> world;
  world.objects.push_back({program::load_model(line, s)});
  world.objects[0].surface = {{0.75, 0.42, 0.20}, {0.75, 0.42, 0.20}, {0.30, 0.30, 0.30}, 40};
  world.view = program::camera_of(line, s, world.objects[0].shape);
  world.lights = s.lights.empty() ? std::vector{program::shoulder_light(world.view)} : s.lights;
  world.ambient = {0.12, 0.12, 0.14};
  ms.load = watch.lap();
  program::draw_scene(line, s, world, ms);
}

} // namespace

int main(int argc, char** argv) { program::run_or_fail({argc, argv, "render", help}, "this model and this size", run); }
