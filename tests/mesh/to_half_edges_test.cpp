// SPDX-License-Identifier: MIT
#include <irg/mesh/to_half_edges.hpp>

#include <initializer_list>
#include <vector>

#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/merge_positions.hpp>
#include <irg/mesh/mesh_faults.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>

#include "support/check_both.hpp"
#include "support/half_edge_facts.hpp"
#include "support/random.hpp"

namespace {

using irg::half_edge_status;

template <class... Faces>
constexpr irg::mesh<double> faces_of(int positions, const Faces&... faces) {
  irg::mesh<double> m;
  for (int i = 0; i < positions; ++i) {
    const double x = i;
    m.positions.push_back({x, x * x, x * x * x});
  }
  (irg::add_face(m, faces), ...);
  return m;
}
using face = std::initializer_list<int>;

constexpr half_edge_status status_of(const irg::mesh<double>& m) { return irg::to_half_edges(m).status; }

void check_round_trip(const irg::mesh<double>& m) {
  const auto b = irg::to_half_edges(m);
  REQUIRE(b.status == half_edge_status::ok);
  CHECK(test::is_sound(b.value));
  CHECK(irg::to_mesh(b.value) == m);
}

}  // namespace

TEST_CASE("to_half_edges: what is no surface is refused, at compile time, too") {
  CHECK_BOTH(status_of(faces_of(3, face{0, 1, 2})) == half_edge_status::ok);
  CHECK_BOTH(status_of(irg::mesh<double>{}) == half_edge_status::ok);
  CHECK_BOTH(status_of(faces_of(4, face{0, 1, 2}, face{0, 1, 3})) == half_edge_status::faces_turned_apart);
  CHECK_BOTH(status_of(faces_of(5, face{0, 1, 2}, face{1, 0, 3}, face{0, 1, 4})) ==
             half_edge_status::edge_of_many_faces);
  CHECK_BOTH(status_of(faces_of(5, face{0, 1, 2}, face{1, 0, 3}, face{1, 0, 4})) ==
             half_edge_status::edge_of_many_faces);
  CHECK_BOTH(status_of(faces_of(5, face{0, 1, 2}, face{0, 3, 4})) == half_edge_status::vertex_of_many_fans);
  CHECK_BOTH(status_of(faces_of(3, face{0, 0, 1, 2})) == half_edge_status::corner_repeated);
  CHECK_BOTH(status_of(faces_of(3, face{0, 1, 2}, face{2, 1, 0})) == half_edge_status::ok);  // a pillow
}

TEST_CASE("to_half_edges: back again everything is as it was") {
  check_round_trip(irg::shape_cube<double>());
  check_round_trip(irg::shape_torus<double>());
  check_round_trip(irg::shape_grid<double>());
  auto parts = irg::shape_icosahedron<double>();
  parts.parts = {{"a", "b", "c", 0, 7}, {"a", "d", "", 7, 13}};
  check_round_trip(parts);
  const auto prism = faces_of(6, face{2, 1, 0}, face{3, 4, 5}, face{0, 1, 4, 3}, face{1, 2, 5, 4}, face{2, 0, 3, 5});
  check_round_trip(prism);
  CHECK(irg::counts_of(irg::to_half_edges(prism).value) == irg::half_edge_counts{6, 9, 5, 0, 1, 0, 0});
  CHECK(irg::counts_of(irg::to_half_edges(irg::shape_torus<double>()).value).genus == 1);
  CHECK(irg::counts_of(irg::to_half_edges(irg::shape_grid<double>()).value).borders == 1);
}

TEST_CASE("to_half_edges: a vertex of 20,000 faces takes no longer than others") {
  std::vector<int> order;
  test::random r(3);
  irg::mesh<double> m;
  constexpr int n = 20000;
  for (int i = 0; i < n + 1; ++i) m.positions.push_back({double(i), 0, 0});
  order.reserve(n);
  for (int i = 0; i < n; ++i) order.push_back(i);
  for (int i = n - 1; i > 0; --i) std::swap(order[std::size_t(i)], order[std::size_t(r.integer(0, i))]);
  for (const int i : order) irg::add_face(m, face{0, 1 + i, 1 + (i + 1) % n});
  const auto b = irg::to_half_edges(m);
  CHECK(b.status == half_edge_status::ok);
  CHECK(irg::counts_of(b.value) == irg::half_edge_counts{n + 1, 2 * n, n, 0, 1, 1, 0});
}

TEST_CASE("to_half_edges: one face that has a vertex as a corner 20,000 times") {
  constexpr int n = 20000;
  std::vector<int> star, three;
  for (int i = 1; i <= n; ++i) star.insert(star.end(), {0, i});
  const auto m = faces_of(n + 1, star);
  const auto b = irg::to_half_edges(m);
  REQUIRE(b.status == half_edge_status::ok);  // to and fro along each edge: a sphere
  CHECK(irg::counts_of(b.value) == irg::half_edge_counts{n + 1, n, 1, 0, 1, 0, 0});
  CHECK(irg::to_mesh(b.value) == m);
  // What is wrong first is the reason, and no more is looked at.
  for (int i = 0; i < n; ++i) three.insert(three.end(), {0, 1, 2});
  CHECK(status_of(faces_of(3, three)) == half_edge_status::faces_turned_apart);
  three.insert(three.begin(), 0);
  CHECK(status_of(faces_of(3, three)) == half_edge_status::corner_repeated);
}

TEST_CASE("to_half_edges: done exactly where list_faults knows nothing but borders") {
  test::random r(20);
  int done = 0, refused = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    auto m = trial % 2 ? irg::shape_icosahedron<double>()
                       : irg::shape_torus<double>({.major_segments = 3, .minor_segments = 3});
    for (std::int64_t k = r.integer(0, 2); k > 0; --k) {  // spoiled
      const auto c = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(m.corners.size()) - 1));
      m.corners[c].position =
          static_cast<std::uint32_t>(r.integer(0, static_cast<std::int64_t>(m.positions.size()) - 1));
    }
    bool is_surface = true;
    for (const irg::mesh_fault& f : irg::list_faults(m))
      is_surface = is_surface &&
                   (f.kind == irg::mesh_fault_kind::open_edge || f.kind == irg::mesh_fault_kind::face_without_area ||
                    f.kind == irg::mesh_fault_kind::position_unused);
    const auto b = irg::to_half_edges(m);
    CHECK((b.status == half_edge_status::ok) == is_surface);
    CHECK(test::is_sound(b.value));
    is_surface ? ++done : ++refused;
  }
  CHECK(done > 500);
  CHECK(refused > 500);
}
