// SPDX-License-Identifier: MIT
// What the accurate solvers share: a system whose rows and columns are scaled by powers of two to be of one size, and
// residuals in twice the precision.
#pragma once

#include <irg/math/detail/float_bits.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/mat.hpp>

namespace irg {

/// L and U with L*U = a, its rows in another order.
/// shape   U on and above the diagonal of lu, L below it, with ones on its diagonal that are not stored; row i of L*U
///         is row order[i] of the matrix
template <Real T, int N>
struct lu_factors {
  mat<T, N, N> lu{};
  int order[static_cast<std::size_t>(N)]{};
};

namespace detail {

// a = the matrix with row i times 2^-row_exponent[i] and column j times 2^-column_exponent[j], as equilibrate makes it.
template <int N>
struct scaled_system {
  mat<double, N, N> a{};
  lu_factors<double, N> factors{};
  int row_exponent[static_cast<std::size_t>(N)]{}, column_exponent[static_cast<std::size_t>(N)]{};
};

inline namespace IRG_ABI {

// Of the exponents of those of n finite numbers c(i) times 2^-e(i) that are not zero: their limits and mean.
struct exponent_range {
  int smallest = 10000, largest = -10000, sum = 0, count = 0;
  IRG_INLINE constexpr int top() const noexcept { return count == 0 ? 0 : largest; }
  IRG_INLINE constexpr int mean() const noexcept { return count == 0 ? 0 : sum / count; }
};
template <class C, class E>
constexpr exponent_range exponents_of(int n, const C& c, const E& e, exponent_range range = {}) noexcept {
  for (int i = 0; i < n; ++i)
    if (const double x = c(i); x != 0) {
      const int exponent = exponent_of(x) - e(i);
      range.largest = greater(range.largest, exponent);
      range.smallest = lesser(range.smallest, exponent);
      range.sum += exponent;
      ++range.count;
    }
  return range;
}

// Brings rows and columns of n x n finite entries to one size: by their means first, which finds factors that are
// hidden in rows and columns alike, then so that the largest of a row is below 2, that of a column in [1, 2), unless
// they are zero. The exponents that were taken away go to the two lists.
template <class M>
constexpr void equilibrate(M& a, int n, int* row_exponent, int* column_exponent) noexcept {
  const auto row = [&](int r, const exponent_range& start = {}) {
    return exponents_of(n, [&](int c) { return a(r, c); }, [&](int c) { return column_exponent[c]; }, start);
  };
  const auto column = [&](int c) {
    return exponents_of(n, [&](int r) { return a(r, c); }, [&](int r) { return row_exponent[r]; });
  };
  exponent_range all;
  for (int c = 0; c < n; ++c) column_exponent[c] = 0;
  for (int r = 0; r < n; ++r) all = row(r, all);
  for (int pass = 0; pass < 3 && all.largest - all.smallest > 8; ++pass) {
    for (int r = 0; r < n; ++r) row_exponent[r] = row(r).mean();
    for (int c = 0; c < n; ++c) column_exponent[c] = column(c).mean();
  }
  for (int r = 0; r < n; ++r) row_exponent[r] = row(r).top();
  for (int c = 0; c < n; ++c) {
    column_exponent[c] = column(c).top();
    for (int r = 0; r < n; ++r) a(r, c) = times_power_of_two(a(r, c), -row_exponent[r] - column_exponent[c]);
  }
}

// Makes of n finite numbers b(i) the right side that belongs to the scaled rows, times 2^-shift, which keeps it inside
// the range; returns shift.
template <class B>
constexpr int scale_right_side(int n, const B& b, const int* row_exponent) noexcept {
  const int shift = exponents_of(n, b, [&](int i) { return row_exponent[i]; }).top() - 500;
  for (int i = 0; i < n; ++i) b(i) = times_power_of_two(b(i), -row_exponent[i] - shift);
  return shift;
}

template <int N>
constexpr double largest_of(const vec<double, N>& v) noexcept {
  double largest = 0;
  for (int i = 0; i < N; ++i) {
    if (!(v[i] == v[i])) return v[i];
    largest = greater(magnitude(v[i]), largest);
  }
  return largest;
}

// b - a * (x + tail), summed in twice the precision.
template <int N>
constexpr vec<double, N> residual_of(const mat<double, N, N>& a, const vec<double, N>& b, const vec<double, N>& x,
                                     const vec<double, N>& tail) noexcept {
  return generate_coordinates<vec<double, N>>([&](int i) {
    double sum = b[i], error = 0;
    for (int j = 0; j < N; ++j) {
      const auto term = two_product(a(i, j), x[j]);
      const auto next = two_sum(sum, -term.value);
      error += next.error - (term.error + product(a(i, j), tail[j]));
      sum = next.value;
    }
    return sum + error;
  });
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
