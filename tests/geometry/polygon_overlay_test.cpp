// SPDX-License-Identifier: MIT
#include <irg/geometry/polygon_overlay.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::boolean_operation;
using irg::fill_rule;
using irg::point;
using irg::polygon_boolean;
using irg::polygon_clip_status;
using P = point<double, 2>;
using Ring = std::vector<P>;
using Rings = std::vector<Ring>;

namespace {

constexpr boolean_operation all_operations[] = {boolean_operation::intersection, boolean_operation::union_,
                                                boolean_operation::difference, boolean_operation::symmetric_difference};

template <class R>
constexpr double area(const R& rings) {
  double sum = 0;
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto &p = ring[i], &q = ring[(i + 1) % ring.size()];
      sum += static_cast<double>(p.x) * static_cast<double>(q.y) - static_cast<double>(p.y) * static_cast<double>(q.x);
    }
  return sum / 2;
}
constexpr double area_of(const Ring& a, const Ring& b, boolean_operation op) {
  return area(polygon_boolean(a, b, op).rings);
}

// How often the rings go round a place that is on none of them.
int winding(const Rings& rings, double x, double y) {
  int turns = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const P &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if ((p.x < x) == (q.x < x)) continue;
      const double side = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
      if (p.x < q.x ? side < 0 : 0 < side) turns += p.x < q.x ? -1 : 1;
    }
  return turns;
}

bool expected_inside(bool a, bool b, boolean_operation op) {
  if (op == boolean_operation::intersection) return a && b;
  if (op == boolean_operation::union_) return a || b;
  if (op == boolean_operation::difference) return a && !b;
  return a != b;
}

int release_or(int ci) { return std::getenv("IRG_RELEASE_TIER") ? 50 * ci : ci; }

constexpr Ring square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

}  // namespace

TEST_CASE("polygon_boolean: by hand, in every life") {
  CHECK_BOTH(area_of(square(0, 0, 2), square(1, 1, 2), boolean_operation::intersection) == 1);
  CHECK_BOTH(area_of(square(0, 0, 2), square(1, 1, 2), boolean_operation::union_) == 7);
  CHECK(area_of(square(0, 0, 2), square(1, 1, 2), boolean_operation::difference) == 3);
  CHECK(area_of(square(0, 0, 2), square(1, 1, 2), boolean_operation::symmetric_difference) == 6);
  // A comb cut by a bar falls apart.
  const Ring comb{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const auto teeth = polygon_boolean(comb, Ring{{-1, 2}, {9, 2}, {9, 9}, {-1, 9}});
  CHECK(teeth.rings.size() == 3);
  CHECK(area(teeth.rings) == 3);
  for (const Ring& r : teeth.rings) CHECK(r.size() == 4);
  // A hole: a square out of the middle, one out of an edge.
  const auto frame = polygon_boolean(square(0, 0, 3), square(1, 1, 1), boolean_operation::difference);
  CHECK(frame.rings.size() == 2);
  CHECK(area(frame.rings) == 8);
  const auto again = polygon_boolean(frame.rings, Rings{square(1, 1, 1)}, boolean_operation::union_);
  CHECK(again.rings == Rings{Ring{{0, 0}, {3, 0}, {3, 3}, {0, 3}}});
}

namespace {

struct segment {
  P p, q;
};

// What comparing all pairs of these tells: one round.
constexpr irg::polygon_overlay_counts counted_by_force(const std::vector<segment>& all) {
  irg::polygon_overlay_counts counts{1, 0, 0, 0};
  const auto turn = [](const P& a, const P& b, const P& c) {  // of small whole numbers
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return area < 0 ? -1 : area > 0 ? 1 : 0;
  };
  const auto apart = [](double a, double b, double c, double d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const segment &a = all[i], &b = all[k];
      ++counts.pairs;
      if (!apart(a.p.x, a.q.x, b.p.x, b.q.x) && !apart(a.p.y, a.q.y, b.p.y, b.q.y)) ++counts.compared;
      if (turn(a.p, a.q, b.p) * turn(a.p, a.q, b.q) < 0 && turn(b.p, b.q, a.p) * turn(b.p, b.q, a.q) < 0)
        ++counts.crossings;
    }
  return counts;
}
constexpr std::vector<segment> edges(const Rings& rings) {
  std::vector<segment> all;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) all.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return all;
}
constexpr irg::polygon_overlay_counts sum(const irg::polygon_overlay_counts& a, const irg::polygon_overlay_counts& b) {
  return {a.rounds + b.rounds, a.pairs + b.pairs, a.compared + b.compared, a.crossings + b.crossings};
}

}  // namespace

TEST_CASE("polygon_boolean: what was compared is counted") {
  // Two squares cross at (2, 1) and (1, 2), where four edges fall into two pieces each: 8 pieces, then 12.
  CHECK_BOTH(polygon_boolean(square(0, 0, 2), square(1, 1, 2)).counts ==
             sum(counted_by_force(edges({square(0, 0, 2), square(1, 1, 2)})),
                 counted_by_force(edges({Ring{{0, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}},
                                         Ring{{1, 1}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}}}))));
  const auto crossed = polygon_boolean(square(0, 0, 2), square(1, 1, 2), boolean_operation::union_).counts;
  CHECK(crossed.rounds == 2);
  CHECK(crossed.pairs == 28 + 66);
  CHECK(crossed.crossings == 2);
  // Apart: each edge meets but its two neighbours.
  CHECK(polygon_boolean(square(0, 0, 2), square(5, 5, 2)).counts == irg::polygon_overlay_counts{1, 28, 8, 0});
  // The same square twice is four pieces.
  CHECK(polygon_boolean(square(0, 0, 2), square(0, 0, 2)).counts == irg::polygon_overlay_counts{1, 6, 4, 0});
  // A corner on an edge is no crossing; it cuts that edge.
  const auto touching = polygon_boolean(square(0, 0, 2), Ring{{2, 1}, {4, 0}, {4, 2}}).counts;
  CHECK(touching.crossings == 0);
  CHECK(touching.rounds == 2);
  CHECK(touching.pairs == 21 + 28);
  CHECK(polygon_boolean(Ring{}, Ring{}).counts == irg::polygon_overlay_counts{1, 0, 0, 0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(polygon_boolean(Ring{{0, 0}, {nan, 1}, {1, 1}}, square(0, 0, 1)).counts == irg::polygon_overlay_counts{});
  test::random r(17);
  int wrong = 0, crossing = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto draw = [&](int n, double x) {
      Ring ring;
      for (int i = 0; i < n; ++i)
        ring.push_back({x + static_cast<double>(r.integer(0, 1000)), static_cast<double>(r.integer(0, 1000))});
      return ring;
    };
    const Rings both{draw(9, 0), draw(11, 300)};
    const auto expected = counted_by_force(edges(both));
    const auto found = polygon_boolean(both[0], both[1]).counts;
    crossing += static_cast<int>(expected.crossings);
    wrong += found.crossings != expected.crossings || found.rounds < 2 || found.pairs < expected.pairs ||
             found.compared < expected.compared || found.compared > found.pairs;
  }
  CHECK(wrong == 0);
  CHECK(crossing > 1000);
}

TEST_CASE("polygon_boolean: shared edges, touching vertices, equal polygons") {
  const Ring a = square(0, 0, 2);
  CHECK(polygon_boolean(a, a).rings == Rings{a});
  CHECK(polygon_boolean(a, a, boolean_operation::union_).rings == Rings{a});
  CHECK(polygon_boolean(a, a, boolean_operation::difference).rings.empty());
  CHECK(polygon_boolean(a, a, boolean_operation::symmetric_difference).rings.empty());
  const Ring back(a.rbegin(), a.rend());
  CHECK(area(polygon_boolean(a, back).rings) == 4);
  // Side by side: nothing in common, one rectangle.
  CHECK(polygon_boolean(a, square(2, 0, 2)).rings.empty());
  CHECK(polygon_boolean(a, square(2, 0, 2), boolean_operation::union_).rings ==
        Rings{Ring{{0, 0}, {4, 0}, {4, 2}, {0, 2}}});
  CHECK(area(polygon_boolean(a, square(2, 1, 2), boolean_operation::union_).rings) == 8);
  // Corner to corner: two pieces.
  CHECK(polygon_boolean(a, square(2, 2, 2)).rings.empty());
  CHECK(polygon_boolean(a, square(2, 2, 2), boolean_operation::union_).rings.size() == 2);
  // A corner on an edge, from within and from without; a common part of an edge from within.
  CHECK(area(polygon_boolean(a, Ring{{1, 0}, {1.5, 1}, {0.5, 1}}).rings) == 0.5);
  CHECK(polygon_boolean(a, Ring{{1, 0}, {1.5, -1}, {0.5, -1}}).rings.empty());
  CHECK(area(polygon_boolean(a, Ring{{0.5, 0}, {1.5, 0}, {1, 1}}, boolean_operation::difference).rings) == 3.5);
  // A hole that touches its outline in a corner.
  const auto touched = polygon_boolean(a, Ring{{0, 0}, {1, 0.5}, {0.5, 1}}, boolean_operation::difference);
  CHECK(area(touched.rings) == 4 - 0.375);
  CHECK(touched.rings.size() == 1);
}

