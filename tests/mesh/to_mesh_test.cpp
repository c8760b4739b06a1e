// SPDX-License-Identifier: MIT
#include <irg/mesh/to_mesh.hpp>

#include <array>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"

namespace {

// A user's mesh: quadrilaterals over a grid that nobody stores.
struct grid_mesh {
  std::size_t columns = 0;
};

}  // namespace

template <>
struct irg::mesh_traits<grid_mesh> {
  using point = irg::point<double, 3>;
  static constexpr std::size_t vertex_count(const grid_mesh& g) { return 2 * (g.columns + 1); }
  static constexpr point position(const grid_mesh&, std::size_t v) {
    return {static_cast<double>(v / 2), static_cast<double>(v % 2), 0.1};
  }
  static constexpr std::size_t face_count(const grid_mesh& g) { return g.columns; }
  static constexpr std::size_t face_size(const grid_mesh&, std::size_t) { return 4; }
  static constexpr std::size_t face_vertex(const grid_mesh&, std::size_t f, std::size_t k) {
    constexpr std::size_t corner[4] = {0, 2, 3, 1};
    return 2 * f + corner[k];
  }
};

namespace {

TEST_CASE("to_mesh: a mesh of a user's type") {
  constexpr auto made = [] { return irg::to_mesh<double>(grid_mesh{3}); };
  CHECK_BOTH(made().positions.size() == 8);
  CHECK_BOTH(made().face_count() == 3);
  CHECK_BOTH(made().corner(2, 1).position == 6);
  CHECK_BOTH(made().corner(2, 1).normal == irg::no_index);
  CHECK_BOTH(made().positions[5] == irg::point<double, 3>{2, 1, 0.1});
  constexpr auto floats = [] { return irg::to_mesh<float>(grid_mesh{1}); };
  CHECK_BOTH(floats().positions[0].z == 0.1f);
  CHECK_BOTH(irg::to_mesh<double>(grid_mesh{}).face_count() == 0);
}

TEST_CASE("to_mesh: irg's own keeps all it has") {
  const auto ball = irg::shape_sphere<double>();
  CHECK(irg::to_mesh<double>(ball) == ball);
  const auto narrow = irg::to_mesh<float>(ball);
  REQUIRE(narrow.normals.size() == ball.normals.size());
  CHECK(narrow.corners == ball.corners);
  CHECK(narrow.face_starts == ball.face_starts);
  CHECK(narrow.parts == ball.parts);
  for (std::size_t i = 0; i < ball.positions.size(); ++i)
    REQUIRE(narrow.positions[i].y == static_cast<float>(ball.positions[i].y));
  for (std::size_t i = 0; i < ball.normals.size(); ++i)
    REQUIRE(narrow.normals[i].x == static_cast<float>(ball.normals[i].x));
}

}  // namespace
