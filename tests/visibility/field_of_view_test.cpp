// SPDX-License-Identifier: MIT
#include <irg/visibility/field_of_view.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell;
using irg::cell3;
using irg::cell_grid;
using irg::corner_rule;
using irg::field_of_view;
using irg::grid_extent;
using irg::walled_grid;

bool release() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

static_assert([] {
  cell_grid g(grid_extent{3, 3, 1});
  g.set(cell{1, 0});
  return field_of_view(g, cell{0, 0}).count() == 7 && field_of_view(g, cell{3, 0}).count() == 0 &&
         field_of_view(cell_grid(), cell{0, 0}).count() == 0;
}());
static_assert([] {
  cell_grid g(grid_extent{3, 1, 3});
  g.set({0, 0, 1});
  return field_of_view(g, cell3{0, 0, 0}).count() == 7;
}());

// Every cell asked for by itself.
template <class G>
cell_grid one_by_one(const G& g, const cell3& viewer, const irg::view_options& o) {
  cell_grid seen(g.extent());
  const grid_extent e = g.extent();
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x) {
        const std::int64_t dx = x - viewer.x, dy = y - viewer.y, dz = z - viewer.z, r = o.radius;
        if (r >= 0 && dx * dx + dy * dy + dz * dz <= r * r && irg::has_line_of_sight(g, viewer, {x, y, z}, o.rules))
          seen.set({x, y, z});
      }
  return seen;
}

void same(const walled_grid& g, const cell3& viewer, const irg::view_options& o = {}) {
  const cell_grid a = field_of_view(g, viewer, o), b = one_by_one(g, viewer, o);
  if (a == b) return;
  std::string text;
  const grid_extent e = g.extent();
  for (int y = 0; y < e.height && e.depth == 1; ++y) {
    for (int x = 0; x < e.width; ++x)
      text += cell{x, y} == cell{viewer.x, viewer.y}         ? '@'
              : a.is_full({x, y, 0}) != b.is_full({x, y, 0}) ? '!'
              : g.is_full({x, y, 0})                         ? '#'
                                                             : '.';
    text += '\n';
  }
  CAPTURE(text);
  CAPTURE(static_cast<int>(o.rules.corners));
  CHECK(a == b);
}

irg::view_options any_options(test::random& r) {
  irg::view_options o;
  o.rules.corners = static_cast<corner_rule>(r.integer(0, 2));
  o.rules.ends = static_cast<irg::end_cells>(r.integer(0, 3) == 0);
  if (r.integer(0, 2) == 0) o.radius = static_cast<int>(r.integer(0, 12));
  return o;
}
// Pairs of cells of which one sees the other and is not seen.
std::int64_t asymmetric_pairs(const walled_grid& g) {
  const grid_extent e = g.extent();
  std::vector<cell3> cells;
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x) cells.push_back({x, y, z});
  std::vector<cell_grid> fields;
  irg::view_memory memory;
  for (const cell3& c : cells) {
    fields.emplace_back(e);
    irg::add_field_of_view(g, c, fields.back(), memory);
  }
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) pairs += fields[i].is_full(cells[j]) != fields[j].is_full(cells[i]);
  return pairs;
}

cell3 any_cell(test::random& r, const grid_extent& e) {
  return {static_cast<int>(r.integer(0, e.width - 1)), static_cast<int>(r.integer(0, e.height - 1)),
          static_cast<int>(r.integer(0, e.depth - 1))};
}

static_assert(irg::view_options{} == irg::view_options{} && irg::view_options{} != irg::view_options{{}, 3, {}});

TEST_CASE("field_of_view: all 4 x 4 maps, from every cell") {
  for (unsigned bits = 0; bits < 1u << 16; bits += release() ? 1u : 13u) {
    walled_grid g(grid_extent{4, 4, 1});
    for (int i = 0; i < 16; ++i)
      if ((bits >> i & 1) != 0) g.set({i % 4, i / 4, 0});
    for (int i = 0; i < 16; ++i) same(g, {i % 4, i / 4, 0});
  }
}

TEST_CASE("field_of_view: all rules on small maps with walls") {
  test::random r(1);
  for (int i = 0; i < (release() ? 200000 : 4000); ++i) {
    const grid_extent e{static_cast<int>(r.integer(1, 14)), static_cast<int>(r.integer(1, 14)), 1};
    const walled_grid g = test::random_map(r, e, static_cast<int>(r.integer(0, 30)),
                                           static_cast<int>(r.integer(0, 1) * r.integer(0, 15)));
    same(g, any_cell(r, e), any_options(r));
  }
}

