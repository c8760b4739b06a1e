// SPDX-License-Identifier: MIT
#include <irg/render/wireframe.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/image.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"

namespace {

using point = irg::point<double, 3>;
using picture = irg::image<int>;
using mesh = irg::mesh<double>;

constexpr auto eye_at_origin =
    irg::perspective(irg::pi<double> / 2, 1.0, 0.125, std::numeric_limits<double>::infinity());

struct drawn {
  picture lines;
  irg::render_counts stats;
};

template <class E = irg::sequential>
constexpr drawn draw(const mesh& m, int width, int height, irg::face_culling culling = irg::face_culling::none,
                     const irg::mat<double, 4, 4>& to_clip = eye_at_origin, const E& executor = {},
                     irg::skipping frustum = irg::skipping::on) {
  drawn d{picture(width, height, 0), {}};
  const auto mapping = irg::map_to_screen<double>({width, height});
  const auto v = irg::project_vertices<double>(m.positions, to_clip, mapping);
  d.stats = irg::draw_wireframe(d.lines, irg::projected_mesh{v, m, mapping, frustum}, 1, culling, executor);
  return d;
}

// The pixels that line_bresenham gives for pairs of vertices none of which is clipped, the smaller index first.
picture expected_lines(const mesh& m, const std::set<std::pair<std::uint32_t, std::uint32_t>>& edges, int width,
                       int height, std::int64_t& cells) {
  picture lines(width, height, 0);
  const auto mapping = irg::map_to_screen<double>({width, height});
  const auto v = irg::project_vertices<double>(m.positions, eye_at_origin, mapping);
  const auto pixel = [&](std::uint32_t i) {
    const irg::subpixel p = v.screen[i].position;
    return irg::cell{static_cast<int>(std::floor(p.x / 256.0)), static_cast<int>(std::floor(p.y / 256.0))};
  };
  for (const auto& [a, b] : edges)
    irg::line_bresenham(pixel(a), pixel(b), {0, 0, width, height}, [&](irg::cell c) { lines(c.x, c.y) = 1, ++cells; });
  return lines;
}

mesh cube_before_the_eye(double distance = 3) {
  mesh m = irg::shape_cube<double>();
  for (auto& p : m.positions) p = {p.x * 2 - 1.1, p.y * 2 - 0.9, p.z * 2 - 1 - distance};
  return m;
}

std::set<std::pair<std::uint32_t, std::uint32_t>> edges_of(const mesh& m, const std::set<std::size_t>& without = {}) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0; k < m.face_size(f) && without.count(f) == 0; ++k) {
      const std::uint32_t a = m.corner(f, k).position, b = m.corner(f, (k + 1) % m.face_size(f)).position;
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  return edges;
}

TEST_CASE("draw_wireframe: the lines of the projected ends, every edge once") {
  const mesh m = cube_before_the_eye();
  const drawn d = draw(m, 80, 70);
  std::int64_t cells = 0;
  const auto edges = edges_of(m);
  CHECK(edges.size() == 18);  // 12, and a diagonal in each square
  CHECK(d.lines == expected_lines(m, edges, 80, 70, cells));
  CHECK(d.stats.pixels.shaded == cells);
  CHECK(d.stats.triangles == 12);
  CHECK(d.stats.skipped == irg::skip_counts{});
}

TEST_CASE("draw_wireframe: faces that face away are left out, their edges with a neighbour are not") {
  const mesh m = cube_before_the_eye();
  std::set<std::size_t> hidden;
  for (std::size_t f = 0; f < m.face_count(); ++f) {  // in space: the eye, at the origin, is behind the face's plane
    const auto at = [&](std::size_t k) { return irg::to_vec(m.positions[m.corner(f, k).position]); };
    if (irg::dot(irg::cross(at(1) - at(0), at(2) - at(0)), at(0)) >= 0) hidden.insert(f);
  }
  CHECK(hidden.size() == 10);  // the eye sees one side alone
  const drawn d = draw(m, 80, 70, irg::face_culling::back);
  std::int64_t cells = 0;
  CHECK(d.lines == expected_lines(m, edges_of(m, hidden), 80, 70, cells));
  CHECK(d.stats.pixels.shaded == cells);
  CHECK(d.stats.skipped.backface == 10);
}

TEST_CASE("draw_wireframe: random soups of triangles and quadrilaterals") {
  test::random r(1);
  for (int i = 0; i < 200; ++i) {
    mesh m = test::random_mesh<double>(r, 12, test::positions::ordinary);
    for (auto& p : m.positions) p.z -= 4;
    const int width = static_cast<int>(r.integer(1, 90)), height = static_cast<int>(r.integer(1, 200));
    const drawn d = draw(m, width, height);
    std::int64_t cells = 0;
    REQUIRE(d.lines == expected_lines(m, edges_of(m), width, height, cells));
    REQUIRE(d.stats.pixels.shaded == cells);
    for (const int threads : {1, 2, 3, 16}) {
      const drawn other = draw(m, width, height, irg::face_culling::none, eye_at_origin, irg::parallel{threads});
      REQUIRE(other.lines == d.lines);
      REQUIRE(other.stats == d.stats);
    }
    REQUIRE(draw(m, width, height, irg::face_culling::none, eye_at_origin, test::backwards{}).lines == d.lines);
  }
}

mesh one_triangle(point a, point b, point c) {
  mesh m;
  m.positions = {a, b, c};
  irg::add_face(m, std::vector<int>{0, 1, 2});
  return m;
}

int count(const picture& p) {
  int n = 0;
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) n += p(x, y);
  return n;
}

TEST_CASE("draw_wireframe: edges that pass the eye are cut before it, and keep their direction") {
  // From the middle of the picture past the eye on the right: the visible part runs to the right border, level.
  const drawn d = draw(one_triangle({0, 0, -4}, {2, 0, 4}, {2, 0, 4}), 64, 64);
  for (int x = 0; x < 64; ++x) CHECK(d.lines(x, 32) == (x >= 32));
  CHECK(count(d.lines) == 32);
}

TEST_CASE("draw_wireframe: edges at the eye, behind it and without an end draw nothing") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  CHECK(count(draw(one_triangle({0, 0, 1}, {1, 0, 2}, {0, 1, 3}), 32, 32).lines) == 0);  // behind
  CHECK(count(draw(one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 32, 32).lines) == 0);  // in the eye's plane
  CHECK(count(draw(one_triangle({9, 0, -1}, {9, 1, -1}, {9, 0, -2}), 32, 32).lines) == 0);
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite, 1.7e308}) {
    const mesh m = one_triangle({0, 0, -2}, {0.5, 0, -2}, {0, odd, -2});
    CHECK(count(draw(m, 32, 32).lines) == 5);  // the edge between the other two: pixels 16 to 20
  }
}

TEST_CASE("draw_wireframe: lines far beyond the picture keep to the straight line") {
  // Corners beyond the guard band; the line through the middle of the picture has slope 1/2.
  const drawn d = draw(one_triangle({-1e9, -0.5e9, -1}, {1e9, 0.5e9, -1}, {1e9, 0.5e9, -1}), 64, 64);
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y)
      if (d.lines(x, y)) CHECK(std::fabs((x - 32) + 2 * (y - 32)) <= 3);
  CHECK(count(d.lines) == 64);
}

TEST_CASE("draw_wireframe: with culling, a face that reaches behind the eye is drawn whichever way it faces") {
  CHECK(count(draw(one_triangle({0, -1, -4}, {2, -1, 4}, {0, 1, -4}), 64, 64, irg::face_culling::back).lines) > 0);
  CHECK(count(draw(one_triangle({0, -1, -4}, {0, 1, -4}, {2, -1, 4}), 64, 64, irg::face_culling::back).lines) > 0);
}

TEST_CASE("draw_wireframe: an edge-on face is hidden by culling") {
  CHECK(count(draw(one_triangle({-1, 0, -2}, {1, 0, -2}, {0, 0, -4}), 64, 64, irg::face_culling::back).lines) == 0);
  CHECK(count(draw(one_triangle({-1, 0, -2}, {1, 0, -2}, {0, 0, -4}), 64, 64).lines) > 0);
}

drawn draw_all(const mesh& m, int width, int height, irg::face_culling culling = irg::face_culling::none,
               const irg::mat<double, 4, 4>& to_clip = eye_at_origin) {
  return draw(m, width, height, culling, to_clip, irg::sequential{}, irg::skipping::off);
}

TEST_CASE("draw_wireframe: what is beyond the picture is passed over to the same pixels, and counted") {
  test::random r(2);
  const int meshes = std::getenv("IRG_RELEASE_TIER") ? 20000 : 400;
  std::int64_t some = 0, all = 0;
  for (int i = 0; i < meshes; ++i) {
    const auto kind = std::array{test::positions::ordinary, test::positions::everywhere,
                                 test::positions::hostile}[static_cast<std::size_t>(i % 3)];
    mesh m = test::random_mesh<double>(r, 24, kind);
    const double near_by = std::ldexp(1.0, static_cast<int>(r.integer(-3, 4)));
    for (auto& p : m.positions) p = {p.x * near_by, p.y * near_by, p.z - (kind == test::positions::ordinary ? 4 : 0)};
    const int width = static_cast<int>(r.integer(1, 60)), height = static_cast<int>(r.integer(1, 60));
    const auto to_clip = i % 2 ? eye_at_origin : irg::perspective(irg::pi<double> / 2, 1.0, 3.0, 5.0);
    for (const auto culling : {irg::face_culling::none, irg::face_culling::back}) {
      const drawn on = draw(m, width, height, culling, to_clip), off = draw_all(m, width, height, culling, to_clip);
      REQUIRE(on.lines == off.lines);
      REQUIRE(on.stats.pixels == off.stats.pixels);
      REQUIRE(off.stats.skipped.frustum == 0);
      REQUIRE(on.stats.triangles == off.stats.triangles);
      REQUIRE(on.stats.skipped.frustum + on.stats.skipped.backface >= off.stats.skipped.backface);
      some += on.stats.skipped.frustum, all += on.stats.triangles;
    }
    if (kind != test::positions::ordinary || i % 2 == 0) continue;
    // All corners in front of the eye and within the guard band: a face is beyond where all its cells are.
    std::int64_t beyond = 0;
    const auto v = irg::project_vertices<double>(m.positions, to_clip, irg::map_to_screen<double>({width, height}));
    REQUIRE(v.any.cut == 0);
    for (std::size_t f = 0; f < m.face_count(); ++f) {
      bool left = true, right = true, above = true, below = true;
      for (std::size_t k = 0; k < m.face_size(f); ++k) {
        const irg::subpixel p = v.screen[m.corner(f, k).position].position;
        left &= p.x < 0, right &= p.x >= 256 * width, above &= p.y < 0, below &= p.y >= 256 * height;
      }
      beyond += left || right || above || below ? static_cast<std::int64_t>(m.face_size(f)) - 2 : 0;
    }
    REQUIRE(draw(m, width, height).stats.skipped.frustum == beyond);
  }
  CHECK(some > all / 10);
  CHECK(some < all * 9 / 10);
}

TEST_CASE("draw_wireframe: a corner less than 1/512 pixel beside the picture is snapped into it, and its face drawn") {
  // At distance 1 the picture of 64 pixels spans -1 to 1.
  const auto beside = [](double pixels) {
    const double x = -1 - pixels / 32;
    return one_triangle({x, 0.5, -1}, {x, -0.5, -1}, {x - 1, 0, -1});
  };
  for (const auto culling : {irg::face_culling::none, irg::face_culling::back}) {
    CHECK(draw_all(beside(1.0 / 1024), 64, 64, culling).lines == draw(beside(1.0 / 1024), 64, 64, culling).lines);
    CHECK(draw(beside(3.0 / 1024), 64, 64, culling).stats.skipped.frustum == 1);
  }
  const drawn snapped = draw(beside(1.0 / 1024), 64, 64);
  CHECK(snapped.stats.skipped.frustum == 0);
  CHECK(count(snapped.lines) == 33);  // rows 16 to 48 of the first column
  CHECK(draw_all(beside(3.0 / 1024), 64, 64).stats.skipped == irg::skip_counts{});
  // Beyond the depth range: nearer than 1/8, behind, and farther than 5. A triangle around the picture is in it.
  CHECK(draw(one_triangle({0, 0, -0.1}, {0.01, 0, -0.1}, {0, 0.01, -0.1}), 64, 64).stats.skipped.frustum == 1);
  CHECK(draw(one_triangle({0, 0, 1}, {1, 0, 2}, {0, 1, 3}), 64, 64).stats.skipped.frustum == 1);
  const auto shallow = irg::perspective(irg::pi<double> / 2, 1.0, 3.0, 5.0);
  CHECK(draw(one_triangle({0, 0, -6}, {1, 0, -6}, {0, 1, -6}), 64, 64, irg::face_culling::none, shallow)
            .stats.skipped.frustum == 1);
  CHECK(draw(one_triangle({-9, -9, -1}, {9, -9, -1}, {0, 9, -1}), 64, 64).stats.skipped.frustum == 0);
}

TEST_CASE("draw_wireframe: empty meshes and pictures") {
  CHECK(draw(mesh{}, 8, 8).stats == irg::render_counts{});
  CHECK(draw(cube_before_the_eye(), 1, 1).lines(0, 0) == 1);
  CHECK(draw(cube_before_the_eye(), 8, 0).stats.pixels.shaded == 0);
}

TEST_CASE("draw_wireframe: a pack in braces, of doubles and of floats") {
  const auto cells = []<class T>(const irg::mesh<T>& m) {
    const auto mapping = irg::map_to_screen<T>({40, 40});
    const auto v =
        irg::project_vertices<T>(m.positions, irg::orthographic(irg::view_window<T>{-1, 1, -1, 1}, -2, 2), mapping);
    picture lines(40, 40, 0);
    return irg::draw_wireframe(lines, {v, m, mapping}, 1).pixels.shaded;
  };
  CHECK(cells(irg::shape_cube<double>()) > 0);
  CHECK(cells(irg::shape_cube<double>()) == cells(irg::shape_cube<float>()));
}

}  // namespace
