// SPDX-License-Identifier: MIT
// What curves are asked that hurts: coincident and collinear control points, knots of full multiplicity, weights of 0,
// degrees 0 to 50, places next to the ends, no tolerance, translations, halves. Every evaluator is asked alike.
#include <irg/curve/bezier_accurate.hpp>
#include <irg/curve/bezier_prepared.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/curve/flatten.hpp>
#include <irg/curve/surface_tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 2>;
using points = std::vector<P>;
constexpr double u = 0x1p-53, none = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();

// Bezier curves by all ways of evaluating one, B-splines of one stretch among them.
const std::vector<std::pair<std::string, std::function<P(const points&, double)>>>& evaluators() {
  static const std::vector<std::pair<std::string, std::function<P(const points&, double)>>> all{
      {"de Casteljau",
       [](const points& c, double t) {
         points room(c.size());
         return irg::bezier_point(c, t, std::span<P>(room));
       }},
      {"Wozny and Chudy", [](const points& c, double t) { return irg::bezier_point_wozny_chudy(c, t); }},
      {"accurate",
       [](const points& c, double t) {
         std::vector<irg::exact_sum<double>> room(c.size());
         return irg::bezier_point_accurate(c, t, std::span<irg::exact_sum<double>>(room));
       }},
      {"prepared",
       [](const points& c, double t) {
         std::vector<double> space(irg::prepared_bezier<P>::numbers_for(c.size()));
         std::vector<irg::exact_sum<double>> room(c.size());
         return irg::bezier_point(*irg::prepare_bezier(c, std::span<double>(space), room), t);
       }},
      {"B-spline",
       [](const points& c, double t) {
         std::vector<double> knots(c.size(), 0), room(c.size());
         knots.resize(2 * c.size(), 1);
         const auto list = *irg::make_bspline_knots(std::span<const double>(knots), static_cast<int>(c.size()) - 1);
         return *irg::bspline_point(list, c, t, room);
       }},
      {"de Boor", [](const points& c, double t) {
         std::vector<double> knots(c.size(), 0);
         knots.resize(2 * c.size(), 1);
         points room(c.size());
         const auto list = *irg::make_bspline_knots(std::span<const double>(knots), static_cast<int>(c.size()) - 1);
         return *irg::bspline_point_de_boor(list, c, t, std::span<P>(room));
       }}};
  return all;
}

const std::vector<double> places{
    0,           std::nextafter(0., 1.), 1e-300, 0x1p-53, 0.1, 0.25, std::nextafter(0.5, 0.), 0.5, 0.7,
    1 - 0x1p-30, std::nextafter(1., 0.), 1};

points random_points(test::random& r, std::size_t count) {
  points c(count);
  for (P& p : c) {
    p.x = 2 * r.unit() - 1;
    p.y = 2 * r.unit() - 1;
  }
  return c;
}

}  // namespace

TEST_CASE("hostile curves: degrees 0 to 50 at places next to the ends: ends exact, within the box of the points") {
  test::random r(111);
  for (const std::size_t degree : {0u, 1u, 2u, 3u, 10u, 20u, 50u}) {
    const points c = random_points(r, degree + 1);
    for (const auto& [name, at] : evaluators()) {
      INFO(name, ", degree ", degree);
      CHECK(at(c, 0) == c.front());
      CHECK(at(c, 1) == c.back());
      for (int axis = 0; axis < 2; ++axis) {
        double low = 1, high = -1;
        for (const P& p : c) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
        bool inside = true;
        for (const double t : places) {
          const double x = at(c, t)[axis];
          inside = inside && x >= low - 4 * u && x <= high + 4 * u;
        }
        CHECK(inside);
      }
      CHECK(irg::length(at(c, std::nextafter(0., 1.)) - c.front()) <= 4 * u);
      CHECK(irg::length(at(c, std::nextafter(1., 0.)) - c.back()) <= 120 * u);
    }
  }
}

TEST_CASE("hostile curves: fast points within 6 u of twice the precision's up to degree 20") {
  test::random r(112);
  double worst = 0;
  for (std::size_t degree = 1; degree <= 20; ++degree)
    for (int trial = 0; trial < 5; ++trial) {
      const points c = random_points(r, degree + 1);
      for (int k = 0; k < 60; ++k) {
        const double t = r.unit();
        const P p = evaluators()[3].second(c, t), want = evaluators()[2].second(c, t);
        worst = std::max({worst, std::abs(p.x - want.x) / u, std::abs(p.y - want.y) / u});
      }
    }
  CHECK(worst <= 6);
}

TEST_CASE("hostile curves: coincident points, points on a line") {
  for (const std::size_t degree : {1u, 3u, 20u})
    for (const auto& [name, at] : evaluators()) {
      INFO(name, ", degree ", degree);
      const points same(degree + 1, P{0.1, -1e6});
      points line;
      for (std::size_t i = 0; i <= degree; ++i) line.push_back({static_cast<double>(i), 3 * static_cast<double>(i)});
      for (const double t : places) {
        const P p = at(same, t), q = at(line, t);
        CHECK(std::abs(p.x - 0.1) <= 8 * u * 0.1);
        CHECK(std::abs(p.y + 1e6) <= 8 * u * 1e6);
        CHECK(std::abs(q.y - 3 * q.x) <= 64 * u * 60);
      }
    }
}

TEST_CASE("hostile curves: translated by a lattice of powers of two, exactly; halves join bit for bit") {
  test::random r(113);
  for (int trial = 0; trial < 100; ++trial) {
    points c(static_cast<std::size_t>(r.integer(1, 8)));
    for (P& p : c) {
      p.x = static_cast<double>(r.integer(-64, 64));
      p.y = static_cast<double>(r.integer(-64, 64));
    }
    const irg::vec<double, 2> way{0x1p20 * static_cast<double>(r.integer(-4, 4)), 0x1p12};
    points moved = c;
    for (P& p : moved) p = p + way;
    for (const std::size_t which : {0u, 2u, 5u})
      for (const double t : {0.0, 0.125, 0.5, 0.75, 1.0})
        CHECK(evaluators()[which].second(moved, t) == evaluators()[which].second(c, t) + way);
    points left(c.size()), right(c.size());
    const double t = r.unit();
    irg::bezier_split(c, t, std::span<P>(left), std::span<P>(right));
    CHECK(left.back() == right.front());
    CHECK(left.front() == c.front());
    CHECK(right.back() == c.back());
    CHECK(left.back() == evaluators()[0].second(c, t));
  }
}

TEST_CASE("hostile curves: knots of full multiplicity, empty stretches, the last knot, weights") {
  const std::vector<double> list{0, 0, 0, 1, 1, 1, 2, 2, 2};  // two pieces, torn at 1
  const points c{{0, 0}, {1, 1}, {2, 0}, {5, 5}, {6, 6}, {7, 5}};
  const irg::bspline_knots<double, 2> knots(list);
  CHECK(*irg::bspline_point(knots, c, 2) == c.back());
  CHECK(*irg::bspline_point(knots, c, 1) == c[3]);
  CHECK(irg::length(*irg::bspline_point(knots, c, std::nextafter(1., 0.)) - c[2]) < 1e-14);
  CHECK(!irg::bspline_point(knots, c, std::nextafter(2., 3.)));
  CHECK(!irg::bspline_point(knots, c, -0x1p-1074));
  std::vector<double> weights{1, 1, 0, 1, 1, 1};
  CHECK(irg::length(*irg::nurbs_point(knots, c, weights, 0.5) - P{2. / 3, 2. / 3}) < 1e-15);  // two points count
  for (const double w : {-1.0, none, inf}) {
    weights[2] = w;
    CHECK(!irg::nurbs_point(knots, c, weights, 0.5));
  }
  weights.assign(6, 0);
  CHECK(!irg::nurbs_point(knots, c, weights, 0.5));
  for (const std::vector<double>& bad : {std::vector<double>{0, 0, 0, 2, 1, 3, 3, 3},
                                         {0, 0, 0, 0, 1, 1, 1, 1},
                                         {0, 0, none, 1, 1, 1},
                                         {0, 0, 0, 1, 1, inf},
                                         {0, 1},
                                         {},
                                         {1, 1, 1, 1, 1, 1}})
    CHECK(!irg::make_bspline_knots(std::span<const double>(bad), 2));
}

TEST_CASE("hostile curves: cusps, loops, folds, no tolerance: all end") {
  const std::vector<points> hard{{{0, 0}, {1, 1}, {0, 1}, {1, 0}},  // a cusp
                                 {{0, 0}, {3, 2}, {-2, 2}, {1, 0}},  // a loop
                                 {{0, 0}, {1, 1}, {2, -1}, {3, 0}},  // an inflection
                                 {{0, 0}, {2, 0}, {-1, 0}, {1, 0}},  // a fold
                                 {{0, 0}, {0, 0}, {0, 0}, {1e300, 1e-300}}};
  for (const points& c : hard)
    for (const double tolerance : {0.0, 1e-300, -1.0, none, 1e-3}) {
      points room(3 * c.size());
      std::size_t count = 0;
      const auto done = irg::flatten(c, tolerance, std::span<P>(room), [&](const P& p) {
        ++count;
        if (p.x != p.x) count = 1000000;
      });
      CHECK(done.pieces <= 65536);
      CHECK(count == done.pieces + 1);
      if (tolerance == 1e-3 && c.back().x < 1e300) CHECK(done.within_tolerance);
    }
}
