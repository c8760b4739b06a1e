// SPDX-License-Identifier: MIT
#include <irg/geometry/convex_hull.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/geometry/polygon_convexity.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
using indices = std::vector<std::uint32_t>;
using irg::side_points;
__extension__ typedef __int128 wide;

// Twice the area of a, b, c for coordinates k * 2^-53, in integers.
template <class Q>
wide cross(const Q& a, const Q& b, const Q& c, double scale = 1) {
  const auto whole = [&](auto v) { return wide{static_cast<std::int64_t>(static_cast<double>(v) * scale)}; };
  return (whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y)) - (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x));
}

// The hull by Jarvis' march: from each corner on to the farthest point that has no other on its right; an oracle that
// sorts no chains.
template <class Q>
indices corners_of(const std::vector<Q>& points, double scale) {
  const auto n = static_cast<std::uint32_t>(points.size());
  const auto less = [](const Q& a, const Q& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  indices hull;
  if (n == 0) return hull;
  std::uint32_t start = 0;
  for (std::uint32_t i = 0; i < n; ++i)
    if (less(points[i], points[start])) start = i;
  std::uint32_t at = start;
  do {
    hull.push_back(at);
    std::uint32_t next = at;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (points[i] == points[at]) continue;
      const wide turn = next == at ? wide{-1} : cross(points[at], points[next], points[i], scale);
      const bool beyond = less(points[next], points[i]) == less(points[at], points[next]);
      if (turn < 0 || (turn == 0 && beyond && !(points[i] == points[next]))) next = i;
    }
    at = next;
  } while (!(points[at] == points[start]) && hull.size() <= n);
  return hull;
}

// And the points on its sides, each side's in their order.
template <class Q>
indices sides_of(const std::vector<Q>& points, const indices& corners, double scale) {
  const auto between = [](auto a, auto b, auto v) { return std::min(a, b) <= v && v <= std::max(a, b); };
  indices all;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Q &a = points[corners[k]], &b = points[corners[(k + 1) % corners.size()]];
    all.push_back(corners[k]);
    if (corners.size() == 1 || (corners.size() == 2 && k == 1)) continue;
    indices side;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Q& p = points[i];
      if (p == a || p == b || cross(a, b, p, scale) != 0 || !between(a.x, b.x, p.x) || !between(a.y, b.y, p.y))
        continue;
      if (std::none_of(side.begin(), side.end(), [&](std::uint32_t j) { return points[j] == p; })) side.push_back(i);
    }
    std::sort(side.begin(), side.end(), [&](std::uint32_t i, std::uint32_t j) {
      return std::fabs(points[i].x - a.x) + std::fabs(points[i].y - a.y) <
             std::fabs(points[j].x - a.x) + std::fabs(points[j].y - a.y);
    });
    all.insert(all.end(), side.begin(), side.end());
  }
  return all;
}

