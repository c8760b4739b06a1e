// SPDX-License-Identifier: MIT
// Sine, cosine, tangent and their inverses, the same bits in constant evaluation and at run time, on every compiler and
// instruction set. float arguments are computed in double and rounded once more.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/detail/hard_floats.hpp>
#include <irg/math/detail/tangent_kernels.hpp>
#include <irg/math/detail/trigonometry_kernels.hpp>
#include <irg/math/detail/trigonometry_single.hpp>
#include <irg/math/hypot.hpp>

namespace irg {

/// The sine and cosine of one angle.
template <Floating T>
struct sine_and_cosine {
  T sine{}, cosine{};
  friend constexpr bool operator==(const sine_and_cosine&, const sine_and_cosine&) = default;
};

namespace detail {
inline namespace IRG_ABI {

template <Floating T, class Angle>
IRG_INLINE constexpr T nearest_sine(T x, const Angle& angle) noexcept {
  return nearest_result<symmetry::odd>(x, rounded_sine(angle), hard_sines);
}
template <Floating T, class Angle>
IRG_INLINE constexpr T nearest_cosine(T x, const Angle& angle) noexcept {
  return nearest_result<symmetry::even>(x, rounded_cosine(angle), hard_cosines);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The sine and the cosine of x at once.
/// units   radians
/// gives   NaN for infinity and NaN; sine -0 for -0
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    about one and a half sines
template <Floating T>
[[nodiscard]] constexpr sine_and_cosine<T> sin_cos(T x) noexcept {
  if (!detail::is_finite(x)) return {detail::not_a_number<T>, detail::not_a_number<T>};
  const auto angle = detail::reduce_radians(x);
  return {detail::is_tiny_angle(x) ? x : detail::nearest_sine(x, angle), detail::nearest_cosine(x, angle)};
}

/// The sine of x.
/// units   radians
/// gives   NaN for infinity and NaN; -0 for -0
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    a table lookup and about 40 operations, 60 more from 2^20 on; float: about 20
/// source  Payne and Hanek 1983 (huge arguments); Gal 1986 (tables); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] constexpr T sin(T x) noexcept {
  if (detail::is_tiny_angle(x)) return x;
  if (!detail::is_finite(x)) return detail::not_a_number<T>;
  return detail::nearest_sine(x, detail::reduce_radians(x));
}

/// The cosine of x.
/// units   radians
/// gives   NaN for infinity and NaN
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    as sin
/// source  as sin
template <Floating T>
[[nodiscard]] constexpr T cos(T x) noexcept {
  if (!detail::is_finite(x)) return detail::not_a_number<T>;
  return detail::nearest_cosine(x, detail::reduce_radians(x));
}

/// The tangent of x.
/// units   radians
/// gives   NaN for infinity and NaN; -0 for -0; never infinity, because no number is an odd multiple of pi/2
/// exact   double within 0.54 ulp for every x up to the largest; float the nearest one
/// cost    that of sin, and a division for every other quadrant; float: a division and two sines
/// source  Payne and Hanek 1983 (huge arguments); Gal 1986 (tables); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] constexpr T tan(T x) noexcept {
  if (detail::is_tiny_angle(x)) return x;
  if (!detail::is_finite(x)) return detail::not_a_number<T>;
  return detail::narrow<T>(detail::rounded_tangent(detail::reduce_radians(x)));
}

/// The angle of x degrees in radians.
/// exact   double within 0.51 ulp, subnormal results too; float the nearest one
template <Floating T>
[[nodiscard]] constexpr T radians(T x) noexcept {
  return detail::narrow<T>(detail::multiply_by_constant(widened(x), detail::degree_high, detail::degree_low));
}

/// The angle of x radians in degrees.
/// exact   double within 0.51 ulp, float the nearest one
template <Floating T>
[[nodiscard]] constexpr T degrees(T x) noexcept {
  return detail::narrow<T>(detail::multiply_by_constant(widened(x), detail::radian_high, detail::radian_low));
}

/// The sine and the cosine of an angle in degrees.
/// units   degrees
/// gives   NaN for infinity and NaN; exactly 0, 1/2 and 1 with their signs where they are due, for every multiple of
///         30 degrees; a sine of zero has the sign of x
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    as sin_cos, and an exact product
template <Floating T>
[[nodiscard]] constexpr sine_and_cosine<T> sin_cos_degrees(T x) noexcept {
  if (!detail::is_finite(x)) return {detail::not_a_number<T>, detail::not_a_number<T>};
  if (detail::is_tiny_angle(x)) return {radians(x), T(1)};
  const detail::quadrant_angle angle = detail::reduce_degrees(widened(x));
  const T sine = detail::narrow<T>(detail::rounded_sine(angle));
  return {sine == 0 && detail::is_negative(x) ? T(-0.0) : sine + T(0),
          detail::narrow<T>(detail::rounded_cosine(angle)) + T(0)};
}

/// The sine of x degrees.
/// units   degrees
/// gives   as sin_cos_degrees
/// exact   as sin_cos_degrees
template <Floating T>
[[nodiscard]] constexpr T sin_degrees(T x) noexcept {
  return sin_cos_degrees(x).sine;
}

/// The cosine of x degrees.
/// units   degrees
/// gives   as sin_cos_degrees
/// exact   as sin_cos_degrees
template <Floating T>
[[nodiscard]] constexpr T cos_degrees(T x) noexcept {
  return sin_cos_degrees(x).cosine;
}

/// The angle of the vector (x, y): from the positive x axis, counter-clockwise positive.
/// units   radians in [-pi, pi]
/// gives   y's sign always; 0 or pi for y = 0, by the sign of x, both zero included; the diagonals for infinities; NaN
///         for NaN
/// exact   double within 0.52 ulp over the whole range; float within 0.5001 ulp
/// cost    a division, an exact product, a table lookup and about 30 operations; float: a division
/// source  Gal 1986 (tables); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] constexpr T atan2(T y, T x) noexcept {
  if (detail::is_nan(x) || detail::is_nan(y)) return detail::not_a_number<T>;
  const double wide_y = widened(y), wide_x = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (detail::is_finite(x) && detail::is_finite(y) && y != 0)
      if (const double quick =
              detail::quick_angle_of(detail::magnitude(wide_y), detail::magnitude(wide_x), detail::is_negative(x));
          quick >= 0x1p-126 && detail::rounds_to_one_float<(1 << 19)>(quick))
        return converted<float>(detail::with_sign(quick, wide_y));
  return detail::narrow<T>(detail::angle_of(wide_y, wide_x));
}

/// The same for numbers of different types, and integers.
template <class Y, class X>
  requires MixedArguments<Y, X>
[[nodiscard]] constexpr double atan2(Y y, X x) noexcept {
  return atan2(static_cast<double>(y), static_cast<double>(x));
}

/// The arctangent of x.
/// units   radians in [-pi/2, pi/2]
/// gives   NaN for NaN; -0 for -0
/// exact   double within 0.52 ulp; float the nearest one
/// cost    a table lookup and about 20 operations, and beyond 1 a division and an exact product; float: as atan2
/// source  as atan2
template <Floating T>
[[nodiscard]] constexpr T atan(T x) noexcept {
  if (detail::is_nan(x)) return detail::not_a_number<T>;
  const double wide = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (const double quick = detail::times_sign(detail::quick_angle_of(detail::magnitude(wide), 1, false), wide);
        detail::rounds_to_one_float<(1 << 19)>(quick))
      return converted<float>(quick);
  return detail::nearest_result<detail::symmetry::odd>(x, detail::arctangent(wide), detail::hard_arctangents);
}

/// The angle whose sine is x.
/// units   radians in [-pi/2, pi/2]
/// gives   NaN for |x| > 1 and NaN; -0 for -0
/// exact   double within 0.53 ulp; float the nearest one
/// cost    a table lookup and about 20 operations, and for |x| > 1/2 a root, a division and an exact product; float:
///         a root and about 20 operations
/// source  as atan2; beyond 1/2 by the half angle, asin(x) = pi/2 - 2 asin(sqrt((1 - x) / 2))
template <Floating T>
[[nodiscard]] constexpr T asin(T x) noexcept {
  if (!(detail::magnitude(x) <= 1)) return detail::not_a_number<T>;
  const double wide = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (const double quick = detail::quick_angle_of_sine(wide); detail::rounds_to_one_float<(1 << 19)>(quick))
      return converted<float>(quick);
  return detail::is_tiny_angle(x) ? x : detail::narrow<T>(detail::angle_of_sine(wide));
}

/// The angle whose cosine is x.
/// units   radians in [0, pi]
/// gives   NaN for |x| > 1 and NaN; 0 for 1
/// exact   double within 0.53 ulp; float the nearest one
/// cost    as asin
/// source  as asin
template <Floating T>
[[nodiscard]] constexpr T acos(T x) noexcept {
  if (!(detail::magnitude(x) <= 1)) return detail::not_a_number<T>;
  const double wide = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (const double quick = detail::quick_angle_of_cosine(wide); detail::rounds_to_one_float<(1 << 19)>(quick))
      return converted<float>(quick);
  return detail::nearest_result<detail::symmetry::none>(x, detail::angle_of_cosine(wide), detail::hard_arccosines);
}

}  // namespace IRG_ABI
}  // namespace irg
