// SPDX-License-Identifier: MIT
#include <irg/visibility/view_through_portals.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "support/check_both.hpp"
#include "support/house_plans.hpp"

namespace {

using plan = irg::cell_plan<double>;
using at = irg::point<double, 2>;
using at3 = irg::point<double, 3>;
using wedge = irg::view_wedge<double>;
using irg::view_reach;

// Three rooms in a row; the doors overlap from y = 1.5 to 2.
constexpr plan row_of_rooms() {
  const auto room = [](double x) {
    return irg::plan_cell<double>{{at{x, 0}, at{x + 1, 0}, at{x + 1, 3}, at{x, 3}}, 0.0, 3.0};
  };
  return {{room(0), room(1), room(2)}, {{0, 1, at{1, 1}, at{1, 2}}, {1, 2, at{2, 1.5}, at{2, 2.5}}}};
}

// The cells seen as bits, each way counted.
constexpr unsigned seen_bits(const plan& p, std::uint32_t cell, const wedge& view) {
  unsigned bits = 0;
  irg::view_through_portals(irg::portal_graph(p), cell, view, [&](std::uint32_t c, const wedge&) { bits |= 1u << c; });
  return bits;
}
constexpr unsigned seen_bits(const at& eye, std::uint32_t cell = 0) {
  return seen_bits(row_of_rooms(), cell, {eye, view_reach::all_round, {}, {}});
}

TEST_CASE("view_through_portals: eyes in a room, in portals and in their lines") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK_BOTH(seen_bits(at{0.5, 1.5}) == 0b111u);
  CHECK_BOTH(seen_bits(at{0.5, 2.99}) == 0b011u);
  CHECK_BOTH(seen_bits(at{0, 2.5}) == 0b011u);  // the ray over both ends only touches them
  CHECK_BOTH(seen_bits(at{0, 2.5 - 0x1p-50}) == 0b111u);
  CHECK_BOTH(seen_bits(at{1, 1.5}) == 0b111u);  // in the portal
  CHECK_BOTH(seen_bits(at{1, 2}) == 0b111u);  // on its end
  CHECK_BOTH(seen_bits(at{1, 2.5}) == 0b001u);  // beside it, in its line
  CHECK_BOTH(seen_bits(at{1, 2.5}, 1) == 0b110u);
  CHECK_BOTH(seen_bits(at{infinity, 0}) == 0);
  CHECK_BOTH(seen_bits(at{0.5, std::numeric_limits<double>::quiet_NaN()}) == 0);
  CHECK_BOTH(seen_bits(at{0.5, 1.5}, 3) == 0);
}

TEST_CASE("view_through_portals: views that are limited") {
  const auto view = [](const at& right, const at& left) {
    return seen_bits(row_of_rooms(), 0, {at{0.5, 1.5}, view_reach::between, right, left});
  };
  CHECK(view({1, 0}, {1, 3}) == 0b111u);
  CHECK(view({1, 1}, {1, 1.4}) == 0b011u);
  CHECK(view({1, 2}, {1, 3}) == 0b001u);
  CHECK(view({0, 3}, {0, 0}) == 0b001u);
  CHECK(view({1, 3}, {1, 0}) == 0b001u);  // more than half round is no view
  CHECK(view({0.5, 1.5}, {1, 0}) == 0b001u);
  CHECK(view({1, 1.5}, {0.5, 3}) == 0b111u);
}

TEST_CASE("view_through_portals: portals without length show nothing") {
  plan p = row_of_rooms();
  p.portals[0].b = p.portals[0].a;
  CHECK(seen_bits(p, 0, {at{0.5, 1}, view_reach::all_round, {}, {}}) == 0b001u);
}

bool within(const wedge& w, const at& q) {
  return w.reach == view_reach::all_round ||
         (irg::orient2d(w.eye, w.right, q) > 0 && irg::orient2d(w.eye, q, w.left) > 0);
}
at random_place(test::random& r, const irg::plan_cell<double>& c) {
  double x = 0, y = 0, sum = 0;
  for (const at& p : c.corners) {
    const double w = 0.01 + r.unit();
    x += w * p.x, y += w * p.y, sum += w;
  }
  return {x / sum, y / sum};
}

