// SPDX-License-Identifier: MIT
#include <irg/visibility/sight_tracker.hpp>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell3;

TEST_CASE("sight_tracker: after every change what a new look sees") {
  test::random r(9);
  int looked = 0, asked = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const irg::grid_extent e{static_cast<int>(r.integer(1, 14)), static_cast<int>(r.integer(1, 14)),
                             trial % 10 == 0 ? 3 : 1};
    const auto any = [&] {
      return cell3{static_cast<int>(r.integer(0, e.width - 1)), static_cast<int>(r.integer(0, e.height - 1)),
                   static_cast<int>(r.integer(0, e.depth - 1))};
    };
    irg::view_options o;
    o.rules.corners = static_cast<irg::corner_rule>(trial % 3);
    if (trial % 4 == 0) o.radius = 5;
    irg::sight_tracker tracker(test::random_map(r, e, 25, trial % 2 * 6), o);
    for (int i = 0; i < 4; ++i) tracker.add(any());
    for (int step = 0; step < 40; ++step) {
      asked += 4;
      switch (r.integer(0, 2)) {
        case 0: tracker.move(static_cast<std::size_t>(r.integer(0, 3)), any()); break;
        case 1: looked += tracker.set(any(), r.integer(0, 1) != 0); break;
        default:
          looked +=
              tracker.set_wall(any(), static_cast<int>(r.integer(0, 2)), static_cast<irg::wall_kind>(r.integer(0, 5)));
      }
      irg::cell_grid all(e);
      int wrong = 0;
      for (std::size_t i = 0; i < tracker.size(); ++i) {
        const irg::cell_grid fresh = irg::field_of_view(tracker.map(), tracker.unit(i), o);
        wrong += !(tracker.seen_by(i) == fresh);
        all |= fresh;
      }
      CHECK(wrong == 0);
      CHECK(tracker.seen() == all);
    }
  }
  CHECK(looked < asked / 3);  // most changes are out of sight
}

}  // namespace
