// SPDX-License-Identifier: MIT
// Sine, cosine, tangent and their inverses, the same bits in constant evaluation and at run time, on every compiler and
// instruction set. float arguments are computed in double and rounded once more.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/detail/hard_floats.hpp>
#include <irg/math/detail/tangent_kernels.hpp>
#include <irg/math/detail/trigonometry_kernels.hpp>
#include <irg/math/hypot.hpp>

namespace irg {

/// The sine and cosine of one angle.
template <Floating T>
struct sine_and_cosine {
  T sine{}, cosine{};
  friend constexpr bool operator==(const sine_and_cosine&, const sine_and_cosine&) = default;
};

inline namespace IRG_ABI {

/// The sine and the cosine of x at once.
/// units   radians
/// gives   NaN for infinity and NaN; sine -0 for -0
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    about one and a half sines
template <Floating T>
[[nodiscard]] constexpr sine_and_cosine<T> sin_cos(T x) noexcept;

/// The sine of x.
/// units   radians
/// gives   NaN for infinity and NaN; -0 for -0
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    a table lookup and about 40 operations, 60 more from 2^20 on; float: about 20
/// source  Payne and Hanek 1983 (huge arguments); Gal 1986 (tables); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] constexpr T sin(T x) noexcept;

/// The cosine of x.
/// units   radians
/// gives   NaN for infinity and NaN
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    as sin
/// source  as sin
template <Floating T>
[[nodiscard]] constexpr T cos(T x) noexcept;

/// The tangent of x.
/// units   radians
/// gives   NaN for infinity and NaN; -0 for -0; never infinity, because no number is an odd multiple of pi/2
/// exact   double within 0.54 ulp for every x up to the largest; float the nearest one
/// cost    that of sin, and a division for every other quadrant; float: a division and two sines
/// source  Payne and Hanek 1983 (huge arguments); Gal 1986 (tables); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] constexpr T tan(T x) noexcept;

/// The angle of x degrees in radians.
/// exact   double within 0.51 ulp, subnormal results too; float the nearest one
template <Floating T>
[[nodiscard]] constexpr T radians(T x) noexcept {
  return narrowed<T>(detail::multiply_by_constant(widened(x), detail::degree_high, detail::degree_low));
}

/// The angle of x radians in degrees.
/// exact   double within 0.51 ulp, float the nearest one
template <Floating T>
[[nodiscard]] constexpr T degrees(T x) noexcept {
  return narrowed<T>(detail::multiply_by_constant(widened(x), detail::radian_high, detail::radian_low));
}

/// The sine and the cosine of an angle in degrees.
/// units   degrees
/// gives   NaN for infinity and NaN; exactly 0, 1/2 and 1 with their signs where they are due, for every multiple of
///         30 degrees; a sine of zero has the sign of x
/// exact   double within 0.55 ulp for every x up to the largest; float the nearest one
/// cost    as sin_cos, and an exact product
template <Floating T>
[[nodiscard]] constexpr sine_and_cosine<T> sin_cos_degrees(T x) noexcept;

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
[[nodiscard]] constexpr T atan2(T y, T x) noexcept;

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
[[nodiscard]] constexpr T atan(T x) noexcept;

/// The angle whose sine is x.
/// units   radians in [-pi/2, pi/2]
/// gives   NaN for |x| > 1 and NaN; -0 for -0
/// exact   double within 0.53 ulp; float the nearest one
/// cost    a table lookup and about 20 operations, and for |x| > 1/2 a root, a division and an exact product; float:
///         a root and about 20 operations
/// source  as atan2; beyond 1/2 by the half angle, asin(x) = pi/2 - 2 asin(sqrt((1 - x) / 2))
template <Floating T>
[[nodiscard]] constexpr T asin(T x) noexcept;

/// The angle whose cosine is x.
/// units   radians in [0, pi]
/// gives   NaN for |x| > 1 and NaN; 0 for 1
/// exact   double within 0.53 ulp; float the nearest one
/// cost    as asin
/// source  as asin
template <Floating T>
[[nodiscard]] constexpr T acos(T x) noexcept;

}  // namespace IRG_ABI

namespace detail {

// The trigonometric functions of float arguments, in plain double: some 2^-50 of relative error, so that the float
// nearest to the result is the right one but for about one argument in 2^24.

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

template <Floating T>
[[nodiscard]] constexpr sine_and_cosine<T> sin_cos(T x) noexcept {
  if (!is_finite(x)) return {not_a_number<T>, not_a_number<T>};
  const auto angle = detail::reduce_radians(x);
  return {detail::is_tiny_angle(x) ? x : detail::nearest_sine(x, angle), detail::nearest_cosine(x, angle)};
}

template <Floating T>
[[nodiscard]] constexpr T sin(T x) noexcept {
  if (detail::is_tiny_angle(x)) return x;
  if (!is_finite(x)) return not_a_number<T>;
  return detail::nearest_sine(x, detail::reduce_radians(x));
}

template <Floating T>
[[nodiscard]] constexpr T cos(T x) noexcept {
  if (!is_finite(x)) return not_a_number<T>;
  return detail::nearest_cosine(x, detail::reduce_radians(x));
}

template <Floating T>
[[nodiscard]] constexpr T tan(T x) noexcept {
  if (detail::is_tiny_angle(x)) return x;
  if (!is_finite(x)) return not_a_number<T>;
  return narrowed<T>(detail::rounded_tangent(detail::reduce_radians(x)));
}

template <Floating T>
[[nodiscard]] constexpr sine_and_cosine<T> sin_cos_degrees(T x) noexcept {
  if (!is_finite(x)) return {not_a_number<T>, not_a_number<T>};
  if (detail::is_tiny_angle(x)) return {radians(x), T(1)};
  const detail::quadrant_angle angle = detail::reduce_degrees(widened(x));
  const T sine = narrowed<T>(detail::rounded_sine(angle));
  return {sine == 0 && is_negative(x) ? T(-0.0) : sine + T(0), narrowed<T>(detail::rounded_cosine(angle)) + T(0)};
}

template <Floating T>
[[nodiscard]] constexpr T atan2(T y, T x) noexcept {
  if (is_nan(x) || is_nan(y)) return not_a_number<T>;
  const double wide_y = widened(y), wide_x = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (is_finite(x) && is_finite(y) && y != 0)
      if (const double quick = detail::quick_angle_of(magnitude(wide_y), magnitude(wide_x), is_negative(x));
          quick >= 0x1p-126 && detail::rounds_to_one_float<(1 << 19)>(quick))
        return converted<float>(with_sign(quick, wide_y));
  return narrowed<T>(detail::angle_of(wide_y, wide_x));
}

template <Floating T>
[[nodiscard]] constexpr T atan(T x) noexcept {
  if (is_nan(x)) return not_a_number<T>;
  const double wide = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (const double quick = detail::times_sign(detail::quick_angle_of(magnitude(wide), 1, false), wide);
        detail::rounds_to_one_float<(1 << 19)>(quick))
      return converted<float>(quick);
  return detail::nearest_result<detail::symmetry::odd>(x, detail::arctangent(wide), detail::hard_arctangents);
}

template <Floating T>
[[nodiscard]] constexpr T asin(T x) noexcept {
  if (!(magnitude(x) <= 1)) return not_a_number<T>;
  const double wide = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (const double quick = detail::quick_angle_of_sine(wide); detail::rounds_to_one_float<(1 << 19)>(quick))
      return converted<float>(quick);
  return detail::is_tiny_angle(x) ? x : narrowed<T>(detail::angle_of_sine(wide));
}

template <Floating T>
[[nodiscard]] constexpr T acos(T x) noexcept {
  if (!(magnitude(x) <= 1)) return not_a_number<T>;
  const double wide = widened(x);
  if constexpr (std::is_same_v<T, float>)
    if (const double quick = detail::quick_angle_of_cosine(wide); detail::rounds_to_one_float<(1 << 19)>(quick))
      return converted<float>(quick);
  return detail::nearest_result<detail::symmetry::none>(x, detail::angle_of_cosine(wide), detail::hard_arccosines);
}

// Plain forms of the functions that the C library has in the global namespace. Beside the templates alone, a bare
// sin(x) after `using namespace irg` would be the C library's, without a word and with other bits; so it is ambiguous.
[[nodiscard]] constexpr double sin(double x) noexcept { return sin<double>(x); }
[[nodiscard]] constexpr float sin(float x) noexcept { return sin<float>(x); }
[[nodiscard]] constexpr double cos(double x) noexcept { return cos<double>(x); }
[[nodiscard]] constexpr float cos(float x) noexcept { return cos<float>(x); }
[[nodiscard]] constexpr double tan(double x) noexcept { return tan<double>(x); }
[[nodiscard]] constexpr float tan(float x) noexcept { return tan<float>(x); }
[[nodiscard]] constexpr double asin(double x) noexcept { return asin<double>(x); }
[[nodiscard]] constexpr float asin(float x) noexcept { return asin<float>(x); }
[[nodiscard]] constexpr double acos(double x) noexcept { return acos<double>(x); }
[[nodiscard]] constexpr float acos(float x) noexcept { return acos<float>(x); }
[[nodiscard]] constexpr double atan(double x) noexcept { return atan<double>(x); }
[[nodiscard]] constexpr float atan(float x) noexcept { return atan<float>(x); }
[[nodiscard]] constexpr double atan2(double y, double x) noexcept { return atan2<double>(y, x); }
[[nodiscard]] constexpr float atan2(float y, float x) noexcept { return atan2<float>(y, x); }

}  // namespace IRG_ABI
}  // namespace irg
