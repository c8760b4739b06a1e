// SPDX-License-Identifier: MIT
// Systems of n linear equations for n unknowns, given as n rows of n coefficients and a right side, by Gauss's
// elimination with full pivoting. Singular systems are told apart: infinitely many solutions, or none.
// solve_exact (math/solve_exact.hpp) decides that exactly for floats.
#pragma once

#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/exact_system.hpp>
#include <irg/math/detail/refinement.hpp>
#include <irg/math/mat.hpp>

namespace irg {

/// What a system of linear equations has.
enum class [[nodiscard]] system_status {
  ok,  ///< one solution
  dependent,  ///< infinitely many: its equations depend on each other
  inconsistent,  ///< none: its equations contradict each other
  not_finite,  ///< a number is NaN or infinite, or the solution is too large
  unique [[deprecated("irg: unique is now ok")]] = ok
};

/// The answer to a system of N linear equations.
/// shape   x is the solution when status is ok, else zero; rank counts the independent rows of coefficients
template <Scalar T, int N>
struct system_solution {
  system_status status = system_status::not_finite;
  int rank = 0;
  vec<T, N> x{};

  /// Whether there is one solution.
  IRG_INLINE constexpr explicit operator bool() const noexcept { return status == system_status::ok; }
  bool operator==(const system_solution&) const = default;
};

namespace detail {

struct eliminated {
  system_status status;
  int rank;
};

inline namespace IRG_ABI {

// Eliminates n rows of n + 1 entries, of one size by equilibrate if they are floats, with full pivoting, until the
// largest entry left is at most `smallest` times the first pivot. column, of 2 n numbers, begins with the unknown of
// each pivot; largest_term, of n numbers, times u bounds the rounding noise of each right side.
template <class T, class M>
constexpr eliminated eliminate_fully(M& a, int n, int* column, T* largest_term, const T& smallest) noexcept {
  int* is_changed = column + n;  // whether a row is no more what it was
  const auto exchange = [](auto& x, auto& y) {
    const auto kept = x;
    x = y;
    y = kept;
  };
  for (int i = 0; i < n; ++i) {
    column[i] = i;
    is_changed[i] = 0;
    largest_term[i] = entry_size(a(i, n));
  }
  T first = T(0);
  for (int k = 0; k < n; ++k) {
    int row = k, unknown = k;
    for (int r = k; r < n; ++r)
      for (int c = k; c < n; ++c)
        if (entry_size(a(row, unknown)) < entry_size(a(r, c))) {
          row = r;
          unknown = c;
        }
    const T pivot = a(row, unknown);
    if (k == 0) first = entry_size(pivot);
    if (!(product(first, smallest) < entry_size(pivot))) {
      for (int r = k; r < n; ++r)
        if (product(largest_term[r], smallest) < entry_size(a(r, n))) return {system_status::inconsistent, k};
      return {system_status::dependent, k};
    }
    swap_rows(a, k, row, n + 1);
    exchange(largest_term[k], largest_term[row]);
    exchange(is_changed[k], is_changed[row]);
    for (int r = 0; r < n && unknown != k; ++r) swap_entries(a, r, k, r, unknown);
    exchange(column[k], column[unknown]);
    for (int r = k + 1; r < n; ++r) {
      const T f = a(r, k) / pivot;
      if constexpr (Floating<T>) {  // the f of a row that has been changed is uncertain by u * first / pivot
        const T part = is_changed[r] != 0 ? first / entry_size(pivot) : entry_size(f);
        largest_term[r] = maximum(product(largest_term[k], part), largest_term[r]);
        if (f != T(0)) is_changed[r] = 1;
      }
      subtract_row(a, r, f, k, k, n + 1);
    }
  }
  return {system_status::ok, n};
}

// The same whatever sizes rows and columns have: beside each entry, in units of u, stands what its rounding and that of
// the steps that made it may amount to, and an entry counts as zero where it is at most `smallest` / u times that.
// n rows of n + 1 doubles; noise is of the same size, column of n numbers.
template <class M>
constexpr eliminated eliminate_certainly(M& a, M& noise, int n, int* column, double smallest) noexcept {
  const auto is_certain = [&](int r, int c) { return product(noise(r, c), smallest) < entry_size(a(r, c)); };
  for (int r = 0; r < n; ++r) {
    column[r] = r;
    for (int c = 0; c <= n; ++c) noise(r, c) = entry_size(a(r, c));
  }
  for (int k = 0; k < n; ++k) {
    int row = n, unknown = k;
    for (int r = k; r < n; ++r)
      for (int c = k; c < n; ++c)
        if (is_certain(r, c) && (row == n || entry_size(a(row, unknown)) < entry_size(a(r, c)))) {
          row = r;
          unknown = c;
        }
    if (row == n) {
      for (int r = k; r < n; ++r)
        if (is_certain(r, n)) return {system_status::inconsistent, k};
      return {system_status::dependent, k};
    }
    swap_rows(a, k, row, n + 1);
    swap_rows(noise, k, row, n + 1);
    for (int r = 0; r < n && unknown != k; ++r) {
      swap_entries(a, r, k, r, unknown);
      swap_entries(noise, r, k, r, unknown);
    }
    const int kept = column[k];
    column[k] = column[unknown];
    column[unknown] = kept;
    const double pivot = a(k, k), size = entry_size(pivot);
    for (int r = k + 1; r < n; ++r) {
      if (noise(r, k) == 0) continue;  // a zero that no step has touched
      const double f = a(r, k) / pivot, f_size = entry_size(f);
      const double f_noise = noise(r, k) / size + product(f_size, noise(k, k) / size);
      for (int c = k + 1; c <= n; ++c)
        noise(r, c) = noise(r, c) + product(f_size, noise(k, c)) + product(f_noise, entry_size(a(k, c)));
      subtract_row(a, r, f, k, k, n + 1);
    }
  }
  return {system_status::ok, n};
}

// The unknown of row i of n rows that are zero left of the diagonal, from those of the rows below.
template <class T, class M, class X>
constexpr T substituted(const M& a, int i, int n, const X& x) noexcept {
  T right = a(i, n);
  for (int j = i + 1; j < n; ++j) right = right - product(a(i, j), x(j));
  return right / a(i, i);
}

// Part of its size by which a system of doubles may differ from a singular one and be taken for it.
constexpr double smallest_pivot(int n) noexcept { return 4.0 * n * 0x1p-53; }

// The solution of n rows that elimination has left, in the order of `column`.
template <class T, class M, class X>
constexpr void substitute(const M& a, int n, const int* column, const X& x) noexcept {
  for (int i = n - 1; i >= 0; --i) x(column[i]) = substituted<T>(a, i, n, [&](int j) { return x(column[j]); });
}

// Undoes the scaling of the columns, and of the right side.
template <class X>
constexpr void scale_solution(int n, int shift, const int* column_exponent, const X& x) noexcept {
  for (int i = 0; i < n; ++i) x(i) = times_power_of_two(x(i), shift - column_exponent[i]);
}

// Work space for n rows: 2 n numbers each of the first two, n of the last.
template <class T>
struct elimination_space {
  int *column, *exponents;
  T* largest_term;
};

// Solves n rows of n + 1 finite numbers entry(r, c), which `a` holds, by elimination: the solution goes to x(0) to
// x(n - 1). Doubles that seem singular are eliminated again with a bound of each entry's noise, in a copy of `a`.
template <class T, class M, class E, class X>
constexpr eliminated solve_rows(M& a, const E& entry, int n, const elimination_space<T>& space,
                                const X& x) noexcept(std::is_nothrow_copy_constructible_v<M>) {
  const auto [column, exponents, largest_term] = space;
  if constexpr (!Floating<T>) {
    const eliminated result = eliminate_fully(a, n, column, largest_term, T(0));
    if (result.status == system_status::ok) substitute<T>(a, n, column, x);
    return result;
  } else {
    static_assert(std::same_as<T, double>, "floats are solved in double");
    const auto right = [&](int i) -> T& { return a(i, n); };
    equilibrate(a, n, exponents, exponents + n);
    int shift = scale_right_side(n, right, exponents);
    eliminated result = eliminate_fully(a, n, column, largest_term, smallest_pivot(n));
    if (result.status != system_status::ok) {
      for (int r = 0; r < n; ++r)
        for (int c = 0; c <= n; ++c) a(r, c) = entry(r, c);
      equilibrate(a, n, exponents, exponents + n, scaling::by_means);
      shift = scale_right_side(n, right, exponents);
      M noise = a;
      result = eliminate_certainly(a, noise, n, column, smallest_pivot(n));
    }
    if (result.status != system_status::ok) return result;
    substitute<T>(a, n, column, x);
    scale_solution(n, shift, exponents + n, x);
    return result;
  }
}

// Whether x solves equations that differ from those of `a` by few roundings of each number: then its error is as small
// as any scaling of rows and columns lets one expect (Oettli and Prager 1964). False, too, where all terms of an
// equation are so small that underflow has cost digits, if has_small() says that there were numbers of very
// different sizes.
template <int N, class S>
constexpr bool fits_every_row(const mat<double, N, N + 1>& a, const double* x, const S& has_small) noexcept {
  bool all = true;
  double least = 1;
  for (int r = 0; r < N; ++r) {
    double rest = a(r, N), size = magnitude(a(r, N));
    for (int c = 0; c < N; ++c) {
      const double term = product(a(r, c), x[c]);
      rest = rest - term;
      size = size + magnitude(term);
    }
    all &= magnitude(rest) <= product(size, 4 * 0x1p-53);
    least = minimum(size, least);
  }
  return all && (least >= 0x1p-400 || !has_small());
}

// What N equations with finite doubles entry(r, c) have that are singular, if is_regular tells which minors are not.
template <Floating T, int N, class E, class P>
constexpr system_solution<T, N> singular_solution(const E& entry, const P& is_regular) noexcept {
  const int rank = rank_by_minors<N - 1>(N, N, entry, is_regular);
  const bool is_consistent = rank_by_minors<N>(N, N + 1, entry, is_regular) == rank;
  return {is_consistent ? system_status::dependent : system_status::inconsistent, rank, {}};
}

// What elimination found of up to four equations, or what they have under the best of all scalings where that may be
// another thing: where it does not fit every row, and where it sees singular equations and zeros or small entries may
// have misled it. What changes of the numbers by their rounding could make is taken for made: the exact determinants
// of 0.1, 0.7 and 0.3, 2.1 would tell how these were rounded, not what they stand for.
template <Floating T, int N, class E>
IRG_NOINLINE constexpr system_solution<T, N> mended(const E& entry, const system_solution<T, N>& found) noexcept {
  const exact_system<N, E> system(entry);
  if (!system.is_singular() && system.is_regular_within(smallest_pivot(N))) {
    system_solution<T, N> s{system_status::ok, N, {}};
    for (int k = 0; k < N; ++k) s.x[k] = system.template component<T>(k);
    return s;
  }
  if (found && !system.is_singular()) return found;
  return singular_solution<T, N>(entry, []<class M, int K>(const M& minor, std::integral_constant<int, K>) {
    const exact_system<K, M> part(minor);
    return !part.is_singular() && part.is_regular_within(smallest_pivot(N));
  });
}

template <Floating T, int N>
constexpr system_solution<T, N> solve_up_to_four(const mat<T, N, N + 1>& a) noexcept {
  const auto entry = [&](int r, int c) { return widened(a(r, c)); };
  auto rows = generate_mat<double, N, N + 1>(entry);
  if (!entries_finite<double>(rows, N, N + 1)) return {};
  int column[2 * static_cast<std::size_t>(N)]{}, exponents[2 * static_cast<std::size_t>(N)]{};
  double largest_term[static_cast<std::size_t>(N)]{}, x[static_cast<std::size_t>(N)]{};
  const auto unknown = [&](int i) -> double& { return x[i]; };
  const scaled_sizes sizes = equilibrate(rows, N, exponents, exponents + N);
  const int shift = scale_right_side(N, [&](int i) -> double& { return rows(i, N); }, exponents);
  const mat<double, N, N + 1> scaled = rows;
  const eliminated result = eliminate_fully(rows, N, column, largest_term, smallest_pivot(N));
  system_solution<T, N> found{result.status, result.rank, {}};
  bool is_doubtful = sizes.may_hide_regular();
  if (found) {
    substitute<double>(rows, N, column, unknown);
    is_doubtful = !fits_every_row(scaled, x, [&] {
      bool any = sizes.has_small();
      for (int i = 0; i < N; ++i) any = any || is_small_beside_largest(entry(i, N), scaled(i, N));
      return any;
    });
    scale_solution(N, shift, exponents + N, unknown);
    found.x = generate_coordinates<vec<T, N>>([&](int i) { return converted<T>(x[i]); });
  }
  return is_doubtful ? mended<T, N>(entry, found) : found;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The solution of the equations row * (x, 1) with the last column as right side: a(i, 0) x_0 + ... = a(i, N).
/// gives   dependent or inconsistent for a singular system, with its rank, as rounding has it. In floats that is one
///         whose largest possible pivot, rows and columns scaled by powers of two to be of one size, is at most 4 N u
///         of the first (u = 2^-53, float too), and in which, up to N = 4, no scaling shows anything else: that a
///         change of a column's entries by 4 N u of their sizes cannot make it singular. Beyond N = 4 entries that
///         elimination leaves must be at most 4 N times what their own rounding can amount to. So numbers that were
///         rounded from those of a singular system are singular, and equations that are merely small, or of different
///         sizes, are not. Ranks and contradictions are decided by the same rule. not_finite for NaN and infinity
/// exact   in rationals. In floats the error of a component is a few u times the condition number times the largest
///         component, rows and columns of one size; up to N = 4, whatever their size. lu_solve_refined and solve_exact
///         are right to the last place
/// cost    2/3 N^3 operations, N^3/3 comparisons; floats are solved in double; systems that look singular take longer,
///         by exact minors up to N = 4, by a second elimination beyond. lu_solve has the same error in a quarter
///         of the time: this is for systems that may be singular, or whose equations are of very different sizes
/// source  Wilkinson 1961 (Gauss's elimination with full pivoting)
template <Real T, int N, int M>
  requires(M == N + 1)
[[nodiscard]] constexpr system_solution<T, N> solve_gauss(const mat<T, N, M>& a) noexcept {
  using W = std::conditional_t<std::same_as<T, float>, double, T>;
  system_solution<T, N> s{};
  if constexpr (Floating<T> && N <= 4) {
    s = detail::solve_up_to_four<T, N>(a);
  } else {
    const auto entry = [&](int r, int c) { return static_cast<W>(a(r, c)); };
    auto rows = generate_mat<W, N, M>(entry);
    if (!detail::entries_finite<W>(rows, N, M)) return {};
    int column[2 * static_cast<std::size_t>(N)]{}, exponents[2 * static_cast<std::size_t>(N)]{};
    W largest_term[static_cast<std::size_t>(N)]{}, x[static_cast<std::size_t>(N)]{};
    const detail::eliminated found =
        detail::solve_rows(rows, entry, N, detail::elimination_space<W>{column, exponents, largest_term},
                           [&](int i) -> W& { return x[i]; });
    s = {found.status, found.rank, {}};
    if (s) s.x = generate_coordinates<vec<T, N>>([&](int i) { return converted<T>(x[i]); });
  }
  if constexpr (Floating<T>)
    for (int i = 0; i < N; ++i)
      if (!is_finite(s.x[i])) return {system_status::not_finite, N, {}};
  return s;
}

/// The solution of a * x = b.
/// gives   as for the rows of a with b behind them
/// exact   as for the rows of a with b behind them
/// cost    as for the rows of a with b behind them
template <Real T, int N>
[[nodiscard]] constexpr system_solution<T, N> solve_gauss(const mat<T, N, N>& a, const vec<T, N>& b) noexcept {
  return solve_gauss(generate_mat<T, N, N + 1>([&](int r, int c) { return c < N ? a(r, c) : b[r]; }));
}

/// The solution of equations whose coefficients left of the diagonal are zero, from the last to the first:
/// x_i = (b_i - sum of a_ij x_j over j > i) / a_ii.
/// needs   a diagonal without zeros; what stands left of it is not read
/// source  Hank n.d., 1.3.3, corrected; as printed it is textbook::back_substitution (math/textbook/solve_gauss.hpp)
template <Real T, int N, int M>
  requires(M == N + 1)
[[nodiscard]] constexpr vec<T, N> back_substitution(const mat<T, N, M>& a) noexcept {
  vec<T, N> x{};
  for (int i = N - 1; i >= 0; --i) x[i] = detail::substituted<T>(a, i, N, [&](int j) { return x[j]; });
  return x;
}

}  // namespace IRG_ABI
}  // namespace irg
