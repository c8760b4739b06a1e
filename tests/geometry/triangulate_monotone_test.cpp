// SPDX-License-Identifier: MIT
#include <irg/geometry/triangulate_monotone.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/lattice_polygons.hpp"
#include "support/rational.hpp"

namespace {

using irg::triangulation_status;
using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
using ring = test::lattice_ring;
using rings = std::vector<ring>;

std::vector<ring> triangles_of(const irg::triangulation& t, const rings& polygon) {
  ring all;
  for (const ring& r : polygon) all.insert(all.end(), r.begin(), r.end());
  std::vector<ring> out;
  for (const auto& i : t.triangles) out.push_back({all[i[0]], all[i[1]], all[i[2]]});
  return out;
}

enum class corners { may_touch, stand_alone };

/// The number of triangles, none of them turned over (nor flat, where nothing touches), and each sample point in as
/// many of them as the even-odd rule says; sample points lie off all lines between vertices.
void check(const rings& polygon, corners how, std::size_t count) {
  const auto t = irg::triangulate_monotone(polygon);
  REQUIRE(t.status == triangulation_status::ok);
  REQUIRE(t.triangles.size() == count);
  const bool forward = test::twice_area(polygon[0]) >= 0;
  const auto triangles = triangles_of(t, polygon);
  for (const ring& r : triangles) {
    const std::int64_t area = forward ? test::twice_area(r) : -test::twice_area(r);
    REQUIRE(area >= (how == corners::stand_alone ? 1 : 0));
  }
  I low = polygon[0][0], high = low;
  for (const ring& r : polygon)
    for (const I& p : r) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const int step_x = (high.x - low.x) / 20 + 1, step_y = (high.y - low.y) / 20 + 1;
  for (int y = low.y; y < high.y; y += step_y)
    for (int x = low.x; x < high.x; x += step_x) {
      int inside = 0;
      for (const ring& r : polygon) inside += test::windings(r, {x, y});
      const auto covers = std::count_if(triangles.begin(), triangles.end(),
                                        [&](const ring& r) { return test::windings(r, {x, y}) != 0; });
      REQUIRE(covers == (inside % 2 != 0 ? 1 : 0));
    }
}
void check_simple(const ring& r) { check({r}, corners::stand_alone, r.size() - 2); }

ring turned_round(ring r) {
  std::reverse(r.begin(), r.end());
  return r;
}
ring comb(int teeth) {
  ring r = {{0, 0}, {2 * teeth, 0}};
  for (int i = teeth; i-- > 0;) {
    r.push_back({2 * i + 1, 100});
    r.push_back({2 * i, 1});
  }
  return r;
}

constexpr std::uint64_t digest(const irg::triangulation& t) {
  std::uint64_t h = 14695981039346656037u + static_cast<std::uint64_t>(t.status);
  for (const auto& triangle : t.triangles)
    for (const auto i : triangle) h = (h ^ i) * 1099511628211u;
  return h;
}

TEST_CASE("triangulate_monotone: at compile time as at run time") {
  constexpr auto l_shape = [] {
    return irg::triangulate_monotone(ring{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  };
  CHECK_BOTH(l_shape().triangles.size() == 4);
  constexpr auto spiked = [] {
    return irg::triangulate_monotone(ring{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, -1}, {4, 8}, {0, 8}}).status;
  };
  CHECK_BOTH(spiked() == triangulation_status::crossing);
  constexpr auto constant = digest(l_shape());
  CHECK(digest(l_shape()) == constant);
  constexpr auto frame = [] {
    return irg::triangulate_monotone(rings{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}});
  };
  CHECK_BOTH(frame().triangles.size() == 8);
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  constexpr auto dart = [](double notch) {  // the notch lies off the diagonal by the least there is
    return irg::triangulate_monotone(std::vector<P>{{-most, -most}, {most, -most}, {most, most}, {-notch, notch}});
  };
  CHECK_BOTH(dart(least).triangles.size() == 2);
  CHECK_BOTH(dart(-least).triangles.size() == 2);
  CHECK_BOTH(irg::triangulate_monotone(ring{{0, 0}, {4, 4}, {4, 0}, {0, 4}}).status == triangulation_status::crossing);
  CHECK_BOTH(irg::triangulate_monotone(ring{}).triangles.empty());
}

TEST_CASE("triangulate_monotone: named shapes, both ways round, from every start") {
  const ring shapes[] = {{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}},  // concave pentagon
                         {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}},  // square with flat vertices
                         {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 3}},  // triangle with flat vertices
                         {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 1}},  // and on every side
                         {{0, 0}, {10, 0}, {10, 10}, {5, 1}},  // dart
                         {{0, 3}, {3, 3}, {4, 0}, {5, 3}, {8, 3}, {6, 5}, {7, 8}, {4, 6}, {1, 8}, {2, 5}},  // star
                         {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 4}, {4, 4}, {4, 2}, {0, 2}},  // C, collinear runs
                         {{0, 0}, {8, 0}, {8, 2}, {6, 2}, {6, 4}, {4, 4}, {4, 6}, {2, 6}, {2, 8}, {0, 8}},  // stairs
                         {{0, 0}, {1, 1000000}, {2, 0}, {1, 999999}},  // sliver notch
                         {{44, 27}, {7, 37}, {7, 19}, {38, 19}},
                         comb(9)};
  for (ring r : shapes) {
    REQUIRE(test::is_simple(r));
    for (std::size_t start = 0; start < r.size(); ++start) {
      check_simple(r);
      check_simple(turned_round(r));
      std::rotate(r.begin(), r.begin() + 1, r.end());
    }
  }
}

TEST_CASE("triangulate_monotone: holes, islands, several rings, rings that touch") {
  const ring outer{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, hole{{4, 4}, {4, 16}, {16, 16}, {16, 4}},
      island{{8, 8}, {12, 8}, {12, 12}, {8, 12}}, beside{{30, 0}, {40, 0}, {35, 9}};
  for (const bool round : {false, true}) {
    const ring inner = round ? turned_round(hole) : hole;
    check({outer, inner}, corners::stand_alone, 8);
    check({inner, outer}, corners::stand_alone, 8);
    check({outer, inner, island}, corners::stand_alone, 10);
    check({island, outer, inner, beside}, corners::stand_alone, 11);
    check({turned_round(outer), inner}, corners::stand_alone, 8);
  }
  check({outer, {{0, 5}, {0, 15}, {5, 15}, {5, 5}}}, corners::may_touch, 8);  // a hole that shares part of an edge
  check({outer, {{0, 0}, {0, 20}, {5, 15}, {5, 5}}}, corners::may_touch, 8);  // a whole edge
  check({outer, {{0, 0}, {1, 4}, {4, 1}}}, corners::may_touch, 7);  // a vertex
  check({{{0, 0}, {1, 4}, {4, 1}}, outer}, corners::may_touch, 7);  // one wedge within another, the inner one first
  check({{{0, 0}, {9, 4}, {4, 9}}, {{0, 0}, {6, 4}, {4, 6}}, outer}, corners::may_touch, 8);
  check({outer, {{0, 10}, {4, 14}, {4, 6}}}, corners::may_touch, 7);  // a vertex within an edge
  check({outer, {{10, 10}, {4, 14}, {4, 6}}, {{10, 10}, {16, 6}, {16, 14}}}, corners::may_touch, 12);  // each other
  check({outer, turned_round(outer)}, corners::may_touch, 8);  // nothing is left
  // squares whose holes are joined by bridges that are walked twice
  check({{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}}}, corners::may_touch, 8);
  check({{{0, 0},
          {9, 0},
          {9, 9},
          {0, 9},
          {0, 0},
          {1, 1},
          {1, 3},
          {3, 3},
          {1, 1},
          {0, 0},
          {4, 1},
          {8, 5},
          {8, 1},
          {4, 1}}},
        corners::may_touch, 12);
  check({{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 6}, {6, 6}, {6, 2}, {2, 2}, {2, 6}, {0, 8}}}, corners::may_touch, 8);
  check({{{0, 0},
          {33, 23},
          {32, 19},
          {27, 17},
          {32, 22},
          {33, 23},
          {0, 0},
          {40, 0},
          {40, 40},
          {0, 40},
          {4, 31},
          {6, 34},
          {10, 32},
          {9, 28},
          {5, 29},
          {4, 31},
          {0, 40}}},
        corners::may_touch, 15);
  // spikes outwards and inwards, repeated vertices
  ring spiked{{0, 0}, {4, 0}, {4, 4}, {9, 9}, {4, 4}, {1, 3}, {3, 2}, {1, 3}, {0, 4}, {0, 4}, {0, 0}};
  for (std::size_t start = 0; start < spiked.size(); ++start) {
    check({spiked}, corners::may_touch, spiked.size() - 2);
    std::rotate(spiked.begin(), spiked.begin() + 1, spiked.end());
  }
}

