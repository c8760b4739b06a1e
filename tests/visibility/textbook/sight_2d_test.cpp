// SPDX-License-Identifier: MIT
#include <irg/visibility/textbook/sight_2d.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

#include "support/check_both.hpp"
#include "support/sight_oracle.hpp"

namespace {

using irg::cell;
using irg::textbook::sight;
using irg::textbook::sight_2d;
using irg::textbook::sight_list;

constexpr irg::cell_grid map(int width, int height, std::initializer_list<cell> full) {
  irg::cell_grid g(irg::grid_extent{width, height, 1});
  for (const cell c : full) g.set(c);
  return g;
}
static_assert(sight_2d(map(5, 5, {{1, 2}}), {0, 0}, {4, 4}) == sight::partial);
static_assert(sight_2d(map(5, 5, {}), {0, 0}, {5, 4}) == sight::blocked);
static_assert(sight_2d(map(1, 1, {{0, 0}}), {0, 0}, {0, 0}) == sight::full);

TEST_CASE("a cell crossed in part blocks; at D = m/2 both cells of the corner, where the printed text asks one") {
  CHECK(sight_2d(map(9, 5, {{5, 3}}), {0, 0}, {8, 4}) == sight::blocked);
  using irg::textbook::corner_case;
  CHECK(sight_2d(map(4, 2, {{1, 1}}), {0, 0}, {3, 1}) == sight::partial);
  CHECK(sight_2d(map(4, 2, {{1, 1}}), {0, 0}, {3, 1}, corner_case::as_printed) == sight::blocked);
  CHECK(sight_2d(map(4, 2, {{2, 0}}), {0, 0}, {3, 1}) == sight::partial);
  CHECK(sight_2d(map(4, 2, {{2, 0}}), {0, 0}, {3, 1}, corner_case::as_printed) == sight::full);
  CHECK(sight_2d(map(4, 2, {{2, 0}, {1, 1}}), {0, 0}, {3, 1}) == sight::blocked);
}

TEST_CASE("45 degrees: full, partial, blocked, whichever the direction") {
  const auto both = [](std::initializer_list<cell> full) {
    const auto g = map(5, 5, full);
    const sight s = sight_2d(g, {0, 0}, {4, 4});
    CHECK(sight_2d(g, {4, 4}, {0, 0}) == s);
    return s;
  };
  CHECK(both({}) == sight::full);
  CHECK(both({{1, 2}}) == sight::partial);
  CHECK(both({{0, 1}, {2, 3}}) == sight::partial);
  CHECK(both({{3, 2}}) == sight::partial);
  CHECK(both({{0, 1}, {1, 0}}) == sight::blocked);
  CHECK(both({{0, 1}, {3, 2}}) == sight::blocked);
  CHECK(both({{2, 2}}) == sight::blocked);
  CHECK(both({{0, 2}}) == sight::full);
  const auto falling = [](std::initializer_list<cell> full) { return sight_2d(map(4, 4, full), {3, 0}, {0, 3}); };
  CHECK(falling({{2, 0}}) == sight::partial);
  CHECK(falling({{3, 1}}) == sight::partial);
  CHECK(falling({{2, 0}, {2, 2}}) == sight::blocked);
}

TEST_CASE("a room of 8 x 6") {
  const auto g = map(8, 6, {{3, 1}, {4, 2}, {2, 4}, {1, 3}});
  const std::string rows[] = {"FFFFFFFF", "FFF#...p", "FFFFx...", "F#FFF...", "F.xFFF..", "F...FFFp"};
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) {
      const sight s = sight_2d(g, {0, 0}, {x, y});
      const bool full = g.is_full({x, y, 0});
      const char seen = full                  ? (s != sight::blocked ? '#' : 'x')
                        : s == sight::full    ? 'F'
                        : s == sight::partial ? 'p'
                                              : '.';
      CHECK(seen == rows[y][static_cast<std::size_t>(x)]);
    }
}

TEST_CASE("figure 30: a cell is seen through cells that are not") {
  const auto g = map(9, 2, {{3, 1}});
  CHECK(sight_2d(g, {0, 0}, {8, 1}) != sight::blocked);
  CHECK(sight_2d(g, {0, 0}, {5, 1}) == sight::blocked);
  CHECK(sight_2d(g, {0, 0}, {6, 1}) == sight::blocked);
}

// The cells whose inside the segment from a to b crosses, in the order in which it enters them. In halves of a cell and
// fractions of whole numbers, by trying all cells of the box round it.
std::vector<cell> crossed(cell a, cell b) {
  struct entry {
    long long from, over;  // the share of the way at which the cell is entered
    cell at;
  };
  std::vector<entry> found;
  for (int y = std::min(a.y, b.y); y <= std::max(a.y, b.y); ++y)
    for (int x = std::min(a.x, b.x); x <= std::max(a.x, b.x); ++x) {
      long long from = 0, from_over = 1, to = 1, to_over = 1;
      bool inside = true;
      for (const auto& [p, q, c] : {std::array{a.x, b.x, x}, std::array{a.y, b.y, y}}) {
        const long long d = q > p ? 2LL * (q - p) : 2LL * (p - q);
        const long long near = q > p ? 2LL * (c - p) - 1 : 2LL * (p - c) - 1, far = near + 2;
        if (d == 0)
          inside = inside && near < 0 && 0 < far;
        else {
          if (near * from_over > from * d) from = near, from_over = d;
          if (far * to_over < to * d) to = far, to_over = d;
        }
      }
      if (inside && from * to_over < to * from_over) found.push_back({from, from_over, {x, y}});
    }
  std::sort(found.begin(), found.end(),
            [](const entry& p, const entry& q) { return p.from * q.over < q.from * p.over; });
  std::vector<cell> out;
  for (const entry& e : found) out.push_back(e.at);
  return out;
}

