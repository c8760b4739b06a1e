// SPDX-License-Identifier: MIT
#include <irg/mesh/shapes.hpp>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/mesh_faults.hpp>
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

using namespace irg;

namespace {

template <class T>
double off_sphere(const mesh<T>& m) {
  double worst = 0;
  for (const auto& p : m.positions) {
    const long double x = static_cast<long double>(p.x), y = static_cast<long double>(p.y),
                      z = static_cast<long double>(p.z);
    worst = std::max(worst, static_cast<double>(std::abs(std::sqrt(x * x + y * y + z * z) - 1)));
  }
  return worst;
}

/// Whether the mirror image of every vertex is a vertex, bit for bit.
template <class T>
bool mirrors(const mesh<T>& m, T x, T y, T z) {
  std::set<std::array<T, 3>> all;
  for (const auto& p : m.positions) all.insert({p.x, p.y, p.z});
  for (const auto& p : m.positions)
    if (all.count({p.x * x, p.y * y, p.z * z}) == 0) return false;
  return true;
}

/// A hash of every bit of a mesh's positions and normals.
constexpr std::uint64_t hash(const mesh<double>& m) {
  std::uint64_t h = 14695981039346656037u;
  const auto add = [&](double x) { h = (h ^ bits_of(x)) * 1099511628211u; };
  for (const auto& p : m.positions) add(p.x), add(p.y), add(p.z);
  for (const auto& n : m.normals) add(n.x), add(n.y), add(n.z);
  return h;
}

}  // namespace

TEST_CASE("sphere: by hand") {
  CHECK_BOTH(shape_sphere<double>({4, 2}).positions ==
             std::vector<point<double, 3>>{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}});
  CHECK_BOTH(shape_sphere<float>({4, 2}).face_count() == 8);
}

TEST_CASE("sphere: closed, outward, counted, on the sphere") {
  for (const auto& [slices, stacks] : {std::pair{3, 2}, {4, 3}, {7, 5}, {32, 16}, {33, 17}, {64, 48}}) {
    const auto m = shape_sphere<double>({slices, stacks});
    const auto facts = test::facts_of(m);
    CHECK(m.positions.size() == static_cast<std::size_t>(slices * (stacks - 1) + 2));
    CHECK(m.face_count() == static_cast<std::size_t>(2 * slices * (stacks - 1)));
    CHECK(test::is_closed(m));
    CHECK(facts.euler == 2);
    CHECK(facts.volume > 0);
    CHECK(off_sphere(m) <= 3 * 0x1p-53);
    CHECK(off_sphere(shape_sphere<float>({slices, stacks})) <= 3 * 0x1p-24);
    REQUIRE(m.normals.size() == m.positions.size());
    for (std::size_t v = 0; v < m.positions.size(); ++v) CHECK(m.normals[v] == to_vec(m.positions[v]));
    for (const mesh_corner& c : m.corners) CHECK(c.normal == c.position);
    for (std::size_t f = 0; f < m.face_count(); ++f)
      CHECK(dot(*face_normal(m, f), m.normals[m.corner(f, 0).normal]) > 0);
  }
  CHECK(test::facts_of(shape_sphere<double>({200, 100})).volume ==
        doctest::Approx(4 * std::acos(-1.0) / 3).epsilon(1e-3));
}

TEST_CASE("sphere: exact mirror images") {
  for (const auto& [slices, stacks] : {std::pair{4, 2}, {12, 7}, {32, 16}, {100, 33}}) {
    const auto m = shape_sphere<double>({slices, stacks});
    CHECK(mirrors(m, -1.0, 1.0, 1.0));
    CHECK(mirrors(m, 1.0, -1.0, 1.0));
    CHECK(mirrors(m, 1.0, 1.0, -1.0));
  }
  CHECK(mirrors(shape_sphere<float>({7, 5}), 1.0f, 1.0f, -1.0f));
}

TEST_CASE("sphere: too coarse is taken as the coarsest") {
  CHECK_BOTH(shape_sphere<double>({0, 0}) == shape_sphere<double>({3, 2}));
  CHECK_BOTH(shape_sphere<double>({-2147483647, 1}) == shape_sphere<double>({3, 2}));
  CHECK_BOTH(shape_torus<double>({1, 0.5, 2, -1}) == shape_torus<double>({1, 0.5, 3, 3}));
}

