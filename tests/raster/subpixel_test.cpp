// SPDX-License-Identifier: MIT
#include <irg/raster/subpixel.hpp>

#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

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

}  // namespace
