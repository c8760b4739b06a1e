// SPDX-License-Identifier: MIT
#include <irg/math/error_free.hpp>

#include <cmath>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

namespace {

using test::same;
constexpr double largest = std::numeric_limits<double>::max();

/// A double of full significand and a random exponent.
double random_double(test::random& r, int lowest, int highest) {
  const double significand = static_cast<double>((r.next() >> 11) | (std::uint64_t{1} << 52)) * 0x1p-52;
  return test::either_sign(r, std::ldexp(significand, static_cast<int>(r.integer(lowest, highest))));
}

}  // namespace

static_assert(noexcept(irg::two_sum(1.0, 2.0)) && noexcept(irg::difference_of_products(1.0f, 1.0f, 1.0f, 1.0f)));
static_assert(std::is_aggregate_v<irg::exact_sum<double>>);

TEST_CASE("sums by hand") {
  CHECK_BOTH(irg::two_sum(1.0, 0x1p-60) == irg::exact_sum<double>{1.0, 0x1p-60});
  CHECK_BOTH(irg::two_sum(0x1p-60, 1.0) == irg::exact_sum<double>{1.0, 0x1p-60});
  CHECK_BOTH(irg::two_sum(1.0f, 0x1.8p-24f) == irg::exact_sum<float>{1.0f + 0x1p-23f, -0x1p-25f});
  CHECK_BOTH(irg::fast_two_sum(1.0, -0x1p-60) == irg::exact_sum<double>{1.0, -0x1p-60});
  CHECK_BOTH(irg::two_sum(0x1p-1074, 0x1p-1074) == irg::exact_sum<double>{0x1p-1073, 0.0});
}

TEST_CASE("split and product by hand") {
  CHECK_BOTH(irg::split(1 + 0x1p-52) == irg::split_number<double>{1, 0x1p-52});
  CHECK_BOTH(irg::split(1 + 0x1p-23f) == irg::split_number<float>{1, 0x1p-23f});
  CHECK_BOTH(irg::fast_two_product(1 + 0x1p-30, 1 + 0x1p-30) == irg::exact_sum<double>{1 + 0x1p-29, 0x1p-60});
  CHECK_BOTH(irg::two_product(1 + 0x1p-20f, 1 + 0x1p-20f) == irg::exact_sum<float>{1 + 0x1p-19f, 0x1p-40f});
}

TEST_CASE("products at the ends of the range") {
  CHECK_BOTH(irg::two_product(0.0, -3.0) == irg::exact_sum<double>{-0.0, 0.0});
  CHECK_BOTH(irg::two_product(largest, 1.0) == irg::exact_sum<double>{largest, 0.0});
  CHECK_BOTH(irg::two_product(largest, 0x1.8p-1) == irg::exact_sum<double>{0x1.7ffffffffffffp1023, 0x1p969});
  CHECK_BOTH(irg::two_product(0x1p-1074, 0x1p1000) == irg::exact_sum<double>{0x1p-74, 0.0});
  CHECK_BOTH(irg::two_product(0x1p-600, 0x1p-600) == irg::exact_sum<double>{0.0, 0.0});
  const irg::exact_sum<double> overflowed = irg::two_product(test::at_run_time(1e200), 1e200);
  CHECK(std::isinf(overflowed.value));
  CHECK(overflowed.error == 0);
}

TEST_CASE("the sum's parts add up to the exact sum, seen in integers") {
  test::random r(1);
  for (int i = 0; i < 200000; ++i) {
    // 53-bit integers at most 60 places apart: their sum fits 128 bits.
    const auto a = static_cast<std::int64_t>(r.next() >> 11), b = static_cast<std::int64_t>(r.next() >> 11);
    const int shift = static_cast<int>(r.integer(0, 60));
    const double x = static_cast<double>(a), y = -std::ldexp(static_cast<double>(b), shift);
    const irg::exact_sum<double> sum = irg::two_sum(x, y);
    __extension__ using wide = __int128;
    const wide exact = static_cast<wide>(a) - (static_cast<wide>(b) << shift);
    CHECK((static_cast<wide>(sum.value) + static_cast<wide>(sum.error) == exact));
    CHECK(same(sum.value, x + y));
    CHECK((std::fabs(x) < std::fabs(y) ? irg::fast_two_sum(y, x) : irg::fast_two_sum(x, y)) == sum);
  }
}

