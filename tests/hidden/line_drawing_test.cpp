// SPDX-License-Identifier: MIT
#include <irg/hidden/line_drawing.hpp>

#include <algorithm>
#include <cstddef>

#include <irg/math/constants.hpp>
#include <irg/mesh/shape_polyhedra.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/projection.hpp>

#include <doctest/doctest.h>

namespace {

using irg::drawn_edges;
using irg::line_drawing;
using irg::line_role;

template <class T>
auto drawn(const irg::mesh<T>& m, irg::line_drawing_options<T> options = {}, T away = T(-5)) {
  const auto to_clip = irg::perspective(irg::radians(T(40)), T(1), T(1), T(100)) *
                       irg::translation(irg::vec<T, 3>{T(0.25), T(0.375), away}) * irg::rotation_x(T(0.75)) *
                       irg::rotation_y(T(0.5));
  line_drawing d;
  irg::add_mesh(d, m, to_clip, irg::map_to_screen<T>(256, 256), options);
  return d;
}
std::int64_t count(const line_drawing& d, line_role role) { return std::count(d.roles.begin(), d.roles.end(), role); }
double length_of(const line_drawing& d, irg::line_visibility which, irg::face_search search) {
  double sum = 0;
  irg::hidden_lines(
      d.faces, d.edges, [&](const irg::edge_part& p) { sum += p.visibility == which ? p.to - p.from : 0.0; }, search);
  return sum;
}

TEST_CASE("line_drawing: a cube has twelve edges, nine of which are seen from beside a corner") {
  const auto cube = irg::shape_cube<double>();
  for (const auto culling : {irg::face_culling::none, irg::face_culling::back}) {
    const line_drawing d = drawn<double>(cube, {.culling = culling});
    CHECK(d.faces.size() == (culling == irg::face_culling::none ? 12 : 6));
    CHECK(d.edges.size() == (culling == irg::face_culling::none ? 12 : 9));
    CHECK(d.triangles == 12);
    CHECK(d.culled == (culling == irg::face_culling::none ? 0 : 6));
    CHECK(count(d, line_role::silhouette) == 6);
    CHECK(count(d, line_role::crease) == (culling == irg::face_culling::none ? 6 : 3));
    double seen = 0;
    std::int64_t parts = 0;
    irg::hidden_lines(d.faces, d.edges, [&](const irg::edge_part& p) {
      if (p.visibility != irg::line_visibility::visible) return;
      seen += p.to - p.from;
      ++parts;
    });
    CHECK(parts == 9);
    CHECK(seen == 9.0);
    const line_drawing outline = drawn<double>(cube, {.edges = drawn_edges::outline, .culling = culling});
    CHECK(outline.edges.size() == 6);
    CHECK(count(outline, line_role::silhouette) == 6);
  }
}

TEST_CASE("line_drawing: borders, silhouettes, creases and the angle that makes them") {
  irg::mesh<double> sheet;
  sheet.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
  sheet.corners = {{0}, {1}, {4}, {1}, {2}, {4}, {2}, {3}, {4}, {3}, {0}, {4}};
  sheet.face_starts = {0, 3, 6, 9, 12};
  line_drawing d = drawn<double>(sheet, {.crease = irg::radians(80.0)});
  CHECK(count(d, line_role::border) == 4);  // the pyramid's base is open
  CHECK(d.edges.size() < 8);
  d = drawn<double>(sheet, {.edges = drawn_edges::every, .crease = irg::radians(80.0)});
  CHECK(d.edges.size() == 8);
  d = drawn<double>(sheet, {.crease = irg::radians(50.0)});
  CHECK(d.edges.size() == 8);
  d = drawn<double>(sheet, {.edges = drawn_edges::outline, .crease = irg::radians(50.0)});
  CHECK(d.edges.size() == static_cast<std::size_t>(4 + count(d, line_role::silhouette)));
  CHECK(d.edges.size() < 8);
  // Three faces at one edge; two that run along it in one direction.
  sheet.corners = {{0}, {1}, {2}, {0}, {1}, {3}, {1}, {0}, {4}};
  sheet.face_starts = {0, 3, 6, 9};
  CHECK(count(drawn<double>(sheet, {.crease = 4}), line_role::crease) == 1);
  CHECK(drawn<double>(irg::mesh<double>{}).edges.empty());
}

TEST_CASE("line_drawing: bodies cut by the eye's plane and beyond, with equal results of both searches") {
  const auto torus = irg::shape_torus<float>({.major_segments = 24, .minor_segments = 12});
  for (const float away : {-5.0f, -2.0f, -1.25f, 0.0f, 3.0f}) {
    const line_drawing d = drawn<float>(torus, {.edges = drawn_edges::every}, away);
    CHECK(d.edges.size() == d.roles.size());
    for (const auto which : {irg::line_visibility::visible, irg::line_visibility::hidden})
      CHECK(length_of(d, which, irg::face_search::nearby) == length_of(d, which, irg::face_search::every));
  }
  // A closed body from outside: with its back faces or without, the same is seen.
  const line_drawing all = drawn<float>(torus), fronts = drawn<float>(torus, {.culling = irg::face_culling::back});
  CHECK(all.faces.size() > fronts.faces.size());
  CHECK(length_of(all, irg::line_visibility::visible, irg::face_search::nearby) ==
        length_of(fronts, irg::line_visibility::visible, irg::face_search::nearby));
}

}  // namespace
