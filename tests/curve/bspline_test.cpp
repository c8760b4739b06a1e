// SPDX-License-Identifier: MIT
#include <irg/curve/bspline.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::bspline_basis;
using irg::bspline_knots;
using irg::check_knots;
using irg::knots_status;
using irg::make_bspline_knots;

namespace {

using P = irg::point<double, 2>;
constexpr double inf = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<double, 6> arc{0, 0, 0, 1, 1, 1};
constexpr std::array<P, 3> arc_points{P{1, 0}, P{1, 1}, P{0, 1}};
constexpr std::array<double, 3> arc_weights{1, 1, 2};
constexpr P on_arc(double t) {
  return *irg::nurbs_point(bspline_knots<double, 2>(arc), arc_points, std::span<const double>(arc_weights), t);
}

constexpr std::array<double, 8> clamped{0, 0, 0, 1, 2, 3, 3, 3};
constexpr std::array<P, 5> hill{P{0, 0}, P{1, 2}, P{3, 2}, P{4, 0}, P{6, 1}};
constexpr P on_hill(double t) { return *irg::bspline_point(bspline_knots<double, 2>(clamped), hill, t); }

template <int Degree, std::size_t N>
constexpr knots_status verdict(const std::array<double, N>& knots) {
  return check_knots<Degree>(std::span<const double>(knots));
}

bool near(const P& p, double x, double y) { return std::abs(p.x - x) < 1e-15 && std::abs(p.y - y) < 1e-15; }

}  // namespace

TEST_CASE("nurbs_point: reference values, a quarter of a circle") {
  CHECK_BOTH(on_arc(0) == P{1, 0});
  CHECK_BOTH(on_arc(1) == P{0, 1});
  CHECK_BOTH(on_arc(0.5) == P{0.6, 0.8});
  CHECK(near(on_arc(0.25), 15. / 17, 8. / 17));
  CHECK(near(on_arc(1. / 3), 4. / 5, 3. / 5));
  CHECK(near(on_arc(2. / 3), 5. / 13, 12. / 13));
}

TEST_CASE("bspline_point: reference values") {
  CHECK_BOTH(on_hill(0) == P{0, 0});
  CHECK_BOTH(on_hill(0.5) == P{1, 1.5});
  CHECK_BOTH(on_hill(1) == P{2, 2});
  CHECK_BOTH(on_hill(1.5) == P{2.875, 1.75});
  CHECK_BOTH(on_hill(2.5) == P{4.375, 0.5});
  CHECK_BOTH(on_hill(3) == P{6, 1});  // the last point, exactly
}

TEST_CASE("check_knots: what is no list of knots") {
  using std::array;
  CHECK_BOTH(verdict<2>(clamped) == knots_status::ok);
  CHECK_BOTH(verdict<2>(array<double, 5>{0, 0, 0, 1, 1}) == knots_status::too_few);
  CHECK_BOTH(verdict<1>(array<double, 4>{0, 0, 1, none}) == knots_status::not_finite);
  CHECK_BOTH(verdict<1>(array<double, 4>{0, 0, 1, inf}) == knots_status::not_finite);
  CHECK_BOTH(verdict<1>(array<double, 5>{0, 0, 2, 1, 3}) == knots_status::decreasing);
  CHECK_BOTH(verdict<1>(array<double, 5>{0, 0, 0, 1, 1}) == knots_status::too_many_equal);
  CHECK_BOTH(verdict<2>(array<double, 9>{0, 0, 0, 1, 1, 1, 2, 2, 2}) == knots_status::ok);  // full, inside too
  CHECK_BOTH(verdict<1>(array<double, 4>{0, 1, 1, 2}) == knots_status::empty);
  CHECK_BOTH(verdict<0>(array<double, 2>{3, 4}) == knots_status::ok);
  CHECK(!make_bspline_knots<1>(std::span<const double>(array<double, 4>{0, 0, 1, none})));
}

