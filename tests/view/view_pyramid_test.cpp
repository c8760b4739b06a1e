// SPDX-License-Identifier: MIT
#include <irg/view/view_pyramid.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::containment;
using irg::depth_range;
using irg::frustum_plane;
using irg::handedness;
using irg::perspective;
using irg::perspective_checked;
using irg::plane;
using irg::point;
using irg::projection_status;
using irg::pyramid_corners;
using irg::pyramid_planes;
using irg::view_pyramid;
using test::rational;

namespace {

using R = rational;
using P = point<R, 3>;
// Hank's: m1 = 8, m2 = 6, d = 2, n = 1, h = 10.
constexpr view_pyramid<R> course{2, 8, 6, 1, 10};
constexpr view_pyramid<double> course_double{2, 8, 6, 1, 10};

}  // namespace

TEST_CASE("view_pyramid: Hank's values, corners") {
  constexpr auto c = pyramid_corners(course, handedness::left);
  CHECK_BOTH(c.at[3] == P{2, {3, 2}, 1});
  CHECK_BOTH(c.at[7] == P{20, 15, 10});
  CHECK_BOTH(c.at[0] == P{-2, {-3, 2}, 1});
  CHECK_BOTH(c.at[5] == P{20, -15, 10});
  CHECK_BOTH(pyramid_corners(course).at[6] == P{-20, 15, -10});
}

TEST_CASE("view_pyramid: Hank's values, planes with inward normals") {
  constexpr auto f = pyramid_planes(course, handedness::left);
  CHECK_BOTH(f[frustum_plane::left] == plane<R>{12, 0, 24, 0});
  CHECK_BOTH(f[frustum_plane::right] == plane<R>{-12, 0, 24, 0});
  CHECK_BOTH(f[frustum_plane::top] == plane<R>{0, -16, 24, 0});
  CHECK_BOTH(f[frustum_plane::bottom] == plane<R>{0, 16, 24, 0});
  CHECK_BOTH(f[frustum_plane::z_near] == plane<R>{0, 0, 1, -1});
  CHECK_BOTH(f[frustum_plane::z_far] == plane<R>{0, 0, -1, 10});
  constexpr auto right_handed = pyramid_planes(course);
  for (int k = 0; k < 6; ++k) CHECK(right_handed.planes[k] == change_handedness(f.planes[k]));
  CHECK_BOTH(pyramid_planes(view_pyramid<int>{2, 8, 6, 1, 10}, handedness::left)[frustum_plane::left] ==
             plane<int>{12, 0, 24, 0});
}

TEST_CASE("view_pyramid: reference values, what is inside") {
  constexpr auto f = pyramid_planes(course, handedness::left);
  using enum containment;
  CHECK_BOTH(classify(f, P{0, 0, 5}) == inside);
  CHECK_BOTH(classify(f, P{10, 0, 5}) == inside);
  CHECK_BOTH(classify(f, P{11, 0, 5}) == outside);
  CHECK_BOTH(classify(f, P{0, {15, 2}, 5}) == inside);
  CHECK_BOTH(classify(f, P{0, 8, 5}) == outside);
  CHECK_BOTH(classify(f, P{0, 0, 1}) == inside);
  CHECK_BOTH(classify(f, P{0, 0, {1, 2}}) == outside);
  CHECK_BOTH(classify(f, P{0, 0, 10}) == inside);
  CHECK_BOTH(classify(f, P{0, 0, 11}) == outside);
  CHECK_BOTH(classify(f, P{0, 0, -5}) == outside);
  CHECK_BOTH(classify(f, irg::box<R, 3>{{-1, -1, 4}, {1, 1, 5}}) == inside);
  CHECK_BOTH(classify(f, irg::box<R, 3>{{9, -1, 4}, {11, 1, 5}}) == crossing);
  CHECK_BOTH(classify(f, irg::box<R, 3>{{20, 0, 2}, {21, 1, 3}}) == outside);
}

