// SPDX-License-Identifier: MIT
// Quotients of polynomials, correctly rounded: computed in twice the precision with a bound of the error, and where
// that does not tell which number is nearest, by exact comparison.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/math/exact/nearest_float.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg::inline IRG_ABI {

/// The T nearest to each quotient a/b, b/... for {b, a...} = polynomials(arguments...); other scalars divide as they
/// do.
/// shape   the polynomials as values_of takes them, giving a std::array: the divisor comes first
/// needs   polynomials of at most this degree, 5 at most; finite numbers
/// gives   nothing when the divisor is zero; the largest number for what is beyond the range; no zero has a sign
/// exact   correctly rounded, ties to even
template <int Degree, class Polynomials, class... A>
[[nodiscard]] constexpr auto quotients_of(const Polynomials& polynomials, const A&... arguments) noexcept;

/// The number nearest to a/b for {b, a} = polynomials(arguments...), as quotients_of gives it.
template <int Degree, class Polynomials, class... A>
[[nodiscard]] constexpr auto quotient_of(const Polynomials& polynomials, const A&... arguments) noexcept {
  using T = detail::argument_scalar<A...>;
  const auto nearest = quotients_of<Degree>(polynomials, arguments...);
  return nearest ? std::optional<T>((*nearest)[0]) : std::nullopt;
}

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// Writes the T nearest to a/b, where `inverse` is about 1/|b|; false where bounds leave more than one, or a is not
// middling. b is.
template <Floating T>
constexpr bool divides_surely(const bounded_double_double& a, const bounded_double_double& b, double inverse,
                              T& nearest) noexcept {
  nearest = T(0);
  if (a.value == 0 && a.bound == 0) return true;
  if (!is_middling(a.value)) return false;
  const double q = a.value / b.value, rest = residual(a, q, b);
  const double correction = product(b.value < 0 ? -rest : rest, inverse), size = magnitude(q);
  const double off = product((a.bound + product(size, b.bound)) * 2, inverse) + size * 0x1p-98;
  // What is rounded to a float must not be rounded to a double first where that could matter.
  const double error = std::is_same_v<T, float> ? maximum(off, size * 0x1p-50) : off;
  nearest = converted<T>(q + (correction - error));
  return nearest == converted<T>(q + (correction + error)) && magnitude(nearest) <= (std::numeric_limits<T>::max)();
}

template <int Degree, Floating T, class Polynomials, class... A>
IRG_NOINLINE constexpr auto exact_quotients_of(const Polynomials& polynomials, const A&... arguments) noexcept {
  using number = big_float<Degree + 1>;
  const auto v = polynomials(in_numbers<number>(arguments, [](const T& x) { return exactly<number>(x); })...);
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

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <int Degree, class Polynomials, class... A>
[[nodiscard]] constexpr auto quotients_of(const Polynomials& polynomials, const A&... arguments) noexcept {
  static_assert(Degree >= 1 && Degree <= 5);
  using T = detail::argument_scalar<A...>;
  if constexpr (Floating<T>) {
    bool suits = true;
    const auto twice = [&](const T& x) IRG_INLINE_LAMBDA {
      suits = suits && detail::suits_double_double(widened(x));
      return detail::bounded_double_double(widened(x));
    };
    const auto stages = [&](const auto&... x) IRG_INLINE_LAMBDA {
      std::array<T, std::tuple_size_v<decltype(polynomials(x...))> - 1> nearest{};
      bool sure = suits;
      if (sure) {
        const auto v = polynomials(x...);
        sure = v[0].is_sure() && detail::is_middling(v[0].value);
        const double inverse = sure ? 1 / magnitude(v[0].value) : 0.0;
        for (std::size_t i = 0; i < nearest.size() && sure; ++i)
          sure = detail::divides_surely(v[i + 1], v[0], inverse, nearest[i]);
      }
      return sure ? std::optional(nearest) : detail::exact_quotients_of<Degree, T>(polynomials, arguments...);
    };
    return stages(in_numbers<detail::bounded_double_double>(arguments, twice)...);
  } else {
    const auto v = polynomials(in_numbers<T>(arguments, [](const T& x) { return x; })...);
    std::array<T, std::tuple_size_v<decltype(v)> - 1> nearest{};
    if (sign_of(v[0]) == 0) return std::optional<decltype(nearest)>();
    for (std::size_t i = 0; i < nearest.size(); ++i) nearest[i] = v[i + 1] / v[0];
    return std::optional(nearest);
  }
}

}  // namespace irg::inline IRG_ABI
