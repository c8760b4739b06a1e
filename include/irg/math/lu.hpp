// SPDX-License-Identifier: MIT
// LU factors of a square matrix: factor once, solve for many right-hand sides; the condition of the matrix; and
// solutions that are right to the last place, by corrections whose residual is computed in twice the precision.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/exact_system.hpp>
#include <irg/math/detail/refinement.hpp>
#include <irg/math/mat.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The factors of `a`, found with partial pivoting.
/// gives   nothing when a column has no pivot, that is for a matrix that is singular as computed (in rationals: that is
///         singular), or when an entry is NaN, infinite or overflows on the way. In floats a singular matrix may get
///         through by rounding: reciprocal_condition tells
/// exact   in rationals. In floats L*U differs from the permuted matrix by at most N u |L|*|U|
/// cost    2/3 N^3 operations
/// source  Higham 2002, ch. 9
template <Real T, int N>
[[nodiscard]] constexpr std::optional<lu_factors<T, N>> lu_factor(const mat<T, N, N>& a) noexcept {
  if (!detail::entries_finite<T>(a, N, N)) return std::nullopt;
  lu_factors<T, N> f{a, {}};
  for (int i = 0; i < N; ++i) f.order[i] = i;
  for (int k = 0; k < N; ++k) {
    const int pivot = detail::pivot_row(f.lu, k, N);
    if (f.lu(pivot, k) == T(0)) return std::nullopt;
    detail::swap_rows(f.lu, k, pivot, N);
    const int kept = f.order[k];
    f.order[k] = f.order[pivot];
    f.order[pivot] = kept;
    for (int r = k + 1; r < N; ++r) {
      const T factor = f.lu(r, k) / f.lu(k, k);
      detail::subtract_row(f.lu, r, factor, k, k + 1, N);
      f.lu(r, k) = factor;
    }
  }
  if (!detail::entries_finite<T>(f.lu, N, N)) return std::nullopt;
  return f;
}