TEST_CASE("view_pyramid: its projection takes the corners to those of clip space, and agrees with the other forms") {
  test::random r(3);
  for (int i = 0; i < 1000; ++i) {
    const view_pyramid<double> p{0.1 + r.unit(), 0.1 + 3 * r.unit(), 0.1 + 2 * r.unit(), 0.01 + r.unit(),
                                 1.5 + 100 * r.unit()};
    const auto depth = r.integer(0, 1) ? depth_range::reversed : depth_range::standard;
    const auto m = perspective(p, depth);
    const auto corners = pyramid_corners(p);
    for (int k = 0; k < 8; ++k) {
      const auto q = to_cartesian(m * corners.at[k]);
      CHECK(std::abs(q.x - (k & 1 ? 1 : -1)) <= 1e-15);
      CHECK(std::abs(q.y - (k & 2 ? 1 : -1)) <= 1e-15);
      CHECK(std::abs(q.z - (((k & 4) != 0) == (depth == depth_range::standard) ? 1 : 0)) <= 1e-14);
    }
    const auto by_angle =
        perspective(irg::vertical_angle_of(p), p.width / p.height, p.near_distance, p.far_distance, depth);
    for (int row = 0; row < 4; ++row)
      for (int c = 0; c < 4; ++c) CHECK(std::abs(m(row, c) - by_angle(row, c)) <= 4e-15 * std::abs(m(row, c)));
    CHECK(std::abs(irg::distance_for_angle(irg::vertical_angle_of(p), p.height) - p.distance) <= 1e-14 * p.distance);
    // The planes are those of the matrix.
    const auto by_points = with_unit_normals(pyramid_planes(p)), by_matrix = irg::frustum_of(m, depth);
    for (int k = 0; k < 6; ++k) {
      const auto &a = by_points.planes[k], &b = by_matrix.planes[k];
      const double size = 1e-13 * (1 + std::abs(b.d));
      CHECK((std::abs(a.a - b.a) <= size && std::abs(a.b - b.b) <= size && std::abs(a.c - b.c) <= size));
      CHECK(std::abs(a.d - b.d) <= 1e-12 * (1 + p.far_distance / p.near_distance));
    }
  }
}

TEST_CASE("view_pyramid: what is refused") {
  using enum projection_status;
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const auto status = [](view_pyramid<double> p) { return perspective_checked(p).status; };
  static_assert(perspective_checked(course_double).status == ok);
  static_assert(perspective_checked(view_pyramid<double>{2, 0, 6, 1, 10}).status == bad_window);
  CHECK(status({2, -8, 6, 1, 10}) == bad_window);
  CHECK(status({2, 8, nan, 1, 10}) == bad_window);
  CHECK(status({2, inf, 6, 1, 10}) == bad_window);
  CHECK(status({0, 8, 6, 1, 10}) == bad_distance);
  CHECK(status({-2, 8, 6, 1, 10}) == bad_distance);
  CHECK(status({nan, 8, 6, 1, 10}) == bad_distance);
  CHECK(status({inf, 8, 6, 1, 10}) == bad_distance);
  CHECK(status({2, 8, 6, 0, 10}) == bad_depth);
  CHECK(status({2, 8, 6, 10, 10}) == bad_depth);
  CHECK(status({2, 8, 6, 11, 10}) == bad_depth);
  CHECK(status({2, 8, 6, nan, 10}) == bad_depth);
  CHECK(status({2, 8, 6, 1, nan}) == bad_depth);
  CHECK(status({2, 8, 6, 1, inf}) == ok);
  CHECK(status({1e300, 1e-300, 6, 1, 10}) == not_representable);
  CHECK(status({2, 8, 6, 1e-3, 1e9}) == ok);
}

TEST_CASE("view_pyramid: the default is in its domain") {
  CHECK_BOTH(view_pyramid<double>{} == view_pyramid<double>{1, 2, 2, 1, 2});
  CHECK_BOTH(perspective_checked(view_pyramid<double>{}).status == projection_status::ok);
}
