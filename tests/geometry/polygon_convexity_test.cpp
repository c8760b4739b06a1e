// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/polygon.hpp>
#include <irg/geometry/polygon_convexity.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::location;
using irg::orientation;
using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
using Q = irg::point<test::rational, 2>;
__extension__ typedef __int128 wide;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

// The course's polygon, and its pentagram.
constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};
constexpr std::array<I, 5> pentagram{I{0, 1000}, I{588, -809}, I{-951, 309}, I{951, 309}, I{-588, -809}};

template <class R>
constexpr R turned_round(R ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

TEST_CASE("orientation and convexity: the course's values") {
  CHECK_BOTH(irg::orientation_of(course) == orientation::clockwise);
  CHECK_BOTH(irg::orientation_of(turned_round(course)) == orientation::counter_clockwise);
  CHECK_BOTH(irg::textbook::orientation_of(course) == orientation::clockwise);
  CHECK_BOTH(irg::textbook::orientation_of(turned_round(course)) == orientation::counter_clockwise);
  CHECK_BOTH(irg::is_convex(course));
  constexpr std::array<I, 4> dart{I{0, 0}, I{0, 4}, I{2, 1}, I{4, 4}};
  CHECK_BOTH(!irg::is_convex(dart));
  CHECK_BOTH(irg::textbook::orientation_of(dart) == orientation::degenerate);
  CHECK_BOTH(irg::orientation_of(dart) == orientation::clockwise);
  // The pentagram satisfies the course's criterion and is not convex.
  CHECK_BOTH(irg::textbook::orientation_of(pentagram) == orientation::clockwise);
  CHECK_BOTH(irg::orientation_of(pentagram) == orientation::clockwise);
  CHECK_BOTH(!irg::is_convex(pentagram));
}

TEST_CASE("is_convex: collinear and repeated vertices, spikes, and rounds") {
  using V = std::vector<I>;
  CHECK_BOTH(irg::is_convex(V{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}));
  CHECK_BOTH(irg::is_convex(V{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}, {0, 0}}));
  CHECK_BOTH(!irg::is_convex(V{{0, 0}, {4, 4}, {4, 0}, {0, 4}}));                                  // a bow-tie
  CHECK_BOTH(!irg::is_convex(V{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}));  // twice round
  CHECK_BOTH(!irg::is_convex(V{{0, 0}, {4, 0}, {2, 0}, {2, 4}, {0, 4}}));                          // a spike along x
  CHECK_BOTH(!irg::is_convex(V{{0, 0}, {0, 4}, {0, 2}, {-4, 2}, {-4, 0}}));
  CHECK_BOTH(!irg::is_convex(V{{0, 0}, {3, 0}, {4, 4}, {6, 6}, {4, 4}, {0, 4}}));
  CHECK_BOTH(!irg::is_convex(V{{0, 0}, {3, 0}, {1, 0}, {5, 0}}));  // a segment walked to and fro
  CHECK_BOTH(irg::is_convex(V{{0, 0}, {3, 1}, {9, 3}, {6, 2}}));   // there and back
  CHECK_BOTH(irg::is_convex(V{}));
  CHECK_BOTH(irg::is_convex(V{{7, 7}}));
  CHECK_BOTH(irg::is_convex(V{{7, 7}, {7, 7}, {7, 7}}));
  CHECK_BOTH(irg::is_convex(V{{7, 7}, {8, 9}}));
}

TEST_CASE("NaN and infinity: no polygon, nowhere") {
  for (const double bad : {nan_, inf, -inf}) {
    const std::array<P, 3> ring{P{0, 0}, P{1, bad}, P{0, 1}};
    CHECK(irg::orientation_of(ring) == orientation::degenerate);
    CHECK(irg::textbook::orientation_of(ring) == orientation::degenerate);
    CHECK(!irg::is_convex(ring));
    CHECK(irg::locate_point(ring, {0, 0}) == location::outside);
    CHECK(irg::locate_point(course, {bad, 200}) == location::outside);
  }
}

