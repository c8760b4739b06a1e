// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/polygon.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/geometry/edge_equation.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"

namespace {

using irg::orientation;
using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};  // the course's values

TEST_CASE("orientation_of: degenerate polygons") {
  using V = std::vector<I>;
  CHECK_BOTH(irg::orientation_of(V{}) == orientation::degenerate);
  CHECK_BOTH(irg::orientation_of(V{{1, 2}}) == orientation::degenerate);
  CHECK_BOTH(irg::orientation_of(V{{1, 2}, {3, 4}}) == orientation::degenerate);
  CHECK_BOTH(irg::orientation_of(V{{0, 0}, {3, 1}, {9, 3}, {6, 2}}) == orientation::degenerate);
  CHECK_BOTH(irg::orientation_of(V{{0, 0}, {4, 4}, {4, 0}, {0, 4}}) == orientation::degenerate);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double odd : {nan, inf, -inf})
    for (std::size_t i = 0; i < 4; ++i)
      for (const bool upright : {false, true}) {
        auto ring = course;
        (upright ? ring[i].y : ring[i].x) = odd;
        CHECK(irg::orientation_of(ring) == orientation::degenerate);
      }
}

TEST_CASE("make_counter_clockwise: the course's values, the reversed list and its edges") {
  static constexpr auto repaired = [] {
    auto ring = course;
    return std::pair{irg::make_counter_clockwise(ring), ring};
  };
  CHECK_BOTH(repaired().first == orientation::clockwise);
  CHECK_BOTH(repaired().second == std::array<P, 4>{P{50, 200}, P{100, 50}, P{300, 150}, P{150, 350}});
  CHECK_BOTH(irg::orientation_of(repaired().second) == orientation::counter_clockwise);
  CHECK_BOTH(irg::textbook::orientation_of(repaired().second) == orientation::counter_clockwise);
  constexpr auto again = [] {
    auto ring = repaired().second;
    return std::pair{irg::make_counter_clockwise(ring), ring};
  };
  CHECK_BOTH(again().first == orientation::counter_clockwise);
  CHECK_BOTH(again().second == repaired().second);
  // the values of criterion 3.2 on the reversed list: 55000 42500 22500 35000
  const auto ring = repaired().second;
  std::vector<double> values;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto e = irg::edge_through(irg::ring_vertex(ring, i), irg::ring_vertex(ring, i + 1));
    const P p = irg::ring_vertex(ring, i + 2);
    values.push_back(e.a * p.x + e.b * p.y + e.c);
  }
  std::sort(values.begin(), values.end());
  CHECK(values == std::vector<double>{22500, 35000, 42500, 55000});
}

TEST_CASE("views: reversed and counter-clockwise, of every size") {
  for (int n = 0; n <= 6; ++n) {
    std::vector<I> ring;
    for (int i = 0; i < n; ++i) ring.push_back({i, i * i});
    const auto back = irg::reversed_ring(ring);
    static_assert(irg::PlaneRing<decltype(back)>);
    auto copy = ring;
    irg::reverse_ring(copy);
    REQUIRE(back.size() == copy.size());
    for (std::size_t i = 0; i < copy.size(); ++i) {
      CHECK(back[i] == copy[i]);
      CHECK(irg::counter_clockwise_ring(copy)[i] == (n < 3 ? copy : ring)[i]);
      CHECK(irg::counter_clockwise_ring(ring)[i] == ring[i]);
    }
    irg::reverse_ring(copy);
    CHECK(copy == ring);
  }
}

TEST_CASE("orientation_of: 64-bit integers at their limits") {
  using L = irg::point<std::int64_t, 2>;
  constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max(),
                         low = std::numeric_limits<std::int64_t>::min();
  CHECK_BOTH(irg::orientation_of(std::array{L{low, low}, L{high, low}, L{high, high}, L{low, high}}) ==
             orientation::counter_clockwise);
  CHECK_BOTH(irg::orientation_of(std::array{L{low, low}, L{high - 1, high}, L{high, high}}) == orientation::clockwise);
  CHECK_BOTH(irg::orientation_of(std::array{L{low, low}, L{0, 0}, L{high, high}}) == orientation::degenerate);
}

}  // namespace
