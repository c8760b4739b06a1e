// SPDX-License-Identifier: MIT
#include <irg/curve/constant_speed.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/curve/bezier.hpp>
#include <irg/curve/bspline_derivative.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 3>;
using V = irg::vec<double, 3>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A straight line run through faster and faster.
constexpr auto straight = [](double t) {
  return irg::bezier_sample(std::array<P, 3>{P{0, 0, 0}, {0, 0, 0}, {3, 0, 4}}, t);
};
constexpr double x_at(double share) {
  std::array<double, 5> lengths{};
  return irg::constant_speed(straight, 0., 1., std::span<double>(lengths)).at(share).point.x;
}

}  // namespace

TEST_CASE("constant_speed: a straight line, its ends, what is beyond") {
  CHECK_BOTH(x_at(0) == 0);
  CHECK_BOTH(x_at(1) == 3);
  CHECK_BOTH(x_at(-1) == 0);
  CHECK_BOTH(x_at(2) == 3);
  CHECK_BOTH(x_at(none) == 0);
  CHECK_BOTH(irg::length(V{x_at(0.5) - 1.5, 0, 0}) < 1e-14);
}

TEST_CASE("constant_speed: equal steps along B-splines, by chords of 10^4 pieces") {
  test::random r(91);
  for (int trial = 0; trial < 5; ++trial) {
    const std::vector<double> list{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    const irg::bspline_knots<double, 3> knots(list);
    std::vector<P> points;
    for (int k = 0; k < 6; ++k) points.push_back({r.unit(), r.unit(), r.unit()});
    const auto sample = [&](double t) {
      std::array<V, 8> room{};
      return *irg::bspline_sample(knots, points, t, std::span<V>(room));
    };
    std::vector<double> lengths(3 * 8 + 1);
    const irg::constant_speed motion(sample, 0., 3., std::span<double>(lengths));
    double far = 0;
    for (int k = 0; k < 10; ++k) {  // tenths of the way, measured by chords
      const double from = motion.parameter(k / 10.), to = motion.parameter((k + 1) / 10.);
      double sum = 0;
      for (int i = 0; i < 1000; ++i)
        sum += irg::length(sample(from + (to - from) * (i + 1) / 1000.).point -
                           sample(from + (to - from) * i / 1000.).point);
      far = std::fmax(far, std::abs(sum / motion.length() - 0.1));
    }
    CHECK(far < 1e-6);
    CHECK(motion.at(0).point == points[0]);
    CHECK(motion.at(1).point == points[5]);
  }
}

// A sharp turn between two lengths of the table: the same place as by a table of many.
TEST_CASE("constant_speed: a table of few lengths does as well as one of many") {
  const std::array<P, 4> turn{P{0, 0, 0}, {10, 1, 0}, {-9, 1, 2}, {1, 0, 0}};
  const auto sample = [&](double t) { return irg::bezier_sample(turn, t); };
  std::array<double, 2> few{};
  std::vector<double> many(1025);
  const irg::constant_speed coarse(sample, 0., 1., std::span<double>(few)),
      fine(sample, 0., 1., std::span<double>(many));
  for (int k = 1; k < 20; ++k)
    CHECK(irg::length(coarse.at(k / 20.).point - fine.at(k / 20.).point) <= 1e-13 * fine.length());
}

TEST_CASE("constant_speed: a curve of no length, NaN") {
  const auto still = [](double) { return irg::curve_sample<P>{{1, 2, 3}, {}}; };
  std::array<double, 3> lengths{};
  const irg::constant_speed motion(still, 0., 1., std::span<double>(lengths));
  CHECK(motion.length() == 0);
  CHECK(motion.at(0.5).point == P{1, 2, 3});
}