TEST_CASE("the whole range of doubles: the largest and the least") {
  CHECK_BOTH(irg::orientation_of(std::array{P{-largest, -largest}, P{largest, -largest}, P{0, largest}}) ==
             orientation::counter_clockwise);
  CHECK_BOTH(irg::orientation_of(std::array{P{0, 0}, P{least, 0}, P{0, least}}) == orientation::counter_clockwise);
  CHECK_BOTH(irg::orientation_of(std::array{P{0, 0}, P{largest, least}, P{largest, 0}}) == orientation::clockwise);
  CHECK_BOTH(irg::is_convex(std::array{P{0, 0}, P{largest, 0}, P{largest, largest}, P{-least, largest}}));
  CHECK_BOTH(!irg::is_convex(std::array{P{0, 0}, P{largest, 0}, P{largest, largest}, P{least * 2, least}}));
  CHECK_BOTH(irg::is_convex(std::array{P{0, 0}, P{largest, 0}, P{largest, largest}, P{least, least}}));
  CHECK_BOTH(irg::locate_point(std::array{P{-largest, 0}, P{largest, 0}, P{0, largest}}, {1e300, 0.0}) ==
             location::boundary);
  CHECK_BOTH(irg::locate_point(std::array{P{-largest, 0}, P{largest, 0}, P{0, largest}}, {1e300, least}) ==
             location::inside);
  CHECK_BOTH(irg::locate_point(std::array{P{-largest, 0}, P{largest, 0}, P{0, largest}}, {1e300, -least}) ==
             location::outside);
}

// The sign of (b - a) x (c - a) for coordinates k * 2^-53, |k| < 2^58, in integers.
int oracle_turn(const P& a, const P& b, const P& c) {
  const auto whole = [](double v) { return wide{static_cast<std::int64_t>(v * 0x1p53)}; };
  const wide v =
      (whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y)) - (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x));
  return v < 0 ? -1 : v > 0;
}

TEST_CASE("turns: right where floats are wrong, on grids of neighbouring doubles, scaled to every exponent") {
  // Kettner, Mehlhorn, Pion, Schirra and Yap 2008: p near (0.5, 0.5) against the line through (12, 12) and (24, 24).
  long plain_wrong = 0, wrong = 0, collinear = 0;
  const int side = std::getenv("IRG_RELEASE_TIER") ? 256 : 48;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const P p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, q{12, 12}, r{24, 24};
      const int expected = oracle_turn(p, q, r);
      const double plain = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      plain_wrong += (plain > 0 ? 1 : plain < 0 ? -1 : 0) != expected;
      collinear += expected == 0;
      for (const double scale : {1.0, 0x1p-1000, 0x1p900, -0x1p-390, 0x1p390}) {
        const auto at = [&](const P& v) { return P{v.x * scale, v.y * scale}; };
        wrong += static_cast<int>(irg::textbook::orientation_of(std::array{at(p), at(q), at(r)})) != expected;
        wrong += static_cast<int>(irg::orientation_of(std::array{at(p), at(q), at(r)})) != expected;
        wrong += irg::orient2d(at(p), at(q), at(r)) != expected;
      }
    }
  const int points = side * side;
  MESSAGE(points, " points, ", collinear, " collinear; plain doubles wrong: ", plain_wrong, ", irg: ", wrong);
  CHECK(plain_wrong > side);
  CHECK(wrong == 0);
}

bool equal(const P& a, const P& b) { return a.x == b.x && a.y == b.y; }

