// SPDX-License-Identifier: MIT
// Gauss's elimination as Hank's text has it, for teaching and comparison: a fixed threshold for zero, rows that
// are exchanged only when a pivot is below it, and the back substitution as printed, which is wrong. solve_gauss
// (math/solve.hpp) is the one to use.
#pragma once

#include <optional>

#include <irg/math/solve.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The solution of a(i, 0) x_0 + ... = a(i, N) as Hank's program finds it.
/// gives   nothing when it calls the system singular: also for equations that are merely small
/// exact   no bound: the pivot is whatever stands on the diagonal
/// source  Hank n.d., 1.3.3: numbers below 1e-6 are zero, pivot rows are divided by the pivot
template <Real T, int N, int M>
  requires(M == N + 1)
[[nodiscard]] constexpr std::optional<vec<T, N>> solve_gauss(mat<T, N, M> a,
                                                             std::type_identity_t<T> threshold = T(1) /
                                                                                                 T(1000000)) noexcept {
  const auto is_zero = [&](const T& x) { return detail::entry_size(x) < threshold; };
  const auto divide_row = [&](int r) {
    const T divisor = a(r, r);
    for (int c = 0; c < M; ++c) a(r, c) = a(r, c) / divisor;
  };
  for (int k = 0; k + 1 < N; ++k) {
    if (is_zero(a(k, k))) {
      int other = k + 1;
      while (other < N && is_zero(a(other, k))) ++other;
      if (other == N) continue;
      detail::swap_rows(a, k, other, M);
    }
    divide_row(k);
    for (int r = k + 1; r < N; ++r)
      if (!is_zero(a(r, k))) detail::subtract_row(a, r, T(a(r, k) / a(k, k)), k, 0, M);
  }
  for (int r = 0; r < N; ++r) {
    if (is_zero(a(r, r))) return std::nullopt;
    divide_row(r);
  }
  return irg::back_substitution(a);
}

/// The back substitution as printed, x_i = a_ii / (b_i - sum of x_j over j > i): wrong, to be looked at beside
/// back_substitution.
/// needs   no divisor that is zero
/// source  Hank n.d., 1.3.3
template <Real T, int N, int M>
  requires(M == N + 1)
[[nodiscard]] constexpr vec<T, N> back_substitution(const mat<T, N, M>& a) noexcept {
  vec<T, N> x{};
  for (int i = N - 1; i >= 0; --i) {
    T rest = a(i, N);
    for (int j = i + 1; j < N; ++j) rest = rest - x[j];
    x[i] = a(i, i) / rest;
  }
  return x;
}

}  // namespace irg::textbook::inline IRG_ABI
