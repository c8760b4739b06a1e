// SPDX-License-Identifier: MIT
// The steps of polynomial.hpp.
#pragma once

#include <array>
#include <span>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/core/contract.hpp>
#include <irg/math/compensated.hpp>

namespace irg::detail::inline IRG_ABI {

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
    if (c(i) != 0) highest = greater(highest, place(i));
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

}  // namespace irg::detail::inline IRG_ABI
