// SPDX-License-Identifier: MIT
// The trigonometric functions of float arguments, in plain double: some 2^-50 of relative error, so that the float
// nearest to the result is the right one but for about one argument in 2^24.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/tangent_kernels.hpp>

namespace irg::detail {

/// The angle quadrant * pi/2 + rest, where |rest| is at most pi/4 and a little.
struct short_quadrant_angle {
  double rest = 0;
  int quadrant = 0;
};

inline namespace IRG_ABI {

/// x modulo pi/2.
/// needs   x finite
IRG_INLINE constexpr short_quadrant_angle reduce_radians(float x) noexcept {
  const double wide = widened(x);
  if (magnitude(wide) >= 0x1p20) {
    const quadrant_angle angle = reduce_huge(wide);
    return {angle.rest.value, angle.quadrant};
  }
  // The first two products and the first difference are exact. No float below 2^20 but 0 is so close to a multiple of
  // pi/2 that the third would cancel.
  const double n = nearest_integer(product(wide, two_over_pi));
  const double rest = (wide - n * half_pi_parts[0]) - n * half_pi_parts[1];
  return {rest - product(n, half_pi_parts[2]), static_cast<int>(n) & 3};
}

IRG_INLINE constexpr double rounded_sine(const short_quadrant_angle& angle) noexcept {
  const double x = angle.rest;
  const double t = product(x, x);
  const double tt = product(t, t);
  const bool is_cosine = (angle.quadrant & 1) != 0;
  const auto& c = is_cosine ? cosine_wide_coefficients : sine_wide_coefficients;
  const double tail =
      (c[0] + product(t, c[1])) + product(tt, (c[2] + product(t, c[3])) + product(tt, c[4] + product(t, c[5])));
  const double result = is_cosine ? (1 - 0.5 * t) + product(tt, tail) : x + product(product(x, t), tail);
  return (angle.quadrant & 2) == 0 ? result : -result;
}

IRG_INLINE constexpr double rounded_cosine(const short_quadrant_angle& angle) noexcept {
  return rounded_sine(short_quadrant_angle{angle.rest, angle.quadrant + 1});
}

IRG_INLINE constexpr double rounded_tangent(const short_quadrant_angle& angle) noexcept {
  return rounded_sine(angle) / rounded_cosine(angle);
}

// The quick ways below are right to within 2^-33: where every number so near rounds to the same float, that is the
// result. So they need no guards, and may be fused: the rounded result stays the same.

/// x + x^3 p(x^2), within 2^-34 the arctangent of 0 <= x <= 1 or the arcsine of 0 <= x <= 1/2.
template <std::size_t N>
IRG_INLINE constexpr double quick_odd(double x, double square, const double (&p)[N]) noexcept {
  const double fourth = square * square;
  double tail = p[N - 2] + square * p[N - 1];
  for (std::size_t i = N - 2; i != 0; i -= 2) tail = (p[i - 2] + square * p[i - 1]) + fourth * tail;
  return x + x * square * tail;
}

/// The angle, 0 to pi, of a vector, from the sizes of its coordinates.
/// needs   no NaN, not both infinite, not both 0, with exponents of float
IRG_INLINE constexpr double quick_angle_of(double y, double x, bool is_backward) noexcept {
  const bool is_steep = x < y;
  const double quotient = (is_steep ? x : y) / (is_steep ? y : x);
  const double angle = quick_odd(quotient, quotient * quotient, arctangent_wide_coefficients);
  return quadrant_bases[(is_backward ? 2 : 0) + (is_steep ? 1 : 0)].value +
         times_sign(angle, is_steep != is_backward ? -1.0 : 1.0);
}

/// The size of the arcsine where `large` is false; beyond, half the arccosine of the size.
IRG_INLINE constexpr double quick_arcsine(double size, bool large) noexcept {
  const double half = 0.5 * (1 - size);
  const double x = large ? sqrt(half) : size;
  return quick_odd(x, large ? half : size * size, arcsine_wide_coefficients);
}

/// asin.
/// needs   |x| <= 1
IRG_INLINE constexpr double quick_angle_of_sine(double x) noexcept {
  const double size = magnitude(x);
  const bool large = size > 0.5;
  const double angle = quick_arcsine(size, large);
  return times_sign(large ? half_pi_high - 2 * angle : angle, x);
}

/// acos.
/// needs   |x| <= 1
IRG_INLINE constexpr double quick_angle_of_cosine(double x) noexcept {
  const double size = magnitude(x);
  const bool large = size > 0.5;
  const double angle = times_sign(quick_arcsine(size, large), x);
  return large ? (x < 0 ? straight_angle.value : 0.0) + 2 * angle : half_pi_high - angle;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
