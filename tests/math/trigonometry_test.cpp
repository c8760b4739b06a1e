// SPDX-License-Identifier: MIT
#include <irg/math/trigonometry.hpp>

#include "support/check_both.hpp"
#include "support/ulp.hpp"

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr float inf_f = std::numeric_limits<float>::infinity();
constexpr double smallest = 0x1p-1074;
constexpr double largest = std::numeric_limits<double>::max();

using test::same;

}  // namespace

static_assert(noexcept(irg::sin(1.0)) && noexcept(irg::atan2(1.0f, 1.0f)));
static_assert(std::is_same_v<decltype(irg::sin(1.0f)), float>);
static_assert(std::is_same_v<decltype(irg::sin_cos(1.0).cosine), double>);

TEST_CASE("sine and cosine: values by hand") {
  CHECK_BOTH(irg::sin(1.0) == 0.8414709848078965);
  CHECK_BOTH(irg::cos(1.0) == 0.5403023058681398);
  CHECK_BOTH(irg::tan(1.0) == 1.5574077246549023);
  CHECK_BOTH(irg::sin(irg::pi<double>) == 1.2246467991473532e-16);
  CHECK_BOTH(irg::cos(irg::half_pi<double>) == 6.123233995736766e-17);
  CHECK_BOTH(irg::tan(irg::half_pi<double>) == 16331239353195370.0);
  CHECK_BOTH(irg::sin(-2.0f) == -0.90929743f);
  CHECK_BOTH(irg::sin_cos(1.0) == irg::sine_and_cosine<double>{irg::sin(1.0), irg::cos(1.0)});
}

TEST_CASE("sine and cosine: huge arguments and those nearest to multiples of pi/2") {
  CHECK_BOTH(irg::sin(1e22) == -0.8522008497671888);
  CHECK_BOTH(irg::cos(1e22) == 0.523214785395139);
  CHECK_BOTH(irg::sin(0x1p1023) == 0.563127779850884);
  CHECK_BOTH(irg::sin(largest) == 0.004961954789184062);
  CHECK_BOTH(irg::cos(largest) == -0.9999876894265599);
  // Of all doubles the one nearest to a multiple of pi/2 relative to its size (Muller 1997).
  CHECK_BOTH(irg::cos(6381956970095103.0 * 0x1p797) == -4.687165924254628e-19);
  CHECK_BOTH(irg::sin(6381956970095103.0 * 0x1p797) == 1.0);
}

TEST_CASE("sine and cosine of floats: where pi/2 needs its third part") {
  CHECK_BOTH(irg::sin(0x1.ab7974p+19f) == 0x1.d60a1ep-13f);
  CHECK_BOTH(irg::cos(0x1.f2b958p+19f) == 0x1.d435e6p-12f);
}

TEST_CASE("sine, cosine and tangent: zeros, infinities, NaN, subnormal numbers") {
  CHECK_BOTH(same(irg::sin(0.0), 0.0));
  CHECK_BOTH(same(irg::sin(-0.0), -0.0));
  CHECK_BOTH(same(irg::tan(-0.0), -0.0));
  CHECK_BOTH(irg::cos(0.0) == 1);
  CHECK_BOTH(irg::cos(-0.0) == 1);
  CHECK_BOTH(irg::sin(smallest) == smallest);
  CHECK_BOTH(irg::tan(-smallest) == -smallest);
  CHECK_BOTH(irg::cos(smallest) == 1);
  CHECK_BOTH(same(irg::sin(inf), no_number));
  CHECK_BOTH(same(irg::cos(-inf), no_number));
  CHECK_BOTH(same(irg::tan(inf), no_number));
  CHECK_BOTH(same(irg::sin(no_number), no_number));
  CHECK_BOTH(same(irg::cos(no_number), no_number));
  CHECK_BOTH(same(irg::tan(no_number), no_number));
  CHECK_BOTH(same(irg::sin(-0.0f), -0.0f));
  CHECK_BOTH(same(irg::cos(inf_f), std::numeric_limits<float>::quiet_NaN()));
  CHECK_BOTH(same(irg::sin_cos(-0.0).sine, -0.0));
  CHECK_BOTH(same(irg::sin_cos(inf).cosine, no_number));
}

TEST_CASE("degrees: exact at multiples of 30") {
  CHECK_BOTH(irg::sin_degrees(30.0) == 0.5);
  CHECK_BOTH(irg::cos_degrees(60.0) == 0.5);
  CHECK_BOTH(irg::sin_degrees(-150.0) == -0.5);
  CHECK_BOTH(irg::sin_degrees(90.0) == 1);
  CHECK_BOTH(irg::cos_degrees(180.0) == -1);
  CHECK_BOTH(irg::cos_degrees(90.0) == 0);
  CHECK_BOTH(same(irg::sin_degrees(180.0), 0.0));
  CHECK_BOTH(same(irg::sin_degrees(-360.0), -0.0));
  CHECK_BOTH(same(irg::cos_degrees(270.0f), 0.0f));
  CHECK_BOTH(irg::sin_degrees(390.0f) == 0.5f);
  CHECK_BOTH(irg::sin_degrees(45.0) == irg::cos_degrees(45.0));
  CHECK_BOTH(irg::sin_degrees(45.0) == irg::sqrt(0.5));
  CHECK_BOTH(same(irg::sin_degrees(inf), no_number));
  CHECK_BOTH(same(irg::cos_degrees(no_number), no_number));
  CHECK_BOTH(same(irg::sin_degrees(-0.0), -0.0));
  CHECK_BOTH(irg::sin_degrees(smallest) == 0);
  CHECK_BOTH(irg::sin_degrees(0x1p60) == irg::sin_degrees(136.0));     // 2^60 modulo 360
  CHECK_BOTH(irg::cos_degrees(0x1p1023) == irg::cos_degrees(8.0));     // 2^1023 modulo 360
  CHECK_BOTH(irg::sin_degrees(360.0 * 0x1p43 + 90) == 1);
  constexpr double sixth_turns[12] = {0, 0.5, 0, 1, 0, 0.5, 0, -0.5, 0, -1, 0, -0.5};
  for (int i = -1200; i <= 1200; ++i) {
    const double expected = sixth_turns[((i % 12) + 12) % 12];
    if (expected != 0 || i % 6 == 0) CHECK(irg::sin_degrees(30.0 * i) == expected);
    if (expected != 0 || i % 6 == 0) CHECK(irg::cos_degrees(90.0 - 30.0 * i) == expected);
  }
}

TEST_CASE("radians and degrees") {
  CHECK_BOTH(irg::radians(180.0) == irg::pi<double>);
  CHECK_BOTH(irg::degrees(irg::pi<double>) == 180);
  CHECK_BOTH(irg::radians(180.0f) == irg::pi<float>);
  CHECK_BOTH(irg::degrees(irg::pi<float>) == 180.0f);
  CHECK_BOTH(irg::radians(-inf) == -inf);
  CHECK_BOTH(same(irg::degrees(no_number), no_number));
  CHECK_BOTH(same(irg::radians(-0.0), -0.0));
  CHECK_BOTH(irg::degrees(inf) == inf);
  CHECK_BOTH(irg::degrees(-largest) == -inf);
  CHECK_BOTH(irg::degrees(smallest) == 57 * smallest);
  CHECK_BOTH(irg::radians(29 * smallest) == smallest);
  CHECK_BOTH(same(irg::radians(-28 * smallest), -0.0));
}

TEST_CASE("inverse functions: values by hand") {
  CHECK_BOTH(irg::atan(1.0) == 0.7853981633974483);
  CHECK_BOTH(irg::atan2(1.0, -1.0) == 2.356194490192345);
  CHECK_BOTH(irg::atan2(-3.0, 4.0) == -0.6435011087932844);
  CHECK_BOTH(irg::asin(0.5) == 0.5235987755982989);
  CHECK_BOTH(irg::acos(0.5) == 1.0471975511965979);
  CHECK_BOTH(irg::asin(1.0) == irg::half_pi<double>);
  CHECK_BOTH(irg::asin(-1.0) == -irg::half_pi<double>);
  CHECK_BOTH(same(irg::acos(1.0), 0.0));
  CHECK_BOTH(irg::acos(-1.0) == irg::pi<double>);
  CHECK_BOTH(irg::acos(0.0) == irg::half_pi<double>);
  CHECK_BOTH(irg::atan2(1.0f, 0.0f) == irg::half_pi<float>);
  CHECK_BOTH(irg::acos(-1.0f) == irg::pi<float>);
  CHECK_BOTH(irg::acos(1 - 0x1p-53) == 0x1p-26);
}

