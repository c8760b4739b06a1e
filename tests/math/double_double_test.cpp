// SPDX-License-Identifier: MIT
#include <irg/math/double_double.hpp>

#include <irg/math/inverse.hpp>
#include <irg/math/mat.hpp>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

using dd = double_double;
using ff = double_word<float>;
constexpr double largest = std::numeric_limits<double>::max();
constexpr double inf = std::numeric_limits<double>::infinity();

constexpr dd third = dd(1) / 3.0;

/// A double_word of full precision whose exponent is uniform in [low, high].
template <class T>
double_word<T> any_words(test::random& r, int low, int high) {
  const double head = test::either_sign(r, test::of_exponent(r, low, high));
  const T rounded = static_cast<T>(head);
  const auto [sum, rest] = two_sum(rounded, static_cast<T>(test::between(r, -1, 1) * static_cast<double>(rounded) *
                                                           (sizeof(T) == 8 ? 0x1p-54 : 0x1p-25)));
  return {sum, rest};
}

}  // namespace

static_assert(Scalar<dd> && Real<dd> && Real<ff> && !Floating<dd>);
static_assert(noexcept(dd(1) * dd(2)) && sizeof(dd) == 16);

TEST_CASE("double_double: by hand") {
  CHECK_BOTH(dd(1) + 0x1p-80 == dd(1, 0x1p-80));
  CHECK_BOTH(dd(1, 0x1p-80) - 1.0 == dd(0x1p-80));
  CHECK_BOTH(dd(1 + 0x1p-40) * dd(1 - 0x1p-40) == dd(1, -0x1p-80));
  CHECK_BOTH(third == dd(1.0 / 3, 0x1.5555555555555p-56));
  CHECK_BOTH(abs(third * 3 - 1) <= dd(0x1p-104));
  CHECK_BOTH(sqrt(dd(2)).high == 0x1.6a09e667f3bcdp+0);
  CHECK_BOTH(abs(sqrt(dd(2)) - dd(0x1.6a09e667f3bcdp+0, -0x1.bdd3413b26456p-54)) < dd(0x1p-104));
  CHECK_BOTH(sqrt(dd(0.0)) == dd(0));
  CHECK_BOTH(static_cast<double>(dd(1, 0x1p-60)) == 1);
  CHECK_BOTH(dd(1) < dd(1, 0x1p-80));
  CHECK_BOTH(dd(1, -0x1p-80) < dd(1));
  CHECK_BOTH(!(dd(1) < dd(1)));
  CHECK_BOTH(dd(1) <= dd(1));
  CHECK_BOTH(-dd(1, 0x1p-80) == dd(-1, -0x1p-80));
  CHECK_BOTH(ff(1) + 0x1p-40f == ff(1, 0x1p-40f));
}

TEST_CASE("double_double: integers are exact") {
  CHECK_BOTH(dd(std::int64_t{9223372036854775807}) == dd(0x1p63, -1));
  CHECK_BOTH(dd(std::uint64_t{18446744073709551615u}) == dd(0x1p64, -1));
  CHECK_BOTH(dd(-9007199254740993) == dd(-9007199254740992.0, -1));
  CHECK_BOTH(dd(std::numeric_limits<std::int64_t>::min()) == dd(-0x1p63));
  CHECK_BOTH(ff(2147483647) == ff(0x1p31f, -1));
  CHECK_BOTH(ff(16777217) == ff(16777216.0f, 1.0f));
  CHECK_BOTH(dd(short{-3}) == dd(-3.0));
  CHECK_BOTH(dd(7u) == dd(7.0));
}

