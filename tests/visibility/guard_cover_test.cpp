// SPDX-License-Identifier: MIT
#include <irg/visibility/guard_cover.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <irg/geometry/point_in_polygon.hpp>
#include <irg/visibility/sight_line.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::guard_status;
using place = irg::point<double, 2>;
using plan = std::vector<std::vector<place>>;

constexpr irg::guard_cover<double> guarded(const plan& rings) {
  return irg::cover_by_guards(std::span<const std::vector<place>>(rings));
}

// A comb of teeth, each of which needs a guard of its own.
constexpr plan comb(int teeth) {
  plan p(1, std::vector<place>{{0, 0}, {4.0 * teeth, 0}, {4.0 * teeth, 1}});
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = 4.0 * i + 1, right = left + 1;
    p[0].insert(p[0].end(), {{right, 1}, {right, 20}, {left, 20}, {left, 1}});
  }
  p[0].push_back({0, 1});
  return p;
}

constexpr bool one_room() {
  const auto c = guarded({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
  return c && c.status == guard_status::ok && c.guards.size() == 1 && c.at_least == 1 && c.parts.size() == 1;
}
constexpr bool degenerate() {
  return guarded({}).guards.empty() && guarded({{}, {{1, 1}}, {{2, 2}, {2, 2}}}).guards.empty() &&
         !guarded({{{0, 0}, {1, 1}, {2, 2}}}) &&
         guarded({{{0, 0}, {1, 1}, {2, 2}}}).status == guard_status::rings_cross &&
         guarded({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}).status == guard_status::rings_cross;
}
static_assert(one_room() && degenerate());

TEST_CASE("cover_by_guards: rooms, nothing, rings that cross, all sizes") {
  CHECK(one_room());
  CHECK(degenerate());
  CHECK(guarded({{{0, 0}, {1, 0}, {std::numeric_limits<double>::infinity(), 1}}}).status == guard_status::not_finite);
}

TEST_CASE("cover_by_guards: each tooth of a comb needs a guard") {
  for (int teeth = 2; teeth <= 4; ++teeth) {
    const auto c = guarded(comb(teeth));
    CHECK(c.guards.size() == static_cast<std::size_t>(teeth));
    CHECK(c.at_least == static_cast<std::size_t>(teeth));
  }
}

double twice_area_of(const std::vector<place>& r) {
  double sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const place &a = r[i], &b = r[(i + 1) % r.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

TEST_CASE("cover_by_guards: rings that touch, whichever way they run; a room in a hole") {
  const std::vector<place> square{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, on_edge{{0, 4}, {2, 3}, {2, 5}},
      on_corner{{8, 8}, {6, 7}, {7, 6}}, well{{3, 3}, {3, 6}, {6, 6}, {6, 3}}, room{{4, 4}, {4, 5}, {5, 5}, {5, 4}};
  for (int flip = 0; flip < 2; ++flip) {
    plan p{square, on_edge, on_corner, well, room};
    if (flip == 1)
      for (auto& r : p) std::reverse(r.begin(), r.end());
    const auto c = guarded(p);
    CHECK(c.status == guard_status::ok);
    CHECK(c.guards.size() >= c.at_least);
    CHECK(c.at_least >= 2);
    double area = 0;
    for (const auto& part : c.parts) area += twice_area_of(part.ring);
    CHECK(std::fabs(area / 2 - (64 - 2 - 1.5 - 9 + 1)) < 1e-9);
  }
}

TEST_CASE("cover_by_guards: rings may touch in a corner, but not cross there") {
  const std::vector<place> through_wall{{0, -1}, {0, 3}, {1, 1}, {0, 0}, {-3, -1}, {0, -3}};
  const std::vector<place> beside_wall{{0, -3}, {0, 3}, {-3, 1}, {0, 0}, {-3, -1}};  // two rooms
  const std::vector<place> through_corner{{0, 0}, {3, 1}, {3, -1}, {0, 0}, {1, 3}, {4, 0}, {1, -3}};
  const std::vector<place> beside_corner{{0, 0}, {3, -1}, {3, 1}, {0, 0}, {-1, 3}, {-1, -3}};
  for (int flip = 0; flip < 2; ++flip) {
    const auto status_of = [flip](std::vector<place> ring) {
      if (flip == 1) std::reverse(ring.begin(), ring.end());
      return guarded({ring}).status;
    };
    CHECK(status_of(through_wall) == guard_status::rings_cross);
    CHECK(status_of(beside_wall) == guard_status::ok);
    CHECK(status_of(through_corner) == guard_status::rings_cross);
    CHECK(status_of(beside_corner) == guard_status::ok);
  }
  // Two rings through each other in two corners of one, on walls of the other.
  CHECK(guarded({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{4, 1}, {6, 2}, {4, 3}, {2, 2}}}).status ==
        guard_status::rings_cross);
  CHECK(guarded({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{4, 1}, {6, 2}, {4, 3}, {5, 2}}}).status == guard_status::ok);
}

// What lies behind a wall that a hole touches is not in the plan, though it sees the hole's corner.
TEST_CASE("cover_by_guards: holes that touch each wall") {
  const plan p{{{0, 0}, {8, 0}, {8, 8}, {0, 8}},
               {{4, 0}, {3, 1}, {5, 1}},
               {{8, 4}, {7, 3}, {7, 5}},
               {{4, 8}, {3, 7}, {5, 7}},
               {{0, 4}, {1, 3}, {1, 5}}};
  const auto c = guarded(p);
  double area = 0;
  for (const auto& part : c.parts) area += twice_area_of(part.ring);
  CHECK(std::fabs(area / 2 - 60) < 1e-9);
}

double area_of(const irg::guard_cover<double>& c) {
  double area = 0;
  for (const auto& part : c.parts) area += twice_area_of(part.ring) / 2;
  return area;
}

TEST_CASE("cover_by_guards: all corners of a ring touch another one, from inside or outside") {
  const std::vector<place> square{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, diamond{{4, 0}, {8, 4}, {4, 8}, {0, 4}},
      star{{0, 0}, {4, 3}, {8, 0}, {5, 4}, {8, 8}, {4, 5}, {0, 8}, {3, 4}},
      notched{{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 4}, {2, 4}, {2, 8}, {0, 8}}, guest{{2, 6}, {4, 4}, {6, 6}};
  const auto four = guarded({square, diamond});
  CHECK(area_of(four) == 32);
  CHECK(four.at_least == 2);
  CHECK(guarded({diamond, square}).parts.size() == four.parts.size());
  CHECK(std::fabs(area_of(guarded({square, star})) - 48) < 1e-9);
  CHECK(std::fabs(area_of(guarded({notched, guest})) - (48 + 4)) < 1e-9);
}

TEST_CASE("cover_by_guards: one guard where rooms touch in a corner of both, or a corner touches a wall") {
  const std::vector<place> room{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, corner_to_corner{{4, 4}, {8, 4}, {8, 8}, {4, 8}},
      corner_to_wall{{4, 2}, {8, 0}, {8, 4}};
  const auto both = guarded({room, corner_to_corner});
  CHECK(both.guards == std::vector<std::size_t>{2});
  CHECK(both.at_least == 1);
  CHECK(area_of(both) == 32);
  const auto beside = guarded({room, corner_to_wall});
  CHECK(beside.guards == std::vector<std::size_t>{4});
  CHECK(area_of(beside) == 24);
}

// Powers of two stretch the plane without rounding: all comes out the same, stretched.
TEST_CASE("cover_by_guards: plans of all sizes, and such as are much wider than high") {
  const plan p = {{{0, 0}, {8, 0}, {8, 4}, {4, 4}, {5, 8}, {0, 7}}, {{6, 3}, {5, 2}, {7, 2}}};
  const auto want = guarded(p);
  CHECK(want.guards.size() >= want.at_least);
  for (const int ex : {-1000, -500, 0, 500, 1000})
    for (const int ey : {-1000, 0, 1000}) {
      const auto stretched = [&](const place& q) { return place{std::ldexp(q.x, ex), std::ldexp(q.y, ey)}; };
      plan t = p;
      for (auto& ring : t)
        for (place& q : ring) q = stretched(q);
      auto expected = want;
      for (auto& part : expected.parts)
        for (place& q : part.ring) q = stretched(q);
      CHECK(guarded(t) == expected);
    }
}

// A ring round the origin with a corner in each of n directions, and perhaps a hole.
plan random_plan(test::random& r, int n) {
  plan p(1);
  for (int i = 0; i < n; ++i) {
    const double turn = 2 * 3.14159 * i / n, far_off = static_cast<double>(r.integer(4, 20)) / 4;
    p[0].push_back({std::round(far_off * 16 * std::cos(turn)) / 16, std::round(far_off * 16 * std::sin(turn)) / 16});
  }
  if (r.integer(0, 1) == 0) p.push_back({{0.25, 0}, {-0.25, 0.125}, {0, -0.25}});
  if (r.integer(0, 1) == 0) std::reverse(p[0].begin(), p[0].end());
  return p;
}

TEST_CASE("cover_by_guards: every place is seen by a guard, and each part by its own") {
  test::random r(3);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 20 : 1;
  int unseen = 0, wrong = 0, more = 0;
  for (int i = 0; i < 12 * times; ++i) {
    const plan p = random_plan(r, 5 + i % 6);
    const auto c = guarded(p);
    REQUIRE(c.status == guard_status::ok);
    std::vector<place> corners;
    std::vector<irg::segment<double, 2>> walls;
    for (const auto& ring : p)
      for (std::size_t k = 0; k < ring.size(); ++k) {
        corners.push_back(ring[k]);
        walls.push_back({ring[k], ring[(k + 1) % ring.size()]});
      }
    for (int k = 0; k < 200; ++k) {
      const double x = 10 * r.unit() - 5, y = 10 * r.unit() - 5;
      if (irg::point_in_polygon(p, place{x, y}, irg::fill_rule::even_odd) != irg::location::inside) continue;
      bool seen = false;
      for (const std::size_t g : c.guards) seen = seen || irg::has_line_of_sight(place{x, y}, corners[g], walls);
      unseen += !seen;
      for (const auto& part : c.parts)
        if (irg::point_in_polygon(part.ring, place{x, y}) == irg::location::inside)
          wrong += !irg::has_line_of_sight(place{x, y}, corners[part.guard], walls);
    }
    double area = 0, whole = std::fabs(twice_area_of(p[0]));
    for (const auto& part : c.parts) area += twice_area_of(part.ring);
    if (p.size() > 1) whole -= std::fabs(twice_area_of(p[1]));
    wrong += std::fabs(area - whole) > 1e-9;
    more += c.guards.size() < c.at_least;
  }
  CHECK(unseen == 0);
  CHECK(wrong == 0);
  CHECK(more == 0);
}

}  // namespace
