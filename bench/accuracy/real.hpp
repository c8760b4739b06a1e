// SPDX-License-Identifier: MIT
// Numbers of many digits for the oracles of the accuracy studies (MPFR), with the operations their formulas need.
#pragma once

#if __has_include(<mpfr.h>)
#define BENCH_HAS_MPFR 1
#include <mpfr.h>

#include <utility>

#include "study.hpp"

namespace bench {

/// A number of 600 bits: exact for sums and products of a few doubles of like size; else 170 digits are enough for any
/// condition the studies have.
class real {
public:
  real(double x = 0) {
    mpfr_init2(value_, 600);
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  real(const real& v) : real() { mpfr_set(value_, v.value_, MPFR_RNDN); }
  real(real&& v) noexcept : real() { mpfr_swap(value_, v.value_); }
  real& operator=(real v) {
    mpfr_swap(value_, v.value_);
    return *this;
  }
  ~real() { mpfr_clear(value_); }

  friend real operator+(real a, const real& b) { return std::move(a.changed(mpfr_add, b)); }
  friend real operator-(real a, const real& b) { return std::move(a.changed(mpfr_sub, b)); }
  friend real operator*(real a, const real& b) { return std::move(a.changed(mpfr_mul, b)); }
  friend real operator/(real a, const real& b) { return std::move(a.changed(mpfr_div, b)); }
  friend real operator-(const real& a) { return real(0) - a; }
  friend bool operator<(const real& a, const real& b) { return mpfr_less_p(a.value_, b.value_) != 0; }
  friend bool operator==(const real& a, const real& b) { return mpfr_equal_p(a.value_, b.value_) != 0; }

  /// f(x) or f(y, x) for one of MPFR's functions, as in real::of(mpfr_sin, x).
  template <class F>
  static real of(F f, const real& x) {
    real r;
    f(r.value_, x.value_, MPFR_RNDN);
    return r;
  }
  template <class F>
  static real of(F f, const real& x, const real& y) {
    real r;
    f(r.value_, x.value_, y.value_, MPFR_RNDN);
    return r;
  }
  friend real sqrt(const real& x) { return of(mpfr_sqrt, x); }
  friend real abs(const real& x) { return x < real(0) ? -x : x; }

  double nearest() const { return mpfr_get_d(value_, MPFR_RNDN); }
  exact_result result() const {
    const double value = nearest();
    if (!std::isfinite(value)) return {value, 0};
    return {value, (*this - real(value)).nearest()};
  }

private:
  template <class F>
  real& changed(F f, const real& b) {
    f(value_, value_, b.value_, MPFR_RNDN);
    return *this;
  }
  mpfr_t value_;
};

}  // namespace bench

#endif
