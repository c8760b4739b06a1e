// SPDX-License-Identifier: MIT
// Quotients of polynomials, correctly rounded: computed in twice the precision with a bound of the error, and where
// that does not tell which number is nearest, by exact comparison.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>

#include <irg/core/conversion.hpp>
#include <irg/geometry/detail/axis_crossing.hpp>
#include <irg/geometry/detail/evaluate.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

IRG_INLINE constexpr bool is_middling(const twofold& x) noexcept { return is_middling(known_number{x.high, x.low, 0}); }

// Writes the T nearest to a/b, where `inverse` is about 1/|b|; false where bounds leave more than one, or a is not
// middling. b is.
template <Floating T>
constexpr bool divides_surely(const twofold& a, const twofold& b, double inverse, T& nearest) noexcept {
  nearest = T(0);
  if (a.high == 0 && a.bound == 0) return true;
  if (!is_middling(a)) return false;
  const double q = a.high / b.high;
  const auto back = fast_two_product(q, b.high);
  const double rest = ((a.high - back.value) - back.error) + (a.low - product(q, b.low));
  const double correction = product(b.high < 0 ? -rest : rest, inverse), size = magnitude(q);
  const double off = product((a.bound + product(size, b.bound)) * 2, inverse) + size * 0x1p-98;
  // What is rounded to a float must not be rounded to a double first where that could matter.
  const double error = std::is_same_v<T, float> ? greater(off, size * 0x1p-50) : off;
  nearest = converted<T>(q + (correction - error));
  return nearest == converted<T>(q + (correction + error)) && magnitude(nearest) <= (std::numeric_limits<T>::max)();
}

template <int Degree, Floating T, std::size_t Size, class Formula>
IRG_NOINLINE constexpr auto exact_nearest_quotients(const Formula& formula, const std::array<T, Size>& in) noexcept {
  using number = dyadic<words_for_degree(Degree + 1)>;
  const auto v = formula(numbers_of<number>(in));
  std::array<T, std::tuple_size_v<decltype(v)> - 1> nearest{};
  if (v[0].sign() == 0) return std::optional<decltype(nearest)>();
  constexpr T most = (std::numeric_limits<T>::max)();
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const number twice = v[i + 1] + v[i + 1];
    const auto side = [&](T p, T q) {
      return v[0].sign() * (twice - v[0] * (number(widened(p)) + number(widened(q)))).sign();
    };
    nearest[i] = nearest_by_sign(-most, most, rounded_to<T>(v[i + 1].rounded() / v[0].rounded()), side);
  }
  return std::optional(nearest);
}

/// The T nearest to v[i]/v[0] for each i > 0, ties to even, v being the values formula(x) of polynomials of at most
/// this degree at x = in; other scalars divide as they do.
/// needs   finite numbers
/// gives   nothing when v[0] is zero; the largest number for what is beyond the range; no zero has a sign
template <int Degree, class T, std::size_t Size, class Formula>
constexpr auto nearest_quotients(const Formula& formula, const std::array<T, Size>& in) noexcept {
  std::array<T, std::tuple_size_v<decltype(formula(in))> - 1> nearest{};
  if constexpr (Floating<T>) {
    bool sure = true;
    for (const T& x : in) sure = sure && suits_twofold(widened(x));
    if (sure) {
      const auto v = formula(numbers_of<twofold>(in));
      sure = v[0].is_sure() && is_middling(v[0]);
      const double inverse = sure ? 1 / magnitude(v[0].high) : 0.0;
      for (std::size_t i = 0; i < nearest.size() && sure; ++i)
        sure = divides_surely(v[i + 1], v[0], inverse, nearest[i]);
    }
    return sure ? std::optional(nearest) : exact_nearest_quotients<Degree>(formula, in);
  } else {
    const auto v = formula(in);
    if (known_sign(v[0]) == 0) return std::optional<decltype(nearest)>();
    for (std::size_t i = 0; i < nearest.size(); ++i) nearest[i] = v[i + 1] / v[0];
    return std::optional(nearest);
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail
