// SPDX-License-Identifier: MIT
#include <irg/curve/surface_nets.hpp>

#include <array>
#include <cmath>
#include <vector>

#include <irg/curve/bspline_surface.hpp>
#include <irg/mesh/teapot.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;
using V3 = irg::vec<double, 3>;
using H2 = irg::hpoint<double, 2>;
using H3 = irg::hpoint<double, 3>;

// Half a unit circle from the south pole up to the north pole.
constexpr std::array<H2, 5> half{H2{0, -2, 2}, {1, -1, 1}, {1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
constexpr std::array<double, 8> half_knots{0, 0, 0, 1, 1, 2, 2, 2};
constexpr auto round_knots = irg::circle_knots<double>();

constexpr std::array<H3, 45> sphere_net() {
  std::array<H3, 45> net{};
  irg::revolution_net<double>(half, net);
  return net;
}
constexpr auto sphere_points = sphere_net();
constexpr irg::bspline_surface<H3, 2> sphere{
    irg::bspline_knots<double, 2>(round_knots), irg::bspline_knots<double, 2>(half_knots), {sphere_points, 5}};

constexpr double distance_from_sphere(double u, double v) {
  const auto p = *irg::nurbs_surface_point(sphere, u, v);
  return irg::length(p - P3{}) - 1;
}
constexpr V3 normal_at(double u, double v) {
  const auto n = irg::surface_normal(*irg::nurbs_surface_sample(sphere, u, v), irg::normalized_parameter(sphere.u, u),
                                     irg::normalized_parameter(sphere.v, v));
  return n ? *n : V3{};
}

}  // namespace

TEST_CASE("revolution: a sphere, exactly turned, with normals at its poles") {
  CHECK_BOTH(*irg::nurbs_surface_point(sphere, 0.5, 1) == P3{0.6, 0, -0.8});
  CHECK_BOTH(normal_at(0.3, 0) == V3{0, -1, 0});
  CHECK_BOTH(normal_at(3.7, 2) == V3{0, 1, 0});
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 20; ++j) {
      const double u = 0.1 * i, v = 0.1 * j;
      CHECK(std::abs(distance_from_sphere(u, v)) < 5e-16);
      CHECK(irg::length(normal_at(u, v) - (*irg::nurbs_surface_point(sphere, u, v) - P3{})) < 4e-15);
    }
  // Homogeneous coordinates of the control points are integers: the equation of the sphere holds for them exactly.
  for (const H3& p : sphere_points)
    for (int axis = 0; axis < 4; ++axis) CHECK(p[axis] == std::floor(p[axis]));
}

TEST_CASE("revolution: poles away from the origin, and rows whose points differ by rounding alone") {
  std::array<H2, 5> raised = half;
  for (H2& p : raised) p.y += 0.1 * p[2];
  std::array<H3, 45> net{};
  irg::revolution_net<double>(raised, net);
  const irg::bspline_surface<H3, 2> s{sphere.u, sphere.v, {net, 5}};
  for (const double u : {0.0, 0.3, 1.0, 2.9, 4.0})
    for (const double v : {0.0, 2.0}) {
      const auto sample = *irg::nurbs_surface_sample(s, u, v);
      CHECK(sample.du == V3{});
      const auto n = irg::surface_normal(sample, irg::normalized_parameter(s.u, u), irg::normalized_parameter(s.v, v));
      REQUIRE(n);
      CHECK(irg::length(*n - V3{0, v - 1, 0}) < 1e-15);
    }
}

TEST_CASE("ruled and translated surfaces") {
  constexpr std::array<P3, 3> low{P3{0, 0, 0}, {1, 2, 0}, {2, 0, 0}}, high{P3{0, 0, 3}, {1, -2, 3}, {2, 0, 3}};
  std::array<P3, 6> net{};
  irg::ruled_net<P3>(low, high, net);
  constexpr std::array<double, 6> u{0, 0, 0, 1, 1, 1};
  constexpr std::array<double, 4> v{0, 0, 1, 1};
  const irg::bspline_surface<P3, 2, 1> ruled{
      irg::bspline_knots<double, 2>(u), irg::bspline_knots<double, 1>(v), {net, 2}};
  CHECK(*irg::bspline_surface_point(ruled, 0.5, 0) == P3{1, 1, 0});
  CHECK(*irg::bspline_surface_point(ruled, 0.5, 0.5) == P3{1, 0, 1.5});
  CHECK(*irg::bspline_surface_point(ruled, 0.5, 1) == P3{1, -1, 3});
  constexpr std::array<V3, 2> path{V3{0, 0, 0}, V3{0, 5, 1}};
  irg::translation_net<P3, V3>(low, path, net);
  CHECK(*irg::bspline_surface_point(ruled, 0.5, 1) == P3{1, 6, 1});
  // A rational curve moved: each point's weight times the displacement.
  std::array<H3, 9> circle{};
  const auto flat = irg::circle_points(P2{0, 0}, 1);
  for (std::size_t i = 0; i < 9; ++i) circle[i] = {flat[i].x, flat[i].y, 0, flat[i][2]};
  std::array<H3, 18> tube{};
  irg::translation_net<H3, V3>(circle, std::array<V3, 2>{V3{1, 2, 0}, V3{1, 2, 7}}, tube);
  const irg::bspline_surface<H3, 2, 1> cylinder{sphere.u, irg::bspline_knots<double, 1>(v), {tube, 2}};
  for (int k = 0; k <= 40; ++k) {
    const P3 p = *irg::nurbs_surface_point(cylinder, 0.1 * k, 0.25);
    CHECK(std::abs(std::hypot(p.x - 1, p.y - 2) - 1) < 1e-15);
    CHECK(std::abs(p.z - 1.75) < 1e-15);
  }
}

TEST_CASE("sections in frames") {
  constexpr auto row = [] {
    constexpr irg::curve_frame<V3> frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    constexpr std::array<P2, 3> section{P2{0, 0}, {2, 1}, {-1, 3}};
    std::array<P3, 3> result{};
    irg::section_row<double>(frame, {5, 6, 7}, section, result);
    return result;
  }();
  CHECK_BOTH(row == std::array<P3, 3>{P3{5, 6, 7}, {5, 8, 8}, {5, 5, 10}});
}

TEST_CASE("the teapot's patches as B-spline surfaces") {
  constexpr std::array<double, 8> unit{0, 0, 0, 0, 1, 1, 1, 1};
  const irg::bspline_knots<double, 3> knots(unit);
  for (const auto& patch : irg::teapot_patches<double>()) {
    std::vector<P3> flat;
    for (const auto& row : patch.points) flat.insert(flat.end(), row.begin(), row.end());
    const irg::bspline_surface<P3, 3> s{knots, knots, {flat, 4}};
    for (int k = 0; k <= 8; ++k)
      for (int l = 0; l <= 8; ++l) {
        const double u = k / 8., v = l / 8.;
        const auto a = irg::patch_sample(patch, u, v);
        const auto b = *irg::bspline_surface_sample(s, u, v);
        CHECK(irg::length(a.point - b.point) < 4e-15);
        CHECK(irg::length(a.du - b.du) < 2e-14);
        CHECK(irg::length(a.dv - b.dv) < 2e-14);
        const auto n = irg::surface_normal(a, u, v), m = irg::surface_normal(b, u, v);
        REQUIRE(n.has_value() == m.has_value());
        if (n) CHECK(irg::length(*n - *m) < 1e-12);
      }
  }
}
