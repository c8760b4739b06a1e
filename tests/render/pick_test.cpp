// SPDX-License-Identifier: MIT
#include <irg/render/pick.hpp>

#include <cstdint>
#include <initializer_list>
#include <vector>

#include <doctest/doctest.h>
#include <irg/mesh/shapes.hpp>
#include <irg/view/affine.hpp>

#include "support/random.hpp"
#include "support/rendered.hpp"

namespace {

TEST_CASE("pick: the object, face and point of every pixel, as the visibility buffer has them") {
  irg::scene<double> s;
  s.objects.push_back({irg::shape_cube<double>()});
  s.objects.push_back({irg::shape_sphere<double>({.slices = 8, .stacks = 5})});
  s.objects[1].placement(0, 3) = 1.5;
  s.view.eye = {2, 3, 4};
  constexpr int width = 80, height = 70;
  auto ready = irg::prepare_scene(s);
  irg::image<std::uint32_t> ids(width, height, irg::no_index);
  irg::image<float> depth(width, height);
  std::vector<irg::triangle_batch<double>> batches;
  const auto mapping = irg::map_to_screen<double>({width, height});
  std::vector<irg::projected_vertices<double>> vertices;
  for (auto& o : ready.objects)
    vertices.push_back(
        irg::project_vertices<double>(o.body.positions, irg::view_projection(s.view, 80.0 / 70), mapping));
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    batches.push_back({&vertices[i], ready.objects[i].body.triangles, number, static_cast<std::uint32_t>(i)});
    number += static_cast<std::uint32_t>(ready.objects[i].body.triangles.size());
  }
  irg::draw_visibility({ids, depth}, {batches, mapping}, {.clear = irg::clearing::before_drawing});
  int shown = 0;
  for (int y = 0; y < height; y += 3)
    for (int x = 0; x < width; x += 3) {
      const auto p = irg::pick(ready, {width, height}, {x, y});
      REQUIRE(p.has_value() == (ids(x, y) != irg::no_index));
      if (!p) continue;
      ++shown;
      const std::size_t object = ids(x, y) < batches[1].first_number ? 0 : 1;
      CHECK(p->object == object);
      CHECK(p->face == ready.objects[object].body.face_of[ids(x, y) - batches[object].first_number]);
      if (object == 0) CHECK((p->at.x > -1e-6 && p->at.x < 1 + 1e-6 && p->at.y > -1e-6 && p->at.y < 1 + 1e-6));
    }
  CHECK(shown > 50);
  CHECK(irg::pick(s, {width, height}, {40, 35}) == irg::pick(ready, {width, height}, {40, 35}));
  for (const irg::cell outside : {irg::cell{-1, 0}, irg::cell{0, -1}, irg::cell{width, 0}, irg::cell{0, height}})
    CHECK(!irg::pick(ready, {width, height}, outside));
  CHECK(!irg::pick(irg::scene<double>{}, {width, height}, {3, 3}));
}

TEST_CASE("pick: what is drawn at the farthest depth is not seen, and not picked") {
  irg::scene<double> s;
  s.objects.push_back({irg::shape_cube<double>()});
  s.objects[0].placement = irg::scaling(1e60);
  s.view.eye = {0, 0, 1e61};
  CHECK(test::render(s, 20, 20).stats.drawn == 0);
  CHECK(!irg::pick(s, {20, 20}, {11, 8}));
  s.view.near_distance = 1e50;
  CHECK(test::render(s, 20, 20).stats.drawn > 0);
  CHECK(irg::pick(s, {20, 20}, {11, 8}));
}

TEST_CASE("pick: of faces whose depths are equal but for rounding the one that is drawn") {
  test::random r(41);
  int seen = 0;
  for (int round = 0; round < 40; ++round) {
    irg::scene<double> s;
    s.objects.resize(1);
    irg::mesh<double>& m = s.objects[0].shape;
    for (int i = 0; i < 3; ++i) m.positions.push_back({4 * r.unit() - 2, 4 * r.unit() - 2, 2 * r.unit()});
    // One triangle from each of its corners on: equally deep, but rounded otherwise.
    for (int i = 0; i < 3; ++i) irg::add_face(m, std::initializer_list<int>{i, (i + 1) % 3, (i + 2) % 3});
    s.view.eye = {0, 0, 4};
    s.view.near_distance = 1;
    auto ready = irg::prepare_scene(s);
    const auto mapping = irg::map_to_screen<double>({12, 12});
    const auto vertices =
        irg::project_vertices<double>(ready.objects[0].body.positions, irg::view_projection(s.view, 1), mapping);
    const irg::triangle_batch<double> batch[]{{&vertices, ready.objects[0].body.triangles, 0, 0}};
    irg::image<std::uint32_t> ids(12, 12, irg::no_index);
    irg::image<float> depth(12, 12);
    irg::draw_visibility({ids, depth}, {batch, mapping}, {.clear = irg::clearing::before_drawing});
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) {
        const auto p = irg::pick(ready, {12, 12}, {x, y});
        REQUIRE(p.has_value() == (ids(x, y) != irg::no_index));
        if (p) REQUIRE(p->face == ids(x, y));
        seen += p.has_value() ? 1 : 0;
      }
  }
  CHECK(seen > 500);
}

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // the old order goes on compiling
TEST_CASE("pick: a size that is a cell is the old form") {
  irg::scene<double> s;
  s.objects.push_back({irg::shape_cube<double>()});
  s.view.eye = {0.3, 0.2, 5};
  auto ready = irg::prepare_scene(s);
  const irg::extent2 size{40, 30};
  CHECK(irg::pick(s, size, {20, 14}));
  CHECK(irg::pick(ready, size, {20, 14}) == irg::pick(ready, irg::cell{40, 30}, {20, 14}));
  CHECK(irg::pick(s, size, {20, 14}) == irg::pick(s, irg::cell{40, 30}, {20, 14}));
}

}  // namespace
