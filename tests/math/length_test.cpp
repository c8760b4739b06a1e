// SPDX-License-Identifier: MIT
#include <irg/math/length.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// The length in 64 bits of precision and 15 of exponent.
long double wide_length(const vec<double, 3>& v) {
  return std::sqrt(wide(v.x) * wide(v.x) + wide(v.y) * wide(v.y) + wide(v.z) * wide(v.z));
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
  // Between the largest subnormal number and the least normal one, nearer to the former.
  CHECK_BOTH(length(vec<double, 4>{0x0.883126e9f0c90p-1022, 0x0.90e5604e44ba1p-1022, 0x0.91d5acb18836cp-1022,
                                   0x0.44bd591584007p-1022}) == 0x0.fffffffffffffp-1022);
  CHECK_BOTH(length(vec<double, 3>{2 * 0x1p1020, 3 * 0x1p1020, 6 * 0x1p1020}) == 7 * 0x1p1020);
  CHECK_BOTH(length(vec<double, 3>{largest, largest, 0}) == inf);
  CHECK_BOTH(length(vec<float, 2>{3e38f, 3e38f}) == std::numeric_limits<float>::infinity());
  CHECK_BOTH(normalized(vec<double, 3>{largest, 0, largest}).x == normalized(vec<double, 3>{1, 0, 1}).x);
  CHECK_BOTH(normalized(vec<double, 3>{0, smallest, 0}) == vec<double, 3>{0, 1, 0});
  CHECK_BOTH(normalized(vec<float, 3>{0, -std::numeric_limits<float>::denorm_min(), 0}) == vec<float, 3>{0, -1, 0});
  CHECK_BOTH(normalized(vec<double, 2>{largest, smallest}) == vec<double, 2>{1, 0});
}

TEST_CASE("length: no direction") {
  CHECK_BOTH(!try_normalized(vec<double, 3>{}));
  CHECK_BOTH(!try_normalized(vec<double, 3>{0, -0.0, 0}));
  CHECK_BOTH(!try_normalized(vec<double, 3>{1, nan_, 0}));
  CHECK_BOTH(!try_normalized(vec<double, 3>{inf, 0, 0}));
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
    const auto at = [&] { return of_exponents(r, middle - 3 < -1074 ? -1074 : middle - 3, middle + 2); };
    const vec<double, 3> v{at(), at(), at()};
    const long double exact = wide_length(v);
    double& here = exact < 0x1p-1022L ? worst_subnormal : worst;
    here = std::max(here, ulps(length(v), exact));
    worst_unit = std::max(worst_unit, std::abs(wide_length(normalized(v)) - 1));
    const vec<double, 3> w{of_exponents(r, -3, 2), of_exponents(r, -3, 2), of_exponents(r, -3, 2)};
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
  CHECK(worst_subnormal <= 0.502);
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
    const auto at = [&] { return static_cast<float>(of_exponents(r, middle - 3, middle + 3)); };
    const vec<float, 3> v{at(), at(), at()};
    if (v == vec<float, 3>{}) continue;
    const vec<float, 3> n = normalized(v);
    const vec<double, 3> wider{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
    worst = std::max(worst, std::abs(static_cast<double>(wide_length(wider)) - 1));
  }
  CHECK(worst <= 2 * 0x1p-24);
}

TEST_CASE("scaled_near_one: the largest coordinate is from 1 to below 4, the others keep their share of it") {
  static_assert(scaled_near_one(vec<float, 2>{0.75f, -6}).scale == 0.25);
  CHECK_BOTH(scaled_near_one(vec<double, 3>{0x1p1000, -0x1p999, 0}).c[1] == -0.5);
  CHECK_BOTH(scaled_near_one(vec<double, 3>{}).scale == 0);
  CHECK_BOTH(is_nan(scaled_near_one(vec<double, 2>{1, inf}).scale));
  CHECK_BOTH(is_nan(scaled_near_one(vec<double, 2>{nan_, 0}).scale));
  CHECK_BOTH(scaled_near_one(vec<double, 2>{smallest, 0}).scale == 0x1p1023);
  test::random r(511);
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const int exponent = static_cast<int>(r.integer(-900, 900));
    vec<double, 3> v{};
    for (double* c : {&v.x, &v.y, &v.z}) *c = std::ldexp((2 * r.unit() - 1), exponent);
    const auto s = scaled_near_one(v);
    double most = 0;
    for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(s.c[k])), wrong += s.c[k] / s.scale != v[k];
    wrong += !(most >= 1 && most < 4);
  }
  CHECK(wrong == 0);
}

