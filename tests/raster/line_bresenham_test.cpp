// SPDX-License-Identifier: MIT
#include <irg/raster/line_bresenham.hpp>

#include <cstdlib>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
__extension__ typedef __int128 wide;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr irg::cell_window everything{least, least, most, most};

constexpr std::vector<cell> cells(cell a, cell b, irg::cell_window w = everything) {
  std::vector<cell> out;
  irg::line_bresenham(a, b, w, [&](cell c) { out.push_back(c); });
  return out;
}

// The cell at step i, straight from the definition: the rational i*m/n, rounded to nearest, a tie towards the start.
constexpr cell oracle_cell(cell a, cell b, std::int64_t i) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t w = dx < 0 ? -dx : dx, h = dy < 0 ? -dy : dy, n = w > h ? w : h, m = w > h ? h : w;
  std::int64_t k =
      n == 0 ? 0 : static_cast<std::int64_t>(wide{i} * m / n);  // the integer below, then one more if nearer
  if (wide{2} * (wide{i} * m - wide{k} * n) > n) ++k;
  const std::int64_t sx = dx < 0 ? -1 : 1, sy = dy < 0 ? -1 : 1;
  return w > h ? cell{static_cast<int>(a.x + sx * i), static_cast<int>(a.y + sy * k)}
               : cell{static_cast<int>(a.x + sx * k), static_cast<int>(a.y + sy * i)};
}

TEST_CASE("line_bresenham: GOLDEN 2, the course's line (10,10)-(200,100)") {
  const auto line = cells({10, 10}, {200, 100});
  CHECK(line.size() == 191);
  int runs[4] = {}, length = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    ++length;
    if (i + 1 == line.size() || line[i + 1].y != line[i].y) {
      ++runs[length];
      length = 0;
    }
  }
  CHECK(runs[2] == 82);
  CHECK(runs[3] == 9);
}

TEST_CASE("line_bresenham: by hand, ties on the side of the start") {
  CHECK_BOTH(cells({0, 0}, {4, 2}) == std::vector<cell>{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}});
  CHECK_BOTH(cells({4, 2}, {0, 0}) == std::vector<cell>{{4, 2}, {3, 2}, {2, 1}, {1, 1}, {0, 0}});
  CHECK_BOTH(cells({3, 3}, {3, 3}) == std::vector<cell>{{3, 3}});
  CHECK_BOTH(cells({0, 0}, {-2, -2}) == std::vector<cell>{{0, 0}, {-1, -1}, {-2, -2}});
}

TEST_CASE("line_bresenham: every cell is the nearest one, and the quality criteria hold, for all ends in 11 x 11") {
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y) {
      const auto line = cells({2, -1}, {x, y});
      const int n = std::abs(x - 2) > std::abs(y + 1) ? std::abs(x - 2) : std::abs(y + 1);
      REQUIRE(line.size() == static_cast<std::size_t>(n) + 1);  // one cell per step of the longer axis
      REQUIRE(line.front() == cell{2, -1});
      REQUIRE(line.back() == cell{x, y});
      for (std::size_t i = 0; i < line.size(); ++i) {
        REQUIRE(line[i] == oracle_cell({2, -1}, {x, y}, static_cast<std::int64_t>(i)));
        if (i > 0) REQUIRE((std::abs(line[i].x - line[i - 1].x) <= 1 && std::abs(line[i].y - line[i - 1].y) <= 1));
      }
    }
}

TEST_CASE("line_bresenham: L9, clipped cells are the unclipped ones in the window, all pairs on 8 x 8, all windows") {
  long windows = 0;
  for (int a = 0; a < 64; ++a)
    for (int b = 0; b < 64; ++b) {
      const cell p{a % 8, a / 8}, q{b % 8, b / 8};
      const auto whole = cells(p, q);
      for (int x0 = 0; x0 < 8; ++x0)
        for (int x1 = x0; x1 <= 8; x1 += 2)
          for (int y0 = 0; y0 < 8; y0 += 2)
            for (int y1 = y0; y1 <= 8; ++y1) {
              std::vector<cell> expected;
              for (const cell c : whole)
                if (c.x >= x0 && c.x < x1 && c.y >= y0 && c.y < y1) expected.push_back(c);
              REQUIRE(cells(p, q, {x0, y0, x1, y1}) == expected);
              ++windows;
            }
    }
  CHECK(windows > 100000);
}

TEST_CASE("line_bresenham: random lines over the whole int range against the rational oracle") {
  test::random random(3);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 10000000 : 20000;
  long crossing = 0;
  for (int i = 0; i < trials; ++i) {
    const auto coordinate = [&] {
      const int bits = static_cast<int>(random.integer(4, 32));
      return static_cast<int>(random.integer(-(std::int64_t{1} << (bits - 1)), (std::int64_t{1} << (bits - 1)) - 1));
    };
    const cell a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    // a window around a cell of the line, so that most lines cross it
    const std::int64_t w = std::abs(std::int64_t{b.x} - a.x), h = std::abs(std::int64_t{b.y} - a.y), n = w > h ? w : h;
    const cell middle = oracle_cell(a, b, random.integer(0, n));
    const auto near = [&](int c) {
      return static_cast<int>(irg::clamp<std::int64_t>(c + random.integer(-9, 3), least, most - 16));
    };
    const irg::cell_window window{near(middle.x), near(middle.y), near(middle.x) + 12, near(middle.y) + 12};
    std::vector<cell> expected;  // walk the rows or columns of the window only
    const bool steep = h >= w;
    const std::int64_t start = steep ? a.y : a.x, sign = steep ? (b.y < a.y ? -1 : 1) : (b.x < a.x ? -1 : 1);
    const std::int64_t low = steep ? window.y_first : window.x_first,
                       high = (steep ? window.y_last : window.x_last) - 1;
    const std::int64_t i0 = sign > 0 ? low - start : start - high, i1 = sign > 0 ? high - start : start - low;
    for (std::int64_t k = i0 < 0 ? 0 : i0; k <= i1 && k <= n; ++k) {
      const cell c = oracle_cell(a, b, k);
      if (c.x >= window.x_first && c.x < window.x_last && c.y >= window.y_first && c.y < window.y_last)
        expected.push_back(c);
    }
    crossing += expected.size() >= 2;
    REQUIRE(cells(a, b, window) == expected);
  }
  CHECK(crossing > trials / 4);
}

TEST_CASE("line_bresenham: L1 to L3, ends at the extremes of int") {
  static constexpr irg::cell_window w{0, 0, 64, 64};
  constexpr auto diagonal = [] {
    int on = 0, n = 0;
    irg::line_bresenham({least, least}, {most, most}, w, [&](cell c) { ++n, on += c.x == c.y; });
    return on == 64 && n == 64;
  };
  CHECK_BOTH(diagonal());
  CHECK_BOTH(cells({least, 5}, {most, 5}, w).size() == 64);
  CHECK_BOTH(cells({5, most}, {5, least}, w).size() == 64);
  CHECK_BOTH(cells({least, 0}, {63, 63}, w).back() == cell{63, 63});
  CHECK(cells({most, least}, {0, 0}, w) == std::vector<cell>{{0, 0}});
}

TEST_CASE("line_bresenham: L4, L7, L8, L11, degenerate lines and windows") {
  CHECK_BOTH(cells({9, 9}, {9, 9}, {0, 0, 4, 4}).empty());
  CHECK_BOTH(cells({3, 3}, {3, 3}, {0, 0, 4, 4}).size() == 1);
  CHECK_BOTH(cells({-3, 2}, {2, -3}, {0, 0, 4, 4}).empty());      // the boxes overlap, the line misses
  CHECK_BOTH(cells({-3, 3}, {3, -3}, {0, 0, 4, 4}).size() == 1);  // exactly the corner
  CHECK_BOTH(cells({0, 0}, {3, 3}, {2, 2, 2, 9}).empty());
  CHECK_BOTH(cells({0, 0}, {3, 3}, {3, 3, 1, 1}).empty());  // inverted
}

}  // namespace
