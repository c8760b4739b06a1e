// SPDX-License-Identifier: MIT
#include <irg/math/length.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// A double whose exponent is uniform in [low, high].
double spread(test::random& r, int low, int high) {
  const int exponent = static_cast<int>(r.integer(low, high));
  const double x = std::ldexp(1 + r.unit(), exponent);
  return (r.next() & 1u) != 0 ? x : -x;
}

long double wide(double x) { return static_cast<long double>(x); }

/// The length in 64 bits of precision and 15 of exponent.
long double wide_length(const vec<double, 3>& v) {
  return std::sqrt(wide(v.x) * wide(v.x) + wide(v.y) * wide(v.y) + wide(v.z) * wide(v.z));
}

double ulps(double x, long double exact) {
  int exponent = 0;
  std::frexp(exact, &exponent);
  const int place = exponent - 53 < -1074 ? -1074 : exponent - 53;
  return static_cast<double>(std::abs(wide(x) - exact) / std::ldexp(1.0L, place));
}

template <class V>
concept has_length = requires(V v) { length(v); };

template <class T>
constexpr bool is_zero(const vec<T, 3>& v) {
  return v == vec<T, 3>{};
}

}  // namespace

TEST_CASE("length: type facts") {
  static_assert(std::is_same_v<decltype(length(vec<float, 2>{})), float>);
  static_assert(noexcept(length(vec<double, 3>{})));
  static_assert(std::is_same_v<decltype(normalized(std::array<double, 3>{})), std::array<double, 3>>);
  static_assert(has_length<vec<float, 3>> && !has_length<vec<int, 3>> && !has_length<point<float, 3>>);
}

TEST_CASE("length: by hand") {
  CHECK_BOTH(length(vec<double, 3>{2, 3, 6}) == 7);
  CHECK_BOTH(length(vec<float, 2>{3, -4}) == 5);
  CHECK_BOTH(length(vec<double, 4>{1, 1, 1, 1}) == 2);
  CHECK_BOTH(length(vec<double, 5>{-2, 0, 0, 0, 0}) == 2);
  CHECK_BOTH(length_squared(vec<int, 3>{2, 3, 6}) == 49);
  CHECK_BOTH(normalized(vec<double, 3>{-2, -1, -2}) == vec<double, 3>{-2.0 / 3, -1.0 / 3, -2.0 / 3});
  CHECK_BOTH(normalized_fast(vec<float, 3>{0, 3, 4}) == vec<float, 3>{0, 0.6f, 0.8f});
}

TEST_CASE("length: the golden vector v3 = v2/|v2| = (19, -7, -6)/sqrt(446)") {
  const vec<double, 3> v = normalized(vec<double, 3>{38, -14, -12});
  CHECK(v.x == doctest::Approx(19 / std::sqrt(446.0)).epsilon(1e-15));
  CHECK(v.y == doctest::Approx(-7 / std::sqrt(446.0)).epsilon(1e-15));
  CHECK(v.z == doctest::Approx(-6 / std::sqrt(446.0)).epsilon(1e-15));
}

TEST_CASE("length: ends of the range") {
  CHECK_BOTH(length(vec<double, 3>{largest, 0, 0}) == largest);
  CHECK_BOTH(length(vec<double, 3>{0, -smallest, 0}) == smallest);
  CHECK_BOTH(length(vec<double, 2>{3 * smallest, 4 * smallest}) == 5 * smallest);
  CHECK_BOTH(length(vec<double, 3>{2 * 0x1p1020, 3 * 0x1p1020, 6 * 0x1p1020}) == 7 * 0x1p1020);
  CHECK_BOTH(length(vec<double, 3>{largest, largest, 0}) == inf);
  CHECK_BOTH(length(vec<float, 2>{3e38f, 3e38f}) == std::numeric_limits<float>::infinity());
  CHECK_BOTH(normalized(vec<double, 3>{largest, 0, largest}).x == normalized(vec<double, 3>{1, 0, 1}).x);
  CHECK_BOTH(normalized(vec<double, 3>{0, smallest, 0}) == vec<double, 3>{0, 1, 0});
  CHECK_BOTH(normalized(vec<float, 3>{0, -std::numeric_limits<float>::denorm_min(), 0}) == vec<float, 3>{0, -1, 0});
  CHECK_BOTH(normalized(vec<double, 2>{largest, smallest}) == vec<double, 2>{1, 0});
}

