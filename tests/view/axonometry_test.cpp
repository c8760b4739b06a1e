// SPDX-License-Identifier: MIT
#include <irg/view/axonometry.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::axonometric_direction;
using irg::axonometric_view;
using irg::axonometry_by_ratios;
using irg::axonometry_kind;
using irg::foreshortening;
using irg::with_axis_up;

namespace {

using V = irg::vec<double, 3>;

bool near(const V& a, const V& b, double bound) {
  return std::abs(a.x - b.x) <= bound && std::abs(a.y - b.y) <= bound && std::abs(a.z - b.z) <= bound;
}

double degrees_of(double x, double y) { return std::atan2(y, x) * 180 / irg::pi<double>; }

// The length of an axis' picture, measured in the picture.
double drawn(const irg::mat<double, 4, 4>& m, int axis) { return std::hypot(m(0, axis), m(1, axis)); }

}  // namespace

TEST_CASE("axonometry: isometric, axes at 30 degrees, all shortened by sqrt(2/3)") {
  constexpr auto iso = irg::isometric<double>();
  static_assert(iso.kind == axonometry_kind::isometric);
  CHECK(near(iso.to_viewer, V{1, 1, 1} * std::sqrt(1.0 / 3), 2e-16));
  CHECK(near(iso.to_viewer, axonometric_direction(irg::pi<double> / 4, std::atan(std::sqrt(0.5))), 3e-16));
  CHECK(near(foreshortening(iso.to_viewer), V{1, 1, 1} * std::sqrt(2.0 / 3), 3e-16));
  const auto m = axonometric_view(iso.to_viewer);
  CHECK(std::abs(degrees_of(m(0, 0), m(1, 0)) + 30) <= 1e-13);   // x: to the right, down
  CHECK(std::abs(degrees_of(m(0, 1), m(1, 1)) - 90) <= 1e-13);   // y: up
  CHECK(std::abs(degrees_of(m(0, 2), m(1, 2)) + 150) <= 1e-13);  // z: to the left, down
}

TEST_CASE("axonometry: dimetric and trimetric, the angles of the handbooks") {
  constexpr auto two = irg::dimetric<double>();
  static_assert(two.kind == axonometry_kind::dimetric);
  const auto m = axonometric_view(two.to_viewer);
  CHECK(std::abs(-degrees_of(m(0, 0), m(1, 0)) - 7.180756) <= 1e-6);
  CHECK(std::abs(degrees_of(m(0, 1), m(1, 1)) - 90) <= 1e-13);
  CHECK(std::abs(180 + degrees_of(m(0, 2), m(1, 2)) - 41.409622) <= 1e-6);
  CHECK(near(foreshortening(two.to_viewer), V{1, 1, 0.5} * (2 * std::sqrt(2.0) / 3), 3e-16));
  constexpr auto three = irg::trimetric<double>();
  static_assert(three.kind == axonometry_kind::trimetric);
  const auto t = axonometric_view(three.to_viewer);
  CHECK(std::abs(-degrees_of(t(0, 0), t(1, 0)) - 5.18) <= 0.005);
  CHECK(std::abs(180 + degrees_of(t(0, 2), t(1, 2)) - 17.815) <= 0.005);
  CHECK(near(foreshortening(three.to_viewer), V{0.9, 1, 0.5} * std::sqrt(2 / 2.06), 3e-16));
}

