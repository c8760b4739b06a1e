// SPDX-License-Identifier: MIT
#include <irg/raster/line_bresenham.hpp>

#include <cstdlib>
#include <iterator>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"
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

TEST_CASE("line_bresenham: the course's line (10,10)-(200,100)") {
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

constexpr auto draw = [](cell a, cell b, const irg::cell_window& w, const irg::line_options& options, auto&& emit) {
  irg::line_bresenham(a, b, w, emit, options);
};

TEST_CASE("line_bresenham: every line of a lattice and the whole int range against the oracle, all options") {
  test::check_window_line(draw);
}

TEST_CASE("line_bresenham: the four criteria, closed and half-open, both ties") {
  for (const irg::line_options& options : test::all_line_options)
    test::check_line_criteria(
        [&](cell a, cell b) {
          test::cells line;
          irg::line_bresenham(a, b, everything, [&](cell c) { line.push_back(c); }, options);
          return line;
        },
        options.ends);
}

TEST_CASE("line_bresenham: Fabris's values, symmetric ties: 5000 random pairs have the same cells both ways") {
  test::random r(2);
  constexpr irg::line_options symmetric{.ties = irg::line_ties::symmetric};
  int different = 0, plain_different = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto coordinate = [&] { return static_cast<int>(r.integer(-15, 15)); };
    const int ax = coordinate(), ay = coordinate(), bx = coordinate();
    const cell a{ax, ay}, b{bx, coordinate()};
    const auto both = [&](const irg::line_options& options) {
      std::vector<cell> there, back;
      irg::line_bresenham(a, b, everything, [&](cell c) { there.push_back(c); }, options);
      irg::line_bresenham(b, a, everything, [&](cell c) { back.push_back(c); }, options);
      return std::vector<cell>(back.rbegin(), back.rend()) == there;
    };
    different += !both(symmetric);
    plain_different += !both({});
  }
  CHECK(different == 0);
  CHECK(plain_different > 500);  // start_side is another rule
}

TEST_CASE("line_bresenham: Fabris's values, symmetric ties by hand") {
  constexpr auto symmetric = [](cell a, cell b) {
    std::vector<cell> out;
    irg::line_bresenham(a, b, everything, [&](cell c) { out.push_back(c); }, {.ties = irg::line_ties::symmetric});
    return out;
  };
  CHECK_BOTH(symmetric({0, 0}, {8, 4}) ==
             std::vector<cell>{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}, {6, 3}, {7, 3}, {8, 4}});
  CHECK_BOTH(symmetric({8, 4}, {0, 0}) ==
             std::vector<cell>{{8, 4}, {7, 3}, {6, 3}, {5, 2}, {4, 2}, {3, 1}, {2, 1}, {1, 0}, {0, 0}});
  CHECK_BOTH(symmetric({0, 4}, {8, 0}) ==
             std::vector<cell>{{0, 4}, {1, 4}, {2, 3}, {3, 3}, {4, 2}, {5, 2}, {6, 1}, {7, 1}, {8, 0}});
  CHECK_BOTH(symmetric({4, 8}, {0, 0}) ==
             std::vector<cell>{{4, 8}, {3, 7}, {3, 6}, {2, 5}, {2, 4}, {1, 3}, {1, 2}, {0, 1}, {0, 0}});
}

TEST_CASE("line_bresenham: a half-open polyline draws each vertex once, whatever the ties") {
  constexpr cell ring[] = {{0, 0}, {9, 4}, {4, 13}, {-7, 2}, {-7, 2}, {0, -6}};
  for (const irg::line_ties ties : {irg::line_ties::start_side, irg::line_ties::symmetric})
    for (const cell vertex : ring) {
      int drawn = 0, corners = 0;
      for (std::size_t i = 0; i < std::size(ring); ++i) {
        irg::line_bresenham(ring[i], ring[(i + 1) % std::size(ring)], everything, [&](cell c) { drawn += c == vertex; },
                            {irg::line_ends::half_open, ties});
        corners += ring[i] == vertex;
      }
      CHECK(drawn == (corners == 2 ? 1 : corners));  // the repeated vertex' own line is empty
    }
}

