// SPDX-License-Identifier: MIT
#include <irg/visibility/see.hpp>

#include <cstdlib>
#include <limits>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell;
using irg::cell3;
using irg::corner_rule;

constexpr irg::cell_grid grid_of(int width, int height, std::uint64_t bits) {
  irg::cell_grid g(irg::grid_extent{width, height, 1});
  for (int i = 0; i < width * height; ++i)
    if ((bits >> i & 1) != 0) g.set(cell{i % width, i / width});
  return g;
}

// A grid that is never stored: one full cell in the middle of all that ints can name.
struct vast {
  static constexpr int most = std::numeric_limits<int>::max();
  constexpr irg::grid_extent extent() const { return {most, most, most}; }
  constexpr bool is_full(const cell3& c) const { return c == cell3{1, 0, 0}; }
};
static_assert(irg::CellGrid<vast> && !irg::WalledCellGrid<vast>);

constexpr irg::cell_grid pinched() { return grid_of(3, 3, 0b000'101'010); }  // (1,0), (0,1), (2,1)
static_assert(!irg::has_line_of_sight(pinched(), cell{0, 0}, cell{1, 1}));
static_assert(irg::has_line_of_sight(pinched(), cell{0, 0}, cell{1, 1}, {corner_rule::open}));
static_assert(irg::has_line_of_sight(pinched(), cell{0, 0}, cell{1, 0}));  // a full cell can be seen
static_assert(!irg::has_line_of_sight(pinched(), cell{0, 0}, cell{1, 0}, {.ends = irg::end_cells::tested}));
static_assert(!irg::has_line_of_sight(pinched(), cell{0, 0}, cell{2, 0}) &&
              irg::has_line_of_sight(pinched(), cell{0, 0}, cell{0, 0}));
static_assert(!irg::has_line_of_sight(pinched(), cell{-1, 0}, cell{0, 0}) &&
              !irg::has_line_of_sight(pinched(), cell{0, 0}, cell{3, 0}));
static_assert(!irg::has_line_of_sight(irg::cell_grid(), cell{0, 0}, cell{0, 0}));
static_assert(!irg::has_line_of_sight(vast{}, cell{0, 0}, cell{vast::most - 1, 0}));
static_assert(irg::has_line_of_sight(vast{}, cell3{vast::most - 1, 5, 7}, cell3{vast::most - 9, 0, 3}));

TEST_CASE("see: one full cell beside a corner, by rule") {
  const irg::cell_grid one = grid_of(2, 2, 0b0010);
  CHECK(irg::has_line_of_sight(one, cell{0, 0}, cell{1, 1}));
  CHECK(irg::has_line_of_sight(one, cell{0, 0}, cell{1, 1}, {corner_rule::open}));
  CHECK(!irg::has_line_of_sight(one, cell{0, 0}, cell{1, 1}, {corner_rule::closed}));
}

TEST_CASE("see: what the source's figures show") {
  irg::cell_grid g(irg::grid_extent{9, 5, 1});
  CHECK(irg::has_line_of_sight(g, cell{0, 0}, cell{8, 4}));
  g.set(cell{5, 3});  // crossed by its corner's neighbourhood only
  CHECK(!irg::has_line_of_sight(g, cell{0, 0}, cell{8, 4}));
  CHECK(!irg::has_line_of_sight(g, cell{8, 4}, cell{0, 0}));
}

TEST_CASE("see: walls block between their two cells, by kind") {
  for (int kind = 0; kind < 6; ++kind) {
    irg::walled_grid g(irg::grid_extent{3, 2, 2});
    for (int axis = 0; axis < 3; ++axis) {
      g.set_wall({0, 0, 0}, axis, static_cast<irg::wall_kind>(kind));
      const cell3 next{axis == 0, axis == 1, axis == 2};
      const bool blocks = kind == 1 || kind == 4;
      CHECK(irg::has_line_of_sight(g, {0, 0, 0}, next) == !blocks);
      CHECK(irg::has_line_of_sight(g, next, {0, 0, 0}) == !blocks);
    }
  }
}