TEST_CASE("length: no direction") {
  CHECK_BOTH(!try_normalize(vec<double, 3>{}));
  CHECK_BOTH(!try_normalize(vec<double, 3>{0, -0.0, 0}));
  CHECK_BOTH(!try_normalize(vec<double, 3>{1, nan_, 0}));
  CHECK_BOTH(!try_normalize(vec<double, 3>{inf, 0, 0}));
  CHECK_BOTH(is_zero(normalized(vec<double, 3>{})));
  CHECK_BOTH(is_zero(normalized(vec<float, 3>{0, std::numeric_limits<float>::quiet_NaN(), 1})));
  CHECK_BOTH(is_zero(normalized_fast(vec<double, 3>{})));
  CHECK_BOTH(length(vec<double, 3>{nan_, 1, -inf}) == inf);
  CHECK_BOTH(length(vec<double, 5>{nan_, 1, 1, 1, -inf}) == inf);
  CHECK(std::isnan(length(vec<double, 3>{nan_, 1, 1})));
}

TEST_CASE("length: error against 64-bit arithmetic over the whole range") {
  test::random r(1);
  double worst = 0, worst_subnormal = 0, worst_fast = 0, worst_coordinate = 0, worst_unit_coordinate = 0;
  long double worst_unit = 0;
  for (int k = 0; k < 200000; ++k) {
    const int middle = static_cast<int>(r.integer(-1070, 1020));
    const auto at = [&] { return spread(r, middle - 3 < -1074 ? -1074 : middle - 3, middle + 2); };
    const vec<double, 3> v{at(), at(), at()};
    const long double exact = wide_length(v);
    double& here = exact < 0x1p-1022L ? worst_subnormal : worst;
    here = std::max(here, ulps(length(v), exact));
    worst_unit = std::max(worst_unit, std::abs(wide_length(normalized(v)) - 1));
    const vec<double, 3> w{spread(r, -3, 2), spread(r, -3, 2), spread(r, -3, 2)};
    worst_fast = std::max(worst_fast, ulps(length_fast(w), wide_length(w)));
    const vec<double, 3> unit = normalized_fast(w), nearest = normalized(v);
    for (int i = 0; i < 3; ++i)
      if (std::abs(nearest[i]) > 0x1p-1000)
        worst_unit_coordinate =
            std::max(worst_unit_coordinate,
                     ulps(std::abs(nearest[i]), static_cast<long double>(std::abs(v[i])) / wide_length(v)));
    for (int i = 0; i < 3; ++i)
      worst_coordinate = std::max(worst_coordinate,
                                  ulps(std::abs(unit[i]), static_cast<long double>(std::abs(w[i])) / wide_length(w)));
  }
  CHECK(worst <= 0.502);
  CHECK(worst_subnormal <= 1);
  CHECK(worst_unit <= 2 * 0x1p-53L);
  CHECK(worst_unit_coordinate <= 1.51);
  CHECK(worst_unit_coordinate > 1.02);  // the quotient of two rounded numbers is not better than that
  CHECK(worst_fast <= 1.26);
  CHECK(worst_coordinate <= 3);
  MESSAGE("length ", worst, " ulp, subnormal ", worst_subnormal, ", |normalized| - 1 ",
          static_cast<double>(worst_unit * 0x1p53L), " u, fast ", worst_fast, " ulp");
}

TEST_CASE("length: float's directions") {
  test::random r(2);
  double worst = 0;
  for (int k = 0; k < 100000; ++k) {
    const int middle = static_cast<int>(r.integer(-140, 120));
    const auto at = [&] { return static_cast<float>(spread(r, middle - 3, middle + 3)); };
    const vec<float, 3> v{at(), at(), at()};
    if (v == vec<float, 3>{}) continue;
    const vec<float, 3> n = normalized(v);
    const vec<double, 3> wider{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
    worst = std::max(worst, std::abs(static_cast<double>(wide_length(wider)) - 1));
  }
  CHECK(worst <= 2 * 0x1p-24);
}

TEST_CASE("length: angles by hand") {
  constexpr double pi_ = pi<double>;
  CHECK_BOTH(angle_between(vec<double, 2>{1, 0}, vec<double, 2>{0, -3}) == pi_ / 2);
  CHECK_BOTH(angle_between(vec<double, 3>{1, 2, 3}, vec<double, 3>{1, 2, 3}) == 0);
  CHECK_BOTH(angle_between(vec<double, 3>{1, 2, 3}, vec<double, 3>{-2, -4, -6}) == pi_);
  CHECK_BOTH(angle_between(vec<float, 3>{0, 0, 1}, vec<float, 3>{0, 5, 0}) == pi<float> / 2);
  CHECK_BOTH(angle_between(vec<double, 3>{largest, 0, 0}, vec<double, 3>{smallest, smallest, 0}) == pi_ / 4);
  CHECK_BOTH(angle_between(vec<double, 3>{1, 0, 0}, vec<double, 3>{1, 0, 1e-300}) == 1e-300);
  // No power of two brings a subnormal vector near 1; its small angle to another one keeps all digits.
  constexpr double small_angle =
      angle_between(vec<double, 2>{0x1.a4179babfc687p-660, 0x1p320}, vec<double, 2>{0, 5 * smallest});
  CHECK_BOTH(irg::detail::magnitude(small_angle - 0x1.a4179babfc687p-980) <= 0x4p-1032);
  CHECK_BOTH(angle_between(vec<double, 3>{}, vec<double, 3>{1, 0, 0}) == 0);
  CHECK(std::isnan(angle_between(vec<double, 3>{nan_, 0, 0}, vec<double, 3>{1, 0, 0})));
  CHECK(std::isnan(angle_between(vec<double, 3>{1, 0, 0}, vec<double, 3>{1, inf, 0})));
}

TEST_CASE("length: angles of equal and opposite vectors, and at the ends of the moderate coordinates") {
  test::random r(5);
  for (int k = 0; k < 20000; ++k) {
    const int middle = static_cast<int>(r.integer(-1070, 1020));
    const int reach = static_cast<int>(r.integer(2, 400));
    const auto at = [&] { return spread(r, std::max(middle - reach, -1074), std::min(middle + reach, 1022)); };
    const vec<double, 3> v{at(), at(), r.unit() < 0.2 ? 0 : at()};
    CHECK(angle_between(v, v) == 0);
    CHECK(angle_between(v, -v) == pi<double>);
    CHECK(angle_between(vec<double, 2>{v.x, v.y}, vec<double, 2>{v.x, v.y}) == 0);
    CHECK(angle_between(vec<double, 2>{v.x, v.y}, vec<double, 2>{-v.x, -v.y}) == pi<double>);
    const double angle = angle_between(v, vec<double, 3>{at(), at(), at()});
    CHECK((angle >= 0 && angle <= pi<double>));
  }
  // One vector is moderate, a little longer it is not.
  const vec<double, 3> a{0x1.8p179, -0x1.2p178, 0x1p100}, b{0x1.3p-178, 0x1.9p-179, 0x1.1p-180};
  CHECK(angle_between(a, b) == angle_between(a * 4.0, b));
  CHECK(angle_between(a, b) == angle_between(a, b * 0.25));
  CHECK(angle_between(a, b) == angle_between(a * 0x1p800, b * 0x1p-800));
  CHECK_BOTH(angle_between(vec<double, 3>{1, 1, 0}, vec<double, 3>{0x1p-200, 0, 0}) == pi<double> / 4);
  CHECK_BOTH(angle_between(vec<double, 3>{0x1p-180, 0, 0}, vec<double, 3>{0, 0x1p-180, 0x1p-180}) == pi<double> / 2);
  constexpr double in_constant_evaluation = angle_between(vec<double, 3>{0.1, 0.2, 0.3}, vec<double, 3>{-0.7, 0.1, 1});
  const vec<double, 3> at_run_time{test::at_run_time(0.1), 0.2, 0.3};
  CHECK(in_constant_evaluation == angle_between(at_run_time, vec<double, 3>{-0.7, 0.1, 1}));
}

#ifdef __SIZEOF_FLOAT128__
TEST_CASE("length: angles against 113-bit products") {
  __extension__ typedef __float128 quad;
  test::random r(3);
  double worst = 0;
  for (int k = 0; k < 100000; ++k) {
    const int small = static_cast<int>(r.integer(-60, 0));
    const vec<double, 3> a{r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5};
    const double sign = (r.next() & 1u) != 0 ? 1.5 : -0.75;
    const auto near = [&](double x) { return sign * x + std::ldexp(r.unit() - 0.5, small); };
    const vec<double, 3> b{near(a.x), near(a.y), near(a.z)};
    const auto minor = [&](double p, double q, double s, double t) { return quad(p) * quad(t) - quad(q) * quad(s); };
    const long double x = static_cast<long double>(minor(a.y, a.z, b.y, b.z));
    const long double y = static_cast<long double>(minor(a.z, a.x, b.z, b.x));
    const long double z = static_cast<long double>(minor(a.x, a.y, b.x, b.y));
    const quad along = quad(a.x) * quad(b.x) + quad(a.y) * quad(b.y) + quad(a.z) * quad(b.z);
    const long double exact = std::atan2(std::sqrt(x * x + y * y + z * z), static_cast<long double>(along));
    worst = std::max(worst, ulps(angle_between(a, b), exact));
  }
  CHECK(worst <= 2.2);  // without the rest of the root it is 2.3, with a plain dot product 2.75
  MESSAGE("angle_between ", worst, " ulp");
}
#endif

#ifdef IRG_HAVE_MPFR
namespace {

/// x times y added to a sum that is wide enough for every product of doubles.
void add_product(mpfr_ptr sum, double x, double y) {
  static test::real product;
  mpfr_set_prec(product, 120);
  mpfr_set_d(product, x, MPFR_RNDN);
  mpfr_mul_d(product, product, y, MPFR_RNDN);
  mpfr_add(sum, sum, product, MPFR_RNDN);
}

void exact_angle(mpfr_ptr out, const vec<double, 3>& a, const vec<double, 3>& b) {
  static test::real square, minor;
  mpfr_set_prec(square, 9000);
  mpfr_set_prec(minor, 9000);
  mpfr_set_zero(square, 1);
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    mpfr_set_zero(minor, 1);
    add_product(minor, a[i], b[j]);
    add_product(minor, -a[j], b[i]);
    mpfr_fma(square, minor, minor, square, MPFR_RNDN);
  }
  mpfr_sqrt(square, square, MPFR_RNDN);
  mpfr_set_zero(minor, 1);
  for (int k = 0; k < 3; ++k) add_product(minor, a[k], b[k]);
  mpfr_prec_round(square, 300, MPFR_RNDN);
  mpfr_prec_round(minor, 300, MPFR_RNDN);
  mpfr_atan2(out, square, minor, MPFR_RNDN);
}

}  // namespace

