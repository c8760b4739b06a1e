// SPDX-License-Identifier: MIT
// The length of a vector of two or three coordinates, over the whole range of exponents.
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

inline namespace IRG_ABI {

/// The length of (x, y, z), the square root of x*x + y*y + z*z.
/// gives   infinity when an argument is infinite, else NaN when one is NaN; infinity when the length overflows
/// exact   double within 0.501 ulp, float within 0.5001 ulp, over the whole range: no spurious overflow or underflow
/// cost    a square root, a division, three exact products; float: a square root
/// source  Borges 2019 (the correction of the root)
template <Floating T>
constexpr T hypot(T x, T y, T z) noexcept {
  return detail::hypot_of(x, y, z);
}

/// The length of the hypotenuse, the square root of x*x + y*y.
/// gives   as hypot of three
/// exact   as hypot of three
/// cost    a square root, a division, two exact products; float: a square root
template <Floating T>
constexpr T hypot(T x, T y) noexcept {
  return detail::hypot_of(x, y);
}

/// The same for numbers of different types, and integers.
template <class X, class Y>
  requires MixedArguments<X, Y>
constexpr double hypot(X x, Y y) noexcept {
  return hypot(static_cast<double>(x), static_cast<double>(y));
}
template <class X, class Y, class Z>
  requires MixedArguments<X, Y, Z>
constexpr double hypot(X x, Y y, Z z) noexcept {
  return hypot(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
}

}  // namespace IRG_ABI
}  // namespace irg