TEST_CASE("the product's parts add up to the exact product, seen in integers") {
  test::random r(2);
  for (int i = 0; i < 200000; ++i) {
    const auto a = static_cast<std::int64_t>(r.next() >> 11), b = static_cast<std::int64_t>(r.next() >> 11);
    const irg::exact_sum<double> p = irg::two_product(static_cast<double>(a), static_cast<double>(b));
    __extension__ using wide = __int128;
    CHECK((static_cast<wide>(p.value) + static_cast<wide>(p.error) == static_cast<wide>(a) * static_cast<wide>(b)));
    CHECK(p == irg::fast_two_product(static_cast<double>(a), static_cast<double>(b)));
    const auto full = static_cast<double>(a | (std::int64_t{1} << 52));  // of exactly 53 bits
    const irg::split_number<double> s = irg::split(full);
    CHECK(s.high + s.low == full);
    CHECK(std::fmod(s.high, 0x1p27) == 0);
    CHECK(std::fabs(s.low) <= 0x1p26);
  }
}

TEST_CASE("two_product is the fused multiply-add's answer over the whole range") {
  test::random r(3);
  for (int i = 0; i < 200000; ++i) {
    const double a = test::any_double(r), b = i % 2 == 0 ? test::any_double(r) : random_double(r, -1022, 1023);
    const irg::exact_sum<double> p = irg::two_product(a, b);
    CHECK(same(p.value, a * b));
    CHECK(p.error == (std::isfinite(a * b) ? std::fma(a, b, -(a * b)) : 0.0));
  }
}

TEST_CASE("products and their differences beyond the range, in constant evaluation, too") {
  constexpr double inf = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  constexpr float single = std::numeric_limits<float>::infinity(), no_single = std::numeric_limits<float>::quiet_NaN();
  CHECK_BOTH(irg::two_product(largest, -2.0) == irg::exact_sum<double>{-inf, 0.0});
  CHECK_BOTH(irg::two_product(largest, 1 - 0x1p-53) == irg::exact_sum<double>{0x1.ffffffffffffep1023, 0x1p918});
  CHECK_BOTH(irg::two_product(inf, -0x1p-1074) == irg::exact_sum<double>{-inf, 0.0});
  CHECK_BOTH(irg::two_product(single, single) == irg::exact_sum<float>{single, 0.0f});
  CHECK_BOTH((irg::two_product(inf, 0.0).value != irg::two_product(inf, 0.0).value));
  CHECK_BOTH(irg::difference_of_products(largest, 2.0, largest, 1.0) == largest);
  CHECK_BOTH(irg::difference_of_products(largest, 2.0, -largest, 1.0) == inf);
  CHECK_BOTH(irg::difference_of_products(1.0, 2.0, inf, 3.0) == -inf);
  CHECK_BOTH(irg::difference_of_products(inf, -2.0, largest, largest) == -inf);
  CHECK_BOTH(irg::sum_of_products(1.0f, 2.0f, single, -3.0f) == -single);
  constexpr auto is_none = [](auto x) { return x != x; };
  CHECK_BOTH(is_none(irg::difference_of_products(inf, 1.0, inf, 2.0)));
  CHECK_BOTH(is_none(irg::difference_of_products(1.0, none, 1.0, 2.0)));
  CHECK_BOTH(is_none(irg::difference_of_products(1.0f, 2.0f, single, 0.0f)));
  CHECK_BOTH(is_none(irg::difference_of_products(no_single, 0.0f, 1.0f, 1.0f)));
}

