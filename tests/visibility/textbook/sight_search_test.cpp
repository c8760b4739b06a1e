// SPDX-License-Identifier: MIT
#include <irg/visibility/textbook/sight_search.hpp>

#include <vector>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell;
using irg::textbook::sight_saving;
using irg::textbook::sight_search;

// The source's field, 20 x 21 = 420 cells: N = x y n calls without savings, the table's first column.
TEST_CASE("the same cells with every saving, and ever fewer calls") {
  test::random r(6);
  for (const int full : {0, 20}) {
    const irg::walled_grid g = test::random_map(r, {20, 21, 1}, full, 0);
    std::vector<cell> units;
    for (int n = 1; n <= 7; ++n) {
      units.push_back({static_cast<int>(r.integer(0, 19)), static_cast<int>(r.integer(0, 20))});
      const auto all = sight_search(g, units, sight_saving::none);
      const auto field = sight_search(g, units, sight_saving::auxiliary_field);
      const auto list = sight_search(g, units, sight_saving::visible_list);
      CHECK(all.calls == 420 * n);
      CHECK(all.seen == field.seen);
      CHECK(all.seen == list.seen);
      CHECK(field.calls <= all.calls);
      CHECK((n == 1 || field.calls < all.calls));
      CHECK(list.calls < field.calls);
      if (full == 0) CHECK(field.calls == 420);
    }
  }
  const std::vector<cell> outside{{-1, 0}, {20, 0}};
  CHECK(sight_search(irg::cell_grid(irg::grid_extent{20, 21, 1}), outside, sight_saving::none).calls == 0);
}

}  // namespace