// Every ray that is walked is in a wedge of each cell on its way, and the middle of every wedge reaches its cell.
void check_against_rays(test::random& r, const plan& p, bool limited) {
  REQUIRE(irg::validate(p) == irg::plan_finding{});
  const irg::portal_graph<double> g(p);
  int unseen = 0, too_much = 0;
  for (std::uint32_t c = 0; c < g.cell_count(); ++c) {
    wedge view{random_place(r, p.cells[c]), view_reach::all_round, {}, {}};
    const double from = r.unit() * 7, turn = from + 0.1 + 3 * r.unit();
    if (limited) {
      const at right{view.eye.x + std::cos(from), view.eye.y + std::sin(from)};
      const at left{view.eye.x + std::cos(turn), view.eye.y + std::sin(turn)};
      view = {view.eye, view_reach::between, right, left};
    }
    std::vector<std::pair<std::uint32_t, wedge>> seen;
    irg::view_through_portals(g, c, view, [&](std::uint32_t cell, const wedge& w) { seen.push_back({cell, w}); });
    REQUIRE(!seen.empty());
    for (int i = 0; i < 200; ++i) {
      const double a = r.unit() * 7;
      const at q{view.eye.x + std::cos(a), view.eye.y + std::sin(a)};
      if (!within(view, q)) continue;
      for (const std::uint32_t cell : test::walked_cells(g, c, view.eye, q)) {
        int ways = 0;
        for (const auto& [s, w] : seen) ways += s == cell && within(w, q);
        unseen += ways != 1;
      }
    }
    for (const auto& [cell, w] : seen) {
      if (w.reach == view_reach::all_round) continue;
      const auto unit = [&](const at& q) {
        const double x = q.x - w.eye.x, y = q.y - w.eye.y, size = std::hypot(x, y);
        return at{x / size, y / size};
      };
      const at u = unit(w.right), v = unit(w.left), q{w.eye.x + 64 * (u.x + v.x), w.eye.y + 64 * (u.y + v.y)};
      if (!within(w, q)) continue;
      const auto way = test::walked_cells(g, c, w.eye, q);
      too_much += std::find(way.begin(), way.end(), cell) == way.end();
    }
  }
  CHECK(unseen == 0);
  CHECK(too_much == 0);
}

TEST_CASE("view_through_portals: against rays that are walked one by one") {
  test::random r(21);
  for (int i = 0; i < 12; ++i) {
    check_against_rays(r, test::random_house<double>(r, 100, 5), i % 2 == 1);
    check_against_rays(r, test::random_triangles<double>(r, 5, 8), i % 2 == 1);
  }
}

TEST_CASE("view_through_portals: sizes from 1e-300 to 1e300") {
  for (const double scale : {0x1p-990, 0x1p-500, 0x1p500, 0x1p990}) {
    plan p = row_of_rooms();
    for (auto& c : p.cells)
      for (at& q : c.corners) q = {q.x * scale, q.y * scale};
    for (auto& d : p.portals) d.a = {d.a.x * scale, d.a.y * scale}, d.b = {d.b.x * scale, d.b.y * scale};
    CHECK(seen_bits(p, 0, {at{0, 2.5 * scale}, view_reach::all_round, {}, {}}) == 0b011u);
    CHECK(seen_bits(p, 0, {at{0, (2.5 - 0x1p-50) * scale}, view_reach::all_round, {}, {}}) == 0b111u);
  }
}

TEST_CASE("seen_through_both: squares one behind the other") {
  const auto square = [](double x, double z) {
    return std::array<at3, 4>{at3{x, 0, z}, at3{x + 1, 0, z}, at3{x + 1, 1, z}, at3{x, 1, z}};
  };
  const at3 eye{0.5, 0.5, 0};
  CHECK(irg::seen_through_both(eye, square(0, -1), square(0, -2)));
  CHECK(irg::seen_through_both(eye, square(0, -1), square(1.25, -2)));
  CHECK(!irg::seen_through_both(eye, square(0, -1), square(1.5, -2)));  // edges touch
  CHECK(!irg::seen_through_both(eye, square(0, -1), square(1.75, -2)));
  CHECK(irg::seen_through_both(eye, square(0, -1), square(1.5 - 0x1p-50, -2)));
  const std::array<at3, 5> repeated{at3{0, 0, -1}, at3{1, 0, -1}, at3{1, 0, -1}, at3{1, 1, -1}, at3{0, 1, -1}};
  CHECK(irg::seen_through_both(eye, repeated, square(0, -2)));
  CHECK(irg::seen_through_both(eye, square(0, -0.5), repeated));
  CHECK(!irg::seen_through_both(eye, repeated, square(1.5, -2)));
  const std::array<at3, 4> flat{at3{0, 0.5, -1}, at3{1, 0.5, -1}, at3{1, 0.5, -1}, at3{0, 0.5, -1}};
  CHECK(!irg::seen_through_both(eye, square(0, -2), flat));
}

// Two triangles in the picture part when all corners of the one are on one side, or on, a line through two of the six
// corners, and those of the other on the other side.
bool share_room(const std::vector<at>& p, const std::vector<at>& q) {
  std::vector<at> all = p;
  all.insert(all.end(), q.begin(), q.end());
  for (const at& a : all)
    for (const at& b : all) {
      if (a == b) continue;
      bool parts = true;
      for (const at& c : p) parts = parts && irg::orient2d(a, b, c) >= 0;
      for (const at& c : q) parts = parts && irg::orient2d(a, b, c) <= 0;
      if (parts) return false;
    }
  return true;
}

