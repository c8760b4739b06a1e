// SPDX-License-Identifier: MIT
#include <irg/mesh/shape_polyhedra.hpp>

#include <array>
#include <cmath>

#include <irg/mesh/normals.hpp>

#include "support/check_both.hpp"
#include "support/mesh_facts.hpp"

using namespace irg;

namespace {

/// The spread of edge lengths and of distances from the origin: zero for a regular body in a sphere.
template <class T>
double irregularity(const mesh<T>& m) {
  double shortest = 1e9, longest = 0, off_sphere = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = m.positions[m.corner(f, k).position], q = m.positions[m.corner(f, (k + 1) % 3).position];
      const double edge = static_cast<double>(length(q - p));
      shortest = std::min(shortest, edge), longest = std::max(longest, edge);
      off_sphere = std::max(off_sphere, std::abs(static_cast<double>(length(to_vec(p))) - 1));
    }
  return std::max(longest - shortest, off_sphere);
}

}  // namespace

TEST_CASE("polyhedra: the cube of the course, vertex by vertex and face by face") {
  using P = point<int, 3>;
  constexpr std::array<P, 8> v{P{0, 0, 0}, P{0, 0, 1}, P{1, 0, 0}, P{1, 0, 1},
                               P{1, 1, 0}, P{1, 1, 1}, P{0, 1, 0}, P{0, 1, 1}};
  constexpr std::array<std::array<std::uint32_t, 3>, 12> f{{{1, 3, 2},
                                                            {3, 4, 2},
                                                            {3, 5, 4},
                                                            {5, 6, 4},
                                                            {5, 7, 6},
                                                            {7, 8, 6},
                                                            {7, 1, 8},
                                                            {1, 2, 8},
                                                            {1, 5, 3},
                                                            {1, 7, 5},
                                                            {2, 4, 6},
                                                            {2, 6, 8}}};
  const mesh<int> cube = shape_cube<int>();
  REQUIRE(cube.positions.size() == 8);
  REQUIRE(cube.face_count() == 12);
  for (std::size_t k = 0; k < 8; ++k) CHECK(cube.positions[k] == v[k]);
  for (std::size_t k = 0; k < 12; ++k)
    for (std::size_t c = 0; c < 3; ++c) CHECK(cube.corner(k, c).position + 1 == f[k][c]);
  CHECK_BOTH(shape_cube<float>().corner(9, 2).position == 4);  // f 1 7 5, misprinted in the P list
  CHECK(test::facts_of(cube).volume == doctest::Approx(1));
  CHECK(test::is_closed(cube));
}

TEST_CASE("polyhedra: regular, closed, outward") {
  CHECK_BOTH(shape_tetrahedron<double>().face_count() == 4);
  CHECK_BOTH(shape_octahedron<int>().face_count() == 8);
  CHECK_BOTH(shape_icosahedron<float>().face_count() == 20);
  const auto check = [](const mesh<double>& m, double volume) {
    CHECK(test::is_closed(m));
    CHECK(test::facts_of(m).euler == 2);
    CHECK(test::facts_of(m).vertices == m.positions.size());
    CHECK(test::facts_of(m).volume == doctest::Approx(volume).epsilon(1e-14));
    CHECK(irregularity(m) < 1e-15);
    for (std::size_t f = 0; f < m.face_count(); ++f)
      CHECK(dot(*face_normal(m, f), to_vec(m.positions[m.corner(f, 0).position])) > 0);
  };
  check(shape_tetrahedron<double>(), 8 / (9 * std::sqrt(3.0)));
  check(shape_octahedron<double>(), 4.0 / 3);
  const double edge = 4 / std::sqrt(10 + 2 * std::sqrt(5.0));
  check(shape_icosahedron<double>(), 5 * (3 + std::sqrt(5.0)) / 12 * edge * edge * edge);
  CHECK(irregularity(shape_icosahedron<float>()) < 3e-7);
}

TEST_CASE("polyhedra: every corner has the normal of its face") {
  const auto check = []<class T>(const mesh<T>& m, std::size_t normals, double tolerance) {
    CHECK(m.normals.size() == normals);
    for (std::size_t f = 0; f < m.face_count(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(m.corner(f, k).normal < normals);
        CHECK(static_cast<double>(length(m.normals[m.corner(f, k).normal] - *face_normal(m, f))) <= tolerance);
      }
  };
  check(shape_cube<double>(), 6, 0);
  check(shape_cube<float>(), 6, 0);
  check(shape_tetrahedron<double>(), 4, 3e-16);
  check(shape_octahedron<double>(), 8, 3e-16);
  check(shape_octahedron<float>(), 8, 2e-7);
  check(shape_icosahedron<double>(), 20, 3e-16);
  check(shape_icosahedron<float>(), 20, 2e-7);
  CHECK_BOTH(shape_octahedron<int>().normals[7] == vec<int, 3>{1, -1, -1});
  CHECK_BOTH(shape_cube<int>().normals[shape_cube<int>().corner(10, 0).normal] == vec<int, 3>{0, 0, 1});
}

TEST_CASE("polyhedra: the grid") {
  const mesh<float> m = shape_grid<float>({3, 2});
  CHECK(m.positions.size() == 12);
  CHECK(m.face_count() == 12);
  CHECK(m.positions.front() == point<float, 3>{-1, 0, -1});
  CHECK(m.positions.back() == point<float, 3>{1, 0, 1});
  for (std::size_t f = 0; f < m.face_count(); ++f) CHECK(*face_normal(m, f) == vec<float, 3>{0, 1, 0});
  const auto facts = test::facts_of(m);
  CHECK(facts.euler == 1);
  CHECK(facts.border_edges == 10);
  CHECK(facts.repeated_edges == 0);
  for (const mesh_corner& c : m.corners) CHECK(c.normal == 0);
  CHECK_BOTH(shape_grid<double>({0, -5}).face_count() == 2);
}
