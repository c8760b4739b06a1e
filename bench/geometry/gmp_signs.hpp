// SPDX-License-Identifier: MIT
// The predicates' true signs: determinants as they are defined, in GMP's integers. Without GMP nobody is judged.
#pragma once

#include <cstdint>
#include <type_traits>

#include "geometry/predicate_sets.hpp"

#ifdef IRG_HAVE_MPFR
#include <gmp.h>

namespace bench {

/// An integer of any size.
class big {
public:
  big() { mpz_init(value_); }
  big(const big& b) { mpz_init_set(value_, b.value_); }
  ~big() { mpz_clear(value_); }
  big& operator=(const big& b) {
    mpz_set(value_, b.value_);
    return *this;
  }
  /// significand * 2^exponent, exponent >= 0.
  void set(std::int64_t significand, int exponent) {
    mpz_set_si(value_, significand);
    mpz_mul_2exp(value_, value_, static_cast<mp_bitcnt_t>(exponent));
  }
  friend big operator-(const big& a, const big& b) { return apply(mpz_sub, a, b); }
  friend big operator+(const big& a, const big& b) { return apply(mpz_add, a, b); }
  friend big operator*(const big& a, const big& b) { return apply(mpz_mul, a, b); }
  int sign() const { return mpz_sgn(value_); }

private:
  template <class F>
  static big apply(F f, const big& a, const big& b) {
    big r;
    f(r.value_, a.value_, b.value_);
    return r;
  }
  mpz_t value_;
};

/// The determinant by its first row.
inline big determinant(const std::vector<std::vector<big>>& m) {
  if (m.size() == 1) return m[0][0];
  big sum;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::vector<std::vector<big>> rest(m.begin() + 1, m.end());
    for (auto& row : rest) row.erase(row.begin() + static_cast<std::ptrdiff_t>(k));
    const big term = m[0][k] * determinant(rest);
    sum = k % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

/// The coordinates times one power of two that makes integers of them.
template <class T, int N, int D>
std::vector<std::vector<big>> as_integers(const arguments<T, N, D>& call) {
  std::vector<std::vector<big>> p(call.size(), std::vector<big>(call[0].size()));
  int least = 2000;
  const auto parts = [](T x, int& exponent) {
    exponent = 0;
    if constexpr (std::is_floating_point_v<T>)
      return static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    else
      return x;
  };
  int exponent = 0;
  for (const auto& point : call)
    for (const T c : point)
      if (parts(c, exponent) != 0) least = std::min(least, exponent);
  for (std::size_t i = 0; i < call.size(); ++i)
    for (std::size_t j = 0; j < call[i].size(); ++j) {
      const std::int64_t significand = parts(call[i][j], exponent);
      if (significand != 0) p[i][j].set(significand, exponent - least);
    }
  return p;
}

/// N = D + 1: on which side of the first D points the last one lies. N = D + 2: 1 inside of the circle or sphere
/// through the first D + 1, if these are in positive order.
template <class T, int N, int D>
int true_sign(const arguments<T, N, D>& call) {
  const auto p = as_integers<T, N, D>(call);
  constexpr std::size_t size = static_cast<std::size_t>(N) - 1;
  // Rows of differences from the last point; each exchange to bring it there is accounted for by the sign at the end.
  std::vector<std::vector<big>> m(size, std::vector<big>(size));
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < static_cast<std::size_t>(D); ++j) {
      m[i][j] = p[i][j] - p.back()[j];
      if (N == D + 2) m[i].back() = m[i].back() + m[i][j] * m[i][j];
    }
  const int sign = determinant(m).sign();
  return D == 3 ? -sign : sign;
}

}  // namespace bench
#endif