// The corners of the convex hull, counter-clockwise, none on a side.
std::vector<P> strict_hull(std::vector<P> points) {
  const auto before = [](const P& a, const P& b) { return a.x < b.x || (a.x <= b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), before);
  std::vector<P> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const P& p : points) {
      while (hull.size() >= base + 2 && oracle_turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// The ring without vertices that repeat the next one or stand straight between their neighbours.
std::vector<P> without_flat_vertices(std::vector<P> ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 1;) {
    const std::size_t n = ring.size();
    const P a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    const double forward = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    if (equal(b, c) || (!equal(a, b) && oracle_turn(a, b, c) == 0 && forward > 0)) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
  return ring;
}

// Whether a ring is the hull's corners in their order, from whichever it starts.
bool same_round(std::vector<P> ring, const std::vector<P>& hull, bool counter_clockwise) {
  if (!counter_clockwise) std::reverse(ring.begin(), ring.end());
  if (ring.size() != hull.size()) return false;
  for (std::size_t shift = 0; shift < hull.size(); ++shift) {
    std::size_t same = 0;
    while (same < hull.size() && equal(ring[same], hull[(same + shift) % hull.size()])) ++same;
    if (same == hull.size()) return true;
  }
  return false;
}

TEST_CASE("random rings of doubles, nearly collinear: orientation, convexity and location against integers") {
  test::random random(31);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 1000000 : 20000;
  long convex = 0, boundary = 0, inside = 0;
  for (int t = 0; t < trials; ++t) {
    const auto n = static_cast<std::size_t>(random.integer(3, 6));
    // Even trials: a coarse lattice, rich in collinear points. Odd ones: neighbours of the points of a line.
    std::vector<P> ring;
    const auto vertex = [&] {
      if (t % 2 == 0) return P{static_cast<double>(random.integer(-3, 3)), static_cast<double>(random.integer(-3, 3))};
      const double at = static_cast<double>(random.integer(-24, 24)) / 2;
      const auto off = [&] { return static_cast<double>(random.integer(-2, 2)) * 0x1p-49; };
      return P{at + off(), at + off()};
    };
    for (std::size_t i = 0; i < n; ++i) ring.push_back(vertex());
    const P p = vertex();
    const auto at = [&](std::size_t i) { return ring[i % n]; };

    wide area = 0;
    const auto whole = [](double v) { return wide{static_cast<std::int64_t>(v * 0x1p53)}; };
    for (std::size_t i = 0; i < n; ++i)
      area += whole(at(i).x) * whole(at(i + 1).y) - whole(at(i).y) * whole(at(i + 1).x);
    REQUIRE(static_cast<int>(irg::orientation_of(ring)) == (area < 0 ? -1 : area > 0));

    const auto hull = strict_hull(ring);
    const bool flat = hull.size() < 3;
    const bool expected_convex = !flat && same_round(without_flat_vertices(ring), hull, area > 0);
    if (!flat) REQUIRE(irg::is_convex(ring) == expected_convex);
    convex += expected_convex;

    // Location by the course's rules 3.3 and 3.4, where the ring is convex.
    if (expected_convex) {
      bool out = false, on = false;
      for (std::size_t i = 0; i < n; ++i) {
        if (at(i).x == at(i + 1).x && at(i).y == at(i + 1).y) continue;
        const int turn = oracle_turn(at(i), at(i + 1), p) * (area < 0 ? 1 : -1);
        out = out || turn > 0;
        on = on || turn == 0;
      }
      const auto expected = out ? location::outside : on ? location::boundary : location::inside;
      REQUIRE(irg::locate_point(ring, p) == expected);
      REQUIRE(irg::point_in_convex_polygon(ring, p) == expected);
      REQUIRE(irg::detail::locate_by_fan(ring, p) == expected);
      boundary += expected == location::boundary;
      inside += expected == location::inside;
    }
  }
  MESSAGE(trials, " rings, ", convex, " convex; points on the boundary ", boundary, ", inside ", inside);
  CHECK(convex > trials / 50);
  CHECK(boundary > 100);
  CHECK(inside > 50);
}

TEST_CASE("any number type: rationals, floats, 64-bit integers, foreign points, hostile size") {
  const std::array<Q, 4> ring{Q{0, 0}, Q{{1, 3}, 0}, Q{{1, 3}, {1, 3}}, Q{0, {1, 3}}};
  CHECK(irg::is_convex(ring));
  CHECK(irg::orientation_of(ring) == orientation::counter_clockwise);
  CHECK(irg::locate_point(ring, {{1, 6}, {1, 6}}) == location::inside);
  CHECK(irg::locate_point(ring, {{1, 3}, {1, 6}}) == location::boundary);
  using F = irg::point<float, 2>;
  CHECK_BOTH(irg::orientation_of(std::array{F{0, 0}, F{0.1f, 0}, F{0, 1e-38f}}) == orientation::counter_clockwise);
  using L = irg::point<std::int64_t, 2>;
  CHECK_BOTH(irg::orientation_of(std::array{L{0, 0}, L{1000000000, 1}, L{1000000000, 0}}) == orientation::clockwise);
  struct xy {
    int x, y;
  };
  const std::vector<xy> most{
      {2147483647, 2147483647}, {-2147483647 - 1, 2147483647}, {-2147483647 - 1, -2147483647 - 1}};
  CHECK(irg::orientation_of(most) == orientation::counter_clockwise);
  CHECK(irg::is_convex(most));
  CHECK(irg::locate_point(most, {0, 0}) == location::boundary);
  CHECK(irg::locate_point(most, {0, -1}) == location::outside);
  CHECK(irg::locate_point(most, {-1, 0}) == location::inside);
  // a million vertices along a parabola
  std::vector<P> many;
  for (int i = 0; i < 1000000; ++i) many.push_back({static_cast<double>(i), static_cast<double>(i) * i});
  CHECK(irg::is_convex(many));
  CHECK(irg::orientation_of(many) == orientation::counter_clockwise);
  many[500000].y += 1.0;  // onto the chord of its neighbours: still convex
  CHECK(irg::is_convex(many));
  many[500000].y += 0.001;
  CHECK(!irg::is_convex(many));
}

}  // namespace
