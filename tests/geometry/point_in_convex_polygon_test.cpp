// SPDX-License-Identifier: MIT
#include <irg/geometry/point_in_convex_polygon.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/geometry/polygon_convexity.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::location;
using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};  // the course's values

TEST_CASE("point in convex polygon: the course's values, both ways") {
  const struct {
    P p;
    location where;
  } cases[] = {{{150, 200}, location::inside},    {{100, 275}, location::boundary}, {{50, 200}, location::boundary},
               {{300, 350}, location::outside},   {{200, 100}, location::boundary}, {{0, 0}, location::outside},
               {{200.5, 100}, location::outside}, {{199.5, 100}, location::inside}};
  for (const auto& [p, where] : cases) {
    CHECK(irg::point_in_convex_polygon(course, p) == where);
    CHECK(irg::detail::locate_by_fan(course, p) == where);
  }
  CHECK_BOTH(irg::point_in_convex_polygon(course, {150, 200}) == location::inside);
  CHECK_BOTH(irg::detail::locate_by_fan(course, {150, 200}) == location::inside);
  // counter-clockwise and repeated vertices: what the course's rules do not ask for
  constexpr std::array<P, 5> repeated{P{50, 200}, P{150, 350}, P{150, 350}, P{300, 150}, P{100, 50}};
  CHECK_BOTH(irg::point_in_convex_polygon(repeated, {150, 200}) == location::inside);
  CHECK_BOTH(irg::detail::locate_by_fan(repeated, {150, 200}) == location::inside);
}

// Every convex ring of a small lattice that random choices make, with collinear and repeated vertices, both ways round,
// from every start, against every point of the lattice.
TEST_CASE("point in convex polygon: by edges and in logarithmic time, against the crossings of any polygon") {
  test::random random(51);
  long rings = 0, flat = 0, inside = 0, boundary = 0;
  const auto check_all = [&](std::vector<I> ring) {
    REQUIRE(irg::is_convex(ring));
    ++rings;
    for (std::size_t start = 0; start < std::max<std::size_t>(ring.size(), 1); ++start) {
      for (int y = -1; y <= 5; ++y)
        for (int x = -1; x <= 5; ++x) {
          const auto expected = irg::point_in_polygon(ring, {x, y});
          REQUIRE(irg::point_in_convex_polygon(ring, {x, y}) == expected);
          REQUIRE(irg::detail::locate_by_edges(ring, {x, y}) == expected);
          REQUIRE(irg::detail::locate_by_fan(ring, {x, y}) == expected);
          inside += expected == location::inside;
          boundary += expected == location::boundary;
        }
      if (!ring.empty()) std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    }
  };
  check_all({});
  for (int t = 0; t < 6000; ++t) {
    std::vector<I> ring;
    for (auto n = random.integer(1, 7); n > 0; --n) {
      const int x = static_cast<int>(random.integer(0, 4));
      const I p{x, static_cast<int>(random.integer(0, 4))};
      for (auto copies = random.integer(0, 4) == 0 ? random.integer(2, 3) : 1; copies > 0; --copies) ring.push_back(p);
    }
    if (!irg::is_convex(ring)) continue;
    check_all(ring);
  }
  for (int t = 0; t < 150; ++t) {  // rectangles and segments with many points on their sides
    const int w = static_cast<int>(random.integer(0, 4)), h = static_cast<int>(random.integer(0, 4));
    std::vector<I> ring;
    for (int i = 0; i < w; ++i) ring.push_back({i, 0});
    for (int i = 0; i < h; ++i) ring.push_back({w, i});
    for (int i = w; i > 0; --i) ring.push_back({i, h});
    for (int i = h; i > 0; --i) ring.push_back({0, i});
    if (ring.empty()) continue;
    flat += w == 0 || h == 0;
    if (t % 2 == 0) std::reverse(ring.begin(), ring.end());
    for (auto copies = random.integer(0, 3); copies > 0; --copies) {
      const auto at = ring.begin() + random.integer(0, static_cast<std::int64_t>(ring.size()) - 1);
      ring.insert(at, I(*at));
    }
    check_all(ring);
  }
  MESSAGE(rings, " convex rings, ", flat, " flat; points inside ", inside, ", on the boundary ", boundary);
  CHECK(rings > 1000);
  CHECK(inside > 3000);
}

TEST_CASE("point_in_convex_polygon: a million vertices, turns counted by exact neighbours") {
  std::vector<P> ring;  // on a parabola, and the chord above it
  for (int i = -500000; i <= 500000; ++i) ring.push_back({static_cast<double>(i), static_cast<double>(i) * i});
  test::random random(52);
  for (int t = 0; t < 2000; ++t) {
    const auto i = static_cast<std::size_t>(random.integer(0, 999'999));
    const P p{ring[i].x, ring[i].y};
    const double y_of_chord = (ring[i].y + ring[i + 1].y) / 2, x_of_chord = p.x + 0.5;
    REQUIRE(irg::point_in_convex_polygon(ring, p) == location::boundary);
    REQUIRE(irg::point_in_convex_polygon(ring, {x_of_chord, y_of_chord}) == location::boundary);
    const double above = std::nextafter(y_of_chord, 1e300), below = std::nextafter(y_of_chord, -1e300);
    REQUIRE(irg::point_in_convex_polygon(ring, {x_of_chord, above}) == location::inside);
    REQUIRE(irg::point_in_convex_polygon(ring, {x_of_chord, below}) == location::outside);
  }
}

TEST_CASE("point in convex polygon: hostile numbers") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  constexpr double inf = std::numeric_limits<double>::infinity(), nan_ = std::numeric_limits<double>::quiet_NaN();
  constexpr std::array<P, 4> square{P{-most, -most}, P{most, -most}, P{most, most}, P{-most, most}};
  CHECK_BOTH(irg::detail::locate_by_fan(square, {0, 0}) == location::inside);
  CHECK_BOTH(irg::detail::locate_by_fan(square, {most, least}) == location::boundary);
  constexpr std::array<P, 3> tiny{P{0, 0}, P{3 * least, 0}, P{0, 3 * least}};
  CHECK_BOTH(irg::detail::locate_by_fan(tiny, {least, least}) == location::inside);
  CHECK_BOTH(irg::detail::locate_by_fan(tiny, {2 * least, least}) == location::boundary);
  CHECK_BOTH(irg::detail::locate_by_fan(tiny, {2 * least, 2 * least}) == location::outside);
  for (const double bad : {inf, -inf, nan_}) {
    CHECK(irg::point_in_convex_polygon(square, {bad, 0}) == location::outside);
    CHECK(irg::point_in_convex_polygon(square, {0, bad}) == location::outside);
  }
}

}  // namespace
