// SPDX-License-Identifier: MIT
#include <irg/hidden/vocabulary.hpp>

#include "support/check_both.hpp"

TEST_CASE("newell_counts: as many as there are steps, by their names") {
  constexpr auto counted = [] {
    irg::newell_counts c;
    c.steps[static_cast<int>(irg::newell_step::drawn)] = 3;
    return c;
  };
  CHECK_BOTH(counted()[irg::newell_step::drawn] == 3);
  CHECK_BOTH(counted()[irg::newell_step::x_apart] == 0);
  CHECK_BOTH(counted() != irg::newell_counts{});
  CHECK_BOTH(irg::newell_counts{}.hidden == 0);
  CHECK_BOTH(sizeof counted().steps / sizeof counted().steps[0] == static_cast<int>(irg::newell_step::drawn) + 1);
}