TEST_CASE("polygon_boolean: what crosses itself goes by the rule; degenerate and hostile input") {
  const Ring bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const Ring all = square(-9, -9, 20);
  CHECK(polygon_boolean(bow, all).rings.size() == 2);
  CHECK(area(polygon_boolean(bow, all).rings) == 2);
  const Ring twice{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(polygon_boolean(twice, all).rings.empty());
  CHECK(area(polygon_boolean(twice, all, boolean_operation::intersection, fill_rule::non_zero).rings) == 4);
  const Ring spike{{0, 0}, {2, 0}, {2, 2}, {5, 2}, {2, 2}, {0, 2}};
  CHECK(polygon_boolean(spike, all).rings == Rings{square(0, 0, 2)});
  for (const Ring& flat :
       {Ring{}, Ring{{1, 1}}, Ring{{0, 0}, {1, 1}}, Ring{{0, 0}, {1, 1}, {2, 2}}, Ring(5, P{1, 1})}) {
    CHECK(polygon_boolean(flat, all).rings.empty());
    CHECK(polygon_boolean(all, flat, boolean_operation::difference).rings == Rings{all});
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf})
    for (int i = 0; i < 4; ++i) {
      Ring broken = square(0, 0, 2);
      broken[static_cast<std::size_t>(i)][i % 2] = bad;
      CHECK((polygon_boolean(all, all) && !polygon_boolean(broken, all)));
      CHECK(polygon_boolean(broken, all).status == polygon_clip_status::not_finite);
      CHECK(polygon_boolean(all, broken).status == polygon_clip_status::not_finite);
    }
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const Ring huge{{-most, -most}, {most, -most}, {most, most}, {-most, most}};
  CHECK(polygon_boolean(huge, square(0, 0, 2)).rings == Rings{square(0, 0, 2)});
  const auto quarter = polygon_boolean(huge, Ring{{0, 0}, {most, 0}, {0, most}});
  CHECK(quarter.rings == Rings{Ring{{0, 0}, {most, 0}, {0, most}}});
  const Ring dust{{0, 0}, {4 * least, 0}, {4 * least, 4 * least}, {0, 4 * least}};
  const auto grain =
      polygon_boolean(dust, Ring{{2 * least, 2 * least}, {9 * least, 2 * least}, {2 * least, 9 * least}});
  CHECK(grain.rings.size() == 1);
}

