// SPDX-License-Identifier: MIT
#include <irg/raster/line_cells.hpp>

#include <algorithm>
#include <iterator>
#include <ranges>
#include <vector>

#include <irg/raster/line_bresenham.hpp>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::line_cells;
using test::cells;

static_assert(std::random_access_iterator<line_cells::iterator>);
static_assert(std::ranges::random_access_range<const line_cells>);
static_assert(std::ranges::sized_range<const line_cells>);
static_assert(std::ranges::common_range<const line_cells>);

TEST_CASE("line_cells: range-for, size, cells by number") {
  constexpr auto sum = [] {
    int x = 0, y = 0, n = 0;
    for (const cell c : line_cells({0, 0}, {5, 2})) x += c.x, y += c.y, ++n;
    return x * 10000 + y * 100 + n;
  };
  CHECK_BOTH(sum() == 150606);
  CHECK_BOTH(line_cells({10, 10}, {200, 100}).size() == 191);
  CHECK_BOTH(line_cells({10, 10}, {200, 100})[40] == cell{50, 29});
  CHECK_BOTH(line_cells({10, 10}, {200, 100}).back() == cell{200, 100});
  CHECK_BOTH(line_cells({3, 3}, {3, 3}).size() == 1);
  CHECK_BOTH(line_cells({3, 3}, {3, 3}).front() == cell{3, 3});
  CHECK_BOTH(line_cells({3, 3}, {3, 3}, {.ends = irg::line_ends::half_open}).empty());
}

TEST_CASE("line_cells: all 2^32 cells of the longest line, by number only") {
  constexpr line_cells diagonal({test::least, test::least}, {test::most, test::most});
  CHECK_BOTH(diagonal.size() == std::int64_t{1} << 32);
  CHECK_BOTH(diagonal[std::int64_t{1} << 31] == cell{0, 0});
  CHECK_BOTH(diagonal.back() == cell{test::most, test::most});
  CHECK_BOTH(line_cells({test::most, test::least}, {test::least, test::most})[1] ==
             cell{test::most - 1, test::least + 1});
  CHECK_BOTH(line_cells({test::least, 0}, {test::most, 1}).size() == std::int64_t{1} << 32);
  CHECK_BOTH(line_cells({test::least, 0}, {test::most, 1})[std::int64_t{1} << 31] == cell{0, 1});
}

TEST_CASE("line_cells: standard algorithms, without a step more than they need") {
  constexpr line_cells line({-1000000000, 7}, {1000000000, -300000001});
  const auto below = std::ranges::partition_point(line, [](cell c) { return c.x < 12345; });
  CHECK(*below == line[1000012345]);
  CHECK(below - line.begin() == 1000012345);
  CHECK(std::ranges::count_if(line_cells({0, 0}, {9, 3}), [](cell c) { return c.y == 1; }) == 3);
  const line_cells short_line({0, 0}, {9, 3});
  CHECK(std::ranges::find(short_line, cell{4, 1}) - short_line.begin() == 4);
  const cells copied(short_line.begin(), short_line.end());  // the legacy algorithms, too
  CHECK(std::ranges::equal(copied, short_line));
  CHECK(std::ranges::equal(copied | std::views::reverse, short_line | std::views::reverse));
}

TEST_CASE("line_cells: every way to a cell leads to the same one") {
  test::random r(21);
  long wrong = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto coordinate = [&] {
      const std::int64_t half = std::int64_t{1} << r.integer(1, 31);
      return static_cast<int>(r.integer(-half, half - 1));
    };
    const int x = coordinate(), y = coordinate(), u = coordinate();
    const line_cells line({x, y}, {u, coordinate()}, test::all_line_options[k % 4]);
    if (line.empty()) continue;
    const std::int64_t i = r.integer(0, line.size() - 1), j = r.integer(0, line.size() - 1);
    const auto at_i = line.begin() + i;
    wrong += *at_i != line[i];
    wrong += *(at_i + (j - i)) != line[j] || at_i[j - i] != line[j] || *(line.end() - (line.size() - j)) != line[j];
    auto walk = at_i;
    for (std::int64_t s = i; s < line.size() && s < i + 9; ++s) wrong += *walk++ != line[s];
    if (walk == line.end()) --walk;
    for (std::int64_t s = walk - line.begin(); s >= 0 && s > i - 9; --s) {
      wrong += *walk != line[s];
      if (s > 0) walk--;
    }
    wrong += (at_i < line.begin() + j) != (i < j) || (at_i == line.begin() + j) != (i == j);
  }
  CHECK(wrong == 0);
}

TEST_CASE("line_cells: every line of a lattice and the whole int range against the oracle, all options") {
  test::check_window_line([](cell a, cell b, const irg::cell_window& w, const irg::line_options& options, auto&& emit) {
    for (const cell c : line_cells(a, b, w, options)) emit(c);
  });
}

TEST_CASE("line_cells: the four criteria, from the front and from the back") {
  test::check_line_criteria([](cell a, cell b) {
    const line_cells line(a, b);
    return cells(line.begin(), line.end());
  });
  test::check_line_criteria([](cell a, cell b) {
    const line_cells line(a, b);
    cells out;
    for (auto it = line.end(); it != line.begin();) out.push_back(*--it);
    std::reverse(out.begin(), out.end());
    return out;
  });
}

TEST_CASE("line_cells: what a window leaves of a line is counted and indexed from its first cell") {
  CHECK_BOTH(line_cells({0, 0}, {9, 3}, {4, 0, 8, 9}).size() == 4);
  CHECK_BOTH(line_cells({0, 0}, {9, 3}, {4, 0, 8, 9}).front() == cell{4, 1});
  CHECK_BOTH(line_cells({0, 0}, {9, 3}, {4, 0, 8, 9}).back() == cell{7, 2});
  CHECK_BOTH(line_cells({0, 0}, {9, 3}, {4, 0, 8, 9})[2] == cell{6, 2});
}

TEST_CASE("line_cells: empty windows, misses, inverted windows") {
  CHECK_BOTH(line_cells({0, 0}, {9, 9}, {3, 3, 3, 9}).empty());
  CHECK_BOTH(line_cells({0, 0}, {9, 9}, {5, 5, 1, 1}).size() == 0);
  CHECK_BOTH(line_cells({-3, 2}, {2, -3}, {0, 0, 4, 4}).begin() == line_cells({-3, 2}, {2, -3}, {0, 0, 4, 4}).end());
  CHECK_BOTH(line_cells::iterator{} == line_cells::iterator{});
}

}  // namespace
