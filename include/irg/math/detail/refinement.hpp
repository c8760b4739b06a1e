// SPDX-License-Identifier: MIT
// What the accurate solvers share: a system whose rows and columns are scaled by powers of two to be of one size, and
// residuals in twice the precision.
#pragma once

#include <irg/math/float_bits.hpp>
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

// What equilibrate goes by: the largest entries of rows and columns, which never makes a condition number much larger;
// or before that the means of their exponents, which finds factors that are hidden in rows and columns alike.
enum class scaling { by_largest, by_means };

// What equilibrate leaves: how many entries are zero, and the least of the others, below 1.
struct scaled_sizes {
  int zeros = 0;
  double least = 1;
  IRG_INLINE constexpr bool has_small() const noexcept { return least < 0x1p-8; }
  IRG_INLINE constexpr bool is_mixed() const noexcept { return zeros != 0 || has_small(); }
  // Whether another scaling might show that a matrix which looks singular is far from it. Up to size 4 that takes an
  // entry far below the others, or a block of zeros beside two blocks that are near singular both.
  IRG_INLINE constexpr bool may_hide_regular() const noexcept { return zeros >= 4 || least < 0x1p-10; }
};

// a = the matrix with row i times 2^-row_exponent[i] and column j times 2^-column_exponent[j], as equilibrate makes it.
template <int N>
struct scaled_system {
  mat<double, N, N> a{};
  lu_factors<double, N> factors{};
  double inverse_pivot[static_cast<std::size_t>(N)]{};
  int row_exponent[static_cast<std::size_t>(N)]{}, column_exponent[static_cast<std::size_t>(N)]{};
  scaled_sizes sizes;
  bool has_factors = false;
};

inline namespace IRG_ABI {

// Of the exponents of those of n finite numbers c(i) times 2^-e(i) that are not zero: the largest and the mean.
struct exponent_range {
  int largest = -10000, sum = 0, count = 0;
  IRG_INLINE constexpr int top() const noexcept { return count == 0 ? 0 : largest; }
  IRG_INLINE constexpr int mean() const noexcept { return count == 0 ? 0 : sum / count; }
};
template <class C, class E>
constexpr exponent_range exponents_of(int n, const C& c, const E& e) noexcept {
  exponent_range range;
  for (int i = 0; i < n; ++i)
    if (const double x = c(i); x != 0) {
      const int exponent = exponent_of(x) - e(i);
      range.largest = maximum(range.largest, exponent);
      range.sum += exponent;
      ++range.count;
    }
  return range;
}

// Brings rows and columns of n x n finite entries to one size: the largest of a row is below 2, that of a column in
// [1, 2), unless they are zero. The exponents that were taken away go to the two lists.
// source  van der Sluis 1969: rows of one size make the condition number at most n times what any others make it, then
//         columns do; both figures hold for powers of two within a factor 2
template <class M>
constexpr scaled_sizes equilibrate(M& a, int n, int* row_exponent, int* column_exponent,
                                   scaling way = scaling::by_largest) noexcept {
  const auto row = [&](int r) {
    return exponents_of(n, [&](int c) { return a(r, c); }, [&](int c) { return column_exponent[c]; });
  };
  const auto column = [&](int c) {
    return exponents_of(n, [&](int r) { return a(r, c); }, [&](int r) { return row_exponent[r]; });
  };
  for (int c = 0; c < n; ++c) column_exponent[c] = 0;
  for (int pass = 0; pass < 3 && way == scaling::by_means; ++pass) {
    for (int r = 0; r < n; ++r) row_exponent[r] = row(r).mean();
    for (int c = 0; c < n; ++c) column_exponent[c] = column(c).mean();
  }
  for (int r = 0; r < n; ++r) row_exponent[r] = row(r).top();
  scaled_sizes sizes;
  for (int c = 0; c < n; ++c) {
    column_exponent[c] = column(c).top();
    for (int r = 0; r < n; ++r) {
      if (a(r, c) == 0) {
        ++sizes.zeros;
        continue;
      }
      a(r, c) = times_power_of_two(a(r, c), -row_exponent[r] - column_exponent[c]);
      sizes.least = minimum(magnitude(a(r, c)), sizes.least);
    }
  }
  return sizes;
}

// Makes of n finite numbers b(i) the right side that belongs to the scaled rows, times 2^-shift, which keeps it inside
// the range; returns shift.
template <class B>
constexpr int scale_right_side(int n, const B& b, const int* row_exponent) noexcept {
  const int shift = exponents_of(n, b, [&](int i) { return row_exponent[i]; }).top() - 500;
  for (int i = 0; i < n; ++i) b(i) = times_power_of_two(b(i), -row_exponent[i] - shift);
  return shift;
}

// Whether a number of the right side, which scale_right_side made `scaled` of, has become small.
IRG_INLINE constexpr bool is_small_beside_largest(double number, double scaled) noexcept {
  return number != 0 && magnitude(scaled) < 0x1p492;
}

template <int N>
constexpr double largest_of(const vec<double, N>& v) noexcept {
  double largest = 0;
  for (int i = 0; i < N; ++i) {
    if (!(v[i] == v[i])) return v[i];
    largest = maximum(magnitude(v[i]), largest);
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
