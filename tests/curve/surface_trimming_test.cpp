// SPDX-License-Identifier: MIT
#include <irg/curve/surface_trimming.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <irg/geometry/polygon_area.hpp>
#include <irg/math/trigonometry.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;
using place = std::pair<double, double>;

std::vector<P3> random_net(test::random& r) {
  std::vector<P3> points(16);
  for (P3& p : points) p = {r.unit(), r.unit(), r.unit()};
  return points;
}

std::vector<P2> star(test::random& r, const P2& centre, double radius, int corners) {
  std::vector<P2> ring;
  for (int k = 0; k < corners; ++k) {
    const double angle = irg::two_pi<double> * k / corners, far = radius * (0.4 + 0.6 * r.unit());
    ring.push_back({centre.x + far * std::cos(angle), centre.y + far * std::sin(angle)});
  }
  return ring;
}

struct trimmed {
  std::optional<irg::surface_tessellation> done;
  double area = 0, farthest = 0;
  std::map<std::pair<place, place>, int> edges{};  // how often met this way, less how often the other way
  std::map<place, P3> points{};
  bool one_point_each = true;
};

template <class R>
trimmed run(const std::vector<P3>& points, const R& polygon, double tolerance) {
  trimmed t;
  const irg::control_net<P3> net{points, 4};
  std::vector<P3> room(12);
  t.done = irg::tessellate_trimmed(net, polygon, tolerance, [&](const auto& a, const auto& b, const auto& c) {
    const std::array corners{&a, &b, &c};
    t.area += ((b.u.t - a.u.t) * (c.v.t - a.v.t) - (c.u.t - a.u.t) * (b.v.t - a.v.t)) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const place p(corners[i]->u.t, corners[i]->v.t), q(corners[(i + 1) % 3]->u.t, corners[(i + 1) % 3]->v.t);
      p < q ? ++t.edges[{p, q}] : --t.edges[{q, p}];
      const auto found = t.points.emplace(p, corners[i]->point).first;
      t.one_point_each = t.one_point_each && found->second == corners[i]->point;
    }
    const double u = (a.u.t + b.u.t + c.u.t) / 3, v = (a.v.t + b.v.t + c.v.t) / 3;
    const auto flat = P3{} + ((a.point - P3{}) + (b.point - P3{}) + (c.point - P3{})) / 3;
    t.farthest = std::fmax(t.farthest, irg::length(irg::patch_sample(net, u, v, room).point - flat));
  });
  return t;
}

// Edges met from one side only are the trimmed border: their length in the plane of parameters.
double open_length(const trimmed& t) {
  double sum = 0;
  for (const auto& [edge, times] : t.edges)
    if (times != 0)
      sum += std::hypot(edge.second.first - edge.first.first, edge.second.second - edge.first.second) * std::abs(times);
  return sum;
}

double perimeter(const std::vector<P2>& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) sum += irg::length(ring[(k + 1) % ring.size()] - ring[k]);
  return sum;
}

}  // namespace

TEST_CASE("tessellate_trimmed: a star with a hole, covered once, without cracks, within the tolerance") {
  test::random r(61);
  for (int trial = 0; trial < 25; ++trial) {
    const auto points = random_net(r);
    const std::vector<std::vector<P2>> rings{star(r, {0.5, 0.5}, 0.5, 17), star(r, {0.5, 0.5}, 0.15, 7)};
    const auto t = run(points, rings, 0.003);
    REQUIRE(t.done);
    CHECK(t.done->within_tolerance);
    CHECK(t.farthest <= 0.003);
    CHECK(t.one_point_each);
    const double area = std::abs(irg::polygon_area(rings[0])) - std::abs(irg::polygon_area(rings[1]));
    CHECK(std::abs(t.area) == doctest::Approx(area).epsilon(1e-12));
    CHECK(open_length(t) == doctest::Approx(perimeter(rings[0]) + perimeter(rings[1])).epsilon(1e-12));
  }
}

TEST_CASE("tessellate_trimmed: corners on lines of cells, parts outside, nothing left") {
  test::random r(62);
  const auto points = random_net(r);
  const std::vector<P2> diamond{{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}};
  const auto whole = run(points, diamond, 0.01);
  CHECK(whole.area == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(open_length(whole) == doctest::Approx(4 * std::sqrt(0.5)).epsilon(1e-14));
  const std::vector<P2> beyond{{-1, -1}, {0.5, -1}, {0.5, 3}, {-1, 3}};
  CHECK(run(points, beyond, 0.01).area == doctest::Approx(0.5).epsilon(1e-14));
  const std::vector<P2> outside{{2, 2}, {3, 2}, {3, 3}};
  CHECK(run(points, outside, 0.01).done == irg::surface_tessellation{});
  CHECK(run(points, std::vector<P2>{{0, 0}, {1, 1}}, 0.01).done == irg::surface_tessellation{});
}

TEST_CASE("tessellate_trimmed: a polygon whose sides are longer than the largest number") {
  test::random r(8);
  const std::vector<P3> net = random_net(r);
  for (const double far : {1e300, 1.7e308}) {
    const trimmed t = run(net, std::vector<P2>{{-far, -far}, {far, -far}, {far, far}, {-far, far}}, 0.25);
    CHECK(t.done.has_value());
    CHECK(std::fabs(t.area - 1) < 1e-14);
  }
}

TEST_CASE("tessellate_trimmed: refused") {
  test::random r(63);
  const auto points = random_net(r);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(!run(points, std::vector<P2>{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 0.01).done);  // crosses itself
  CHECK(!run(points, std::vector<P2>{{0, 0}, {1, none}, {1, 0}}, 0.01).done);
  const std::vector<irg::point<float, 3>> single{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
  const irg::control_net<irg::point<float, 3>> net{single, 2};
  const auto ignore = [](const auto&, const auto&, const auto&) {};
  CHECK(irg::tessellate_trimmed(net, std::vector<P2>{{0, 0}, {1e30, 0}, {0, 1e30}}, 1, ignore));
  CHECK(!irg::tessellate_trimmed(net, std::vector<P2>{{0, 0}, {1e300, 0}, {0, 1e300}}, 1, ignore));  // no float
  auto bad = points;
  bad[3].x = none;
  CHECK(run(bad, std::vector<P2>{{0, 0}, {1, 0}, {1, 1}}, 0.01).done == irg::surface_tessellation{0, 0, false});
}

TEST_CASE("tessellate_trimmed: a net of one row or column is no surface") {
  const std::vector<P3> curve{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}};
  const std::vector<P2> slanted{{0.1, 0.1}, {0.5, 0.2}, {0.3, 0.9}};
  const auto ignore = [](const auto&, const auto&, const auto&) {};
  for (const std::size_t columns : {1u, 4u})
    CHECK(irg::tessellate_trimmed(irg::control_net<P3>{curve, columns}, slanted, 10, ignore) ==
          irg::surface_tessellation{});
}

TEST_CASE("tessellate_trimmed: in constant evaluation") {
  constexpr auto count = [] {
    constexpr std::array<P3, 4> square{P3{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    constexpr std::array<P2, 3> half{P2{0, 0}, {1, 0}, {1, 1}};
    return *irg::tessellate_trimmed(irg::control_net<P3>{square, 2}, half, 0.1,
                                    [](const auto&, const auto&, const auto&) {});
  };
  CHECK_BOTH(count() == irg::surface_tessellation{3, 1, true});
}