TEST_CASE("polygon_boolean: samples and areas, polygons of all kinds") {
  test::random r(1);
  int wrong = 0, rings_found = 0;
  for (int k = 0; k < release_or(250); ++k) {
    const auto draw = [&](int n, double size) {
      Ring ring;
      for (int i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n, radius = size * (0.2 + 0.8 * r.unit());
        ring.push_back({radius * std::cos(angle) + 0.1, radius * std::sin(angle)});
      }
      return ring;
    };
    Rings a{draw(static_cast<int>(r.integer(3, 25)), 3)}, b{draw(static_cast<int>(r.integer(3, 25)), 3)};
    if (r.integer(0, 1) != 0) a.push_back(draw(5, 0.5));  // a hole, or something over the rim
    if (r.integer(0, 2) == 0) {                           // crosses itself
      Ring wild;
      for (int i = 0; i < 7; ++i) wild.push_back({r.unit() * 6 - 3, r.unit() * 6 - 3});
      b = {wild};
    }
    const auto rule = r.integer(0, 1) != 0 ? fill_rule::even_odd : fill_rule::non_zero;
    const auto inside = [&](const Rings& rings, double x, double y) {
      const int w = winding(rings, x, y);
      return rule == fill_rule::even_odd ? w % 2 != 0 : w != 0;
    };
    double areas[4];
    for (std::size_t o = 0; o < 4; ++o) {
      const auto result = polygon_boolean(a, b, all_operations[o], rule);
      wrong += result.status == polygon_clip_status::ok ? 0 : 1;
      areas[o] = area(result.rings);
      rings_found += static_cast<int>(result.rings.size());
      for (int s = 0; s < 20; ++s) {
        const double x = r.unit() * 6 - 3, y = r.unit() * 6 - 3;
        const int w = winding(result.rings, x, y);
        wrong += w == (expected_inside(inside(a, x, y), inside(b, x, y), all_operations[o]) ? 1 : 0) ? 0 : 1;
      }
      // Clipped to itself it stays as it is.
      const auto again = polygon_boolean(result.rings, result.rings, boolean_operation::intersection, rule);
      wrong += std::abs(area(again.rings) - areas[o]) <= 0 ? 0 : 1;
    }
    // A polygon cut off and put together: (a - b) + (a and b) = a, and what the identity says of all four.
    wrong += std::abs(areas[1] - areas[0] - areas[3]) <= 1e-13 ? 0 : 1;
    const double whole_a = area(polygon_boolean(a, Rings{}, boolean_operation::union_, rule).rings);
    const double whole_b = area(polygon_boolean(b, Rings{}, boolean_operation::union_, rule).rings);
    wrong += std::abs(whole_a + whole_b - areas[0] - areas[1]) <= 1e-13 ? 0 : 1;
    wrong += std::abs(whole_a - areas[0] - areas[2]) <= 1e-13 ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(rings_found > 2000);
}

TEST_CASE("polygon_boolean: on a lattice, where everything touches and overlaps") {
  test::random r(2);
  int wrong = 0, touching = 0;
  for (int k = 0; k < release_or(1500); ++k) {
    const auto draw = [&] {
      Ring ring;
      const auto n = r.integer(3, 9);
      for (int i = 0; i < n; ++i)
        ring.push_back({static_cast<double>(r.integer(0, 4)), static_cast<double>(r.integer(0, 4))});
      return Rings{ring};
    };
    const Rings a = draw(), b = draw();
    double areas[4];
    for (std::size_t o = 0; o < 4; ++o) {
      const auto result = polygon_boolean(a, b, all_operations[o]);
      wrong += result.status == polygon_clip_status::ok ? 0 : 1;
      areas[o] = area(result.rings);
      for (int s = 0; s < 10; ++s) {
        const double x = r.unit() * 4, y = r.unit() * 4;
        const bool in_a = winding(a, x, y) % 2 != 0, in_b = winding(b, x, y) % 2 != 0;
        wrong += winding(result.rings, x, y) == (expected_inside(in_a, in_b, all_operations[o]) ? 1 : 0) ? 0 : 1;
      }
    }
    touching += areas[0] == 0 ? 1 : 0;
    wrong += std::abs(areas[1] - areas[0] - areas[3]) <= 1e-14 * 16 ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(touching > 20);
}

TEST_CASE("polygon_boolean: integers, plain arrays, a ring against a list of rings") {
  using I = point<int, 2>;
  constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
  constexpr auto whole = [] {
    constexpr I square[] = {{least, least}, {most, least}, {most, most}, {least, most}};
    const std::vector<std::vector<I>> holed{{{least, 0}, {most, 0}, {most, 9}, {least, 9}},
                                            {{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
    const auto both = irg::polygon_boolean(square, holed);
    return both.rings.size() == 2 && area(both.rings) == 9 * 0x1.fffffffep31 - 1;
  };
  CHECK_BOTH(whole());
  // Crossings are doubles.
  constexpr auto crossing = [] {
    constexpr I a[] = {{0, 0}, {1, 0}, {1, 1}}, b[] = {{0, 1}, {1, 0}, {1, 1}};
    const auto both = irg::polygon_boolean(a, b);
    return both.rings.size() == 1 && both.rings[0].size() == 3 && both.rings[0][0] == P{0.5, 0.5};
  };
  CHECK_BOTH(crossing());
}

TEST_CASE("polygon_boolean: ends within an ulp of edges; float") {
  test::random r(3);
  int wrong = 0;
  for (int k = 0; k < release_or(400); ++k) {
    // Thin triangles on nearly one line: crossings are rounded across their neighbours.
    using F = point<float, 2>;
    const auto near_line = [&](float x) {
      const auto off = static_cast<float>(r.integer(-3, 3)) * 0x1p-23f;
      return F{x, 0.3f * x + 1 + off};
    };
    const auto draw = [&] {
      std::vector<F> ring;
      for (int i = 0; i < 6; ++i) ring.push_back(near_line(static_cast<float>(r.unit())));
      return ring;
    };
    const auto a = draw(), b = draw();
    double areas[4];
    for (std::size_t o = 0; o < 4; ++o) {
      const auto result = polygon_boolean(a, b, all_operations[o]);
      wrong += result.status == polygon_clip_status::ok ? 0 : 1;
      areas[o] = area(result.rings);
      wrong += areas[o] >= 0 ? 0 : 1;
      const auto again = polygon_boolean(result.rings, result.rings);
      wrong += area(again.rings) == areas[o] ? 0 : 1;
    }
    wrong += std::abs(areas[1] - areas[0] - areas[3]) <= 1e-14 ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("polygon_boolean: polygons of many edges, few of which overlap in x") {
  const int n = 2000;
  Ring circle, saw{P{n + 0.5, -1}, P{-1, -1}}, shifted;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    circle.push_back({std::cos(angle), std::sin(angle)});
    shifted.push_back({circle.back().x + 0.5, circle.back().y});
    saw.push_back({static_cast<double>(i), i % 2 == 0 ? 0.0 : 1.0});
  }
  for (const auto operation : {boolean_operation::intersection, boolean_operation::union_}) {
    const auto lens = polygon_boolean(circle, shifted, operation);
    CHECK((lens.status == polygon_clip_status::ok && lens.rings.size() == 1));
  }
  const auto teeth = polygon_boolean(saw, Ring{{-2, 0.5}, {n + 2, 0.5}, {n + 2, 2}, {-2, 2}});
  CHECK((teeth.status == polygon_clip_status::ok && teeth.rings.size() == n / 2));
}
