// SPDX-License-Identifier: MIT
// Polynomials: c[0] + c[1]*x + c[2]*x^2 + ..., coefficients in ascending order, in anything with size and [].
#pragma once

#include <array>
#include <span>
#include <utility>

#include <irg/core/contract.hpp>
#include <irg/core/conversion.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/detail/polynomial_steps.hpp>

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
    const C& c, std::type_identity_t<coefficient_of<C>> x) noexcept {
  using T = coefficient_of<C>;
  const std::size_t n = std::size(c);
  IRG_EXPECTS(n < 500);
  const auto wide = [&](std::size_t i) { return widened(c[i]); };
  const double at = widened(x);
  if (n > 0 && detail::can_be_bounded(n, wide, at)) {
    const detail::compensated_sum sum = detail::bounded_horner(n, wide, at);
    return detail::narrow<T>(sum.value + sum.error);
  }
  if (!detail::is_finite(at) || !detail::all_finite(n, wide)) return evaluate_polynomial(c, x);
  if (n == 0 || at == 0) return n == 0 ? T(0) : c[0];
  return detail::narrow<T>(detail::scaled_horner(n, wide, at));
}

/// The number nearest to the polynomial's value at x, for up to seven coefficients.
/// needs   finite numbers
/// gives   infinity when the value overflows
/// exact   correctly rounded for all finite numbers
/// cost    twice evaluate_polynomial_accurate, which gives the same for less but close to a root of high multiplicity:
///         there it leaves the rounding open, and an exact sum in integers decides
template <Floating T, std::size_t N>
  requires(N >= 1 && N <= 7)
[[nodiscard]] constexpr T evaluate_polynomial_exact(const std::array<T, N>& c, std::type_identity_t<T> x) noexcept {
  const std::array<double, N> wide = detail::all_widened(c);
  const auto at = [&](std::size_t i) { return wide[i]; };
  T rounded{};
  if (detail::can_be_bounded(N, at, widened(x)) &&
      detail::round_safely(detail::bounded_horner(N, at, widened(x)), rounded))
    return rounded;
  return detail::rounded_once<T>(detail::exact_horner(wide, widened(x)));
}

/// -1, 0 or 1: the sign of the polynomial's value at x, for up to seven coefficients.
/// needs   finite numbers
/// exact   for all finite numbers
/// cost    as evaluate_polynomial_accurate, and an exact sum in integers where that leaves the sign open
template <Floating T, std::size_t N>
  requires(N >= 1 && N <= 7)
[[nodiscard]] constexpr int polynomial_sign(const std::array<T, N>& c, std::type_identity_t<T> x) noexcept {
  const std::array<double, N> wide = detail::all_widened(c);
  const auto at = [&](std::size_t i) { return wide[i]; };
  if (detail::can_be_bounded(N, at, widened(x))) {
    const detail::compensated_sum sum = detail::bounded_horner(N, at, widened(x));
    const double value = sum.value + sum.error;
    if (detail::magnitude(value) > 2 * sum.bound) return value < 0 ? -1 : 1;
    if (value == 0 && sum.bound == 0) return 0;
  }
  return detail::exact_horner(wide, widened(x)).sign();
}

/// The coefficients of the derivative; 0 for a constant.
template <Scalar T, std::size_t N>
  requires(N >= 1)
[[nodiscard]] constexpr std::array<T, (N > 1 ? N - 1 : 1)> polynomial_derivative(const std::array<T, N>& c) noexcept {
  std::array<T, (N > 1 ? N - 1 : 1)> derivative{};
  for (std::size_t i = 1; i < N; ++i) derivative[i - 1] = static_cast<T>(static_cast<int>(i)) * c[i];
  return derivative;
}

}  // namespace IRG_ABI
}  // namespace irg
