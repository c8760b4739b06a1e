// SPDX-License-Identifier: MIT
#include <irg/raster/edge_walk.hpp>

#include <cstdlib>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::far_subpixel;
using irg::subpixel;
__extension__ typedef __int128 wide;

constexpr std::int64_t column_in_row(subpixel upper, subpixel lower, std::int64_t row, int steps = 0) {
  auto e = irg::walk_edge(upper, lower, row);
  for (int i = 0; i < steps; ++i) e.next();
  return e.column;
}

// Whether c is the first column whose centre is on or right of the edge: its centre is, that of the column before is
// not.
template <class V>
bool is_first_column(const V& a, const V& b, std::int64_t row, std::int64_t c) {
  const wide dx = wide{b.x} - a.x, dy = wide{b.y} - a.y, y = wide{row} * 256 + 128 - a.y;
  const wide crossing = wide{a.x} * dy + y * dx;  // the edge's x times dy
  return crossing <= (wide{c} * 256 + 128) * dy && crossing > (wide{c - 1} * 256 + 128) * dy;
}

TEST_CASE("walk_edge: an edge by hand") {
  CHECK_BOTH(column_in_row({0, 0}, {0, 1024}, 0) == 0);
  CHECK_BOTH(column_in_row({128, 0}, {128, 1024}, 0) == 0);  // a centre on the edge counts
  CHECK_BOTH(column_in_row({129, 0}, {129, 1024}, 3) == 1);
  CHECK_BOTH(column_in_row({0, 0}, {1024, 1024}, 0) == 0);  // through all centres of the diagonal
  CHECK_BOTH(column_in_row({0, 0}, {1024, 1024}, 0, 3) == 3);
  CHECK_BOTH(column_in_row({1024, 0}, {0, 1024}, 0) == 3);
  CHECK_BOTH(column_in_row({1024, 0}, {0, 1024}, 0, 3) == 0);
  CHECK_BOTH(column_in_row({-1000, -1000}, {-1000, 1000}, 0) == -4);
}

TEST_CASE("rows_of_edge: from the upper end's centre line, with it, to the lower end's, without it") {
  CHECK_BOTH(irg::rows_of_edge(subpixel{0, 128}, subpixel{0, 128 + 512}).first == 0);
  CHECK_BOTH(irg::rows_of_edge(subpixel{0, 128}, subpixel{0, 128 + 512}).last == 2);
  CHECK_BOTH(irg::rows_of_edge(subpixel{0, 129}, subpixel{0, 384}).first == 1);
  CHECK_BOTH(irg::rows_of_edge(subpixel{0, 129}, subpixel{0, 384}).last == 1);
  CHECK_BOTH(irg::rows_of_edge(subpixel{7, 384}, subpixel{9, 384}).first ==
             irg::rows_of_edge(subpixel{7, 384}, subpixel{9, 384}).last);
  constexpr far_subpixel top{0, -irg::far_limit * 256}, bottom{0, irg::far_limit * 256};
  CHECK_BOTH(irg::rows_of_edge(top, bottom).last == irg::far_limit);
}

template <class V>
long wrong_columns(int trials, std::int64_t reach, bool slivers) {
  test::random random(4242);
  long wrong = 0;
  for (int i = 0; i < trials; ++i) {
    const std::int64_t size = slivers ? reach : random.integer(1, reach);
    V a{}, b{};
    const auto place = [&] { return static_cast<decltype(a.x)>(random.integer(-size, size)); };
    a.x = place(), a.y = place(), b.x = place(), b.y = place();
    if (b.y < a.y) {
      const V t = a;
      a = b;
      b = t;
    }
    if (i % 3 == 0)
      b.y = static_cast<decltype(a.x)>(a.y + random.integer(0, 600) < size ? a.y + random.integer(0, 600) : a.y);
    if (b.y < a.y || b.y > size) b.y = a.y;
    const auto rows = irg::rows_of_edge(a, b);
    if (rows.first >= rows.last) continue;
    const std::int64_t row = random.integer(rows.first, rows.last - 1);
    auto e = irg::walk_edge(a, b, row);
    for (std::int64_t y = row; y < rows.last && y < row + 20; ++y, e.next()) {
      wrong += !is_first_column(a, b, y, e.column);
      wrong += e.rest < -e.height || e.rest >= 0;
    }
  }
  return wrong;
}

TEST_CASE("walk_edge: every column is the rational one, near and far") {
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 5000000 : 50000;
  CHECK(wrong_columns<subpixel>(trials, 4096, false) == 0);
  CHECK(wrong_columns<subpixel>(trials, std::int64_t{irg::snap_limit} * 256, false) == 0);
  CHECK(wrong_columns<subpixel>(trials, std::int64_t{irg::snap_limit} * 256, true) == 0);
  CHECK(wrong_columns<far_subpixel>(trials, std::int64_t{irg::snap_limit} * 256, false) == 0);
  CHECK(wrong_columns<far_subpixel>(trials, irg::far_limit * 256, false) == 0);
  CHECK(wrong_columns<far_subpixel>(trials, irg::far_limit * 256, true) == 0);
}

TEST_CASE("walk_edge: the far walk is the near one") {
  test::random random(5);
  for (int i = 0; i < 20000; ++i) {
    constexpr std::int64_t limit = std::int64_t{irg::snap_limit} * 256;
    const auto place = [&] { return static_cast<std::int32_t>(random.integer(-limit, limit)); };
    subpixel a{place(), place()}, b{place(), place()};
    if (b.y < a.y) {
      const subpixel t = a;
      a = b;
      b = t;
    }
    const auto rows = irg::rows_of_edge(a, b);
    if (rows.first >= rows.last) continue;
    const std::int64_t row = random.integer(rows.first, rows.last - 1);
    const auto near = irg::walk_edge(a, b, row);
    const auto far = irg::walk_edge(far_subpixel{a.x, a.y}, far_subpixel{b.x, b.y}, row);
    REQUIRE(near.column == far.column);
    REQUIRE(near.rest == far.rest);
    REQUIRE(near.step == far.step);
    REQUIRE(near.rest_step == far.rest_step);
  }
}

TEST_CASE("walk_edge: slopes of whole columns and of the least fraction") {
  constexpr std::int32_t limit = irg::snap_limit * 256;
  CHECK_BOTH(irg::walk_edge(subpixel{-limit, 0}, subpixel{limit, 256}, 0).step == limit / 128);
  CHECK_BOTH(irg::walk_edge(subpixel{limit, 100}, subpixel{-limit, 129}, 0).column < limit);
  CHECK_BOTH(irg::walk_edge(subpixel{0, -limit}, subpixel{1, limit}, 0).column == 0);
  CHECK_BOTH(irg::walk_edge(subpixel{128, -limit}, subpixel{129, limit}, 0).column == 1);
  CHECK_BOTH(irg::walk_edge(subpixel{1, -limit}, subpixel{0, limit}, 0).step == -1);
}

}  // namespace
