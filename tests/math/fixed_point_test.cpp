// SPDX-License-Identifier: MIT
#include <irg/math/fixed_point.hpp>

#include <cmath>
#include <cstdint>
#include <string>

#include "support/check_both.hpp"
#include "support/random.hpp"
#ifdef IRG_HAVE_MPFR
#include "support/fixed_point_mpfr.hpp"
#endif

using irg::fixed_point;
using irg::parse_fixed_point;

namespace {

using number = fixed_point<3>;

constexpr number one(1.0), half(0.5);

}  // namespace

TEST_CASE("fixed_point: doubles go in and come out") {
  static_assert(double(number(-0.75)) == -0.75 && number(-0.0) == number() && double(one + half) == 1.5);
  static_assert(double(number(-2.5) * number(1.5)) == -3.75 && double(half - one) == -0.5 && double(-one) == -1);
  static_assert(number(0x1p-128).units.word[0] == 1 && number(0x1p-129) == number());
  static_assert(number(-0x1p-129) == number() && number(-0x1p-128) == -number(0x1p-128));
  test::random r(1);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-70, 62)));
    CHECK(double(number(x)) == x);
    CHECK(double(-number(x)) == -x);
  }
  CHECK(double(number(0x1p-128)) == 0x1p-128);
  CHECK(double(number(-0x1p-128)) == -0x1p-128);
}

TEST_CASE("parse_fixed_point: decimal texts") {
  static_assert(parse_fixed_point<3>("-0.75") == number(-0.75) && parse_fixed_point<3>("+12.") == number(12.0));
  static_assert(parse_fixed_point<3>(".5") == half && parse_fixed_point<3>("2147483647") == number(2147483647.0));
  for (const char* text : {"", "-", ".", "+.", "1e5", "0x1", "1.2.3", "1 ", " 1", "2147483648", "nan", "--1", "1,5"})
    CHECK_MESSAGE(!parse_fixed_point<3>(text), text);
  CHECK(parse_fixed_point<3>("0." + std::string(5000, '9')).has_value());
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("fixed_point: sums, products and texts against MPFR") {
  mpfr_t a, b, got, wanted;
  for (mpfr_ptr x : {a, b, got, wanted}) mpfr_init2(x, 800);
  // In units: wanted - got.
  const auto error = [&] {
    mpfr_sub(wanted, wanted, got, MPFR_RNDN);
    mpfr_mul_2ui(wanted, wanted, 128, MPFR_RNDN);
    return mpfr_get_d(wanted, MPFR_RNDN);
  };
  test::random r(2);
  for (int i = 0; i < 3000; ++i) {
    const auto any = [&] {
      irg::wide_int<3> units;
      units.word[0] = r.next();
      units.word[1] = r.next() >> r.integer(0, 63);
      units.word[2] = static_cast<std::uint64_t>(r.integer(-(i % 5), i % 5));
      return number::made_of(i % 7 == 0 ? -units : units);
    };
    const number x = any(), y = any();
    test::set_to_fixed_point(a, x);
    test::set_to_fixed_point(b, y);
    mpfr_mul(wanted, a, b, MPFR_RNDN);
    test::set_to_fixed_point(got, x * y);
    const double below = error();
    CHECK((below >= 0 && below < 1));
    mpfr_sub(wanted, a, b, MPFR_RNDN);
    test::set_to_fixed_point(got, x - y);
    CHECK(error() == 0);
    const double nearest = mpfr_get_d(a, MPFR_RNDN);
    CHECK(std::abs(double(x) - nearest) <= 0x1p-52 * std::abs(nearest));

    std::string text = i % 2 == 0 ? "-" : "";
    text += std::to_string(r.integer(0, 2147483647)) + '.';
    for (int digits = static_cast<int>(r.integer(0, 90)); digits > 0; --digits)
      text += static_cast<char>('0' + r.integer(0, 9));
    mpfr_set_str(wanted, text.c_str(), 10, MPFR_RNDN);
    test::set_to_fixed_point(got, *parse_fixed_point<3>(text));
    CHECK(std::abs(error()) < 2);
  }
  for (mpfr_ptr x : {a, b, got, wanted}) mpfr_clear(x);
}
#endif
