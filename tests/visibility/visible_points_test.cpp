// SPDX-License-Identifier: MIT
#include <irg/visibility/visible_points.hpp>

#include <array>
#include <limits>
#include <vector>

#include <irg/geometry/orient2d.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 2>;
constexpr std::nullopt_t none = std::nullopt;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

TEST_CASE("see_on_line: neighbours on both sides, equal points, ends, none") {
  static constexpr std::array<int, 5> line{-3, 1, 1, 4, 9};
  constexpr auto see = [](int viewer) { return irg::see_on_line(std::span<const int>(line), viewer); };
  CHECK_BOTH(see(2) == irg::line_neighbours{2, 3, 0});
  CHECK_BOTH(see(1) == irg::line_neighbours{0, 3, 2});
  CHECK_BOTH(see(-9) == irg::line_neighbours{none, 0, 0});
  CHECK_BOTH(see(10) == irg::line_neighbours{4, none, 0});
  CHECK_BOTH(irg::see_on_line(std::span<const double>(), 1.0) == irg::line_neighbours{});
  static constexpr std::array<double, 2> two{0, 1};
  CHECK_BOTH(irg::see_on_line(std::span<const double>(two), nan) == irg::line_neighbours{});
}

TEST_CASE("visible_points: the nearest on each ray, against all pairs") {
  test::random r(61);
  for (int round = 0; round < 100; ++round) {
    const double s = round % 4 == 0 ? 1 : round % 4 == 1 ? 0x1p-1070 : round % 4 == 2 ? 0x1p1020 : 0.1;
    std::vector<P> points;
    const auto place = [&] {
      return P{static_cast<double>(r.integer(-4, 4)) * s, static_cast<double>(r.integer(-4, 4)) * s};
    };
    for (int i = 0; i < 40; ++i) points.push_back(place());
    const P viewer = place();
    const auto seen = irg::visible_points(std::span<const P>(points), viewer);
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool expected = true;
      for (const P& q : points) {  // before p on its ray: between viewer and p
        const P& p = points[i];
        const auto between = [](double a, double b, double c) { return (a <= b && b <= c) || (c <= b && b <= a); };
        if (q == p || q == viewer || irg::orient2d(viewer, p, q) != 0) continue;
        expected = expected && !(between(viewer.x, q.x, p.x) && between(viewer.y, q.y, p.y));
      }
      CHECK((seen[i] != 0) == expected);
    }
  }
}

TEST_CASE("visible_points: places that are none") {
  const std::vector<P> points{{1, 1}, {nan, 0}, {2, 2}, {infinite, infinite}, {0, 0}};
  CHECK(irg::visible_points(std::span<const P>(points), P{0, 0}) == std::vector<std::uint8_t>{1, 0, 0, 0, 1});
  CHECK(irg::visible_points(std::span<const P>(points), P{nan, 0}) == std::vector<std::uint8_t>(5, 0));
  CHECK(irg::visible_points(std::span<const P>(), P{0, 0}).empty());
}

}  // namespace
