// SPDX-License-Identifier: MIT
#include <irg/raster/textbook/line_bresenham.hpp>

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/line_cells.hpp>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::cell;
using test::cells;
using test::rational;

template <class Number = double>
constexpr cells textbook(cell a, cell b) {
  cells out;
  irg::textbook::line_bresenham<Number>(a, b, [&](cell c) { out.push_back(c); });
  return out;
}

// How many cells differ from line_bresenham's.
template <class Number>
std::int64_t wrong_cells(cell a, cell b) {
  auto expected = irg::line_cells(a, b).begin();
  std::int64_t wrong = 0, count = 0;
  CHECK(irg::textbook::line_bresenham<Number>(a, b, [&](cell c) { wrong += c != *expected++, ++count; }));
  return wrong + (count != irg::line_cells(a, b).size());
}

// The textbook's own test, D > 0, in doubles.
std::int64_t wrong_cells_of_literal_test(std::int64_t n, std::int64_t m) {
  const double slope = static_cast<double>(m) / static_cast<double>(n);
  double distance = slope - 0.5;
  std::int64_t aside = 0, wrong = 0;
  auto expected = irg::line_cells({0, 0}, {static_cast<int>(n), static_cast<int>(m)}).begin();
  for (std::int64_t i = 0; i < n; ++i) {
    wrong += (*expected++).y != aside;
    if (distance > 0) {
      ++aside;
      distance -= 1;
    }
    distance += slope;
  }
  return wrong;
}

TEST_CASE("textbook::line_bresenham: the course's values, all octants, ties, degenerate lines") {
  CHECK_BOTH(textbook({10, 10}, {200, 100}).size() == 191);
  CHECK_BOTH(textbook({0, 0}, {5, 2}) == cells{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}});
  CHECK_BOTH(textbook({0, 0}, {2, 5}) == cells{{0, 0}, {0, 1}, {1, 2}, {1, 3}, {2, 4}, {2, 5}});
  CHECK_BOTH(textbook({0, 0}, {-2, 5}) == cells{{0, 0}, {0, 1}, {-1, 2}, {-1, 3}, {-2, 4}, {-2, 5}});
  CHECK_BOTH(textbook({0, 0}, {-5, 2}) == cells{{0, 0}, {-1, 0}, {-2, 1}, {-3, 1}, {-4, 2}, {-5, 2}});
  CHECK_BOTH(textbook({0, 0}, {-5, -2}) == cells{{0, 0}, {-1, 0}, {-2, -1}, {-3, -1}, {-4, -2}, {-5, -2}});
  CHECK_BOTH(textbook({0, 0}, {-2, -5}) == cells{{0, 0}, {0, -1}, {-1, -2}, {-1, -3}, {-2, -4}, {-2, -5}});
  CHECK_BOTH(textbook({0, 0}, {2, -5}) == cells{{0, 0}, {0, -1}, {1, -2}, {1, -3}, {2, -4}, {2, -5}});
  CHECK_BOTH(textbook({0, 0}, {5, -2}) == cells{{0, 0}, {1, 0}, {2, -1}, {3, -1}, {4, -2}, {5, -2}});
  CHECK_BOTH(textbook({3, 3}, {3, 3}) == cells{{3, 3}});
  CHECK_BOTH(textbook({0, 0}, {0, -3}) == cells{{0, 0}, {0, -1}, {0, -2}, {0, -3}});
  CHECK_BOTH(textbook({0, 0}, {-3, 3}) == cells{{0, 0}, {-1, 1}, {-2, 2}, {-3, 3}});
  CHECK_BOTH(textbook({4, 2}, {0, 0}) == cells{{4, 2}, {3, 2}, {2, 1}, {1, 1}, {0, 0}});
}

TEST_CASE("textbook::line_bresenham: Fabris's table 1: x, y, and D at the end of each pass") {
  std::vector<std::pair<cell, rational>> rows;
  irg::textbook::line_bresenham<rational>({0, 0}, {8, 4}, [&](cell c, const rational& d) { rows.push_back({c, d}); });
  REQUIRE(rows.size() == 9);
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(rows[i].first == cell{static_cast<int>(i), static_cast<int>(i / 2)});
    CHECK(rows[i + 1].second == (i % 2 == 0 ? rational(1, 2) : rational(0)));
  }
}

