// SPDX-License-Identifier: MIT
#include <irg/geometry/split_polygon.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/geometry/plane.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/math/vec.hpp>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/lattice_polygons.hpp"
#include "support/rational.hpp"

namespace {

using irg::split_side;
using P = irg::point<double, 2>;
using S = irg::point<double, 3>;
using Q = irg::point<test::rational, 2>;
using V = std::vector<P>;

template <class R>
std::size_t vertex_count(const std::vector<R>& parts) {
  std::size_t n = 0;
  for (const R& r : parts) n += r.size();
  return n;
}
// The same ring, wherever it starts.
template <class R>
bool same_ring(R a, const R& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (a == b) return true;
    std::rotate(a.begin(), a.begin() + 1, a.end());
  }
  return b.empty();
}

TEST_CASE("split_polygon: by hand, in the plane") {
  const V square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const auto halves = irg::split_polygon(square, {2, 0}, {2, 1});
  CHECK(halves.side == split_side::both);
  REQUIRE(halves.front.size() == 1);
  REQUIRE(halves.back.size() == 1);
  CHECK(same_ring(halves.front[0], V{{0, 0}, {2, 0}, {2, 4}, {0, 4}}));
  CHECK(same_ring(halves.back[0], V{{2, 0}, {4, 0}, {4, 4}, {2, 4}}));
  // a diagonal: both vertices on it go to both parts, and none is new
  const auto triangles = irg::split_polygon(square, {0, 0}, {4, 4});
  CHECK(same_ring(triangles.front[0], V{{0, 0}, {4, 4}, {0, 4}}));
  CHECK(same_ring(triangles.back[0], V{{0, 0}, {4, 0}, {4, 4}}));
  constexpr auto sides = [](P from, P over) {
    const auto parts = irg::split_polygon(V{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, from, over);
    return static_cast<int>(parts.side) * 100 + static_cast<int>(parts.front.size() * 10 + parts.back.size());
  };
  CHECK_BOTH(sides({0, 0}, {1, 0}) == 10);     // front, touching along an edge
  CHECK_BOTH(sides({1, 0}, {0, 0}) == 101);    // back
  CHECK_BOTH(sides({0, 4}, {1, 5}) == 101);    // back, touching at a vertex
  CHECK_BOTH(sides({0, 1}, {1, 1}) == 211);    // both
  CHECK_BOTH(sides({7, 7}, {7, 7}) == 300);    // no line
  // an M from above: two teeth and the block below, which has the valley on its upper side
  const V letter{{0, 0}, {8, 0}, {8, 6}, {4, 2}, {0, 6}};
  const auto teeth = irg::split_polygon(letter, {0, 2}, {1, 2});
  REQUIRE(teeth.front.size() == 2);
  REQUIRE(teeth.back.size() == 1);
  CHECK(same_ring(teeth.back[0], V{{0, 0}, {8, 0}, {8, 2}, {4, 2}, {0, 2}}));
  CHECK(irg::polygon_area(teeth.front) == 16);
  const auto higher = irg::split_polygon(letter, {0, 3}, {1, 3});
  CHECK(higher.front.size() == 2);
  CHECK(higher.back.size() == 1);
  CHECK(vertex_count(higher.back) == 7);
  // two notches that reach the cut at one place, in either order: three parts above, each by itself
  V notched{{-10, -10}, {10, -10}, {10, 10}, {8, 10}, {0, 0}, {4, 10}, {-4, 10}, {0, 0}, {-8, 10}, {-10, 10}};
  for (std::size_t start = 0; start < notched.size(); ++start) {
    for (const bool upside_down : {false, true}) {
      const auto three =
          upside_down ? irg::split_polygon(notched, {1, 0}, {0, 0}) : irg::split_polygon(notched, {0, 0}, {1, 0});
      const auto &above = upside_down ? three.back : three.front, &below = upside_down ? three.front : three.back;
      REQUIRE(above.size() == 3);
      REQUIRE(below.size() == 1);
      CHECK(same_ring(below[0], V{{-10, -10}, {10, -10}, {10, 0}, {0, 0}, {-10, 0}}));
      std::vector<double> areas;
      for (const V& part : above) areas.push_back(irg::polygon_area(part));
      std::sort(areas.begin(), areas.end());
      CHECK(areas == std::vector<double>{40, 60, 60});
    }
    std::rotate(notched.begin(), notched.begin() + 1, notched.end());
  }
  // a bow-tie keeps its area on each side, in one ring
  const auto tie = irg::split_polygon(V{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {0, 1}, {1, 1});
  CHECK(tie.side == split_side::both);
  CHECK(tie.front.size() <= 1);
}

TEST_CASE("split_polygon: in space, with attributes; nothing, flat, no numbers") {
  using A = irg::attributed_point<double, 3, 2>;
  const std::vector<A> quad{{{0, 0, 0}, {0, 1}}, {{4, 0, 4}, {4, 1}}, {{4, 4, 4}, {4, 5}}, {{0, 4, 0}, {0, 5}}};
  const auto parts = irg::split_polygon(quad, irg::plane<double>{1, 0, 0, -1});
  REQUIRE(parts.side == split_side::both);
  CHECK(same_ring(parts.front[0], std::vector<A>{{{1, 0, 1}, {1, 1}}, quad[1], quad[2], {{1, 4, 1}, {1, 5}}}));
  CHECK(same_ring(parts.back[0], std::vector<A>{quad[0], {{1, 0, 1}, {1, 1}}, {{1, 4, 1}, {1, 5}}, quad[3]}));
  CHECK(irg::split_polygon(quad, irg::plane<double>{1, 0, -1, 0}).side == split_side::on);
  CHECK(irg::split_polygon(quad, irg::plane<double>{0, 0, 0, 1}).side == split_side::front);
  CHECK(irg::split_polygon(std::vector<A>{}, irg::plane<double>{1, 0, 0, 0}).side == split_side::on);
  constexpr double nan_ = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK(irg::split_polygon(quad, irg::plane<double>{1, nan_, 0, 0}).side == split_side::not_finite);
  CHECK_BOTH(irg::split_polygon(std::vector<S>{{0, 0, 0}, {1, 0, 0}}, irg::plane<double>{1, nan_, 0, 0}).side ==
             split_side::not_finite);
  CHECK_BOTH(
      irg::split_polygon(std::vector<S>{{0, 0, 0}, {1, inf, 0}, {1, 1, 0}}, irg::plane<double>{1, 0, 0, 0}).side ==
      split_side::not_finite);
  // a segment there and back: parts without area are dropped
  const auto flat = irg::split_polygon(std::vector<S>{{0, 0, 0}, {4, 0, 0}}, irg::plane<double>{1, 0, 0, -1});
  CHECK(flat.side == split_side::both);
  CHECK(flat.front.empty());
  CHECK(flat.back.empty());
}

// A polygon of rationals cut by a line: nothing is rounded, so areas add up, points keep to their sides, and sample
// points lie where they lay.
void check(const test::lattice_ring& lattice, const test::lattice_point& from, const test::lattice_point& over) {
  std::vector<Q> ring;
  for (const auto& p : lattice) ring.push_back({p.x, p.y});
  const Q a{from.x, from.y}, b{over.x, over.y};
  const auto parts = irg::split_polygon(ring, a, b);
  bool left = false, right = false;
  for (const auto& p : lattice) {
    left = left || test::turn(from, over, p) > 0;
    right = right || test::turn(from, over, p) < 0;
  }
  REQUIRE(parts.side == (left && right ? split_side::both
                         : left        ? split_side::front
                         : right       ? split_side::back
                                       : split_side::on));
  if (!left || !right) return;
  test::rational sum = 0;
  const bool forward = test::twice_area(lattice) > 0;
  std::vector<std::pair<Q, Q>> along[2];  // edges on the line
  for (const int side : {1, -1})
    for (const auto& part : side > 0 ? parts.front : parts.back) {
      REQUIRE(part.size() >= 3);
      const auto area = irg::polygon_area(part);
      REQUIRE((test::rational(0) < area) == forward);
      sum = sum + area;
      for (std::size_t k = 0; k < part.size(); ++k) {
        const Q &p = part[k], &q = part[(k + 1) % part.size()];
        REQUIRE(irg::orient2d(a, b, p) * side >= 0);
        if (irg::orient2d(a, b, p) == 0 && irg::orient2d(a, b, q) == 0) along[side > 0].push_back({p, q});
      }
    }
  // each edge along the cut is one of the other side's, walked the other way, or one of the polygon's own
  for (const int k : {0, 1})
    for (const auto& [p, q] : along[k]) {
      const test::rational half(1, 2);
      const Q middle{(p.x + q.x) * half, (p.y + q.y) * half};
      const bool is_own = irg::point_in_polygon(ring, middle) == irg::location::boundary;
      REQUIRE((is_own || std::count(along[1 - k].begin(), along[1 - k].end(), std::pair(q, p)) == 1));
    }
  REQUIRE(sum + sum == test::rational(test::twice_area(lattice)));
  for (const auto& [x, y] : {std::pair{1, 2}, {2, 3}, {3, 1}, {4, 4}, {5, 2}, {3, 5}, {6, 6}, {1, 6}, {6, 1}, {4, 3}}) {
    const Q p{test::rational(21 * x + 7, 21), test::rational(21 * y + 3, 21)};
    int count = 0;
    for (const auto* half : {&parts.front, &parts.back})
      for (const auto& part : *half) {
        const auto where = irg::point_in_polygon(part, p);
        count += where == irg::location::inside;
        if (where == irg::location::boundary) count = -1000;  // on the cut
      }
    REQUIRE((count < 0 || count == std::abs(test::windings(lattice, {x, y}))));
  }
}

TEST_CASE("split_polygon: random simple polygons by lattice lines, in rationals") {
  test::random random(111);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 100'000 : 700;
  int cut = 0;
  for (int i = 0; i < rounds; ++i) {
    const int n = static_cast<int>(random.integer(3, i % 10 == 0 ? 30 : 12));
    test::lattice_ring r = n == 3 ? test::lattice_ring{{0, 0}, {7, 2}, {3, 6}} : test::random_simple(random, n, 7);
    if (r.empty()) continue;
    if (i % 2 == 0) std::reverse(r.begin(), r.end());
    const auto lattice_place = [&] {
      const int x = static_cast<int>(random.integer(0, 7));
      return test::lattice_point{x, static_cast<int>(random.integer(0, 7))};
    };
    const auto from = lattice_place(), over = lattice_place();
    if (from == over) continue;
    check(r, from, over);
    ++cut;
  }
  CHECK(cut > rounds / 2);
}

TEST_CASE("split_polygon: outlines of cells along lattice lines: edges on the cut, touching corners") {
  test::random random(112);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 50'000 : 150;
  for (int i = 0; i < rounds; ++i)
    for (test::lattice_ring r : test::outlines(random, 7, 7, static_cast<int>(random.integer(40, 80)))) {
      if (i % 2 == 0) std::reverse(r.begin(), r.end());
      const int at = static_cast<int>(random.integer(1, 6));
      check(r, {0, at}, {1, at});
      check(r, {at, 1}, {at, 0});
      check(r, {0, at}, {7, 7 - at});
    }
}

TEST_CASE("split_polygon: neighbours get the same points, whichever way they run; parts agree along the cut") {
  test::random random(113);
  long shared = 0;
  for (int t = 0; t < 1500; ++t) {
    const auto place = [&] {
      const double x = random.unit(), y = random.unit();
      return S{x, y, random.unit()};
    };
    const S a = place(), b = place(), c = place(), d = place();
    const double scale = std::ldexp(1.0, static_cast<int>(random.integer(-300, 300)));
    const auto at = [&](const S& p) { return S{p.x * scale, p.y * scale, p.z * scale}; };
    const irg::plane<double> plane{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5,
                                   (random.unit() - 0.5) * 0.5 * scale};
    const auto one = irg::split_polygon(std::vector<S>{at(a), at(b), at(c)}, plane);
    const auto other = irg::split_polygon(std::vector<S>{at(b), at(a), at(d)}, plane);
    const int side_a = irg::plane_value(plane, at(a)) > 0 ? 1 : -1,
              side_b = irg::plane_value(plane, at(b)) > 0 ? 1 : -1;
    if (side_a == side_b || one.side != split_side::both || other.side != split_side::both) continue;
    const auto is_new = [&](const S& p) { return !(p == at(a)) && !(p == at(b)) && !(p == at(c)) && !(p == at(d)); };
    std::vector<S> common;
    for (const S& p : one.front[0]) {
      if (!is_new(p)) continue;
      REQUIRE(std::count(one.back[0].begin(), one.back[0].end(), p) == 1);
      if (std::count(other.front[0].begin(), other.front[0].end(), p) == 1) common.push_back(p);
    }
    REQUIRE(common.size() == 1);
    ++shared;
  }
  CHECK(shared > 200);
}

}  // namespace

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("split_polygon: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("split_polygon"), 1,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto c = numbers<T, 4>(r, which);
        const auto e = rationals(c);
        struct crossing {
          point<T, 3> front, back;
          quotient t;
        };
        std::vector<crossing> crossings;
        double worst = 0;
        const auto note = [&](const point<T, 3>& front, const point<T, 3>& back, T t) {
          const auto height = [&](const point<T, 3>& q) {
            return e[0] * of(q.x) + e[1] * of(q.y) + e[2] * of(q.z) + e[3];
          };
          const E at_front = height(front), at_back = height(back);
          crossings.push_back({front, back, {at_front, at_front - at_back}});
          worst = std::fmax(worst, quotient_error(t, at_front, at_front - at_back));
          return front;
        };
        const std::vector<point<T, 3>> ring(p.begin(), p.end());
        const auto parts = split_polygon(ring, irg::plane<T>{c[0], c[1], c[2], c[3]}, note);
        for (const auto* side : {&parts.front, &parts.back})
          for (const auto& part : *side)
            for (const auto& q : part) {
              if (q == p[0] || q == p[1] || q == p[2]) continue;
              double off = wrong;
              for (const auto& x : crossings) off = std::fmin(off, off_between(q, x.front, x.back, x.t));
              worst = std::fmax(worst, off);
            }
        return worst;
      },
      2000);
}

#endif
