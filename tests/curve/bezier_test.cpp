// SPDX-License-Identifier: MIT
#include <irg/curve/bezier.hpp>

#include <cmath>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/own_types.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using P2 = point<double, 2>;
using P3 = point<double, 3>;
using V3 = vec<double, 3>;

/// The course's control points.
constexpr std::array<P3, 4> course{P3{0, 0, 0}, P3{1, 3, 0}, P3{4, 3, 2}, P3{5, 0, 4}};

constexpr bool is_near(const P3& a, const P3& b, double tolerance) {
  for (int i = 0; i < 3; ++i)
    if (!(a[i] - b[i] <= tolerance && b[i] - a[i] <= tolerance)) return false;
  return true;
}

/// The curve in 64 bits by powers and binomials.
long double wide_bezier(const std::vector<P2>& b, double t, int axis) {
  const long double u = static_cast<long double>(t), rest = 1 - u;
  long double sum = 0, binomial = 1;
  const std::size_t n = b.size() - 1;
  for (std::size_t i = 0; i <= n; ++i) {
    sum += binomial * std::pow(u, static_cast<long double>(i)) * std::pow(rest, static_cast<long double>(n - i)) *
           static_cast<long double>(b[i][axis]);
    binomial = binomial * static_cast<long double>(n - i) / static_cast<long double>(i + 1);
  }
  return sum;
}

/// The points of the curve cut at t, as both halves give them.
constexpr std::array<std::array<P3, 4>, 2> halves(double t) {
  std::array<std::array<P3, 4>, 2> h{};
  bezier_split(course, t, h[0], h[1]);
  return h;
}

constexpr std::array<P3, 4> reversed{course[3], course[2], course[1], course[0]};

constexpr bool same_backwards(int n) {
  for (int k = 0; k <= n; ++k)
    if (!(bezier_point(course, curve_fraction<double>(k, n)) ==
          bezier_point(reversed, curve_fraction<double>(n - k, n))))
      return false;
  return true;
}

}  // namespace

TEST_CASE("bezier: type facts") {
  static_assert(FixedControlPoints<std::array<P3, 4>> && FixedControlPoints<std::array<V3, 2>>);
  static_assert(FixedControlPoints<std::span<const P3, 4>> && !FixedControlPoints<std::span<const P3>>);
  static_assert(ControlPoints<std::vector<P3>> && ControlPoints<std::vector<hpoint<float, 3>>>);
  static_assert(!ControlPoints<std::vector<point<int, 2>>> && !ControlPoints<int>);
  static_assert(std::is_same_v<decltype(bezier_sample(course, 0.5).derivative), V3>);
  static_assert(noexcept(bezier_point(course, 0.5)));
}

TEST_CASE("bezier: golden points") {
  CHECK_BOTH(bezier_point(course, 0.0) == P3{0, 0, 0});
  CHECK_BOTH(bezier_point(course, 0.25) == P3{17.0 / 16, 27.0 / 16, 11.0 / 32});
  CHECK_BOTH(bezier_point(course, 0.5) == P3{2.5, 2.25, 1.25});
  CHECK_BOTH(bezier_point(course, 0.75) == P3{63.0 / 16, 27.0 / 16, 81.0 / 32});
  CHECK_BOTH(bezier_point(course, 1.0) == P3{5, 0, 4});
  CHECK_BOTH(is_near(bezier_point(course, 0.01), P3{7649.0 / 250000, 0.0891, 299.0 / 500000}, 1e-15));
  CHECK_BOTH(is_near(bezier_point(course, 0.1), P3{89.0 / 250, 0.81, 0.058}, 1e-15));
  CHECK_BOTH(is_near(bezier_point(course, 1.0 / 3), P3{41.0 / 27, 2, 16.0 / 27}, 1e-15));
  CHECK_BOTH(is_near(bezier_point(course, 2.0 / 3), P3{94.0 / 27, 2, 56.0 / 27}, 2e-15));
  CHECK_BOTH(is_near(bezier_point(course, 0.9), P3{4.644, 0.81, 3.402}, 2e-15));
  CHECK_BOTH(bezier_point(std::array{P2{0, 0}, P2{2, 4}}, 0.25) == P2{0.5, 1});
  CHECK_BOTH(bezier_point(std::array{P2{0, 0}, P2{1, 2}, P2{2, 0}}, 0.5) == P2{1, 1});
  CHECK_BOTH(bezier_point(std::array{P2{0, 0}, P2{1, 0}, P2{2, 8}, P2{3, 0}, P2{4, 0}}, 0.5) == P2{2, 3});
  CHECK_BOTH(bezier_point(std::array{P2{7, 8}}, 0.5) == P2{7, 8});
}

