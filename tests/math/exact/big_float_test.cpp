// SPDX-License-Identifier: MIT
#include <irg/math/exact/big_float.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using number = irg::big_float<3>;
constexpr number of(double x) { return irg::exactly<number>(x); }
constexpr double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();

}  // namespace

TEST_CASE("big floats: sums, differences and products of doubles of all sizes") {
  static_assert(irg::Number<number>);
  CHECK_BOTH((of(most) + of(least) - of(most) - of(least)).sign() == 0);
  CHECK_BOTH((of(most) * of(most) - of(least)).sign() == 1);
  CHECK_BOTH((of(least) * of(least) * of(-least)).sign() == -1);
  CHECK_BOTH(of(0.1) * of(3) == of(0.3) + of(0.1) * of(3) - of(0.3));
  CHECK_BOTH(!(of(0.1) * of(3) == of(0.3)));
  CHECK_BOTH(irg::exactly<number>(std::int64_t{-9223372036854775807}) + of(0x1p63) == of(1));
  CHECK_BOTH(of(most).rounded().exponent == 1023);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("big floats: against rationals") {
  test::random r(7);
  for (int trial = 0; trial < 2000; ++trial) {
    number x = of(1);
    test::big_rational exact(1);
    for (int k = 0; k < 3; ++k) {
      const double a = std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-1000, 1000)));
      const double b = std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-1000, 1000)));
      x = x * (of(a) - of(b));
      exact = exact * (test::big_rational(a) - test::big_rational(b));
    }
    REQUIRE(x.sign() == exact.sign());
    const auto known = x.rounded();
    if (exact.sign() == 0) continue;
    const test::big_rational back =
        (test::big_rational(known.high) + test::big_rational(known.low)).times_power_of_two(known.exponent);
    const test::big_rational off = (back - exact) / exact;
    REQUIRE(off < test::big_rational(0x1p-105));
    REQUIRE(-off < test::big_rational(0x1p-105));
  }
}
#endif
