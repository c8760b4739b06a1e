// SPDX-License-Identifier: MIT
#include <irg/hidden/floating_horizon.hpp>

#include <string>
#include <vector>

#include "horizon_runs.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::cell;

TEST_CASE("floating_horizon: the strict rule on the source's curves") {
  irg::floating_horizon equal(5);
  CHECK(test::drawn(equal, {{0, 2}, {1, 3}, {2, 4}, {3, 3}, {4, 2}}) ==
        "U0,2-1,3 L0,2-1,3 U1,3-2,4 L1,3-2,4 U2,4-3,3 L2,4-3,3 U3,3-4,2 L3,3-4,2 ");
  CHECK(test::drawn(equal, {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}}) == "U0,3-1,3 L1,3-2,3 L2,3-3,3 U3,3-4,3 ");
  CHECK(test::drawn(equal, {{0, 1}, {1, 4}, {2, 4}, {3, 2}, {4, 1}}) ==
        "U0,3-1,4 L0,1-1,3 U1,4-2,4 U2,4-3,3 L2,3-3,2 L3,2-4,1 ");
  CHECK(equal[0] == irg::horizon_column{1, 3, true});

  irg::floating_horizon oblique(11);
  CHECK(test::drawn(oblique, {{8, 5}, {9, 6}, {10, 5}}) == "U8,5-9,6 L8,5-9,6 U9,6-10,5 L9,6-10,5 ");
  CHECK(test::drawn(oblique, {{5, 4}, {6, 5}, {7, 6}, {8, 6}, {9, 5}, {10, 4}}) ==
        "U5,4-6,5 L5,4-6,5 U6,5-7,6 L6,5-7,6 U7,6-8,6 U8,6-9,6 L8,5-9,5 L9,5-10,4 ");
  CHECK(test::drawn(oblique, {{3, 7}, {4, 7}, {5, 6}, {6, 5}, {7, 5}}) ==
        "U3,7-4,7 L3,7-4,7 U4,7-5,6 U5,6-6,5 L6,5-7,5 ");
  CHECK(!oblique[0].is_set);

  irg::floating_horizon through(4);
  test::drawn(through, {{0, 5}, {1, 5}, {2, 5}, {3, 5}});
  CHECK(test::drawn(through, {{0, 8}, {1, 9}, {2, 2}, {3, 1}}) == "U0,8-1,9 U1,9-2,5 L1,5-2,2 L2,2-3,1 ");
}

TEST_CASE("floating_horizon: steep parts are joined") {
  irg::floating_horizon h(3);
  CHECK(test::drawn(h, {{0, 2}, {1, 2}, {1, 5}, {1, 9}, {2, 9}}) == "U0,2-1,2 L0,2-1,2 U1,2-1,5 U1,5-1,9 U1,9-2,9 ");
}

TEST_CASE("floating_horizon: gaps, samples outside, no columns; in constant evaluation") {
  irg::floating_horizon h(3);
  CHECK(test::drawn(h, {{0, 1}, {-1, 1}, {1, 1}, {2, 1}, {3, 9}, {2, 5}}) == "U1,1-2,1 L1,1-2,1 ");
  constexpr auto counts = [](int columns) {
    irg::floating_horizon f(columns);
    int lines = 0;
    for (int x = 0; x < 4; ++x) f.add(cell{x, x * x}, [&](cell, cell, irg::horizon_side) { ++lines; });
    return lines;
  };
  CHECK_BOTH(counts(4) == 6);
  CHECK_BOTH(counts(0) == 0);
  CHECK_BOTH(counts(-5) == 0);
}

// By its definition, from all samples so far: a horizon is the greatest and the least row of its column.
TEST_CASE("floating_horizon: horizons are the extremes of all samples; lines end on them and join neighbours") {
  test::random r(41);
  for (int trial = 0; trial < 300; ++trial) {
    irg::floating_horizon h(12);
    std::vector<std::vector<int>> rows(12);
    for (int curve = 0; curve < 8; ++curve) {
      std::vector<cell> samples;
      int x = static_cast<int>(r.integer(0, 11));
      while (x < 12) {
        samples.push_back({x, static_cast<int>(r.integer(-6, 6))});
        rows[static_cast<std::size_t>(x)].push_back(samples.back().y);
        x += static_cast<int>(r.integer(0, 1));
      }
      h.begin_curve();
      for (const cell& s : samples)
        h.add(s, [&](cell a, cell b, irg::horizon_side side) {
          CHECK(b == cell{b.x, side == irg::horizon_side::upper ? h[b.x].upper : h[b.x].lower});
          CHECK((b.x == a.x || b.x == a.x + 1));
        });
    }
    for (int x = 0; x < 12; ++x) {
      const auto& all = rows[static_cast<std::size_t>(x)];
      CHECK(h[x].is_set == !all.empty());
      if (all.empty()) continue;
      CHECK(h[x].upper == *std::max_element(all.begin(), all.end()));
      CHECK(h[x].lower == *std::min_element(all.begin(), all.end()));
    }
  }
}