TEST_CASE("triangulate_monotone: rings without area, and what crosses") {
  const auto flat = [](const ring& r) { check({r}, corners::may_touch, r.size() < 3 ? 0 : r.size() - 2); };
  flat({{1, 1}});
  flat({{1, 1}, {2, 3}});
  flat({{1, 1}, {2, 3}, {3, 5}});
  flat({{1, 1}, {1, 1}, {1, 1}, {1, 1}});
  flat({{0, 0}, {4, 0}, {0, 0}, {4, 0}, {0, 0}});
  flat({{0, 0}, {3, 0}, {1, 0}, {5, 0}, {2, 0}});
  const auto state = [](const auto& polygon) { return irg::triangulate_monotone(polygon).status; };
  CHECK(state(rings{}) == triangulation_status::ok);
  CHECK(state(rings{{}, {}}) == triangulation_status::ok);
  CHECK(state(ring{{0, 0}, {4, 4}, {4, 0}, {0, 4}}) == triangulation_status::crossing);  // bow-tie
  CHECK(state(ring{{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}}) == triangulation_status::crossing);  // at a vertex
  CHECK(state(ring{{0, 0}, {5, 9}, {10, 0}, {0, 6}, {10, 6}}) == triangulation_status::crossing);  // pentagram
  CHECK(state(ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}) == triangulation_status::crossing);
  CHECK(state(rings{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 2}, {6, 2}, {6, 6}}}) == triangulation_status::crossing);
  CHECK(irg::triangulate_monotone(ring{{0, 0}, {4, 4}, {4, 0}, {0, 4}}).triangles.empty());
  constexpr double inf = std::numeric_limits<double>::infinity(), nan_ = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {inf, -inf, nan_}) {
    CHECK(state(std::vector<P>{{0, 0}, {1, bad}, {0, 1}}) == triangulation_status::not_finite);
    CHECK(irg::triangulate_monotone(std::vector<P>{{0, 0}, {1, 0}, {bad, 1}}).triangles.empty());
  }
}

TEST_CASE("triangulate_monotone: random simple polygons") {
  test::random random(71);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 200'000 : 600;
  int simple = 0;
  for (int i = 0; i < rounds; ++i) {
    const int n = static_cast<int>(random.integer(4, i % 20 == 0 ? 60 : 14));
    const ring r = test::random_simple(random, n, static_cast<int>(n / 4 + random.integer(3, 16)));
    if (r.empty()) continue;
    ++simple;
    check_simple(i % 2 == 0 ? r : turned_round(r));
  }
  CHECK(simple > rounds / 2);
}

TEST_CASE("triangulate_monotone: outlines of random cells, which touch at corners, with holes and islands") {
  test::random random(72);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 100'000 : 400;
  std::size_t triangles = 0;
  for (int i = 0; i < rounds; ++i) {
    rings r = test::outlines(random, static_cast<int>(random.integer(1, 7)), static_cast<int>(random.integer(1, 7)),
                             static_cast<int>(random.integer(30, 90)));
    if (r.empty()) continue;
    std::size_t count = 0;
    for (ring& one : r) {
      count += one.size();
      if (test::twice_area(one) > 0)
        count -= 2;
      else
        count += 2;
      if (random.integer(0, 2) == 0) std::reverse(one.begin(), one.end());
      std::rotate(one.begin(), one.begin() + random.integer(0, static_cast<std::int64_t>(one.size()) - 1), one.end());
    }
    std::rotate(r.begin(), r.begin() + random.integer(0, static_cast<std::int64_t>(r.size()) - 1), r.end());
    check(r, corners::may_touch, count);
    triangles += count;
  }
  MESSAGE(rounds, " sets of cells, ", triangles, " triangles");
}

