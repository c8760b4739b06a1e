// SPDX-License-Identifier: MIT
#include <irg/hidden/line_drawing.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include <irg/math/constants.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/projection.hpp>

#include <doctest/doctest.h>

#include "support/random.hpp"
#include "support/scenes.hpp"

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
  irg::add_mesh(d, m, to_clip, irg::map_to_screen<T>({256, 256}), options);
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

// A line that may be seen, as the ends of its part in pixels.
struct part {
  irg::point<double, 2> from, to;
  irg::line_visibility visibility;
  bool operator==(const part&) const = default;
};
// The parts of those edges that are not wholly more than two pixels beyond a border of size x size pixels.
std::vector<part> parts_near(const line_drawing& d, double size, std::size_t& edges) {
  const auto beyond = [&](double a, double b) { return (a < -2 && b < -2) || (a > size + 2 && b > size + 2); };
  edges = 0;
  for (const irg::screen_edge& e : d.edges) {
    const auto a = irg::point_on(e, 0), b = irg::point_on(e, 1);
    edges += beyond(a.x, b.x) || beyond(a.y, b.y) ? 0u : 1u;
  }
  std::vector<part> parts;
  irg::hidden_lines(d.faces, d.edges, [&](const irg::edge_part& p) {
    const irg::screen_edge& e = d.edges[p.edge];
    const auto a = irg::point_on(e, 0), b = irg::point_on(e, 1);
    if (!beyond(a.x, b.x) && !beyond(a.y, b.y))
      parts.push_back({irg::point_on(e, p.from), irg::point_on(e, p.to), p.visibility});
  });
  return parts;
}

TEST_CASE("line_drawing: without what is beyond the picture, edges in it have the same parts to their far ends") {
  test::random r(3);
  std::int64_t beyond = 0, triangles = 0, faces = 0, faces_left = 0, outside = 0;
  const int scenes = std::getenv("IRG_RELEASE_TIER") ? 20000 : 300;
  for (int i = 0; i < scenes; ++i) {
    const irg::scene<double> s =
        test::random_scene<double>(r, 30, i % 2 ? test::positions::everywhere : test::positions::ordinary);
    const int size = static_cast<int>(r.integer(1, 64));
    const auto mapping = irg::map_to_screen<double>({size, size});
    irg::line_drawing_options<double> options{.edges = i % 3 ? drawn_edges::every : drawn_edges::features,
                                              .culling = i % 4 ? irg::face_culling::none : irg::face_culling::back};
    line_drawing all, near;
    irg::camera<double> view = s.view;
    if (i % 2 == 0) view.vertical_angle /= 4;
    const auto to_clip = irg::view_projection(view, 1.0);
    for (const auto& o : s.objects) {
      options.frustum = irg::skipping::off;
      irg::add_mesh(all, o.shape, to_clip * o.placement, mapping, options);
      options.frustum = irg::skipping::on;
      irg::add_mesh(near, o.shape, to_clip * o.placement, mapping, options);
    }
    REQUIRE(all.beyond == 0);
    REQUIRE(near.triangles == all.triangles);
    REQUIRE(near.beyond + near.culled >= all.culled);
    REQUIRE(near.faces.size() == all.faces.size());
    faces += static_cast<std::int64_t>(near.faces.size());
    irg::leave_out_faces_beside_edges(near);
    faces_left += static_cast<std::int64_t>(near.faces.size());
    std::size_t edges = 0, same = 0;
    const auto expected = parts_near(all, size, edges);
    REQUIRE(near.edges.size() == edges);
    REQUIRE(near.roles.size() == edges);
    REQUIRE(parts_near(near, size, same) == expected);
    for (const part& p : expected)
      outside += p.visibility == irg::line_visibility::hidden && (p.from.x < -2 || p.to.x < -2) ? 1 : 0;
    beyond += near.beyond, triangles += near.triangles;
  }
  CHECK(beyond > triangles / 10);
  CHECK(beyond < triangles);
  CHECK(faces_left < faces);
  CHECK(outside > 0);  // an edge is hidden beyond the picture, too
}

TEST_CASE("line_drawing: a face beyond the picture hides the end of an edge there, or is left out") {
  // One pixel is a unit; the picture shows 0 to 8. The edge runs out to the left, to behind a face at -6 to -4.
  irg::mat<double, 4, 4> to_clip{{{0.25, 0, 0, -1}, {0, -0.25, 0, 1}, {0, 0, 0.125, 0}, {0, 0, 0, 1}}};
  irg::mesh<double> m;
  m.positions = {{-5, 4, 1}, {4, 4, 1},   {4, 5, 1},   {-6, 0, 6}, {-4, 0, 6},
                 {-5, 8, 6}, {-40, 0, 6}, {-39, 0, 6}, {-39, 8, 6}};
  m.corners = {{0}, {1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}};
  m.face_starts = {0, 3, 6, 9};
  line_drawing d;
  irg::add_mesh(d, m, to_clip, irg::map_to_screen<double>({8, 8}),
                {.edges = drawn_edges::every, .frustum = irg::skipping::on});
  CHECK(d.beyond == 2);
  CHECK(d.edges.size() == 3);
  CHECK(d.faces.size() == 3);
  irg::leave_out_faces_beside_edges(d);
  CHECK(d.faces.size() == 2);
  std::int64_t hidden = 0;
  irg::hidden_lines(d.faces, d.edges,
                    [&](const irg::edge_part& p) { hidden += p.visibility == irg::line_visibility::hidden ? 1 : 0; });
  CHECK(hidden == 2);  // of the two edges at the corner that is beyond the picture
  d.edges.clear();
  irg::leave_out_faces_beside_edges(d);
  CHECK(d.faces.empty());
}

}  // namespace