TEST_CASE("difference of products: by hand and degenerate") {
  CHECK_BOTH(irg::difference_of_products(3.0, 4.0, 2.0, 5.0) == 2);
  CHECK_BOTH(irg::difference_of_products(1 + 0x1p-30, 1 + 0x1p-30, 1 + 0x1p-29, 1.0) == 0x1p-60);
  CHECK_BOTH(irg::difference_of_products(1 + 0x1p-20f, 1 + 0x1p-20f, 1 + 0x1p-19f, 1.0f) == 0x1p-40f);
  CHECK_BOTH(irg::sum_of_products(1 + 0x1p-30, 1 - 0x1p-30, -1.0, 1.0) == -0x1p-60);
  CHECK_BOTH(irg::difference_of_products(0.1, 0.3, 0.3, 0.1) == 0);
  CHECK_BOTH(irg::difference_of_products(1e300, 1e300, 1e300, 1e300) == 0);
  CHECK_BOTH(irg::difference_of_products(largest, 2.0, 0x1.ffffffffffffep1023, 2.0) == 0x1p972);
  CHECK_BOTH(irg::difference_of_products(largest, 0x1p-600, 1.0, 1.0) == largest * 0x1p-600);
  const double infinite = irg::difference_of_products(test::at_run_time(1e300), 1e300, 1.0, 1.0);
  CHECK(std::isinf(infinite));
  CHECK(std::isnan(irg::difference_of_products(test::at_run_time(std::nan("")), 1.0, 1.0, 1.0)));
}

/// Integers with a*b - c*d == 1, where all rounded parts of the products cancel but the last bit.
struct neighbours {
  std::int64_t a, b, c, d;
};
constexpr neighbours neighbours_of(std::int64_t a, std::int64_t c) {
  // Euclid's algorithm; x * a + y * c is the remainder throughout.
  std::int64_t remainder = a, next = c, x = 1, next_x = 0, y = 0, next_y = 1;
  while (next != 0) {
    const std::int64_t q = remainder / next;
    const neighbours step{next, remainder - q * next, next_x, next_y};
    next_x = x - q * next_x, next_y = y - q * next_y;
    remainder = step.a, next = step.b, x = step.c, y = step.d;
  }
  return remainder == 1 ? neighbours{a, x, c, -y} : neighbours{1, 1, 0, 0};
}

TEST_CASE("difference of products: one, between products of 106 bits") {
  constexpr neighbours fixed = neighbours_of(9007199254740881, 6369051672525773);
  static_assert(fixed.c != 0);
  CHECK_BOTH(irg::difference_of_products(static_cast<double>(fixed.a), static_cast<double>(fixed.b),
                                         static_cast<double>(fixed.c), static_cast<double>(fixed.d)) == 1);
  test::random r(5);
  for (int i = 0; i < 20000; ++i) {
    const auto full = [&] { return static_cast<std::int64_t>((r.next() >> 11) | (std::uint64_t{1} << 52)); };
    const std::int64_t first = full(), second = full();
    const neighbours n = neighbours_of(first, second);
    CHECK(irg::difference_of_products(static_cast<double>(n.a), static_cast<double>(n.b), static_cast<double>(n.c),
                                      static_cast<double>(n.d)) == 1);
  }
}

