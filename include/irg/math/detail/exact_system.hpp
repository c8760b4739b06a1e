// SPDX-License-Identifier: MIT
// The solution and the inverse of up to four equations from exact determinants, entry by entry: what solve_exact and
// inverse_exact consist of, and what the solvers in double go back to where rounding may have spoiled a result.
#pragma once

#include <bit>
#include <cstddef>

#include <irg/math/detail/exact_minors.hpp>
#include <irg/math/mat.hpp>

namespace irg::detail::inline IRG_ABI {

// The first n bits.
template <int N>
inline constexpr unsigned all_of = (1u << N) - 1;

// A matrix of finite doubles entry(row, column), and its determinant; column N is a right side.
template <int N, class E>
class exact_system {
public:
  constexpr explicit exact_system(const E& entry) noexcept : entry_(entry), sum_(exact_determinant<N>(entry)) {
    if (!is_singular()) divisor_ = scaled_parts(sum_);
  }

  constexpr bool is_singular() const noexcept { return sum_.sign() == 0; }

  /// Component k of the solution, correctly rounded.
  /// needs   a matrix that is not singular
  /// source  Cramer 1750
  template <Floating T>
  IRG_NOINLINE constexpr T component(int k) const noexcept {
    return nearest<T>(exact_determinant<N>([&](int r, int c) { return entry_(r, c == k ? N : c); }));
  }

  /// An entry of the inverse, correctly rounded.
  /// needs   a matrix that is not singular
  template <Floating T>
  constexpr T inverse_entry(int r, int c) const noexcept {
    const T size = nearest<T>(minor_beside(c, r));
    return (r + c) % 2 == 0 || size == 0 ? size : -size;
  }

  /// Whether no change of the entries of a column by `part` of their sizes makes the matrix singular. It does not
  /// depend on how rows and columns are scaled, and holds where any scaling has a condition number below 1 / part.
  /// needs   a matrix that is not singular
  constexpr bool is_regular_within(double part) const noexcept {
    for (int c = 0; c < N; ++c) {
      double condition = 0;  // the sum of |x(c, r) * a(r, c)| over r, for x = the inverse
      for (int r = 0; r < N; ++r) {
        const auto minor = minor_beside(r, c);
        if (entry_(r, c) == 0 || minor.sign() == 0) continue;
        const auto above = scaled_parts(minor);
        const scaled_number factor = decompose(entry_(r, c));
        const double size = product(magnitude(factor.significand), magnitude(above.parts.value / divisor_.parts.value));
        condition += times_power_of_two(size, factor.exponent + above.exponent - divisor_.exponent);
      }
      if (!(product(condition, part) < 1)) return false;
    }
    return true;
  }

private:
  const E& entry_;
  exact_accumulator<N> sum_;
  scaled_sum<N> divisor_;

  // The determinant without row r and column c.
  constexpr auto minor_beside(int r, int c) const noexcept {
    if constexpr (N == 1) {
      exact_accumulator<1> one;
      one.add(1.0);
      return one;
    } else {
      return exact_determinant<N - 1>([&](int i, int j) { return entry_(i < r ? i : i + 1, j < c ? j : j + 1); });
    }
  }
  template <Floating T, int K>
  constexpr T nearest(const exact_accumulator<K>& above) const noexcept {
    return above.sign() == 0 ? T(0) : quotient_of_sums<T>(scaled_parts(above), divisor_);
  }
};

// Puts components of the solution of a * x = b into x, those whose bits are set in `which`; for all of them the matrix
// must be regular_within `part`. False when it is not, or is singular.
template <Floating T, int N>
IRG_NOINLINE constexpr bool put_exact_solution(const mat<double, N, N>& a, const vec<double, N>& b, unsigned which,
                                               double part, vec<T, N>& x) noexcept {
  const auto entry = [&](int r, int c) { return c < N ? a(r, c) : b[r]; };
  const exact_system<N, decltype(entry)> system(entry);
  if (system.is_singular()) return false;
  if (which == all_of<N> && !system.is_regular_within(part)) return false;
  for (int k = 0; k < N; ++k)
    if ((which >> k & 1) != 0) x[k] = system.template component<T>(k);
  return true;
}

// Whether the minor beside row r and column c of N x N numbers is zero because each of its products has a factor
// that is: whether some rows have fewer columns than they are that are not zero (Hall 1935). Bit j of nonzero[i] is
// column j.
template <int N>
constexpr bool is_zero_by_pattern(const unsigned (&nonzero)[static_cast<std::size_t>(N)], int r, int c) noexcept {
  for (unsigned rows = 1; rows < 1u << N; ++rows) {
    if ((rows >> r & 1) != 0) continue;
    unsigned columns = 0;
    for (int i = 0; i < N; ++i)
      if ((rows >> i & 1) != 0) columns |= nonzero[i];
    if (std::popcount(columns & ~(1u << c)) < std::popcount(rows)) return true;
  }
  return false;
}

// The same for the entries of the inverse; entry (r, c) is bit r N + c.
template <Floating T, int N>
IRG_NOINLINE constexpr bool put_exact_inverse(const mat<double, N, N>& a, unsigned which, double part,
                                              mat<T, N, N>& x) noexcept {
  unsigned nonzero[static_cast<std::size_t>(N)]{};
  for (int i = 0; i < N * N; ++i) nonzero[i / N] |= a(i / N, i % N) != 0 ? 1u << (i % N) : 0;
  const bool is_certain = which != all_of<N * N>;
  for (int i = 0; is_certain && i < N * N; ++i)
    if ((which >> i & 1) != 0 && is_zero_by_pattern<N>(nonzero, i % N, i / N)) {
      x(i / N, i % N) = T(0);
      which &= ~(1u << i);
    }
  if (which == 0) return true;
  const auto entry = [&](int r, int c) { return a(r, c); };
  const exact_system<N, decltype(entry)> system(entry);
  if (system.is_singular() || !(is_certain || system.is_regular_within(part))) return false;
  for (int i = 0; i < N * N; ++i)
    if ((which >> i & 1) != 0) x(i / N, i % N) = system.template inverse_entry<T>(i / N, i % N);
  return true;
}

}  // namespace irg::detail::inline IRG_ABI