TEST_CASE("torus: closed, outward, one hole, right distances") {
  for (const auto& [major, minor] : {std::pair{3, 3}, {5, 4}, {48, 24}, {17, 31}}) {
    const auto m = shape_torus<double>({2, 0.75, major, minor});
    const auto facts = test::facts_of(m);
    CHECK(m.positions.size() == static_cast<std::size_t>(major * minor));
    CHECK(m.face_count() == static_cast<std::size_t>(2 * major * minor));
    CHECK(test::is_closed(m));
    CHECK(facts.euler == 0);
    CHECK(facts.volume > 0);
    for (std::size_t v = 0; v < m.positions.size(); ++v) {
      const auto p = m.positions[v];
      const double ring = std::sqrt(p.x * p.x + p.z * p.z);
      CHECK(std::hypot(ring - 2, p.y) == doctest::Approx(0.75).epsilon(1e-14));
      const vec<double, 3> outward{(ring - 2) * p.x / ring / 0.75, p.y / 0.75, (ring - 2) * p.z / ring / 0.75};
      CHECK(length(m.normals[v] - outward) < 1e-14);
    }
  }
  CHECK(test::facts_of(shape_torus<double>({2, 0.5, 400, 200})).volume ==
        doctest::Approx(std::acos(-1.0) * std::acos(-1.0)).epsilon(1e-3));
  CHECK(mirrors(shape_torus<float>(), -1.0f, 1.0f, 1.0f));
  CHECK(mirrors(shape_torus<float>(), 1.0f, -1.0f, 1.0f));
}

TEST_CASE("sphere and torus: the same bits in constant evaluation") {
  constexpr std::uint64_t sphere = hash(shape_sphere<double>({7, 5})),
                          torus = hash(shape_torus<double>({2, 0.75, 5, 4}));
  CHECK(hash(shape_sphere<double>({7, 5})) == sphere);
  CHECK(hash(shape_torus<double>({2, 0.75, 5, 4})) == torus);
}

namespace {

using body = irg::mesh<double>;
using ring = std::vector<irg::point<double, 2>>;

double volume(const body& m) {
  double sum = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 2; k < m.face_size(f); ++k) {
      const auto a = m.positions[m.corner(f, 0).position], b = m.positions[m.corner(f, k - 1).position],
                 c = m.positions[m.corner(f, k).position];
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    }
  return sum / 6;
}
double polygon_area(int n) { return n * std::sin(2 * 3.14159265358979323846 / n) / 2; }

}  // namespace

TEST_CASE("shapes by sweeps: closed and outward, at compile time, too") {
  CHECK_BOTH(irg::is_closed(irg::shape_cylinder<double>(5)));
  CHECK_BOTH(irg::is_closed(irg::shape_cone<float>(4)));
  CHECK_BOTH(irg::is_closed(irg::shape_dodecahedron<double>()));
  CHECK_BOTH(irg::is_closed(irg::shape_extrusion(ring{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3.0)));
  CHECK_BOTH(irg::shape_dodecahedron<double>().face_count() == 12);
  CHECK_BOTH(irg::shape_cylinder<double>(0) == irg::shape_cylinder<double>(3));
  CHECK_BOTH(irg::shape_revolution<double>({}).face_count() == 0);
}

TEST_CASE("shapes by sweeps: counts, no faults, volumes") {
  for (const int n : {3, 4, 7, 32}) {
    const body cylinder = irg::shape_cylinder<double>(n), cone = irg::shape_cone<double>(n);
    CHECK(irg::list_faults(cylinder).empty());
    CHECK(irg::list_faults(cone).empty());
    CHECK(cylinder.face_count() == static_cast<std::size_t>(n) + 2);
    CHECK(cone.face_count() == static_cast<std::size_t>(n) + 1);
    CHECK(cone.positions.size() == static_cast<std::size_t>(n) + 1);
    CHECK(volume(cylinder) == doctest::Approx(2 * polygon_area(n)));
    CHECK(volume(cone) == doctest::Approx(2 * polygon_area(n) / 3));
  }
  const body prism = irg::shape_extrusion(ring{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3.0);
  CHECK(irg::list_faults(prism).empty());
  CHECK(volume(prism) == 9);
  const body vase =
      irg::shape_revolution<double>({{0, 0}, {1, 0}, {0.5, 1}, {1, 2}, {0.75, 2}, {0.25, 1}, {0, 0.5}}, 16);
  CHECK(irg::list_faults(vase).empty());
  CHECK(volume(vase) > 0);
  const body dodecahedron = irg::shape_dodecahedron<double>();
  CHECK(irg::list_faults(dodecahedron).empty());
  const double edge = 4 / (std::sqrt(3.0) * (1 + std::sqrt(5.0)));
  CHECK(volume(dodecahedron) == doctest::Approx((15 + 7 * std::sqrt(5.0)) / 4 * edge * edge * edge));
  for (const auto& p : dodecahedron.positions)
    CHECK(std::abs(std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - 1) < 4 * 0x1p-53);
}
