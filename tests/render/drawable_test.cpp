// SPDX-License-Identifier: MIT
#include <irg/render/drawable.hpp>

#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/mesh_facts.hpp"
#include "support/random.hpp"
#include "support/scenes.hpp"

namespace {

using irg::mesh_corner;

// Two triangles that share an edge, flat: the normals differ at none of its corners.
constexpr irg::mesh<double> roof() {
  irg::mesh<double> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  irg::add_face(m, std::vector<int>{0, 1, 2});
  irg::add_face(m, std::vector<int>{1, 3, 2});
  return m;
}

// The same with a normal of its own for each face: the shared positions become two vertices each.
constexpr irg::mesh<double> creased_roof() {
  irg::mesh<double> m = roof();
  m.normals = {{0, 0, 1}, {0, 1, 0}};
  for (std::uint32_t k = 0; k < 6; ++k) m.corners[k].normal = k / 3;
  return m;
}

// A pentagon with a dent beside a triangle.
constexpr irg::mesh<double> polygons() {
  irg::mesh<double> m;
  m.positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}, {2, 6, 0}};
  irg::add_face(m, std::vector<int>{0, 1, 2, 3, 4});
  irg::add_face(m, std::vector<int>{4, 3, 2});
  irg::add_face(m, std::vector<int>{4, 2, 5, 0});
  return m;
}

constexpr std::size_t vertices_of(const irg::mesh<double>& m) { return irg::make_drawable(m).positions.size(); }

TEST_CASE("make_drawable: corners of one position and normal share a vertex") {
  CHECK_BOTH(vertices_of(roof()) == 4);
  CHECK_BOTH(vertices_of(creased_roof()) == 6);
  CHECK_BOTH(irg::make_drawable(creased_roof()).triangles.size() == 2);
}

TEST_CASE("make_drawable: meshes without normals get the average of the faces around") {
  const auto d = irg::make_drawable(test::without_normals(irg::shape_octahedron<double>()));
  CHECK(d.positions.size() == 6);
  CHECK(d.triangles.size() == 8);
  for (std::size_t v = 0; v < 6; ++v)  // by symmetry away from the middle
    CHECK(irg::length(d.normals[v] - irg::to_vec(d.positions[v])) < 1e-15);
}

TEST_CASE("make_drawable: where some corners have no normal, none is used") {
  irg::mesh<double> m = creased_roof();
  m.normals = {{1, 0, 0}, {1, 0, 0}};
  m.corners[4].normal = irg::no_index;
  const auto d = irg::make_drawable(m);
  for (const auto& n : d.normals) CHECK(n == irg::vec<double, 3>{0, 0, 1});
}

TEST_CASE("make_drawable: polygons are cut, and each triangle knows its face") {
  const auto d = irg::make_drawable(polygons());
  CHECK(d.triangles.size() == 3 + 1 + 2);
  CHECK(d.face_of == std::vector<std::uint32_t>{0, 0, 0, 1, 2, 2});
  double area = 0;  // of the dented pentagon: the fan would have 12
  for (std::size_t t = 0; t < 3; ++t) {
    const auto [a, b, c] = d.triangles[t].v;
    const double twice = irg::cross(d.positions[b] - d.positions[a], d.positions[c] - d.positions[a]).z;
    CHECK(twice > 0);
    area += twice / 2;
  }
  CHECK(area == 10);
}

TEST_CASE("make_drawable: every triangle has its corners' positions and normals") {
  test::random r(1);
  for (int i = 0; i < 200; ++i) {
    const auto m = irg::triangulated(test::random_mesh<double>(r, 20, test::positions::everywhere));
    const auto d = irg::make_drawable(m);
    REQUIRE(d.triangles.size() == m.face_count());
    REQUIRE(d.face_of.size() == m.face_count());
    REQUIRE(d.normals.size() == d.positions.size());
    for (std::size_t t = 0; t < m.face_count(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = d.triangles[t].v[k];
        REQUIRE(v < d.positions.size());
        REQUIRE(d.positions[v] == m.positions[m.corner(t, k).position]);
        if (!m.normals.empty()) REQUIRE(d.normals[v] == m.normals[m.corner(t, k).normal]);
      }
  }
}

TEST_CASE("make_drawable: empty meshes, unused positions") {
  CHECK_BOTH(irg::make_drawable(irg::mesh<double>{}).triangles.empty());
  irg::mesh<double> m;
  m.positions = {{0, 0, 0}};
  CHECK(irg::make_drawable(m).triangles.empty());
  m = roof();
  m.positions.push_back({9, 9, 9});
  CHECK(vertices_of(m) == 4);
}

TEST_CASE("make_drawable: a hub at which many normals meet takes linear time") {
  irg::mesh<double> m;
  constexpr std::uint32_t faces = 300000;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::uint32_t f = 0; f < faces; ++f) {
    m.normals.push_back({0, 0, 1.0 + f});
    for (std::uint32_t k = 0; k < 3; ++k) m.corners.push_back({k, f, irg::no_index});
    m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
  }
  const auto d = irg::make_drawable(m);  // going through all normals of the hub takes minutes
  CHECK(d.triangles.size() == faces);
  CHECK(d.positions.size() == 3 * faces);
}

}  // namespace
