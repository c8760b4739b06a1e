// SPDX-License-Identifier: MIT
#include <irg/raster/ellipse_midpoint.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/raster/circle_midpoint.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/curve_trials.hpp"
#include "support/framed_raster.hpp"
#include "support/random.hpp"

namespace {

using irg::cell;
using irg::cell_window;
using irg::span_of_cells;
__extension__ typedef __int128 wide;
constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();

constexpr std::vector<cell> cells(cell centre, int a, int b, cell_window w = {-99, -99, 99, 99}) {
  std::vector<cell> out;
  irg::ellipse_midpoint(centre, a, b, w, [&](cell c) { out.push_back(c); });
  return out;
}

// Whether m is the integer nearest to the ellipse's height at k, its radii being p along and q aside; by squares.
bool nearest(wide p, wide q, wide k, wide m) {
  if (k > p) return false;
  const wide square = 4 * q * q * (p * p - k * k);
  return (m == 0 || (2 * m - 1) * (2 * m - 1) * p * p < square) && square < (2 * m + 1) * (2 * m + 1) * p * p;
}

// Whether column k lies where the ellipse is not steeper than 45 degrees: k <= p^2 / sqrt(p^2 + q^2).
bool flat(wide p, wide q, wide k) { return k * k * (p * p + q * q) <= p * p * p * p; }

bool on_ellipse(cell centre, wide a, wide b, cell c) {
  const wide x = std::abs(std::int64_t{c.x} - centre.x), y = std::abs(std::int64_t{c.y} - centre.y);
  if (a == 0 || b == 0) return x <= a && y <= b;
  const bool column = nearest(a, b, x, y), row = nearest(b, a, y, x);
  if (flat(a, b, x) && column) return true;
  if (flat(b, a, y) && row) return true;
  const bool beyond_x = !flat(a, b, x) && flat(a, b, x - 1), beyond_y = !flat(b, a, y) && flat(b, a, y - 1);
  return beyond_x && beyond_y && (column || row);
}

bool in_ellipse(cell centre, wide a, wide b, cell c) {
  const wide x = std::int64_t{c.x} - centre.x, y = std::int64_t{c.y} - centre.y;
  if (a == 0 || b == 0) return x <= a && -x <= a && y <= b && -y <= b;
  return x <= a && -x <= a && y * y * a * a <= b * b * (a * a - x * x);
}

// Compares both forms with their definitions in a window.
void check_window(cell centre, int a, int b, const cell_window& w) {
  const bool good = test::is_as_defined(
      w, [&](auto&& sink) { irg::ellipse_midpoint(centre, a, b, w, sink); },
      [&](auto&& sink) { irg::ellipse_spans(centre, a, b, w, sink); },
      [&](cell c) { return on_ellipse(centre, a, b, c); }, [&](cell c) { return in_ellipse(centre, a, b, c); });
  REQUIRE_MESSAGE(good, "radii ", a, " and ", b);
}

TEST_CASE("ellipse_midpoint: by hand and degenerate") {
  CHECK_BOTH(cells({5, 7}, 0, 0) == std::vector<cell>{{5, 7}});
  CHECK_BOTH(cells({5, 7}, 2, 0) == std::vector<cell>{{3, 7}, {4, 7}, {5, 7}, {6, 7}, {7, 7}});
  CHECK_BOTH(cells({5, 7}, 0, 1) == std::vector<cell>{{5, 6}, {5, 7}, {5, 8}});
  CHECK_BOTH(cells({5, 7}, -1, 3).empty());
  CHECK_BOTH(cells({5, 7}, 3, least).empty());
  // Radii 4 and 1: columns up to 3 at height 1, and the tips
  CHECK_BOTH(cells({0, 0}, 4, 1).size() == 16);
  constexpr auto spans = [] {
    std::vector<span_of_cells> out;
    irg::ellipse_spans({0, 0}, 5, 2, {-9, -9, 9, 9}, [&](span_of_cells s) { out.push_back(s); });
    return out;
  };
  CHECK_BOTH(spans() == std::vector<span_of_cells>{{-2, 0, 1}, {-1, -4, 5}, {0, -5, 6}, {1, -4, 5}, {2, 0, 1}});
}

TEST_CASE("ellipse_midpoint: every cell once, by the definition, whole and in windows") {
  for (int a = 0; a <= 24; ++a)
    for (int b = 0; b <= 24; ++b) check_window({0, 0}, a, b, {-26, -26, 27, 27});
  test::random random(91);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 300000 : 3000;
  for (int i = 0; i < trials; ++i) {
    const auto at = [&](int extent) { return static_cast<int>(random.integer(-extent, extent)); };
    const int a = static_cast<int>(random.integer(0, 60)), b = static_cast<int>(random.integer(0, i % 2 ? 60 : 3));
    const int x = at(50), y = i % 2 ? at(50) : at(5), w = static_cast<int>(random.integer(0, 40));
    if (i % 3)
      check_window({at(9), at(9)}, a, b, {x, y, x + w, y + 20});
    else
      check_window({at(9), at(9)}, b, a, {y, x, y + 20, x + w});
  }
}

// The cells in one piece, without a hole: the background inside cannot be reached from outside by steps along the axes.
void check_curve(int a, int b) {
  const int width = 2 * a + 5, height = 2 * b + 5;
  std::vector<char> grid(static_cast<std::size_t>(width * height), 0);
  const auto at = [&](int x, int y) -> char& {
    return grid[static_cast<std::size_t>((y + b + 2) * width + x + a + 2)];
  };
  const auto line = cells({0, 0}, a, b, {-a - 2, -b - 2, a + 3, b + 3});
  bool good = true;
  for (const cell c : line) good &= ++at(c.x, c.y) == 1;
  for (const cell c : line) good &= at(-c.x, c.y) == 1 && at(c.x, -c.y) == 1;
  good &= test::count_connected(line.front(), at) == line.size();
  if (at(0, 0) == 0) {  // seed fill from the centre must not get out
    std::vector<cell> unvisited{{0, 0}};
    at(0, 0) = 3;
    while (!unvisited.empty() && good) {
      const cell c = unvisited.back();
      unvisited.pop_back();
      good &= std::abs(c.x) < a && std::abs(c.y) < b;
      for (const cell d : {cell{1, 0}, cell{-1, 0}, cell{0, 1}, cell{0, -1}})
        if (good && at(c.x + d.x, c.y + d.y) == 0) {
          at(c.x + d.x, c.y + d.y) = 3;
          unvisited.push_back({c.x + d.x, c.y + d.y});
        }
    }
  }
  REQUIRE_MESSAGE(good, "radii ", a, " and ", b);
}

TEST_CASE("ellipse_midpoint: a closed 8-connected curve, symmetric, thin ones too") {
  const int greatest = std::getenv("IRG_RELEASE_TIER") ? 200 : 40;
  for (int a = 1; a <= greatest; ++a)
    for (int b = 1; b <= greatest; ++b) check_curve(a, b);
  for (const int a : {60, 100, 333, 1000})
    for (int b = 1; b <= 12; ++b) {
      check_curve(a, b);
      check_curve(b, a);
    }
}

TEST_CASE("ellipse_midpoint: equal radii give the circle, cell by cell") {
  for (int r = 0; r <= 400; ++r) {
    auto ellipse = cells({1, 2}, r, r, {-500, -500, 500, 500});
    std::vector<cell> circle;
    irg::circle_midpoint({1, 2}, r, {-500, -500, 500, 500}, [&](cell c) { circle.push_back(c); });
    const auto order = [](cell p, cell q) { return p.y != q.y ? p.y < q.y : p.x < q.x; };
    std::sort(ellipse.begin(), ellipse.end(), order);
    std::sort(circle.begin(), circle.end(), order);
    REQUIRE(ellipse == circle);
  }
}

TEST_CASE("ellipse_midpoint: radii and centres up to the limits of int") {
  static constexpr cell_window w{0, 0, 64, 64};
  CHECK_BOTH(cells({most, 32}, most, most, w).size() == 64);
  CHECK_BOTH(cells({most, 32}, most, most, w) != cells({most, 32}, most, 1 << 20, w));
  CHECK_BOTH(cells({0, 32}, most, 1, w).size() == 128);  // above and below
  CHECK_BOTH(cells({0, 32}, most, 0, w).size() == 64);
  CHECK_BOTH(cells({0, 0}, most, most, w).empty());
  CHECK_BOTH(cells({0, 0}, 5, 9, {3, 3, 3, 9}).empty());
  CHECK_BOTH(cells({0, 0}, 5, 9, {3, 3, 1, 1}).empty());
  test::random random(92);
  long seen = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto radius = [&] { return random.integer(1, (std::int64_t{1} << random.integer(4, 31)) - 1); };
    const std::int64_t a = radius(), b = radius(),
                       dx = i % 5 ? random.integer(-a, a) : a - random.integer(0, lround(std::sqrt(a)));
    const double t = static_cast<double>(dx) / static_cast<double>(a);
    const auto dy = static_cast<std::int64_t>(irg::sqrt((1 - t) * (1 + t)) * static_cast<double>(b)) * (i % 2 ? 1 : -1);
    const cell centre{static_cast<int>(-dx), static_cast<int>(-dy)};
    const int x = static_cast<int>(random.integer(-12, 0)), y = static_cast<int>(random.integer(-12, 0));
    check_window(centre, static_cast<int>(a), static_cast<int>(b), {x, y, x + 13, y + 13});
    seen += static_cast<long>(cells(centre, static_cast<int>(a), static_cast<int>(b), {x, y, x + 13, y + 13}).size());
  }
  CHECK(seen > 15000);
}

