// SPDX-License-Identifier: MIT
#include <irg/spatial/walled_grid.hpp>

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

#include "mesh/short_memory.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::wall_kind;
using irg::walled_grid;

static_assert(irg::WalledCellGrid<walled_grid>);

// The source's table 2.
TEST_CASE("wall_options: which kinds block") {
  const irg::wall_options rules;
  CHECK(!rules(wall_kind::none));
  CHECK(rules(wall_kind::wall));
  CHECK(!rules(wall_kind::half_wall));
  CHECK(!rules(wall_kind::open_door));
  CHECK(rules(wall_kind::closed_door));
  CHECK(!rules(wall_kind::laser_field));
}

TEST_CASE("walled_grid: walls by cell and axis, and rules of one's own") {
  irg::wall_options rules;
  rules.blocks[static_cast<std::size_t>(wall_kind::laser_field)] = true;
  walled_grid g(irg::grid_extent{4, 3, 2}, rules);
  CHECK(!g.walled());
  CHECK(!g.has_wall({1, 1, 1}, 2));
  g.set_wall({3, 2, 1}, 2, wall_kind::laser_field);
  g.set_wall({0, 0, 0}, 1, wall_kind::open_door);
  CHECK(g.walled());
  int walls = 0, blocking = 0;
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 4; ++x)
        for (int axis = 0; axis < 3; ++axis)
          walls += g.wall({x, y, z}, axis) != wall_kind::none, blocking += g.has_wall({x, y, z}, axis);
  CHECK(walls == 2);
  CHECK(blocking == 1);
  CHECK(g.has_wall({3, 2, 1}, 2));
  g.set_wall({3, 2, 1}, 2, wall_kind::half_wall);
  CHECK(!g.has_wall({3, 2, 1}, 2));
}

TEST_CASE("walled_grid: every wall its own, whatever stands beside it; with_walls keeps what blocks") {
  test::random r(12);
  const irg::grid_extent e{5, 4, 3};
  walled_grid g(e);
  std::vector<wall_kind> kinds(std::size_t{3} * 5 * 4 * 3, wall_kind::none);
  const auto each_wall = [&](const auto& use) {
    std::size_t i = 0;
    for (int z = 0; z < e.depth; ++z)
      for (int y = 0; y < e.height; ++y)
        for (int x = 0; x < e.width; ++x)
          for (int axis = 0; axis < 3; ++axis) use(irg::cell3{x, y, z}, axis, kinds[i++]);
  };
  each_wall([&](const irg::cell3& c, int axis, wall_kind& kind) {
    kind = static_cast<wall_kind>(r.integer(0, 5));
    g.set_wall(c, axis, kind);
    g.set(c, r.integer(0, 1) != 0);
  });
  const walled_grid copy = irg::with_walls(g);
  int wrong = 0, blocking = 0;
  each_wall([&](const irg::cell3& c, int axis, wall_kind kind) {
    const bool blocks = irg::wall_options{}(kind);
    blocking += blocks;
    wrong += g.wall(c, axis) != kind || g.has_wall(c, axis) != blocks || copy.has_wall(c, axis) != blocks ||
             copy.wall(c, axis) != (blocks ? wall_kind::wall : wall_kind::none) || copy.is_full(c) != g.is_full(c);
  });
  CHECK(wrong == 0);
  CHECK(blocking > 30);
  CHECK(blocking < 150);
  irg::cell_grid cells(e);
  cells.set({1, 2, 0});
  const walled_grid without = irg::with_walls(cells);
  CHECK(!without.walled());
  CHECK(without.is_full({1, 2, 0}));
}

#ifdef __cpp_exceptions
TEST_CASE("walled_grid: where memory gives out at the first wall, the grid is as it was") {
  walled_grid g(irg::grid_extent{4, 3, 2});
  const walled_grid before = g;
  for (long left = 0;; ++left) {
    test::allocations_left = left;
    bool failed = false;
    try {
      g.set_wall({1, 1, 1}, 1, wall_kind::wall);
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    test::allocations_left = -1;
    REQUIRE(left < 20);
    CHECK((g == before) == failed);
    if (!failed) break;
  }
  CHECK(g.has_wall({1, 1, 1}, 1));
}
#endif

}  // namespace
