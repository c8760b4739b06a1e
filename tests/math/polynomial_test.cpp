// SPDX-License-Identifier: MIT
#include <irg/math/polynomial.hpp>

#include <span>
#include <vector>

#include <irg/math/double_double.hpp>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;

// (x - 1)^3: around 1 the value is the cube of what is left of x.
constexpr std::array<double, 4> cube{-1, 3, -3, 1};
constexpr std::array<float, 4> float_cube{-1, 3, -3, 1};
constexpr double whole[]{1, 2, 3};
constexpr std::array<int, 3> integers{1, -2, 3};

}  // namespace

static_assert(PolynomialCoefficients<std::array<double, 3>> && PolynomialCoefficients<double[3]>);
static_assert(PolynomialCoefficients<std::span<const float>> && PolynomialCoefficients<std::vector<int>>);
static_assert(!PolynomialCoefficients<double> && noexcept(evaluate_polynomial_accurate(cube, 1.0)));

TEST_CASE("polynomial: by hand") {
  CHECK_BOTH(evaluate_polynomial(whole, 2) == 17);
  CHECK_BOTH(evaluate_polynomial(integers, -3) == 34);
  CHECK_BOTH(evaluate_polynomial(std::span<const double>{}, 2) == 0);
  CHECK_BOTH(evaluate_polynomial(std::array<double_double, 2>{double_double(1), double_double(0x1p-70)},
                                 double_double(1)) == double_double(1, 0x1p-70));
  CHECK_BOTH(evaluate_polynomial_with_derivative(whole, 2) == value_and_derivative<double>{17, 14});
  CHECK_BOTH(polynomial_derivative(integers) == std::array<int, 2>{-2, 6});
  CHECK_BOTH(polynomial_derivative(std::array<double, 1>{7}) == std::array<double, 1>{0});
  CHECK_BOTH(evaluate_polynomial_accurate(whole, 2) == 17);
  CHECK_BOTH(evaluate_polynomial_accurate(std::span<const double>{}, 2) == 0);
  CHECK_BOTH(evaluate_polynomial_exact(cube, 3) == 8);
}

TEST_CASE("polynomial: near a triple root") {
  CHECK_BOTH(evaluate_polynomial(cube, 1 + 0x1p-30) != 0x1p-90);  // Horner's rule has no right digit here
  CHECK_BOTH(evaluate_polynomial_accurate(cube, 1 + 0x1p-30) == 0x1p-90);
  CHECK_BOTH(evaluate_polynomial_exact(cube, 1 + 0x1p-50) == 0x1p-150);
  CHECK_BOTH(evaluate_polynomial_exact(float_cube, 1 + 0x1p-20f) == 0x1p-60f);
  CHECK_BOTH(polynomial_sign(cube, 1 + 0x1p-52) == 1);
  CHECK_BOTH(polynomial_sign(cube, 1 - 0x1p-53) == -1);
  CHECK_BOTH(polynomial_sign(cube, 1) == 0);
  constexpr std::array<double, 6> fifth{-1, 5, -10, 10, -5, 1};
  for (int k = 20; k <= 52; ++k) {  // 2^-260 and less: twice the precision is not enough
    CHECK(polynomial_sign(fifth, 1 + std::ldexp(1.0, -k)) == 1);
    CHECK(polynomial_sign(fifth, 1 - std::ldexp(1.0, -k)) == -1);
    CHECK(evaluate_polynomial_exact(fifth, 1 + std::ldexp(1.0, -k)) == std::ldexp(1.0, -5 * k));
  }
}

TEST_CASE("polynomial: both ends of the range") {
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 3>{0, -largest, 1}, largest) == 0);
  CHECK_BOTH(evaluate_polynomial_exact(std::array<double, 3>{5, -largest, 1}, largest) == 5);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 3>{0, largest, -2}, largest) == -inf);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 4>{1, 0, 0, 1}, smallest) == 1);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 3>{0, 0, 0}, largest) == 0);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 3>{smallest, largest, 1}, 0) == smallest);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 2>{0, smallest}, 0.5) == 0);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 2>{0, 3 * smallest}, 0.5) == 2 * smallest);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<double, 3>{-largest, largest, largest}, 1) == largest);
  CHECK_BOTH(evaluate_polynomial_accurate(std::array<float, 3>{-3e38f, 3e38f, 3e38f}, 1) == 3e38f);
  const double nan_ = test::at_run_time(std::nan(""));
  CHECK(std::isnan(evaluate_polynomial_accurate(cube, nan_)));
  CHECK(std::isnan(evaluate_polynomial_accurate(std::array<double, 2>{nan_, 1}, 1)));
}

#ifdef IRG_HAVE_MPFR
namespace {

template <std::size_t N>
void exact_value(mpfr_ptr sum, const std::array<double, N>& c, double x) {
  mpfr_set_zero(sum, 1);
  for (std::size_t i = N; i-- > 0;) {
    mpfr_mul_d(sum, sum, x, MPFR_RNDN);
    mpfr_add_d(sum, sum, c[i], MPFR_RNDN);
  }
}

}  // namespace

TEST_CASE("polynomial: values against MPFR, near roots and over the whole range") {
  test::random r(1);
  mpfr_t exact, size;
  mpfr_init2(exact, 16000), mpfr_init2(size, 16000);
  double worst = 0, worst_far = 0;
  int compared = 0, opened = 0;
  for (int i = 0, n = test::count_of(5000); i < n; ++i) {
    // A polynomial with a root near x, of condition up to 2^60.
    std::array<double, 5> c{};
    for (double& v : c) v = test::either_sign(r, test::of_exponent(r, -3, 3));
    const double x = test::either_sign(r, test::of_exponent(r, -3, 3));
    exact_value(exact, c, x);
    c[0] -= mpfr_get_d(exact, MPFR_RNDN) * (1 - std::ldexp(r.unit(), -static_cast<int>(r.integer(0, 60))));
    exact_value(exact, c, x);
    CHECK(evaluate_polynomial_exact(c, x) == mpfr_get_d(exact, MPFR_RNDN));
    CHECK(polynomial_sign(c, x) == (mpfr_sgn(exact) > 0) - (mpfr_sgn(exact) < 0));
    std::array<double, 5> sizes = c;
    for (double& v : sizes) v = std::fabs(v);
    exact_value(size, sizes, std::fabs(x));
    mpfr_div(size, size, exact, MPFR_RNDN);
    if (std::fabs(mpfr_get_d(size, MPFR_RNDN)) < 1e14) {
      worst = std::max(worst, test::ulp_error(evaluate_polynomial_accurate(c, x), exact)), ++compared;
    } else {
      ++opened;
    }
    // Any doubles at all.
    std::array<double, 4> any{};
    for (double& v : any) v = test::any_double(r);
    const double at = r.next() % 2 == 0 ? test::any_double(r) : test::of_exponent(r, -300, 300);
    exact_value(exact, any, at);
    CHECK(evaluate_polynomial_exact(any, at) == mpfr_get_d(exact, MPFR_RNDN));
    worst_far = std::max(worst_far, test::ulp_error(evaluate_polynomial_accurate(any, at), exact));
  }
  CHECK(worst <= 1);
  CHECK(worst_far <= 1);
  CHECK(compared > opened);
  MESSAGE("evaluate_polynomial_accurate ", worst, " ulp on ", compared, ", any doubles ", worst_far);
  mpfr_clear(exact), mpfr_clear(size);
}

namespace {
namespace sweeps {

using namespace test::mixed;

template <class T>
void sweep_polynomials() {
  sweep("evaluate_polynomial, values and derivatives", 1, [](test::random& r, sizes which) {
    std::array<T, 4> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    const auto got = irg::evaluate_polynomial_with_derivative(c, x);
    big_rational value = 0, slope = 0, size = 0, slope_size = 0;
    bool is_usual = got.value == irg::evaluate_polynomial(c, x);
    if (!is_usual) return 1e9;
    for (std::size_t i = 4; i-- > 0;) {
      is_usual = is_usual && is_inside<T>(slope * rational(x)) && is_inside<T>(value * rational(x));
      slope = slope * rational(x) + value, slope_size = slope_size * abs(rational(x)) + size;
      value = value * rational(x) + rational(c[i]), size = size * abs(rational(x)) + abs(rational(c[i]));
      is_usual = is_usual && is_inside<T>(slope) && is_inside<T>(value);
    }
    if (!is_usual || size.sign() == 0 || slope_size.sign() == 0) return 0.0;
    const big_rational bound = rational(std::numeric_limits<T>::epsilon()) * 3;  // 2n u
    return std::fmax((abs(rational(got.value) - value) / (size * bound)).rounded(),
                     (abs(rational(got.derivative) - slope) / (slope_size * bound)).rounded());
  });
  sweep("evaluate_polynomial_accurate", 1, [](test::random& r, sizes which) {
    std::array<T, 4> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    big_rational value = 0, size = 0;
    for (std::size_t i = 4; i-- > 0;) {
      value = value * rational(x) + rational(c[i]);
      size = size * abs(rational(x)) + abs(rational(c[i]));
    }
    const T got = irg::evaluate_polynomial_accurate(c, x);
    const double ulp = test::error_in_ulp(got, value);
    if (ulp <= 1 || size < abs(value) * big_rational(1e14)) return ulp;
    const big_rational bound = abs(value) * rational(std::numeric_limits<T>::epsilon()) + size * big_rational(0x9p-104);
    return abs(rational(got) - value) < bound ? 1 : ulp;
  });
  sweep("polynomial_sign", 0, [](test::random& r, sizes which) {
    std::array<T, 3> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    if (r.integer(0, 1) == 0) c[0] = static_cast<T>(-(c[1] + c[2] * x) * x);
    if (!std::isfinite(c[0])) return 0;
    const big_rational value = (rational(c[2]) * rational(x) + rational(c[1])) * rational(x) + rational(c[0]);
    return irg::polynomial_sign(c, x) == value.sign() ? 0 : 1;
  });
}

TEST_CASE_TEMPLATE("polynomials: numbers of all sizes", T, double, float) {
  const auto missed = [](T got, const big_rational& want) { return got == test::nearest<T>(want) ? 0.0 : 1.0; };
  sweep("evaluate_polynomial_exact", 0, [&](test::random& r, sizes which) {
    std::array<T, 4> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    big_rational value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value * rational(x) + rational(c[i]);
    return missed(irg::evaluate_polynomial_exact(c, x), value);
  });
  sweep_polynomials<T>();
}

}  // namespace sweeps
}  // namespace

#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif
