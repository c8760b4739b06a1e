// SPDX-License-Identifier: MIT
#include <irg/spatial/grid_concept.hpp>

#include <set>
#include <sstream>

#include "support/check_both.hpp"

namespace {

// A type that knows nothing of irg.
struct dungeon {
  const char* rows[2]{"..#", "#.."};
};

}  // namespace

template <>
struct irg::grid_traits<dungeon> {
  static constexpr grid_extent extent(const dungeon&) { return {3, 2, 1}; }
  static constexpr bool is_full(const dungeon& d, const cell3& c) { return d.rows[c.y][c.x] == '#'; }
};

namespace {

static_assert(irg::CellGrid<dungeon> && !irg::WalledCellGrid<dungeon> && !irg::CellGrid<int>);
static_assert(irg::is_full(dungeon{}, {2, 0, 0}) && !irg::is_full(dungeon{}, {2, 1, 0}));
static_assert(!irg::has_wall(dungeon{}, {0, 0, 0}, 0));

TEST_CASE("cell3: written as (x, y, z), and hashed: no two of many near by alike") {
  std::ostringstream out;
  out << irg::cell3(1, -2, 3);
  CHECK(out.str() == "(1, -2, 3)");
  std::set<std::size_t> hashes;
  for (int i = 0; i < 8000; ++i) hashes.insert(std::hash<irg::cell3>{}({i % 20 - 10, i / 20 % 20 - 10, i / 400 - 10}));
  CHECK(hashes.size() == 8000);
}

TEST_CASE("a grid of one's own") { CHECK(irg::extent_of(dungeon{}) == irg::grid_extent{3, 2, 1}); }

}  // namespace
