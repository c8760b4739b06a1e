// SPDX-License-Identifier: MIT
#include <irg/core/is_finite.hpp>

#include <array>
#include <limits>
#include <vector>

#include "support/check_both.hpp"
#include "support/rational.hpp"

namespace {

struct place {
  float x, y;
};
struct flat {
  double a, b, c, d;
};
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("is_finite: numbers of every type") {
  CHECK_BOTH(irg::is_finite(0.0));
  CHECK_BOTH(irg::is_finite(std::numeric_limits<double>::max()));
  CHECK_BOTH(irg::is_finite(-std::numeric_limits<float>::denorm_min()));
  CHECK_BOTH(irg::is_finite(7));
  CHECK_BOTH(irg::is_finite(test::rational(1, 3)));
  CHECK_BOTH(!irg::is_finite(nan));
  CHECK_BOTH(!irg::is_finite(-infinite));
  CHECK_BOTH(!irg::is_finite(std::numeric_limits<float>::infinity()));
}

TEST_CASE("is_finite: points, planes, rings, several") {
  CHECK_BOTH(irg::is_finite(place{1, 2}));
  CHECK_BOTH(!irg::is_finite(std::array{0.0, 0.0, nan}));
  CHECK_BOTH(irg::is_finite(flat{1, 2, 3, 4}));
  CHECK_BOTH(!irg::is_finite(flat{1, 2, 3, infinite}));
  CHECK_BOTH(irg::is_finite(std::array<place, 3>{}));
  CHECK_BOTH(!irg::is_finite(std::array{std::array{0.0, 0.0}, std::array{0.0, -infinite}}));
  CHECK(irg::is_finite(std::vector<place>{}));
  CHECK_BOTH(irg::is_finite(1.0, place{1, 2}, flat{1, 2, 3, 4}));
  CHECK_BOTH(!irg::is_finite(1.0, place{1, 2}, nan));
  CHECK_BOTH(!irg::is_finite(nan, 1.0));
}
