// SPDX-License-Identifier: MIT
// The tangent of a reduced angle, arctangent, arcsine and arccosine: each is a polynomial about the nearest multiple of
// 1/64, added to the table's value there in twice the precision. One division or one root brings the argument in reach.
#pragma once

#include <irg/math/detail/polynomial_tables.hpp>
#include <irg/math/detail/trigonometry_kernels.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::detail {

/// The multiple of 1/64 nearest to a number.
struct table_centre {
  int index;
  double value;
};

inline namespace IRG_ABI {

/// f(c + d) + rest * f'(c), where `centre` is f(c) and the polynomial is f's about c.
/// needs   |d| <= 1/128, and at most |f(c)| unless that is 0; |rest| of the order 2^-53 |d|
IRG_INLINE constexpr unrounded near_centre(const number_pair& centre, const local_polynomial& about, double d,
                                           double rest) noexcept {
  const auto& c = about.c;
  const double x = d + rest;
  const double t = product(x, x);
  const double tail =
      (c[1] + product(x, c[2])) + product(t, (c[3] + product(x, c[4])) + product(t, c[5] + product(x, c[6])));
  // d, the largest of the terms, is added without an error. The others are at most some 2^-7 of the sum.
  const unrounded head = fast_two_sum(centre.high, d);
  return {head.value, head.error + (centre.low + (rest + (product(x, c[0]) + product(t, tail))))};
}

/// The multiple of 1/64 nearest to x.
/// needs   0 <= x <= 1000
IRG_INLINE constexpr table_centre nearest_centre(double x) noexcept {
  const double shifted = x + 0x1.8p46;
  return {static_cast<int>(bits_of(shifted) & 0xffff), shifted - 0x1.8p46};
}

/// x, or -x where y is negative: told from the signs' bits, because random signs are no matter for a branch.
IRG_INLINE constexpr double times_sign(double x, double y) noexcept {
  return from_bits(bits_of(x) ^ (bits_of(y) & (std::uint64_t{1} << 63)));
}

IRG_INLINE constexpr double rounded_tangent(const quadrant_angle& angle) noexcept {
  const double size = magnitude(angle.rest.value);
  const double rest = times_sign(angle.rest.error, angle.rest.value);
  const auto [i, c] = nearest_centre(size);
  const unrounded t = renormalised(near_centre(tangent_table[i], tangent_polynomials[i], size - c, rest));
  if ((angle.quadrant & 1) == 0) return times_sign(t.value, angle.rest.value);
  const double inverse = 1 / t.value;
  const double miss = residual(1, inverse, t.value) - product(inverse, t.error);
  return times_sign(-(inverse + product(miss, inverse)), angle.rest.value);
}

/// The arctangent of x + rest, 0 <= x <= 1 and a little.
IRG_INLINE constexpr unrounded arctangent_near(double x, double rest) noexcept {
  const auto [i, c] = nearest_centre(x);
  return near_centre(arctangent_table[i], arctangent_polynomials[i], x - c, rest);
}

/// The arcsine of x + rest, 0 <= x <= 1/2 and a little.
IRG_INLINE constexpr unrounded arcsine_near(double x, double rest) noexcept {
  const auto [i, c] = nearest_centre(x);
  return near_centre(arcsine_table[i], arcsine_polynomials[i], x - c, rest);
}

/// base + x, where |base| >= |x| or base is 0, rounded.
IRG_INLINE constexpr double rounded_sum(const unrounded& base, const unrounded& x) noexcept {
  const unrounded heads = fast_two_sum(base.value, x.value);
  return heads.value + (heads.error + (base.error + x.error));
}

/// The axis from which the angle of a vector is measured: 2 for a backward one, 1 more for a steep one.
inline constexpr unrounded quadrant_bases[4] = {{0.0, 0.0}, right_angle, straight_angle, right_angle};

/// The angle, 0 to pi, of a vector whose lesser coordinate is quotient + rest of the larger one: steep is one nearer to
/// the y axis, backward one with negative x.
IRG_INLINE constexpr double angle_of_quotient(double quotient, double rest, bool is_steep, bool is_backward) noexcept {
  const unrounded angle = arctangent_near(quotient, rest);
  const double sign = is_steep != is_backward ? -1.0 : 1.0;
  return rounded_sum(quadrant_bases[(is_backward ? 2 : 0) + (is_steep ? 1 : 0)],
                     {times_sign(angle.value, sign), times_sign(angle.error, sign)});
}

/// The angle of the vector (x, y), 0 to pi, from the sizes of its coordinates.
/// needs   sizes from 2^-960 to 2^960
IRG_INLINE constexpr double angle_of_moderate(double y, double x, bool is_backward) noexcept {
  const bool is_steep = x < y;
  const double lesser_one = is_steep ? x : y;
  const double large = is_steep ? y : x;
  const double inverse = 1 / large;
  const double quotient = product(lesser_one, inverse);
  const double rest = product(residual(lesser_one, quotient, large), inverse);
  return angle_of_quotient(quotient, rest, is_steep, is_backward);
}

/// atan2 where the coordinates are far apart or one of them is zero, infinite, very large or very small.
/// needs   no NaN
constexpr double angle_of_extreme(double y, double x) noexcept {
  const double x_size = magnitude(x), y_size = magnitude(y);
  const bool is_backward = is_negative(x);
  if (x_size == infinity<double> && y_size == infinity<double>)
    return with_sign(is_backward ? 1.5 * half_pi_high : 0.5 * half_pi_high, y);
  if (y_size == 0 || y_size < x_size * 0x1p-60) {
    if (is_backward) return with_sign(straight_angle.value, y);
    return y_size == 0 || x_size == infinity<double> ? with_sign(0, y) : with_sign(y_size / x_size, y);
  }
  if (x_size == 0 || x_size < y_size * 0x1p-60) return with_sign(half_pi_high, y);
  // The exponents differ by 60 at most.
  const scaled_number near_x = decompose(x_size), near_y = decompose(y_size);
  const double scaled_y = near_y.significand * power_of_two(near_y.exponent - near_x.exponent);
  return with_sign(angle_of_moderate(scaled_y, near_x.significand, is_backward), y);
}

/// atan2.
/// needs   no NaN
constexpr double angle_of(double y, double x) noexcept {
  const double x_size = magnitude(x), y_size = magnitude(y);
  const bool is_moderate =
      x_size >= 0x1p-900 && x_size <= 0x1p900 && y_size >= x_size * 0x1p-60 && y_size * 0x1p-60 <= x_size;
  return is_moderate ? with_sign(angle_of_moderate(y_size, x_size, is_negative(x)), y) : angle_of_extreme(y, x);
}

/// atan.
/// needs   no NaN
constexpr double arctangent(double x) noexcept {
  if (is_tiny_angle(x)) return x;
  const double size = magnitude(x);
  if (size <= 1) return with_sign(round(arctangent_near(size, 0)), x);
  if (size >= 0x1p60) return with_sign(half_pi_high, x);
  const double inverse = 1 / size;
  const unrounded angle = arctangent_near(inverse, product(residual(1, inverse, size), inverse));
  return with_sign(rounded_sum(right_angle, negated(angle)), x);
}

/// Half the arccosine of a number from 1/2 to 1, the arcsine of sqrt((1 - x) / 2).
/// needs   1/2 <= x < 1
IRG_INLINE constexpr unrounded half_arccosine(double x) noexcept {
  const double square = 0.5 * (1 - x);
  const double root = sqrt(square);
  return arcsine_near(root, product(residual(square, root, root), 0.5 / root));
}

/// asin.
/// needs   |x| <= 1
constexpr double angle_of_sine(double x) noexcept {
  const double size = magnitude(x);
  if (size <= 0.5) return with_sign(round(arcsine_near(size, 0)), x);
  if (size == 1) return with_sign(half_pi_high, x);
  const unrounded half = half_arccosine(size);
  return with_sign(rounded_sum(right_angle, {-2 * half.value, -2 * half.error}), x);
}

/// acos.
/// needs   |x| <= 1
constexpr double angle_of_cosine(double x) noexcept {
  const double size = magnitude(x);
  if (size <= 0.5) {
    const unrounded angle = arcsine_near(size, 0);
    return rounded_sum(right_angle, x < 0 ? angle : negated(angle));
  }
  if (size == 1) return x < 0 ? straight_angle.value : 0;
  const unrounded half = half_arccosine(size);
  if (x > 0) return 2 * round(half);
  return rounded_sum(straight_angle, {-2 * half.value, -2 * half.error});
}

}  // namespace IRG_ABI
}  // namespace irg::detail
