// SPDX-License-Identifier: MIT
// The length of a vector of two or three coordinates, over the whole range of exponents.
#pragma once

#include <concepts>

#include <irg/core/conversion.hpp>
#include <irg/core/lanes.hpp>
#include <irg/math/detail/length_kernel.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::inline IRG_ABI {

/// The length of (x, y, z), the square root of x*x + y*y + z*z.
/// gives   infinity when an argument is infinite, else NaN when one is NaN; infinity when the length overflows
/// exact   double within 0.50001 ulp, float within 0.5001 ulp, over the whole range: no spurious overflow or underflow
/// cost    a square root, a division, twelve products; float: a square root
/// source  Borges 2019 (the correction of the root)
template <Floating T>
[[nodiscard]] constexpr T hypot(T x, T y, T z) noexcept;

/// The length of the hypotenuse, the square root of x*x + y*y.
/// gives   as hypot of three
/// exact   as hypot of three
/// cost    a square root, a division, nine products; float: a square root
template <Floating T>
[[nodiscard]] constexpr T hypot(T x, T y) noexcept;

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

/// The sum of the squares, of numbers or of registers of them.
/// exact   each square and each sum rounded once, from left to right, never fused
template <class F, std::same_as<F>... Others>
[[nodiscard]] IRG_INLINE constexpr F sum_of_squares(const F& first, const Others&... others) noexcept {
  F sum = product(first, first);
  ((sum = sum + product(others, others)), ...);
  return sum;
}

/// hypot of three whose squares and root are known, without care for the ends of the exponents: for loops over arrays
/// and registers, which take their roots apart.
/// shape   x, y, z: doubles, or registers of doubles
/// needs   square = sum_of_squares(x, y, z), from 2^-800 to 2^1000; root, its square root; no number negative
/// exact   the bits of hypot
template <class F>
[[nodiscard]] IRG_INLINE constexpr F hypot_from_root(const F& square, const F& root, const F& x, const F& y,
                                                     const F& z) noexcept {
  const F rest = detail::rest_of_squares_one_by_one(root, detail::grid_below_root(square), x, y, z);
  return root + product(rest, lanes<F>::broadcast(0.5) / root);
}

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

/// Whether squares of numbers up to that size neither overflow nor vanish.
IRG_INLINE constexpr bool has_moderate_square(double largest) noexcept {
  return largest >= 0x1p-400 && largest <= 0x1p500;
}

/// The length of numbers of any size.
/// needs   finite sizes
template <std::same_as<double>... Sizes>
constexpr double hypotenuse_of_sizes(Sizes... sizes) noexcept {
  const auto length_of = [](auto... scaled)
                             IRG_INLINE_LAMBDA { return length_of_moderate(sum_of_squares(scaled...), scaled...); };
  double largest = 0;
  ((largest = maximum(sizes, largest)), ...);
  if (has_moderate_square(largest)) return round(length_of(sizes...));
  if (largest == 0) return 0;
  if (largest > 1) {
    const double result = round(length_of((sizes * 0x1p-540)...));
    return result >= 0x1p484 ? infinity<double> : result * 0x1p540;
  }
  // The root is off by some last places, so its nearest double is taken before it is asked on which side it lies.
  const unrounded result = renormalised(length_of((sizes * 0x1p600)...));
  constexpr double first_normal =
      0x1p-422;  // whose last place is 2^-474: what becomes subnormal is rounded by it, once
  if (result.value >= first_normal) return round(result) * 0x1p-600;
  const unrounded sum = fast_two_sum(first_normal, result.value);
  return ((sum.value + (sum.error + result.error)) - first_normal) * 0x1p-600;
}

/// needs   finite arguments
template <std::same_as<double>... Numbers>
constexpr double hypotenuse(Numbers... numbers) noexcept {
  return hypotenuse_of_sizes(magnitude(numbers)...);
}

/// The length of numbers of which one may be infinite or NaN.
template <std::same_as<double>... Numbers>
IRG_NOINLINE constexpr double hypotenuse_of_any(Numbers... numbers) noexcept {
  if (((magnitude(numbers) == infinity<double>) || ...)) return infinity<double>;
  if ((is_nan(numbers) || ...)) return not_a_number<double>;
  return hypotenuse(numbers...);
}

/// hypot of any number of coordinates.
template <Floating T, std::same_as<T>... Others>
IRG_INLINE constexpr T hypot_of(T first, Others... others) noexcept {
  if constexpr (std::is_same_v<T, double>) {
    if (!can_take_squares(first, others...)) return hypotenuse_of_any(first, others...);
    const double square = sum_of_squares(first, others...);
    if (!is_moderate_square(square)) return hypotenuse_of_any(first, others...);
    return round(length_of_moderate(square, magnitude(first), magnitude(others)...));
  } else {
    return float_length(first, others...);
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr T hypot(T x, T y, T z) noexcept {
  return detail::hypot_of(x, y, z);
}

template <Floating T>
[[nodiscard]] constexpr T hypot(T x, T y) noexcept {
  return detail::hypot_of(x, y);
}

// Plain forms, for the reason given in trigonometry.hpp.
[[nodiscard]] constexpr double hypot(double x, double y) noexcept { return hypot<double>(x, y); }
[[nodiscard]] constexpr float hypot(float x, float y) noexcept { return hypot<float>(x, y); }

}  // namespace irg::inline IRG_ABI
