// SPDX-License-Identifier: MIT
#include <irg/geometry/point_in_polygon.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::fill_rule;
using irg::location;
using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};  // the course's values

constexpr std::array<I, 5> pentagram{I{0, 1000}, I{588, -809}, I{-951, 309}, I{951, 309}, I{-588, -809}};

template <class R>
constexpr R turned_round(R ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

TEST_CASE("locate_point: the course's values") {
  CHECK_BOTH(irg::locate_point(course, {150, 200}) == location::inside);
  CHECK_BOTH(irg::locate_point(course, {100, 275}) == location::boundary);
  CHECK_BOTH(irg::locate_point(course, {50, 200}) == location::boundary);
  CHECK_BOTH(irg::locate_point(course, {300, 350}) == location::outside);
  CHECK_BOTH(irg::locate_point(course, {200, 100}) == location::boundary);
  CHECK_BOTH(irg::locate_point(course, {0, 0}) == location::outside);
  CHECK_BOTH(irg::locate_point(course, {200.5, 100}) == location::outside);
  CHECK_BOTH(irg::locate_point(course, {199.5, 100}) == location::inside);
  CHECK_BOTH(irg::locate_point(turned_round(course), {150, 200}) == location::inside);
  CHECK_BOTH(irg::locate_point(pentagram, {0, 0}) == location::inside);  // wound twice
  CHECK_BOTH(irg::locate_point(pentagram, {0, 1000}) == location::boundary);
  CHECK_BOTH(irg::locate_point(pentagram, {0, 309}) == location::boundary);
  CHECK_BOTH(irg::locate_point(pentagram, {0, -700}) == location::outside);
}

TEST_CASE("locate_point: degenerate polygons are their own boundary") {
  using V = std::vector<I>;
  CHECK_BOTH(irg::locate_point(V{}, {0, 0}) == location::outside);
  CHECK_BOTH(irg::locate_point(V{{1, 2}}, {1, 2}) == location::boundary);
  CHECK_BOTH(irg::locate_point(V{{1, 2}}, {1, 3}) == location::outside);
  CHECK_BOTH(irg::locate_point(V{{0, 0}, {4, 2}}, {2, 1}) == location::boundary);
  CHECK_BOTH(irg::locate_point(V{{0, 0}, {4, 2}}, {6, 3}) == location::outside);
  CHECK_BOTH(irg::locate_point(V{{0, 0}, {4, 0}}, {6, 0}) == location::outside);
}

TEST_CASE("locate_point: any polygon, against the angles of the rational crossings") {
  test::random random(32);
  long inside = 0, boundary = 0;
  for (int t = 0; t < 20000; ++t) {
    std::vector<I> ring(static_cast<std::size_t>(random.integer(1, 9)), I{0, 0});
    const auto vertex = [&] {
      const int x = static_cast<int>(random.integer(-4, 4));
      return I{x, static_cast<int>(random.integer(-4, 4))};
    };
    for (I& v : ring) v = vertex();
    const I p = vertex();
    // The winding number by a ray to the right that is lifted a little: each crossing's x compared as a fraction.
    int winding = 0;
    bool on = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      I a = ring[i], b = ring[(i + 1) % ring.size()];
      const int cross = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      const int along = (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y);
      on = on || (cross == 0 && along <= 0);
      const int direction = a.y < b.y ? 1 : -1;
      if (direction < 0) std::swap(a, b);
      if (!(a.y <= p.y && p.y < b.y)) continue;
      const test::rational x = test::rational(a.x) + test::rational((p.y - a.y) * (b.x - a.x), b.y - a.y);
      if (test::rational(p.x) < x) winding += direction;
    }
    const auto expected = on ? location::boundary : winding ? location::inside : location::outside;
    REQUIRE(irg::locate_point(ring, p) == expected);
    REQUIRE(irg::winding_number(ring, p) == (on ? std::nullopt : std::optional(winding)));
    const auto odd = on ? location::boundary : winding % 2 ? location::inside : location::outside;
    REQUIRE(irg::point_in_polygon(ring, p, fill_rule::even_odd) == odd);
    REQUIRE(irg::point_in_polygon(std::vector{ring}, p, fill_rule::even_odd) == odd);
    // two rings: the windings add up, and so do the boundaries
    const auto twice = irg::winding_number(std::vector{ring, ring}, p);
    REQUIRE(twice == (on ? std::nullopt : std::optional(2 * winding)));
    inside += expected == location::inside;
    boundary += on;
  }
  CHECK(inside > 500);
  CHECK(boundary > 500);
}

