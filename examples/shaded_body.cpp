// SPDX-License-Identifier: MIT
// shaded_body - which faces of a body an eye sees, and how bright constant shading makes each.
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <irg/hidden/back_faces.hpp>
#include <irg/shade/intensity_range.hpp>
#include <irg/shade/shading.hpp>

#include "support/command_line.hpp"
#include "support/eye_inside.hpp"
#include "support/number_output.hpp"
#include "support/rendering.hpp"
#include "support/run_or_fail.hpp"

namespace {

const std::string help = R"(shaded_body - the shaded faces of a body

usage: shaded_body MODEL [options]

Prints how many triangles the model has, its faces cut, and how many belong to faces that turn their outer side towards
the eye. The others are back faces, and so are those seen from their edge. A face is as bright as the ambient and the
diffuse light on its centre make it: Ia ka + Ii kd (L.N), summed over the lamps and cut off at 255, with Ia = 100,
ka = 0.2, Ii = 200, kd = 0.6. Where the eye is inside a closed body, which is meant to be seen from outside, a line on
standard error says so.

  MODEL                a body as OBJ, STL, PLY, OFF or XML, or one of teapot, cube, sphere, torus
  --fit                move the model's centre to the origin and scale it until its longest side goes from -1 to 1
  --list               print instead, for every face of the model: its intensity, 0 to 255, or hidden for a back face
  -o OUT               draw the body in this light: .png, .ppm or .svg
)" + std::string(program::render_options_help);

using mesh = irg::mesh<double>;
using vec3 = irg::vec<double, 3>;
constexpr double ambient_light = 100, lamp = 200, ambient_share = 0.2, diffuse_share = 0.6, brightest = 255;

constexpr irg::rgb<double> grey(double v) { return {v, v, v}; }

// The eye; for parallel projections the direction towards it.
irg::hpoint<double, 3> eye_of(const irg::camera<double>& c) {
  if (c.projection == irg::projection_kind::perspective) return irg::to_homogeneous(c.eye);
  vec3 towards = c.eye - c.target;
  if (c.projection == irg::projection_kind::oblique || towards == vec3{}) {
    const bool slanted = c.projection == irg::projection_kind::oblique;
    const auto axes = irg::submatrix(irg::look_at(c.eye, c.target, c.up), 3, 3);
    towards = irg::transpose(axes) * (slanted ? irg::direction_to_viewer(c.receding) : vec3{0, 0, 1});
  }
  return {towards.x, towards.y, towards.z, 0};
}

// The mean of a face's vertices, by their differences from the first.
irg::point<double, 3> centre_of(const mesh& m, std::size_t f) {
  const irg::point<double, 3>& first = m.positions[m.corner(f, 0).position];
  vec3 sum{};
  for (std::size_t k = 1; k < m.face_size(f); ++k) sum += m.positions[m.corner(f, k).position] - first;
  return first + sum / static_cast<double>(m.face_size(f));
}

std::string report_of(const irg::scene<double>& world, bool list) {
  const mesh& body = world.objects[0].shape;
  const irg::hpoint<double, 3> eye = eye_of(world.view);
  std::vector<irg::light<double, double>> lamps;
  lamps.reserve(world.lights.size());
  for (const auto& l : world.lights) lamps.push_back({l.position, lamp});
  const irg::flat_shader<double, double> shade{
      {ambient_share, diffuse_share, 0, 1}, {ambient_light, lamps}, world.view.eye};
  std::string text;
  std::size_t triangles = 0, visible = 0;
  for (std::size_t f = 0; f < body.face_count(); ++f) {
    const bool hidden = irg::is_hidden(irg::facing_of(body, f, eye));
    triangles += body.face_size(f) - 2;
    visible += hidden ? 0 : body.face_size(f) - 2;
    if (!list) continue;
    if (hidden) {
      text += "hidden\n";
      continue;
    }
    const double intensity = shade(centre_of(body, f), irg::face_normal(body, f).value_or(vec3{}));
    text += program::shortest(irg::clamp_intensity(intensity, brightest)) + "\n";
  }
  if (!list) text = "triangles: " + std::to_string(triangles) + "\nvisible: " + std::to_string(visible) + "\n";
  return text;
}

void run(program::command_line& line) {
  program::render_settings s;
  bool list = false;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--list")
      list = true;
    else if (word == "--fit")
      s.fit = true;
    else
      s.read(line, word);
  }
  if (s.model.empty()) line.fail("no model given; --help tells how");
  s.finish(line);
  if (!s.out.empty()) program::expect_picture_name(line, s.out);
  program::timings ms;
  program::stopwatch watch;

  irg::scene<double> world;
  world.objects.push_back({program::load_model(line, s)});
  world.objects[0].surface = {grey(ambient_share), grey(diffuse_share), {}, 1};
  world.view = program::camera_of(line, s, world.objects[0].shape);
  if (world.view.projection == irg::projection_kind::perspective)
    program::hint_if_inside(line, world.objects[0].shape, world.view.eye);
  world.lights = s.lights.empty() ? std::vector{program::shoulder_light(world.view)} : s.lights;
  for (auto& l : world.lights) l.intensity = grey(lamp / brightest);
  world.ambient = grey(ambient_light / brightest);
  ms.load = watch.lap();

  const std::string report = report_of(world, list);
  if (!s.out.empty() || !s.stats.empty()) program::draw_scene(line, s, world, ms);
  std::fwrite(report.data(), 1, report.size(), stdout);
  program::finish_output(line, s.out, s.stats);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail({argc, argv, "shaded_body", help}, "this model and this size", run);
}
