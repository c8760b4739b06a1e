// SPDX-License-Identifier: MIT
// What sweeps of functions of several numbers over all sizes share: each number a random one times 2^k, k from the whole
// range of exponents, or one number far below or above the others. The sweeps stand in the tests of what they sweep.
#pragma once

#include <cmath>
#include <limits>

#include <irg/math/vec.hpp>

#include "support/mixed_magnitudes.hpp"

#ifdef IRG_HAVE_MPFR

namespace test::mixed {

using irg::vec;

// The T nearest to x, ties to even.
template <class T>
T nearest_to(mpfr_ptr x) {
  return sizeof(T) == 4 ? static_cast<T>(mpfr_get_flt(x, MPFR_RNDN)) : static_cast<T>(mpfr_get_d(x, MPFR_RNDN));
}
template <class T>
double missed(T got, mpfr_ptr want) {
  return got == nearest_to<T>(want) ? 0 : 1;
}

inline int sign_of(mpfr_ptr x) { return (mpfr_sgn(x) > 0) - (mpfr_sgn(x) < 0); }

// Wide enough for sums of products of two numbers, exactly.
template <class T>
struct wide : test::real {
  wide() { mpfr_set_prec(*this, sizeof(T) == 8 ? 4400 : 800); }
};

// The product of numbers added to a sum.
template <class... T>
void add_product(mpfr_ptr sum, double first, T... others) {
  static test::real product;
  mpfr_set_d(product, first, MPFR_RNDN);
  (mpfr_mul_d(product, product, static_cast<double>(others), MPFR_RNDN), ...);
  mpfr_add(sum, sum, product, MPFR_RNDN);
}
template <class T, int N>
void set_dot(mpfr_ptr out, const vec<T, N>& a, const vec<T, N>& b) {
  static wide<T> sum;
  mpfr_set_zero(sum, 1);
  for (int i = 0; i < N; ++i) add_product(sum, static_cast<double>(a[i]), b[i]);
  mpfr_set(out, sum, MPFR_RNDN);
}
template <class T, int N>
void set_length(mpfr_ptr out, const vec<T, N>& v) {
  set_dot(out, v, v);
  mpfr_sqrt(out, out, MPFR_RNDN);
}
// A vector, and another that is at right angles to it, parallel to it, both nearly, or neither.
template <class T, int N>
vec<T, N> beside(test::random& r, const vec<T, N>& a, sizes which) {
  const auto other = vector<T, N>(r, which);
  const std::int64_t how = r.integer(0, 4);
  if (how > 1) return other;
  vec<T, N> b{};
  const T factor = static_cast<T>(r.unit() + 0.5);
  if (how == 0) {
    for (int i = 0; i < N; ++i) b[i] = a[i] * factor;
  } else {
    b[0] = -a[1] * factor, b[1] = a[0] * factor;
  }
  if (r.integer(0, 1) == 0) b[N - 1] = other[N - 1];
  return b == vec<T, N>{} ? other : b;
}

// Whether x is 0 or neither near the smallest nor near the largest numbers.
template <class T>
bool is_inside(const big_rational& x) {
  constexpr T least = std::numeric_limits<T>::min() * T(0x1p60f), most = std::numeric_limits<T>::max() * T(0x1p-4f);
  return x.sign() == 0 || (rational(least) < abs(x) && abs(x) < rational(most));
}

}  // namespace test::mixed

#endif
