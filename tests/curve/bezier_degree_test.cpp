// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_degree.hpp>

#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using degree_point = point<double, 2>;
using degree_points = std::vector<degree_point>;
constexpr std::array<degree_point, 3> arch{degree_point{0, 0}, degree_point{3, 6}, degree_point{6, 0}};

constexpr std::array<degree_point, 4> raised() {
  std::array<degree_point, 4> e{};
  bezier_elevate(arch, e);
  return e;
}
constexpr double lowered_again() {
  std::array<degree_point, 3> r{};
  const double off = bezier_reduce(raised(), r);
  return r == arch ? off : -1;
}

degree_points random_points(test::random& r, std::size_t count) {
  degree_points p(count, degree_point{});
  for (degree_point& q : p) q = {2 * r.unit() - 1, 2 * r.unit() - 1};
  return p;
}

degree_point at(const degree_points& points, double t) {
  degree_points scratch(points.size(), degree_point{});
  return bezier_point(points, t, scratch);
}

}  // namespace

TEST_CASE("bezier degree: a parabola as a cubic and back") {
  CHECK_BOTH(raised() == std::array<degree_point, 4>{degree_point{0, 0}, {2, 4}, {4, 4}, {6, 0}});
  CHECK_BOTH(lowered_again() == 0);
  constexpr auto point_twice = [] {
    const std::array<degree_point, 1> one{degree_point{3, 6}};
    std::array<degree_point, 2> e{};
    bezier_elevate(one, e);
    return e;
  };
  CHECK_BOTH(point_twice() == std::array<degree_point, 2>{degree_point{3, 6}, {3, 6}});
}

TEST_CASE("bezier degree: elevation keeps the curve, reduction takes it back") {
  test::random r(61);
  for (std::size_t count = 1; count <= 20; ++count) {
    const degree_points p = random_points(r, count);
    degree_points up(count + 1, degree_point{}), down(count, degree_point{});
    bezier_elevate(p, up);
    CHECK(up.front() == p.front());
    CHECK(up.back() == p.back());
    for (const double t : {0.0, 0.125, 0.3, 0.77, 1.0}) CHECK(length(at(p, t) - at(up, t)) <= 1e-14);
    const double off = bezier_reduce(up, std::span<degree_point>(down));
    if (count <= 12) CHECK(off <= 1e-12);
    for (std::size_t k = 0; k < count && count <= 12; ++k) CHECK(length(down[k] - p[k]) <= 1e-11);
  }
}

TEST_CASE("bezier degree: the bound of a reduction holds, ends stay, and direction does not matter") {
  test::random r(62);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t count = static_cast<std::size_t>(r.integer(2, 9));
    degree_points p = random_points(r, count), q(count - 1, degree_point{}), back = q;
    const double off = bezier_reduce(p, std::span<degree_point>(q));
    if (count > 2) CHECK((q.front() == p.front() && q.back() == p.back()));
    for (int k = 0; k <= 32; ++k) CHECK(length(at(p, k / 32.0) - at(q, k / 32.0)) <= off + 1e-14);
    bezier_reduce(degree_points(p.rbegin(), p.rend()), std::span<degree_point>(back));
    CHECK(degree_points(back.rbegin(), back.rend()) == q);
  }
}

TEST_CASE("bezier degree: derivatives, against divided differences and for degree 0") {
  test::random r(63);
  for (std::size_t count = 2; count <= 8; ++count) {
    const degree_points p = random_points(r, count);
    std::vector<vec<double, 2>> d(count - 1, vec<double, 2>{}), scratch = d;
    bezier_derivative(p, std::span<vec<double, 2>>(d));
    for (const double t : {0.1, 0.5, 0.8}) {
      const vec<double, 2> slope = bezier_point(d, t, scratch);
      CHECK(length((at(p, t + 1e-6) - at(p, t - 1e-6)) * 5e5 - slope) <= 1e-7);
      degree_points work(count, degree_point{});
      CHECK(length(bezier_sample(p, t, work).derivative - slope) <= 1e-13);
    }
  }
  std::array<vec<double, 2>, 1> none{vec<double, 2>{1, 1}};
  bezier_derivative(std::array{degree_point{3, 4}}, none);
  CHECK(none[0] == vec<double, 2>{0, 0});
}
