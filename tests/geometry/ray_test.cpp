// SPDX-License-Identifier: MIT
#include <irg/geometry/ray.hpp>

#include <limits>

#include "support/check_both.hpp"

namespace {

using R = irg::ray<double, 3>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

TEST_CASE("ray: points, ends, and rays that are none") {
  constexpr R r{{1, 2, 3}, {0, 0, 2}};
  CHECK_BOTH(irg::point_at(r, 0.5) == irg::point<double, 3>{1, 2, 4});
  CHECK_BOTH(irg::ray_between(irg::point<double, 2>{1, 2}, irg::point<double, 2>{4, 6}) ==
             irg::ray<double, 2>{{1, 2}, {3, 4}, 0, 1});
  CHECK_BOTH(!r.empty());
  CHECK_BOTH(!R{{}, {0, 5e-324, 0}, 0, 0}.empty());
  CHECK_BOTH(R{{}, {0, -0.0, 0}}.empty());
  CHECK_BOTH(R{{}, {0, nan, 1}}.empty());
  CHECK_BOTH(R{{}, {infinite, 0, 1}}.empty());
  CHECK_BOTH(R{{0, infinite, 0}, {0, 0, 1}}.empty());
  CHECK_BOTH(R{{}, {0, 0, 1}, 2, 1}.empty());
  CHECK_BOTH(R{{}, {0, 0, 1}, -2, -1}.empty());
  CHECK_BOTH(R{{}, {0, 0, 1}, 0, nan}.empty());
  CHECK_BOTH(R{{}, {0, 0, 1}, infinite, infinite}.empty());
}

}  // namespace
