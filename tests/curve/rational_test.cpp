// SPDX-License-Identifier: MIT
#include <irg/curve/rational.hpp>

#include <array>
#include <cmath>

#include <irg/curve/bezier.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"

namespace {

using P = irg::point<double, 2>;
using V = irg::vec<double, 2>;
using H = irg::hpoint<double, 2>;

constexpr auto circle_knots = irg::circle_knots<double>();
constexpr auto circle = irg::circle_points(P{3, -2}, 4);
constexpr std::array<V, 3> on_circle(double t) {
  std::array<H, 3> homogeneous{};
  std::array<H, 6> scratch{};
  std::array<V, 3> all{};
  const irg::bspline_knots<double, 2> knots(circle_knots);
  irg::bspline_derivatives(knots, circle, t, homogeneous, scratch);
  irg::rational_derivatives<double, 2>(homogeneous, all);
  return all;
}

}  // namespace

TEST_CASE("circle_points and rational_derivatives: a circle exactly, its speed and its curvature") {
  CHECK_BOTH(on_circle(0)[0] == V{7, -2});
  CHECK_BOTH(on_circle(0.5)[0] == V{5.4, 1.2});
  CHECK_BOTH(on_circle(0)[1] == V{0, 8});
  CHECK_BOTH(on_circle(1)[0] == V{3, 2});
  CHECK_BOTH(on_circle(4)[0] == V{7, -2});
  for (int k = 0; k <= 4000; ++k) {
    const auto d = on_circle(k / 1000.0);
    const double x = (d[0].x - 3) / 4, y = (d[0].y + 2) / 4, speed = std::hypot(d[1].x, d[1].y);
    CHECK(std::abs(x * x + y * y - 1) < 2e-15);
    CHECK(std::abs(x * d[1].x + y * d[1].y) < 1e-14 * speed);
    CHECK(std::abs((d[1].x * d[2].y - d[1].y * d[2].x) / (speed * speed * speed) - 0.25) < 1e-14);
  }
  std::array<V, 2> all{};
  const std::array<H, 2> at_infinity{H{1, 1, 0}, H{0, 0, 1}};
  CHECK(!irg::rational_derivatives<double, 2>(at_infinity, all));
}

TEST_CASE("conic_arc: ellipse, parabola, hyperbola, the line of weight 0") {
  using enum irg::conic_kind;
  CHECK_BOTH(irg::conic_kind_of(0.5) == ellipse);
  CHECK_BOTH(irg::conic_kind_of(-1.0) == parabola);
  CHECK_BOTH(irg::conic_kind_of(2) == hyperbola);
  CHECK_BOTH(irg::conic_kind_of(0.0) == line);
  // From (1, 0) to (0, 1) with corner (1, 1) and weight w the implicit form is 4 w^2 a c = b^2 in barycentric a, b, c.
  for (const double w : {0.25, 0.5, 1.0, 2.0, 8.0}) {
    const auto arc = irg::conic_arc(P{1, 0}, P{1, 1}, P{0, 1}, w);
    for (int k = 0; k <= 64; ++k) {
      const auto p = *irg::try_to_cartesian(irg::bezier_point(arc, k / 64.0));
      const double b = p.x + p.y - 1, a = 1 - p.y, c = 1 - p.x;
      CHECK(std::abs(4 * w * w * a * c - b * b) < 1e-14 * (1 + w * w));
    }
  }
  const auto exact = irg::conic_arc(irg::point<int, 2>{1, 0}, {1, 1}, {0, 1}, 3);
  CHECK(exact[1] == irg::hpoint<int, 2>{3, 3, 3});
}
