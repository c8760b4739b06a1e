// SPDX-License-Identifier: MIT
// Hidden lines of 9, 36 and 100 bodies that stand tilted and overlap each other: 20 thousand, 100 thousand and 260
// thousand triangles, with the edges that are features and with all of them.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <irg/hidden/line_drawing.hpp>
#include <irg/mesh/shape_polyhedra.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>

#include "support/measure.hpp"

namespace {

using namespace bench;

constexpr int width = 1600, height = 1200;

// Bodies in a square of `side` places, a third each of spheres, tori and cubes.
irg::line_drawing make_drawing(int side, int fineness, irg::drawn_edges edges) {
  using namespace irg;
  line_drawing drawing;
  const mesh<double> body[3] = {shape_sphere<double>({.slices = 2 * fineness, .stacks = fineness}),
                                shape_torus<double>({.major_segments = 2 * fineness, .minor_segments = fineness}),
                                shape_cube<double>()};
  const double reach = 1.1 * side;
  const auto to_clip = orthographic(-reach, reach, -reach * height / width, reach * height / width, 1.0, 100.0) *
                       look_at(point<double, 3>{20, 14, 18}, point<double, 3>{0, 0, 0}, vec<double, 3>{0, 1, 0});
  for (int i = 0; i < side * side; ++i) {
    const double x = 1.5 * (i % side - 0.5 * (side - 1)), z = 1.5 * (i / side - 0.5 * (side - 1));
    const auto place = translation(vec<double, 3>{x, 0, z}) * rotation_x(0.3 * i) * rotation_z(0.7 * i);
    add_mesh(drawing, body[i % 3], to_clip * place, map_to_screen<double>(width, height), {.edges = edges});
  }
  return drawing;
}

// What makes two results comparable: how many parts, and their places.
struct outcome {
  std::int64_t parts = 0;
  double sum = 0;
  void take(const irg::edge_part& p) {
    ++parts;
    sum += p.from * static_cast<double>(p.edge % 64 + 1) + (p.visibility == irg::line_visibility::hidden ? p.to : 0.0);
  }
};

void enter_scene(const std::string& name, int side, int fineness, irg::drawn_edges edges) {
  auto& drawing = keep_lazy([=] { return make_drawing(smoke() ? 2 : side, smoke() ? 8 : fineness, edges); });
  auto& last = keep(outcome());
  const contest what{"hidden_lines", name, "drawing"};
  const auto add = [&](const std::string& who, irg::face_search search) {
    contender c{who, [&drawing, &last, search] {
                  last = {};
                  irg::hidden_lines((*drawing).faces, (*drawing).edges,
                                    [&last](const irg::edge_part& p) { last.take(p); }, search);
                }};
    c.judge = [&drawing, &last] {
      errors e;
      irg::hidden_line_counts counts;
      outcome again;
      counts =
          irg::hidden_lines((*drawing).faces, (*drawing).edges, [&again](const irg::edge_part& p) { again.take(p); });
      e.wrong = again.parts != last.parts || again.sum != last.sum ? 1 : 0;
      if (e.wrong != 0) e.broken = "the searches give different parts";
      e.more = {{"faces", static_cast<double>(counts.faces)},
                {"edges", static_cast<double>(counts.edges)},
                {"tried", static_cast<double>(counts.tried)},
                {"visible", static_cast<double>(counts.visible)}};
      return e;
    };
    enter(what, std::move(c));
  };
  add("irg", irg::face_search::nearby);
  if (side == 3 && edges == irg::drawn_edges::features) add("irg:every face tried", irg::face_search::every);
}

}  // namespace

int main(int argc, char** argv) {
  enter_scene("features of 20 thousand", 3, 42, irg::drawn_edges::features);
  enter_scene("features of 100 thousand", 6, 47, irg::drawn_edges::features);
  enter_scene("features of 260 thousand", 10, 45, irg::drawn_edges::features);
  enter_scene("all edges of 20 thousand", 3, 42, irg::drawn_edges::every);
  enter_scene("all edges of 100 thousand", 6, 47, irg::drawn_edges::every);
  enter_scene("all edges of 260 thousand", 10, 45, irg::drawn_edges::every);
  return run_benchmarks(argc, argv);
}