TEST_CASE("textbook::line_bresenham: Fabris's table 3") {
  const cells there = textbook({0, 0}, {8, 4});
  const cells back = textbook({8, 4}, {0, 0});
  const cells reversed(back.rbegin(), back.rend());
  CHECK(there == cells{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}, {6, 3}, {7, 3}, {8, 4}});
  CHECK(reversed == cells{{0, 0}, {1, 1}, {2, 1}, {3, 2}, {4, 2}, {5, 3}, {6, 3}, {7, 4}, {8, 4}});
  for (std::size_t i = 0; i < 9; ++i) CHECK((there[i] != reversed[i]) == (i % 2 == 1));
}

TEST_CASE("textbook::line_bresenham: the four criteria, in double, float and exact numbers") {
  test::check_line_criteria([](cell a, cell b) { return textbook(a, b); });
  test::check_line_criteria([](cell a, cell b) { return textbook<float>(a, b); });
  test::check_line_criteria([](cell a, cell b) { return textbook<rational>(a, b); });
}

TEST_CASE("textbook::line_bresenham: every slope of up to 400 steps, in double and float") {
  const int longest = test::release_tier() ? 1024 : 400;
  std::int64_t wrong = 0, literal_wrong_lines = 0, lines = 0;
  for (int n = 1; n <= longest; ++n)
    for (int m = 0; m <= n; ++m) {
      wrong += wrong_cells<double>({0, 0}, {n, m}) + wrong_cells<float>({0, 0}, {m, -n});
      literal_wrong_lines += wrong_cells_of_literal_test(n, m) != 0;
      ++lines;
    }
  CHECK(wrong == 0);
  CHECK(10 * literal_wrong_lines > lines);  // D > 0 would not do
}

// Slopes whose D comes as near to 0 as it can: ties (even n), and n near a multiple of m.
TEST_CASE("textbook::line_bresenham: up to 2^20 steps and beyond, ties and near-ties") {
  test::random r(5);
  const int trials = test::release_tier() ? 400 : 3;
  std::int64_t wrong = 0, tied = 0;
  for (int i = 0; i < trials; ++i) {
    const auto steps = static_cast<int>(i % 3 == 0 ? 1 << 20 : r.integer(1 << 19, 1 << 20));
    const auto m = static_cast<int>(i % 4 == 0   ? steps / 2 + r.integer(-3, 3)
                                    : i % 4 == 1 ? r.integer(0, 40)
                                    : i % 4 == 2 ? steps - r.integer(0, 40)
                                                 : r.integer(0, steps));
    tied += steps / std::gcd(steps, m) % 2 == 0;
    const auto far = [&] { return static_cast<int>(r.integer(-(1 << 30), 1 << 30)); };
    const int x = far();
    const cell a{x, far()};
    const cell b{a.x + (r.integer(0, 1) ? steps : -steps), a.y + (r.integer(0, 1) ? m : -m)};
    wrong += wrong_cells<double>(a, b);
    wrong += wrong_cells<double>({a.y, a.x}, {b.y, b.x});
  }
  for (const int n : {1048574, 1048575, 1048576}) {
    for (const int m : {1, 349525, 524287, n - 1}) {
      wrong += wrong_cells<double>({-n, 7}, {0, 7 - m});
      tied += n / std::gcd(n, m) % 2 == 0;
    }
  }
  if (test::release_tier())
    for (const int m : {1, 11184811, 33554431, 12345678}) wrong += wrong_cells<double>({0, 0}, {1 << 25, m});
  CHECK(wrong == 0);
  CHECK(tied >= 4);
}

TEST_CASE("textbook::line_bresenham: the limits: too many steps for the number, ends at the extremes of int") {
  CHECK_BOTH(irg::textbook::line_bresenham_steps<double> == 1 << 25);
  CHECK_BOTH(irg::textbook::line_bresenham_steps<float> == 1 << 10);
  CHECK_BOTH(irg::textbook::line_bresenham_steps<rational> == std::int64_t{1} << 32);
  CHECK_BOTH(!irg::textbook::line_bresenham<float>({0, 0}, {1025, 3}, [](cell) {}));
  CHECK_BOTH(irg::textbook::line_bresenham<float>({0, 0}, {-4, 3}, [](cell) {}));
  CHECK_BOTH(!irg::textbook::line_bresenham({test::least, 0}, {test::most, 0}, [](cell) {}));
  CHECK_BOTH(textbook({test::most, test::most}, {test::most - 2, test::most}).back() ==
             cell{test::most - 2, test::most});
  CHECK_BOTH(textbook({test::least, test::most}, {test::least + 1, test::most - 2}) ==
             cells{{test::least, test::most}, {test::least, test::most - 1}, {test::least + 1, test::most - 2}});
}

}  // namespace