TEST_CASE("double_double: ends of the range") {
  CHECK_BOTH(dd(largest) * 1.0 == dd(largest));
  CHECK_BOTH(dd(largest, 0x1p969) / 4.0 == dd(largest / 4, 0x1p967));
  CHECK_BOTH(dd(0x1p-1074) + dd(0x1p-1074) == dd(0x1p-1073));
  CHECK_BOTH(dd(0x1p-1074) * dd(0x1p1000, 0x1p940) == dd(0x1p-74, 0x1p-134));
  // What is left of a division, and of a root, is known also where the products in it would lose bits or overflow.
  CHECK_BOTH(dd(0x1p-1000) / dd(0x3p-500) == dd(0x1.5555555555555p-502, 0x1.5555555555555p-556));
  CHECK_BOTH(dd(largest) / dd(3) == dd(0x1.5555555555555p1022, -0x1.5555555555555p968));
  CHECK_BOTH(dd(0x3p-1074) / dd(0x1p-1074) == dd(3));
  CHECK_BOTH(sqrt(dd(0x1p-999)) * 0x1p500 == sqrt(dd(2)));
  CHECK_BOTH(ff(0x1p-100f) / ff(0x3p-50f) == ff(0x1.555556p-52f, -0x1.555556p-77f));
  CHECK_BOTH(sqrt(ff(0x1p-140f)) == ff(0x1p-70f));
  const dd overflowed = dd(test::at_run_time(largest)) * 2.0;
  CHECK(overflowed == dd(inf));
  CHECK(overflowed.low == 0);
  CHECK(dd(test::at_run_time(largest)) + dd(largest) == dd(inf));
  CHECK(dd(test::at_run_time(largest), 0x1p969) + 0x1p969 == dd(inf));  // only the sum of all words overflows
  CHECK(dd(1) / dd(test::at_run_time(0.0)) == dd(inf));
  CHECK(dd(1) / overflowed == dd(0));
  CHECK(sqrt(overflowed) == dd(inf));
  const dd none = sqrt(dd(test::at_run_time(-1.0)));
  CHECK(!(none == none));
  CHECK(!(none < dd(1)));
}

TEST_CASE("double_double: determinants of 106 bits") {
  // Two rows that differ in the 60th bit of one entry.
  constexpr dd almost(1, 0x1p-60);
  CHECK_BOTH(determinant(mat<dd, 2, 2>{{{dd(1), dd(1)}, {dd(1), almost}}}) == dd(0x1p-60));
  // Hilbert's matrix of size 4: the determinant is 1/6048000.
  constexpr auto hilbert = [] {
    mat<dd, 4, 4> h;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) h(i, j) = dd(1) / dd(i + j + 1);
    return h;
  }();
  constexpr dd d = determinant(hilbert);
  CHECK_BOTH(d.high == 1.0 / 6048000);
  CHECK(inverse(hilbert).has_value());
  CHECK_BOTH(dot(vec<dd, 2>{almost, dd(1)}, vec<dd, 2>{dd(1), dd(-1)}) == dd(0x1p-60));
}

#ifdef IRG_HAVE_MPFR
namespace {

template <class T>
void set(mpfr_ptr out, const double_word<T>& x) {
  mpfr_set_d(out, static_cast<double>(x.high), MPFR_RNDN);
  mpfr_add_d(out, out, static_cast<double>(x.low), MPFR_RNDN);
}

/// The relative error in units of u^2.
template <class T>
double error_of(const double_word<T>& got, mpfr_ptr exact) {
  test::real difference;
  set(difference, got);
  mpfr_sub(difference, difference, exact, MPFR_RNDN);
  mpfr_div(difference, difference, exact, MPFR_RNDN);
  mpfr_mul_2si(difference, difference, 2 * std::numeric_limits<T>::digits, MPFR_RNDN);
  return std::fabs(mpfr_get_d(difference, MPFR_RNDN));
}

template <class T>
struct worst_errors {
  double sum = 0, difference = 0, product = 0, quotient = 0, root = 0, by_one = 0;
};

template <class T>
worst_errors<T> measure(int count, int range) {
  worst_errors<T> worst;
  test::random r(1);
  test::real a, b, exact;
  const auto note = [&](double& place, const double_word<T>& got) {
    CHECK(got.high == got.high + got.low);  // the words are apart
    place = std::max(place, error_of(got, exact));
  };
  for (int i = 0; i < count; ++i) {
    const double_word<T> x = any_words<T>(r, -range, range);
    // Every other time near x, so that sums cancel.
    const double_word<T> near = x * (T(1) + static_cast<T>(std::ldexp(r.unit(), static_cast<int>(r.integer(-60, 0)))));
    const double_word<T> y = i % 2 == 0 ? near : any_words<T>(r, -range, range);
    set<T>(a, x), set<T>(b, y);
    mpfr_add(exact, a, b, MPFR_RNDN), note(worst.sum, x + y);
    mpfr_sub(exact, a, b, MPFR_RNDN);
    if (!mpfr_zero_p(exact)) note(worst.difference, x - y);
    mpfr_mul(exact, a, b, MPFR_RNDN), note(worst.product, x * y);
    mpfr_div(exact, a, b, MPFR_RNDN), note(worst.quotient, x / y);
    mpfr_abs(exact, a, MPFR_RNDN), mpfr_sqrt(exact, exact, MPFR_RNDN), note(worst.root, sqrt(abs(x)));
    mpfr_mul_d(exact, a, static_cast<double>(y.high), MPFR_RNDN), note(worst.by_one, x * y.high);
    mpfr_add_d(exact, a, static_cast<double>(y.high), MPFR_RNDN), note(worst.by_one, x + y.high);
  }
  return worst;
}

template <class T>
void check(const worst_errors<T>& worst) {
  CHECK(worst.sum <= 3.001);
  CHECK(worst.difference <= 3.001);
  CHECK(worst.product <= 5);
  CHECK(worst.quotient <= 15.001);
  CHECK(worst.root <= 25.0 / 8);
  CHECK(worst.by_one <= 3);
  MESSAGE("sum ", worst.sum, " u^2, difference ", worst.difference, ", product ", worst.product, ", quotient ",
          worst.quotient, ", root ", worst.root, ", with one word ", worst.by_one);
}

}  // namespace

TEST_CASE("double_double: errors against MPFR") {
  check(measure<double>(test::count_of(20000), 200));
  check(measure<float>(test::count_of(20000), 20));
}

namespace {
namespace sweeps {

using namespace test::mixed;
using test::mixed::rational;

// A number in two words; the second is of any size that goes with the first one.
template <class T>
irg::double_word<T> two_words(test::random& r, sizes which) {
  const T high = number<T>(r, which);
  const T half_place = (std::nextafter(std::fabs(high), T(HUGE_VAL)) - std::fabs(high)) / 2;
  const int down = r.integer(0, 1) == 0 ? 0 : static_cast<int>(r.integer(0, 60));
  const auto words = irg::two_sum(high, static_cast<T>(std::ldexp(half_place, -down) * static_cast<T>(r.unit() - 0.5)));
  return {words.value, words.error};
}
template <class T>
big_rational rational(const irg::double_word<T>& x) {
  return rational(x.high) + rational(x.low);
}
// The relative error in units of u^2; 0 where the absolute one is at most twice the smallest number.
template <class T>
double error_in_words(const irg::double_word<T>& got, const big_rational& want) {
  if (!std::isfinite(got.high)) return test::error_in_ulp(got.high, want);
  if (got.high != got.high + got.low) return 1e9;
  const big_rational off = abs(rational(got) - want);
  if (!(rational(2 * std::numeric_limits<T>::denorm_min()) < off)) return 0;
  if (want.sign() == 0) return 1e9;
  return (off / abs(want)).times_power_of_two(2 * std::numeric_limits<T>::digits).rounded();
}

template <class T>
void sweep_double_words() {
  using words = irg::double_word<T>;
  const auto binary = [](const char* what, double bound, auto f) {
    sweep(what, bound, [&](test::random& r, sizes which) {
      const words x = two_words<T>(r, which), y = two_words<T>(r, r.integer(0, 1) == 0 ? which : sizes::one_apart);
      return f(x, y);
    });
  };
  const auto error = [](const words& got, const big_rational& want) { return error_in_words(got, want); };
  binary("double_word, sum", 3.001, [&](words x, words y) { return error(x + y, rational(x) + rational(y)); });
  binary("double_word, difference", 3.001, [&](words x, words y) { return error(x - y, rational(x) - rational(y)); });
  binary("double_word, product", 5, [&](words x, words y) { return error(x * y, rational(x) * rational(y)); });
  binary("double_word, sum with one word", 2,
         [&](words x, words y) { return error(x + y.high, rational(x) + rational(y.high)); });
  binary("double_word, product with one word", 3,
         [&](words x, words y) { return error(x * y.high, rational(x) * rational(y.high)); });
  binary("double_word, quotient", 15.001, [&](words x, words y) {
    if (y.high == 0) return 0.0;
    return error(x / y, rational(x) / rational(y));
  });
  test::real exact, off;
  sweep("double_word, root", 25.0 / 8, [&](test::random& r, sizes which) {
    const words x = abs(two_words<T>(r, which)), got = sqrt(x);
    mpfr_set_d(exact, static_cast<double>(x.high), MPFR_RNDN);
    mpfr_add_d(exact, exact, static_cast<double>(x.low), MPFR_RNDN);
    mpfr_sqrt(exact, exact, MPFR_RNDN);
    mpfr_sub_d(off, exact, static_cast<double>(got.high), MPFR_RNDN);
    mpfr_sub_d(off, off, static_cast<double>(got.low), MPFR_RNDN);
    if (x.high == 0) return got.high == 0 ? 0 : 1e9;
    mpfr_div(off, off, exact, MPFR_RNDN);
    return std::fabs(std::ldexp(mpfr_get_d(off, MPFR_RNDN), 2 * std::numeric_limits<T>::digits));
  });
}

TEST_CASE_TEMPLATE("double_word: numbers of all sizes", T, double, float) { sweep_double_words<T>(); }

}  // namespace sweeps
}  // namespace

#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif
