// SPDX-License-Identifier: MIT
// The error bounds of curves where control points, knots, weights and parameters are of all sizes: each a random number
// times 2^k, k from the whole range of exponents, or one of them far below or above the others.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <irg/curve/bezier.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/math/vec.hpp>

#include "support/mixed_magnitudes.hpp"

#ifdef IRG_HAVE_MPFR

namespace {

using irg::point;
using E = test::big_rational;
using test::mixed::number;
using test::mixed::rational;
using test::mixed::sizes;
using test::mixed::sweep;

constexpr double wrong = 1e9;

template <class T>
std::string named(const char* what) {
  return std::string(what) + (sizeof(T) == 4 ? ", float" : ", double");
}

// |off| / bound.
double share(const E& off, const E& bound) {
  if (off.sign() == 0) return 0;
  if (bound.sign() == 0) return wrong;
  const E scaled = abs(off).times_power_of_two(-bound.exponent());
  return scaled.rounded() / bound.times_power_of_two(-bound.exponent()).rounded();
}

// In [0, 1]: anywhere, or of any size below.
template <class T>
T parameter(test::random& r, sizes which) {
  const T t = r.integer(0, 2) == 0 ? static_cast<T>(r.unit()) : std::fabs(number<T>(r, which));
  return t <= 1 ? t : 1 / t;
}

// The Bernstein polynomials by their definition.
template <class T>
E bernstein_by_powers(int n, int i, T t) {
  E value = 1;
  for (int k = 1; k <= i; ++k) value = value * E(n - i + k) / E(k) * rational(t);
  for (int k = 0; k < n - i; ++k) value = value * (E(1) - rational(t));
  return value;
}

template <class T>
const E& unit_roundoff() {
  static const E u = rational(std::numeric_limits<T>::epsilon() / 2);
  return u;
}
template <class T>
const E& smallest() {
  static const E least = rational(std::numeric_limits<T>::denorm_min());
  return least;
}

}  // namespace

TEST_CASE_TEMPLATE("mixed magnitudes: Bezier curves, of their bounds", T, double, float) {
  constexpr int degree = 3;
  sweep(
      named<T>("bezier_point"), 1,
      [](test::random& r, sizes which) {
        std::array<point<T, 2>, degree + 1> b;
        for (auto& p : b) p = {number<T>(r, which), number<T>(r, which)};
        const T t = parameter<T>(r, which);
        const auto got = bezier_point(b, t);
        double worst = 0;
        for (int k = 0; k < 2; ++k) {
          E sum = 0, largest = 0;
          for (int i = 0; i <= degree; ++i) {
            const E c = rational(b[static_cast<std::size_t>(i)][k]);
            sum = sum + bernstein_by_powers(degree, i, t) * c;
            if (largest < abs(c)) largest = abs(c);
          }
          if (!std::isfinite(got[k])) return wrong;
          const E bound = unit_roundoff<T>() * E(3 * degree) * largest + smallest<T>() * E(degree);
          worst = std::fmax(worst, share(rational(got[k]) - sum, bound));
        }
        return worst;
      },
      3000);
  sweep(
      named<T>("bernstein_basis and bernstein"), 1,
      [](test::random& r, sizes which) {
        constexpr int n = 5;
        const T t = parameter<T>(r, which);
        const auto basis = irg::bernstein_basis<n>(t);
        double worst = 0;
        for (int i = 0; i <= n; ++i) {
          const E want = bernstein_by_powers(n, i, t);
          const T by_recursion = basis[static_cast<std::size_t>(i)], by_powers = irg::bernstein(n, i, t);
          if (!(by_recursion >= 0 && by_powers >= 0)) return wrong;
          if (want < rational(std::numeric_limits<T>::min()) * 2) continue;  // factors underflow
          worst = std::fmax(worst, share(rational(by_recursion) - want, unit_roundoff<T>() * E(2 * n) * want));
          worst = std::fmax(worst, share(rational(by_powers) - want, unit_roundoff<T>() * E(4 * n) * want));
        }
        return worst;
      },
      3000);
}

TEST_CASE_TEMPLATE("mixed magnitudes: sums of spline bases, of their bound", T, double, float) {
  constexpr int degree = 3;
  const auto off_from_one = [](const auto& values) {
    E sum = -1;
    for (const T v : values) {
      if (!(v >= 0)) return wrong;
      sum = sum + rational(v);
    }
    return share(sum, unit_roundoff<T>() * E(4));
  };
  sweep(named<T>("bspline_basis and nurbs_basis"), 1, [&](test::random& r, sizes which) {
    std::vector<T> u(static_cast<std::size_t>(r.integer(8, 14)));
    for (T& v : u) v = number<T>(r, which);
    for (std::size_t i = 1; i < u.size(); ++i)
      if (r.integer(0, 3) == 0) u[i] = u[i - 1];
    std::sort(u.begin(), u.end());
    const auto knots = irg::make_bspline_knots<degree>(std::span<const T>(u));
    if (!knots) return 0.0;
    T t = r.integer(0, 1) == 0 ? u[static_cast<std::size_t>(r.integer(0, 7))] : number<T>(r, which);
    t = std::clamp(t, knots->first(), knots->last());
    const auto basis = bspline_basis(*knots, t);
    if (!basis) return wrong;
    std::vector<T> weights(knots->size());
    for (T& w : weights) w = std::fabs(number<T>(r, sizes::all));
    const auto rational_basis = nurbs_basis(*knots, std::span<const T>(weights), t);
    const double plain = off_from_one(basis->value);
    return rational_basis ? std::fmax(plain, off_from_one(rational_basis->value)) : plain;
  });
}

#endif
