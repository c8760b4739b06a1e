// SPDX-License-Identifier: MIT
#include <irg/math/exponential.hpp>

#include "support/check_both.hpp"
#include "support/ulp.hpp"

namespace {

using test::same;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;
constexpr float inf_f = std::numeric_limits<float>::infinity();

}  // namespace

static_assert(noexcept(irg::exp(1.0)) && noexcept(irg::pow(1.0f, 1.0f)));
static_assert(std::is_same_v<decltype(irg::pow(2.0f, 3)), float>);

TEST_CASE("powers and logarithms by hand") {
  CHECK_BOTH(irg::exp(1.0) == 2.718281828459045);
  CHECK_BOTH(irg::exp(0.0) == 1);
  CHECK_BOTH(irg::exp(-1.0f) == 0.36787945f);
  CHECK_BOTH(irg::exp2(0.5) == 1.4142135623730951);
  CHECK_BOTH(irg::log(2.0) == 0.6931471805599453);
  CHECK_BOTH(irg::log(10.0f) == 2.30258512f);
  CHECK_BOTH(same(irg::log(1.0), 0.0));
  CHECK_BOTH(irg::log2(10.0) == 3.321928094887362);
  CHECK_BOTH(irg::log10(2.0) == 0.3010299956639812);
  CHECK_BOTH(irg::log(1 + 0x1p-52) == 0x1.fffffffffffffp-53);
  CHECK_BOTH(irg::log(1 - 0x1p-53) == -0x1p-53);
  CHECK_BOTH(irg::pow(2.0, 0.5) == 1.4142135623730951);
  CHECK_BOTH(irg::pow(10.0, -3.0) == 0.001);
  CHECK_BOTH(irg::pow(-2.0, 3.0) == -8);
  CHECK_BOTH(irg::pow(1.1f, 10.0f) == 2.59374309f);
  CHECK_BOTH(irg::cbrt(-27.0) == -3);
  CHECK_BOTH(irg::cbrt(2.0) == 1.2599210498948732);
}

TEST_CASE("the ends of the exponential's range") {
  CHECK_BOTH(irg::exp(709.782712893384) == 0x1.fffffffffff2ap1023);
  CHECK_BOTH(irg::exp(709.7827128933841) == inf);
  CHECK_BOTH(irg::exp(-745.1332191019411) == smallest);
  CHECK_BOTH(same(irg::exp(-745.1332191019412), 0.0));
  CHECK_BOTH(irg::exp(largest) == inf);
  CHECK_BOTH(irg::exp(-largest) == 0);
  CHECK_BOTH(irg::exp(inf) == inf);
  CHECK_BOTH(same(irg::exp(-inf), 0.0));
  CHECK_BOTH(same(irg::exp(no_number), no_number));
  CHECK_BOTH(irg::exp(smallest) == 1);
  CHECK_BOTH(irg::exp(-708.5) == 2.006132305331306e-308);
  CHECK_BOTH(irg::exp(88.7228f) == 3.40269467e38f);
  CHECK_BOTH(irg::exp(88.8f) == inf_f);
  CHECK_BOTH(irg::exp2(1024.0) == inf);
  CHECK_BOTH(irg::exp2(-1074.0) == smallest);
  CHECK_BOTH(irg::exp2(-1075.0) == 0);
  CHECK_BOTH(irg::exp2(-1074.9999999999998) == smallest);
  CHECK_BOTH(same(irg::exp2(no_number), no_number));
}

TEST_CASE("logarithms and cube roots of zeros, infinities, NaN, negative and subnormal numbers") {
  CHECK_BOTH(irg::log(0.0) == -inf);
  CHECK_BOTH(irg::log(-0.0) == -inf);
  CHECK_BOTH(same(irg::log(-1.0), no_number));
  CHECK_BOTH(same(irg::log(no_number), no_number));
  CHECK_BOTH(irg::log(inf) == inf);
  CHECK_BOTH(irg::log(smallest) == -744.4400719213812);
  CHECK_BOTH(irg::log2(smallest) == -1074);
  CHECK_BOTH(irg::log2(0.0f) == -inf_f);
  CHECK_BOTH(same(irg::log10(-inf), no_number));
  CHECK_BOTH(irg::log10(largest) == 308.25471555991675);
  CHECK_BOTH(same(irg::cbrt(-0.0), -0.0));
  CHECK_BOTH(irg::cbrt(-inf) == -inf);
  CHECK_BOTH(same(irg::cbrt(no_number), no_number));
  CHECK_BOTH(irg::cbrt(smallest) == 0x1p-358);
  CHECK_BOTH(irg::cbrt(0x1p-1073) == 0x1.428a2f98d728bp-358);
}

TEST_CASE("powers: C's Annex F, line by line") {
  CHECK_BOTH(irg::pow(0.0, -3.0) == inf);
  CHECK_BOTH(irg::pow(-0.0, -3.0) == -inf);
  CHECK_BOTH(irg::pow(-0.0, -2.0) == inf);
  CHECK_BOTH(irg::pow(-0.0, -2.5) == inf);
  CHECK_BOTH(irg::pow(-0.0, -inf) == inf);
  CHECK_BOTH(same(irg::pow(-0.0, 3.0), -0.0));
  CHECK_BOTH(same(irg::pow(-0.0, 4.0), 0.0));
  CHECK_BOTH(irg::pow(-1.0, inf) == 1);
  CHECK_BOTH(irg::pow(-1.0, -inf) == 1);
  CHECK_BOTH(irg::pow(1.0, no_number) == 1);
  CHECK_BOTH(irg::pow(no_number, 0.0) == 1);
  CHECK_BOTH(irg::pow(no_number, -0.0) == 1);
  CHECK_BOTH(same(irg::pow(-8.0, 1.0 / 3), no_number));
  CHECK_BOTH(same(irg::pow(no_number, 1.0), no_number));
  CHECK_BOTH(same(irg::pow(2.0, no_number), no_number));
  CHECK_BOTH(irg::pow(0.5, -inf) == inf);
  CHECK_BOTH(irg::pow(-2.0, -inf) == 0);
  CHECK_BOTH(irg::pow(-0.5, inf) == 0);
  CHECK_BOTH(irg::pow(2.0, inf) == inf);
  CHECK_BOTH(same(irg::pow(-inf, -3.0), -0.0));
  CHECK_BOTH(same(irg::pow(-inf, -2.0), 0.0));
  CHECK_BOTH(irg::pow(-inf, 3.0) == -inf);
  CHECK_BOTH(irg::pow(-inf, 2.5) == inf);
  CHECK_BOTH(irg::pow(inf, -1.0) == 0);
  CHECK_BOTH(irg::pow(inf, 1e-300) == inf);
}

TEST_CASE("powers: hostile exponents") {
  CHECK_BOTH(irg::pow(largest, largest) == inf);
  CHECK_BOTH(irg::pow(1 + 0x1p-52, largest) == inf);
  CHECK_BOTH(irg::pow(1 - 0x1p-53, largest) == 0);
  CHECK_BOTH(irg::pow(largest, smallest) == 1);
  CHECK_BOTH(irg::pow(-1.0, 0x1p53 - 1) == -1);
  CHECK_BOTH(irg::pow(-1.0, 0x1p53) == 1);
  CHECK_BOTH(irg::pow(-1.0, largest) == 1);
  CHECK_BOTH(irg::pow(2.0, -1074.0) == smallest);
  CHECK_BOTH(irg::pow(smallest, -0.5) == 0x1p537);
  CHECK_BOTH(irg::pow(-largest, 3.0) == -inf);
  CHECK_BOTH(irg::pow(10.0f, 39.0f) == inf_f);
}