TEST_CASE("triangulate_monotone: every ring of five vertices on a small lattice: crossings are found, and no others") {
  const auto at = [](int i) { return I{i % 3, i / 3}; };
  long complete = 0, crossing = 0;
  const int step = std::getenv("IRG_RELEASE_TIER") ? 1 : 7;
  for (int code = 0; code < 9 * 9 * 9 * 9 * 9; code += step) {
    const ring r{at(code % 9), at(code / 9 % 9), at(code / 81 % 9), at(code / 729 % 9), at(code / 6561)};
    const auto t = irg::triangulate_monotone(r);
    // without the spikes and the steps to the same place, which go as triangles without area
    ring core = r;
    for (std::size_t i = 0; i < core.size() && core.size() > 2;) {
      const std::size_t n = core.size();
      const I &a = core[(i + n - 1) % n], &b = core[i], &c = core[(i + 1) % n];
      const int along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
      if (test::cross(a, b, c) == 0 && along <= 0) {
        core.erase(core.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
      } else {
        ++i;
      }
    }
    const bool crosses = test::ways_cross({r});
    if (crosses) REQUIRE(t.status == triangulation_status::crossing);
    if (test::is_simple(core) && !crosses) REQUIRE(t.status == triangulation_status::ok);
    if (t.status != triangulation_status::ok) {
      ++crossing;
      continue;
    }
    ++complete;
    REQUIRE(t.triangles.size() == 3);
    std::int64_t sum = 0;
    for (const ring& one : triangles_of(t, {r})) {
      REQUIRE(test::twice_area(one) * test::twice_area(r) >= 0);
      sum += test::twice_area(one);
    }
    REQUIRE(sum == test::twice_area(r));
  }
  MESSAGE(complete, " complete, ", crossing, " crossing");
}

TEST_CASE("triangulate_monotone: a spike through a side crosses it, a spike up to it does not") {
  const auto state = [](const auto& polygon) { return irg::triangulate_monotone(polygon).status; };
  const auto spiked = [](const I& tip) { return ring{{0, 0}, {8, 0}, {8, 8}, {4, 8}, tip, {4, 8}, {0, 8}}; };
  CHECK(state(spiked({4, 3})) == triangulation_status::ok);
  CHECK(state(spiked({4, 0})) == triangulation_status::ok);  // up to a side
  CHECK(state(spiked({4, -1})) == triangulation_status::crossing);  // through it
  CHECK(state(spiked({0, 0})) == triangulation_status::ok);  // up to a vertex
  CHECK(state(spiked({-4, -8})) == triangulation_status::crossing);
  CHECK(state(spiked({4, 20})) == triangulation_status::ok);  // outwards
  CHECK(state(spiked({20, 8})) == triangulation_status::ok);  // along a side
  // a spike of two links, whose bend lies on a side
  CHECK(state(ring{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 0}, {5, -3}, {4, 0}, {4, 8}, {0, 8}}) ==
        triangulation_status::crossing);
  CHECK(state(ring{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 0}, {5, 3}, {4, 0}, {4, 8}, {0, 8}}) ==
        triangulation_status::ok);
  // two spikes, apart and across each other; a flat ring through a side
  CHECK(state(ring{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 2}, {4, 8}, {0, 8}, {0, 4}, {4, 4}, {0, 4}}) ==
        triangulation_status::ok);
  CHECK(state(ring{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 2}, {4, 8}, {0, 8}, {0, 4}, {7, 4}, {0, 4}}) ==
        triangulation_status::crossing);
  const ring square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  CHECK(state(rings{square, {{2, 2}, {12, 2}, {2, 2}, {12, 2}}}) == triangulation_status::crossing);
  CHECK(state(rings{square, {{2, 2}, {8, 2}, {2, 2}, {5, 2}}}) == triangulation_status::ok);
}

TEST_CASE("triangulate_monotone: random simple polygons with spikes, pauses and straight vertices") {
  test::random random(75);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 300'000 : 5000;
  int complete = 0, crossing = 0;
  for (int i = 0; i < rounds; ++i) {
    ring r =
        test::random_simple(random, static_cast<int>(random.integer(3, 9)), static_cast<int>(random.integer(4, 12)));
    if (r.empty()) continue;
    for (auto extra = random.integer(1, 3); extra > 0; --extra) {
      const auto vertex = [&] { return random.integer(0, static_cast<std::int64_t>(r.size()) - 1); };
      const auto any = [&] {
        const int x = static_cast<int>(random.integer(-1, 12));
        return I{x, static_cast<int>(random.integer(-1, 12))};
      };
      const auto at = r.begin() + vertex() + 1;
      const I root = at[-1], tip = random.integer(0, 2) == 0 ? r[static_cast<std::size_t>(vertex())] : any();
      const auto kind = random.integer(0, 3);
      if (kind == 0)
        r.insert(at, root);
      else if (kind == 1)
        r.insert(at, {tip, any(), tip, root});
      else
        r.insert(at, {tip, root});
    }
    if (i % 2 == 0) r = turned_round(r);
    const auto t = irg::triangulate_monotone(r);
    const bool crosses = test::ways_cross({r});
    REQUIRE((t.status == triangulation_status::crossing) == crosses);
    REQUIRE(static_cast<bool>(t) != crosses);
    ++(crosses ? crossing : complete);
    if (!crosses) check({r}, corners::may_touch, r.size() - 2);
  }
  MESSAGE(complete, " complete, ", crossing, " crossing");
  CHECK((complete > rounds / 10 && crossing > rounds / 10));
}

