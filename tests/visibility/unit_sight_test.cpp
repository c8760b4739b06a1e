// SPDX-License-Identifier: MIT
#include <irg/visibility/unit_sight.hpp>

#include <vector>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell3;

TEST_CASE("who_sees_whom and see_regions: pair by pair") {
  test::random r(8);
  for (int i = 0; i < 30; ++i) {
    const irg::grid_extent e{9, 8, i % 2 + 1};
    const irg::walled_grid g = test::random_map(r, e, 20, 5);
    std::vector<cell3> units;
    for (int k = 0; k < 12; ++k)  // some of them outside
      units.push_back({static_cast<int>(r.integer(-1, 9)), static_cast<int>(r.integer(0, 7)),
                       static_cast<int>(r.integer(0, e.depth - 1))});
    const irg::cell_grid m = irg::who_sees_whom(g, units);
    std::int64_t seen = 0;
    for (int a = 0; a < 12; ++a)
      for (int b = 0; b < 12; ++b) {
        const bool sees = test::sees(g, units[static_cast<std::size_t>(a)], units[static_cast<std::size_t>(b)]);
        CHECK(m.is_full({a, b, 0}) == sees);
        seen += sees;
      }
    CHECK(irg::see_regions(g, units, units) == irg::region_sight{144, seen});
  }
  CHECK_BOTH(irg::region_sight{} == irg::region_sight{0, 0});
  CHECK(irg::who_sees_whom(irg::cell_grid(), std::vector<cell3>{}).extent().empty());
}

}  // namespace
