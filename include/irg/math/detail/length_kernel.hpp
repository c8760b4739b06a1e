// SPDX-License-Identifier: MIT
// Lengths and directions of floats, whose squares are exact in double and stay far inside its range. Run time looks at
// their sum alone; constant evaluation, where a NaN must not come out of a sum, at the coordinates first.
#pragma once

#include <concepts>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::detail::inline IRG_ABI {

/// The length of the vector of these coordinates.
template <std::same_as<float>... Ts>
IRG_INLINE constexpr float float_length(Ts... coordinates) noexcept {
  const auto has_infinity = [&]() IRG_INLINE_LAMBDA { return ((magnitude(coordinates) == infinity<float>) | ...); };
  if (std::is_constant_evaluated() && ((is_nan(coordinates) || ...) || has_infinity()))
    return has_infinity() ? infinity<float> : not_a_number<float>;
  double sum = 0;
  ((sum = sum + widened(coordinates) * widened(coordinates)), ...);
  const float length = narrow<float>(sqrt(sum));
  return is_nan(sum) && has_infinity() ? infinity<float> : length;
}

/// Puts a vector's direction into `unit`, zero where there is none, and says whether there is one.
template <Vector V>
IRG_INLINE constexpr bool put_float_direction(const V& v, V& unit) noexcept {
  double c[static_cast<std::size_t>(size_of<V>)]{}, square = 0;
  bool is_known = true;
  for (int i = 0; i < size_of<V>; ++i) {
    c[i] = widened(coordinate(v, i));
    if (std::is_constant_evaluated()) is_known = is_known && is_finite(c[i]);
  }
  if (is_known)
    for (const double x : c) square = square + x * x;
  const bool has_direction = (square > 0) & (square < infinity<double>);
  const double factor = 1 / sqrt(has_direction ? square : 1.0);
  unit = generate_coordinates<V>(
      [&](int i) IRG_INLINE_LAMBDA { return converted<float>(has_direction ? product(c[i], factor) : 0.0); });
  return has_direction;
}

}  // namespace irg::detail::inline IRG_ABI
