// SPDX-License-Identifier: MIT
// The square root: the processor's instruction at run time, the same bits in constant evaluation.
#pragma once

#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/instructions.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

/// The square root without a square root instruction: Heron's iteration on a significand in [1, 4), then one exact
/// comparison with the middles between the result and its neighbours.
/// needs   x > 0, finite
/// exact   correctly rounded
constexpr double sqrt_of_positive(double x) noexcept {
  const scaled_number parts = decompose(x);
  const bool is_odd = (parts.exponent & 1) != 0;
  const double f = is_odd ? 2 * parts.significand : parts.significand;
  double y = product(0.34, f) + 0.69;  // within 4 %, which four iterations bring within one ulp, 2^-52
  for (int i = 0; i < 4; ++i) y = 0.5 * (y + f / y);
  const exact_sum<double> square = fast_two_product(y, y);
  const double residual = (f - square.value) - square.error;
  // The root lies beyond y + 2^-53 exactly if residual > y * 2^-52 + 2^-106, where both sides but the last term are
  // multiples of 2^-104; on the other side the same term turns the strict comparison into <=.
  if (residual > y * 0x1p-52)
    y += 0x1p-52;
  else if (residual <= -y * 0x1p-52)
    y -= 0x1p-52;
  return y * power_of_two((parts.exponent - (is_odd ? 1 : 0)) / 2);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The square root.
/// gives   -0 for -0, infinity for infinity, NaN for NaN and everything below zero
/// exact   correctly rounded (IEEE 754)
/// cost    one instruction
/// source  IEEE 754; Heron, Metrica, in constant evaluation
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T sqrt(T x) noexcept {
  if (!std::is_constant_evaluated()) return square_root_instruction(x);
  if (!(x > T(0))) return x == T(0) ? x : not_a_number<T>;
  // A float's root taken in double rounds to the right float: 53 >= 2 * 24 + 2 bits.
  return is_finite(x) ? converted<T>(detail::sqrt_of_positive(widened(x))) : x;
}

}  // namespace IRG_ABI
}  // namespace irg
