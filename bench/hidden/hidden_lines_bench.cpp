// SPDX-License-Identifier: MIT
// Hidden lines of 9, 36 and 100 bodies that stand tilted and overlap each other: 20 thousand, 100 thousand and 260
// thousand triangles, with the edges that are features and with all of them. Beside Open CASCADE, on its own bodies and
// triangles, with everything from the bodies on: its own time is that of Load, Update and the list of edges.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <irg/hidden/line_drawing.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>

#include "hidden/hidden_lines_peer.hpp"
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
  const auto to_clip =
      orthographic(irg::view_window<double>{-reach, reach, -reach * height / width, reach * height / width}, 1.0,
                   100.0) *
      look_at(point<double, 3>{20, 14, 18}, point<double, 3>{0, 0, 0}, vec<double, 3>{0, 1, 0});
  for (int i = 0; i < side * side; ++i) {
    const double x = 1.5 * (i % side - 0.5 * (side - 1)), z = 1.5 * (i / side - 0.5 * (side - 1));
    const auto place = translation(vec<double, 3>{x, 0, z}) * rotation_x(0.3 * i) * rotation_z(0.7 * i);
    add_mesh(drawing, body[i % 3], to_clip * place, map_to_screen<double>({width, height}), {.edges = edges});
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

// Whether parts are those that every face tried says, for some edges.
bool agrees_with_every_face(const irg::line_drawing& d) {
  std::vector<irg::screen_edge> some;
  for (std::size_t i = 0; i < d.edges.size(); i += d.edges.size() / 50 + 1) some.push_back(d.edges[i]);
  outcome near, all;
  irg::hidden_lines(d.faces, some, [&near](const irg::edge_part& p) { near.take(p); });
  irg::hidden_lines(d.faces, some, [&all](const irg::edge_part& p) { all.take(p); }, irg::face_search::every);
  return near.parts == all.parts && near.sum == all.sum;
}

// From Open CASCADE's bodies to lines: bodies are closed, so that both leave out what faces away.
void enter_beside_occt(const std::string& name, int side, double deflection) {
  if (!has_occt()) return;
  const int used = smoke() ? 2 : side;
  const auto draw = [used, deflection](irg::face_culling culling) {
    irg::line_drawing d;
    const double reach = 1.1 * used, high = reach * height / width;
    const auto to_clip =
        irg::orthographic(irg::view_window<double>{-reach, reach, -high, high}, 1.0, 100.0) *
        irg::look_at(irg::point<double, 3>{30, 21, 27}, irg::point<double, 3>{0, 0, 0}, irg::vec<double, 3>{0, 1, 0});
    for (const irg::mesh<double>& m : occt_bodies(used, smoke() ? 0.02 : deflection))
      add_mesh(d, m, to_clip, irg::map_to_screen<double>({width, height}), {.culling = culling});
    return d;
  };
  const contest what{"hidden lines of bodies", name, "drawing"};
  for (const irg::face_culling culling : {irg::face_culling::back, irg::face_culling::none}) {
    auto& last = keep(outcome());
    contender c{culling == irg::face_culling::back ? "irg" : "irg:open bodies", [&last, draw, culling] {
                  last = {};
                  const irg::line_drawing d = draw(culling);
                  irg::hidden_lines(d.faces, d.edges, [&last](const irg::edge_part& p) { last.take(p); });
                }};
    c.judge = [draw, culling] {
      const irg::line_drawing d = draw(culling);
      errors e;
      e.wrong = agrees_with_every_face(d) ? 0 : 1;
      if (e.wrong != 0) e.broken = "the searches give different parts";
      e.more = {{"triangles", static_cast<double>(d.triangles)}, {"edges", static_cast<double>(d.edges.size())}};
      return e;
    };
    enter(what, std::move(c));
  }
  auto& drawing = keep_lazy([draw] { return draw(irg::face_culling::back); });
  auto& parts = keep(std::int64_t{0});
  contender finding{"irg:faces and edges at hand", [&drawing, &parts] {
                      parts = 0;
                      irg::hidden_lines((*drawing).faces, (*drawing).edges,
                                        [&parts](const irg::edge_part&) { ++parts; });
                    }};
  finding.same_work = false;
  enter(what, std::move(finding));
  auto& shown = keep(std::int64_t{0});
  contender peer{"Open CASCADE", [&shown, used, deflection] {
                   static_cast<void>(occt_bodies(used, smoke() ? 0.02 : deflection));
                   shown = occt_hidden_lines(used);
                 }};
  peer.judge = [&shown] {
    errors e;
    e.more = {{"visible", static_cast<double>(shown)}};
    return e;
  };
  enter(what, std::move(peer));
}

}  // namespace

int main(int argc, char** argv) {
  enter_scene("features of 20 thousand", 3, 29, irg::drawn_edges::features);
  enter_scene("features of 100 thousand", 6, 33, irg::drawn_edges::features);
  enter_scene("features of 260 thousand", 10, 31, irg::drawn_edges::features);
  enter_scene("all edges of 20 thousand", 3, 29, irg::drawn_edges::every);
  enter_scene("all edges of 100 thousand", 6, 33, irg::drawn_edges::every);
  enter_scene("all edges of 260 thousand", 10, 31, irg::drawn_edges::every);
  enter_beside_occt("20 thousand", 3, 0.0025);
  enter_beside_occt("100 thousand", 6, 0.0019);
  enter_beside_occt("260 thousand", 10, 0.002);
  return run_benchmarks(argc, argv);
}
