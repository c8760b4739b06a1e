// SPDX-License-Identifier: MIT
#include <irg/geometry/polygons_overlap.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/lattice_polygons.hpp"
#include "support/rational.hpp"

namespace {

using irg::polygon_overlap;
using ring = test::lattice_ring;
using P = irg::point<double, 2>;
using Q = irg::point<test::rational, 2>;

// Twice the area that two convex counter-clockwise rings have in common, by cutting one with the other's edges in
// rationals.
test::rational common_area(const ring& a, const ring& b) {
  std::vector<Q> part;
  for (const auto& p : a) part.push_back({p.x, p.y});
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Q p{b[i].x, b[i].y}, q{b[(i + 1) % b.size()].x, b[(i + 1) % b.size()].y};
    const auto value = [&](const Q& v) { return (q.x - p.x) * (v.y - p.y) - (q.y - p.y) * (v.x - p.x); };
    std::vector<Q> kept;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Q &u = part[k], &v = part[(k + 1) % part.size()];
      const test::rational at_u = value(u), at_v = value(v), zero = 0;
      if (!(at_u < zero)) kept.push_back(u);
      if ((at_u < zero && zero < at_v) || (at_v < zero && zero < at_u)) {
        const test::rational t = at_u / (at_u - at_v);
        kept.push_back({u.x + t * (v.x - u.x), u.y + t * (v.y - u.y)});
      }
    }
    part = kept;
  }
  test::rational sum = 0;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Q &u = part[k], &v = part[(k + 1) % part.size()];
    sum = sum + (u.x * v.y - u.y * v.x);
  }
  return sum;
}

polygon_overlap convex_oracle(const ring& a, const ring& b) {
  const bool areas = test::twice_area(a) != 0 && test::twice_area(b) != 0;
  if (areas && !(common_area(a, b) == test::rational(0))) return polygon_overlap::overlapping;
  bool common =
      irg::locate_point(a, b[0]) != irg::location::outside || irg::locate_point(b, a[0]) != irg::location::outside;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k)
      common = common || test::meet(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]);
  return common ? polygon_overlap::touching : polygon_overlap::separate;
}

ring turned_round(ring r) {
  std::reverse(r.begin(), r.end());
  return r;
}

