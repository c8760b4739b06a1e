// SPDX-License-Identifier: MIT
// The steps of hypot.hpp.
#pragma once

#include <concepts>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/length_kernel.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::detail::inline IRG_ABI {

/// The square root of the sum of the squares of numbers, the first of them the largest.
/// needs   2^-400 <= largest <= 2^500, the others anything from 0 up to it; or all of them multiples of 2^-474
template <class... Others>
IRG_INLINE constexpr unrounded length_of_moderate(double largest, Others... others) noexcept {
  // A coordinate below 2^-460 adds nothing to the others, so the underflow of its square's error does not matter.
  unrounded sum = fast_two_product(largest, largest);
  const auto add_square = [&](double x) IRG_INLINE_LAMBDA {
    const unrounded square = fast_two_product(x, x), heads = fast_two_sum(sum.value, square.value);
    sum = {heads.value, sum.error + (heads.error + square.error)};
  };
  (add_square(others), ...);
  return unrounded_sqrt(sum);
}

/// Makes numbers their sizes, the largest the first. A NaN stays one of them.
template <class... Others>
IRG_INLINE constexpr void put_largest_first(double& largest, Others&... others) noexcept {
  largest = magnitude(largest);
  ((others = magnitude(others)), ...);
  const auto exchange = [](double& a, double& b) IRG_INLINE_LAMBDA {
    const double larger = a < b ? b : a;
    b = a < b ? a : b;
    a = larger;
  };
  (exchange(largest, others), ...);
}

/// Whether squares of numbers up to that size neither overflow nor vanish.
IRG_INLINE constexpr bool has_moderate_square(double largest) noexcept {
  return largest >= 0x1p-400 && largest <= 0x1p500;
}

/// The length of numbers of any size.
/// needs   finite sizes, the first of them the largest
template <class... Others>
constexpr double hypotenuse_of_sizes(double largest, Others... others) noexcept {
  if (has_moderate_square(largest)) return round(length_of_moderate(largest, others...));
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

/// needs   finite arguments
template <class... Others>
constexpr double hypotenuse(double largest, Others... others) noexcept {
  put_largest_first(largest, others...);
  return hypotenuse_of_sizes(largest, others...);
}

/// The length of sizes of which one may be infinite or NaN.
template <class... Others>
IRG_NOINLINE constexpr double hypotenuse_of_any(double first, Others... others) noexcept {
  if (first == infinity<double> || ((others == infinity<double>) || ...)) return infinity<double>;
  if (is_nan(first) || (is_nan(others) || ...)) return not_a_number<double>;
  return hypotenuse_of_sizes(first, others...);
}

/// hypot of any number of coordinates.
template <Floating T, std::same_as<T>... Others>
IRG_INLINE constexpr T hypot_of(T first, Others... others) noexcept {
  if constexpr (std::is_same_v<T, double>) {
    put_largest_first(first, others...);
    // Only a NaN makes more of a moderate largest size than the sum's root.
    if (has_moderate_square(first) && ((others <= first) && ...)) return round(length_of_moderate(first, others...));
    return hypotenuse_of_any(first, others...);
  } else {
    return float_length(first, others...);
  }
}

}  // namespace irg::detail::inline IRG_ABI