TEST_CASE("field_of_view: 64 x 64 and wider maps, both ways") {
  test::random r(2);
  for (int i = 0; i < (release() ? 14000 : 60); ++i) {
    const grid_extent e =
        i % 4 != 0 ? grid_extent{64, 64, 1}
                   : grid_extent{static_cast<int>(r.integer(1, 200)), static_cast<int>(r.integer(1, 200)), 1};
    const walled_grid g = test::random_map(r, e, static_cast<int>(r.integer(0, 3) * r.integer(0, 6)),
                                           static_cast<int>(r.integer(0, 3) == 0));
    const cell3 viewer = any_cell(r, e);
    same(g, viewer, any_options(r));
    const cell_grid seen = field_of_view(g, viewer);
    int asymmetric = 0;
    for (int k = 0; k < 20; ++k) {
      const cell3 c = any_cell(r, e);
      asymmetric += field_of_view(g, c).is_full(viewer) != seen.is_full(c);
    }
    CHECK(asymmetric == 0);
  }
}

TEST_CASE("field_of_view: every pair of cells both ways, on maps of 64 x 64 and 16 x 16 x 16 cells") {
  test::random r(6);
  for (int i = 0; i < (release() ? 10000 : 1); ++i) {
    const int full = static_cast<int>(r.integer(0, 40)), walls = static_cast<int>(r.integer(0, 2));
    CHECK(asymmetric_pairs(test::random_map(r, {64, 64, 1}, full, walls)) == 0);
  }
  for (int i = 0; i < (release() ? 1000 : 0); ++i) {
    const int full = static_cast<int>(r.integer(0, 40)), walls = static_cast<int>(r.integer(0, 2));
    CHECK(asymmetric_pairs(test::random_map(r, {16, 16, 16}, full, walls)) == 0);
  }
  CHECK(asymmetric_pairs(test::random_map(r, {7, 6, 8}, 12, 2)) == 0);
}
TEST_CASE("field_of_view: all maps of 2 x 2 x 3 cells, from every cell") {
  for (unsigned bits = 0; bits < 1u << 12; ++bits) {
    walled_grid g(grid_extent{2, 2, 3});
    for (int i = 0; i < 12; ++i)
      if ((bits >> i & 1) != 0) g.set({i & 1, i >> 1 & 1, i >> 2});
    for (int i = 0; i < 12; ++i) same(g, {i & 1, i >> 1 & 1, i >> 2});
  }
}

TEST_CASE("field_of_view: maps in space") {
  test::random r(3);
  for (int i = 0; i < (release() ? 2000 : 40); ++i) {
    grid_extent e{static_cast<int>(r.integer(1, 16)), static_cast<int>(r.integer(1, 16)),
                  static_cast<int>(r.integer(2, 16))};
    if (i % 2 != 0) e = {16, 16, 16};
    const walled_grid g = test::random_map(r, e, static_cast<int>(r.integer(0, 2) * r.integer(0, 10)),
                                           static_cast<int>(r.integer(0, 3) == 0));
    same(g, any_cell(r, e), any_options(r));
  }
  const walled_grid g = test::random_map(r, {16, 16, 16}, 3, 0);
  same(g, {15, 0, 7});
  same(walled_grid(grid_extent{90, 3, 5}), {70, 1, 2});
}

TEST_CASE("field_of_view: cones") {
  test::random r(4);
  for (int i = 0; i < 300; ++i) {
    const grid_extent e{15, 15, 1};
    const walled_grid g = test::random_map(r, e, 10, 0);
    const cell3 viewer = any_cell(r, e);
    irg::view_options o;
    const auto small = [&] { return static_cast<int>(r.integer(-3, 3)); };
    o.cone = {{small(), small()}, {small(), small()}};
    const cell_grid all = field_of_view(g, viewer), some = field_of_view(g, viewer, o);
    const auto angle = [](double x, double y) { return std::atan2(y, x); };
    const double turn = 2 * 3.14159265358979323846;
    int wrong = 0;
    all.for_each([&](const cell3& c) {
      if (c == viewer || o.cone.from == cell{} || o.cone.to == cell{}) {
        wrong += !some.is_full(c);
        return;
      }
      const double from = angle(o.cone.from.x, o.cone.from.y), width = angle(o.cone.to.x, o.cone.to.y) - from;
      double wide = width < -1e-9 ? width + turn : width, at = angle(c.x - viewer.x, c.y - viewer.y) - from;
      if (at < -1e-9) at += turn;
      if (wide > turn / 2 + 1e-9) return;  // more than half a turn is not asked for
      wrong += some.is_full(c) != (at <= wide + 1e-9);
    });
    CHECK(wrong == 0);
  }
}