TEST_CASE("atan2: every quadrant, zero and infinity") {
  constexpr double pi = irg::pi<double>;
  CHECK_BOTH(same(irg::atan2(0.0, 1.0), 0.0));
  CHECK_BOTH(same(irg::atan2(-0.0, 1.0), -0.0));
  CHECK_BOTH(same(irg::atan2(0.0, 0.0), 0.0));
  CHECK_BOTH(same(irg::atan2(-0.0, 0.0), -0.0));
  CHECK_BOTH(irg::atan2(0.0, -0.0) == pi);
  CHECK_BOTH(irg::atan2(-0.0, -0.0) == -pi);
  CHECK_BOTH(irg::atan2(-0.0, -1.0) == -pi);
  CHECK_BOTH(irg::atan2(1.0, 0.0) == pi / 2);
  CHECK_BOTH(irg::atan2(-1.0, -0.0) == -pi / 2);
  CHECK_BOTH(irg::atan2(inf, inf) == pi / 4);
  CHECK_BOTH(irg::atan2(-inf, -inf) == -2.356194490192345);
  CHECK_BOTH(irg::atan2(inf, -5.0) == pi / 2);
  CHECK_BOTH(irg::atan2(-5.0, -inf) == -pi);
  CHECK_BOTH(same(irg::atan2(-5.0, inf), -0.0));
  CHECK_BOTH(irg::atan(-inf) == -pi / 2);
  CHECK_BOTH(same(irg::atan2(no_number, 1.0), no_number));
  CHECK_BOTH(same(irg::atan2(0.0, no_number), no_number));
  CHECK_BOTH(same(irg::atan(no_number), no_number));
  CHECK_BOTH(irg::atan2(smallest, smallest) == pi / 4);
  CHECK_BOTH(irg::atan2(largest, -largest) == 2.356194490192345);
  CHECK_BOTH(irg::atan2(smallest, largest) == 0);
  CHECK_BOTH(irg::atan2(smallest, -largest) == pi);
  CHECK_BOTH(irg::atan2(0x1p-1070, 8.0) == 0x1p-1073);
  CHECK_BOTH(same(irg::asin(1 + 0x1p-52), no_number));
  CHECK_BOTH(same(irg::acos(-inf), no_number));
  CHECK_BOTH(same(irg::asin(no_number), no_number));
  CHECK_BOTH(same(irg::asin(-0.0), -0.0));
  CHECK_BOTH(irg::asin(smallest) == smallest);
}

TEST_CASE("constant evaluation and run time give the same bits") {
  CHECK_SAME_LIVES_1(irg::sin, 0.1);
  CHECK_SAME_LIVES_1(irg::sin, 0.7);
  CHECK_SAME_LIVES_1(irg::sin, 12345.678);
  CHECK_SAME_LIVES_1(irg::sin, -1.2345e300);
  CHECK_SAME_LIVES_1(irg::cos, 3.0000000000000004);
  CHECK_SAME_LIVES_1(irg::cos, 98765.4321f);
  CHECK_SAME_LIVES_1(irg::tan, -22.0);
  CHECK_SAME_LIVES_1(irg::tan, 1e-300);
  CHECK_SAME_LIVES_1(irg::asin, 0.3);
  CHECK_SAME_LIVES_1(irg::acos, -0.99999);
  CHECK_SAME_LIVES_1(irg::acos, 0.3f);
  CHECK_SAME_LIVES_1(irg::atan, 1e-5);
  CHECK_SAME_LIVES_1(irg::sin_degrees, 29.999);
  CHECK_SAME_LIVES_1(irg::cos_degrees, -1e-310);
  CHECK_SAME_LIVES_2(irg::atan2, -0.3, -17.0);
  CHECK_SAME_LIVES_2(irg::atan2, 1e-310, 3e-312);
  CHECK_SAME_LIVES_2(irg::atan2, 0.3f, -0.1f);
}

TEST_CASE("symmetries hold bit for bit") {
  test::random r(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = test::any_double(r), y = test::any_double(r), u = test::between(r, -1, 1);
    CHECK(same(irg::sin(-x), -irg::sin(x)));
    CHECK(same(irg::cos(-x), irg::cos(x)));
    CHECK(same(irg::tan(-x), -irg::tan(x)));
    CHECK(same(irg::atan2(-y, x), -irg::atan2(y, x)));
    CHECK(same(irg::asin(-u), -irg::asin(u)));
    CHECK(irg::sin_cos(x) == irg::sine_and_cosine<double>{irg::sin(x), irg::cos(x)});
  }
}

#ifdef IRG_HAVE_MPFR
#define IRG_EXACT(operation) [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr) { operation(out, x, MPFR_RNDN); }
#define IRG_OWN(function) [](double x, double) { return function(x); }

namespace {

/// The double nearest to a random multiple of pi/2 below 2^exponent.
test::pair_of_doubles near_quadrant(test::random& r, double exponent) {
  mpfr_t p;
  mpfr_init2(p, 1200);
  mpfr_const_pi(p, MPFR_RNDN);
  mpfr_mul_d(p, p, std::floor(test::of_exponent(r, 0, exponent)), MPFR_RNDN);
  mpfr_div_2ui(p, p, 1, MPFR_RNDN);
  const double x = mpfr_get_d(p, MPFR_RNDN);
  mpfr_clear(p);
  return {x, 0};
}

template <class F, class Exact>
void check_circular(const std::string& name, double bound, F function, Exact exact) {
  const auto run = [&](const char* range, auto generate, int count) {
    test::check_ulp((name + range).c_str(), bound, function, exact, generate, test::count_of(count));
  };
  using test::random;
  using result = test::pair_of_doubles;
  run(", all doubles", [](random& r) { return result{test::any_double(r), 0}; }, 8000);
  run(", first octant", [](random& r) { return result{test::between(r, -0.8, 0.8), 0}; }, 20000);
  run(", to 100", [](random& r) { return result{test::between(r, -100, 100), 0}; }, 20000);
  run(", 2^15 to 2^25", [](random& r) { return result{test::of_exponent(r, 15, 25), 0}; }, 8000);
  run(", small", [](random& r) { return result{test::either_sign(r, test::of_exponent(r, -40, 0)), 0}; }, 8000);
  run(", near multiples of pi/2 to 2^20", [](random& r) { return near_quadrant(r, 20); }, 4000);
  run(", near multiples of pi/2 to 2^1022", [](random& r) { return near_quadrant(r, 1022); }, 4000);
}

}  // namespace

TEST_CASE("sine, cosine and tangent stay within their bounds") {
  check_circular("sin", 0.55, IRG_OWN(irg::sin), IRG_EXACT(mpfr_sin));
  check_circular("cos", 0.55, IRG_OWN(irg::cos), IRG_EXACT(mpfr_cos));
  check_circular("tan", 0.54, IRG_OWN(irg::tan), IRG_EXACT(mpfr_tan));
}

namespace {

/// x degrees modulo 360 in radians; zero_at is the angle modulo 180 whose sine or cosine is exactly zero, where no
/// number of bits of pi gives zero. Returns whether x is such an angle.
bool exact_radians(mpfr_ptr out, mpfr_ptr x, double zero_at) {
  mpfr_fmod_ui(out, x, 180, MPFR_RNDN);
  mpfr_abs(out, out, MPFR_RNDN);
  const bool is_zero = mpfr_cmp_d(out, zero_at) == 0;
  mpfr_fmod_ui(out, x, 360, MPFR_RNDN);
  test::real pi;
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_mul(out, out, pi, MPFR_RNDN);
  mpfr_div_ui(out, out, 180, MPFR_RNDN);
  if (is_zero) mpfr_set_zero(out, 1);
  return is_zero;
}
void exact_sin_degrees(mpfr_ptr out, mpfr_ptr x) {
  if (!exact_radians(out, x, 0)) mpfr_sin(out, out, MPFR_RNDN);
}
void exact_cos_degrees(mpfr_ptr out, mpfr_ptr x) {
  if (!exact_radians(out, x, 90)) mpfr_cos(out, out, MPFR_RNDN);
}

}  // namespace

TEST_CASE("sine and cosine of degrees stay within their bounds") {
  using test::random;
  using result = test::pair_of_doubles;
  const auto sine = [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr) { exact_sin_degrees(out, x); };
  const auto cosine = [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr) { exact_cos_degrees(out, x); };
  const auto both = [&](const std::string& range, auto generate) {
    const int n = test::count_of(8000);
    test::check_ulp(("sin_degrees" + range).c_str(), 0.55, IRG_OWN(irg::sin_degrees), sine, generate, n);
    test::check_ulp(("cos_degrees" + range).c_str(), 0.55, IRG_OWN(irg::cos_degrees), cosine, generate, n);
  };
  both(", all doubles", [](random& r) { return result{test::any_double(r), 0}; });
  both(", to 1000", [](random& r) { return result{test::between(r, -1000, 1000), 0}; });
  both(", 2^10 to 2^60", [](random& r) { return result{test::of_exponent(r, 10, 60), 0}; });
  both(", integers", [](random& r) { return result{static_cast<double>(r.integer(-100000, 100000)), 0}; });
  both(", near multiples of 90", [](random& r) {
    return result{90.0 * static_cast<double>(r.integer(-99, 99)) + test::of_exponent(r, -60, 0), 0};
  });
}