TEST_CASE("point_in_polygon: self-touching, bow-tie, pentagram, holes that share an edge or a vertex") {
  using V = std::vector<I>;
  const auto where = [](const auto& polygon, I p, fill_rule rule) { return irg::point_in_polygon(polygon, p, rule); };
  for (const fill_rule rule : {fill_rule::even_odd, fill_rule::non_zero}) {
    // two triangles that touch at (2, 2)
    const V touching{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}};
    CHECK(where(touching, {2, 2}, rule) == location::boundary);
    CHECK(where(touching, {1, 2}, rule) == location::inside);
    CHECK(where(touching, {2, 1}, rule) == location::outside);
    // a hole that shares an edge, and one that shares a vertex
    const std::vector<V> at_edge{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{0, 3}, {0, 6}, {3, 6}, {3, 3}}};
    CHECK(where(at_edge, {0, 4}, rule) == location::boundary);
    CHECK(where(at_edge, {1, 4}, rule) == location::outside);
    CHECK(where(at_edge, {4, 4}, rule) == location::inside);
    CHECK(where(at_edge, {1, 3}, rule) == location::boundary);
    const std::vector<V> at_vertex{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{0, 0}, {1, 4}, {4, 1}}};
    CHECK(where(at_vertex, {0, 0}, rule) == location::boundary);
    CHECK(where(at_vertex, {2, 2}, rule) == location::outside);
    CHECK(where(at_vertex, {3, 3}, rule) == location::inside);
    CHECK(where(at_vertex, {0, 4}, rule) == location::boundary);
  }
  const V bow_tie{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  CHECK(irg::winding_number(bow_tie, {1, 2}) == 1);
  CHECK(irg::winding_number(bow_tie, {3, 2}) == -1);
  CHECK(irg::winding_number(bow_tie, {2, 2}) == std::nullopt);
  CHECK(irg::winding_number(bow_tie, {2, 3}) == 0);
  CHECK(irg::winding_number(pentagram, {0, 0}) == -2);
  CHECK(where(pentagram, {0, 0}, fill_rule::even_odd) == location::outside);
  CHECK(where(pentagram, {0, 0}, fill_rule::non_zero) == location::inside);
  CHECK(where(pentagram, {0, 800}, fill_rule::even_odd) == location::inside);
  // a hole that runs the same way as its ring is filled by the non-zero rule
  const std::vector<V> same_way{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}};
  CHECK(where(same_way, {4, 4}, fill_rule::even_odd) == location::outside);
  CHECK(where(same_way, {4, 4}, fill_rule::non_zero) == location::inside);
  CHECK(irg::winding_number(same_way, {4, 4}) == 2);
  CHECK(irg::winding_number(std::vector<V>{}, {4, 4}) == 0);
  CHECK(irg::point_in_polygon(std::vector<V>{{}, {}}, {4, 4}) == location::outside);
}

TEST_CASE("point_in_polygon: NaN and infinity anywhere, extremes, 64-bit integers") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan_ = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {inf, -inf, nan_})
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<std::vector<P>> rings{{{0, 0}, {9, 0}, {0, 9}}, {{1, 1}, {1, 2}, {2, 1}}};
      CHECK(irg::point_in_polygon(rings, {3, 3}) == location::inside);
      rings[1][i].y = bad;
      CHECK(irg::point_in_polygon(rings, {3, 3}) == location::outside);
      CHECK(irg::point_in_polygon(rings, {0, 3}) == location::outside);
      CHECK(!irg::winding_number(rings, {3, 3}));
      rings[1][i] = {bad, 5};
      CHECK(irg::point_in_polygon(rings, {3, 3}) == location::outside);
    }
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  constexpr std::array<P, 3> wide{P{-most, -most}, P{most, -most}, P{0, most}};
  CHECK_BOTH(irg::point_in_polygon(wide, {0, 0}) == location::inside);
  CHECK_BOTH(irg::point_in_polygon(wide, {0, -most}) == location::boundary);
  CHECK_BOTH(irg::point_in_polygon(wide, {most / 2, 0}) == location::boundary);
  CHECK_BOTH(irg::point_in_polygon(wide, {most / 2, least}) == location::outside);
  CHECK_BOTH(irg::point_in_polygon(wide, {most / 2, -least}) == location::inside);
  using L = irg::point<std::int64_t, 2>;
  constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max(),
                         low = std::numeric_limits<std::int64_t>::min();
  constexpr std::array<L, 3> half{L{low, low}, L{high, low}, L{high, high}};
  CHECK_BOTH(irg::point_in_polygon(half, {0, 0}) == location::boundary);
  CHECK_BOTH(irg::point_in_polygon(half, {1, 0}) == location::inside);
  CHECK_BOTH(irg::point_in_polygon(half, {0, 1}) == location::outside);
}

}  // namespace
