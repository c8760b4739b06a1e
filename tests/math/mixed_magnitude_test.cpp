// SPDX-License-Identifier: MIT
// The error bounds of functions of several numbers where these are of all sizes: each a random number times 2^k, k from
// the whole range of exponents, or one number far below or above the others.
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include <irg/math/compensated.hpp>
#include <irg/math/length.hpp>
#include <irg/math/polynomial.hpp>
#include <irg/math/vec.hpp>

#include "support/mixed_magnitudes.hpp"

#ifdef IRG_HAVE_MPFR

namespace {

using irg::vec;
using test::big_rational;

using test::mixed::all_sizes;
using test::mixed::number;
using test::mixed::rational;
using test::mixed::sizes;
using test::mixed::sweep;
using test::mixed::vector;

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
  sweep("try_normalize, " + type, unit_bound, [&](test::random& r, sizes which) {
    const auto v = vector<T, N>(r, which);
    const auto unit = try_normalize(v);
    measure(v);
    double worst = 0;
    for (int i = 0; unit && i < N; ++i) {
      mpfr_d_div(quotient, static_cast<double>(v[i]), length_of_v, MPFR_RNDN);
      worst = std::fmax(worst, test::ulp_error((*unit)[i], quotient));
    }
    return worst;
  });
}

}  // namespace

TEST_CASE("mixed magnitudes: lengths and directions") {
  sweep_vectors<double, 2>("2 doubles", 0.501, 1.51);
  sweep_vectors<double, 3>("3 doubles", 0.501, 1.51);
  sweep_vectors<double, 4>("4 doubles", 0.501, 1.51);
  sweep_vectors<double, 6>("6 doubles", 0.501, 1.51);
  sweep_vectors<float, 3>("3 floats", 0.501, 0.51);
  sweep_vectors<float, 4>("4 floats", 0.501, 0.51);
}

TEST_CASE_TEMPLATE("mixed magnitudes: sums, products, polynomials", T, double, float) {
  const auto missed = [](T got, const big_rational& want) { return got == test::nearest<T>(want) ? 0.0 : 1.0; };
  sweep("sum_exact", 0, [&](test::random& r, sizes which) {
    std::array<T, 5> x{};
    big_rational sum = 0;
    for (T& v : x) {
      v = number<T>(r, which);
      sum = sum + rational(v);
    }
    return missed(irg::sum_exact(std::span<const T>(x)), sum);
  });
  sweep("dot_exact", 0, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, all_sizes[r.integer(0, 3)]);
    big_rational sum = 0;
    for (int i = 0; i < 3; ++i) sum = sum + rational(a[i]) * rational(b[i]);
    return missed(dot_exact(a, b), sum);
  });
  sweep("cross_accurate", 1, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, which);
    const auto c = cross_accurate(a, b);
    return test::error_in_ulp(c[0], rational(a[1]) * rational(b[2]) - rational(a[2]) * rational(b[1]));
  });
  sweep("evaluate_polynomial_exact", 0, [&](test::random& r, sizes which) {
    std::array<T, 4> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    big_rational value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value * rational(x) + rational(c[i]);
    return missed(irg::evaluate_polynomial_exact(c, x), value);
  });
}

#endif