TEST_CASE("constant evaluation and run time give the same bits") {
  CHECK_SAME_LIVES_1(irg::exp, 0.1);
  CHECK_SAME_LIVES_1(irg::exp, -740.123);
  CHECK_SAME_LIVES_1(irg::exp, 700.7f - 640);
  CHECK_SAME_LIVES_1(irg::exp2, -1060.3);
  CHECK_SAME_LIVES_1(irg::log, 0.99);
  CHECK_SAME_LIVES_1(irg::log, 3e-320);
  CHECK_SAME_LIVES_1(irg::log2, 1.7e308);
  CHECK_SAME_LIVES_1(irg::log10, 0.1f);
  CHECK_SAME_LIVES_1(irg::cbrt, 1.2345e-300);
  CHECK_SAME_LIVES_2(irg::pow, 1.0000001, 1e9);
  CHECK_SAME_LIVES_2(irg::pow, 0.3, 617.3);
  CHECK_SAME_LIVES_2(irg::pow, 0.3f, 17.3f);
}

TEST_CASE("exact results are exact") {
  for (int i = -1074; i <= 1023; ++i) {
    CHECK(irg::exp2(static_cast<double>(i)) == std::ldexp(1.0, i));
    CHECK(irg::pow(2.0, static_cast<double>(i)) == std::ldexp(1.0, i));
    CHECK(irg::log2(std::ldexp(1.0, i)) == i);
  }
  double power = 1;
  for (int i = 0; i <= 22; ++i, power *= 10) {
    CHECK(irg::log10(power) == i);
    CHECK(irg::pow(10.0, static_cast<double>(i)) == power);
  }
  for (int i = 1; i < 200000; i += 7) {
    const double x = i;
    CHECK(irg::cbrt(x * x * x) == x);
    CHECK(irg::pow(x, 3.0) == x * x * x);
    CHECK(irg::pow(x * x, 0.5) == x);
  }
}

