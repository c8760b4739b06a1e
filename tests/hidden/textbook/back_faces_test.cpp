// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/back_faces.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::facing;
using irg::orientation;
using point2 = irg::point<double, 2>;
using point3 = irg::point<double, 3>;
using vec3 = irg::vec<double, 3>;
using hpoint3 = irg::hpoint<double, 3>;
using faces = std::vector<std::uint32_t>;

TEST_CASE("textbook back faces: the rule of edges does not notice the back of a star, the area does") {
  constexpr point2 star[] = {{0, 4},  {-1, 1}, {-4, 0}, {-1, -1},
                             {0, -4}, {1, -1}, {4, 0},  {1, 1}};  // counter-clockwise
  CHECK_BOTH(irg::facing_by_order(star, orientation::clockwise) == facing::back);
  CHECK_BOTH(!irg::textbook::is_back_by_edges(star, orientation::clockwise));
}

struct seen_polygon {
  point3 p[3];
  vec3 normal;
  double mixed;
};

TEST_CASE("textbook back faces: the slides' normal, mixed product and procedure, the viewer in (0, 0, 10)") {
  constexpr seen_polygon all[] = {
      {{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {0, 0, 12}, 120},   {{{0, 3, 0}, {4, 0, 0}, {0, 0, 0}}, {0, 0, -12}, -120},
      {{{1, 2, 3}, {4, 0, 1}, {2, 5, -1}}, {14, 10, 11}, 43}, {{{1, 0, 0}, {2, 0, 5}, {3, 0, 1}}, {0, 9, 0}, 0},
      {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}, {0, 0, 1}, 9},      {{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}}, {0, 0, -1}, -10},
      {{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {1, 0, 0}, -1},     {{{0, 1, 0}, {0, 0, 0}, {0, 1, 1}}, {-1, 0, 0}, 0}};
  for (const auto& [p, normal, mixed] : all) {
    CHECK(irg::textbook::face_normal(p[0], p[1], p[2]) == normal);
    CHECK(irg::textbook::mixed_product(p[0], p[1], p[2], 10.0) == mixed);
    CHECK(irg::textbook::is_hidden_polygon(p, 10.0) == !(mixed > 0));
    CHECK(irg::textbook::is_hidden_polygon(p, 10.0, irg::edge_on_faces::drawn) == (mixed < 0));
  }
  static_assert(irg::textbook::mixed_product(all[2].p[0], all[2].p[1], all[2].p[2], 10.0) == 43);
  static_assert(irg::textbook::is_hidden_polygon(all[3].p, 10.0));
  static_assert(!irg::textbook::is_hidden_polygon(all[3].p, 10.0, irg::edge_on_faces::drawn));
}

TEST_CASE(
    "textbook back faces: Hank's values, the rule of the camera's axis errs in both directions under central "
    "projection") {
  constexpr vec3 z{0, 0, 1};
  CHECK_BOTH(irg::textbook::is_back_by_axis(z, vec3{3, 0, 1}));
  CHECK_BOTH(irg::facing_by_angle(vec3{3, 0, 1}, point3{-2, 0, 4}, point3{}) == facing::front);
  CHECK_BOTH(!irg::textbook::is_back_by_axis(z, vec3{3, 0, -1}));
  CHECK_BOTH(irg::facing_by_angle(vec3{3, 0, -1}, point3{2, 0, 4}, point3{}) == facing::back);
  CHECK_BOTH(!irg::textbook::is_back_by_axis(z, vec3{1, 0, 0}));
  // Under parallel projection it is right: the eye is at infinity, against the axis.
  constexpr auto by_axis = [] {
    const irg::mesh<double> cube = irg::shape_cube<double>();
    faces visible;  // the axis' rule shows faces seen from their edge, too
    for (std::uint32_t f = 0; f < cube.face_count(); ++f)
      if (!irg::textbook::is_back_by_axis(vec3{0, 0, 1}, *irg::face_normal(cube, f))) visible.push_back(f);
    return visible.size() == 10 && visible == irg::front_faces(cube, hpoint3{0, 0, -1, 0}, irg::edge_on_faces::drawn) &&
           irg::front_faces(cube, hpoint3{0, 0, -1, 0}).size() == 2;
  };
  CHECK_BOTH(by_axis());
}

TEST_CASE("textbook back faces: an infinitely far eye sees as the camera's axis has it") {
  const irg::mesh<double> m = irg::shape_sphere<double>();
  test::random r(7);
  for (int trial = 0; trial < 50; ++trial) {
    const auto number = [&] { return static_cast<double>(r.integer(-100, 100)) / 64; };
    const vec3 z{number(), number(), number()};
    for (std::size_t f = 0; f < m.face_count(); ++f) {
      const vec3 normal = irg::face_normal(m, f).value_or(vec3{});
      const facing side = irg::facing_of(m, f, hpoint3{-z.x, -z.y, -z.z, 0});
      if (std::abs(dot(z, normal)) > 1e-12) CHECK(irg::textbook::is_back_by_axis(z, normal) == (side == facing::back));
    }
  }
}

TEST_CASE(
    "textbook back faces: the slides' forms are the plane's value at (0, 0, d), for random triangles of integers") {
  test::random r(8);
  for (int trial = 0; trial < 5000; ++trial) {
    const auto number = [&] { return static_cast<double>(r.integer(-9, 9)); };
    const point3 p[3] = {
        {number(), number(), number()}, {number(), number(), number()}, {number(), number(), number()}};
    const double d = number(), mixed = irg::textbook::mixed_product(p[0], p[1], p[2], d);
    const vec3 normal = irg::textbook::face_normal(p[0], p[1], p[2]);
    CHECK(mixed == dot(point3{0, 0, d} - p[1], normal));
    const auto plane = irg::plane_through(p[0], p[1], p[2]);
    CHECK((plane ? irg::normal_of(*plane) : vec3{}) == normal);
    const facing side = plane ? irg::facing_by_plane(*plane, point3{0, 0, d}) : facing::edge_on;
    CHECK(irg::textbook::is_hidden_polygon(p, d) == irg::is_hidden(side));
  }
}

}  // namespace
