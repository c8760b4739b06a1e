// SPDX-License-Identifier: MIT
#include <irg/mesh/normals.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using V3 = vec<double, 3>;
using P3 = point<double, 3>;
constexpr double largest = std::numeric_limits<double>::max();

/// A mesh of one polygon.
template <class T, std::size_t N>
constexpr mesh<T> polygon(const std::array<point<T, 3>, N>& vertices) {
  mesh<T> m;
  std::array<std::uint32_t, N> indices{};
  for (std::size_t k = 0; k < N; ++k) {
    m.positions.push_back(vertices[k]);
    indices[k] = static_cast<std::uint32_t>(k);
  }
  add_face(m, indices);
  return m;
}

template <class T>
constexpr mesh<T> right_angle(T size) {
  return polygon<T, 3>({point<T, 3>{T(0), T(0), T(0)}, point<T, 3>{size, T(0), T(0)}, point<T, 3>{T(0), size, T(0)}});
}

constexpr V3 cube_normal(std::size_t vertex, normal_weight weight) {
  return vertex_normals(shape_cube<double>(), weight)[vertex];
}

/// A triangle and the same seen from behind.
constexpr mesh<double> sheet() {
  mesh<double> m = right_angle(1.0);
  add_face(m, std::array{0, 2, 1});
  return m;
}

/// The letter L as one polygon, and the same cut into triangles.
constexpr std::array<P3, 6> letter{P3{0, 0, 0}, P3{3, 0, 0}, P3{3, 1, 0}, P3{1, 1, 1}, P3{1, 3, 0}, P3{0, 3, 0}};

constexpr bool is_near(const V3& a, const V3& b, double tolerance) { return length(a - b) <= tolerance; }

}  // namespace

TEST_CASE("normals: type facts") {
  static_assert(std::is_same_v<decltype(face_normal(mesh<float>{}, 0)), std::optional<vec<float, 3>>>);
  static_assert(std::is_same_v<decltype(vertex_normals(mesh<double>{})), std::vector<V3>>);
  static_assert(noexcept(face_normal(std::declval<const mesh<double>&>(), 0)));
}

TEST_CASE("normals: the vertices of the cube, golden") {
  using enum normal_weight;
  CHECK_BOTH(cube_normal(0, average) == V3{-2.0 / 3, -1.0 / 3, -2.0 / 3});
  CHECK_BOTH(cube_normal(1, average) == V3{-1.0 / 3, -2.0 / 3, 2.0 / 3});
  const double a = 0.408248290463863, b = 0.816496580927726;
  const std::array<V3, 8> expected{
      V3{-2.0 / 3, -1.0 / 3, -2.0 / 3}, V3{-1.0 / 3, -2.0 / 3, 2.0 / 3}, V3{a, -b, -a}, V3{b, -a, a},
      V3{2.0 / 3, 1.0 / 3, -2.0 / 3},   V3{1.0 / 3, 2.0 / 3, 2.0 / 3},   V3{-a, b, -a}, V3{-b, a, a}};
  const auto normals = vertex_normals(shape_cube<double>());
  REQUIRE(normals.size() == 8);
  for (std::size_t v = 0; v < 8; ++v) CHECK(is_near(normals[v], expected[v], 1e-15));
}

TEST_CASE("normals: by angle the cube's are diagonals, however its squares are cut") {
  const mesh<double> cube = shape_cube<double>();
  const auto normals = vertex_normals(cube, normal_weight::angle);
  for (std::size_t v = 0; v < 8; ++v) {
    const V3 diagonal = (cube.positions[v] - P3{0.5, 0.5, 0.5}) * (2 / std::sqrt(3.0));
    CHECK(is_near(normals[v], diagonal, 4e-16));
  }
}

TEST_CASE("normals: by angle and for a polygon with a reflex corner, cutting changes nothing") {
  const mesh<double> whole = polygon(letter);
  mesh<double> cut;
  cut.positions = whole.positions;
  for (const auto& t : {std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{3, 4, 5}, std::array{3, 5, 0}})
    add_face(cut, t);
  // Flat, so that both have the same face normals.
  mesh<double> flat = whole, flat_cut = cut;
  for (auto* m : {&flat, &flat_cut})
    for (P3& p : m->positions) p.z = 0;
  // A wall on the edge 2-3 and on 3-4 makes the normals of the reflex corner depend on its angle.
  for (auto* m : {&flat, &flat_cut}) {
    m->positions.push_back({1, 1, 1});
    m->positions.push_back({3, 1, 1});
    add_face(*m, std::array{3, 2, 7, 6});
  }
  const V3 a = vertex_normals(flat, normal_weight::angle)[3], b = vertex_normals(flat_cut, normal_weight::angle)[3];
  CHECK(is_near(a, b, 1e-15));
  const V3 by_hand = normalized(V3{0, -0.5, 1.5});  // a right angle of wall, three right angles of floor
  CHECK(is_near(a, by_hand, 1e-15));
}

