// SPDX-License-Identifier: MIT
// The steps of quotients_of.hpp.
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

namespace irg::detail::inline IRG_ABI {

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

template <int Degree, Floating T, class Polynomials, class... A>
IRG_NOINLINE constexpr auto exact_quotients_of(const Polynomials& polynomials, const A&... arguments) noexcept {
  using number = exact_number<Degree + 1>;
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
