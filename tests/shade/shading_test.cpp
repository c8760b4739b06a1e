// SPDX-License-Identifier: MIT
#include <irg/shade/shading.hpp>

#include <array>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using point3 = irg::point<double, 3>;
using vec3 = irg::vec<double, 3>;
using triangle = std::array<point3, 3>;

// The unit cube of the course: 12 triangles, counter-clockwise seen from outside.
constexpr std::array<point3, 8> corners{
    {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}, {0, 1, 0}, {0, 1, 1}}};
constexpr std::array<std::array<std::size_t, 3>, 12> faces{{{0, 2, 1},
                                                            {2, 3, 1},
                                                            {2, 4, 3},
                                                            {4, 5, 3},
                                                            {4, 6, 5},
                                                            {6, 7, 5},
                                                            {6, 0, 7},
                                                            {0, 1, 7},
                                                            {0, 4, 2},
                                                            {0, 6, 4},
                                                            {1, 3, 5},
                                                            {1, 5, 7}}};

constexpr triangle face(std::size_t i) { return {corners[faces[i][0]], corners[faces[i][1]], corners[faces[i][2]]}; }
constexpr vec3 face_normal(std::size_t i) {
  const triangle t = face(i);
  return irg::cross(t[1] - t[0], t[2] - t[0]);
}
constexpr vec3 vertex_normal(std::size_t v) {
  vec3 sum;
  for (std::size_t i = 0; i < 12; ++i)
    if (faces[i][0] == v || faces[i][1] == v || faces[i][2] == v) sum += face_normal(i);
  return sum;
}

// Ia = 100, ka = 1/5, Ii = 200, kd = 3/5, no highlight: formula (7.7). A point light at (3, 2, 4).
constexpr irg::material<double, double> matte{0.2, 0.6, 0.0, 1.0};
constexpr static std::array<irg::light<double, double>, 1> lamp{{{{3, 2, 4, 1}, 200.0}}};
constexpr irg::lighting<double, double> course{100.0, lamp};
constexpr irg::flat_shader<double, double> flat{matte, course, {5, 5, 5}};
constexpr irg::gouraud_shader<double, double> gouraud{matte, course, {5, 5, 5}};
constexpr irg::phong_shader<double, double> phong{matte, course, {5, 5, 5}};

constexpr bool near(double a, double b) { return a - b < 1e-12 * b && b - a < 1e-12 * b; }

}  // namespace

TEST_CASE("shading: plain aggregates") {
  static_assert(std::is_trivially_copyable_v<irg::flat_shader<float>> && std::is_aggregate_v<irg::phong_shader<float>>);
  static_assert(std::is_same_v<decltype(irg::phong_shader<float>{}(irg::point<float, 3>{}, irg::vec<float, 3>{})),
                               irg::rgb<float>>);
  static_assert(noexcept(gouraud({}, {})));
}

TEST_CASE("shading: the mean of vertices") {
  CHECK_BOTH(irg::vertex_mean(triangle{{{0, 0, 0}, {3, 0, 3}, {0, 6, 3}}}) == point3{1, 2, 2});
  CHECK_BOTH(irg::vertex_mean(std::array<point3, 1>{{{1, 2, 3}}}) == point3{1, 2, 3});
  CHECK_BOTH(irg::vertex_mean(std::array<irg::point<float, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) ==
             irg::point<float, 2>{0.5f, 0.5f});
  CHECK(irg::vertex_mean(std::vector<point3>{{0, 0, 0}, {2, 4, 8}}) == point3{1, 2, 4});
}

TEST_CASE("shading: the course's values, the faces of the cube") {
  constexpr double golden[12] = {20, 20, 73.3699507995993, 78.3997116070745, 46.9076633390697, 47.3702931657094, 20, 20,
                                 20, 20, 106.74768752147,  105.115923873823};
  constexpr auto all_right = [](const double(&expected)[12]) {
    for (std::size_t i = 0; i < 12; ++i)
      if (!near(flat(face(i), face_normal(i)), expected[i])) return false;
    return true;
  };
  CHECK_BOTH(all_right(golden));
  for (std::size_t i = 0; i < 12; ++i) CHECK(near(flat(face(i), face_normal(i)), golden[i]));
  constexpr double in_constant_evaluation = flat(face(10), face_normal(10));
  const volatile std::size_t at_run_time = 10;
  CHECK(flat(face(at_run_time), face_normal(at_run_time)) == in_constant_evaluation);
}

TEST_CASE("shading: the course's values, the vertices of the cube") {
  constexpr double golden[8] = {20, 20, 20, 79.4088525786005, 20, 126.90449676497, 20, 20};
  constexpr auto all_right = [](const double(&expected)[8]) {
    for (std::size_t v = 0; v < 8; ++v)
      if (!near(gouraud(corners[v], vertex_normal(v)), expected[v])) return false;
    return true;
  };
  CHECK_BOTH(all_right(golden));
  for (std::size_t v = 0; v < 8; ++v) CHECK(near(gouraud(corners[v], vertex_normal(v)), golden[v]));
}

TEST_CASE("shading: a normal's length does not matter") {
  test::random random(3);
  for (int i = 0; i < 1000; ++i) {
    const vec3 n{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
    const point3 p{random.unit(), random.unit(), random.unit()};
    REQUIRE(phong(p, n) == phong(p, n * 4.0));
    REQUIRE(near(phong(p, n), phong(p, n / 3.0)));
    REQUIRE(phong(p, n) == irg::phong_model(matte, course, {5, 5, 5}, {p, irg::normalized(n)}));
    REQUIRE(gouraud(p, n) == phong(p, n));  // at a vertex the two agree
    REQUIRE(flat(p, n) == phong(p, n));     // and at the centre of a face, when its normal is given
  }
}

TEST_CASE("shading: a highlight inside a triangle is seen by Phong's shading and missed by Gouraud's") {
  constexpr static std::array<irg::light<double, double>, 1> sun{{{{0, 0, 1, 0}, 1.0}}};
  constexpr irg::material<double, double> glossy{0.0, 0.0, 1.0, 50.0};
  constexpr irg::lighting<double, double> light{0.0, sun};
  constexpr irg::gouraud_shader<double, double> at_vertices{glossy, light, {0, 0, 9}};
  constexpr irg::phong_shader<double, double> at_pixels{glossy, light, {0, 0, 9}};
  constexpr vec3 normals[3] = {{-1, 0, 1}, {1, 0, 1}, {0, 0, 0.5}};  // the first two bend apart
  constexpr point3 ends[2] = {{-1, 0, 0}, {1, 0, 0}};
  constexpr double gouraud_middle = (at_vertices(ends[0], normals[0]) + at_vertices(ends[1], normals[1])) / 2;
  CHECK_BOTH(gouraud_middle < 1e-3);
  CHECK_BOTH(at_pixels({0, 0, 0}, (normals[0] + normals[1]) / 2.0) == 1.0);
}

TEST_CASE("shading: degenerate faces give the ambient term") {
  constexpr triangle needle{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
  CHECK_BOTH(flat(needle, irg::cross(needle[1] - needle[0], needle[2] - needle[0])) == 20.0);
  CHECK_BOTH(gouraud({3, 2, 4}, {1, 0, 0}) == 20.0);               // the light in the vertex
  CHECK_BOTH(phong({0, 0, 0}, vec3{1, 2, 3} + vec3{-1, -2, -3}) == 20.0);  // opposite normals interpolated
}
