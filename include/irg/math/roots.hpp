// SPDX-License-Identifier: MIT
// Real roots of quadratic and cubic equations: as many as there are, decided exactly, and each with almost all its
// digits, for coefficients of any size.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/cubic.hpp>

namespace irg {

/// What the solutions of an equation are. `linear` is the one solution of an equation without a square or a cube; `all`
/// says that every number solves it (0 = 0), `undefined` that a coefficient is NaN or infinite.
enum class roots_kind { none, one, two, three, linear, all, undefined };

/// The distinct real roots of an equation of degree N or less.
/// shape   a range of numbers in ascending order, root[0] to root[count - 1]; multiplicity[i] is 1, 2 or 3. Roots that
///         differ by less than rounding does can be equal numbers. A root beyond the range of T is an infinity
template <Floating T, int N>
struct real_roots {
  roots_kind kind = roots_kind::none;
  int count = 0;
  T root[static_cast<std::size_t>(N)]{};
  int multiplicity[static_cast<std::size_t>(N)]{};
  [[nodiscard]] IRG_APART constexpr const T* begin() const noexcept { return root; }
  [[nodiscard]] IRG_APART constexpr const T* end() const noexcept { return root + count; }
  [[nodiscard]] IRG_APART constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(count); }
  friend constexpr bool operator==(const real_roots&, const real_roots&) = default;
};