/// The x with a * x = b, from the factors of `a`.
/// exact   in rationals; in floats the error of a component is a few u times the condition number times the largest
///         component. May overflow to infinity or NaN where the solution is too large
/// cost    2 N^2 operations
template <Real T, int N>
[[nodiscard]] constexpr vec<T, N> lu_solve(const lu_factors<T, N>& f, const vec<T, N>& b) noexcept {
  vec<T, N> x{};
  for (int i = 0; i < N; ++i) {
    x[i] = b[f.order[i]];
    for (int j = 0; j < i; ++j) x[i] = x[i] - product(f.lu(i, j), x[j]);
  }
  for (int i = N - 1; i >= 0; --i) {
    for (int j = i + 1; j < N; ++j) x[i] = x[i] - product(f.lu(i, j), x[j]);
    x[i] = x[i] / f.lu(i, i);
  }
  return x;
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// The sum of the sizes of the coordinates.
template <class T, int N>
constexpr T size_1(const vec<T, N>& v) noexcept {
  T sum = entry_size(v[0]);
  for (int i = 1; i < N; ++i) sum = sum + entry_size(v[i]);
  return sum;
}

// What reciprocal_condition must exceed for results to be right to the last place: residuals are known to (N + 1) u^2.
constexpr double smallest_condition(int n) noexcept { return 4.0 * n * 0x1p-53; }

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The largest sum of the sizes of the entries of a column: the norm that belongs to sums of absolute values.
template <class T, int R, int C>
[[nodiscard]] IRG_INLINE constexpr T norm_1(const mat<T, R, C>& a) noexcept {
  T sum[static_cast<std::size_t>(C)]{};
  for (int r = 0; r < R; ++r)
    for (int c = 0; c < C; ++c) sum[c] = sum[c] + detail::entry_size(a(r, c));
  T largest = sum[0];
  for (int c = 1; c < C; ++c) largest = maximum(sum[c], largest);
  return largest;
}

/// 1 over the condition number of `a`, the product of the norms (norm_1) of `a` and of its inverse, from its factors:
/// by what part of its size the matrix may change before it can become singular.
/// gives   0 to 1
/// exact   in rationals; in floats within a few percent for conditions up to 1e14 (float 1e6); beyond 1/u its size is
///         noise below 4 N u. 0 where it underflows
/// cost    2 N^3 operations: the inverse's norm is found column by column, not estimated
template <Real T, int N>
[[nodiscard]] constexpr T reciprocal_condition(const mat<T, N, N>& a, const lu_factors<T, N>& f) noexcept {
  T largest = T(0);
  for (int c = 0; c < N; ++c) {
    const T sum =
        detail::size_1(lu_solve(f, generate_coordinates<vec<T, N>>([&](int i) { return i == c ? T(1) : T(0); })));
    if (!(sum == sum)) return T(0);
    largest = maximum(sum, largest);
  }
  return T(1) / norm_1(a) / largest;
}

/// 1 over the condition number of `a`.
/// gives   0 where lu_factor gives nothing: for a matrix that is singular as computed, that has an entry that is NaN or
///         infinite, or whose factors overflow
/// exact   as from its factors
template <Real T, int N>
[[nodiscard]] constexpr T reciprocal_condition(const mat<T, N, N>& a) noexcept {
  const std::optional<lu_factors<T, N>> f = lu_factor(a);
  return f ? reciprocal_condition(a, *f) : T(0);
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// a scaled, and its factors if it has any.
// needs   finite entries
template <int N>
constexpr scaled_system<N> factor_scaled(const mat<double, N, N>& a, scaling way) noexcept {
  scaled_system<N> s;
  s.a = a;
  s.sizes = equilibrate(s.a, N, s.row_exponent, s.column_exponent, way);
  if (const std::optional<lu_factors<double, N>> factors = lu_factor(s.a)) {
    s.factors = *factors;
    for (int i = 0; i < N; ++i) s.inverse_pivot[i] = 1 / s.factors.lu(i, i);
    s.has_factors = true;
  }
  return s;
}

// lu_solve without divisions, which is as good for corrections.
template <int N>
constexpr vec<double, N> roughly_solved(const scaled_system<N>& s, const vec<double, N>& b) noexcept {
  vec<double, N> x{};
  for (int i = 0; i < N; ++i) {
    x[i] = b[s.factors.order[i]];
    for (int j = 0; j < i; ++j) x[i] = x[i] - product(s.factors.lu(i, j), x[j]);
  }
  for (int i = N - 1; i >= 0; --i) {
    for (int j = i + 1; j < N; ++j) x[i] = x[i] - product(s.factors.lu(i, j), x[j]);
    x[i] = product(x[i], s.inverse_pivot[i]);
  }
  return x;
}

// The x with s.a * x = b, corrected until x + tail is right beyond the last place of x; false when the corrections do
// not become smaller, that is when the matrix is singular for double.
template <int N>
constexpr bool refine(const scaled_system<N>& s, const vec<double, N>& b, vec<double, N>& x,
                      vec<double, N>& tail) noexcept {
  tail = {};
  x = roughly_solved(s, b);
  double last = infinity<double>;
  for (int step = 0; step < 100; ++step) {
    const vec<double, N> d = roughly_solved(s, residual_of(s.a, b, x, tail));
    const double size = largest_of(x), change = largest_of(d);
    if (!is_finite(size) || !is_finite(change)) return false;
    const bool is_smaller = change <= 0.5 * last && change <= 0.5 * size;
    if (!is_smaller && change > 0x1p-56 * size) return false;
    for (int i = 0; i < N; ++i) {
      const auto sum = two_sum(x[i], d[i]);
      const auto whole = two_sum(sum.value, tail[i] + sum.error);
      x[i] = whole.value;
      tail[i] = whole.error;
    }
    if (!is_smaller || change <= 0x1p-70 * size) return true;
    last = change;
  }
  return false;
}

// The T nearest to (x + tail) * 2^e.
template <Floating T>
IRG_INLINE constexpr T scaled_back(double x, double tail, int e) noexcept {
  const double rounded = times_power_of_two(x, e);
  if (std::same_as<T, float> || x == 0 || magnitude(rounded) >= 0x1p-1022) return narrowed<T>(rounded);
  return converted<T>(nearest_scaled<double>({x, tail}, e, [](double, double) { return 0; }));
}

// Whether x is so small beside the largest of its column that the last correction, whose error is the same for all, may
// have spoiled it; where the matrix is of one size, only differences of equal terms are that small.
IRG_INLINE constexpr bool is_doubtful(double x, double largest, double condition, const scaled_sizes& sizes) noexcept {
  if (!sizes.is_mixed() || (x == 0 && !sizes.has_small())) return false;
  return magnitude(x) < product(largest, minimum(product(condition, 0x1p-56), 0x1p-8));
}

// The solution of a * x = b, s being a scaled and factored.
template <Floating T, int N>
constexpr std::optional<vec<T, N>> refined_solution(const scaled_system<N>& s, const mat<double, N, N>& a,
                                                    const vec<double, N>& b) noexcept {
  if (!s.has_factors) return std::nullopt;
  const double part = reciprocal_condition(s.a, s.factors);
  if (!(part > smallest_condition(N))) return std::nullopt;
  vec<double, N> right = b, x{}, tail{};
  scaled_sizes sizes = s.sizes;
  const int shift = scale_right_side(N, [&](int i) -> double& { return right[i]; }, s.row_exponent);
  if (!refine(s, right, x, tail)) return std::nullopt;
  vec<T, N> result{};
  for (int i = 0; i < N; ++i) result[i] = scaled_back<T>(x[i], tail[i], shift - s.column_exponent[i]);
  if constexpr (N <= 4)
    if (sizes.is_mixed()) {
      for (int i = 0; i < N; ++i)
        if (is_small_beside_largest(b[i], right[i])) sizes.least = 0;
      const double largest = largest_of(x);
      unsigned which = 0;
      for (int i = 0; i < N; ++i) which |= is_doubtful(x[i], largest, 1 / part, sizes) ? 1u << i : 0;
      if (which != 0 && !put_exact_solution(a, b, which, smallest_condition(N), result)) return std::nullopt;
    }
  return result;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The x with a * x = b, right to the last place.
/// gives   nothing when the condition number of `a`, its rows and columns scaled by powers of two to be of one size,
///         reaches 1/(4 N u) with u = 2^-53 (so a singular matrix gives nothing), when a number is NaN or infinite, or
///         when the solution is too large for T. Up to N = 4 it is the best of all scalings that counts
/// exact   every component that is no less than 2^-8 of the largest (after the scaling of columns) within 0.51 ulp; up
///         to N = 4 after any scaling that leaves the condition number below that limit
/// cost    about 3 corrections, each N^2 exact products; floats are solved in double
/// source  Higham 2002, ch. 12; Demmel et al. 2006
template <Floating T, int N>
[[nodiscard]] constexpr std::optional<vec<T, N>> lu_solve_refined(const mat<T, N, N>& a, const vec<T, N>& b) noexcept {
  const auto wide = generate_mat<double, N, N>([&](int r, int c) { return widened(a(r, c)); });
  const auto right = generate_coordinates<vec<double, N>>([&](int i) { return widened(b[i]); });
  if (!detail::entries_finite<double>(wide, N, N)) return std::nullopt;
  for (int i = 0; i < N; ++i)
    if (!is_finite(right[i])) return std::nullopt;
  const auto s = detail::factor_scaled(wide, detail::scaling::by_largest);
  auto x = detail::refined_solution<T>(s, wide, right);
  if (!x && s.sizes.may_hide_regular()) {
    if constexpr (N <= 4) {
      x.emplace();
      const double part = detail::smallest_condition(N);
      if (!detail::put_exact_solution(wide, right, detail::all_of<N>, part, *x)) return std::nullopt;
    } else {
      x = detail::refined_solution<T>(detail::factor_scaled(wide, detail::scaling::by_means), wide, right);
    }
  }
  for (int j = 0; x && j < N; ++j)
    if (!is_finite((*x)[j])) return std::nullopt;
  return x;
}

}  // namespace IRG_ABI
}  // namespace irg