TEST_CASE("bezier: the sum of the course's 101 points, golden") {
  V3 de_casteljau{}, linear{};
  for (int k = 0; k <= 100; ++k) {
    de_casteljau += to_vec(bezier_point(course, curve_fraction<double>(k, 100)));
    linear += to_vec(bezier_point_wozny_chudy(course, curve_fraction<double>(k, 100)));
  }
  for (const V3& sum : {de_casteljau, linear}) {
    CHECK(sum.x == doctest::Approx(252.5).epsilon(1e-14));
    CHECK(sum.y == doctest::Approx(149.985).epsilon(1e-14));
    CHECK(sum.z == doctest::Approx(152.005).epsilon(1e-14));
  }
}

TEST_CASE("bezier: Bernstein polynomials, golden and by their sum") {
  constexpr auto b = bernstein_basis<3>(1.0 / 3);
  const std::array<double, 4> expected{8.0 / 27, 4.0 / 9, 2.0 / 9, 1.0 / 27};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(b[i] == doctest::Approx(expected[i]).epsilon(1e-15));
    CHECK(bernstein(3, static_cast<int>(i), 1.0 / 3) == doctest::Approx(expected[i]).epsilon(1e-15));
  }
  CHECK_BOTH(bernstein(0, 0, 0.0) == 1);
  CHECK_BOTH((bernstein(5, 0, 0.0) == 1 && bernstein(5, 5, 1.0) == 1 && bernstein(5, 2, 0.0) == 0));
  CHECK_BOTH((bernstein(5, -1, 0.5) == 0 && bernstein(5, 6, 0.5) == 0));
  CHECK_BOTH(bernstein_basis<4>(0.5) == std::array{0.0625, 0.25, 0.375, 0.25, 0.0625});
  CHECK_BOTH(bernstein_basis<0>(0.25) == std::array{1.0});
  test::random r(1);
  for (int k = 0; k < 1000; ++k) {
    const double t = r.unit();
    const auto all = bernstein_basis<50>(t);
    double sum = 0;
    for (int i = 0; i <= 50; ++i) {
      sum += all[static_cast<std::size_t>(i)];
      CHECK(bernstein(50, i, t) == doctest::Approx(all[static_cast<std::size_t>(i)]).epsilon(1e-13));
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("bezier: error of both forms against 64-bit arithmetic") {
  test::random r(2);
  for (const std::size_t count : {1u, 2u, 4u, 8u, 21u}) {
    double worst = 0, worst_linear = 0;
    for (int k = 0; k < 4000; ++k) {
      std::vector<P2> b(count, P2{}), scratch(count, P2{});
      for (P2& p : b) {
        const double x = 2 * r.unit() - 1;
        p = {x, (r.next() & 1u) != 0 ? 1.0 : -1.0};
      }
      const double t = r.unit();
      const P2 p = bezier_point(b, t, scratch), q = bezier_point_wozny_chudy(b, t);
      for (int i = 0; i < 2; ++i) {
        const long double exact = wide_bezier(b, t, i);
        worst = std::max(worst, static_cast<double>(std::abs(static_cast<long double>(p[i]) - exact)) * 0x1p53);
        worst_linear =
            std::max(worst_linear, static_cast<double>(std::abs(static_cast<long double>(q[i]) - exact)) * 0x1p53);
        CHECK(std::abs(q[i]) <= 1 + 4 * 0x1p-53);
      }
    }
    CHECK(worst <= minimum(6.0, 3 * static_cast<double>(count - 1)));
    CHECK(worst_linear <= minimum(6.0, 3.5 * static_cast<double>(count - 1)));
    MESSAGE("degree ", count - 1, ": de Casteljau ", worst, " u, Wozny-Chudy ", worst_linear, " u");
  }
}

TEST_CASE("bezier: the derivative is the curve of the differences") {
  test::random r(3);
  for (int k = 0; k < 1000; ++k) {
    std::array<P3, 6> b{};
    for (P3& p : b) p = {r.unit(), r.unit(), r.unit()};
    std::array<V3, 5> hodograph{};
    for (std::size_t i = 0; i < 5; ++i) hodograph[i] = (b[i + 1] - b[i]) * 5;
    const double t = r.unit();
    const auto s = bezier_sample(b, t);
    CHECK(s.point == bezier_point(b, t));
    CHECK(is_near(to_point(s.derivative), to_point(bezier_point(hodograph, t)), 1e-14));
  }
  CHECK_BOTH(bezier_sample(course, 0.0) == curve_sample<P3>{{0, 0, 0}, {3, 9, 0}});
  CHECK_BOTH(bezier_sample(course, 1.0) == curve_sample<P3>{{5, 0, 4}, {3, -9, 6}});
  CHECK_BOTH(bezier_sample(std::array{P2{7, 8}}, 0.5) == curve_sample<P2>{{7, 8}, {0, 0}});
}

TEST_CASE("bezier: backwards the points are the same, bit for bit") {
  CHECK_BOTH(same_backwards(10));
  CHECK_BOTH(same_backwards(7));
  CHECK(same_backwards(1000));
}

TEST_CASE("bezier: halves join bit for bit and follow the curve") {
  CHECK_BOTH(halves(0.3)[0][3] == halves(0.3)[1][0]);
  CHECK_BOTH(halves(0.3)[0][3] == bezier_point(course, 0.3));
  CHECK_BOTH((halves(0.3)[0][0] == course[0] && halves(0.3)[1][3] == course[3]));
  CHECK_BOTH((halves(0.0)[1] == course && halves(1.0)[0] == course));
  const auto h = halves(0.375);
  for (int k = 0; k <= 16; ++k) {
    const double t = k / 16.0;
    CHECK(is_near(bezier_point(h[0], t), bezier_point(course, 0.375 * t), 1e-14));
    CHECK(is_near(bezier_point(h[1], t), bezier_point(course, 0.375 + 0.625 * t), 1e-14));
  }
}

TEST_CASE("bezier: translation over a lattice is exact") {
  std::array<P3, 4> moved = course;
  for (P3& p : moved) p = p + V3{1024, -4096, 512};
  for (int k = 0; k <= 16; ++k) {
    const double t = k / 16.0;
    CHECK(bezier_point(moved, t) == bezier_point(course, t) + V3{1024, -4096, 512});
  }
}

TEST_CASE("bezier: any range of any type") {
  const std::vector<own::plain2<float>> foreign{{0, 0}, {1, 2}, {2, 0}};
  std::vector<own::plain2<float>> scratch(3, own::plain2<float>{});
  CHECK(bezier_point(foreign, 0.5f, scratch).y == 1);
  CHECK(bezier_sample(foreign, 0.5f, scratch).derivative.x == 2);
  const std::array<hpoint<double, 2>, 3> quarter{hpoint<double, 2>{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
  const auto p = to_cartesian(bezier_point(quarter, 0.5));  // the rational quarter circle
  CHECK(p.x == doctest::Approx(0.6).epsilon(1e-15));
  CHECK(p.y == doctest::Approx(0.8).epsilon(1e-15));
}

TEST_CASE("bezier: coincident, collinear, extreme and outside") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr std::array<P2, 5> same{P2{0.1, 0.7}, P2{0.1, 0.7}, P2{0.1, 0.7}, P2{0.1, 0.7}, P2{0.1, 0.7}};
  CHECK_BOTH(bezier_sample(same, 0.3).derivative == vec<double, 2>{});
  CHECK(bezier_point(same, 0.3).x == doctest::Approx(0.1).epsilon(1e-15));
  CHECK_BOTH(bezier_point(std::array{P2{0, 0}, P2{1, 1}, P2{2, 2}}, 0.3).x ==
             bezier_point(std::array{P2{0, 0}, P2{1, 1}, P2{2, 2}}, 0.3).y);
  CHECK_BOTH(bezier_point(std::array{P2{0, 0}, P2{1, 2}}, 2.0) == P2{2, 4});
  CHECK_BOTH(bezier_point(std::array{P2{0, 0}, P2{1, 2}}, -1.0) == P2{-1, -2});
  CHECK_BOTH(bezier_point(std::array{P2{1, -0.0}, P2{inf, inf}}, 0.0) == P2{1, 0});
  CHECK_BOTH(bezier_point_wozny_chudy(std::array{P2{inf, inf}, P2{1, 2}}, 1.0) == P2{1, 2});
  CHECK_BOTH(bezier_point_wozny_chudy(std::array{P2{1, -0.0}, P2{inf, inf}}, 0.0) == P2{1, 0});
  CHECK(std::signbit(bezier_point_wozny_chudy(std::array{P2{1, -0.0}, P2{1, 2}}, 0.0).y));
  CHECK_BOTH(bezier_point_wozny_chudy(course, 0x1p-1074).x < 1e-300);
  CHECK_BOTH(bezier_point(course, 0x1.fffffffffffffp-1).x < 5.0);
  const std::vector<P2> fifty(51, P2{1, -1});
  CHECK(bezier_point_wozny_chudy(fifty, 0.7).x == doctest::Approx(1).epsilon(1e-14));
}