TEST_CASE("overlap: by hand") {
  using A = std::array<irg::point<int, 2>, 4>;
  constexpr A square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  constexpr auto moved = [](int dx, int dy) { return A{{{dx, dy}, {4 + dx, dy}, {4 + dx, 4 + dy}, {dx, 4 + dy}}}; };
  CHECK_BOTH(irg::convex_polygons_overlap(square, moved(3, 3)) == polygon_overlap::overlapping);
  CHECK_BOTH(irg::convex_polygons_overlap(square, moved(4, 0)) == polygon_overlap::touching);
  CHECK_BOTH(irg::convex_polygons_overlap(square, moved(4, 4)) == polygon_overlap::touching);
  CHECK_BOTH(irg::convex_polygons_overlap(square, moved(4, 5)) == polygon_overlap::separate);
  CHECK_BOTH(irg::convex_polygons_overlap(square, square) == polygon_overlap::overlapping);
  CHECK_BOTH(irg::polygons_overlap(square, moved(3, 3)) == polygon_overlap::overlapping);
  CHECK_BOTH(irg::polygons_overlap(square, moved(4, 0)) == polygon_overlap::touching);
  CHECK_BOTH(irg::polygons_overlap(square, moved(4, 4)) == polygon_overlap::touching);
  CHECK_BOTH(irg::polygons_overlap(square, moved(4, 5)) == polygon_overlap::separate);
  CHECK_BOTH(irg::polygons_overlap(square, square) == polygon_overlap::overlapping);
  const ring u{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
  CHECK(irg::polygons_overlap(u, ring{{4, 4}, {5, 4}, {5, 8}, {4, 8}}) == polygon_overlap::separate);  // in the bay
  CHECK(irg::polygons_overlap(u, ring{{3, 3}, {6, 3}, {6, 9}, {3, 9}}) == polygon_overlap::touching);  // fills it
  CHECK(irg::polygons_overlap(u, ring{{1, 1}, {2, 1}, {2, 2}, {1, 2}}) == polygon_overlap::overlapping);  // within
  CHECK(irg::polygons_overlap(u, ring{{-1, -1}, {10, -1}, {10, 10}, {-1, 10}}) == polygon_overlap::overlapping);
  CHECK(irg::polygons_overlap(ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, ring{{2, 0}, {4, 2}, {2, 4}, {0, 2}}) ==
        polygon_overlap::overlapping);  // inscribed: every vertex on an edge
  CHECK(irg::polygons_overlap(ring{{0, 0}, {4, 4}, {8, 0}}, ring{{0, 0}, {3, 3}, {0, 9}}) == polygon_overlap::touching);
}

TEST_CASE("overlap: degenerate convex polygons") {
  const auto of = [](const ring& a, const ring& b) {
    const auto one = irg::convex_polygons_overlap(a, b);
    CHECK(irg::convex_polygons_overlap(b, a) == one);
    return one;
  };
  const ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(of({}, square) == polygon_overlap::separate);
  CHECK(of({{2, 2}}, square) == polygon_overlap::touching);
  CHECK(of({{4, 2}}, square) == polygon_overlap::touching);
  CHECK(of({{5, 2}}, square) == polygon_overlap::separate);
  CHECK(of({{5, 2}}, {{5, 2}, {5, 2}}) == polygon_overlap::touching);
  CHECK(of({{5, 2}}, {{5, 3}}) == polygon_overlap::separate);
  CHECK(of({{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}) == polygon_overlap::touching);
  CHECK(of({{0, 0}, {4, 4}}, {{2, 2}, {6, 6}}) == polygon_overlap::touching);
  CHECK(of({{0, 0}, {2, 2}}, {{3, 3}, {6, 6}}) == polygon_overlap::separate);
  CHECK(of({{0, 0}, {2, 2}}, {{0, 1}, {2, 3}}) == polygon_overlap::separate);
  CHECK(of({{1, 1}, {9, 9}}, square) == polygon_overlap::touching);
  CHECK(of({{4, 1}, {4, 9}}, square) == polygon_overlap::touching);
  CHECK(of({{4, 5}, {4, 9}}, square) == polygon_overlap::separate);
  CHECK(irg::polygons_overlap(ring{{1, 1}, {2, 2}}, square) == polygon_overlap::separate);
  CHECK(irg::polygons_overlap(ring{}, square) == polygon_overlap::separate);
}

TEST_CASE("overlap: random convex polygons, segments and points, against areas in rationals") {
  test::random random(121);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 500'000 : 15'000;
  long count[3]{};
  for (int t = 0; t < rounds; ++t) {
    const auto hull = [&] {
      ring points;
      const auto dx = random.integer(0, 4), dy = random.integer(0, 4);
      for (auto n = random.integer(1, 7); n > 0; --n) {
        const int x = static_cast<int>(dx + random.integer(0, 4));
        points.push_back({x, static_cast<int>(dy + random.integer(0, 4))});
      }
      ring out;
      for (const auto i : irg::convex_hull(points, t % 2 == 0 ? irg::side_points::keep : irg::side_points::leave_out))
        out.push_back(points[i]);
      if (out.size() > 2 && test::twice_area(out) == 0) out = {out.front(), out.back()};  // no walking to and fro
      return out;
    };
    const ring a = hull(), b = hull();
    const auto expected = convex_oracle(a, b);
    ++count[static_cast<int>(expected)];
    REQUIRE(irg::convex_polygons_overlap(a, b) == expected);
    REQUIRE(irg::convex_polygons_overlap(b, a) == expected);
    REQUIRE(irg::convex_polygons_overlap(turned_round(a), b) == expected);
    if (test::twice_area(a) != 0 && test::twice_area(b) != 0) {
      REQUIRE(irg::polygons_overlap(a, b) == expected);
      REQUIRE(irg::polygons_overlap(b, turned_round(a)) == expected);
    }
  }
  MESSAGE("separate ", count[0], ", touching ", count[1], ", overlapping ", count[2]);
  CHECK(count[1] > 1000);
}

TEST_CASE("overlap: random simple polygons, against the triangles of both") {
  test::random random(122);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 100'000 : 3000;
  long count[3]{};
  for (int t = 0; t < rounds; ++t) {
    const auto polygon = [&] {
      ring r = test::random_simple(random, static_cast<int>(random.integer(4, 9)), 5);
      const int dx = static_cast<int>(random.integer(0, 5)), dy = static_cast<int>(random.integer(0, 5));
      for (auto& p : r) p = {p.x + dx, p.y + dy};
      if (!r.empty() && random.integer(0, 3) == 0) r.push_back(r.front());  // a repeated vertex
      return r;
    };
    const ring a = polygon(), b = polygon();
    if (a.empty() || b.empty()) continue;
    const auto triangles = [](const ring& r) {
      std::vector<ring> out;
      for (const auto& i : irg::triangulate_monotone(r).triangles) out.push_back({r[i[0]], r[i[1]], r[i[2]]});
      return out;
    };
    auto expected = polygon_overlap::separate;
    for (const ring& p : triangles(a))
      for (const ring& q : triangles(b)) {
        if (test::twice_area(p) == 0 || test::twice_area(q) == 0) continue;
        expected = std::max(expected, irg::convex_polygons_overlap(p, q));
      }
    ++count[static_cast<int>(expected)];
    REQUIRE(irg::polygons_overlap(a, b) == expected);
    REQUIRE(irg::polygons_overlap(b, a) == expected);
    REQUIRE(irg::polygons_overlap(turned_round(a), b) == expected);
  }
  MESSAGE("separate ", count[0], ", touching ", count[1], ", overlapping ", count[2]);
  CHECK(count[1] > 50);
}

TEST_CASE("overlap: a hair apart, at every exponent") {
  for (const double scale : {0x1p-1000, 1.0, 0x1p900}) {
    const auto at = [&](double x, double y) { return P{x * scale, y * scale}; };
    // the line x + y = 24 is the edge of one; the other's corner is beside it by one ulp
    const std::vector<P> below{at(0, 0), at(24, 0), at(0, 24)};
    const auto corner = [&](double y) { return std::vector<P>{at(12.5, y), at(30, 30), at(20, 30)}; };
    CHECK(irg::convex_polygons_overlap(below, corner(11.5)) == polygon_overlap::touching);
    CHECK(irg::convex_polygons_overlap(below, corner(11.5 + 0x1p-49)) == polygon_overlap::separate);
    CHECK(irg::convex_polygons_overlap(below, corner(11.5 - 0x1p-49)) == polygon_overlap::overlapping);
    CHECK(irg::polygons_overlap(below, corner(11.5)) == polygon_overlap::touching);
    CHECK(irg::polygons_overlap(below, corner(11.5 + 0x1p-49)) == polygon_overlap::separate);
    CHECK(irg::polygons_overlap(below, corner(11.5 - 0x1p-49)) == polygon_overlap::overlapping);
  }
}

}  // namespace
