// SPDX-License-Identifier: MIT
#include <irg/curve/curve_joint.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 2>;
using irg::continuity_of;
using irg::curve_continuity;

constexpr std::array<P, 4> cubic{P{0, 0}, P{8, 16}, P{24, 16}, P{32, 0}};

// How the two parts of the curve, cut at t, go on in each other.
constexpr curve_continuity of_parts(double t, double first, double second) {
  std::array<P, 4> left{}, right{};
  irg::bezier_split(cubic, t, left, right);
  return continuity_of(left, right, first, second);
}

}  // namespace

TEST_CASE("continuity_of: reference values of every kind") {
  CHECK_BOTH(of_parts(0.5, 1, 1) == curve_continuity::second_derivative);
  CHECK_BOTH(of_parts(0.25, 1, 3) == curve_continuity::second_derivative);
  CHECK_BOTH(of_parts(0.25, 1, 1) == curve_continuity::direction);
  constexpr std::array<P, 2> line{P{0, 0}, P{1, 1}}, on{P{1, 1}, P{2, 2}}, longer{P{1, 1}, P{3, 3}},
      turned{P{1, 1}, P{2, 1}}, back{P{1, 1}, P{0, 0}}, off{P{1, 1.0000000000000002}, P{2, 2}};
  constexpr std::array<P, 3> bent{P{1, 1}, P{1.5, 1.5}, P{3, 1}};
  CHECK_BOTH(continuity_of(line, on) == curve_continuity::second_derivative);
  CHECK_BOTH(continuity_of(line, longer) == curve_continuity::direction);
  CHECK_BOTH(continuity_of(line, longer, 1, 2) == curve_continuity::second_derivative);
  CHECK_BOTH(continuity_of(line, turned) == curve_continuity::position);
  CHECK_BOTH(continuity_of(line, back) == curve_continuity::position);
  CHECK_BOTH(continuity_of(line, off) == curve_continuity::apart);
  CHECK_BOTH(continuity_of(line, bent) == curve_continuity::first_derivative);
  // In four dimensions, every one of which counts.
  using V = irg::vec<double, 4>;
  constexpr std::array<V, 2> from{V{-1, -2, -3, -4}, V{0, 0, 0, 0}}, ahead{V{0, 0, 0, 0}, V{2, 4, 6, 8}},
      aside{V{0, 0, 0, 0}, V{2, 4, 6, 7}}, reversed{V{0, 0, 0, 0}, V{-2, -4, -6, -8}};
  CHECK_BOTH(continuity_of(from, ahead) == curve_continuity::direction);
  CHECK_BOTH(continuity_of(from, aside) == curve_continuity::position);
  CHECK_BOTH(continuity_of(from, reversed) == curve_continuity::position);
  for (int axis = 0; axis < 4; ++axis) {
    std::array<V, 2> before{}, after{};
    before[0][axis] = -1, after[1][axis] = 2;
    CHECK(continuity_of(before, after) == curve_continuity::direction);
    after[1][axis] = -2;
    CHECK(continuity_of(before, after) == curve_continuity::position);
  }
}

TEST_CASE("continuity_of: single points, coincident ones, sizes, one ulp, what is not finite") {
  const std::vector<P> one{{1, 1}}, same{{1, 1}, {1, 1}, {1, 1}}, line{{0, 0}, {1, 1}};
  CHECK(continuity_of(one, one) == curve_continuity::second_derivative);
  CHECK(continuity_of(one, same) == curve_continuity::second_derivative);
  CHECK(continuity_of(line, one) == curve_continuity::position);
  CHECK(continuity_of(line, same) == curve_continuity::position);
  const std::vector<P> nearly{{1, 1}, {2, std::nextafter(2, 3)}};
  CHECK(continuity_of(line, nearly) == curve_continuity::position);
  const std::vector<P> huge{{-1e308, -1e308}, {0, 0}}, next{{0, 0}, {1e308, 1e308}}, tiny{{0, 0}, {5e-324, 5e-324}};
  CHECK(continuity_of(huge, next) == curve_continuity::second_derivative);
  CHECK(continuity_of(huge, tiny) == curve_continuity::direction);
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(continuity_of(line, std::vector<P>{{1, 1}, {inf, 1}}) == curve_continuity::apart);
  using Q = irg::point<float, 3>;
  const std::vector<Q> a{{0, 0, 0}, {1, 2, 3}}, b{{1, 2, 3}, {3, 6, 9}}, c{{1, 2, 3}, {3, 6, 10}};
  CHECK(continuity_of(a, b) == curve_continuity::direction);
  CHECK(continuity_of(a, c) == curve_continuity::position);
}