namespace detail::inline IRG_ABI {

template <Floating T, int N>
constexpr void append_root(real_roots<T, N>& roots, double x, int multiplicity) noexcept {
  roots.root[roots.count] = narrow<T>(x + 0.0);  // -0 becomes 0
  roots.multiplicity[roots.count++] = multiplicity;
  roots.kind = roots.count == 1 ? roots_kind::one : roots.count == 2 ? roots_kind::two : roots_kind::three;
}

template <Floating T>
IRG_INLINE constexpr real_roots<T, 2> two_real_roots(T x, T y, bool is_double) noexcept {
  if (is_double) return {roots_kind::one, 1, {x, T(0)}, {2, 0}};
  return {roots_kind::two, 2, {lesser(x, y), greater(x, y)}, {1, 1}};
}

template <Floating T, int N>
constexpr real_roots<T, N> no_equation(roots_kind kind) noexcept {
  real_roots<T, N> roots;
  roots.kind = kind;
  return roots;
}

/// The root of b*x + c = 0.
template <Floating T, int N>
constexpr real_roots<T, N> linear_root(double b, double c) noexcept {
  if (b == 0) return no_equation<T, N>(c == 0 ? roots_kind::all : roots_kind::none);
  real_roots<T, N> roots;
  append_root(roots, far_quotient(-c, b), 1);
  roots.kind = roots_kind::linear;
  return roots;
}

template <Floating T, int N>
constexpr real_roots<T, N> roots_of_quadratic(double a, double b, double c) noexcept {
  if (a == 0) return linear_root<T, N>(b, c);
  real_roots<T, N> roots;
  const unrounded_roots found = solve_quadratic(a, b, c);
  if (found.count == 1) append_root(roots, rounded_root(found, 0), 2);
  if (found.count < 2) return roots;
  const double x = rounded_root(found, 0), y = rounded_root(found, 1);
  append_root(roots, lesser(x, y), 1);
  append_root(roots, greater(x, y), 1);
  return roots;
}

/// The roots of x * (a*x^2 + b*x + c).
template <Floating T>
constexpr real_roots<T, 3> roots_with_zero(double a, double b, double c) noexcept {
  const auto others = roots_of_quadratic<double, 2>(a, b, c);
  real_roots<T, 3> roots;
  bool has_zero = false;
  for (int i = 0; i < others.count; ++i) {
    if (!has_zero && (c == 0 ? others.root[i] == 0 : others.root[i] > 0)) {
      has_zero = true;
      append_root(roots, 0, c == 0 ? others.multiplicity[i] + 1 : 1);
      if (c == 0) continue;
    }
    append_root(roots, others.root[i], others.multiplicity[i]);
  }
  if (!has_zero) append_root(roots, 0, 1);
  return roots;
}

/// needs   a and d not 0
template <Floating T>
constexpr real_roots<T, 3> roots_of_cubic(const cubic_coefficients& p) noexcept {
  real_roots<T, 3> roots;
  const int sign = p[3] < 0 ? -1 : 1, distinct = cubic_discriminant_sign(p);
  if (distinct < 0) {
    const sign_change everywhere{-last_double, last_double, -sign};
    append_root(roots,
                is_moderate_cubic(p) ? root_near(p, everywhere, polished(p, only_root_guess(p), infinity<double>))
                                     : root_by_halving(p, everywhere),
                1);
    return roots;
  }
  const int middle = distinct == 0 ? sign * sign_at_inflection(p) : 0;
  if (distinct == 0 && middle == 0) {
    // -b/3a, where 3a overflows or has a bit too many
    const scaled_number a = decompose(p[3]), b = decompose(p[2]);
    append_root(roots,
                placed(divide({-b.significand, 0}, two_sum(2 * a.significand, a.significand)), b.exponent - a.exponent),
                3);
    return roots;
  }
  const cubic_shape shape = cubic_shape_of(p);
  const sign_change left{-last_double, shape.low, -sign}, between{shape.low, shape.high, sign},
      right{shape.high, last_double, -sign};
  if (distinct == 0) {  // an extremum is the double root
    const double spread = shape.high * 0.5 - shape.low * 0.5;
    if (middle < 0) append_root(roots, shape.low, 2);
    append_root(roots,
                !shape.is_moderate ? root_by_halving(p, middle < 0 ? right : left)
                : middle < 0       ? root_near(p, right, polished(p, shape.high + spread, infinity<double>))
                                   : root_near(p, left, polished(p, shape.low - spread, infinity<double>)),
                1);
    if (middle > 0) append_root(roots, shape.high, 2);
    return roots;
  }
  // Two roots can be so near to each other that no number lies between them: then the extremum stands for both.
  const bool left_apart = polynomial_sign(p, shape.low) == sign, right_apart = polynomial_sign(p, shape.high) == -sign;
  append_root(roots, left_apart ? root_beside(p, shape, left, shape.low, -1) : shape.low, 1);
  if (!left_apart || !right_apart)
    append_root(roots, left_apart ? shape.high : shape.low, 1);
  else if (magnitude(evaluate_polynomial_accurate(p, shape.low)) <
           magnitude(evaluate_polynomial_accurate(p, shape.high)))
    append_root(roots, root_beside(p, shape, between, shape.low, 1), 1);
  else
    append_root(roots, root_beside(p, shape, between, shape.high, -1), 1);
  append_root(roots, right_apart ? root_beside(p, shape, right, shape.high, 1) : shape.high, 1);
  return roots;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The real roots of a*x^2 + b*x + c = 0.
/// gives   `one`, of multiplicity 2, exactly when the discriminant is zero; `linear` when a = 0; `none` when there is
///         no real root, `all` when all three coefficients are 0, `undefined` when one is NaN or infinite
/// exact   the number of roots for all finite coefficients; each root within 0.51 ulp (float 0.501) over the whole
///         range, subnormals within 1
/// cost    a square root, three divisions and some 60 operations; coefficients beyond 2^-240 to 2^240 some more
/// source  Kahan 2004 (the discriminant in twice the precision), here with the root, sum and quotients in it, too
template <Floating T>
[[nodiscard]] constexpr real_roots<T, 2> quadratic_roots(T a, T b, T c) noexcept {
  if (!detail::is_finite(a) || !detail::is_finite(b) || !detail::is_finite(c))
    return detail::no_equation<T, 2>(roots_kind::undefined);
  return detail::roots_of_quadratic<T, 2>(widened(a), widened(b), widened(c));
}

/// The same for coefficients of different types, and integers.
template <class A, class B, class C>
  requires MixedArguments<A, B, C>
[[nodiscard]] constexpr real_roots<double, 2> quadratic_roots(A a, B b, C c) noexcept {
  return quadratic_roots(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c));
}

/// The real roots of a*x^2 + b*x + c = 0 by the stable formula in working precision.
/// needs   a not 0; a*c and b*b 0 or between 2^-900 and 2^1000 (float: no limit), quotients in the range
/// exact   within 3 ulp (measured: 2.0); the number of roots is right
/// cost    a square root, two divisions and a difference_of_products
/// source  Kahan 2004 (the discriminant); the root of larger size first, the other from the product of both
template <Floating T>
[[nodiscard]] constexpr real_roots<T, 2> quadratic_roots_fast(T a, T b, T c) noexcept {
  real_roots<T, 2> roots;
  // The products of floats are exact in double and within its range.
  const double p = widened(a), q = widened(b), r = widened(c);
  const double discriminant =
      std::is_same_v<T, float> ? product(q, q) - product(4 * p, r) : difference_of_products(q, q, 4 * p, r);
  if (!(discriminant >= 0)) return roots;
  const double root = sqrt(discriminant);
  const double sum = -0.5 * (q < 0 ? q - root : q + root);
  const double x = sum / p, y = sum == 0 ? 0 : r / sum;
  return detail::two_real_roots(detail::narrow<T>(x), detail::narrow<T>(y), discriminant == 0);
}

/// The real roots of a*x^3 + b*x^2 + c*x + d = 0.
/// gives   as quadratic_roots; that of quadratic_roots when a = 0
/// exact   the number of distinct roots and their multiplicities for all finite coefficients; each root within 1 ulp,
///         two that are nearer to each other than 2 ulp within 3
/// cost    some 0.2 us for one root, 0.7 us for three; coefficients beyond 2^-60 to 2^60 some 20 us
/// source  Kahan 1986b and Blinn 2006 (starting places); the enclosure by exact signs is irg's own
template <Floating T>
[[nodiscard]] constexpr real_roots<T, 3> cubic_roots(T a, T b, T c, T d) noexcept {
  const detail::cubic_coefficients p{widened(d), widened(c), widened(b), widened(a)};
  if (!detail::all_finite(4, [&](std::size_t i) { return p[i]; }))
    return detail::no_equation<T, 3>(roots_kind::undefined);
  if (a == 0) return detail::roots_of_quadratic<T, 3>(p[2], p[1], p[0]);
  return d == 0 ? detail::roots_with_zero<T>(p[3], p[2], p[1]) : detail::roots_of_cubic<T>(p);
}

/// The same for coefficients of different types, and integers.
template <class A, class B, class C, class D>
  requires MixedArguments<A, B, C, D>
[[nodiscard]] constexpr real_roots<double, 3> cubic_roots(A a, B b, C c, D d) noexcept {
  return cubic_roots(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c), static_cast<double>(d));
}

}  // namespace IRG_ABI
}  // namespace irg