TEST_CASE("bspline_basis: outside, at the ends, next to them; bad weights") {
  constexpr bspline_knots<double, 2> knots(clamped);
  CHECK_BOTH(!bspline_basis(knots, -0x1p-1074));
  CHECK_BOTH(!bspline_basis(knots, 3.0000000000000004));
  CHECK(!bspline_basis(knots, none));
  CHECK_BOTH(bspline_basis(knots, 0)->value == std::array<double, 3>{1, 0, 0});
  CHECK_BOTH((bspline_basis(knots, 3)->value == std::array<double, 3>{0, 0, 1} && bspline_basis(knots, 3)->first == 2));
  CHECK_BOTH(bspline_basis(knots, 0x1.7ffffffffffffp1)->value[2] > 0.999);
  constexpr std::array<double, 2> step{3, 4};
  CHECK_BOTH(bspline_basis(bspline_knots<double, 0>(step), 3.5)->value[0] == 1);
  const bspline_knots<double, 2> circle(arc);
  for (const std::array<double, 3>& w : {std::array<double, 3>{0, 0, 0}, {1, -1, 1}, {1, none, 1}, {1, inf, 1}})
    CHECK(!irg::nurbs_point(circle, arc_points, std::span<const double>(w), 0.5));
  CHECK(*irg::nurbs_point(circle, arc_points, std::span<const double>(std::array<double, 3>{0, 1, 0}), 0.5) == P{1, 1});
  CHECK(!irg::nurbs_point(circle, arc_points, std::span<const double>(std::array<double, 3>{0, 1, 0}), 0));
  CHECK(
      irg::nurbs_point(circle, arc_points, std::span<const double>(std::array<double, 3>{1e300, 1e-300, 1e300}), 0.5));
  // At an end one weight counts, however far it is from those that do not.
  for (const std::array<double, 3>& w : {std::array<double, 3>{1e-300, 1e300, 1}, {0x1p-1074, 0x1p1023, 0x1p1023}}) {
    CHECK(*irg::nurbs_point(circle, arc_points, std::span<const double>(w), 0) == P{1, 0});
    CHECK(*irg::nurbs_point(circle, arc_points, std::span<const double>(w), 1) == P{0, 1});
  }
}

namespace {

template <class T, int Degree>
struct totals {
  double worst_sum = 0, worst_rational = 0;
  long wrong = 0, places = 0;
};

/// Random knots of every multiplicity up to degree + 1, evenly spaced, crowded or of all sizes; all ends and random
/// places between.
template <class T, int Degree>
void check_unity(std::uint64_t seed, int rounds) {
  test::random r(seed);
  double worst = 0, worst_rational = 0;
  long wrong = 0, places = 0;
  const auto sum_off = [](const auto& value) {
    long double sum = 0;
    for (const T v : value) sum += static_cast<long double>(v);
    return static_cast<double>(std::abs(sum - 1)) / static_cast<double>(std::numeric_limits<T>::epsilon() / 2);
  };
  for (int i = 0; i < rounds; ++i) {
    std::vector<T> knots;
    T at = static_cast<T>(r.integer(-5, 5));
    const int kinds = static_cast<int>(r.integer(0, 3));
    const auto n = static_cast<std::size_t>(r.integer(2 * Degree + 2, 3 * Degree + 9));
    while (knots.size() < n) {
      const auto times = r.integer(0, 2) == 0 ? r.integer(1, Degree + 1) : 1;
      for (std::int64_t k = 0; k < times; ++k) knots.push_back(at);
      const T step = kinds == 0   ? T(1)
                     : kinds == 1 ? static_cast<T>(r.unit())
                     : kinds == 2 ? std::nextafter(at, T(1e30f)) - at
                                  : static_cast<T>(std::ldexp(r.unit(), static_cast<int>(r.integer(-90, 90))));
      at += step;
    }
    const std::span<const T> all(knots);
    const knots_status verdict = check_knots<Degree>(all);
    if (verdict == knots_status::empty || verdict == knots_status::too_many_equal)
      continue;  // steps too small to count
    REQUIRE(verdict == knots_status::ok);
    const auto legal = *make_bspline_knots<Degree>(all);
    std::vector<T> weights;
    for (std::size_t k = 0; k < legal.size(); ++k)
      weights.push_back(static_cast<T>(std::ldexp(r.unit(), static_cast<int>(r.integer(-20, 20)))));
    for (int k = 0; k < 12; ++k) {
      T t = k < 2 ? (k == 0 ? legal.first() : legal.last())
                  : knots[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(n) - 1))];
      if (k > 5) t = legal.first() + (legal.last() - legal.first()) * static_cast<T>(r.unit());
      if (k == 5) t = std::nextafter(t, legal.first());
      const auto basis = bspline_basis(legal, t);
      const bool inside = legal.first() <= t && t <= legal.last();
      wrong += basis.has_value() != inside;
      if (!basis) continue;
      ++places;
      for (const T v : basis->value) wrong += !(v >= 0 && v <= 1);
      worst = std::fmax(worst, sum_off(basis->value));
      const auto rational = irg::nurbs_basis(legal, std::span<const T>(weights), t);
      if (!rational) continue;
      for (const T v : rational->value) wrong += !(v >= 0 && v <= 1);
      worst_rational = std::fmax(worst_rational, sum_off(rational->value));
    }
  }
  MESSAGE("degree ", Degree, ": sums off by ", worst, " u, rational ", worst_rational, " u at ", places, " places");
  CHECK(wrong == 0);
  CHECK(places > rounds);
  CHECK(worst <= 4);
  CHECK(worst_rational <= 4);
}

}  // namespace

