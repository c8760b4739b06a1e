// SPDX-License-Identifier: MIT
// Polynomials: c[0] + c[1]*x + c[2]*x^2 + ..., coefficients in ascending order, in anything with size and [].
#pragma once

#include <array>
#include <utility>

#include <irg/core/contract.hpp>
#include <irg/core/conversion.hpp>
#include <irg/math/compensated.hpp>

namespace irg {

/// The coefficients of a polynomial, that of x^0 first. Models: arrays, std::array, std::span, std::vector.
template <class C>
concept PolynomialCoefficients = requires(const C& c) {
  { std::size(c) } -> std::convertible_to<std::size_t>;
  requires Scalar<std::remove_cvref_t<decltype(c[std::size_t{0}])>>;
};

/// The number type of a polynomial's coefficients.
template <PolynomialCoefficients C>
using coefficient_of = std::remove_cvref_t<decltype(std::declval<const C&>()[std::size_t{0}])>;

/// A polynomial's value and that of its derivative at the same place.
template <Scalar T>
struct value_and_derivative {
  T value{}, derivative{};
  friend bool operator==(const value_and_derivative&, const value_and_derivative&) = default;
};

inline namespace IRG_ABI {

/// The polynomial's value at x; 0 when it has no coefficients.
/// exact   in integers and rationals. In floats the error is at most 2n u (n the degree) times the sum of |c_i*x^i|,
///         barring over- and underflow; each product and each sum rounded once, never fused
/// cost    a multiplication and an addition a degree
/// source  Horner 1819
template <PolynomialCoefficients C>
[[nodiscard]] constexpr coefficient_of<C> evaluate_polynomial(const C& c,
                                                              std::type_identity_t<coefficient_of<C>> x) noexcept {
  using T = coefficient_of<C>;
  T value = T(0);
  for (std::size_t i = std::size(c); i-- > 0;) value = product(value, x) + c[i];
  return value;
}

/// The polynomial's value and its derivative's at x.
/// exact   as evaluate_polynomial
template <PolynomialCoefficients C>
[[nodiscard]] constexpr value_and_derivative<coefficient_of<C>> evaluate_polynomial_with_derivative(
    const C& c, std::type_identity_t<coefficient_of<C>> x) noexcept {
  using T = coefficient_of<C>;
  value_and_derivative<T> at{T(0), T(0)};
  for (std::size_t i = std::size(c); i-- > 0;) {
    at.derivative = product(at.derivative, x) + at.value;
    at.value = product(at.value, x) + c[i];
  }
  return at;
}

/// The polynomial's value at x, computed in twice the precision.
/// needs   fewer than 500 coefficients
/// gives   for finite numbers never NaN, infinity only when the value itself overflows
/// exact   the error is at most u times the value and (2n u)^2 times the sum of |c_i*x^i| for degree n: within 1 ulp up
///         to condition 10^14 and degree 20
/// cost    some 5 times that of evaluate_polynomial
/// source  Graillat, Langlois and Louvet 2005
template <PolynomialCoefficients C>
  requires Floating<coefficient_of<C>>
[[nodiscard]] constexpr coefficient_of<C> evaluate_polynomial_accurate(
    const C& c, std::type_identity_t<coefficient_of<C>> x) noexcept;

/// The number nearest to the polynomial's value at x, for up to seven coefficients.
/// needs   finite numbers
/// gives   infinity when the value overflows
/// exact   correctly rounded for all finite numbers
/// cost    twice evaluate_polynomial_accurate, which gives the same for less but close to a root of high multiplicity:
///         there it leaves the rounding open, and an exact sum in integers decides
template <Floating T, std::size_t N>
  requires(N >= 1 && N <= 7)
[[nodiscard]] constexpr T evaluate_polynomial_exact(const std::array<T, N>& c, std::type_identity_t<T> x) noexcept;

/// -1, 0 or 1: the sign of the polynomial's value at x, for up to seven coefficients.
/// needs   finite numbers
/// exact   for all finite numbers
/// cost    as evaluate_polynomial_accurate, and an exact sum in integers where that leaves the sign open
template <Floating T, std::size_t N>
  requires(N >= 1 && N <= 7)
[[nodiscard]] constexpr int polynomial_sign(const std::array<T, N>& c, std::type_identity_t<T> x) noexcept;

/// The coefficients of the derivative; 0 for a constant.
template <Scalar T, std::size_t N>
  requires(N >= 1)
[[nodiscard]] constexpr std::array<T, (N > 1 ? N - 1 : 1)> polynomial_derivative(const std::array<T, N>& c) noexcept {
  std::array<T, (N > 1 ? N - 1 : 1)> derivative{};
  for (std::size_t i = 1; i < N; ++i) derivative[i - 1] = static_cast<T>(static_cast<int>(i)) * c[i];
  return derivative;
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

/// Horner's rule with exact errors for n coefficients c(i), and with a bound of what the sum of value and error lacks;
/// 0 when nothing was rounded.
/// needs   can_be_bounded
/// source  Graillat, Langlois and Louvet 2005 (CompHorner)
template <class C>
IRG_INLINE constexpr compensated_sum bounded_horner(std::size_t n, const C& c, double x) noexcept {
  compensated_sum sum{c(n - 1), 0, 0};
  double sizes = 0;
  for (std::size_t i = n - 1; i-- > 0;) {
    const auto [term, term_error] = fast_two_product(sum.value, x);
    const auto [next, next_error] = two_sum(term, c(i));
    sum.error = product(sum.error, x) + (term_error + next_error);
    sizes = product(sizes, magnitude(x)) + (magnitude(term_error) + magnitude(next_error));
    sum.value = next;
  }
  // Three roundings of u a step in the error, as many in `sizes`; doubled.
  sum.bound = product(sizes, static_cast<double>(3 * n) * 0x1p-52);
  return sum;
}

/// Whether x is 0 or 2^-range <= |x| < 2^range.
IRG_INLINE constexpr bool is_within(double x, int range) noexcept {
  const auto bits = bits_of(x) << 1;
  const auto field = static_cast<int>(bits >> 53);
  return (field >= 1023 - range && field < 1023 + range) || bits == 0;
}

/// Whether no step of Horner's rule comes near an end of the range.
template <class C>
IRG_INLINE constexpr bool can_be_bounded(std::size_t n, const C& c, double x) noexcept {
  bool moderate = n <= 125 && is_within(x, n <= 3 ? 125 : 250 / static_cast<int>(n - 1));
  for (std::size_t i = 0; i < n; ++i) moderate = moderate && is_within(c(i), 150);
  return moderate;
}

/// Horner's rule in twice the precision beyond that range, by x = m*2^e with 1 <= |m| < 2 and coefficients scaled to
/// match.
/// needs   fewer than 500 coefficients, not all zero; x finite and not zero
template <class C>
constexpr double scaled_horner(std::size_t n, const C& c, double x) noexcept {
  const scaled_number at = decompose(x);
  const auto place = [&](std::size_t i) { return decompose(c(i)).exponent + static_cast<int>(i) * at.exponent; };
  int highest = (std::numeric_limits<int>::min)();
  for (std::size_t i = 0; i < n; ++i)
    if (c(i) != 0) highest = maximum(highest, place(i));
  double value = 0, error = 0;
  for (std::size_t i = n; i-- > 0;) {
    const int k = c(i) == 0 ? -2000 : place(i) - highest;
    const double coefficient = k < -900 ? 0.0 : decompose(c(i)).significand * power_of_two(k);
    const auto [term, term_error] = two_product(value, at.significand);
    const auto [next, next_error] = two_sum(term, coefficient);
    error = product(error, at.significand) + (term_error + next_error);
    value = next;
  }
  const auto [head, rest] = two_sum(value, error);
  if (head == 0) return 0;
  const scaled_number parts = decompose(head);
  return scale({parts.significand, rest * power_of_two(-parts.exponent)}, parts.exponent + highest);
}

template <class C>
constexpr bool all_finite(std::size_t n, const C& c) noexcept {
  bool finite = true;
  for (std::size_t i = 0; i < n; ++i) finite = finite && is_finite(c(i));
  return finite;
}

/// The polynomial's value, exactly.
/// needs   finite numbers
template <std::size_t N>
IRG_NOINLINE constexpr exact_accumulator<static_cast<int>(N)> exact_horner(const std::array<double, N>& c,
                                                                           double x) noexcept {
  exact_accumulator<static_cast<int>(N)> sum;
  const auto add = [&]<std::size_t... J>(double coefficient, std::index_sequence<J...>) {
    sum.add(coefficient, (static_cast<void>(J), x)...);
  };
  [&]<std::size_t... K>(std::index_sequence<K...>) {
    (add(c[K], std::make_index_sequence<K>{}), ...);
  }(std::make_index_sequence<N>{});
  return sum;
}

template <Floating T, std::size_t N>
constexpr std::array<double, N> all_widened(const std::array<T, N>& c) noexcept {
  std::array<double, N> wide{};
  for (std::size_t i = 0; i < N; ++i) wide[i] = widened(c[i]);
  return wide;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <PolynomialCoefficients C>
  requires Floating<coefficient_of<C>>
[[nodiscard]] constexpr coefficient_of<C> evaluate_polynomial_accurate(
    const C& c, std::type_identity_t<coefficient_of<C>> x) noexcept {
  using T = coefficient_of<C>;
  const std::size_t n = std::size(c);
  IRG_EXPECTS(n < 500);
  const auto wide = [&](std::size_t i) { return widened(c[i]); };
  const double at = widened(x);
  if (n > 0 && detail::can_be_bounded(n, wide, at)) {
    const detail::compensated_sum sum = detail::bounded_horner(n, wide, at);
    return narrowed<T>(sum.value + sum.error);
  }
  if (!is_finite(at) || !detail::all_finite(n, wide)) return evaluate_polynomial(c, x);
  if (n == 0 || at == 0) return n == 0 ? T(0) : c[0];
  return narrowed<T>(detail::scaled_horner(n, wide, at));
}

template <Floating T, std::size_t N>
  requires(N >= 1 && N <= 7)
[[nodiscard]] constexpr T evaluate_polynomial_exact(const std::array<T, N>& c, std::type_identity_t<T> x) noexcept {
  const std::array<double, N> wide = detail::all_widened(c);
  const auto at = [&](std::size_t i) { return wide[i]; };
  T rounded{};
  if (detail::can_be_bounded(N, at, widened(x)) &&
      detail::round_safely(detail::bounded_horner(N, at, widened(x)), rounded))
    return rounded;
  return detail::round_exact_sum<T>(detail::exact_horner(wide, widened(x)));
}

template <Floating T, std::size_t N>
  requires(N >= 1 && N <= 7)
[[nodiscard]] constexpr int polynomial_sign(const std::array<T, N>& c, std::type_identity_t<T> x) noexcept {
  const std::array<double, N> wide = detail::all_widened(c);
  const auto at = [&](std::size_t i) { return wide[i]; };
  if (detail::can_be_bounded(N, at, widened(x))) {
    const detail::compensated_sum sum = detail::bounded_horner(N, at, widened(x));
    const double value = sum.value + sum.error;
    if (magnitude(value) > 2 * sum.bound) return value < 0 ? -1 : 1;
    if (value == 0 && sum.bound == 0) return 0;
  }
  return detail::exact_horner(wide, widened(x)).sign();
}

}  // namespace IRG_ABI
}  // namespace irg
