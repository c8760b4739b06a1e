// SPDX-License-Identifier: MIT
#include <irg/spatial/cell_grid.hpp>

#include <set>
#include <tuple>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell3;
using irg::cell_grid;
using irg::grid_extent;

static_assert([] {
  cell_grid g(grid_extent{70, 3, 2});
  g.set_run(60, 70, 1, 1);
  g.set({0, 0, 0});
  g.set({65, 1, 1}, false);
  return g.count() == 10 && g.is_full({64, 1, 1}) && !g.is_full({65, 1, 1}) && !g.is_full({59, 1, 1});
}());
static_assert(cell_grid().extent() == grid_extent{0, 0, 0} && cell_grid().count() == 0 &&
              cell_grid(grid_extent{-1, 5, 1}).extent() == grid_extent{0, 0, 0});

TEST_CASE("cell_grid: runs, sets and counts are those of a set of cells") {
  test::random r(1);
  for (int trial = 0; trial < 200; ++trial) {
    const grid_extent e{static_cast<int>(r.integer(1, 200)), static_cast<int>(r.integer(1, 4)),
                        static_cast<int>(r.integer(1, 3))};
    cell_grid g(e), other(e);
    std::set<std::tuple<int, int, int>> cells, second;
    for (int i = 0; i < 8; ++i) {
      const int y = static_cast<int>(r.integer(0, e.height - 1)), z = static_cast<int>(r.integer(0, e.depth - 1));
      const int a = static_cast<int>(r.integer(0, e.width)), b = static_cast<int>(r.integer(0, e.width));
      g.set_run(a, b, y, z);
      for (int x = a; x < b; ++x) cells.insert({z, y, x});
      const int x = static_cast<int>(r.integer(0, e.width - 1));
      const bool full = r.integer(0, 1) != 0;
      g.set({x, y, z}, full);
      if (full)
        cells.insert({z, y, x});
      else
        cells.erase({z, y, x});
      other.set({x, y, z});
      second.insert({z, y, x});
    }
    CHECK(g.count() == static_cast<std::int64_t>(cells.size()));
    std::vector<std::tuple<int, int, int>> listed;
    g.for_each([&](const cell3& c) { listed.emplace_back(c.z, c.y, c.x); });
    CHECK(listed == std::vector(cells.begin(), cells.end()));
    cell_grid both = g, either = g;
    both &= other;
    either |= other;
    for (const auto& [z, y, x] : second) {
      CHECK(both.is_full({x, y, z}) == cells.contains({z, y, x}));
      CHECK(either.is_full({x, y, z}));
    }
    std::int64_t common = 0;
    for (const auto& c : second) common += cells.contains(c);
    CHECK(both.count() == common);
    CHECK(either.count() == static_cast<std::int64_t>(cells.size() + second.size()) - common);
    CHECK(irg::packed(g) == g);
    g.clear();
    CHECK(g == cell_grid(e));
  }
}

TEST_CASE("cell_grid: every run of a row of three words") {
  const int width = 130;
  int wrong = 0;
  for (int first = 0; first <= width; ++first)
    for (int last = 0; last <= width; ++last) {
      cell_grid g(grid_extent{width, 1, 1});
      g.set_run(first, last, 0, 0);
      if (first >= last)
        wrong += g.count() != 0;
      else
        wrong += g.count() != last - first || !g.is_full({first, 0, 0}) || !g.is_full({last - 1, 0, 0});
    }
  CHECK(wrong == 0);
}

TEST_CASE("grid_from_raster: the pixels that are dark") {
  irg::image<int> p(3, 2, 255);
  p(2, 1) = 10;
  const cell_grid g = irg::grid_from_raster(p, [](int v) { return v < 128; });
  CHECK(g.count() == 1);
  CHECK(g.is_full({2, 1, 0}));
}

}  // namespace