TEST_CASE("bspline_basis: partition of unity within 4u for every legal list of knots") {
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 300'000 : 1500;
  check_unity<double, 0>(1, rounds);
  check_unity<double, 1>(2, rounds);
  check_unity<double, 2>(3, rounds);
  check_unity<double, 3>(4, rounds);
  check_unity<double, 7>(5, rounds);
  check_unity<double, 20>(6, rounds / 4);
  check_unity<float, 3>(7, rounds);
}

#ifdef IRG_HAVE_MPFR
namespace {

using test::big_rational;

/// By the definition: N(i, 0) is 1 in its stretch; N(i, p) blends two of them, 0/0 being 0.
big_rational by_definition(const std::vector<double>& u, std::size_t i, int degree, std::size_t stretch, double t) {
  if (degree == 0) return big_rational(i == stretch ? 1 : 0);
  const auto share = [&](double from, double to, double a, double b) {
    return a == b ? big_rational(0) : (big_rational(to) - big_rational(from)) / (big_rational(b) - big_rational(a));
  };
  const auto p = static_cast<std::size_t>(degree);
  return share(u[i], t, u[i], u[i + p]) * by_definition(u, i, degree - 1, stretch, t) +
         share(t, u[i + p + 1], u[i + 1], u[i + p + 1]) * by_definition(u, i + 1, degree - 1, stretch, t);
}

}  // namespace

TEST_CASE("bspline_basis: against the recursion by Cox and de Boor in rationals") {
  test::random r(9);
  double worst = 0;
  for (int i = 0; i < (std::getenv("IRG_RELEASE_TIER") ? 20'000 : 300); ++i) {
    std::vector<double> u{r.unit()};
    while (u.size() < 12) u.push_back(u.back() + (r.integer(0, 3) == 0 ? 0 : r.unit()));
    const std::span<const double> all(u);
    if (check_knots<3>(all) != knots_status::ok) continue;
    const auto knots = *make_bspline_knots<3>(all);
    const double t = i % 5 == 0 ? knots.last() : knots.first() + (knots.last() - knots.first()) * r.unit();
    if (t > knots.last()) continue;
    const auto basis = *bspline_basis(knots, t);
    for (std::size_t k = 0; k < 4; ++k) {
      const big_rational exact = by_definition(u, basis.first + k, 3, basis.first + 3, t);
      worst = std::fmax(worst, test::distance(basis.value[k], exact));
    }
  }
  MESSAGE("largest error ", worst * 0x1p53, " u");
  CHECK(worst <= 8 * 0x1p-53);
}
#endif