#ifdef IRG_HAVE_MPFR

namespace {
namespace sweeps {

using namespace test::mixed;

template <class T, int N>
void sweep_vectors(const std::string& type, double length_bound, double unit_bound) {
  test::real length_of_v, square, quotient;
  const auto measure = [&](const vec<T, N>& v) {
    mpfr_set_zero(length_of_v, 1);
    for (int i = 0; i < N; ++i) {
      mpfr_set_d(square, static_cast<double>(v[i]), MPFR_RNDN);
      mpfr_sqr(square, square, MPFR_RNDN);
      mpfr_add(length_of_v, length_of_v, square, MPFR_RNDN);
    }
    mpfr_sqrt(length_of_v, length_of_v, MPFR_RNDN);
  };
  sweep("length, " + type, length_bound, [&](test::random& r, sizes which) {
    const auto v = vector<T, N>(r, which);
    measure(v);
    return test::ulp_error(length(v), length_of_v);
  });
  sweep("try_normalized, " + type, unit_bound, [&](test::random& r, sizes which) {
    const auto v = vector<T, N>(r, which);
    const auto unit = try_normalized(v);
    measure(v);
    double worst = 0;
    for (int i = 0; unit && i < N; ++i) {
      mpfr_d_div(quotient, static_cast<double>(v[i]), length_of_v, MPFR_RNDN);
      worst = std::fmax(worst, test::ulp_error((*unit)[i], quotient));
    }
    return worst;
  });
}

// A vector whose largest coordinate is of the sizes that the fast functions are for.
template <class T, int N>
vec<T, N> vector_of_moderate_length(test::random& r, sizes which) {
  constexpr int reach = sizeof(T) == 8 ? 499 : 59;
  auto v = vector<T, N>(r, which);
  int largest = 0;
  for (int i = 1; i < N; ++i)
    if (std::fabs(v[i]) > std::fabs(v[largest])) largest = i;
  if (v[largest] == 0) return v;
  const int by = std::max(-reach, std::min(reach, std::ilogb(v[largest]))) - std::ilogb(v[largest]);
  for (int i = 0; i < N; ++i) v[i] = std::ldexp(v[i], by);
  return v;
}
template <class T>
void sweep_fast_lengths() {
  test::real exact, quotient;
  sweep("length_fast", 1.26, [&](test::random& r, sizes which) {
    const auto v = vector_of_moderate_length<T, 3>(r, which);
    set_length(exact, v);
    return test::ulp_error(length_fast(v), exact);
  });
  sweep("normalized_fast", 5, [&](test::random& r, sizes which) {
    const auto v = vector_of_moderate_length<T, 3>(r, which), unit = normalized_fast(v);
    if (v == vec<T, 3>{}) return unit == v ? 0.0 : 1e9;
    set_length(exact, v);
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
      mpfr_d_div(quotient, static_cast<double>(v[i]), exact, MPFR_RNDN);
      worst = std::fmax(worst, test::ulp_error(unit[i], quotient));
    }
    return worst;
  });
}

TEST_CASE("length, try_normalized: numbers of all sizes") {
  sweep_vectors<double, 2>("2 doubles", 0.501, 1.51);
  sweep_vectors<double, 3>("3 doubles", 0.501, 1.51);
  sweep_vectors<double, 4>("4 doubles", 0.501, 1.51);
  sweep_vectors<double, 6>("6 doubles", 0.501, 1.51);
  sweep_vectors<float, 3>("3 floats", 0.501, 0.51);
  sweep_vectors<float, 4>("4 floats", 0.501, 0.51);
}

TEST_CASE_TEMPLATE("length_fast, normalized_fast: numbers of all sizes", T, double, float) { sweep_fast_lengths<T>(); }

}  // namespace sweeps
}  // namespace

#endif
