// SPDX-License-Identifier: MIT
// Systems of up to four linear equations in floats, decided exactly for the numbers as they are: one solution,
// correctly rounded, infinitely many, or none.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/exact_system.hpp>
#include <irg/math/solve.hpp>

namespace irg::inline IRG_ABI {

/// The solution of a(i, 0) x_0 + ... = a(i, N) for the exact values of the numbers.
/// gives   ok, dependent or inconsistent, never wrongly; not_finite when a number is NaN or infinite, or when a
///         component of the solution is too large for T
/// exact   the decision and the rank, for all finite numbers; each component of the solution is correctly rounded,
///         ties to even, subnormal ones too, however close to singular the system is
/// cost    N + 1 exact determinants of N! products: about 10 times solve_gauss for N = 3; singular systems take longer.
///         Up to a condition of 10^12 lu_solve_refined gives the same sooner: this is for worse and for singular ones
/// source  Cramer 1750, in exact sums
template <Floating T, int N, int M>
  requires(M == N + 1 && N <= 4)
[[nodiscard]] constexpr system_solution<T, N> solve_exact(const mat<T, N, M>& a) noexcept {
  if (!detail::entries_finite<T>(a, N, M)) return {};
  const auto entry = [&](int r, int c) { return widened(a(r, c)); };
  const detail::exact_system<N, decltype(entry)> system(entry);
  if (system.is_singular()) return detail::singular_solution<T, N>(entry, detail::is_nonzero_minor);
  system_solution<T, N> s{system_status::ok, N, {}};
  for (int k = 0; k < N; ++k) {
    s.x[k] = system.template component<T>(k);
    if (!is_finite(s.x[k])) return {system_status::not_finite, N, {}};
  }
  return s;
}

/// The solution of a * x = b for the exact values of the numbers.
/// gives   as for the rows of a with b behind them
/// exact   as for the rows of a with b behind them
/// cost    as for the rows of a with b behind them
template <Floating T, int N>
  requires(N <= 4)
[[nodiscard]] constexpr system_solution<T, N> solve_exact(const mat<T, N, N>& a, const vec<T, N>& b) noexcept {
  return solve_exact(generate_mat<T, N, N + 1>([&](int r, int c) { return c < N ? a(r, c) : b[r]; }));
}

}  // namespace irg::inline IRG_ABI
