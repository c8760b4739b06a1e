// SPDX-License-Identifier: MIT
// How far numbers are from quotients of rationals and from roots of these, without dividing: in lowest terms quotients
// of numbers of all sizes take long.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/big_rational.hpp"

#ifdef IRG_HAVE_MPFR

namespace test::quotients {

// value * 2^exponent with 1/2 < |value| < 2, near a rational.
struct near_number {
  double value = 0;
  int exponent = 0;
  explicit near_number(const big_rational& x) {
    if (x.sign() == 0) return;
    exponent = x.exponent();
    value = x.times_power_of_two(-exponent).rounded();
  }
};

template <class T>
constexpr int smallest_place = sizeof(T) == 4 ? -149 : -1074;

template <class T>
big_rational of(T x) {
  return big_rational(static_cast<double>(x));
}
template <class T>
big_rational largest() {
  return of((std::numeric_limits<T>::max)());
}

/// |got - p/q| in units in the last place of p/q, as error_in_ulp.
/// needs   q is not zero
template <class T>
double quotient_error(T got, const big_rational& p, const big_rational& q) {
  if (got != got) return 1e9;
  if (p.sign() == 0) return got == 0 ? 0 : 1e9;
  const big_rational above = abs(p), below = abs(q);
  if (std::isinf(got)) return largest<T>() * below < above && (got < 0) == (p.sign() != q.sign()) ? 0 : 1e9;
  int exponent = above.exponent() - below.exponent() - 1;
  while (!(above < below.times_power_of_two(exponent))) ++exponent;
  const int last = std::max(exponent - std::numeric_limits<T>::digits, smallest_place<T>);
  const near_number off(of(got) * q - p), divisor(q);
  return std::fabs(std::ldexp(off.value / divisor.value, off.exponent - divisor.exponent - last));
}

/// |got - sqrt(p/q)| in units in the last place of the root.
/// needs   q > 0, p not negative
template <class T>
double root_error(T got, const big_rational& p, const big_rational& q) {
  if (got != got || got < 0) return 1e9;
  if (p.sign() == 0) return got == 0 ? 0 : 1e9;
  if (std::isinf(got)) return largest<T>() * largest<T>() * q < p ? 0 : 1e9;
  // root = value * 2^half
  const near_number above(p), below(q);
  const int apart = above.exponent - below.exponent, odd = apart & 1, half = (apart - odd) / 2;
  const double value = std::sqrt(std::ldexp(above.value / below.value, odd));
  int exponent = 0;
  std::frexp(value, &exponent);
  const int last = std::max(exponent + half - std::numeric_limits<T>::digits, smallest_place<T>);
  // got - root = (got^2 q - p) / (q (got + root))
  const near_number off(of(got) * of(got) * q - p), number(of(got));
  double sum = value;
  int sum_exponent = half;
  if (number.value != 0 && number.exponent > half)
    sum = number.value + std::ldexp(value, half - number.exponent), sum_exponent = number.exponent;
  else if (number.value != 0)
    sum = value + std::ldexp(number.value, number.exponent - half);
  return std::fabs(std::ldexp(off.value / (below.value * sum), off.exponent - below.exponent - sum_exponent - last));
}

}  // namespace test::quotients

#endif