TEST_CASE("seen_through_both: against lines through all pairs of corners in the picture") {
  test::random r(23);
  int wrong = 0, shared = 0;
  for (int i = 0; i < 5000; ++i) {
    std::vector<at> flat[2];
    std::vector<at3> space[2];
    const at3 eye{static_cast<double>(r.integer(-9, 9)), static_cast<double>(r.integer(-9, 9)), 5};
    for (int k = 0; k < 2; ++k) {
      do {
        flat[k].clear();
        for (int v = 0; v < 3; ++v) {
          const auto x = static_cast<double>(r.integer(-5, 5)), y = static_cast<double>(r.integer(-5, 5));
          flat[k].push_back({x, y});
        }
      } while (irg::orient2d(flat[k][0], flat[k][1], flat[k][2]) <= 0);
      for (const at& v : flat[k]) {
        const auto away = static_cast<double>(r.integer(1, 6));
        space[k].push_back({eye.x + v.x * away, eye.y + v.y * away, eye.z - away});
      }
    }
    const bool share = share_room(flat[0], flat[1]);
    wrong += irg::seen_through_both(eye, space[0], space[1]) != share;
    shared += share;
  }
  CHECK(wrong == 0);
  CHECK(shared > 500);
  CHECK(shared < 4500);
}

TEST_CASE("view_through_openings: against rays in space, and against the view from above") {
  test::random r(22);
  int unseen = 0, differ = 0, seen_cells = 0, reached_cells = 0;
  for (int i = 0; i < 10; ++i) {
    plan p = test::random_house<double>(r, 100, 5);
    for (auto& c : p.cells) {
      if (i == 0) continue;
      c.floor = static_cast<double>(r.integer(0, 3));
      c.ceiling = c.floor + static_cast<double>(r.integer(1, 4));
    }
    const irg::portal_graph<double> g(p);
    for (std::uint32_t c = 0; c < g.cell_count(); ++c) {
      const at eye = random_place(r, p.cells[c]);
      const double height = p.cells[c].floor + (p.cells[c].ceiling - p.cells[c].floor) * r.unit();
      std::set<std::uint32_t> seen, above, reached{c};
      const wedge view{eye, view_reach::all_round, {}, {}};
      irg::view_through_openings({p, g}, c, view, height, [&](std::uint32_t cell, const wedge&) { seen.insert(cell); });
      irg::view_through_portals(g, c, view, [&](std::uint32_t cell, const wedge&) { above.insert(cell); });
      differ += i == 0 && seen != above;
      for (int k = 0; k < 2000; ++k) {
        const auto& target =
            p.portals[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(p.portals.size()) - 1))];
        const double u = r.unit(), v = r.unit();
        const at q{target.a.x + u * (target.b.x - target.a.x), target.a.y + u * (target.b.y - target.a.y)};
        const double slope = (v * 8 - height) / std::hypot(q.x - eye.x, q.y - eye.y);
        std::uint32_t cell = c;
        for (bool on = true; on;) {  // one doorway after the other, as long as the ray is well within its opening
          on = false;
          for (const auto& d : g.doors(cell)) {
            if (!(irg::orient2d(eye, q, d.right) < 0 && irg::orient2d(eye, q, d.left) > 0)) continue;
            const double nx = d.left.y - d.right.y, ny = d.right.x - d.left.x, n = std::hypot(q.x - eye.x, q.y - eye.y);
            const double way =
                (nx * (d.right.x - eye.x) + ny * (d.right.y - eye.y)) / ((nx * (q.x - eye.x) + ny * (q.y - eye.y)) / n);
            const auto opening = irg::opening_of(p, d);
            const double z = height + slope * way;
            if (z < opening[0].z + 1e-9 || z > opening[2].z - 1e-9) break;
            cell = d.to;
            reached.insert(cell);
            unseen += seen.count(cell) == 0;
            on = true;
            break;
          }
        }
      }
      seen_cells += static_cast<int>(seen.size());
      reached_cells += static_cast<int>(reached.size());
    }
  }
  CHECK(unseen == 0);
  CHECK(differ == 0);
  MESSAGE("seen / reached by rays: " << seen_cells << " / " << reached_cells);
  CHECK(seen_cells <= reached_cells * 1.1);
}

TEST_CASE("view_through_openings: rooms that share no height, and eyes that are not there") {
  plan p = row_of_rooms();
  const irg::portal_graph<double> g(p);
  const auto seen = [&](double height) {
    unsigned bits = 0;
    irg::view_through_openings({p, g}, 0, {at{0.5, 1.5}, view_reach::all_round, {}, {}}, height,
                               [&](std::uint32_t c, const wedge&) { bits |= 1u << c; });
    return bits;
  };
  CHECK(seen(1.5) == 0b111u);
  p.cells[1].floor = 3, p.cells[1].ceiling = 4;
  CHECK(seen(1.5) == 0b001u);
  p.cells[1].floor = 2;  // a step that hides what is behind it
  p.cells[2].ceiling = 2.5;
  CHECK(seen(2.25) == 0b111u);
  CHECK(seen(1.5) == 0b011u);
  CHECK(seen(std::numeric_limits<double>::infinity()) == 0);
  CHECK(seen(std::numeric_limits<double>::quiet_NaN()) == 0);
}

}  // namespace
