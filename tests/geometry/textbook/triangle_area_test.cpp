// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/triangle_area.hpp>

#include <limits>

#include "support/check_both.hpp"

using irg::textbook::triangle_area_from_sides;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("textbook::triangle_area_from_sides: by hand") {
  CHECK_BOTH(triangle_area_from_sides(4.0, 5.0, 3.0) == 6.0);
  CHECK_BOTH(triangle_area_from_sides(5.0f, 3.0f, 4.0f) == 6.0f);
  CHECK_BOTH(triangle_area_from_sides(1.0, 2.0, 3.0) == 0.0);
  CHECK_BOTH(!triangle_area_from_sides(1.0, 2.0, 4.0));
  CHECK(!triangle_area_from_sides(inf, 1.0, 1.0));
}

TEST_CASE("textbook::triangle_area_from_sides: a needle loses its digits, triangle_area_from_sides does not") {
  constexpr double e = 0x1p-52;
  CHECK_BOTH(triangle_area_from_sides(1.0, 1.0, e) == 0.0);
  CHECK_BOTH(*irg::triangle_area_from_sides(1.0, 1.0, e) > 0x1p-54);
}