TEST_CASE("convex_hull: by hand") {
  const std::vector<I> square{{2, 2}, {0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {4, 2}, {2, 4}, {0, 2}, {1, 1}, {0, 0}};
  CHECK(irg::convex_hull(square) == indices{1, 2, 3, 4});
  CHECK(irg::convex_hull(square, side_points::keep) == indices{1, 5, 2, 6, 3, 7, 4, 8});
  constexpr auto digits = [](side_points option) {
    constexpr std::array<I, 6> points{I{3, 1}, I{0, 0}, I{1, 1}, I{2, 2}, I{0, 2}, I{1, 1}};
    std::array<std::uint32_t, 6> hull{};
    const std::size_t size = irg::convex_hull(points, std::span<std::uint32_t>(hull), option);
    int value = 0;
    for (std::size_t i = 0; i < size; ++i) value = 10 * value + static_cast<int>(hull[i]);
    return value;
  };
  CHECK_BOTH(digits(side_points::leave_out) == 1034);
  CHECK_BOTH(digits(side_points::keep) == 1034);
}

TEST_CASE("convex_hull: nothing, one place, a line, no numbers") {
  using V = std::vector<I>;
  for (const side_points option : {side_points::leave_out, side_points::keep}) {
    CHECK(irg::convex_hull(V{}, option).empty());
    CHECK(irg::convex_hull(V{{7, 7}}, option) == indices{0});
    CHECK(irg::convex_hull(V{{7, 7}, {7, 7}, {7, 7}}, option) == indices{0});
    CHECK(irg::convex_hull(V{{7, 7}, {3, 3}}, option) == indices{1, 0});
    CHECK(irg::convex_hull(V{{1, 5}, {1, 3}, {1, 5}, {1, 3}}, option) == indices{1, 0});
  }
  const V line{{2, 4}, {0, 0}, {3, 6}, {1, 2}, {0, 0}, {3, 6}};
  CHECK(irg::convex_hull(line) == indices{1, 2});
  CHECK(irg::convex_hull(line, side_points::keep) == indices{1, 3, 0, 2});
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK(irg::convex_hull(std::vector<P>{{0, 0}, {1, bad}, {bad, 1}, {1, 0}}).empty());
}

TEST_CASE("convex_hull: random lattice points and neighbouring doubles, against Jarvis' march") {
  test::random random(61);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 300'000 : 8000;
  std::size_t corners = 0, sides = 0;
  for (int t = 0; t < trials; ++t) {
    const auto n = static_cast<std::size_t>(random.integer(0, t % 10 == 0 ? 40 : 9));
    const auto extent = random.integer(1, 6);
    std::vector<P> points;
    while (points.size() < n) {
      if (t % 2 == 0) {
        const double x = static_cast<double>(random.integer(0, extent));
        points.push_back({x, static_cast<double>(random.integer(0, extent))});
      } else {  // neighbours of the points of a line
        const double at = static_cast<double>(random.integer(-8, 8)) / 2;
        const double x = at + static_cast<double>(random.integer(-2, 2)) * 0x1p-50;
        points.push_back({x, at + static_cast<double>(random.integer(-2, 2)) * 0x1p-50});
      }
    }
    const auto hull = irg::convex_hull(points);
    REQUIRE(hull == corners_of(points, 0x1p50));
    const auto all = irg::convex_hull(points, side_points::keep);
    REQUIRE(all == sides_of(points, hull, 0x1p50));
    corners += hull.size();
    sides += all.size() - hull.size();
    for (const double scale : {0x1p-1000, 0x1p900}) {  // every exponent alike
      auto scaled = points;
      for (P& p : scaled) p = {p.x * scale, p.y * scale};
      if (t % 2 == 1 && scale < 1) continue;  // the lowest bits would be lost
      REQUIRE(irg::convex_hull(scaled) == hull);
      REQUIRE(irg::convex_hull(scaled, side_points::keep) == all);
    }
  }
  MESSAGE(trials, " sets, ", corners, " corners, ", sides, " side points");
  CHECK(sides > 1000);
}

TEST_CASE("convex_hull: a million points; rationals; the limits of doubles and integers") {
  test::random random(62);
  std::vector<P> points;
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = random.unit();
    points.push_back({x, random.unit()});
  }
  const auto hull = irg::convex_hull(points);
  std::vector<P> ring;
  for (const auto i : hull) ring.push_back(points[i]);
  CHECK(irg::is_convex(ring));
  long outside = 0;
  for (std::size_t i = 0; i < points.size(); i += 101)
    for (std::size_t k = 0; k < ring.size(); ++k)
      outside += irg::orient2d(ring[k], ring[(k + 1) % ring.size()], points[i]) < 0;
  CHECK(outside == 0);
  MESSAGE(hull.size(), " corners of 1000000 points");

  using Q = irg::point<test::rational, 2>;
  const std::vector<Q> thirds{{{1, 3}, {1, 3}}, {0, 0}, {{2, 3}, 0}, {{1, 3}, {1, 6}}, {0, {2, 3}}};
  CHECK(irg::convex_hull(thirds) == indices{1, 2, 4});
  CHECK(irg::convex_hull(thirds, side_points::keep) == indices{1, 2, 0, 4});
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK(irg::convex_hull(std::vector<P>{{most, most}, {-most, -most}, {0, 0}, {least, 0}, {-least, 0}}) ==
        indices{1, 3, 0, 4});
  using L = irg::point<std::int64_t, 2>;
  constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max(),
                         low = std::numeric_limits<std::int64_t>::min();
  CHECK(irg::convex_hull(std::vector<L>{{high, high}, {low, low}, {0, 0}, {0, 1}, {0, -1}}) == indices{1, 4, 0, 3});
}

}  // namespace