TEST_CASE("normals: by area a large face counts more") {
  mesh<double> m;
  m.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  add_face(m, std::array{0, 1, 2});  // area 2, up z
  add_face(m, std::array{0, 2, 3});  // area 1, along x
  CHECK(is_near(vertex_normals(m, normal_weight::area)[0], normalized(V3{1, 0, 2}), 1e-15));
  CHECK(is_near(vertex_normals(m, normal_weight::average)[0], normalized(V3{1, 0, 1}), 1e-15));
  for (const double size : {0x1p960, 0x1p-960, 0x1p-1060}) {
    mesh<double> other = m;
    for (P3& p : other.positions) p = {p.x * size, p.y * size, p.z * size};
    CHECK(is_near(vertex_normals(other, normal_weight::area)[0], normalized(V3{1, 0, 2}), 1e-15));
  }
}

TEST_CASE("normals: of a sphere's mesh they are nearly its points") {
  const mesh<double> ball = shape_sphere<double>({64, 32});
  for (const auto weight : {normal_weight::average, normal_weight::angle, normal_weight::area}) {
    const auto normals = vertex_normals(ball, weight);
    for (std::size_t v = 0; v < normals.size(); ++v) CHECK(dot(normals[v], to_vec(ball.positions[v])) > 0.998);
  }
}

TEST_CASE("normals: vertices without a direction get zero") {
  CHECK_BOTH(vertex_normals(sheet())[1] == V3{});
  CHECK_BOTH(vertex_normals(sheet(), normal_weight::angle)[1] == V3{});
  CHECK_BOTH(vertex_normals(sheet(), normal_weight::area)[1] == V3{});
  CHECK_BOTH(vertex_normals(mesh<float>{}).empty());
  mesh<double> m = right_angle(1.0);
  m.positions.push_back({5, 5, 5});
  m.positions.push_back({0, 0, std::numeric_limits<double>::quiet_NaN()});
  add_face(m, std::array{0, 1, 4});
  add_face(m, std::array{0, 0, 1});
  for (const auto weight : {normal_weight::average, normal_weight::angle, normal_weight::area}) {
    const auto normals = vertex_normals(m, weight);
    CHECK(normals[0] == V3{0, 0, 1});
    CHECK(normals[3] == V3{});
    CHECK(normals[4] == V3{});
  }
}

TEST_CASE_TEMPLATE("normals: many triangles at a time, other faces between, hostile ones: the bits of one by one", T,
                   float, double) {
  test::random r(29);
  constexpr T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN(),
              most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::denorm_min();
  const T hostile[] = {inf, nan, most, -most, least, T(0), T(1e-30), T(1e30)};
  for (int trial = 0; trial < 60; ++trial) {
    irg::mesh<T> m;
    for (int i = 0; i < 150; ++i) {
      const auto any = [&] {
        if (trial % 2 == 1 && r.integer(0, 20) == 0) return hostile[r.integer(0, 7)];
        return static_cast<T>(std::ldexp(r.unit() - 0.5, trial % 3 == 0 ? 0 : static_cast<int>(r.integer(-60, 60))));
      };
      const T x = any(), y = any();
      m.positions.push_back({x, y, any()});
    }
    for (int f = 0; f < 300; ++f) {
      std::vector<std::int64_t> corners(trial % 4 == 0 || r.integer(0, 40) != 0 ? 3 : 4);
      for (auto& c : corners) c = r.integer(0, 149);
      irg::add_face(m, corners);
    }
    std::vector<irg::vec<T, 3>> expected(m.positions.size());
    for (std::size_t f = 0; f < m.face_count(); ++f)
      if (const auto n = irg::face_normal(m, f))
        for (std::size_t k = 0; k < m.face_size(f); ++k) expected[m.corner(f, k).position] += *n;
    for (auto& n : expected) n = irg::normalized(n);
    const auto got = irg::vertex_normals(m);
    REQUIRE(got.size() == expected.size());
    CAPTURE(trial);
    CHECK(std::memcmp(got.data(), expected.data(), got.size() * sizeof got[0]) == 0);
  }
}

TEST_CASE("normals: assigned to a mesh") {
  mesh<float> cube = shape_cube<float>();
  assign_vertex_normals(cube, normal_weight::angle);
  CHECK(cube.normals.size() == 8);
  for (const mesh_corner& c : cube.corners) CHECK(c.normal == c.position);
}
