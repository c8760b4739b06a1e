// SPDX-License-Identifier: MIT
#include <irg/fractal/settle_time.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using C = irg::point<double, 2>;

// Newton's step for z^3 - 1: (2 z^3 + 1) / (3 z^2).
constexpr C newton(const C& z) {
  const C square{z.x * z.x - z.y * z.y, 2 * z.x * z.y};
  const C cube{z.x * square.x - z.y * square.y, z.x * square.y + z.y * square.x};
  const double size = 3 * (square.x * square.x + square.y * square.y);
  const C over{2 * cube.x + 1, 2 * cube.y};
  return {(over.x * square.x + over.y * square.y) / size, (over.y * square.x - over.x * square.y) / size};
}

}  // namespace

TEST_CASE("settle_orbit: Newton's steps end at a zero of z^3 - 1, the nearest one for starts beside it") {
  test::random r(2);
  for (int i = 0; i < 2000; ++i) {
    const C z{4 * r.unit() - 2, 4 * r.unit() - 2};
    const auto end = irg::settle_orbit(newton, z, 1e-12, 200);
    REQUIRE(end.count < 200);
    const C cube{end.z.x * end.z.x * end.z.x - 3 * end.z.x * end.z.y * end.z.y,
                 3 * end.z.x * end.z.x * end.z.y - end.z.y * end.z.y * end.z.y};
    CHECK(std::hypot(cube.x - 1, cube.y) < 1e-12);
    const C beside{-0.5 + 0.2 * (r.unit() - 0.5), std::sqrt(0.75) + 0.2 * (r.unit() - 0.5)};
    CHECK(std::hypot(irg::settle_orbit(newton, beside, 1e-12, 200).z.x + 0.5, 0) < 1e-12);
  }
}

TEST_CASE("settle_orbit: rest at once, never, at the last step, NaN") {
  constexpr auto stays = [](const C& z) { return z; };
  constexpr auto wanders = [](const C& z) { return C{z.x + 1, z.y}; };
  constexpr auto halves = [](const C& z) { return C{z.x / 2, z.y / 2}; };
  CHECK_BOTH(irg::settle_orbit(stays, C{3, 4}, 0.0, 9) == irg::escape_end<double>{0, {3, 4}});
  CHECK_BOTH(irg::settle_orbit(wanders, C{0, 0}, 0.5, 9) == irg::escape_end<double>{9, {9, 0}});
  CHECK_BOTH(irg::settle_orbit(wanders, C{0, 0}, 1.0, 9) == irg::escape_end<double>{0, {1, 0}});
  CHECK_BOTH(irg::settle_orbit(halves, C{8, 0}, 1.0, 9) == irg::escape_end<double>{2, {1, 0}});  // 4, 2, 1
  CHECK_BOTH(irg::settle_orbit(stays, C{3, 4}, 1.0, 0) == irg::escape_end<double>{0, {3, 4}});
  CHECK_BOTH(irg::settle_orbit(stays, C{3, 4}, 1.0, -5).count == 0);
  CHECK_BOTH(irg::settle_orbit(newton, C{1, 0}, 0.0, 9).count == 0);
  CHECK_BOTH(irg::settle_orbit(stays, C{3, 4}, -1.0, 9).count == 9);
  CHECK_BOTH(irg::settle_orbit(stays, C{3, 4}, std::numeric_limits<double>::quiet_NaN(), 9).count == 9);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(irg::settle_orbit(halves, C{nan, 0}, 1.0, 9).count == 9);
  CHECK(irg::settle_orbit(newton, C{0, 0}, 1e-12, 9).count == 9);  // a division by 0
}
