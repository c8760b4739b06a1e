// SPDX-License-Identifier: MIT
#include <irg/mesh/mesh.hpp>

#include <array>
#include <set>
#include <vector>

#include "support/check_both.hpp"

namespace {

static_assert(irg::Mesh<irg::mesh<float>> && irg::Mesh<irg::mesh<double>> && irg::Mesh<irg::mesh<int>>);
static_assert(!irg::Coordinates<irg::mesh<float>>);
static_assert(std::same_as<irg::mesh_traits<irg::mesh<double>>::point, irg::point<double, 3>>);
static_assert(irg::mesh_corner{}.normal == irg::no_index && irg::mesh_corner{}.texcoord == irg::no_index);

// A pyramid on a square: one face of four corners and four of three.
constexpr irg::mesh<int> pyramid() {
  irg::mesh<int> m;
  for (const irg::point<int, 3>& p : {irg::point<int, 3>{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}})
    m.positions.push_back(p);
  irg::add_face(m, std::array{0, 3, 2, 1});
  irg::add_face(m, std::array{0, 1, 4});
  irg::add_face(m, std::array{1, 2, 4});
  irg::add_face(m, std::array{2, 3, 4});
  irg::add_face(m, std::array{3, 0, 4});
  return m;
}

// Every edge of a closed mesh is walked once in each direction.
constexpr bool closed(const irg::mesh<int>& m) {
  int walked[5][5] = {};
  for (std::size_t f = 0; f < irg::mesh_face_count(m); ++f) {
    const std::size_t n = irg::mesh_face_size(m, f);
    for (std::size_t k = 0; k < n; ++k)
      ++walked[irg::mesh_face_vertex(m, f, k)][irg::mesh_face_vertex(m, f, (k + 1) % n)];
  }
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 5; ++k)
      if (walked[i][k] != walked[k][i] || walked[i][k] > 1) return false;
  return true;
}

}  // namespace

TEST_CASE("mesh_corner: ordered by position, normal, texture coordinate, and hashed") {
  using corner = irg::mesh_corner;
  CHECK_BOTH(
      (corner{1, 9, 9} < corner{2, 0, 0} && corner{1, 1, 9} < corner{1, 2, 0} && corner{1, 1, 1} < corner{1, 1, 2}));
  CHECK_BOTH(!(corner{1, 1, 1} < corner{1, 1, 1}));
  std::set<std::size_t> hashes;
  for (std::uint32_t i = 0; i < 8000; ++i) hashes.insert(std::hash<corner>{}({i % 20, i / 20 % 20, i / 400}));
  CHECK(hashes.size() == 8000);
}

TEST_CASE("mesh: faces of different sizes share their positions") {
  CHECK_BOTH(irg::mesh_vertex_count(pyramid()) == 5);
  CHECK_BOTH(irg::mesh_face_count(pyramid()) == 5);
  CHECK_BOTH(irg::mesh_face_size(pyramid(), 0) == 4);
  CHECK_BOTH(irg::mesh_face_size(pyramid(), 4) == 3);
  CHECK_BOTH(irg::mesh_face_vertex(pyramid(), 0, 1) == 3);
  CHECK_BOTH(irg::mesh_face_vertex(pyramid(), 4, 2) == 4);
  CHECK_BOTH(irg::mesh_position(pyramid(), 4) == irg::point<int, 3>{1, 1, 3});
  CHECK_BOTH(closed(pyramid()));
}

TEST_CASE("mesh: corners may name normals and texture coordinates of their own") {
  irg::mesh<float> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  m.normals = {{0, 0, 1}};
  irg::add_face(m, std::vector<std::uint32_t>{0, 1, 2});
  CHECK(m.corner(0, 2).position == 2);
  CHECK(m.corner(0, 2).normal == irg::no_index);
  m.corners[2].normal = 0;
  CHECK(m.corner(0, 2).normal == 0);
  CHECK(m.normals[m.corner(0, 2).normal] == irg::vec<float, 3>{0, 0, 1});
}

TEST_CASE("mesh: empty, copied and compared") {
  CHECK_BOTH(irg::mesh<float>{}.face_count() == 0);
  CHECK_BOTH(irg::mesh_vertex_count(irg::mesh<float>{}) == 0);
  CHECK_BOTH(pyramid() == pyramid());
  irg::mesh<int> other = pyramid();
  other.positions[4].z = 4;
  CHECK(other != pyramid());
  irg::mesh<float> hollow;
  hollow.face_starts.clear();  // as a moved-from mesh may be
  CHECK(hollow.face_count() == 0);
}

TEST_CASE("add_face: indices in braces, of any one type") {
  constexpr auto made = [] {
    irg::mesh<double> m;
    m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    irg::add_face(m, {0, 1, 2});
    const std::size_t last = 3;
    irg::add_face(m, {last, std::size_t{2}, std::size_t{1}, std::size_t{0}});
    return m;
  };
  CHECK_BOTH(made().face_count() == 2);
  CHECK_BOTH(made().corner(0, 2).position == 2);
  CHECK_BOTH(made().face_size(1) == 4);
  CHECK_BOTH(made().corner(1, 0).position == 3);
}
