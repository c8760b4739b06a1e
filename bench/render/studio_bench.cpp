// SPDX-License-Identifier: MIT
// Frames of the studio on one thread: the teapot and three bodies, one of them transparent and one of edges and points,
// both views of 640x480, while both cameras orbit. In the second case a transformation after the camera makes a body
// ready anew in every frame; in the third the teapot is that body.
#include <cstdlib>
#include <string>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/image.hpp>

#include "../../examples/studio/studio_picture.hpp"
#include "support/measure.hpp"

namespace {

using namespace bench;
using event = irg::studio_event<double>;

struct session {
  irg::studio<double> state;
  irg::studio_memory<double> memory;
  irg::image<irg::rgba8> picture;

  session(int width, int height) : picture(width, height) {}
  void happen(const event& e) {
    if (irg::apply_event(state, e) != irg::studio_status::done) std::abort();
  }
  void frame() {
    const event events[] = {irg::orbit_camera<double>{irg::studio_view::main, 1, 0},
                            irg::orbit_camera<double>{irg::studio_view::outer, -1, 0}};
    (void)irg::run_studio<double>(state, events, picture.view(), memory);
  }
};

void enter_case(const std::string& name, const char* turned, int width, int height) {
  auto& s = keep(session(width, height));
  const auto load = [&](const char* body, const irg::mesh<double>& m) {
    s.happen(irg::load_body<double>{irg::store_body(body, m)});
  };
  const auto move = [&](const char* body, double x, double y, double z) {
    s.happen(irg::add_transformation<double>{body, irg::studio_stage::before, {irg::studio_map::translate, {x, y, z}}});
  };
  load("teapot", irg::shape_teapot<double>());
  load("cube", irg::shape_cube<double>());
  load("cube", irg::shape_cube<double>());
  load("ring", irg::shape_torus<double>());
  s.happen(irg::shade_body{{}, irg::studio_shading::gouraud});
  move("cube", -3, 0, 0);
  move("cube(2)", 2.5, 0, 1.5);
  move("ring", 0, 0, 2.5);
  s.happen(irg::show_part{"cube(2)", irg::studio_part::edges, irg::display::shown});
  s.happen(irg::show_part{"cube(2)", irg::studio_part::points, irg::display::shown});
  s.happen(irg::set_opacity<double>{"ring", 0.5});
  if (turned != nullptr)
    s.happen(irg::add_transformation<double>{turned, irg::studio_stage::after, {irg::studio_map::rotate_z, {20}}});
  enter({"studio", name + build_suffix(), "frame", 1, "", ""}, contender{"irg", [&s] { s.frame(); }});
}

}  // namespace

int main(int argc, char** argv) {
  const int width = smoke() ? 64 : 1280, height = smoke() ? 24 : 480;
  enter_case("2 x 640x480", nullptr, width, height);
  enter_case("2 x 640x480 with a cube after the camera", "cube", width, height);
  enter_case("2 x 640x480 with the teapot after the camera", "teapot", width, height);
  enter_case("2 x 320x480", nullptr, width / 2, height);
  return run_benchmarks(argc, argv);
}
