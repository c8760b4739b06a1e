// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/floating_horizon.hpp>

#include <string>

#include "hidden/horizon_runs.hpp"
#include "support/check_both.hpp"

using irg::textbook::floating_horizon;
using irg::textbook::horizon_rule;

TEST_CASE("textbook::floating_horizon: the improved step on the source's curves") {
  floating_horizon equal(5);
  CHECK(test::drawn(equal, {{0, 2}, {1, 3}, {2, 4}, {3, 3}, {4, 2}}) ==
        "U0,2-1,3 L0,2-1,3 U1,3-2,4 L1,3-2,4 U2,4-3,3 L2,4-3,3 U3,3-4,2 L3,3-4,2 ");
  CHECK(test::drawn(equal, {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}}) ==
        "U0,3-1,3 L0,2-1,3 U1,3-2,4 L1,3-2,3 U2,4-3,3 L2,3-3,3 U3,3-4,3 L3,3-4,2 ");
  CHECK(test::drawn(equal, {{0, 1}, {1, 4}, {2, 4}, {3, 2}, {4, 1}}) ==
        "U0,3-1,4 L0,1-1,3 U1,4-2,4 U2,4-3,3 L2,3-3,2 L3,2-4,1 ");
  floating_horizon oblique(11);
  test::drawn(oblique, {{8, 5}, {9, 6}, {10, 5}});
  test::drawn(oblique, {{5, 4}, {6, 5}, {7, 6}, {8, 6}, {9, 5}, {10, 4}});
  CHECK(test::drawn(oblique, {{3, 7}, {4, 7}, {5, 6}, {6, 5}, {7, 5}}) ==
        "U3,7-4,7 L3,7-4,7 U4,7-5,6 L4,7-5,4 U5,6-6,5 L5,4-6,5 U6,5-7,6 L6,5-7,5 ");
  floating_horizon touching(3);
  test::drawn(touching, {{0, 5}, {1, 9}, {2, 5}});
  CHECK(test::drawn(touching, {{0, 5}, {1, 5}, {2, 5}}) == "U0,5-1,9 L0,5-1,5 U1,9-2,5 L1,5-2,5 ");
  CHECK(test::drawn(touching, {{0, 3}, {1, 1}, {2, 3}}) == "L0,3-1,1 L1,1-2,3 ");
  CHECK(test::drawn(touching, {{0, 4}, {1, 2}, {2, 4}}) == "");
  floating_horizon steep(3);
  CHECK(test::drawn(steep, {{0, 2}, {1, 2}, {1, 5}, {1, 9}, {2, 9}}) ==
        "U0,2-1,2 L0,2-1,2 U1,5-1,5 L1,2-1,2 U1,9-1,9 U1,9-2,9 L1,2-2,9 ");
}

TEST_CASE("textbook::floating_horizon: the simple step draws both horizons again, points are what moved them") {
  floating_horizon simple(5, horizon_rule::simple_step);
  test::drawn(simple, {{0, 2}, {1, 3}, {2, 4}, {3, 3}, {4, 2}});
  CHECK(test::drawn(simple, {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}}) ==
        "U0,3-1,3 L0,2-1,3 U1,3-2,4 L1,3-2,3 U2,4-3,3 L2,3-3,3 U3,3-4,3 L3,3-4,2 ");
  floating_horizon points(3, horizon_rule::points);
  CHECK(test::drawn(points, {{0, 2}, {1, 5}, {2, 9}}) == "U0,2-0,2 U1,5-1,5 U2,9-2,9 ");
  CHECK(test::drawn(points, {{0, 2}, {1, 6}, {2, 1}}) == "U1,6-1,6 L2,1-2,1 ");
}

TEST_CASE("textbook::floating_horizon: outside, and in constant evaluation") {
  constexpr auto lines = [](int columns) {
    floating_horizon h(columns);
    int n = 0;
    for (int x = -1; x < 5; ++x) h.add(irg::cell{x, 3}, [&](irg::cell, irg::cell, irg::horizon_side) { ++n; });
    return n;
  };
  CHECK_BOTH(lines(4) == 6);
  CHECK_BOTH(lines(0) == 0);
}
