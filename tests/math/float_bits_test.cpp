// SPDX-License-Identifier: MIT
#include <irg/math/float_bits.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "support/check_both.hpp"
#include "support/random.hpp"
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

TEST_CASE("narrowed, rounded_once: as a conversion of numbers in range and of long doubles, infinity beyond") {
  CHECK_BOTH(irg::narrowed<float>(0x1.ffffffp127) == irg::infinity<float>);
  CHECK_BOTH(irg::narrowed<float>(-0x1.fffffefffffffp127) == -std::numeric_limits<float>::max());
  CHECK_BOTH(irg::narrowed<double>(1e300) == 1e300);
  // Half-way between two floats: the rest decides, then the even one.
  CHECK_BOTH(irg::rounded_once<float>(1 + 0x1p-24, 0x1p-80) == 1 + 0x1p-23f);
  CHECK_BOTH(irg::rounded_once<float>(1 + 0x1p-24, -0x1p-80) == 1.0f);
  CHECK_BOTH(irg::rounded_once<float>(1 + 0x1p-24, 0) == 1.0f);
  CHECK_BOTH(irg::rounded_once<float>(-1 - 0x1p-24, -1) == -1 - 0x1p-23f);
  CHECK_BOTH(irg::rounded_once<double>(0.1, 0x1p-80) == 0.1);
  test::random random(20261203);
  int differ = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::ldexp(static_cast<double>(random.next() >> 11), static_cast<int>(random.next() % 320) - 220);
    if (std::abs(x) < 0x1p127) differ += irg::narrowed<float>(x) != static_cast<float>(x);
    // Doubles half-way between floats, and a rest that a long double still holds.
    const double middle = std::ldexp(static_cast<double>(random.next() >> 40 | 1) + 0x1p24, -30);
    const double rest = std::ldexp(static_cast<double>(static_cast<int>(random.next() % 3)) - 1, -66);
    const float once = static_cast<float>(static_cast<long double>(middle) + static_cast<long double>(rest));
    if (std::numeric_limits<long double>::digits >= 64) differ += irg::rounded_once<float>(middle, rest) != once;
  }
  CHECK(differ == 0);
}

TEST_CASE("integer_parts_of: significand times the power of two gives the number back") {
  CHECK_BOTH(irg::integer_parts_of(-1.5f) == irg::integer_parts<float>{0xc00000, 126, true});
  CHECK_BOTH(irg::integer_parts_of(0x1p-149f) == irg::integer_parts<float>{1, 0, false});
  CHECK_BOTH(irg::integer_parts_of(-0.0) == irg::integer_parts<double>{0, 0, true});
  CHECK_BOTH(irg::integer_parts_of(1.0) == irg::integer_parts<double>{std::uint64_t{1} << 52, 1022, false});
  CHECK_BOTH(irg::integer_parts_of(std::numeric_limits<double>::max()).place == 2045);
  test::random random(20261204);
  int differ = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto check = [&](auto x) {
      if (!std::isfinite(x)) return;
      const auto p = irg::integer_parts_of(x);
      const double size = std::ldexp(static_cast<double>(p.significand), p.place + p.least);
      differ += std::signbit(x) != p.negative || size != static_cast<double>(std::abs(x)) || p.place < 0;
    };
    check(irg::from_bits(random.next()));
    check(std::bit_cast<float>(static_cast<std::uint32_t>(random.next())));
  }
  CHECK(differ == 0);
}

TEST_CASE("normalizing_power_of_two: the product is from 1 to below 4, a power of two that no number exceeds") {
  CHECK_BOTH(irg::normalizing_power_of_two(1.0) == 1);
  CHECK_BOTH(irg::normalizing_power_of_two(0x1.8p1000) == 0x1p-1000);
  CHECK_BOTH(irg::normalizing_power_of_two(0x1p-1074) == 0x1p1023);
  test::random random(20261205);
  int wrong = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = irg::from_bits(random.next() >> 1);
    if (!(x >= 0x1p-1022) || !std::isfinite(x)) continue;
    int exponent = 0;
    const double p = irg::normalizing_power_of_two(x);
    wrong += !(p * x >= 1 && p * x < 4) || std::frexp(p, &exponent) != 0.5;
  }
  CHECK(wrong == 0);
}

}  // namespace
