// SPDX-License-Identifier: MIT
// Rationals of any size over GMP: an oracle for algorithms over any Real. Without GMP (IRG_HAVE_MPFR undefined) there is
// none, and the runs that need it are left out.
#pragma once

#ifdef IRG_HAVE_MPFR
#include <gmp.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace test {

class big_rational {
public:
  big_rational() { mpq_init(value_); }
  big_rational(int x) : big_rational() { mpq_set_si(value_, x, 1); }
  /// needs   a finite number
  explicit big_rational(double x) : big_rational() { mpq_set_d(value_, x); }
  big_rational(const big_rational& v) : big_rational() { mpq_set(value_, v.value_); }
  big_rational& operator=(const big_rational& v) {
    mpq_set(value_, v.value_);
    return *this;
  }
  ~big_rational() { mpq_clear(value_); }

  friend big_rational operator+(const big_rational& a, const big_rational& b) { return with(mpq_add, a, b); }
  friend big_rational operator-(const big_rational& a, const big_rational& b) { return with(mpq_sub, a, b); }
  friend big_rational operator*(const big_rational& a, const big_rational& b) { return with(mpq_mul, a, b); }
  friend big_rational operator/(const big_rational& a, const big_rational& b) { return with(mpq_div, a, b); }
  big_rational operator-() const { return big_rational(0) - *this; }
  friend bool operator<(const big_rational& a, const big_rational& b) { return mpq_cmp(a.value_, b.value_) < 0; }
  // constexpr because mat's is; there are no constants of this type.
  friend constexpr bool operator==(const big_rational& a, const big_rational& b) {
    return std::is_constant_evaluated() ? false : mpq_equal(a.value_, b.value_) != 0;
  }

  /// The double next to it, towards zero.
  explicit operator double() const { return rounded(); }
  double rounded() const { return mpq_get_d(value_); }
  int sign() const { return mpq_sgn(value_); }
  /// An e with 2^(e-1) < |x| < 2^(e+1).
  /// needs   a number that is not zero
  int exponent() const {
    return static_cast<int>(mpz_sizeinbase(mpq_numref(value_), 2)) -
           static_cast<int>(mpz_sizeinbase(mpq_denref(value_), 2));
  }
  friend big_rational abs(const big_rational& a) { return a.sign() < 0 ? -a : a; }
  big_rational times_power_of_two(int k) const {
    big_rational r = *this;
    if (k > 0)
      mpq_mul_2exp(r.value_, r.value_, static_cast<mp_bitcnt_t>(k));
    else
      mpq_div_2exp(r.value_, r.value_, static_cast<mp_bitcnt_t>(-k));
    return r;
  }

private:
  template <class F>
  static big_rational with(F f, const big_rational& a, const big_rational& b) {
    big_rational r;
    f(r.value_, a.value_, b.value_);
    return r;
  }
  mpq_t value_;
};

/// |got - exact|.
inline double distance(double got, const big_rational& exact) {
  return std::fabs(static_cast<double>(big_rational(got) - exact));
}

/// The T nearest to x, ties to even, subnormal and infinite ones too.
template <class T>
T nearest(const big_rational& x) {
  const big_rational size = abs(x);
  const double down = std::fmin(size.rounded(), static_cast<double>((std::numeric_limits<T>::max)()));
  T low = static_cast<T>(down);
  if (static_cast<double>(low) > down) low = std::nextafter(low, T(0));
  const T high = std::nextafter(low, std::numeric_limits<T>::infinity());
  const big_rational step = std::isinf(high) ? big_rational(static_cast<double>(low - std::nextafter(low, T(0))))
                                             : big_rational(static_cast<double>(high - low));
  const big_rational twice_over = (size - big_rational(static_cast<double>(low))) * 2 - step;
  const bool is_odd = std::fmod(static_cast<double>(low) / static_cast<double>(step.rounded()), 2) != 0;
  const bool up = twice_over.sign() > 0 || (twice_over.sign() == 0 && is_odd);
  return std::copysign(up ? high : low, static_cast<T>(x.sign()));
}

/// |got - want| in units in the last place of want, at least the smallest number; 0 for an infinity that is right, 1e9
/// for NaN and wrong infinities.
template <class T>
double error_in_ulp(T got, const big_rational& want) {
  if (got != got) return 1e9;
  const big_rational largest(static_cast<double>((std::numeric_limits<T>::max)()));
  const bool beyond = largest < abs(want);
  if (std::isinf(got)) return beyond && (got < 0) == (want.sign() < 0) ? 0 : 1e9;
  const double near = want.rounded();
  int exponent = 0;
  std::frexp(near, &exponent);
  const int lowest = sizeof(T) == 4 ? -149 : -1074, last = exponent - std::numeric_limits<T>::digits;
  const big_rational off =
      (big_rational(static_cast<double>(got)) - want).times_power_of_two(-(near == 0 || last < lowest ? lowest : last));
  return std::fabs(off.rounded());
}

}  // namespace test
#endif