TEST_CASE("constant evaluation and run time give the same bits") {
  constexpr auto p = irg::two_product(0.1, 1e-300);
  CHECK(p == irg::two_product(test::at_run_time(0.1), test::at_run_time(1e-300)));
  constexpr auto q = irg::two_product(0x1.fffffffffffffp1000, 0x1.23456789abcdfp20);
  CHECK(q == irg::two_product(test::at_run_time(0x1.fffffffffffffp1000), test::at_run_time(0x1.23456789abcdfp20)));
  constexpr double d = irg::difference_of_products(0.1, 0.2, 0.30000000000000004, 0.06666666666666667);
  CHECK(same(d, irg::difference_of_products(test::at_run_time(0.1), 0.2, 0.30000000000000004, 0.06666666666666667)));
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("difference of products: within 0.51 ulp, cancellation included") {
  test::random r(4);
  test::real left, right;
  mpfr_set_prec(left, 3000);
  mpfr_set_prec(right, 3000);
  double worst = 0, worst_single = 0;
  const int count = test::count_of(60000);
  for (int i = 0; i < count; ++i) {
    // The second product equals the first but for a change of the last bits of one factor.
    const int range = i % 3 == 0 ? 450 : 20;
    const double a = random_double(r, -range, range), b = random_double(r, -range, range);
    const double c = std::nextafter(b, static_cast<double>(r.integer(-1, 1)) * 1e300);
    double d = a;
    for (std::int64_t steps = r.integer(0, 3); steps > 0; --steps) d = std::nextafter(d, 1e300);
    const double e = i % 4 == 0 ? random_double(r, -range, range) : d;
    mpfr_set_d(left, a, MPFR_RNDN);
    mpfr_mul_d(left, left, b, MPFR_RNDN);
    mpfr_set_d(right, c, MPFR_RNDN);
    mpfr_mul_d(right, right, e, MPFR_RNDN);
    mpfr_sub(left, left, right, MPFR_RNDN);
    const double got = irg::difference_of_products(a, b, c, e);
    if (mpfr_zero_p(left)) {
      CHECK(got == 0);
      continue;
    }
    worst = std::fmax(worst, test::ulp_error(got, left));
    CHECK(same(got, irg::sum_of_products(a, b, -c, e)));

    const auto fa = static_cast<float>(std::ldexp(a, -std::ilogb(a))),
               fb = static_cast<float>(std::ldexp(b, -std::ilogb(b)));
    const float fc = std::nextafter(fb, 4.0f), fd = std::nextafter(fa, 0.0f);
    mpfr_set_d(left, static_cast<double>(fa) * static_cast<double>(fb), MPFR_RNDN);
    mpfr_sub_d(left, left, static_cast<double>(fc) * static_cast<double>(fd), MPFR_RNDN);
    worst_single = std::fmax(worst_single, test::ulp_error(irg::difference_of_products(fa, fb, fc, fd), left));
  }
  MESSAGE("difference_of_products: ", worst, " ulp in double, ", worst_single, " ulp in float");
  CHECK(worst <= 0.51);
  CHECK(worst_single <= 0.5001);
}

TEST_CASE("difference of products: both ends of the range") {
  test::random r(6);
  test::real left, right;
  mpfr_set_prec(left, 5000);
  mpfr_set_prec(right, 5000);
  double worst_large = 0, worst_small = 0;
  for (int i = 0; i < test::count_of(20000); ++i) {
    // Products between 2^1000 and 2^1100 that may cancel, and products below 2^-900.
    const bool is_large = i % 2 == 0;
    const int first = static_cast<int>(r.integer(is_large ? 500 : -900, is_large ? 1000 : -100));
    const int sum = static_cast<int>(r.integer(is_large ? 1000 : -1080, is_large ? 1100 : -950));
    const double a = random_double(r, first, first), b = random_double(r, sum - first, sum - first);
    const double c = i % 3 == 0 ? std::nextafter(a, 0.0) : random_double(r, first, first), d = i % 5 == 0 ? b : -b;
    mpfr_set_d(left, a, MPFR_RNDN);
    mpfr_mul_d(left, left, b, MPFR_RNDN);
    mpfr_set_d(right, c, MPFR_RNDN);
    mpfr_mul_d(right, right, d, MPFR_RNDN);
    mpfr_sub(left, left, right, MPFR_RNDN);
    const double got = irg::difference_of_products(a, b, c, d);
    CHECK(!std::isnan(got));
    if (is_large) {
      worst_large = std::fmax(worst_large, test::ulp_error(got, left));
    } else {
      // In units of the smallest double, beyond one unit in the last place of the result.
      const double last_place = std::fmax(std::nextafter(std::fabs(got), 1.0) - std::fabs(got), 0x1p-1074);
      mpfr_sub_d(left, left, got, MPFR_RNDN);
      mpfr_abs(left, left, MPFR_RNDN);
      mpfr_sub_d(left, left, last_place, MPFR_RNDN);
      worst_small = std::fmax(worst_small, std::ldexp(mpfr_get_d(left, MPFR_RNDU), 1000) * 0x1p74);
    }
  }
  MESSAGE("difference_of_products: ", worst_large, " ulp of large products; ", worst_small,
          " smallest doubles beyond one ulp of small ones");
  CHECK(worst_large <= 0.51);
  CHECK(worst_small <= 2);
}

namespace {
namespace sweeps {

using namespace test::mixed;

// What difference_of_products gives: 1e9 where it is no number, else its error in ulp, less what underflow may add.
template <class T>
double error_of_difference(T a, T b, T c, T d) {
  const big_rational left = rational(a) * rational(b), right = rational(c) * rational(d), want = left - right;
  const T got = irg::difference_of_products(a, b, c, d);
  if (want.sign() == 0) return got == 0 ? 0 : 1e9;
  const big_rational least(0x1p-900);
  const bool is_small = sizeof(T) == 8 && abs(left) < least && abs(right) < least;
  if (is_small && std::isfinite(got) && !(big_rational(0x1p-1073) < abs(rational(got) - want))) return 0;
  return test::error_in_ulp(got, want);
}

TEST_CASE_TEMPLATE("errors of sums and products: numbers of all sizes", T, double, float) {
  const auto missing = [](T value, T error, const big_rational& want) {
    return rational(value) + rational(error) == want && value == test::nearest<T>(want) ? 0.0 : 1.0;
  };
  sweep("two_sum", 0, [&](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, all_sizes[r.integer(0, 3)]);
    const auto sum = irg::two_sum(a, b),
               fast = std::fabs(a) < std::fabs(b) ? irg::fast_two_sum(b, a) : irg::fast_two_sum(a, b);
    const big_rational want = rational(a) + rational(b);
    return missing(sum.value, sum.error, want) + missing(fast.value, fast.error, want);
  });
  sweep("two_product", 0, [&](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, all_sizes[r.integer(0, 3)]);
    const auto got = irg::two_product(a, b);
    const big_rational want = rational(a) * rational(b);
    if (!std::isfinite(got.value)) return got.error == 0 && got.value == test::nearest<T>(want) ? 0.0 : 1.0;
    return got.value == test::nearest<T>(want) && got.error == test::nearest<T>(want - rational(got.value)) ? 0.0 : 1.0;
  });
  sweep("split", 0, [&](test::random& r, sizes which) {
    const T x = number<T>(r, which);
    if (std::fabs(x) > (sizeof(T) == 8 ? T(0x1p995) : T(0x1p114))) return 0.0;
    const auto [high, low] = irg::split(x);
    return missing(high, low, rational(x)) == 0 || rational(high) + rational(low) == rational(x) ? 0.0 : 1.0;
  });
  sweep("difference_of_products", 1, [&](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, all_sizes[r.integer(0, 3)]);
    if (r.integer(0, 2) > 0) return error_of_difference(a, b, number<T>(r, which), number<T>(r, which));
    const T factor = std::ldexp(T(1), static_cast<int>(r.integer(-20, 0)));  // nearly the same product
    return std::fabs(a) < 1 ? error_of_difference(a, b, std::nextafter(a, T(0)) / factor, b * factor)
                            : error_of_difference(a, b, std::nextafter(a, T(0)) * factor, b);
  });
}

}  // namespace sweeps
}  // namespace

#endif
