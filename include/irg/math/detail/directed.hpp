// SPDX-License-Identifier: MIT
// Sums, products, quotients and roots rounded downwards, without touching the rounding mode: the rounded result and the
// sign of its exact error. Rounding upwards is rounding the negative downwards.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/unrounded.hpp>

namespace irg::detail::inline IRG_ABI {

template <Floating T>
inline constexpr T largest_number = (std::numeric_limits<T>::max)();

/// The largest number below x.
/// needs   x is not -infinity
template <Floating T>
IRG_INLINE constexpr T next_down(T x) noexcept {
  using bits_type = std::conditional_t<std::is_same_v<T, double>, std::uint64_t, std::uint32_t>;
  if (x == 0) return -std::numeric_limits<T>::denorm_min();
  const auto bits = std::bit_cast<bits_type>(x);
  return std::bit_cast<T>(static_cast<bits_type>(x < 0 ? bits + 1 : bits - 1));
}

/// The rounded result, or its neighbour below where that is too large.
template <Floating T>
IRG_INLINE constexpr T lowered(T rounded, bool is_too_large) noexcept {
  if (rounded == infinity<T>) return largest_number<T>;
  return is_too_large && rounded != -infinity<T> ? next_down(rounded) : rounded;
}

/// Below the range in which errors are known: one step down, but not from positive numbers to negative ones.
template <Floating T>
IRG_INLINE constexpr T lowered_blindly(T rounded, bool is_positive) noexcept {
  return rounded == 0 && is_positive ? T(0) : lowered(rounded, true);
}

/// a + b, rounded downwards.
/// needs   a and b below infinity
template <Floating T>
constexpr T sum_down(T a, T b) noexcept {
  if (a == -infinity<T> || b == -infinity<T>) return -infinity<T>;
  if (is_refused_sum(a, b)) return a < 0 ? -infinity<T> : largest_number<T>;
  const auto [value, error] = two_sum(a, b);
  return lowered(value, error < 0);
}

/// a*b, rounded downwards; 0 times infinity is 0, as it is for the end points of intervals.
template <Floating T>
constexpr T product_down(T a, T b) noexcept {
  if (a == 0 || b == 0) return T(0);
  const bool is_positive = (a < 0) == (b < 0);
  if (!is_finite(a) || !is_finite(b)) return is_positive ? infinity<T> : -infinity<T>;
  if constexpr (std::is_same_v<T, float>) {
    const double exact = widened(a) * widened(b);
    const T value = narrow<T>(exact);
    return lowered(value, widened(value) > exact);
  } else {
    const auto [value, error] = two_product(a, b);
    return magnitude(value) < 0x1p-960 ? lowered_blindly(value, is_positive) : lowered(value, error < 0);
  }
}

/// a/b, rounded downwards; infinity over infinity is 0.
/// needs   b > 0
template <Floating T>
constexpr T quotient_down(T a, T b) noexcept {
  if (a == 0 || !is_finite(b)) return T(0);
  const bool is_positive = a > 0;
  if (!is_finite(a)) return is_positive ? infinity<T> : -infinity<T>;
  if constexpr (std::is_same_v<T, float>) {
    const T value = narrow<T>(widened(a) / widened(b));
    const double back = widened(value) * widened(b);
    return lowered(value, back > widened(a));
  } else {
    if (is_refused_quotient(a, b)) return is_positive ? largest_number<T> : -infinity<T>;
    const T value = a / b;
    if (!(magnitude(a) < 0x1p1020 && magnitude(value) > 0x1p-960 && magnitude(value) < 0x1p1020))
      return lowered_blindly(value, is_positive);
    // A dividend near the smallest number and the smaller factor are scaled, so that the error is a number.
    const T up = magnitude(a) > 0x1p-900 ? T(1) : T(0x1p200);
    const bool is_large = magnitude(value) > 1;
    const auto [back, error] = two_product(is_large ? value : value * up, is_large ? b * up : b);
    const T rest = (a * up - back) - error;  // exact, as the remainder of every division
    return lowered(value, rest < 0);
  }
}

/// The square root, rounded downwards or upwards.
/// needs   x >= 0
template <Floating T>
constexpr T sqrt_directed(T x, bool upwards) noexcept {
  if (x == 0 || !is_finite(x)) return x;
  const T root = sqrt(x);
  double rest = 0;
  if constexpr (std::is_same_v<T, float>) {
    rest = widened(x) - widened(root) * widened(root);
  } else {
    const bool is_small = x < 0x1p-900;
    const auto [back, error] = two_product(is_small ? root * 0x1p100 : root, is_small ? root * 0x1p100 : root);
    rest = ((is_small ? x * 0x1p200 : x) - back) - error;
  }
  if (upwards) return rest > 0 ? -next_down(-root) : root;
  return lowered(root, rest < 0);
}

}  // namespace irg::detail::inline IRG_ABI
