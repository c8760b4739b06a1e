// SPDX-License-Identifier: MIT
#include <irg/math/float_bits.hpp>

#include <cmath>
#include <random>

#include "support/check_both.hpp"
#include "support/same_bits.hpp"

namespace {

TEST_CASE("float_bits: signs, exponents and bits, of zeros and subnormal numbers, too") {
  CHECK_BOTH(irg::bits_of(1.0) == 0x3ff0000000000000u);
  CHECK_BOTH(irg::from_bits(0x3ff8000000000000u) == 1.5);
  CHECK_BOTH(irg::is_negative(-0.0));
  CHECK_BOTH(!irg::is_negative(0.0f));
  CHECK_BOTH(irg::is_negative(irg::with_sign(0.0, -3.0)));
  CHECK_BOTH(irg::with_sign(-2.0, 5.0) == 2.0);
  CHECK_BOTH(irg::is_nan(irg::not_a_number<float>));
  CHECK_BOTH(!irg::is_nan(irg::infinity<double>));
  CHECK_BOTH(irg::exponent_of(0x1p-1074) == -1074);
  CHECK_BOTH(irg::exponent_of(-0x1.8p1023) == 1023);
  CHECK_BOTH(irg::decompose(-0x1.4p-1060).significand == -1.25);
  CHECK_BOTH(irg::decompose(-0x1.4p-1060).exponent == -1060);
  CHECK_BOTH(irg::exactly_widened(-0x1p-149f) == -0x1p-149);
  CHECK_BOTH(irg::is_zero_or_within<-80, 80>(0.0));
  CHECK_BOTH(irg::is_zero_or_within<-80, 80>(-0x1p-80));
  CHECK_BOTH(!irg::is_zero_or_within<-80, 80>(0x1p80));
  CHECK_BOTH(!irg::is_zero_or_from<-80>(0x1.fffffffffffffp-81));
}

TEST_CASE("times_power_of_two: as ldexp, bit for bit, rounded once where the result is subnormal") {
  CHECK_BOTH(irg::times_power_of_two(0x1.8p0, -1074) == 0x1p-1073);
  CHECK_BOTH(irg::times_power_of_two(-1.0, 5000) == -irg::infinity<double>);
  CHECK_BOTH(irg::power_of_two(-1074) == 0x1p-1074);
  std::mt19937_64 random(20261130);
  int differ = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double x = irg::from_bits(random());
    const int e = static_cast<int>(random() % 4400) - 2200;
    if (!irg::is_nan(x)) differ += !test::same_bits(irg::times_power_of_two(x, e), std::ldexp(x, e));
    if (std::isfinite(x) && x != 0) {
      int exponent = 0;
      const double part = std::frexp(x, &exponent);
      differ += irg::exponent_of(x) != exponent - 1 || irg::decompose(x).significand != 2 * part;
    }
  }
  CHECK(differ == 0);
}

}  // namespace