TEST_CASE("line_bresenham: ends at the extremes of int") {
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

TEST_CASE("line_bresenham: degenerate lines and windows") {
  CHECK_BOTH(cells({9, 9}, {9, 9}, {0, 0, 4, 4}).empty());
  CHECK_BOTH(cells({3, 3}, {3, 3}, {0, 0, 4, 4}).size() == 1);
  CHECK_BOTH(cells({-3, 2}, {2, -3}, {0, 0, 4, 4}).empty());      // the boxes overlap, the line misses
  CHECK_BOTH(cells({-3, 3}, {3, -3}, {0, 0, 4, 4}).size() == 1);  // exactly the corner
  CHECK_BOTH(cells({0, 0}, {3, 3}, {2, 2, 2, 9}).empty());
  CHECK_BOTH(cells({0, 0}, {3, 3}, {3, 3, 1, 1}).empty());  // inverted
  CHECK_BOTH(cells({0, 0}, {0, 0}, {0, 0, 1, 1}) == std::vector<cell>{{0, 0}});
  CHECK_BOTH(cells({4, 0}, {4, 0}, {0, 0, 4, 4}).empty());  // x_last is outside
  CHECK_BOTH(cells({3, 0}, {3, 0}, {0, 0, 4, 4}).size() == 1);
}

TEST_CASE("line_bresenham: two cells in all eight directions") {
  constexpr auto both_cells = [] {
    bool right = true;
    for (int k = 0; k < 9; ++k) {
      const cell b{5 + k % 3 - 1, 5 + k / 3 - 1};
      right = right && (k == 4 ? cells({5, 5}, b).size() == 1 : cells({5, 5}, b) == std::vector<cell>{{5, 5}, b});
    }
    return right;
  };
  CHECK_BOTH(both_cells());
}

TEST_CASE("line_bresenham: slope one half forward and back") {
  CHECK_BOTH(cells({0, 0}, {6, 3}) == std::vector<cell>{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}, {6, 3}});
  CHECK_BOTH(cells({6, 3}, {0, 0}) == std::vector<cell>{{6, 3}, {5, 3}, {4, 2}, {3, 2}, {2, 1}, {1, 1}, {0, 0}});
}

TEST_CASE("line_bresenham: without a window, the cells at the greatest int, too") {
  constexpr auto all = [](cell a, cell b, irg::line_options options) {
    std::vector<cell> out;
    irg::line_bresenham(a, b, [&](cell c) { out.push_back(c); }, options);
    return out;
  };
  CHECK_BOTH(all({most - 2, most}, {most, most - 1}, {}) ==
             std::vector<cell>{{most - 2, most}, {most - 1, most}, {most, most - 1}});
  CHECK_BOTH(all({most, most - 1}, {most - 2, most}, {irg::line_ends::half_open, irg::line_ties::symmetric}) ==
             std::vector<cell>{{most, most - 1}, {most - 1, most}});
}

TEST_CASE("line_bresenham: far ends that other libraries draw wrong") {
  constexpr irg::cell_window w{0, 0, 1024, 1024};
  constexpr struct {
    cell a, b;
  } far[] = {{{262, 23}, {91618510, -54756195}}, {{263, 214}, {80120779, 11846827}}, {{34, 204}, {46400, 47400}}};
  for (const auto& line : far) {
    test::cells expected;
    test::oracle_line(line.a, line.b, w, {}, expected);
    CHECK(expected.size() > 20);
    CHECK(cells(line.a, line.b, w) == expected);
    test::oracle_line(line.b, line.a, w, {}, expected);
    CHECK(cells(line.b, line.a, w) == expected);
  }
}

}  // namespace
