// SPDX-License-Identifier: MIT
// The steps of hypot.hpp.
#pragma once

#include <concepts>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

/// The square root of the sum of the squares of numbers, the first of them the largest.
/// needs   2^-400 <= largest <= 2^500, the others anything from 0 up to it; or all of them multiples of 2^-474
template <class... Others>
IRG_INLINE constexpr unrounded length_of_moderate(double largest, Others... others) noexcept {
  // A coordinate below 2^-460 adds nothing to the others, so the underflow of its square's error does not matter.
  unrounded sum = fast_two_product(largest, largest);
  ((sum = add(sum, fast_two_product(others, others))), ...);
  return unrounded_sqrt(sum);
}

/// needs   finite arguments
template <class... Others>
constexpr double hypotenuse(double largest, Others... others) noexcept {
  largest = magnitude(largest);
  ((others = magnitude(others)), ...);
  const auto exchange = [](double& a, double& b) {
    const double larger = a < b ? b : a;
    b = a < b ? a : b;
    a = larger;
  };
  (exchange(largest, others), ...);
  if (largest >= 0x1p-400 && largest <= 0x1p500) return round(length_of_moderate(largest, others...));
  if (largest == 0) return 0;
  if (largest > 1) {
    const double result = round(length_of_moderate(largest * 0x1p-540, (others * 0x1p-540)...));
    return result >= 0x1p484 ? infinity<double> : result * 0x1p540;
  }
  const unrounded result = length_of_moderate(largest * 0x1p600, (others * 0x1p600)...);
  constexpr double first_normal =
      0x1p-422;  // whose last place is 2^-474: what becomes subnormal is rounded by it, once
  if (result.value >= first_normal) return round(result) * 0x1p-600;
  const unrounded sum = fast_two_sum(first_normal, result.value);
  return ((sum.value + (sum.error + result.error)) - first_normal) * 0x1p-600;
}

/// hypot of any number of coordinates.
template <Floating T, std::same_as<T>... Others>
constexpr T hypot_of(T first, Others... others) noexcept {
  if (magnitude(first) == infinity<T> || ((magnitude(others) == infinity<T>) || ...)) return infinity<T>;
  if (is_nan(first) || (is_nan(others) || ...)) return not_a_number<T>;
  if constexpr (std::is_same_v<T, double>) {
    return hypotenuse(first, others...);
  } else {
    // In double the squares are exact and cannot overflow.
    double sum = widened(first) * widened(first);
    ((sum = sum + widened(others) * widened(others)), ...);
    return narrow<T>(sqrt(sum));
  }
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