static_assert(sight_list(map(4, 3, {}), {0, 0}, {3, 2}).cells.size() == 6);
static_assert(sight_list(map(4, 3, {{2, 1}}), {0, 0}, {3, 2}).cells.empty());
static_assert(sight_list(map(2, 2, {}), {0, 0}, {2147483647, 0}).cells.empty());

TEST_CASE("the checker's list: cells with those partly crossed between them, from a to b") {
  const auto open = map(9, 9, {});
  const auto of = [&](cell a, cell b) { return sight_list(open, a, b).cells; };
  CHECK(of({0, 0}, {3, 2}) == std::vector<cell>{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {3, 2}});  // table 4
  CHECK(of({0, 0}, {8, 4}) == std::vector<cell>{{0, 0},
                                                {1, 0},
                                                {1, 1},
                                                {2, 1},
                                                {3, 1},
                                                {3, 2},
                                                {4, 2},
                                                {5, 2},
                                                {5, 3},
                                                {6, 3},
                                                {7, 3},
                                                {7, 4},
                                                {8, 4}});  // figure 23
  CHECK(of({0, 0}, {2, 5}) == std::vector<cell>{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {1, 3}, {1, 4}, {2, 4}, {2, 5}});
  CHECK(of({5, 0}, {0, 2}) == std::vector<cell>{{5, 0}, {4, 0}, {4, 1}, {3, 1}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  CHECK(of({1, 1}, {4, 4}) == std::vector<cell>{{1, 1}, {2, 2}, {3, 3}, {4, 4}});
  CHECK(of({4, 4}, {4, 4}) == std::vector<cell>{{4, 4}});
  // At D = m/2 the segment crosses neither cell; the printed form blames, and lists, the one aside.
  CHECK(of({0, 0}, {3, 1}) == std::vector<cell>{{0, 0}, {1, 0}, {2, 1}, {3, 1}});
  CHECK(sight_list(open, {0, 0}, {3, 1}, irg::textbook::corner_case::as_printed).cells ==
        std::vector<cell>{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {3, 1}});
}

TEST_CASE("the checker's list is what the segment crosses, in its order, and turns with it") {
  const auto open = map(23, 23, {});
  int lines = 0, wrong = 0;
  for (int y = 0; y < 23; ++y)
    for (int x = 0; x < 23; ++x) {
      const cell a{11, 11}, b{x, y};
      auto there = sight_list(open, a, b).cells;
      const auto back = sight_list(open, b, a).cells;
      ++lines;
      if (there != crossed(a, b)) ++wrong;
      std::reverse(there.begin(), there.end());
      if (there != back) ++wrong;
    }
  CHECK(lines == 529);
  CHECK(wrong == 0);
}

TEST_CASE("the checker's list: the checker's answer, and nothing where sight is blocked") {
  test::random r(41);
  int listed = 0, partial = 0, wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const irg::walled_grid g = test::random_map(r, {9, 9, 1}, static_cast<int>(r.integer(0, 20)), 4);
    const cell a{static_cast<int>(r.integer(0, 8)), static_cast<int>(r.integer(0, 8))};
    const cell b{static_cast<int>(r.integer(0, 8)), static_cast<int>(r.integer(0, 8))};
    const auto list = sight_list(g, a, b);
    if (list.seen != sight_2d(g, a, b)) ++wrong;
    if (list.cells != (list.seen == sight::blocked ? std::vector<cell>{} : crossed(a, b))) ++wrong;
    for (const cell c : list.cells)
      if (c != a && c != b && g.is_full({c.x, c.y, 0})) ++wrong;
    listed += list.seen == sight::full ? 1 : 0;
    partial += list.seen == sight::partial ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(listed > 100);
  CHECK(partial > 50);
}

// Away from 45 degrees, cells and third cells are all that the segment crosses: the algorithm is the exact definition.
TEST_CASE("where the algorithm differs from the exact definition: on lines of 45 degrees only") {
  test::random r(5);
  int differ = 0, wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const irg::walled_grid g =
        test::random_map(r, {9, 9, 1}, static_cast<int>(r.integer(0, 30)), static_cast<int>(r.integer(0, 1) * 8));
    const cell a{static_cast<int>(r.integer(0, 8)), static_cast<int>(r.integer(0, 8))};
    const cell b{static_cast<int>(r.integer(0, 8)), static_cast<int>(r.integer(0, 8))};
    const bool seen = sight_2d(g, a, b) != sight::blocked, exact = test::sees(g, a, b);
    CHECK(sight_2d(g, b, a) == sight_2d(g, a, b));
    if (seen == exact) continue;
    ++differ;
    if (std::abs(b.x - a.x) != std::abs(b.y - a.y) || seen) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(differ > 0);
}

}  // namespace
