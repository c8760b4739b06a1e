// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/polygon.hpp>

#include <array>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::location;
using irg::orientation;

namespace {

using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};  // the course's values

}  // namespace

TEST_CASE("textbook::polygon_area: the course's values, holes, rationals") {
  CHECK_BOTH(irg::textbook::polygon_area(course) == -38750);
  const std::vector<std::vector<P>> frame{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}};
  CHECK(irg::textbook::polygon_area(frame) == 72);
  using Q = irg::point<test::rational, 2>;
  CHECK(irg::textbook::polygon_area(std::array{Q{0, 0}, Q{{1, 3}, 0}, Q{0, {1, 5}}}) == test::rational{1, 30});
  // Far from the origin nothing is left of it.
  constexpr double f = 0x1p53;
  CHECK_BOTH(irg::textbook::polygon_area(std::array{P{f, f}, P{f + 2, f}, P{f + 2, f + 2}}) == 0);
  CHECK_BOTH(irg::polygon_area(std::array{P{f, f}, P{f + 2, f}, P{f + 2, f + 2}}) == 2);
}

TEST_CASE("textbook::orientation_of: three vertices at a time") {
  using V = std::vector<I>;
  // A pentagram turns one way at every vertex, whichever way round its corners lie.
  CHECK_BOTH(irg::textbook::orientation_of(V{{10, 0}, {-8, 6}, {3, -10}, {3, 10}, {-8, -6}}) ==
             orientation::counter_clockwise);
  CHECK_BOTH(irg::textbook::orientation_of(V{{-8, -6}, {3, 10}, {3, -10}, {-8, 6}, {10, 0}}) == orientation::clockwise);
  CHECK_BOTH(irg::textbook::orientation_of(V{{0, 0}, {4, 0}, {2, 1}, {4, 4}, {0, 4}}) == orientation::degenerate);
  CHECK_BOTH(irg::textbook::orientation_of(V{{0, 0}, {2, 0}, {4, 0}, {4, 4}}) == orientation::degenerate);
}

TEST_CASE("textbook::point_in_convex_polygon: the course's values, and what its rules do not ask for") {
  const struct {
    P p;
    location where;
  } cases[] = {{{150, 200}, location::inside},    {{100, 275}, location::boundary}, {{50, 200}, location::boundary},
               {{300, 350}, location::outside},   {{200, 100}, location::boundary}, {{0, 0}, location::outside},
               {{200.5, 100}, location::outside}, {{199.5, 100}, location::inside}};
  for (const auto& [p, where] : cases) CHECK(irg::textbook::point_in_convex_polygon(course, p) == where);
  CHECK_BOTH(irg::textbook::point_in_convex_polygon(course, {100, 275}) == location::boundary);
  CHECK_BOTH(irg::textbook::point_in_convex_polygon(course, {150, std::numeric_limits<double>::quiet_NaN()}) ==
             location::outside);
  CHECK_BOTH(irg::textbook::point_in_convex_polygon(course, {-std::numeric_limits<double>::infinity(), 200}) ==
             location::outside);
  constexpr std::array<P, 5> repeated{P{50, 200}, P{150, 350}, P{150, 350}, P{300, 150}, P{100, 50}};
  CHECK_BOTH(irg::textbook::point_in_convex_polygon(repeated, {150, 200}) == location::boundary);
}