TEST_CASE(
    "axonometry: a direction from ratios draws the axes in these ratios; the squares of the factors add up to 2") {
  test::random r(5);
  int possible = 0;
  for (int i = 0; i < 5000; ++i) {
    const double x = r.unit(), y = r.unit(), z = r.unit();
    const auto a = axonometry_by_ratios(x, y, z);
    const double longest = std::max(x * x, std::max(y * y, z * z));
    const bool can_be = x * x + y * y + z * z - 2 * longest > 1e-12;
    if (std::abs(x * x + y * y + z * z - 2 * longest) > 1e-12) CHECK((a.kind != axonometry_kind::impossible) == can_be);
    if (a.kind == axonometry_kind::impossible) continue;
    ++possible;
    CHECK(std::abs(length(a.to_viewer) - 1) <= 1e-15);
    CHECK((a.to_viewer.x >= 0 && a.to_viewer.y >= 0 && a.to_viewer.z >= 0));
    const auto m = axonometric_view(a.to_viewer);
    const double scale = std::sqrt(2 / (x * x + y * y + z * z));
    // Rays at right angles to an axis leave its length to second order: there the root loses half of the digits.
    CHECK(std::abs(drawn(m, 0) - x * scale) <= 4e-15);
    CHECK(std::abs(drawn(m, 1) - y * scale) <= 4e-15);
    CHECK(std::abs(drawn(m, 2) - z * scale) <= 4e-15);
    const V f = foreshortening(a.to_viewer * (1 + 100 * r.unit()));
    CHECK(near(f, {x * scale, y * scale, z * scale}, 4e-15));
    CHECK(std::abs(f.x * f.x + f.y * f.y + f.z * f.z - 2) <= 4e-15);
    // A rotation that keeps y upright and looks along the direction.
    CHECK(std::abs(m(0, 1)) <= 2e-15);
    CHECK(m(1, 1) >= 0);
    CHECK(near({m(2, 0), m(2, 1), m(2, 2)}, a.to_viewer, 2e-15));
    CHECK(std::abs(determinant(submatrix(m, 3, 3)) - 1) <= 4e-15);
    CHECK((m(0, 3) == 0 && m(1, 3) == 0 && m(2, 3) == 0));
  }
  CHECK(possible > 1000);
}

TEST_CASE("axonometry: by angles, the axes' pictures in closed form") {
  test::random r(6);
  for (int i = 0; i < 2000; ++i) {
    const double turn = 6 * (r.unit() - 0.5), tilt = 3 * (r.unit() - 0.5);
    const auto m = axonometric_view(axonometric_direction(turn, tilt));
    const double c = std::cos(turn), s = std::sin(turn);
    CHECK((std::abs(m(0, 0) - c) <= 1e-13 && std::abs(m(1, 0) + s * std::sin(tilt)) <= 1e-13));
    CHECK((std::abs(m(0, 1)) <= 1e-13 && std::abs(m(1, 1) - std::cos(tilt)) <= 1e-13));
    CHECK((std::abs(m(0, 2) + s) <= 1e-13 && std::abs(m(1, 2) + c * std::sin(tilt)) <= 1e-13));
  }
}

TEST_CASE("axonometry: impossible and degenerate input, in every life") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  constexpr irg::axonometry<double> none{};
  CHECK_BOTH(axonometry_by_ratios(0.0, 0, 0) == none);
  CHECK_BOTH(axonometry_by_ratios(1.0, 1, 1.5) == none);
  CHECK_BOTH(axonometry_by_ratios(1.0, -1, 1) == none);
  CHECK_BOTH(axonometry_by_ratios(nan, 1, 1) == none);
  CHECK_BOTH(axonometry_by_ratios(1.0, nan, 1) == none);
  CHECK_BOTH(axonometry_by_ratios(1.0, 1, nan) == none);
  CHECK_BOTH(axonometry_by_ratios(1.0, inf, 1) == none);
  CHECK_BOTH(axonometry_by_ratios(1.0, 1, 0).to_viewer == V{0, 0, 1});  // seen from the front
  CHECK_BOTH(axonometry_by_ratios(1e300, 1e300, 1e300).kind == axonometry_kind::isometric);
  CHECK_BOTH(axonometry_by_ratios(1e300, 1e300, 1e300).to_viewer == irg::isometric<double>().to_viewer);
  // Right on the border and beside it: the axis across is seen in its full length, or hardly more than that.
  CHECK_BOTH(axonometry_by_ratios(3.0, 4, 5).to_viewer.z == 0);
  for (int m = 2; m < 60; ++m)
    for (int k = 1; k < m; ++k) {
      const double a = m * m - k * k, b = 2 * m * k, c = m * m + k * k;
      const auto seen = axonometry_by_ratios(a, b, c);
      CHECK((seen.kind != axonometry_kind::impossible && seen.to_viewer.z == 0));
      CHECK(axonometry_by_ratios(a, b, std::nextafter(c, inf)) == none);
      // (a a + b b - d d) / (a a + b b + d d) with d = c - e: e (2 c - e) / (2 c c - e (2 c - e)).
      const double e = 0x1p-30, part = e * (2 * c - e), z = std::sqrt(part / (2 * c * c - part));
      CHECK(std::abs(axonometry_by_ratios(a, b, c - e).to_viewer.z - z) <= 0x1p-51 * z);
    }
  CHECK_BOTH(axonometry_by_ratios(1e-320, 1e300, 1e300).to_viewer == V{1, 0, 0});
  CHECK_BOTH(foreshortening(V{0, 0, 0}) == V{0, 0, 0});
  CHECK_BOTH(foreshortening(V{nan, 0, 1}) == V{0, 0, 0});
  CHECK_BOTH(foreshortening(V{0, 0, 5}) == V{1, 1, 0});
  CHECK_BOTH(axonometric_view(V{0, 0, 0}) == irg::identity_matrix<double, 4>());
  CHECK_BOTH(irg::is_finite(axonometric_view(V{0, 1, 0})));
  CHECK_BOTH(irg::is_finite(axonometric_view(V{nan, 1, 0})));
  constexpr auto at_compile_time = irg::trimetric<float>();
  volatile float ratio = 0.9f;
  CHECK(axonometry_by_ratios<float>(ratio, 1, 0.5f) == at_compile_time);
}

TEST_CASE("with_axis_up: y up changes nothing; z up keeps x to the right; any other axis a rotation") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(with_axis_up(V{1, 2, 3}, {0, 5, 0}) == V{1, 2, 3});
  CHECK_BOTH(with_axis_up(V{1, 2, 3}, {0, 0, 2}) == V{1, -3, 2});
  CHECK_BOTH(with_axis_up(V{1, 2, 3}, {0, 0, 0}) == V{1, 2, 3});
  CHECK_BOTH(with_axis_up(V{1, 2, 3}, {0, nan, 0}) == V{1, 2, 3});
  test::random r(7);
  for (int i = 0; i < 1000; ++i) {
    const V up{r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5};
    const V x = with_axis_up(V{1, 0, 0}, up), y = with_axis_up(V{0, 1, 0}, up), z = with_axis_up(V{0, 0, 1}, up);
    CHECK(near(y, normalized(up), 1e-15));
    CHECK(near(cross(x, y), z, 1e-14));
    CHECK((std::abs(length(x) - 1) <= 1e-14 && std::abs(dot(x, y)) <= 1e-14));
    // Front has as much of the world's z as it can, or of -y where up is nearest to the z axis.
    CHECK((std::abs(up.z) >= std::max(std::abs(up.x), std::abs(up.y)) || z.z > 0));
    const bool z_up = std::abs(up.z) > std::max(std::abs(up.x), std::abs(up.y));
    const V front = z_up ? V{0, -1, 0} : V{0, 0, 1};
    CHECK(near(z, normalized(front - y * dot(front, y)), 1e-14));
  }
  // As near to another axis as to z: z is in front.
  for (const V& up : {V{1, 0, 1}, V{-1, 0.5, 1}, V{0.5, 1, -1}, V{0.5, -1, 1}, V{1, 1, 1}}) {
    const V y = normalized(up), front{0, 0, 1};
    CHECK(near(with_axis_up(V{0, 0, 1}, up), normalized(front - y * dot(front, y)), 1e-15));
  }
}

TEST_CASE("axonometry_by_ratios: axes that are hardly seen, whose squares no number is small enough for") {
  constexpr auto d = irg::axonometry_by_ratios(1.0, 1.0, 0x1p-1000).to_viewer;
  static_assert(d.x == 0x1p-1000 * 0.70710678118654752 && d.y == d.x && d.z == 1);
  constexpr auto f = irg::axonometry_by_ratios(4.0f, 0x1p115f, 0x1p115f).to_viewer;
  static_assert(f.x == 1 && f.y == 0x1p-113f * 0.70710678f && f.z == f.y);
  const auto beyond = irg::axonometry_by_ratios(0x1p1000, 0x1p1000, 0x1p-1000);
  CHECK(beyond.to_viewer == irg::vec<double, 3>{0, 0, 1});
  CHECK(beyond.kind == irg::axonometry_kind::dimetric);
  CHECK(irg::axonometry_by_ratios(3.0, 4.0, 5.0).to_viewer.z == 0);
}
