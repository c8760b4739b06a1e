// SPDX-License-Identifier: MIT
#include <irg/view/oblique.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::depth_range;
using irg::oblique;
using irg::oblique_checked;
using irg::oblique_depth;
using irg::oblique_shear_checked;
using irg::point;
using irg::projection_status;
using irg::view_window;

namespace {

using P = point<double, 3>;
constexpr double inf = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr view_window<double> window{-4, 4, -3, 3};

}  // namespace

TEST_CASE("oblique: by hand, in every life") {
  // Depth straight to the right at full length: (x, y, z) -> (x - z, y).
  constexpr auto m = oblique({0.0, irg::cavalier_factor<double>}, window, 1, 5);
  CHECK_BOTH((m * P{0, 0, -2}) == irg::hpoint<double, 3>{0.5, 0, 0.75, 1});
  CHECK_BOTH((m * P{-2, 3, -2}) == irg::hpoint<double, 3>{0, 1, 0.75, 1});
  CHECK_BOTH((m * P{-2, 3, -1}).z == 1);
  // The plane z = -3 stays, half the length for depth.
  constexpr auto n = oblique({0.0, irg::cabinet_factor<double>, -3}, window, 1, 5, depth_range::standard);
  CHECK_BOTH((n * P{1, 1.5, -3}) == irg::hpoint<double, 3>{0.25, 0.5, 0.5, 1});
  CHECK_BOTH((n * P{1, 1.5, -5}) == irg::hpoint<double, 3>{0.5, 0.5, 1, 1});
  CHECK_BOTH((n * P{1, 1.5, -1}) == irg::hpoint<double, 3>{0, 0.5, 0, 1});
  // Factor 0 is orthographic.
  CHECK_BOTH(oblique({1.0, 0.0}, window, 1, 5) == irg::orthographic(irg::view_window<double>{-4, 4, -3, 3}, 1, 5));
  constexpr auto any = oblique(oblique_depth<float>{0.7f, 0.3f, -2.0f}, {-1.1f, 2.3f, -0.7f, 0.9f}, 0.1f, 10.0f);
  volatile float angle = 0.7f;
  CHECK(oblique(oblique_depth<float>{angle, 0.3f, -2.0f}, {-1.1f, 2.3f, -0.7f, 0.9f}, 0.1f, 10.0f) == any);
}

TEST_CASE("oblique: cavalier keeps lengths along z, cabinet halves them, whatever the angle; x and y keep theirs") {
  for (const double factor : {irg::cavalier_factor<double>, irg::cabinet_factor<double>, 0.8, -1.5, 3.0})
    for (int degrees = -180; degrees <= 360; degrees += 15) {
      const double a = irg::radians(static_cast<double>(degrees));
      const auto m = irg::oblique_shear(oblique_depth<double>{a, factor, -7});
      CHECK(m == oblique_shear_checked(oblique_depth<double>{a, factor, -7}).value);
      const auto at = [&](P p) { return transform_point(m, p); };
      const P o = at({0, 0, -7}), x = at({1, 0, -7}), y = at({0, 1, -7}), back = at({0, 0, -8});
      CHECK(std::hypot(o.x, o.y) <= 4e-15 * std::abs(factor));
      CHECK((std::abs(x.x - o.x - 1) <= 2e-15 && std::abs(x.y - o.y) <= 2e-15));
      CHECK((std::abs(y.x - o.x) <= 2e-15 && std::abs(y.y - o.y - 1) <= 2e-15));
      CHECK(std::abs(std::hypot(back.x - o.x, back.y - o.y) - std::abs(factor)) <= 8e-15);
      CHECK(std::abs((back.x - o.x) - factor * std::cos(a)) <= 8e-15);
      CHECK(std::abs((back.y - o.y) - factor * std::sin(a)) <= 8e-15);
      CHECK(back.z == -8);
    }
}