TEST_CASE("triangulate_monotone: random rings that cross or touch: whatever is cut is right") {
  test::random random(73);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 300'000 : 5000;
  long complete = 0, crossing = 0;
  for (int i = 0; i < rounds; ++i) {
    rings polygon(static_cast<std::size_t>(random.integer(1, 3)));
    for (ring& r : polygon)
      for (auto n = random.integer(3, 7); n > 0; --n) {
        const int x = static_cast<int>(random.integer(0, 4));
        r.push_back({x, static_cast<int>(random.integer(0, 4))});
      }
    const auto t = irg::triangulate_monotone(polygon);
    ++(t.status == triangulation_status::ok ? complete : crossing);
    if (test::ways_cross(polygon)) REQUIRE(t.status == triangulation_status::crossing);
    if (t.status == triangulation_status::ok) check(polygon, corners::may_touch, t.triangles.size());
  }
  MESSAGE(complete, " complete, ", crossing, " crossing");
  CHECK(complete > 500);
}

TEST_CASE("triangulate_monotone: ears of one ulp, hostile exponents, other numbers") {
  // a star whose ears stand out of a line by one ulp
  for (const double scale : {0x1p-1040, 0x1p-500, 1.0, 0x1p500, 0x1p1000}) {
    std::vector<P> saw{{0, 0}, {65, 0}, {65, 4}};
    for (int i = 64; i > 0; --i)
      saw.push_back({static_cast<double>(i), i % 2 == 0 ? 4.0 : i % 4 == 1 ? std::nextafter(4.0, 5.0) : 4 - 0x1p-51});
    saw.push_back({0, 4});
    for (P& p : saw) p = {p.x * scale, p.y * scale};
    const auto t = irg::triangulate_monotone(saw);
    REQUIRE(t.status == triangulation_status::ok);
    REQUIRE(t.triangles.size() == saw.size() - 2);
    irg::exact_accumulator<2> difference;
    const auto add = [&](const P& a, const P& b) { difference.add(a.x, b.y), difference.subtract(a.y, b.x); };
    for (const auto& i : t.triangles) {
      if (scale > 0x1p-1000) REQUIRE(irg::orient2d(saw[i[0]], saw[i[1]], saw[i[2]]) == 1);
      for (std::size_t k = 0; k < 3; ++k) add(saw[i[k]], saw[i[(k + 1) % 3]]);
    }
    for (std::size_t i = 0; i < saw.size(); ++i) add(saw[(i + 1) % saw.size()], saw[i]);
    REQUIRE(difference.sign() == 0);
  }
  using Q = irg::point<test::rational, 2>;
  const std::vector<Q> dart{{0, 0}, {{1, 3}, {1, 9}}, {1, 0}, {{1, 3}, 1}};
  CHECK(irg::triangulate_monotone(dart).triangles.size() == 2);
}

TEST_CASE("triangulate_monotone: a million vertices") {
  const auto check_area = [](const std::vector<P>& r) {
    const auto t = irg::triangulate_monotone(r);
    REQUIRE(t.status == triangulation_status::ok);
    REQUIRE(t.triangles.size() == r.size() - 2);
    long wrong = 0;
    for (const auto& i : t.triangles) wrong += irg::orient2d(r[i[0]], r[i[1]], r[i[2]]) <= 0;
    CHECK(wrong == 0);
  };
  test::random random(74);
  std::vector<P> jagged, saw;
  constexpr int n = 30'000;
  for (int i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * i / n, r = 1 + random.unit() * 0.5;
    jagged.push_back({r * std::cos(t), r * std::sin(t)});
  }
  check_area(jagged);
  saw = {{0, -1}, {n, -1}};
  for (int i = n; i >= 0; --i) saw.push_back({static_cast<double>(i), i % 2 == 0 ? 0 : 1e6 + random.unit()});
  check_area(saw);
  if (std::getenv("IRG_RELEASE_TIER")) {
    std::vector<P> many;
    for (int i = 0; i < 1'000'000; ++i) {
      const double t = 6.283185307179586 * i / 1'000'000, r = 1 + random.unit();
      many.push_back({r * std::cos(t), r * std::sin(t)});
    }
    check_area(many);
  }
}

}  // namespace
