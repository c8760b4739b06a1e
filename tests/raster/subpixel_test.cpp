// SPDX-License-Identifier: MIT
#include <irg/raster/subpixel.hpp>

#include <array>
#include <doctest/doctest.h>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

struct place {
  int x, y;
};
struct wide_place {
  long long x, y;
};
struct place_in_space {
  int x, y, z;
};

// Points of ints in the plane, and they alone.
static_assert(irg::CellPosition<place> && irg::CellPosition<std::array<int, 2>> &&
              irg::CellPosition<irg::point<int, 2>>);
static_assert(!irg::CellPosition<wide_place> && !irg::CellPosition<place_in_space> &&
              !irg::CellPosition<irg::point<float, 2>> && !irg::CellPosition<irg::vec<int, 2>>);
// A cell is one, and a snapped position is none, though both have an x and a y of type int.
static_assert(!irg::CellPosition<irg::cell> && !irg::CellPosition<irg::subpixel>);

static_assert(irg::as_cell(place{-2147483647 - 1, 2147483647}) == irg::cell{-2147483647 - 1, 2147483647});
static_assert(irg::as_cell(irg::cell{3, 4}) == irg::cell{3, 4});

}  // namespace

TEST_CASE("cell_position: ints snap as the cell that they name") {
  for (const int x : {-2147483647 - 1, -irg::snap_limit - 1, -irg::snap_limit, -1, 0, 7, irg::snap_limit - 1,
                      irg::snap_limit, 2147483647}) {
    const irg::cell c{x, 5};
    const place p{x, 5};
    CHECK(irg::can_snap(p) == irg::can_snap(c));
    if (irg::can_snap(c)) CHECK(irg::snap(p) == irg::snap(c));
  }
}

namespace {

TEST_CASE("snap: the nearest multiple of 1/256, the greater on a tie") {
  CHECK_BOTH(irg::snap(1.0) == 256);
  CHECK_BOTH(irg::snap(0.5 / 256) == 1);    // tie upwards
  CHECK_BOTH(irg::snap(-0.5 / 256) == 0);   // tie upwards here too
  CHECK_BOTH(irg::snap(-1.5 / 256) == -1);
  CHECK_BOTH(irg::snap(-0.501f / 256) == -1);
  CHECK_BOTH(irg::snap(irg::point<float, 2>{2.5f, -0.25f}) == irg::subpixel{640, -64});
}

TEST_CASE("snap: just below a tie stays below, where v + 1/2 would round up") {
  CHECK_BOTH(irg::snap(0x1.fffffffffffffp-2 / 256) == 0);
  CHECK_BOTH(irg::snap(0x1.fffffep-2f / 256) == 0);
}

TEST_CASE("snap: the ends of the domain, and what lies outside") {
  CHECK_BOTH(irg::snap(double{irg::snap_limit}) == irg::snap_limit * 256);
  CHECK_BOTH(irg::snap(-double{irg::snap_limit}) == -irg::snap_limit * 256);
  CHECK_BOTH(!irg::can_snap(std::numeric_limits<double>::quiet_NaN()));
  CHECK_BOTH(!irg::can_snap(std::numeric_limits<float>::infinity()));
  CHECK_BOTH(!irg::can_snap(-1e30f));
  CHECK_BOTH(!irg::can_snap(2097152.1));
  CHECK_BOTH(irg::snap(5e-324) == 0);
  CHECK_BOTH(irg::snap(-5e-324) == 0);
}

TEST_CASE("snap: agrees with integer arithmetic on random multiples of 2^-30") {
  test::random random(1);
  for (int i = 0; i < 100000; ++i) {
    const std::int64_t n = random.integer(-(std::int64_t{1} << 50), std::int64_t{1} << 50);  // v = n / 2^30 pixels
    const std::int64_t expected = (n + (std::int64_t{1} << 21)) >> 22;
    REQUIRE(irg::snap(static_cast<double>(n) * 0x1p-30) == expected);
  }
}

TEST_CASE("snap: cells go to their centres, snapped positions stay; can_snap says where the reach ends") {
  using irg::cell, irg::subpixel, irg::snap_limit;
  static_assert(irg::ScreenPosition<cell> && irg::ScreenPosition<subpixel> &&
                irg::ScreenPosition<irg::point<float, 2>>);
  static_assert(!irg::ScreenPosition<irg::point<float, 3>> && !irg::ScreenPosition<irg::point<int, 3>>);
  static_assert(irg::ScreenPosition<irg::point<int, 2>>);  // names a cell
  CHECK_BOTH(irg::snap(cell{3, -2}) == subpixel{3 * 256 + 128, -2 * 256 + 128});
  CHECK_BOTH(irg::snap(subpixel{3, -2}) == subpixel{3, -2});
  CHECK_BOTH(irg::can_snap(cell{snap_limit - 1, -snap_limit}));
  CHECK_BOTH(!irg::can_snap(cell{snap_limit, 0}));
  CHECK_BOTH(!irg::can_snap(cell{0, -snap_limit - 1}));
  CHECK_BOTH(!irg::can_snap(cell{(std::numeric_limits<int>::min)(), (std::numeric_limits<int>::max)()}));
  CHECK_BOTH(irg::can_snap(subpixel{snap_limit * 256, -snap_limit * 256}));
  CHECK_BOTH(!irg::can_snap(subpixel{0, snap_limit * 256 + 1}));
  CHECK_BOTH(!irg::can_snap(subpixel{-snap_limit * 256 - 1, 0}));
  CHECK_BOTH(!irg::can_snap(irg::point<double, 2>{0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST_CASE("screen_vertex: an affine picture unless told otherwise") {
  CHECK_BOTH(irg::screen_vertex{}.position == irg::subpixel{0, 0});
  CHECK_BOTH(irg::screen_vertex{}.depth == 0.0f);
  CHECK_BOTH(irg::screen_vertex{{1, 2}, 0.5f}.inverse_w == 1.0f);
}

}  // namespace
