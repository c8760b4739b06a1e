// SPDX-License-Identifier: MIT
#include <irg/scene/stored_body.hpp>

#include <set>
#include <utility>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"

TEST_CASE("stored body: a mesh, each edge once, one surface, at compile time, too") {
  CHECK_BOTH([] {
    irg::mesh<double> m;
    m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    irg::add_face(m, std::initializer_list<int>{0, 1, 2});
    irg::add_face(m, std::initializer_list<int>{2, 3, 0});
    const auto b = irg::store_body("two", m);
    return b.edges == std::vector<irg::stored_edge>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}} && b.shape == m &&
           b.surfaces.size() == 1 && b.surface_of_face == std::vector<std::uint32_t>{0, 0};
  }());
  CHECK_BOTH(irg::store_body("none", irg::mesh<float>{}).edges.empty());
}

TEST_CASE("stored body: the edges of closed bodies, as a set finds them; corners named twice have none") {
  for (const auto& m : {irg::shape_cube<double>(), irg::shape_tetrahedron<double>(), irg::shape_torus<double>()}) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::size_t f = 0; f < m.face_count(); ++f)
      for (std::size_t k = 0; k < m.face_size(f); ++k) {
        const std::uint32_t a = m.corner(f, k).position, b = m.corner(f, (k + 1) % m.face_size(f)).position;
        if (a != b) expected.insert(std::minmax(a, b));
      }
    const auto edges = irg::store_body("m", m).edges;
    CHECK(edges.size() == expected.size());
    for (const irg::stored_edge& e : edges) CHECK(expected.count({e.from, e.to}) == 1);
  }
}
