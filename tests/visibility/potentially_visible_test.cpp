// SPDX-License-Identifier: MIT
#include <irg/visibility/potentially_visible.hpp>

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/house_plans.hpp"

namespace {

using plan = irg::cell_plan<double>;
using at = irg::point<double, 2>;

// Unit cells A, B, C in a row, E above B and G above C: no line through AB and BC rises, so none reaches G.
constexpr plan five_cells() {
  const auto unit = [](double x, double y) {
    return irg::plan_cell<double>{{at{x, y}, at{x + 1, y}, at{x + 1, y + 1}, at{x, y + 1}}};
  };
  return {{unit(0, 0), unit(1, 0), unit(2, 0), unit(1, 1), unit(2, 1)},
          {{0, 1, at{1, 0.4}, at{1, 0.6}},
           {1, 2, at{2, 0}, at{2, 0.2}},
           {1, 3, at{1.8, 1}, at{2, 1}},
           {2, 4, at{2, 1}, at{2.2, 1}}}};
}

constexpr unsigned row_of(const irg::visible_sets& s, int from) {
  return static_cast<unsigned>(s.seen.row(from, 0)[0]);
}

TEST_CASE("potentially_visible: a cell round a corner") {
  CHECK_BOTH(row_of(irg::potentially_visible(five_cells()), 0) == 0b01111u);
  CHECK_BOTH(row_of(irg::potentially_visible(five_cells()), 4) == 0b10110u);
  CHECK_BOTH(row_of(irg::connected_cells(irg::portal_graph(five_cells()), 5), 0) == 0b11111u);
  CHECK_BOTH(row_of(irg::connected_cells(irg::portal_graph(five_cells()), 1), 0) == 0b00011u);
  CHECK_BOTH(irg::potentially_visible(plan{}).seen.count() == 0);
}

TEST_CASE("potentially_visible: a search that is too long sees all that is connected") {
  plan p = five_cells();
  p.cells.push_back({{at{9, 9}, at{10, 9}, at{10, 10}}});
  const auto sets = irg::potentially_visible(p, {3});
  CHECK(sets.unfinished == 5);
  CHECK(row_of(sets, 0) == 0b011111u);
  CHECK(row_of(sets, 5) == 0b100000u);
}

TEST_CASE("potentially_visible: a portal without length, and one that was not validated") {
  plan p = five_cells();
  p.portals[0].b = p.portals[0].a;
  CHECK(row_of(irg::potentially_visible(p), 0) == 0b00001u);
  for (int from = 1; from < 5; ++from) CHECK((row_of(irg::potentially_visible(p), from) & 1u) == 0);
  p = five_cells();
  p.portals.push_back({0, 0, at{0, 0}, at{0, 1}});
  CHECK(irg::potentially_visible(p, {100}).seen.is_full({1, 0, 0}));
}

// Three doors in a row that a line passes only by touching the ends of all three, and the same a little wider.
TEST_CASE("potentially_visible: a line that only touches ends does not see") {
  const auto doors = [](double lower) {
    plan p;
    for (int i = 0; i < 4; ++i) {
      const double x = i;
      p.cells.push_back({{at{x, 0}, at{x + 1, 0}, at{x + 1, 4}, at{x, 4}}});
    }
    p.portals = {{0, 1, at{1, 1}, at{1, 2}}, {1, 2, at{2, 2}, at{2, 3}}, {2, 3, at{3, lower}, at{3, 2}}};
    return p;
  };
  CHECK(irg::validate(doors(1)) == irg::plan_finding{});
  CHECK(row_of(irg::potentially_visible(doors(1)), 0) == 0b0111u);
  plan wider = doors(1);
  wider.portals[2].b = at{3, 2 + 0x1p-51};
  CHECK(row_of(irg::potentially_visible(wider), 0) == 0b1111u);
}

TEST_CASE("potentially_visible: a long corridor, and a hall without walls") {
  plan corridor;
  for (int i = 0; i < 3000; ++i) {
    const double x = i;
    corridor.cells.push_back({{at{x, 0}, at{x + 1, 0}, at{x + 1, 1}, at{x, 1}}});
    if (i > 0)
      corridor.portals.push_back(
          {static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i), at{x, 0}, at{x, 1}});
  }
  const irg::portal_graph<double> g(corridor);
  irg::stabbing_lines<double> lines;
  for (std::uint32_t c = 0; c + 1 < 3000; ++c)
    for (const auto& d : g.doors(c))
      if (d.to == c + 1) {
        REQUIRE(lines.passes(d));
        lines.enter(d);
      }
  plan hall;
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 6; ++x) {
      const double u = x, v = y;
      const auto cell = static_cast<std::uint32_t>(y * 6 + x);
      hall.cells.push_back({{at{u, v}, at{u + 1, v}, at{u + 1, v + 1}, at{u, v + 1}}});
      if (x > 0) hall.portals.push_back({cell - 1, cell, at{u, v}, at{u, v + 1}});
      if (y > 0) hall.portals.push_back({cell - 6, cell, at{u, v}, at{u + 1, v}});
    }
  REQUIRE(irg::validate(hall) == irg::plan_finding{});
  const auto sets = irg::potentially_visible(hall);
  CHECK(sets.seen.count() == 36 * 36);
  CHECK(sets.unfinished == 0);
}

