// SPDX-License-Identifier: MIT
#include <irg/raster/triangle_batch.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("triangle_batch: an empty one borrows nothing") {
  constexpr irg::triangle_batch<float> batch{};
  CHECK_BOTH(batch.vertices == nullptr);
  CHECK_BOTH(batch.triangles.empty());
  CHECK_BOTH(batch.first_number == 0);
  CHECK_BOTH(batch.object == 0);
}

TEST_CASE("triangle_batch: it borrows vertices and triangles") {
  static constexpr irg::triangle_indices triangles[] = {{{0, 1, 2}}, {{2, 1, 3}}};
  const irg::projected_vertices<double> vertices;
  const irg::triangle_batch<double> batch{&vertices, triangles, 7, 3};
  CHECK(batch.vertices == &vertices);
  CHECK(batch.triangles.data() == triangles);
  CHECK(batch.triangles.size() == 2);
  CHECK(batch.first_number == 7);
  CHECK(batch.object == 3);
}

TEST_CASE("triangle_batch: an index one beyond the last vertex names none") {
  static constexpr irg::triangle_indices triangles[] = {{{0, 1, 2}}, {{0, 3, 1}}, {{3, 0, 1}}, {{0, 1, 4}}};
  irg::projected_vertices<double> vertices;
  vertices.screen.resize(3);
  const irg::triangle_batch<double> batch{&vertices, triangles, 0, 0};
  CHECK(irg::has_vertices(batch, 0));
  CHECK(!irg::has_vertices(batch, 1));
  CHECK(!irg::has_vertices(batch, 2));
  CHECK(!irg::has_vertices(batch, 3));
}

TEST_CASE("triangle_batch: triangles are equal by their indices in order") {
  constexpr irg::triangle_indices t{{0, 1, 2}};
  CHECK_BOTH(t == irg::triangle_indices{{0, 1, 2}});
  CHECK_BOTH(t != irg::triangle_indices{{1, 2, 0}});
}

}  // namespace