TEST_CASE("field_of_view: several viewers, and those that are nowhere") {
  const walled_grid g(grid_extent{1, 9, 1});
  const std::vector<cell3> units{{0, 2, 0}, {0, 9, 0}, {-1, 0, 0}, {0, 0, 1}};
  CHECK(field_of_view(g, std::span(units)).count() == 9);
  CHECK(field_of_view(g, std::span(units).subspan(1)).count() == 0);
  irg::view_options none;
  none.radius = -1;
  CHECK(field_of_view(g, cell{0, 0}, none).count() == 0);
  none.radius = 0;
  CHECK(field_of_view(g, cell{0, 0}, none).count() == 1);
}

// A corridor that is shut; an open map; a room of one cell, for whose walls' corners two cells beside it are looked at;
// a post that ends the open rows; a circle; a shaft in space.
constexpr irg::view_counts counts_of(const walled_grid& g, const cell3& viewer, int radius = 1000) {
  irg::view_counts counts;
  irg::view_options o;
  o.radius = radius;
  (void)field_of_view(g, viewer, o, counts);
  return counts;
}
constexpr bool counted_by_hand() {
  walled_grid corridor(grid_extent{9, 1, 1}), room(grid_extent{9, 9, 1}), post(grid_extent{5, 5, 1});
  walled_grid shaft(grid_extent{1, 1, 3});
  corridor.set({5, 0, 0});
  for (int y = 3; y <= 5; ++y)
    for (int x = 3; x <= 5; ++x) room.set({x, y, 0}, x != 4 || y != 4);
  post.set({2, 1, 0});
  shaft.set({0, 0, 1});
  const walled_grid open(grid_extent{20, 10, 1}), block(grid_extent{3, 3, 3});
  return counts_of(corridor, {0, 0, 0}) == irg::view_counts{9, 6, 0, 0} &&
         counts_of(open, {3, 7, 0}) == irg::view_counts{200, 200, 200, 0} &&
         counts_of(room, {4, 4, 0}) == irg::view_counts{81, 11, 0, 0} &&
         counts_of(post, {2, 4, 0}) == irg::view_counts{25, 25, 15, 0} &&
         counts_of(room, {0, 0, 0}, 2) == irg::view_counts{6, 6, 0, 0} &&
         counts_of(block, {1, 1, 1}) == irg::view_counts{27, 27, 0, 0} &&
         counts_of(shaft, {0, 0, 0}) == irg::view_counts{3, 2, 0, 1};
}
static_assert(counted_by_hand());

TEST_CASE("field_of_view: counts of scenes worked out by hand, and what adds nothing to them") {
  CHECK(counted_by_hand());
  walled_grid g(grid_extent{9, 1, 1});
  g.set({5, 0, 0});
  const std::vector<cell3> units{{0, 0, 0}, {9, 0, 0}, {8, 0, 0}};
  irg::view_counts counts{1, 1, 1, 1};
  CHECK(field_of_view(g.cells(), std::span(units), {}, counts).count() == 9);
  CHECK(counts == irg::view_counts{19, 11, 1, 1});  // 6 cells are looked at from the left, 4 from the right
  irg::view_options tested;
  tested.rules.ends = irg::end_cells::tested;
  CHECK(field_of_view(g, cell{5, 0}, tested, counts).count() == 0);
  CHECK(counts == irg::view_counts{19, 11, 1, 1});
}

TEST_CASE("field_of_view: counting changes nothing, and what was not looked at does not matter") {
  test::random r(6);
  irg::counted_view_memory memory;
  for (int i = 0; i < (release() ? 20000 : 400); ++i) {
    const bool flat = i % 4 != 0;
    const grid_extent e = flat ? grid_extent{static_cast<int>(r.integer(1, 80)), static_cast<int>(r.integer(1, 20)), 1}
                               : grid_extent{static_cast<int>(r.integer(1, 7)), static_cast<int>(r.integer(1, 7)), 6};
    walled_grid g = test::random_map(r, e, static_cast<int>(r.integer(0, 3) * r.integer(0, 15)),
                                     static_cast<int>(r.integer(0, 3) == 0));
    const cell3 viewer = any_cell(r, e);
    irg::view_options o = any_options(r);
    o.rules.ends = irg::end_cells::untested;
    const cell_grid plain = field_of_view(g, viewer, o);
    cell_grid counted(e);
    memory.counts = {};
    add_field_of_view(g, viewer, counted, memory, o);
    CHECK(plain == counted);
    CHECK(plain.count() <= memory.counts.looked_at);
    CHECK(memory.counts.looked_at <= memory.counts.in_reach);
    CHECK(memory.counts.in_open_rows <= memory.counts.looked_at);
    for (int z = 0; z < e.depth; ++z)
      for (int y = 0; y < e.height; ++y)
        for (int x = 0; x < e.width; ++x)
          if (const cell3 c{x, y, z}; !memory.looked_at.is_full(c) && r.integer(0, 1) == 0) g.set(c, !g.is_full(c));
    CHECK(plain == field_of_view(g, viewer, o));
  }
}

}  // namespace