// The oracle: sequences of portals are followed as long as the hulls of their right ends and of their left ends have no
// point in common, decided over all triangles and pairs of segments in numbers that do not round.
template <class N>
struct separated_hulls {
  struct place {
    N x, y;
  };
  std::vector<place> right, left;

  static int turn(const place& a, const place& b, const place& c) {
    const N v = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return v < N(0) ? -1 : N(0) < v ? 1 : 0;
  }
  static bool on(const place& a, const place& b, const place& p) {
    const auto between = [](const N& u, const N& v, const N& w) { return !(v < u && v < w) && !(u < v && w < v); };
    return turn(a, b, p) == 0 && between(a.x, p.x, b.x) && between(a.y, p.y, b.y);
  }
  static bool meet(const place& a, const place& b, const place& c, const place& d) {
    if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return true;
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }
  static bool holds(const std::vector<place>& hull, const place& p) {
    for (std::size_t i = 0; i < hull.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) {
          const int s = turn(hull[i], hull[j], p);
          if (s != 0 && s == turn(hull[j], hull[k], p) && s == turn(hull[k], hull[i], p)) return true;
        }
    return false;
  }
  bool apart() const {
    for (const place& p : left)
      if (holds(right, p)) return false;
    for (const place& p : right)
      if (holds(left, p)) return false;
    for (const place& a : left)
      for (const place& b : left)
        for (const place& c : right)
          for (const place& d : right)
            if (meet(a, b, c, d)) return false;
    return true;
  }
  void follow(const irg::portal_graph<double>& g, std::uint32_t cell, std::vector<bool>& seen) {
    seen[cell] = true;
    for (const irg::doorway<double>& d : g.doors(cell)) {
      right.push_back({N(d.right.x), N(d.right.y)});
      left.push_back({N(d.left.x), N(d.left.y)});
      if (apart()) follow(g, d.to, seen);
      right.pop_back();
      left.pop_back();
    }
  }
};