#ifdef IRG_HAVE_MPFR
namespace {

using test::big_rational;

big_rational difference(const P& a, const P& b, int axis) {
  return big_rational(axis == 0 ? a.x : a.y) - big_rational(axis == 0 ? b.x : b.y);
}

/// By the derivatives themselves, as quotients by the widths.
curve_continuity by_definition(const std::vector<P>& a, const std::vector<P>& b, double first, double second) {
  const auto n = a.size() - 1, m = b.size() - 1;
  const auto derivatives = [](const P& p0, const P& p1, const P& p2, std::size_t degree, double width, int axis) {
    const int d = static_cast<int>(degree);
    const big_rational w(width);
    return std::array<big_rational, 2>{
        big_rational(d) * difference(p1, p0, axis) / w,
        big_rational(d * (d - 1)) * (difference(p2, p1, axis) - difference(p1, p0, axis)) / (w * w)};
  };
  if (!(a[n] == b[0])) return curve_continuity::apart;
  std::array<std::array<big_rational, 2>, 2> u, v;
  for (int axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    u[i] = derivatives(a[n], a[n - 1], a[n > 1 ? n - 2 : 0], n, first, axis);
    u[i][0] = -u[i][0];
    v[i] = derivatives(b[0], b[1], b[m > 1 ? 2 : 1], m, second, axis);
  }
  if (u[0][0] == v[0][0] && u[1][0] == v[1][0])
    return u[0][1] == v[0][1] && u[1][1] == v[1][1] ? curve_continuity::second_derivative
                                                    : curve_continuity::first_derivative;
  const bool ahead = (u[0][0] * v[0][0] + u[1][0] * v[1][0]).sign() > 0;
  return ahead && (u[0][0] * v[1][0] - u[1][0] * v[0][0]).sign() == 0 ? curve_continuity::direction
                                                                      : curve_continuity::position;
}

}  // namespace

TEST_CASE("continuity_of: against derivatives in rationals") {
  test::random r(61);
  std::array<long, 5> seen{};
  long wrong = 0;
  for (int round = 0; round < (std::getenv("IRG_RELEASE_TIER") ? 300'000 : 4000); ++round) {
    // Few coordinates, so that joints of all kinds come up; scaled, so that products round and differences do not fit.
    const int scale = static_cast<int>(r.integer(-300, 300));
    const auto make = [&](std::int64_t size) {
      std::vector<P> c;
      for (; size > 0; --size) {
        const auto x = r.integer(0, 2), y = r.integer(0, 1);
        c.push_back({std::ldexp(static_cast<double>(x), scale), std::ldexp(static_cast<double>(y), scale)});
      }
      return c;
    };
    const auto a = make(r.integer(2, 4));
    auto b = make(r.integer(2, 4));
    if (r.integer(0, 3) != 0) b[0] = a.back();
    if (r.integer(0, 9) == 0) b[1].y = std::nextafter(b[1].y, 1e300);
    const double first = static_cast<double>(r.integer(1, 3)), second = static_cast<double>(r.integer(1, 3));
    const auto got = continuity_of(a, b, first, second);
    wrong += got != by_definition(a, b, first, second);
    ++seen[static_cast<std::size_t>(got)];
  }
  CHECK(wrong == 0);
  for (const long count : seen) CHECK(count > 10);
}
#endif
