// SPDX-License-Identifier: MIT
#include <irg/spatial/walled_grid.hpp>

#include <new>

#include "mesh/short_memory.hpp"
#include "support/check_both.hpp"

namespace {

using irg::wall_kind;
using irg::walled_grid;

static_assert(irg::WalledCellGrid<walled_grid>);

// The source's table 2.
TEST_CASE("wall_rules: which kinds block") {
  const irg::wall_rules rules;
  CHECK(!rules(wall_kind::none));
  CHECK(rules(wall_kind::wall));
  CHECK(!rules(wall_kind::half_wall));
  CHECK(!rules(wall_kind::open_door));
  CHECK(rules(wall_kind::closed_door));
  CHECK(!rules(wall_kind::laser_field));
}

TEST_CASE("walled_grid: walls by cell and axis, and rules of one's own") {
  irg::wall_rules rules;
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