template <class N>
void check_against_hulls(const plan& p) {
  REQUIRE(irg::validate(p) == irg::plan_finding{});
  const irg::portal_graph<double> g(p);
  const auto sets = irg::potentially_visible(g);
  CHECK(sets.unfinished == 0);
  int wrong = 0;
  for (std::uint32_t c = 0; c < g.cell_count(); ++c) {
    std::vector<bool> seen(g.cell_count(), false);
    separated_hulls<N>{}.follow(g, c, seen);
    for (std::uint32_t to = 0; to < g.cell_count(); ++to) {
      const int x = static_cast<int>(to), y = static_cast<int>(c);
      wrong += sets.seen.is_full({x, y, 0}) != seen[to];
      wrong += sets.seen.is_full({x, y, 0}) != sets.seen.is_full({y, x, 0});
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("potentially_visible: against hulls over all sequences of portals") {
  test::random r(11);
  const int trials = std::getenv("IRG_RELEASE_TIER") != nullptr ? 1000 : 25;
  for (int i = 0; i < trials; ++i) check_against_hulls<std::int64_t>(test::random_house<double>(r, 40 + i % 30, 4));
  for (int i = 0; i < trials; ++i) {
    const int size = 2 + i % 3;
    check_against_hulls<std::int64_t>(test::random_triangles<double>(r, size, size > 3 ? 6 : 8));
  }
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("potentially_visible: against hulls in rationals, coordinates of mixed magnitudes") {
  test::random r(12);
  const int trials = std::getenv("IRG_RELEASE_TIER") != nullptr ? 100 : 4;
  for (int i = 0; i < trials; ++i) {
    plan p = test::random_house<double>(r, 40, 3);
    // Each line of the plan is moved for itself, over 600 decades or by a last place; order stays.
    const auto moved = [&](double v) {
      return i % 2 == 0 ? std::ldexp(v + 1, static_cast<int>(v) * 50 - 1000) : 1 + (v + 1) * 0x1p-52;
    };
    for (auto& c : p.cells)
      for (at& q : c.corners) q = {moved(q.x), moved(q.y)};
    for (auto& d : p.portals) d.a = {moved(d.a.x), moved(d.a.y)}, d.b = {moved(d.b.x), moved(d.b.y)};
    check_against_hulls<test::big_rational>(p);
  }
}
#endif

TEST_CASE("potentially_visible: sight lines find no cell that is missing, and nearly all that are there") {
  const int lines = std::getenv("IRG_RELEASE_TIER") != nullptr ? 1000000 : 100000;
  test::random r(13);
  int missing = 0;
  std::int64_t promised = 0, found = 0;
  for (int h = 0; h < 10; ++h) {
    const plan p = test::random_house<double>(r, 90, 5);
    const irg::portal_graph<double> g(p);
    const auto sets = irg::potentially_visible(g);
    irg::cell_grid sampled(sets.seen.extent());
    for (std::uint32_t c = 0; c < g.cell_count(); ++c) sampled.set({static_cast<int>(c), static_cast<int>(c), 0});
    for (int i = 0; i < lines / 10; ++i) {
      const auto cell = static_cast<std::uint32_t>(r.integer(0, static_cast<std::int64_t>(g.cell_count()) - 1));
      const auto& corners = p.cells[cell].corners;
      const double u = r.unit(), v = r.unit();
      at from{corners[0].x + u * (corners[2].x - corners[0].x), corners[0].y + v * (corners[2].y - corners[0].y)};
      const auto door = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(p.portals.size()) - 1));
      const double w = r.unit();
      const auto& q = p.portals[door];
      const at to{q.a.x + w * (q.b.x - q.a.x), q.a.y + w * (q.b.y - q.a.y)};
      const auto way = test::walked_cells(g, cell, from, to);
      for (const std::uint32_t a : way)
        for (const std::uint32_t b : way) {
          const irg::cell3 pair{static_cast<int>(a), static_cast<int>(b), 0};
          missing += !sets.seen.is_full(pair);
          sampled.set(pair);
        }
    }
    promised += sets.seen.count();
    found += sampled.count();
  }
  CHECK(missing == 0);
  const double ratio = static_cast<double>(promised) / static_cast<double>(found);
  MESSAGE("promised / found: " << promised << " / " << found << " = " << ratio);
  CHECK(ratio <= 1.3);
}

}  // namespace
