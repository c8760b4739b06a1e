// SPDX-License-Identifier: MIT
// The length of a vector of two or three coordinates, over the whole range of exponents.
#pragma once

#include <concepts>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/hypot_steps.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::inline IRG_ABI {

/// The length of (x, y, z), the square root of x*x + y*y + z*z.
/// gives   infinity when an argument is infinite, else NaN when one is NaN; infinity when the length overflows
/// exact   double within 0.50001 ulp, float within 0.5001 ulp, over the whole range: no spurious overflow or underflow
/// cost    a square root, a division, twelve products; float: a square root
/// source  Borges 2019 (the correction of the root)
template <Floating T>
[[nodiscard]] constexpr T hypot(T x, T y, T z) noexcept {
  return detail::hypot_of(x, y, z);
}

/// The length of the hypotenuse, the square root of x*x + y*y.
/// gives   as hypot of three
/// exact   as hypot of three
/// cost    a square root, a division, nine products; float: a square root
template <Floating T>
[[nodiscard]] constexpr T hypot(T x, T y) noexcept {
  return detail::hypot_of(x, y);
}

/// The same for numbers of different types, and integers.
template <class X, class Y>
  requires MixedArguments<X, Y>
[[nodiscard]] constexpr double hypot(X x, Y y) noexcept {
  return hypot(static_cast<double>(x), static_cast<double>(y));
}
template <class X, class Y, class Z>
  requires MixedArguments<X, Y, Z>
[[nodiscard]] constexpr double hypot(X x, Y y, Z z) noexcept {
  return hypot(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
}

}  // namespace irg::inline IRG_ABI
