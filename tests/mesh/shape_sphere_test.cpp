// SPDX-License-Identifier: MIT
#include <irg/mesh/shape_sphere.hpp>

#include <array>
#include <cmath>
#include <set>

#include <irg/mesh/normals.hpp>

#include "support/check_both.hpp"
#include "support/mesh_facts.hpp"

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
