// SPDX-License-Identifier: MIT
#include <irg/raster/circle_midpoint.hpp>

#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/curve_trials.hpp"
#include "support/framed_raster.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::cell_window;
__extension__ typedef __int128 wide;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();

constexpr std::vector<cell> cells(cell centre, int r, cell_window w = {-99, -99, 99, 99}) {
  std::vector<cell> out;
  irg::circle_midpoint(centre, r, w, [&](cell c) { out.push_back(c); });
  return out;
}

// The definition at one cell: with m the longer and k the shorter distance from the centre along the axes, m is the
// integer nearest to sqrt(r^2 - k^2), that is 2 * sqrt(r^2 - k^2) lies between 2m - 1 and 2m + 1.
bool on_circle(cell centre, std::int64_t r, cell c) {
  std::int64_t k = std::abs(std::int64_t{c.x} - centre.x), m = std::abs(std::int64_t{c.y} - centre.y);
  if (k > m) std::swap(k, m);
  if (k > r) return false;
  const wide square = wide{r} * r - wide{k} * k;
  return (m == 0 || wide{2 * m - 1} * (2 * m - 1) < 4 * square) && 4 * square < wide{2 * m + 1} * (2 * m + 1);
}

bool in_disc(cell centre, std::int64_t r, cell c) {
  const wide x = std::int64_t{c.x} - centre.x, y = std::int64_t{c.y} - centre.y;
  return r >= 0 && x * x + y * y <= wide{r} * r;
}

// Compares both forms with their definitions in a window.
void check_window(cell centre, int r, const cell_window& w) {
  const bool good = test::is_as_defined(
      w, [&](auto&& sink) { irg::circle_midpoint(centre, r, w, sink); },
      [&](auto&& sink) { irg::circle_spans(centre, r, w, sink); },
      [&](cell c) { return r >= 0 && on_circle(centre, r, c); }, [&](cell c) { return in_disc(centre, r, c); });
  REQUIRE_MESSAGE(good, "radius ", r);
}

TEST_CASE("circle_midpoint: by hand") {
  CHECK_BOTH(cells({5, 7}, 0) == std::vector<cell>{{5, 7}});
  CHECK_BOTH(cells({5, 7}, -1).empty());
  CHECK_BOTH(cells({5, 7}, least).empty());
  CHECK_BOTH(cells({0, 0}, 1).size() == 4);
  CHECK_BOTH(cells({0, 0}, 2).size() == 12);
  CHECK_BOTH(cells({0, 0}, 4).size() == 24);  // (3, 3) is nearest in its row and column
  constexpr auto picture = [] {
    std::array<int, 7> rows{};
    for (const cell c : cells({3, 3}, 3)) rows[static_cast<std::size_t>(c.y)] |= 1 << c.x;
    return rows;
  };
  CHECK_BOTH(picture() ==
             std::array<int, 7>{0b0011100, 0b0100010, 0b1000001, 0b1000001, 0b1000001, 0b0100010, 0b0011100});
}

TEST_CASE("circle_midpoint: every cell once, by the definition, whole and in windows") {
  for (int r = -1; r <= 64; ++r) check_window({0, 0}, r, {-70, -70, 70, 70});
  test::random random(81);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 300000 : 3000;
  for (int i = 0; i < trials; ++i) {
    const auto at = [&](int extent) { return static_cast<int>(random.integer(-extent, extent)); };
    const int r = static_cast<int>(random.integer(0, 60)), x = at(60), y = at(60);
    check_window({at(9), at(9)}, r,
                 {x, y, x + static_cast<int>(random.integer(0, 40)), y + static_cast<int>(random.integer(0, 40))});
  }
}

TEST_CASE("circle_midpoint: a closed 8-connected curve, symmetric, no cell farther than half a cell along its axis") {
  for (int r = 1; r <= 300; ++r) {
    std::vector<char> grid(610 * 610, 0);
    const auto at = [&](int x, int y) -> char& { return grid[static_cast<std::size_t>((y + 305) * 610 + x + 305)]; };
    const auto line = cells({0, 0}, r, {-305, -305, 305, 305});
    for (const cell c : line) {
      ++at(c.x, c.y);
    }
    bool good = true;
    for (const cell c : line) {
      good &= at(c.x, c.y) == 1 && at(-c.x, c.y) == 1 && at(c.x, -c.y) == 1 && at(c.y, c.x) == 1;
      int neighbours = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) neighbours += (dx != 0 || dy != 0) && at(c.x + dx, c.y + dy);
      good &= neighbours >= 2;
    }
    REQUIRE_MESSAGE(good, "radius ", r);
    REQUIRE(test::count_connected(line.front(), at) == line.size());
  }
}

TEST_CASE("circle_midpoint: radii and centres up to the limits of int") {
  static constexpr cell_window w{0, 0, 64, 64};
  CHECK_BOTH(cells({most, 32}, most, w).size() == 64);  // nearly upright through column 0
  CHECK_BOTH(cells({least, least}, most, w).empty());
  CHECK_BOTH(cells({0, 0}, most, w).empty());
  CHECK_BOTH(cells({0, 0}, 5, {3, 3, 3, 9}).empty());
  CHECK_BOTH(cells({0, 0}, 5, {3, 3, 1, 1}).empty());
  test::random random(82);
  long seen = 0;
  for (int i = 0; i < 2000; ++i) {
    const int bits = static_cast<int>(random.integer(8, 31));
    const std::int64_t r = random.integer(1, (std::int64_t{1} << bits) - 1), dx = random.integer(-r, r);
    const auto dy = static_cast<std::int64_t>(irg::sqrt(static_cast<double>(r * r - dx * dx))) * (i % 2 ? 1 : -1);
    const cell centre{static_cast<int>(irg::clamped<std::int64_t>(-dx, least, most)),
                      static_cast<int>(irg::clamped<std::int64_t>(-dy, least, most))};
    const int x = static_cast<int>(random.integer(-12, 0)), y = static_cast<int>(random.integer(-12, 0));
    check_window(centre, static_cast<int>(r), {x, y, x + 13, y + 13});
    seen += static_cast<long>(cells(centre, static_cast<int>(r), {x, y, x + 13, y + 13}).size());
  }
  CHECK(seen > 10000);
}

TEST_CASE("draw_circle, fill_circle: paint by value or function, each pixel once, and nothing outside") {
  constexpr auto good = [] {
    irg::image<int> image(9, 9);
    const auto add = [](int there) { return there + 1; };
    irg::draw_circle(image, {4, 4}, 4, add);
    irg::fill_circle(image, {4, 4}, 2, add);
    irg::draw_circle(irg::within(image, {-9, 7, 9, 99}), {0, 8}, 3, 5);
    int n = 0;
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 9; ++x) {
        if (image(x, y) > 1) return -1;
        n += image(x, y);
      }
    return n * 10 + (image(3, 8) == 5 && image(3, 7) == 5);
  };
  CHECK_BOTH(good() == (13 + 24 - 7) * 10 + 1);
  test::framed_raster<double> framed;
  auto& view = framed.view;
  const cell_window beyond{-100, -100, 100, 100};
  for (int r = 0; r < 12; ++r) irg::draw_circle(irg::within(view, beyond), {5, 3}, r, 1.0);
  irg::fill_circle(irg::within(view, beyond), {9, 6}, 4, 2.0);
  irg::fill_circle(view, {-1000, 3}, 1001, 2.0);
  CHECK(framed.frame_is_whole());
  CHECK(framed.painted() > 40);
}

}  // namespace
