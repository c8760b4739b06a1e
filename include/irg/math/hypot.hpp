// SPDX-License-Identifier: MIT
// The length of a vector of two or three coordinates, over the whole range of exponents.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

/// The square root of the sum of the squares of three numbers, the first of them the largest.
/// needs   2^-400 <= largest <= 2^500, the others anything from 0 up to it; or all of them multiples of 2^-474
IRG_INLINE constexpr unrounded length_of_moderate(double largest, double y, double z) noexcept {
  // A coordinate below 2^-460 adds nothing to the others, so the underflow of its square's error does not matter.
  const unrounded xx = fast_two_product(largest, largest);
  const unrounded yy = fast_two_product(y, y);
  const unrounded zz = fast_two_product(z, z);
  return unrounded_sqrt(add(add(xx, yy), zz));
}

/// needs   finite arguments
constexpr double hypotenuse(double x, double y, double z) noexcept {
  double largest = magnitude(x), middle = magnitude(y), last = magnitude(z);
  const auto exchange = [](double& a, double& b) {
    const double larger = a < b ? b : a;
    b = a < b ? a : b;
    a = larger;
  };
  exchange(largest, middle);
  exchange(largest, last);
  if (largest >= 0x1p-400 && largest <= 0x1p500) return round(length_of_moderate(largest, middle, last));
  if (largest == 0) return 0;
  if (largest > 1) {
    const double result = round(length_of_moderate(largest * 0x1p-540, middle * 0x1p-540, last * 0x1p-540));
    return result >= 0x1p484 ? infinity<double> : result * 0x1p540;
  }
  const unrounded result = length_of_moderate(largest * 0x1p600, middle * 0x1p600, last * 0x1p600);
  constexpr double first_normal =
      0x1p-422;  // whose last place is 2^-474: what becomes subnormal is rounded by it, once
  if (result.value >= first_normal) return round(result) * 0x1p-600;
  const unrounded sum = fast_two_sum(first_normal, result.value);
  return ((sum.value + (sum.error + result.error)) - first_normal) * 0x1p-600;
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
  if (detail::magnitude(x) == detail::infinity<T> || detail::magnitude(y) == detail::infinity<T> ||
      detail::magnitude(z) == detail::infinity<T>)
    return detail::infinity<T>;
  if (detail::is_nan(x) || detail::is_nan(y) || detail::is_nan(z)) return detail::not_a_number<T>;
  if constexpr (std::is_same_v<T, double>) {
    return detail::hypotenuse(x, y, z);
  } else {
    // In double the squares are exact and cannot overflow.
    const double xx = widened(x) * widened(x);
    const double yy = widened(y) * widened(y);
    const double zz = widened(z) * widened(z);
    return detail::narrow<T>(sqrt((xx + yy) + zz));
  }
}

/// The length of the hypotenuse, the square root of x*x + y*y.
/// gives   as hypot of three
/// exact   as hypot of three
/// cost    a square root, a division, three exact products; float: a square root
template <Floating T>
constexpr T hypot(T x, T y) noexcept {
  return hypot(x, y, T(0));
}

}  // namespace IRG_ABI
}  // namespace irg
