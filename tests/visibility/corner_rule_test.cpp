// SPDX-License-Identifier: MIT
#include <irg/visibility/corner_rule.hpp>

#include <array>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::corner_rule;

// The six cells round a step along three axes, by their subsets of the axes.
constexpr std::array<unsigned, 6> sides{1, 2, 4, 3, 5, 6};

TEST_CASE("a step along three axes: the 64 sets of full cells, by rule") {
  int stopped = 0;
  for (unsigned m = 0; m < 64; ++m) {
    irg::cell_grid g(irg::grid_extent{2, 2, 2});
    for (unsigned i = 0; i < 6; ++i) {
      const int s = static_cast<int>(sides[i]);
      if ((m >> i & 1) != 0) g.set({s & 1, s >> 1 & 1, s >> 2});
    }
    const irg::detail::corner_step step{{0, 0, 0}, {1, 1, 1}, 7};
    const bool pinched = irg::detail::stops_at_corner(g, step, corner_rule::pinch);
    stopped += pinched;
    CHECK(pinched == !test::way_exists(g, {0, 0, 0}, {1, 1, 1}, 7, 0, 1));
    CHECK(irg::detail::stops_at_corner(g, step, corner_rule::closed) == (m != 0));
    CHECK(!irg::detail::stops_at_corner(g, step, corner_rule::open));
  }
  CHECK(stopped == 18);  // five least sets and what contains them
}

TEST_CASE("a step along three axes with walls: a way may need to turn back") {
  // 000 - 100 - 110 - 010 - 011 - 111 and no shorter one.
  irg::walled_grid g(irg::grid_extent{2, 2, 2});
  const auto wall = [&](irg::cell3 c, int axis) { g.set_wall(c, axis, irg::wall_kind::wall); };
  wall({0, 0, 0}, 1);
  wall({0, 0, 0}, 2);
  wall({1, 1, 0}, 2);
  wall({1, 0, 0}, 2);
  wall({0, 0, 1}, 1);
  const irg::detail::corner_step step{{0, 0, 0}, {1, 1, 1}, 7};
  CHECK(!irg::detail::stops_at_corner(g, step, corner_rule::pinch));
  wall({0, 1, 1}, 0);
  CHECK(irg::detail::stops_at_corner(g, step, corner_rule::pinch));
}

TEST_CASE("corners with walls at random: the ways tried one by one") {
  test::random r(4);
  for (int i = 0; i < 3000; ++i) {
    const irg::walled_grid g = test::random_map(r, {2, 2, 2}, 25, 30);
    for (unsigned axes : {3u, 5u, 6u, 7u}) {
      const irg::detail::corner_step step{{1, 0, 1}, {-1, 1, -1}, axes};
      CHECK(irg::detail::stops_at_corner(g, step, corner_rule::pinch) ==
            !test::way_exists(g, {1, 0, 1}, {-1, 1, -1}, axes, 0, 1));
    }
  }
}

}  // namespace