TEST_CASE("oblique: all points of a ray towards the viewer have one picture, the nearer the greater their depth") {
  test::random r(4);
  for (int i = 0; i < 2000; ++i) {
    const oblique_depth<double> how{10 * (r.unit() - 0.5), 3 * (r.unit() - 0.5), -5 * r.unit()};
    const double plane_z = how.plane_z;
    const auto m = oblique(how, window, -20, 20);
    const auto to_viewer = direction_to_viewer(how);
    CHECK(std::abs(length(to_viewer) - 1) <= 1e-15);
    const P p{8 * (r.unit() - 0.5), 6 * (r.unit() - 0.5), 8 * (r.unit() - 0.5)};
    const auto q = m * p, nearer = m * (p + to_viewer * 0.5);
    CHECK((std::abs(q.x - nearer.x) <= 1e-14 && std::abs(q.y - nearer.y) <= 1e-14));
    CHECK((q.z < nearer.z && q.w == 1 && nearer.w == 1));
    // The formula of textbooks, in long double.
    const auto wide = [](double v) { return static_cast<long double>(v); };
    const long double depth = wide(how.factor) * (wide(p.z) - wide(plane_z));
    const long double x = (wide(p.x) - depth * std::cos(wide(how.angle))) / 4;
    const long double y = (wide(p.y) - depth * std::sin(wide(how.angle))) / 3;
    CHECK((std::abs(static_cast<double>(x) - q.x) <= 2e-15 && std::abs(static_cast<double>(y) - q.y) <= 2e-15));
  }
}

TEST_CASE("oblique: what is refused") {
  using enum projection_status;
  const auto status = [](oblique_depth<double> how, view_window<double> w, double n, double f, double z) {
    how.plane_z = z;
    const auto p = oblique_checked(how, w, n, f);
    CHECK((p.status == ok || p.value == irg::identity_matrix<double, 4>()));
    return p.status;
  };
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(status({bad, 1}, window, 1, 5, 0) == bad_angle);
    CHECK(status({0, bad}, window, 1, 5, 0) == bad_factor);
    CHECK(status({0, 1}, window, 1, 5, bad) == bad_depth);
    CHECK(status({0, 1}, window, bad, 5, 0) == bad_depth);
    CHECK(status({0, 1}, window, 1, bad, 0) == bad_depth);
    CHECK(status({0, 1}, {bad, 4, -3, 3}, 1, 5, 0) == bad_window);
    CHECK(direction_to_viewer(oblique_depth<double>{bad, 1}) == irg::vec<double, 3>{0, 0, 1});
  }
  CHECK(status({0, 1}, window, 5, 5, 0) == bad_depth);
  CHECK(status({0, 1}, window, 6, 5, 0) == bad_depth);
  CHECK(status({0, 1}, {4, 4, -3, 3}, 1, 5, 0) == bad_window);
  CHECK(status({0, 1}, {-4, 4, 3, 3}, 1, 5, 0) == bad_window);
  CHECK(status({0, 1e200}, window, 1, 5, 1e200) == not_representable);
  CHECK(status({0, 1e200}, {-1e-200, 1e-200, -3, 3}, 1, 5, 0) == not_representable);
  CHECK(status({0, 1e200}, window, 1, 5, 0) == ok);
  static_assert(oblique_checked(oblique_depth<double>{not_a_number, 1.0}, window, 1, 5).status == bad_angle);
  static_assert(oblique_checked(oblique_depth<double>{0.0, 1e200, 1e200}, window, 1, 5).status == not_representable);
}

TEST_CASE("oblique: a subnormal shear has lost what the window's scale makes visible") {
  constexpr double least = std::numeric_limits<double>::denorm_min(), angle = 45 * irg::pi<double> / 180;
  const auto scaled = [](double factor) {
    return irg::oblique_checked(irg::oblique_depth<double>{angle, factor, 0}, {-0x1p-1000, 0x1p-1000, -1, 1}, 1, 9);
  };
  CHECK(scaled(least).value(0, 2) == -0x1p1000 * least);  // not times the cosine
  CHECK(scaled(0x1p-1000).value(0, 2) == doctest::Approx(-0.7071067811865476).epsilon(1e-15));
}