// All 64 walls and cells round a corner in the plane: blocked where both ways are.
TEST_CASE("see: the table of a diagonal step") {
  for (unsigned m = 0; m < 64; ++m) {
    irg::walled_grid g(irg::grid_extent{2, 2, 1});
    const auto on = [&](int bit) { return (m >> bit & 1) != 0; };
    if (on(0)) g.set({1, 0, 0});
    if (on(1)) g.set({0, 1, 0});
    if (on(2)) g.set_wall({0, 0, 0}, 0, irg::wall_kind::wall);
    if (on(3)) g.set_wall({1, 0, 0}, 1, irg::wall_kind::wall);
    if (on(4)) g.set_wall({0, 0, 0}, 1, irg::wall_kind::wall);
    if (on(5)) g.set_wall({0, 1, 0}, 0, irg::wall_kind::wall);
    const bool right = on(0) || on(2) || on(3), left = on(1) || on(4) || on(5);
    CHECK(irg::has_line_of_sight(g, {0, 0, 0}, {1, 1, 0}) == !(left && right));
    CHECK(irg::has_line_of_sight(g, {0, 0, 0}, {1, 1, 0}, {corner_rule::closed}) == (m == 0));
    CHECK(irg::has_line_of_sight(g, {0, 0, 0}, {1, 1, 0}, {corner_rule::open}));
  }
}

template <class G>
void agree_with_oracle(const G& g, test::random& r, int pairs) {
  const irg::grid_extent e = irg::extent_of(g);
  const auto any = [&] {
    return cell3{static_cast<int>(r.integer(0, e.width - 1)), static_cast<int>(r.integer(0, e.height - 1)),
                 static_cast<int>(r.integer(0, e.depth - 1))};
  };
  int wrong = 0;
  for (int i = 0; i < pairs; ++i) {
    const cell3 a = any(), b = any();
    for (const corner_rule corners : {corner_rule::pinch, corner_rule::open, corner_rule::closed})
      for (const auto ends : {irg::end_cells::untested, irg::end_cells::tested}) {
        const bool seen = irg::has_line_of_sight(g, a, b, {corners, ends});
        if (seen != irg::has_line_of_sight(g, b, a, {corners, ends}) || seen != test::sees(g, a, b, {corners, ends}))
          ++wrong;
      }
  }
  CHECK(wrong == 0);
}

TEST_CASE("see: all pairs of all 4 x 4 maps both ways; the oracle on some of them") {
  const bool all = std::getenv("IRG_RELEASE_TIER") != nullptr;
  test::random r(1);
  int wrong = 0;
  for (unsigned bits = 0; bits < 1u << 16; ++bits) {
    const irg::cell_grid g = grid_of(4, 4, bits);
    for (int i = 0; i < 16; ++i)
      for (int j = i + 1; j < 16; ++j)
        wrong += irg::has_line_of_sight(g, cell{i % 4, i / 4}, cell{j % 4, j / 4}) !=
                 irg::has_line_of_sight(g, cell{j % 4, j / 4}, cell{i % 4, i / 4});
    if (all || bits % 97 == 0) agree_with_oracle(g, r, 8);
  }
  CHECK(wrong == 0);
}

TEST_CASE("see: random maps with walls, in the plane and in space, against the oracle") {
  const int maps = std::getenv("IRG_RELEASE_TIER") != nullptr ? 10000 : 300;
  test::random r(2);
  for (int i = 0; i < maps; ++i) {
    const int full = static_cast<int>(r.integer(0, 40)), walls = static_cast<int>(r.integer(0, 1) * r.integer(0, 25));
    const irg::grid_extent e =
        i % 2 == 0 ? irg::grid_extent{static_cast<int>(r.integer(1, 12)), static_cast<int>(r.integer(1, 12)), 1}
                   : irg::grid_extent{static_cast<int>(r.integer(1, 5)), static_cast<int>(r.integer(1, 5)),
                                      static_cast<int>(r.integer(1, 5))};
    agree_with_oracle(test::random_map(r, e, full, walls), r, 20);
  }
}

TEST_CASE("see: both ways on all maps of 2 x 2 x 3 cells, and on 64 x 64 and 16 x 16 x 16 ones") {
  int wrong = 0;
  for (unsigned bits = 0; bits < 1u << 12; ++bits) {
    irg::cell_grid g(irg::grid_extent{2, 2, 3});
    const auto at = [](int i) { return cell3{i & 1, i >> 1 & 1, i >> 2}; };
    for (int i = 0; i < 12; ++i)
      if ((bits >> i & 1) != 0) g.set(at(i));
    for (int i = 0; i < 12; ++i)
      for (int j = i + 1; j < 12; ++j)
        wrong += irg::has_line_of_sight(g, at(i), at(j)) != irg::has_line_of_sight(g, at(j), at(i));
  }
  CHECK(wrong == 0);
  const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;
  test::random r(3);
  for (int i = 0; i < (release ? 10000 : 50); ++i)
    agree_with_oracle(test::random_map(r, {64, 64, 1}, static_cast<int>(r.integer(0, 6)), 0), r, 10);
  for (int i = 0; i < (release ? 1000 : 20); ++i)
    agree_with_oracle(test::random_map(r, {16, 16, 16}, static_cast<int>(r.integer(0, 12)), 0), r, 10);
}

}  // namespace
