// SPDX-License-Identifier: MIT
#include <irg/math/angle_between.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <irg/math/constants.hpp>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"
#include "support/wide_oracle.hpp"

using namespace irg;
using test::of_exponents, test::ulps, test::wide;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("angle_between: by hand") {
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
  CHECK_BOTH(irg::magnitude(small_angle - 0x1.a4179babfc687p-980) <= 0x4p-1032);
  CHECK_BOTH(angle_between(vec<double, 3>{}, vec<double, 3>{1, 0, 0}) == 0);
  CHECK(std::isnan(angle_between(vec<double, 3>{nan_, 0, 0}, vec<double, 3>{1, 0, 0})));
  CHECK(std::isnan(angle_between(vec<double, 3>{1, 0, 0}, vec<double, 3>{1, inf, 0})));
}

TEST_CASE("angle_between: of equal and opposite vectors, and at the ends of the moderate coordinates") {
  test::random r(5);
  for (int k = 0; k < 20000; ++k) {
    const int middle = static_cast<int>(r.integer(-1070, 1020));
    const int reach = static_cast<int>(r.integer(2, 400));
    const auto at = [&] { return of_exponents(r, std::max(middle - reach, -1074), std::min(middle + reach, 1022)); };
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
TEST_CASE("angle_between: against 113-bit products") {
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

TEST_CASE("angle_between: from 1e-300 to pi, lengths from 2^-500 to 2^500, against MPFR") {
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

namespace {
namespace sweeps {

using namespace test::mixed;
using test::mixed::wide;

template <class T>
void set_cross_length(mpfr_ptr out, const vec<T, 3>& a, const vec<T, 3>& b) {
  static wide<T> minor;
  static test::real square;
  mpfr_set_zero(out, 1);
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    mpfr_set_zero(minor, 1);
    add_product(minor, static_cast<double>(a[i]), b[j]);
    add_product(minor, -static_cast<double>(a[j]), b[i]);
    mpfr_set(square, minor, MPFR_RNDN);
    mpfr_fma(out, square, square, out, MPFR_RNDN);
  }
  mpfr_sqrt(out, out, MPFR_RNDN);
}

template <class T, int N>
void sweep_angles(const std::string& type) {
  test::real across, along, exact;
  sweep("angle_between, " + type, 4, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto in_space = [](const vec<T, N>& v) { return vec<T, 3>{v[0], v[1], N == 3 ? v[N - 1] : T(0)}; };
    set_cross_length(across, in_space(a), in_space(b));
    set_dot(along, a, b);
    mpfr_atan2(exact, across, along, MPFR_RNDN);
    if (a == vec<T, N>{} || b == vec<T, N>{}) mpfr_set_zero(exact, 1);
    return test::ulp_error(irg::angle_between(a, b), exact);
  });
}

TEST_CASE("angle_between: numbers of all sizes") {
  sweep_angles<double, 3>("3 doubles");
  sweep_angles<double, 2>("2 doubles");
  sweep_angles<float, 3>("3 floats");
  sweep_angles<float, 2>("2 floats");
}

}  // namespace sweeps
}  // namespace

#endif