TEST_CASE("radians and degrees stay within their bounds") {
  using test::random;
  using result = test::pair_of_doubles;
  const auto to_radians = [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr) {
    mpfr_const_pi(out, MPFR_RNDN);
    mpfr_mul(out, out, x, MPFR_RNDN);
    mpfr_div_ui(out, out, 180, MPFR_RNDN);
  };
  const auto to_degrees = [](mpfr_ptr out, mpfr_ptr x, mpfr_ptr) {
    mpfr_const_pi(out, MPFR_RNDN);
    mpfr_div(out, x, out, MPFR_RNDN);
    mpfr_mul_ui(out, out, 180, MPFR_RNDN);
  };
  const int n = test::count_of(8000);
  const auto any = [](random& r) { return result{test::any_double(r), 0}; };
  const auto moderate = [](random& r) { return result{test::between(r, -400, 400), 0}; };
  const auto subnormal = [](random& r) { return result{test::between(r, -1, 1) * 0x1p-1022, 0}; };
  for (const auto& generate : {+any, +moderate, +subnormal}) {
    test::check_ulp("radians", 0.51, IRG_OWN(irg::radians), to_radians, generate, n);
    test::check_ulp("degrees", 0.51, IRG_OWN(irg::degrees), to_degrees, generate, n);
  }
}

TEST_CASE("the inverse functions stay within their bounds") {
  using test::random;
  using result = test::pair_of_doubles;
  const auto unit = [](random& r) { return result{test::between(r, -1, 1), 0}; };
  const auto tiny = [](random& r) { return result{test::either_sign(r, test::of_exponent(r, -1074, 0)), 0}; };
  const auto near_one = [](random& r) { return result{test::either_sign(r, 1 - test::of_exponent(r, -53, -1)), 0}; };
  const int n = test::count_of(15000);
  test::check_ulp("asin, unit", 0.53, IRG_OWN(irg::asin), IRG_EXACT(mpfr_asin), unit, n);
  test::check_ulp("asin, tiny", 0.53, IRG_OWN(irg::asin), IRG_EXACT(mpfr_asin), tiny, n);
  test::check_ulp("asin, near 1", 0.53, IRG_OWN(irg::asin), IRG_EXACT(mpfr_asin), near_one, n);
  test::check_ulp("acos, unit", 0.53, IRG_OWN(irg::acos), IRG_EXACT(mpfr_acos), unit, n);
  test::check_ulp("acos, tiny", 0.53, IRG_OWN(irg::acos), IRG_EXACT(mpfr_acos), tiny, n);
  test::check_ulp("acos, near 1", 0.53, IRG_OWN(irg::acos), IRG_EXACT(mpfr_acos), near_one, n);
  test::check_ulp(
      "atan, all doubles", 0.52, IRG_OWN(irg::atan), IRG_EXACT(mpfr_atan),
      [](random& r) { return result{test::any_double(r), 0}; }, n);
  test::check_ulp("atan, unit", 0.52, IRG_OWN(irg::atan), IRG_EXACT(mpfr_atan), unit, n);

  const auto own = [](double y, double x) { return irg::atan2(y, x); };
  const auto exact = [](mpfr_ptr out, mpfr_ptr y, mpfr_ptr x) { mpfr_atan2(out, y, x, MPFR_RNDN); };
  const auto ratio = [](random& r) {
    return result{test::between(r, -1, 1) * test::of_exponent(r, -70, 70), test::between(r, -1, 1)};
  };
  const auto subnormal = [](random& r) {
    return result{test::between(r, -1, 1) * 0x1p-1060, test::between(r, -1, 1) * 0x1p-1060};
  };
  test::check_ulp(
      "atan2, all doubles", 0.52, own, exact,
      [](random& r) { return result{test::any_double(r), test::any_double(r)}; }, n);
  test::check_ulp(
      "atan2, unit square", 0.52, own, exact,
      [](random& r) { return result{test::between(r, -1, 1), test::between(r, -1, 1)}; }, n);
  test::check_ulp("atan2, ratios to 2^70", 0.52, own, exact, ratio, n);
  test::check_ulp("atan2, subnormal", 0.52, own, exact, subnormal, n);
}

#define IRG_MPFR(operation) [](mpfr_ptr out, mpfr_ptr x) { operation(out, x, MPFR_RNDN); }
#define IRG_FLOAT_RUN(name, function, reference, operation) \
  test::check_floats(name, 0.5, [](float x) { return function(x); }, [](double x) { return reference(x); }, operation)

TEST_CASE("the floats whose result is, to double, halfway between two floats") {
  CHECK_BOTH(irg::sin(0x1.33333p+13f) == -0x1.63f4bap-2f);
  CHECK_BOTH(irg::sin(-0x1.33333p+13f) == 0x1.63f4bap-2f);
  CHECK_BOTH(irg::sin_cos(-0x1.33333p+13f).sine == 0x1.63f4bap-2f);
  CHECK_BOTH(irg::cos(0x1.4555p+51f) == 0x1.115d7ep-1f);
  CHECK_BOTH(irg::cos(-0x1.4555p+51f) == 0x1.115d7ep-1f);
  CHECK_BOTH(irg::cos(0x1.3170fp+63f) == 0x1.fe2976p-1f);
  CHECK_BOTH(irg::sin_cos(0x1.2b9622p+67f).cosine == 0x1.f0285ep-1f);
  CHECK_BOTH(irg::atan(0x1.1ad646p-4f) == 0x1.1a6386p-4f);
  CHECK_BOTH(irg::atan(-0x1.1ad646p-4f) == -0x1.1a6386p-4f);
  CHECK_BOTH(irg::acos(0x1.110b46p-26f) == 0x1.921fb6p+0f);
  CHECK_BOTH(irg::acos(0x1.04c444p-12f) == 0x1.920f6ap+0f);
}

TEST_CASE("float results are the nearest float") {
  IRG_FLOAT_RUN("sin", irg::sin, std::sin, IRG_MPFR(mpfr_sin));
  IRG_FLOAT_RUN("cos", irg::cos, std::cos, IRG_MPFR(mpfr_cos));
  IRG_FLOAT_RUN("tan", irg::tan, std::tan, IRG_MPFR(mpfr_tan));
  IRG_FLOAT_RUN("asin", irg::asin, std::asin, IRG_MPFR(mpfr_asin));
  IRG_FLOAT_RUN("acos", irg::acos, std::acos, IRG_MPFR(mpfr_acos));
  IRG_FLOAT_RUN("atan", irg::atan, std::atan, IRG_MPFR(mpfr_atan));
  // Double's sine of degrees has its own test above, and serves as reference here.
  IRG_FLOAT_RUN("sin_degrees", irg::sin_degrees, irg::sin_degrees, exact_sin_degrees);
  IRG_FLOAT_RUN("cos_degrees", irg::cos_degrees, irg::cos_degrees, exact_cos_degrees);
  IRG_FLOAT_RUN("radians", irg::radians, irg::radians, [](mpfr_ptr out, mpfr_ptr x) {
    mpfr_const_pi(out, MPFR_RNDN);
    mpfr_mul(out, out, x, MPFR_RNDN);
    mpfr_div_ui(out, out, 180, MPFR_RNDN);
  });
  IRG_FLOAT_RUN("degrees", irg::degrees, irg::degrees, [](mpfr_ptr out, mpfr_ptr x) {
    mpfr_const_pi(out, MPFR_RNDN);
    mpfr_div(out, x, out, MPFR_RNDN);
    mpfr_mul_ui(out, out, 180, MPFR_RNDN);
  });
}

TEST_CASE("float angles of points with a fixed x are the nearest float, or within 0.5001 ulp") {
  for (const float x : {0.7f, -3e-5f, 1e-38f, -2e30f})
    test::check_floats(
        "atan2 of a fixed x", 0.5001, [x](float y) { return irg::atan2(y, x); },
        [x](double y) { return std::atan2(y, static_cast<double>(x)); },
        [x](mpfr_ptr out, mpfr_ptr y) { mpfr_atan2(out, y, test::real(static_cast<double>(x)), MPFR_RNDN); });
}

TEST_CASE("float pairs: angles of points") {
  test::check_float_pairs(
      "atan2", 0.5001, [](float y, float x) { return irg::atan2(y, x); },
      [](double y, double x) { return std::atan2(y, x); },
      [](mpfr_ptr out, mpfr_ptr y, mpfr_ptr x) { mpfr_atan2(out, y, x, MPFR_RNDN); }, 12, 12);
}
#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif
