// SPDX-License-Identifier: MIT
// B-spline curves in rationals: in one stretch each basis function is a polynomial, made by Cox's and de Boor's recursion
// over lists of coefficients and differentiated term by term. Without GMP there is none.
#pragma once

#ifdef IRG_HAVE_MPFR
#include <cstddef>
#include <vector>

#include "support/big_rational.hpp"

namespace test {

using rational_polynomial = std::vector<big_rational>;

/// (p * (t - at) * sign) / width, for the lists of coefficients of p; zero where the width is.
inline rational_polynomial times_line(const rational_polynomial& p, double at, int sign, const big_rational& width) {
  rational_polynomial result(p.size() + 1, big_rational(0));
  if (width.sign() == 0) return result;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const big_rational c = p[i] * big_rational(sign) / width;
    result[i + 1] = result[i + 1] + c;
    result[i] = result[i] - c * big_rational(at);
  }
  return result;
}

/// The degree + 1 basis functions of the stretch from u[low] on, as polynomials: element k is that of u[low - degree + k].
inline std::vector<rational_polynomial> stretch_polynomials(const std::vector<double>& u, std::size_t degree,
                                                            std::size_t low) {
  std::vector<rational_polynomial> basis{{big_rational(1)}};
  for (std::size_t p = 1; p <= degree; ++p) {
    std::vector<rational_polynomial> next(p + 1, rational_polynomial(p + 1, big_rational(0)));
    for (std::size_t k = 0; k < p; ++k) {  // the function from knot low - p + 1 + k to low + 1 + k
      const double from = u[low - p + 1 + k], to = u[low + 1 + k];
      const big_rational width = big_rational(to) - big_rational(from);
      const auto up = times_line(basis[k], from, 1, width), down = times_line(basis[k], to, -1, width);
      for (std::size_t i = 0; i <= p; ++i) {
        next[k + 1][i] = next[k + 1][i] + up[i];
        next[k][i] = next[k][i] + down[i];
      }
    }
    basis = next;
  }
  return basis;
}

inline big_rational value_of(const rational_polynomial& p, double t, int derivative) {
  big_rational sum(0);
  for (std::size_t i = p.size(); i-- > static_cast<std::size_t>(derivative);) {
    big_rational c = p[i];
    for (int k = 0; k < derivative; ++k) c = c * big_rational(static_cast<int>(i) - k);
    sum = sum * big_rational(t) + c;
  }
  return sum;
}

/// One coordinate of the curve, or of a derivative, in the stretch that begins behind t (before it at the curve's end);
/// `coordinate(i)` is that of control point i.
template <class F>
big_rational spline_value(const std::vector<double>& u, std::size_t degree, double t, int derivative,
                          const F& coordinate) {
  const std::size_t count = u.size() - degree - 1;
  std::size_t low = degree;
  for (std::size_t i = degree; i < count; ++i)
    if (u[i] < u[i + 1] && (u[i] <= t || i == degree)) low = i;
  while (!(u[low] < u[low + 1])) ++low;
  const auto basis = stretch_polynomials(u, degree, low);
  big_rational sum(0);
  for (std::size_t k = 0; k <= degree; ++k)
    sum = sum + value_of(basis[k], t, derivative) * coordinate(low - degree + k);
  return sum;
}

}  // namespace test
#endif
