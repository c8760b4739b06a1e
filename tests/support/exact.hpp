// SPDX-License-Identifier: MIT
// Rationals of any size (GMP) as oracle and as user-defined scalar, coordinates of every size, and errors in units in
// the last place. Without MPFR and GMP (IRG_HAVE_MPFR undefined) tests that need them are left out.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "random.hpp"

#ifdef IRG_HAVE_MPFR
#include <gmp.h>

namespace test {

/// A rational of any size.
class exact {
public:
  exact() { mpq_init(q_); }
  exact(int n) : exact() { mpq_set_si(q_, n, 1); }
  explicit exact(double x) : exact() { mpq_set_d(q_, x); }
  exact(const exact& other) : exact() { mpq_set(q_, other.q_); }
  exact& operator=(const exact& other) {
    mpq_set(q_, other.q_);
    return *this;
  }
  ~exact() { mpq_clear(q_); }

  friend exact operator+(const exact& a, const exact& b) { return made(mpq_add, a, b); }
  friend exact operator-(const exact& a, const exact& b) { return made(mpq_sub, a, b); }
  friend exact operator*(const exact& a, const exact& b) { return made(mpq_mul, a, b); }
  friend exact operator/(const exact& a, const exact& b) { return made(mpq_div, a, b); }
  friend exact operator-(const exact& a) { return exact(0) - a; }
  friend bool operator<(const exact& a, const exact& b) { return mpq_cmp(a.q_, b.q_) < 0; }
  friend bool operator==(const exact& a, const exact& b) { return mpq_equal(a.q_, b.q_) != 0; }

  int sign() const { return mpq_sgn(q_); }
  /// The nearest double towards zero.
  double rounded() const { return mpq_get_d(q_); }
  exact times_power_of_two(int k) const {
    exact r = *this;
    if (k > 0)
      mpq_mul_2exp(r.q_, r.q_, static_cast<mp_bitcnt_t>(k));
    else
      mpq_div_2exp(r.q_, r.q_, static_cast<mp_bitcnt_t>(-k));
    return r;
  }

private:
  template <class F>
  static exact made(F f, const exact& a, const exact& b) {
    exact r;
    f(r.q_, a.q_, b.q_);
    return r;
  }
  mpq_t q_;
};

/// |got - want| in units in the last place of want, at least the smallest number; 0 for an infinity that is right, 1e9
/// for NaN and wrong infinities.
template <class T>
double error_in_ulp(T got, const exact& want) {
  if (got != got) return 1e9;
  const exact largest(static_cast<double>((std::numeric_limits<T>::max)()));
  const bool beyond = largest < (want.sign() < 0 ? -want : want);
  if (std::isinf(got)) return beyond && (got < 0) == (want.sign() < 0) ? 0 : 1e9;
  const double near = want.rounded();
  int exponent = 0;
  std::frexp(near, &exponent);
  const int lowest = sizeof(T) == 4 ? -149 : -1074, last = exponent - std::numeric_limits<T>::digits;
  const exact off =
      (exact(static_cast<double>(got)) - want).times_power_of_two(-(near == 0 || last < lowest ? lowest : last));
  return std::fabs(off.rounded());
}

}  // namespace test
#endif

namespace test {

/// How many trials a run takes, from how many it takes per commit.
inline int trials(int per_commit) { return std::getenv("IRG_RELEASE_TIER") != nullptr ? 100 * per_commit : per_commit; }

/// Coordinates of controlled difficulty.
enum class spread { unit, small_integers, tenths, tiny_steps, any_bits, wide, subnormal };
inline constexpr spread all_spreads[] = {spread::unit,     spread::small_integers, spread::tenths,   spread::tiny_steps,
                                         spread::any_bits, spread::wide,           spread::subnormal};

/// A finite number of the kind, of type T.
template <class T>
T any_coordinate(random& r, spread kind) {
  switch (kind) {
    case spread::unit: return static_cast<T>(2 * r.unit() - 1);
    case spread::small_integers: return static_cast<T>(r.integer(-2, 2));
    case spread::tenths: return static_cast<T>(r.integer(0, 5)) * static_cast<T>(0.1);
    case spread::tiny_steps:
      return static_cast<T>(1) + static_cast<T>(r.integer(0, 4)) * std::numeric_limits<T>::epsilon();
    case spread::any_bits:
      for (;;) {
        T x;
        if constexpr (sizeof(T) == 4)
          x = std::bit_cast<T>(static_cast<std::uint32_t>(r.next()));
        else
          x = std::bit_cast<T>(r.next());
        if (std::isfinite(x)) return x;
      }
    case spread::wide:
      return static_cast<T>(
          std::ldexp(2 * r.unit() - 1, static_cast<int>(sizeof(T) == 4 ? r.integer(-100, 100) : r.integer(-800, 800))));
    case spread::subnormal: return static_cast<T>(r.integer(-9, 9)) * std::numeric_limits<T>::denorm_min();
  }
  return T(0);
}

}  // namespace test
