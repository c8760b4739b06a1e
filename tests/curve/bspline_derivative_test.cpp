// SPDX-License-Identifier: MIT
#include <irg/curve/bspline_derivative.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/curve/rational.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/spline_oracle.hpp"

namespace {

using P = irg::point<double, 2>;
using V = irg::vec<double, 2>;
using H = irg::hpoint<double, 2>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<double, 8> clamped{0, 0, 0, 1, 2, 3, 3, 3};
constexpr std::array<P, 5> hill{P{0, 0}, P{1, 2}, P{3, 2}, P{4, 0}, P{6, 1}};
constexpr auto fixed = irg::bspline_knots<double, 2>(clamped);
constexpr auto at_hand = *irg::make_bspline_knots(std::span<const double>(clamped), 2);

constexpr P by_blends(double t) {
  std::array<P, 3> scratch{};
  return *irg::bspline_point_de_boor(at_hand, hill, t, scratch);
}
constexpr P by_basis(double t) {
  std::array<double, 3> scratch{};
  return *irg::bspline_point(at_hand, hill, t, scratch);
}
constexpr std::array<V, 4> derivatives(double t) {
  std::array<V, 4> all{};
  std::array<V, 6> scratch{};
  return irg::bspline_derivatives(fixed, hill, t, all, scratch) ? all : std::array<V, 4>{V{-1, -1}};
}

}  // namespace

TEST_CASE("B-splines of a degree known when running: reference values, as of one known when compiling") {
  CHECK_BOTH(by_basis(0) == P{0, 0});
  CHECK_BOTH(by_basis(0.5) == P{1, 1.5});
  CHECK_BOTH(by_basis(1.5) == P{2.875, 1.75});
  CHECK_BOTH(by_basis(3) == P{6, 1});
  CHECK_BOTH(by_blends(0) == P{0, 0});
  CHECK_BOTH(by_blends(0.5) == P{1, 1.5});
  CHECK_BOTH(by_blends(1) == P{2, 2});
  CHECK_BOTH(by_blends(1.5) == P{2.875, 1.75});
  CHECK_BOTH(by_blends(2.5) == P{4.375, 0.5});
  CHECK_BOTH(by_blends(3) == P{6, 1});
  test::random r(31);
  for (int i = 0; i < 1000; ++i) {
    const double t = 3 * r.unit();
    CHECK(by_basis(t) == *irg::bspline_point(fixed, hill, t));
  }
  std::array<double, 3> scratch{7, 7, 7};
  CHECK(!irg::bspline_basis(at_hand, none, scratch));
  CHECK(!irg::bspline_point(at_hand, hill, 3.0000000000000004, scratch));
  CHECK(scratch == std::array<double, 3>{7, 7, 7});
}

TEST_CASE("nurbs_point and derivatives: the values published in NURBS-Python's tests") {
  const auto within = [](const P& p, double x, double y, double error) {
    return std::abs(p.x - x) < error && std::abs(p.y - y) < error;
  };
  const std::vector<double> u{0, 0, 0, 0, .33, .66, 1, 1, 1, 1}, weights{0.5, 1, 0.75, 1, 0.25, 1};
  const std::vector<P> points{{5, 5}, {10, 10}, {20, 15}, {35, 15}, {45, 10}, {50, 5}};
  const auto knots = *irg::make_bspline_knots(std::span<const double>(u), 3);
  std::array<double, 4> scratch{};
  const auto plain = [&](double t) { return *irg::bspline_point(knots, points, t, scratch); };
  CHECK(within(plain(0.3), 18.617, 13.377, 1e-3));  // three digits are published
  CHECK(within(plain(0.5), 27.645, 14.691, 1e-3));
  CHECK(within(plain(0.6), 32.143, 14.328, 1e-3));
  CHECK(plain(1) == P{50, 5});
  std::vector<H> weighted;
  for (std::size_t i = 0; i < points.size(); ++i) weighted.push_back(irg::to_homogeneous(points[i], weights[i]));
  const auto derivatives_at = [&](double t) {
    std::array<H, 4> homogeneous{};
    std::array<H, 8> work{};
    std::array<V, 4> all{};
    CHECK(irg::bspline_derivatives(knots, weighted, t, homogeneous, work));
    CHECK(irg::rational_derivatives<double, 2>(homogeneous, all));
    const P p = *irg::nurbs_point(knots, points, weights, t, scratch);
    CHECK(within(p, all[0].x, all[0].y, 1e-14 * 50));
    return all;
  };
  const auto is_near = [&](const V& v, double x, double y) { return within(P{v.x, v.y}, x, y, 1e-4); };
  CHECK(is_near(derivatives_at(0)[1], 90.9090, 90.9090));
  CHECK(is_near(derivatives_at(0.2)[0], 13.8181, 11.5103));
  CHECK(is_near(derivatives_at(0.2)[1], 40.0602, 17.3878));
  CHECK(is_near(derivatives_at(0.2)[2], 104.4062, -29.3672));
  CHECK(is_near(derivatives_at(0.5)[0], 28.1775, 14.7858));
  CHECK(is_near(derivatives_at(0.5)[1], 39.7272, 2.2562));
  CHECK(is_near(derivatives_at(0.5)[2], -116.9254, -49.7367));
  CHECK(is_near(derivatives_at(0.5)[3], 125.5276, 196.8865));
  CHECK(is_near(derivatives_at(0.95)[1], 39.5178, -29.9962));
  // A unit circle of three arcs, published to the last digit.
  const double third = 1. / 3, a = 3 / std::sqrt(3.), h = 1.5;
  const std::vector<double> arcs{0, 0, 0, third, third, 2 * third, 2 * third, 1, 1, 1};
  const std::vector<P> triangle{{0, -1}, {-a, -1}, {-a / 2, h - 1}, {0, 2 * h - 1}, {a / 2, h - 1}, {a, -1}, {0, -1}};
  const std::vector<double> halves{1, 0.5, 1, 0.5, 1, 0.5, 1};
  const auto round_knots = *irg::make_bspline_knots(std::span<const double>(arcs), 2);
  const auto on_triangle = [&](double t) { return *irg::nurbs_point(round_knots, triangle, halves, t, scratch); };
  CHECK(on_triangle(0) == P{0, -1});
  CHECK(within(on_triangle(0.2), -0.9571859726038534, -0.2894736842105261, 1e-14));
  CHECK(within(on_triangle(0.5), 1.1102230246251568e-16, 1, 1e-14));
  CHECK(within(on_triangle(0.95), 0.27544074447012257, -0.9613180515759312, 1e-14));
  const std::vector<double> zero(7, 0);
  CHECK(!irg::nurbs_point(round_knots, triangle, zero, 0.3, scratch));
}

TEST_CASE("check_knots with a degree at hand") {
  const auto verdict = [](const std::vector<double>& u, int degree) {
    return irg::check_knots(std::span<const double>(u), degree);
  };
  using enum irg::knots_status;
  CHECK(verdict({0, 0, 1, 1}, 1) == ok);
  CHECK(verdict({0, 0, 1, 1}, -1) == negative_degree);
  CHECK(verdict({0, 0, 1, 1}, (std::numeric_limits<int>::min)()) == negative_degree);
  CHECK(verdict({0, 0, 1, 1}, 2) == too_few);
  CHECK(verdict({0, 0, 1, 1}, (std::numeric_limits<int>::max)()) == too_few);
  CHECK(verdict({}, 0) == too_few);
  CHECK(verdict({1, 0}, 0) == decreasing);
  CHECK(verdict({0, 0, 0, 0}, 1) == too_many_equal);
  CHECK(verdict({0, 0}, 0) == too_many_equal);
  CHECK(!irg::make_bspline_knots(std::span<const double>(std::array<double, 2>{0, 0}), 0));
}

TEST_CASE("bspline_derivatives: reference values, ends, beyond the degree, outside") {
  CHECK_BOTH(derivatives(0) == std::array<V, 4>{V{0, 0}, V{2, 4}, V{0, -4}, V{0, 0}});
  CHECK_BOTH(derivatives(1.5)[1] == V{1.5, -1});  // the mean of (2, 0) and (1, -2)
  CHECK_BOTH(derivatives(1)[2] == V{-1, -2});
  CHECK_BOTH(derivatives(3)[1] == V{4, 2});
  CHECK_BOTH(derivatives(3.5)[0] == V{-1, -1});
  CHECK(derivatives(none)[0] == V{-1, -1});
  // A knot of full multiplicity inside: two curves, each with its own derivatives.
  const std::array<double, 6> torn{0, 0, 1, 1, 2, 2};
  const std::array<P, 4> points{P{0, 0}, P{1, 0}, P{5, 5}, P{5, 8}};
  std::array<V, 2> all{};
  std::array<V, 4> scratch{};
  CHECK(irg::bspline_derivatives(irg::bspline_knots<double, 1>(torn), points, 1, all, scratch));
  CHECK(all == std::array<V, 2>{V{5, 5}, V{0, 3}});
  const std::array<double, 2> step{3, 4};
  CHECK(irg::bspline_derivatives(irg::bspline_knots<double, 0>(step), std::array<P, 1>{P{2, 3}}, 3.5, all, scratch));
  CHECK(all == std::array<V, 2>{V{2, 3}, V{0, 0}});
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("de Boor's algorithm and derivatives against the polynomials of each stretch in rationals") {
  test::random r(77);
  double worst_point = 0, worst_blend = 0;
  std::array<double, 4> worst{};
  int places = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 20'000 : 300); ++round) {
    const auto degree = static_cast<std::size_t>(r.integer(0, 7));
    std::vector<double> u{r.unit()};
    while (u.size() < 2 * degree + 8) {
      const bool same = r.integer(0, 2) == 0;
      u.push_back(u.back() + (same ? 0 : 0.01 + r.unit()));
    }
    const auto knots = irg::make_bspline_knots(std::span<const double>(u), static_cast<int>(degree));
    if (!knots) continue;
    std::vector<P> points(knots->size());
    for (P& p : points) {
      const double x = 2 * r.unit() - 1, y = 2 * r.unit() - 1;
      p = {x, y};
    }
    double t = u[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(u.size()) - 1))];
    if (r.integer(0, 1) == 0) t = knots->first() + (knots->last() - knots->first()) * r.unit();
    t = std::clamp(t, knots->first(), knots->last());
    std::vector<double> value(degree + 1);
    std::vector<P> local(degree + 1);
    std::vector<V> scratch(2 * degree + 2);
    std::array<V, 4> all{};
    REQUIRE(irg::bspline_derivatives(*knots, points, t, all, scratch));
    const P by_value = *irg::bspline_point(*knots, points, t, value);
    const P by_blend = *irg::bspline_point_de_boor(*knots, points, t, local);
    CHECK(by_blend == P{all[0].x, all[0].y});
    ++places;
    double scale = 1;
    for (int k = 0; k < 4; ++k) {
      const auto want =
          test::spline_value(u, degree, t, k, [&](std::size_t i) { return test::big_rational(points[i].y); });
      if (k == 0) {
        worst_point = std::fmax(worst_point, test::distance(by_value.y, want));
        worst_blend = std::fmax(worst_blend, test::distance(by_blend.y, want));
      }
      worst[static_cast<std::size_t>(k)] = std::fmax(worst[static_cast<std::size_t>(k)],
                                                     test::distance(all[static_cast<std::size_t>(k)].y, want) / scale);
      scale *= 2 * static_cast<double>(degree) / 0.01;
    }
  }
  MESSAGE("at ", places, " places: point ", worst_point * 0x1p53, " u, blends ", worst_blend * 0x1p53,
          " u, derivatives 1 to 3 ", worst[1] * 0x1p53, ", ", worst[2] * 0x1p53, ", ", worst[3] * 0x1p53,
          " u of the largest they can be");
  CHECK(places > 100);
  CHECK(worst_point <= 8 * 0x1p-53);
  CHECK(worst_blend <= 3 * 7 * 0x1p-53);
  for (const double w : worst) CHECK(w <= 4 * 0x1p-53);
}
#endif