TEST_CASE("draw_ellipse, fill_ellipse: paint by value or function, each pixel once, and nothing outside") {
  constexpr auto good = [] {
    irg::image<int> image(11, 7);
    const auto add = [](int there) { return there + 1; };
    irg::fill_ellipse(image, {5, 3}, 5, 3, add);
    irg::draw_ellipse(image, {5, 3}, 2, 1, [](int there) { return there + 10; });
    irg::draw_ellipse(irg::within(image, {0, 3, 1, 4}), {5, 3}, 5, 3, 100);
    int most_painted = 0, sum = 0;
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 11; ++x) {
        const int p = image(x, y);
        if (p != 100) most_painted = p > most_painted ? p : most_painted;
        sum += p;
      }
    return most_painted == 11 && image(0, 3) == 100 ? sum : -1;
  };
  CHECK_BOTH(good() > 100);
  test::framed_raster<double> framed;
  auto& view = framed.view;
  const cell_window beyond{-100, -100, 100, 100};
  for (int r = 0; r < 12; ++r) irg::draw_ellipse(irg::within(view, beyond), {5, 3}, r, 12 - r, 1.0);
  irg::fill_ellipse(irg::within(view, beyond), {9, 6}, 4, 9, 2.0);
  irg::fill_ellipse(view, {-1000, 3}, 1001, 2, 2.0);
  CHECK(framed.frame_is_whole());
  CHECK(framed.painted() > 30);
}

}  // namespace
