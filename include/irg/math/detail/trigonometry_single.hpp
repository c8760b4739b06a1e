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

/// The angle of the vector (x, y).
/// needs   finite numbers at least 0, not both 0, with exponents of float
IRG_INLINE constexpr double short_angle_in_first_quadrant(double y, double x) noexcept {
  const bool is_steep = x < y;
  const double lesser_one = is_steep ? x : y;
  const double large = is_steep ? y : x;
  const int i = static_cast<int>(lesser_one / large * 64 + 0.5);
  const double slope = i * 0x1p-6;
  const double tangent = (lesser_one - product(slope, large)) / (large + product(slope, lesser_one));
  const double t = product(tangent, tangent);
  const auto& c = arctangent_coefficients;
  const double cube = product(product(tangent, t), c[0] + product(t, c[1] + product(t, c[2])));
  const double angle = arctangent_table[i].high + (tangent + cube);
  return is_steep ? half_pi_high - (angle - half_pi_low) : angle;
}

/// atan2.
/// needs   no NaN
constexpr double angle_of(float y, float x) noexcept {
  const double x_size = widened(magnitude(x)), y_size = widened(magnitude(y));
  if (!is_finite(x_size) || !is_finite(y_size) || y_size == 0) return angle_of(widened(y), widened(x));
  const double angle = short_angle_in_first_quadrant(y_size, x_size);
  return with_sign(is_negative(x) ? straight_angle.value - (angle - straight_angle.error) : angle, widened(y));
}

/// asin and acos.
/// needs   |x| <= 1
constexpr double angle_of_sine(float x) noexcept {
  const double wide = widened(x);
  return with_sign(short_angle_in_first_quadrant(magnitude(wide), sqrt(1 - wide * wide)), wide);
}
constexpr double angle_of_cosine(float x) noexcept {
  const double wide = widened(x);
  const double angle = short_angle_in_first_quadrant(sqrt(1 - wide * wide), magnitude(wide));
  return wide < 0 ? straight_angle.value - (angle - straight_angle.error) : angle;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
