// SPDX-License-Identifier: MIT
#include <irg/raster/textbook/line_printed.hpp>

#include <irg/raster/line_bresenham.hpp>

#include "support/check_both.hpp"
#include "support/line_oracle.hpp"
#include "support/line_properties.hpp"
#include "support/rational.hpp"

namespace {

using irg::cell;
using test::cells;
using test::rational;
constexpr irg::cell_window everything{test::least, test::least, test::most, test::most};

template <class Number = double>
constexpr cells seed(cell a, cell b) {
  cells out;
  irg::textbook::line_bresenham_printed<Number>(a, b, [&](cell c) { out.push_back(c); });
  return out;
}
template <class Number = double>
constexpr cells octant(cell to) {
  cells out;
  irg::textbook::line_octant<Number>(to, [&](cell c) { out.push_back(c); });
  return out;
}
template <class Number = double>
constexpr cells quadrant(cell to) {
  cells out;
  irg::textbook::line_quadrant<Number>(to, [&](cell c) { out.push_back(c); });
  return out;
}
template <class Number = double>
constexpr cells plane(cell a, cell b) {
  cells out;
  irg::textbook::line_plane<Number>(a, b, [&](cell c) { out.push_back(c); });
  return out;
}
cells bresenham(cell a, cell b, irg::line_ends ends = irg::line_ends::closed) {
  cells out;
  irg::line_bresenham(a, b, everything, [&](cell c) { out.push_back(c); }, {.ends = ends});
  return out;
}

TEST_CASE(
    "textbook::line_bresenham_printed: the course's values, 190 cells of (10,10)-(200,100), the last is (199,100)") {
  CHECK_BOTH(seed({10, 10}, {200, 100}).size() == 190);
  CHECK_BOTH(seed({10, 10}, {200, 100}).back() == cell{199, 100});
  CHECK(seed({10, 10}, {200, 100}) == bresenham({10, 10}, {200, 100}, irg::line_ends::half_open));
}

TEST_CASE("textbook::line_bresenham_printed: in exact numbers, the half-open line for every slope of its domain") {
  int wrong = 0, wrong_in_double = 0;
  for (int n = 1; n <= 60; ++n)
    for (int m = 0; m <= n; ++m) {
      const cells expected = bresenham({-5, 9}, {n - 5, m + 9}, irg::line_ends::half_open);
      wrong += seed<rational>({-5, 9}, {n - 5, m + 9}) != expected;
      wrong_in_double += seed({-5, 9}, {n - 5, m + 9}) != expected;
    }
  CHECK(wrong == 0);
  CHECK(wrong_in_double > 0);  // D > 0 at a tie: 1e-17 instead of 0
  CHECK_BOTH(seed({0, 0}, {6, 5})[3] == cell{3, 3});  // the line passes (3, 2.5): (3, 2) is on the start's side
  CHECK_BOTH(seed<rational>({0, 0}, {6, 5})[3] == cell{3, 2});
}

TEST_CASE("textbook::line_bresenham_printed: outside 0 to 45 degrees nothing comes out") {
  for (const cell b :
       {cell{2, 5}, cell{-2, 5}, cell{-5, 2}, cell{-5, -2}, cell{5, -2}, cell{0, 0}, cell{0, 5}, cell{-5, 0}})
    CHECK((!irg::textbook::line_bresenham_printed({0, 0}, b, [](cell) { FAIL("no cell"); })));
  CHECK_BOTH(seed({0, 0}, {3, 3}) == cells{{0, 0}, {1, 1}, {2, 2}});
  CHECK_BOTH(seed({0, 0}, {2, 0}) == cells{{0, 0}, {1, 0}});
  CHECK_BOTH(!irg::textbook::line_bresenham_printed({test::least, 0}, {test::most, 0}, [](cell) {}));
  CHECK_BOTH(seed({test::most - 2, test::most - 1}, {test::most, test::most}).size() == 2);
}

TEST_CASE("textbook::line_octant: Fabris's values, the literal listing corrects before it plots") {
  CHECK_BOTH(octant({8, 4}) == cells{{0, 0}, {1, 1}, {2, 1}, {3, 2}, {4, 2}, {5, 3}, {6, 3}, {7, 4}, {8, 4}});
  CHECK_BOTH(octant({5, 3}) == cells{{0, 1}, {1, 1}, {2, 2}, {3, 2}, {4, 3}, {5, 3}});
  for (const cell to : {cell{3, 3}, cell{2, 5}, cell{-5, 2}, cell{5, -2}, cell{0, 0}})
    CHECK((!irg::textbook::line_octant(to, [](cell) { FAIL("no cell"); })));
}

TEST_CASE("textbook::line_quadrant: the other octant is the mirrored one") {
  CHECK_BOTH(quadrant({5, 3}) == octant({5, 3}));
  CHECK_BOTH(quadrant({3, 5}) == cells{{1, 0}, {1, 1}, {2, 2}, {2, 3}, {3, 4}, {3, 5}});
  CHECK_BOTH(quadrant({0, 2}) == cells{{0, 0}, {0, 1}, {0, 2}});
  for (const cell to : {cell{0, 0}, cell{-1, 5}, cell{5, -1}, cell{-2, -3}})
    CHECK((!irg::textbook::line_quadrant(to, [](cell) { FAIL("no cell"); })));
}

TEST_CASE("textbook::line_plane: Fabris's values, y moves by the sign of x; all other lines are right") {
  CHECK_BOTH(plane({0, 0}, {5, -2}) == cells{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}});
  CHECK_BOTH(plane({0, 0}, {8, 4}) == cells{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}, {6, 3}, {7, 3}, {8, 4}});
  int wrong = 0, mirrored = 0;
  for (int x = -12; x <= 12; ++x)
    for (int y = -12; y <= 12; ++y) {
      if (x == 0 && y == 0) continue;
      const cells drawn = plane<rational>({1, 2}, {1 + x, 2 + y});
      const bool faulty = (x < 0 ? -x : x) > (y < 0 ? -y : y) && y != 0 && (x < 0) != (y < 0);
      mirrored += faulty;
      wrong += drawn != bresenham({1, 2}, {1 + x, faulty ? 2 - y : 2 + y});
    }
  CHECK(wrong == 0);
  CHECK(mirrored == 132);
}

TEST_CASE("textbook::line_plane: identical ends, and a faulty direction that would leave int") {
  CHECK_BOTH(plane({3, 3}, {3, 3}).empty());
  CHECK_BOTH(plane({0, test::most}, {5, test::most - 2}).empty());
  CHECK_BOTH(plane({0, test::most - 2}, {5, test::most}).size() == 6);
  CHECK_BOTH(plane({0, test::least}, {-5, test::least + 2}).empty());
}

}  // namespace