TEST_CASE("length: angles from 1e-300 to pi, lengths from 2^-500 to 2^500, against MPFR") {
  test::random r(4);
  double worst = 0, worst_obtuse = 0, worst_flat = 0;
  test::real exact;
  for (int i = 0, n = test::count_of(3000); i < n; ++i) {
    // Two coordinates in proportion, the third an angle apart: 10^-300 to 1, from 0 and from pi, along every axis.
    const double apart = std::pow(10, -300 * r.unit() * r.unit());
    const double sign = (r.next() & 1u) != 0 ? 1.0 : -1.0;
    const double factor = std::ldexp(sign, static_cast<int>(r.integer(-400, 400)));
    const double size = std::ldexp(1.0, static_cast<int>(r.integer(-100, 100)));
    double p[3] = {size * (r.unit() + 0.5), size * (r.unit() - 0.5), 0}, q[3];
    for (int k = 0; k < 3; ++k) q[k] = p[k] * factor;
    q[2] = apart * (r.unit() + 0.5) * size * std::abs(factor);
    if (q[2] < 0x1p-1022) continue;
    const int turn = static_cast<int>(r.integer(0, 2));
    const auto turned = [&](const double(&c)[3]) {
      return vec<double, 3>{c[turn], c[(turn + 1) % 3], c[(turn + 2) % 3]};
    };
    const vec<double, 3> a = turned(p), b = turned(q);
    const double got = angle_between(a, b);
    exact_angle(exact, a, b);
    double& here = factor > 0 ? worst : worst_obtuse;
    here = std::max(here, test::ulp_error(got, exact));
    CHECK(test::same(got, angle_between(b, a)));
    // The same in the plane.
    const vec<double, 2> u{p[0], 0}, v{q[0], q[2]};
    exact_angle(exact, {u.x, u.y, 0}, {v.x, v.y, 0});
    worst_flat = std::max(worst_flat, test::ulp_error(angle_between(u, v), exact));
  }
  CHECK(worst <= 4);
  CHECK(worst_obtuse <= 4);
  CHECK(worst_flat <= 4);
  MESSAGE("angle_between ", worst, " ulp near 0, ", worst_obtuse, " near pi, ", worst_flat, " in the plane");
}
#endif
