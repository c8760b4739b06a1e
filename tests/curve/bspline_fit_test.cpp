// SPDX-License-Identifier: MIT
#include <irg/curve/bspline_fit.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 2>;
using irg::bspline_fit_status;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Three points at 0, 1/2 and 1, one quadratic stretch through them.
constexpr std::array<P, 3> through_three() {
  constexpr std::array<double, 6> u{0, 0, 0, 1, 1, 1};
  constexpr std::array<P, 3> points{P{0, 0}, {1, 1}, {2, 0}};
  std::array<P, 3> result{};
  static_cast<void>(irg::bspline_interpolate(irg::bspline_knots<double, 2>(u), std::array<double, 3>{0, 0.5, 1},
                                             std::span<const P>(points), std::span<P>(result)));
  return result;
}

struct samples {
  std::vector<P> points;
  std::vector<double> places, knots;
};

samples noisy_samples(test::random& r, int degree, std::size_t size, std::size_t count, irg::fit_spacing spacing) {
  samples d;
  for (std::size_t k = 0; k < size; ++k) d.points.push_back({static_cast<double>(k) + r.unit(), 5 * r.unit()});
  d.places.resize(size);
  CHECK(irg::parametrize(std::span<const P>(d.points), spacing, d.places) == bspline_fit_status::ok);
  d.knots.resize(count + static_cast<std::size_t>(degree) + 1);
  irg::fit_knots(std::span<const double>(d.places), degree, count, d.knots);
  return d;
}

}  // namespace

TEST_CASE("bspline_interpolate: by hand") {
  CHECK_BOTH(through_three()[0] == P{0, 0});
  CHECK_BOTH(irg::length(through_three()[1] - P{1, 2}) < 1e-15);
  CHECK_BOTH(through_three()[2] == P{2, 0});
}

TEST_CASE("bspline_interpolate: through every point, whatever the spacing") {
  test::random r(71);
  double worst = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const int degree = static_cast<int>(r.integer(1, 5));
    const std::size_t size = static_cast<std::size_t>(degree) + 1 + static_cast<std::size_t>(r.integer(0, 40));
    const auto spacing = std::array{irg::fit_spacing::uniform, irg::fit_spacing::chord_length,
                                    irg::fit_spacing::centripetal}[static_cast<std::size_t>(trial % 3)];
    const samples d = noisy_samples(r, degree, size, size, spacing);
    const auto knots = irg::make_bspline_knots(std::span<const double>(d.knots), degree);
    REQUIRE(knots);
    std::vector<P> control(size);
    const auto fit = irg::bspline_interpolate(*knots, d.places, std::span<const P>(d.points), control);
    REQUIRE(fit);
    double largest = 0;
    for (const P& c : control) largest = std::fmax(largest, irg::length(c - P{}));
    worst = std::fmax(worst, *fit / largest * 0x1p53);
    CHECK(control.front() == d.points.front());
    CHECK(control.back() == d.points.back());
  }
  MESSAGE("worst ", worst, " u of the largest control point");
  CHECK(worst < 32);
}

TEST_CASE("bspline_least_squares: a spline comes back from points on it; more control points come nearer") {
  test::random r(72);
  for (int trial = 0; trial < 60; ++trial) {
    const int degree = static_cast<int>(r.integer(1, 4));
    const std::size_t count = static_cast<std::size_t>(degree) + 1 + static_cast<std::size_t>(r.integer(0, 8));
    samples d = noisy_samples(r, degree, 80, count, irg::fit_spacing::chord_length);
    const auto knots = *irg::make_bspline_knots(std::span<const double>(d.knots), degree);
    std::vector<P> control(count), back(count);
    for (P& c : control) c = {r.unit(), r.unit()};
    std::vector<double> scratch(6);
    const std::vector<P> given = d.points;
    for (std::size_t k = 0; k < 80; ++k) d.points[k] = *irg::bspline_point(knots, control, d.places[k], scratch);
    for (const auto ends : {irg::fit_ends::through, irg::fit_ends::free}) {
      const auto fit = irg::bspline_least_squares(knots, d.places, std::span<const P>(d.points), ends, back);
      REQUIRE(fit);
      CHECK(*fit < 1e-14);
      for (std::size_t i = 0; i < count; ++i) CHECK(irg::length(back[i] - control[i]) < 1e-12);
    }
    const auto off = irg::bspline_least_squares(knots, d.places, std::span<const P>(given), irg::fit_ends::free, back);
    CHECK(off.value_or(0) > 0.01);
  }
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("bspline_least_squares: no other control points are better: the residual is normal to every basis function") {
  test::random r(73);
  double worst = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const int degree = static_cast<int>(r.integer(1, 4));
    const std::size_t count = static_cast<std::size_t>(degree) + 3;
    const samples d = noisy_samples(r, degree, 30, count, irg::fit_spacing::centripetal);
    const auto knots = *irg::make_bspline_knots(std::span<const double>(d.knots), degree);
    std::vector<P> control(count);
    REQUIRE(irg::bspline_least_squares(knots, d.places, std::span<const P>(d.points), irg::fit_ends::free, control));
    std::vector<test::big_rational> sum(count, test::big_rational(0));
    std::vector<double> values(static_cast<std::size_t>(degree) + 1);
    for (std::size_t k = 0; k < d.points.size(); ++k) {
      const std::size_t first = *irg::bspline_basis(knots, d.places[k], values);
      test::big_rational off(d.points[k].y);
      for (std::size_t i = 0; i < values.size(); ++i)
        off = off - test::big_rational(values[i]) * test::big_rational(control[first + i].y);
      for (std::size_t i = 0; i < values.size(); ++i)
        sum[first + i] = sum[first + i] + off * test::big_rational(values[i]);
    }
    for (const auto& s : sum) worst = std::fmax(worst, std::fabs(static_cast<double>(s)));
  }
  CHECK(worst < 2e-14);
}
#endif

// What a point costs is its row's turns: no more of them than the order, however many control points there are.
TEST_CASE("bspline_least_squares: turns in proportion to the points") {
  test::random r(74);
  for (const std::size_t size : {std::size_t{1000}, static_cast<std::size_t>(test::trials(10000))}) {
    for (const int degree : {1, 3, 5}) {
      const samples d = noisy_samples(r, degree, size, size / 10, irg::fit_spacing::centripetal);
      const auto knots = *irg::make_bspline_knots(std::span<const double>(d.knots), degree);
      irg::detail::banded_rows<P> rows(knots.size(), knots.order());
      std::vector<double> values(knots.order());
      std::size_t turns = 0;
      for (std::size_t k = 0; k < size; ++k) {
        const std::size_t first = *irg::bspline_basis(knots, d.places[k], std::span<double>(values));
        turns += rows.add(values, first, d.points[k]);
      }
      CHECK(turns <= size * knots.order());
    }
  }
}

TEST_CASE("fits that there are not") {
  constexpr std::array<double, 7> u{0, 0, 0, 0.5, 1, 1, 1};
  const irg::bspline_knots<double, 2> knots(u);
  std::vector<P> points{{0, 0}, {1, 1}, {2, 1}, {3, 0}}, result(4);
  const auto status = [&](std::vector<double> places) {
    const auto fit = irg::bspline_interpolate(knots, places, std::span<const P>(points), result);
    return fit ? bspline_fit_status::ok : fit.error();
  };
  CHECK(status({0, 0.3, 0.7, 1}) == bspline_fit_status::ok);
  CHECK(status({0, 0.7, 0.3, 1}) == bspline_fit_status::not_rising);
  CHECK(status({0, 0.3, 0.7, 1.5}) == bspline_fit_status::not_rising);
  CHECK(status({-0.5, 0.3, 0.7, 1}) == bspline_fit_status::not_rising);
  CHECK(status({0, 0.3, none, 1}) == bspline_fit_status::not_finite);
  CHECK(status({0, 0.3, 0.3, 1}) == bspline_fit_status::undetermined);  // two points at one place
  CHECK(status({0, 0, 0.3, 1}) == bspline_fit_status::undetermined);
  CHECK(status({0, 0.1, 0.2, 0.3}) == bspline_fit_status::undetermined);  // the last function is 0 at all of them
  CHECK(status({0.1, 0.2, 0.6, 0.9}) == bspline_fit_status::ok);
  constexpr double most = std::numeric_limits<double>::max();
  const std::vector<P> usual = points;
  points = {{most, most}, {-most, most}, {most, -most}, {-most, most}};
  CHECK(status({0, 0.3, 0.7, 1}) == bspline_fit_status::not_finite);  // control points would be beyond all numbers
  points = usual;
  points[1].x = none;
  CHECK(status({0, 0.3, 0.7, 1}) == bspline_fit_status::not_finite);
  std::vector<double> places(3);
  const auto at = [&](const std::vector<P>& p) {
    return irg::parametrize(std::span<const P>(p), irg::fit_spacing::chord_length, places);
  };
  CHECK(at({{1, 1}, {1, 1}, {1, 1}}) == bspline_fit_status::undetermined);
  CHECK(at({{1, 1}, {none, 1}, {1, 1}}) == bspline_fit_status::not_finite);
  CHECK(at({{most, 1}, {-most, 1}, {1, 1}}) == bspline_fit_status::not_finite);
  constexpr auto of_infinity = [](irg::fit_spacing spacing) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const std::array<P, 3> far{P{0, inf}, P{1, inf}, P{none, 1}};
    std::array<double, 3> three{};
    return irg::parametrize(std::span<const P>(far), spacing, three);
  };
  CHECK_BOTH(of_infinity(irg::fit_spacing::centripetal) == bspline_fit_status::not_finite);
  CHECK_BOTH(of_infinity(irg::fit_spacing::uniform) == bspline_fit_status::ok);
  CHECK(at({{1, 1}, {1, 1}, {2, 1}}) == bspline_fit_status::ok);
  CHECK(places == std::vector<double>{0, 0, 1});
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  CHECK(irg::fit_places(std::span<const P>(usual).first(3), irg::fit_spacing::uniform, places));
#pragma GCC diagnostic pop
  // Nor are many points near the largest number.
  const std::vector<P> distant(100, P{0.99 * most, -most / 2});
  std::vector<double> hundred(100);
  for (std::size_t k = 0; k < 100; ++k) hundred[k] = static_cast<double>(k) / 99;
  for (const auto ends : {irg::fit_ends::through, irg::fit_ends::free}) {
    const auto fit = irg::bspline_least_squares(knots, hundred, std::span<const P>(distant), ends, result);
    REQUIRE(fit);
    CHECK(*fit <= most * 0x1p-48);
  }
  // Equal points one after another are no harm to least squares.
  const std::vector<P> more{{0, 0}, {0, 0}, {1, 1}, {2, 1}, {2, 1}, {3, 0}};
  const std::vector<double> six{0, 0, 0.3, 0.7, 0.7, 1};
  CHECK(irg::bspline_least_squares(knots, six, std::span<const P>(more), irg::fit_ends::through, result));
  CHECK(result[0] == P{0, 0});
}
