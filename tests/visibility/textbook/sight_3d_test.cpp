// SPDX-License-Identifier: MIT
#include <irg/visibility/textbook/sight_3d.hpp>

#include <initializer_list>
#include <utility>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell3;
using irg::textbook::sight_3d;
using irg::textbook::three_axis_rule;

constexpr irg::cell_grid map(std::initializer_list<cell3> full) {
  irg::cell_grid g(irg::grid_extent{5, 5, 5});
  for (const cell3& c : full) g.set(c);
  return g;
}
static_assert(!sight_3d(map({{1, 0, 0}, {0, 0, 1}}), {0, 0, 0}, {1, 0, 1}));
static_assert(sight_3d(map({{1, 0, 0}}), {0, 0, 0}, {1, 0, 1}));

TEST_CASE("three axes: 64 sets, ten blocked by the printed two, eighteen by all five") {
  int thesis = 0, all = 0;
  for (unsigned m = 0; m < 64; ++m) {
    irg::cell_grid g(irg::grid_extent{2, 2, 2});
    unsigned blocked = 0;
    for (unsigned i = 0; i < 6; ++i)
      if ((m >> i & 1) != 0) {
        const unsigned s = i + 1;
        blocked |= 1u << s;
        g.set({static_cast<int>(s & 1), static_cast<int>(s >> 1 & 1), static_cast<int>(s >> 2)});
      }
    const bool by_path = irg::textbook::three_axis_blocked(blocked, three_axis_rule::face_path);
    const bool by_thesis = irg::textbook::three_axis_blocked(blocked, three_axis_rule::thesis);
    CHECK(by_path == !test::way_exists(g, {0, 0, 0}, {1, 1, 1}, 7, 0, 1));
    CHECK((by_path || !by_thesis));
    thesis += by_thesis, all += by_path;
  }
  CHECK(thesis == 10);
  CHECK(all == 18);
}

TEST_CASE("verdicts") {
  const auto seen = [](std::initializer_list<cell3> full, cell3 b) {
    const auto g = map(full);
    const bool t = sight_3d(g, {0, 0, 0}, b), f = sight_3d(g, {0, 0, 0}, b, three_axis_rule::face_path);
    CHECK(sight_3d(g, b, {0, 0, 0}) == t);
    CHECK(sight_3d(g, b, {0, 0, 0}, three_axis_rule::face_path) == f);
    return std::pair{t, f};
  };
  CHECK(seen({}, {2, 0, 2}) == std::pair{true, true});
  CHECK(seen({{1, 0, 0}}, {1, 0, 1}) == std::pair{true, true});
  CHECK(seen({{1, 0, 0}, {0, 0, 1}}, {1, 0, 1}) == std::pair{false, false});
  CHECK(seen({{1, 0, 0}, {1, 0, 1}, {0, 1, 0}, {0, 1, 1}}, {1, 1, 1}) == std::pair{false, false});
  CHECK(seen({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 1, 1}) == std::pair{false, false});
  CHECK(seen({{1, 1, 0}, {1, 0, 1}, {0, 1, 1}}, {1, 1, 1}) == std::pair{true, false});
  CHECK(seen({{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}}, {1, 1, 1}) == std::pair{true, false});
  CHECK(seen({{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1, 1}}, {1, 1, 1}) == std::pair{true, true});
  CHECK(seen({{2, 1, 0}}, {4, 2, 1}) == std::pair{false, false});
  CHECK(seen({{0, 0, 2}}, {0, 0, 3}) == std::pair{false, false});
  CHECK(seen({}, {0, 0, 3}) == std::pair{true, true});
  // Where z = 0 at both ends, the test in the plane sees the cells that are crossed in part.
  CHECK(seen({{1, 1, 0}}, {4, 2, 0}) == std::pair{false, false});
}

TEST_CASE("walls stand at z = 0 and count for steps that touch it") {
  irg::walled_grid g(irg::grid_extent{3, 3, 3});
  g.set_wall({0, 0, 0}, 0, irg::wall_kind::wall);
  g.set({0, 0, 1});
  CHECK(!sight_3d(g, {0, 0, 0}, {1, 0, 1}));
  g.set({0, 0, 1}, false);
  CHECK(sight_3d(g, {0, 0, 0}, {1, 0, 1}));
  g.set_wall({0, 0, 1}, 0, irg::wall_kind::wall);
  CHECK(sight_3d(g, {0, 0, 1}, {1, 0, 1}));
}

}  // namespace