#ifdef IRG_HAVE_MPFR
#define IRG_ULP(function, bound, range, ...)                                          \
  test::check_ulp(                                                                    \
      #function ", " range, bound, [](double x, double) { return irg::function(x); }, \
      [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr) { mpfr_##function(out, x, MPFR_RNDN); }, \
      [](test::random& r) -> test::pair_of_doubles { return {__VA_ARGS__, 0}; }, test::count_of(15000))

TEST_CASE("exponentials stay within their bound") {
  IRG_ULP(exp, 0.52, "whole range", test::between(r, -746, 709.78));
  IRG_ULP(exp, 0.52, "unit", test::between(r, -1, 1));
  IRG_ULP(exp, 0.52, "small", test::either_sign(r, test::of_exponent(r, -60, 0)));
  IRG_ULP(exp, 0.52, "subnormal results", test::between(r, -746, -707));
  IRG_ULP(exp, 0.52, "largest results", test::between(r, 709, 709.7827128933840));
  IRG_ULP(exp2, 0.52, "whole range", test::between(r, -1076, 1023.999999));
  IRG_ULP(exp2, 0.52, "subnormal results", test::between(r, -1076, -1021));
}

TEST_CASE("logarithms stay within their bound") {
  IRG_ULP(log, 0.51, "all doubles", std::fabs(test::any_double(r)));
  IRG_ULP(log, 0.51, "near 1", 1 + test::either_sign(r, test::of_exponent(r, -53, -1)));
  IRG_ULP(log, 0.51, "1/2 to 2", test::between(r, 0.5, 2));
  IRG_ULP(log, 0.51, "subnormal", r.unit() * 0x1p-1022 + smallest);
  IRG_ULP(log2, 0.51, "all doubles", std::fabs(test::any_double(r)));
  IRG_ULP(log2, 0.51, "near 1", 1 + test::either_sign(r, test::of_exponent(r, -53, -1)));
  IRG_ULP(log10, 0.51, "all doubles", std::fabs(test::any_double(r)));
  IRG_ULP(log10, 0.51, "near 1", 1 + test::either_sign(r, test::of_exponent(r, -53, -1)));
}

TEST_CASE("cube roots stay within their bound") {
  IRG_ULP(cbrt, 0.501, "all doubles", test::any_double(r));
  IRG_ULP(cbrt, 0.501, "subnormal", test::between(r, -1, 1) * 0x1p-1022);
  IRG_ULP(cbrt, 0.501, "1 to 8", test::between(r, 1, 8));
}

TEST_CASE("powers stay within their bound") {
  using test::random;
  using result = test::pair_of_doubles;
  const auto own = [](double x, double y) { return irg::pow(x, y); };
  const auto exact = [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr y) { mpfr_pow(out, x, y, MPFR_RNDN); };
  const int n = test::count_of(10000);
  const auto run = [&](const char* range, auto generate) { test::check_ulp(range, 0.52, own, exact, generate, n); };
  // Arguments whose result is e^t.
  const auto of_result = [](double x, double t) { return result{x, t / std::log(x)}; };
  run("pow, moderate", [](random& r) { return result{test::between(r, 0, 10), test::between(r, -20, 20)}; });
  run("pow, all bases",
      [&](random& r) { return of_result(test::of_exponent(r, -1074, 1023), test::between(r, -744, 709.7)); });
  run("pow, bases near 1", [&](random& r) {
    return of_result(1 + test::either_sign(r, test::of_exponent(r, -52, -2)), test::between(r, -744, 709.7));
  });
  run("pow, largest results",
      [&](random& r) { return of_result(test::of_exponent(r, 1, 1023), test::between(r, 700, 709.7)); });
  run("pow, subnormal results",
      [&](random& r) { return of_result(test::of_exponent(r, 1, 1023), test::between(r, -746, -706)); });
  run("pow, integers", [](random& r) {
    return result{static_cast<double>(r.integer(-999, 999)), static_cast<double>(r.integer(-20, 30))};
  });
}

#define IRG_FLOAT_RUN(function)                                                                            \
  test::check_floats(                                                                                      \
      #function, 0.5, [](float x) { return irg::function(x); }, [](double x) { return std::function(x); }, \
      [](mpfr_ptr out, mpfr_ptr x) { mpfr_##function(out, x, MPFR_RNDN); })

TEST_CASE("the floats whose logarithm or power is, to double, halfway between two floats") {
  CHECK_BOTH(irg::log(0x1.2f1fd6p+3f) == 0x1.1fcbcep+1f);
  CHECK_BOTH(irg::exp2(0x1.853a6ep-9f) == 0x1.00870ap+0f);
  CHECK_BOTH(irg::exp2(-0x1.e7526ep-6f) == 0x1.f58d62p-1f);
}

TEST_CASE("float results are the nearest float") {
  IRG_FLOAT_RUN(exp);
  IRG_FLOAT_RUN(exp2);
  IRG_FLOAT_RUN(log);
  IRG_FLOAT_RUN(log2);
  IRG_FLOAT_RUN(log10);
  IRG_FLOAT_RUN(cbrt);
}

TEST_CASE("float powers with a fixed exponent are the nearest float, or within 0.5001 ulp") {
  for (const float y : {2.4f, 1 / 2.4f, -3.0f, 50.0f})
    test::check_floats(
        "pow with a fixed y", 0.5001, [y](float x) { return irg::pow(x, y); },
        [y](double x) { return std::pow(x, static_cast<double>(y)); },
        [y](mpfr_ptr out, mpfr_ptr x) { mpfr_pow(out, x, test::real(static_cast<double>(y)), MPFR_RNDN); });
}

TEST_CASE("float pairs: powers") {
  test::check_float_pairs(
      "pow", 0.5001, [](float x, float y) { return irg::pow(x, y); }, [](double x, double y) { return std::pow(x, y); },
      [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr y) { mpfr_pow(out, x, y, MPFR_RNDN); }, 12, 5);
}
#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif
