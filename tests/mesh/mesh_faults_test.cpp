// SPDX-License-Identifier: MIT
#include <irg/mesh/mesh_faults.hpp>

#include <initializer_list>
#include <string>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::mesh_fault;
using irg::mesh_fault_kind;
using faults = std::vector<mesh_fault>;

constexpr irg::mesh<double> tetrahedron() {
  irg::mesh<double> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& f : {std::initializer_list<int>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) irg::add_face(m, f);
  return m;
}

std::string words(const mesh_fault& f) { return irg::sentence_of(f); }

}  // namespace

TEST_CASE("list_faults: none in a tetrahedron; each spoiled one has its own, at compile time, too") {
  CHECK_BOTH(irg::list_faults(tetrahedron()).empty());
  CHECK_BOTH(irg::list_faults(irg::mesh<float>{}).empty());
  CHECK_BOTH([] {
    auto m = tetrahedron();
    std::swap(m.corners[1], m.corners[2]);  // the first face turned
    return irg::list_faults(m) == faults{{mesh_fault_kind::faces_turned_apart, 0, 1, 0, 1},
                                         {mesh_fault_kind::faces_turned_apart, 0, 2, 0, 2},
                                         {mesh_fault_kind::faces_turned_apart, 1, 2, 0, 3}};
  }());
  CHECK_BOTH([] {
    auto m = tetrahedron();
    m.corners.resize(9);
    m.face_starts.pop_back();
    return irg::list_faults(m) == faults{{mesh_fault_kind::open_edge, 1, 2, 0},
                                         {mesh_fault_kind::open_edge, 1, 3, 1},
                                         {mesh_fault_kind::open_edge, 2, 3, 2}};
  }());
}

TEST_CASE("list_faults: sentences") {
  auto m = tetrahedron();
  m.positions.push_back({0, 0, -0.0});
  CHECK(words(irg::list_faults(m)[0]) == "no face has position 4");
  CHECK(words(irg::list_faults(m)[1]) == "positions 0 and 4 are in the same place");
  m.positions[4] = {5e-324, 0, 0};
  irg::add_face(m, std::initializer_list<int>{0, 1, 4});
  CHECK(words(irg::list_faults(m)[0]) == "face 4 has no area");
  CHECK(words(irg::list_faults(m)[1]) == "the edge from position 0 to 1 has 3 faces");
  CHECK(words(irg::list_faults(m)[2]) == "the edge from position 0 to 4 has only one face, 4");
  m = tetrahedron();
  irg::add_face(m, std::initializer_list<int>{0, 1, 0});
  CHECK(words(irg::list_faults(m)[0]) == "face 4 has position 0 as a corner more than once");
  m = tetrahedron();
  std::swap(m.corners[1], m.corners[2]);
  CHECK(words(irg::list_faults(m)[0]) == "faces 0 and 1 run along the edge from position 0 to 1 in the same direction");
  m = tetrahedron();
  m.positions.insert(m.positions.end(), {{0, 0, -1}, {0, -1, 0}});
  irg::add_face(m, std::initializer_list<int>{0, 4, 5});
  CHECK(words(irg::list_faults(m).back()) ==
        "the faces at position 0 are 2 fans that have only this position in common");
}

TEST_CASE("list_faults: nothing about edges exactly where is_closed says so") {
  test::random r(20);
  for (int trial = 0; trial < 2000; ++trial) {
    auto m = irg::shape_icosahedron<double>();
    for (std::int64_t k = r.integer(0, 2); k > 0; --k) {
      const auto c = static_cast<std::size_t>(r.integer(0, 59));
      m.corners[c].position = static_cast<std::uint32_t>(r.integer(0, 11));
    }
    bool of_edges = false;
    for (const mesh_fault& f : irg::list_faults(m))
      of_edges = of_edges || f.kind == mesh_fault_kind::open_edge || f.kind == mesh_fault_kind::edge_of_many_faces ||
                 f.kind == mesh_fault_kind::faces_turned_apart || f.kind == mesh_fault_kind::corner_repeated;
    CHECK(of_edges == !irg::is_closed(m));
  }
}
