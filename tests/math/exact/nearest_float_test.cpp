// SPDX-License-Identifier: MIT
#include <irg/math/exact/nearest_float.hpp>

#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

// The number nearest to y, which is one.
constexpr double found(double y, double guess) {
  return irg::nearest_by_sign(-most, most, guess, [&](double p, double q) {
    const double middle = p / 2 + q / 2;
    return y > middle ? 1 : y < middle ? -1 : 0;
  });
}

}  // namespace

TEST_CASE("ordinal_of, float_at: the numbers in order") {
  CHECK_BOTH(irg::ordinal_of(0.0) == 0);
  CHECK_BOTH(irg::ordinal_of(-0.0) == 0);
  CHECK_BOTH(irg::ordinal_of(least) == 1);
  CHECK_BOTH(irg::ordinal_of(-least) == -1);
  CHECK_BOTH(irg::float_at<double>(-1) == -least);
  CHECK_BOTH(irg::float_at<float>(irg::ordinal_of(1.0f) + 1) == 1 + 0x1p-23f);
  test::random r(9);
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-1060, 1000)));
    REQUIRE(irg::float_at<double>(irg::ordinal_of(x)) == x);
    REQUIRE(irg::float_at<double>(irg::ordinal_of(x) + 1) == std::nextafter(x, most));
  }
}

TEST_CASE("nearest_by_sign: found from any guess") {
  CHECK_BOTH(found(0.75, 0.0) == 0.75);
  CHECK_BOTH(found(-4.0, 1e300) == -4.0);
  CHECK_BOTH(found(0.0, -most) == 0.0);
  // Halfway between two numbers: to the one whose last bit is 0.
  CHECK_BOTH(irg::nearest_by_sign(0.0f, 2.0f, 1.0f, [](float p, float q) {
               const double twice = 2 * (1 + 0x1p-24), sum = static_cast<double>(p) + static_cast<double>(q);
               return twice > sum ? 1 : twice < sum ? -1 : 0;
             }) == 1.0f);
}
