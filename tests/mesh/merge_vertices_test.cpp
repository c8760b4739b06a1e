// SPDX-License-Identifier: MIT
#include <irg/mesh/merge_vertices.hpp>

#include <cstdint>
#include <map>
#include <vector>

#include <irg/mesh/crease_normals.hpp>
#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/mesh_files.hpp"
#include "support/random.hpp"

namespace {

using irg::list_triangles;
using irg::merge_vertices;

constexpr irg::mesh<double> square() {
  irg::mesh<double> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-0.0, 0, 0}, {9, 9, 9}};
  m.texcoords = {{0, 0}, {1, 1}, {-0.0, 0}};
  m.corners = {{0, irg::no_index, 0}, {1}, {2}, {4, irg::no_index, 2}, {2}, {3}};
  m.face_starts = {0, 3, 6};
  return m;
}

}  // namespace

TEST_CASE("merge_vertices: by value, in the order of use, at compile time, too") {
  CHECK_BOTH([] {
    const auto v = merge_vertices(square());
    return v.vertices == std::vector<irg::mesh_corner>{{0, irg::no_index, 0}, {1}, {2}, {3}} &&
           v.triangles == std::vector<irg::triangle_indices>{{{0, 1, 2}}, {{0, 2, 3}}};
  }());
  CHECK_BOTH(merge_vertices(irg::mesh<float>{}).vertices.empty());
  CHECK_BOTH(list_triangles(square()) == std::vector<irg::triangle_indices>{{{0, 1, 2}}, {{4, 2, 3}}});
}

TEST_CASE("merge_vertices: a cube with its creases has 24 vertices, a smooth one 8") {
  irg::mesh<double> cube = irg::shape_cube<double>();
  irg::assign_crease_normals(cube, 0.1);
  CHECK(merge_vertices(cube).vertices.size() == 24);
  CHECK(merge_vertices(cube).triangles.size() == 12);
  CHECK(merge_vertices(test::without_attributes(cube)).vertices.size() == 8);
}

TEST_CASE("merge_vertices: a map from numbers to places says the same, and nothing of a corner is lost") {
  test::random r(77);
  for (int trial = 0; trial < 200; ++trial) {
    irg::mesh<double> m;
    const auto number = [&] { return r.integer(0, 9) == 0 ? -0.0 : static_cast<double>(r.integer(-1, 1)) * 1e-300; };
    for (int i = 0; i < 20; ++i) {
      const double x = number(), y = number(), z = number();
      m.positions.push_back({x, y, z});
      m.normals.push_back({z, x, y});
      m.texcoords.push_back({y, x});
    }
    for (int f = 0; f < 15; ++f) {
      for (std::int64_t k = r.integer(3, 5); k > 0; --k) {
        const auto index = [&] { return static_cast<std::uint32_t>(r.integer(0, 19)); };
        irg::mesh_corner c;
        c.position = index();
        if (r.integer(0, 1) == 0) c.normal = index();
        if (r.integer(0, 1) == 0) c.texcoord = index();
        m.corners.push_back(c);
      }
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
    const auto merged = merge_vertices(m);
    const auto key = [&](const irg::mesh_corner& c) {
      std::vector<double> k = {m.positions[c.position][0], m.positions[c.position][1], m.positions[c.position][2]};
      k.push_back(c.normal == irg::no_index ? 0 : 1);
      if (k.back() == 1)
        for (int i = 0; i < 3; ++i) k.push_back(m.normals[c.normal][i]);
      k.push_back(c.texcoord == irg::no_index ? 0 : 1);
      if (k.back() == 1)
        for (int i = 0; i < 2; ++i) k.push_back(m.texcoords[c.texcoord][i]);
      return k;
    };
    const auto triangles = irg::triangulated(m);
    std::map<std::vector<double>, std::uint32_t> places;
    REQUIRE(merged.triangles.size() == triangles.face_count());
    for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
      const auto next = static_cast<std::uint32_t>(places.size());
      const std::uint32_t place = places.try_emplace(key(triangles.corners[i]), next).first->second;
      REQUIRE(merged.triangles[i / 3].v[i % 3] == place);
      CHECK(key(merged.vertices[place]) == key(triangles.corners[i]));
    }
    CHECK(merged.vertices.size() == places.size());
  }
}
