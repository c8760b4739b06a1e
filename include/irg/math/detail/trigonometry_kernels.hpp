// SPDX-License-Identifier: MIT
// Argument reduction, and the sine and cosine of a reduced angle, both unrounded.
#pragma once

#include <irg/math/detail/trigonometry_tables.hpp>
#include <irg/math/detail/unrounded.hpp>

namespace irg::detail {

/// The angle quadrant * pi/2 + rest, where |rest| is at most pi/4 and a little.
struct quadrant_angle {
  unrounded rest;
  int quadrant = 0;
};

inline namespace IRG_ABI {

inline constexpr unrounded right_angle{half_pi_high, half_pi_low};
inline constexpr unrounded straight_angle{2 * half_pi_high, 2 * half_pi_low};

/// Whether sine, tangent and arcsine of x are x itself, to within 2^-55 of it.
template <Floating T>
IRG_INLINE constexpr bool is_tiny_angle(T x) noexcept {
  return magnitude(x) < T(0x1p-27);
}

/// The integer nearest to x, of |x| < 2^50.
IRG_INLINE constexpr double nearest_integer(double x) noexcept {
  const double shifted = opaque(x) + 0x1.8p52;
  return shifted - 0x1.8p52;
}

/// x modulo pi/2 for |x| < 2^20, by subtracting multiples of pi/2 in four parts. The first three products are exact.
IRG_INLINE constexpr quadrant_angle reduce_moderate(double x) noexcept {
  const double n = nearest_integer(product(x, two_over_pi));
  const double first = x - n * half_pi_parts[0];
  const unrounded second = two_sum(first, -(n * half_pi_parts[1]));
  const unrounded third = two_sum(second.value, -(n * half_pi_parts[2]));
  const double tail = (second.error + third.error) - product(n, half_pi_parts[3]);
  return {fast_two_sum(third.value, tail), static_cast<int>(static_cast<std::int64_t>(n) & 3)};
}

/// x modulo pi/2 for finite |x| >= 2^20: the product of x's significand with those words of 2/pi that tell the quadrant
/// and 160 bits of the fraction. No double lies closer than 2^-62 to a multiple of pi/2 relative to pi/2.
constexpr quadrant_angle reduce_huge(double x) noexcept {
  const std::uint64_t bits = bits_of(x);
  const int exponent = static_cast<int>((bits >> 52) & 0x7ff) - 1075;  // x = significand * 2^exponent, exponent >= -32
  const std::uint64_t significand = (bits & 0xfffffffffffffu) | (std::uint64_t{1} << 52);
  const int first_word = (exponent + 32) / 32;  // the table's word whose product with the lowest limb has weight 1
  const int shift = (exponent + 32) % 32;
  const std::uint64_t low = (significand & 0xffffffffu) << shift;
  const std::uint64_t high = ((significand >> 32) << shift) + (low >> 32);
  const std::uint64_t limbs[3] = {low & 0xffffffffu, high & 0xffffffffu, high >> 32};

  std::uint64_t digits[6] = {};  // of weights 1, 2^-32, ... 2^-160
  std::uint64_t carry = 0;
  for (int place = 5; place >= 0; --place) {
    std::uint64_t sum = carry;
    carry = 0;
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t term = limbs[i] * two_over_pi_words[first_word + place + i];
      sum += term & 0xffffffffu;
      carry += term >> 32;
    }
    digits[place] = sum & 0xffffffffu;
    carry += sum >> 32;
  }

  // A fraction of 1/2 and more becomes the next quadrant and a negative fraction.
  const bool is_upper = digits[1] >= 0x80000000u;
  const std::uint64_t flip = is_upper ? 0xffffffffu : 0;
  const int quadrant = static_cast<int>(digits[0] & 3) + (is_upper ? 1 : 0);
  const auto part = [&](int i, double weight) { return static_cast<double>(digits[i] ^ flip) * weight; };
  const unrounded head = fast_two_sum(part(1, 0x1p-32), part(2, 0x1p-64));
  const unrounded next = fast_two_sum(head.value, part(3, 0x1p-96));
  const unrounded fraction = fast_two_sum(next.value, head.error + (next.error + part(4, 0x1p-128)));
  const unrounded rest = multiply(fraction, right_angle);
  const bool is_negative_rest = is_upper != is_negative(x);
  return {is_negative_rest ? negated(rest) : rest, (is_negative(x) ? -quadrant : quadrant) & 3};
}

/// x modulo pi/2.
/// needs   x finite
IRG_INLINE constexpr quadrant_angle reduce_radians(double x) noexcept {
  const double size = magnitude(x);
  if (size <= 0.785) return {{x, 0.0}, 0};
  return size < 0x1p20 ? reduce_moderate(x) : reduce_huge(x);
}

/// x degrees modulo a right angle, the rest in radians.
/// needs   x finite
constexpr quadrant_angle reduce_degrees(double x) noexcept {
  double turn_rest = x;
  if (magnitude(x) >= 0x1p53) {
    // An integer m * 2^e; the powers of two modulo 360 repeat after twelve, from 2^3 on.
    const std::uint64_t bits = bits_of(x);
    const int exponent = static_cast<int>((bits >> 52) & 0x7ff) - 1075;
    const std::uint64_t significand = (bits & 0xfffffffffffffu) | (std::uint64_t{1} << 52);
    const int equivalent = exponent < 3 ? exponent : 3 + (exponent - 3) % 12;
    turn_rest = with_sign(static_cast<double>(((significand % 360) << equivalent) % 360), x);
  }
  turn_rest = turn_rest - product(360.0, nearest_integer(turn_rest / 360));
  const double n = nearest_integer(turn_rest / 90);
  const double rest = turn_rest - product(90.0, n);
  const exact_sum<double> head = two_product(rest, degree_high);
  return {{head.value, head.error + product(rest, degree_low)}, static_cast<int>(n) & 3};
}

/// The table's angle nearest to |x|, and the difference from it.
struct table_angle {
  const sine_cosine_row& row;
  double sine, versine;  // sin d and 1 - cos d of the difference d, |d| <= 1/256
};
IRG_INLINE constexpr table_angle nearest_table_angle(const unrounded& x) noexcept {
  const double size = magnitude(x.value);
  const int i = static_cast<int>(size * 128 + 0.5);
  const double d = (size - i * 0x1p-7) + (x.value < 0 ? -x.error : x.error);
  const double t = product(d, d);
  const double sine = d + product(product(d, t), -0x1.5555555555555p-3 + product(t, 0x1.1111111111111p-7));
  const double versine = product(t, 0.5 + product(t, -0x1.5555555555555p-5 + product(t, 0x1.6c16c16c16c17p-10)));
  return {sine_cosine_table[i], sine, versine};
}

IRG_INLINE constexpr unrounded sine_of_rest(const unrounded& x) noexcept {
  if (magnitude(x.value) < 0.126) {
    const double t = product(x.value, x.value);
    const auto& s = sine_coefficients;
    const double tail = s[0] + product(t, s[1] + product(t, s[2] + product(t, s[3])));
    return {x.value, x.error + product(product(x.value, t), tail)};
  }
  const auto [row, sine, versine] = nearest_table_angle(x);
  const unrounded s{row.sine, row.sine_low + (product(row.cosine, sine) - product(row.sine, versine))};
  return x.value < 0 ? negated(s) : s;
}

IRG_INLINE constexpr unrounded cosine_of_rest(const unrounded& x) noexcept {
  const auto [row, sine, versine] = nearest_table_angle(x);
  return {row.cosine, row.cosine_low - (product(row.sine, sine) + product(row.cosine, versine))};
}

IRG_INLINE constexpr unrounded sine_of(const quadrant_angle& angle) noexcept {
  const unrounded s = (angle.quadrant & 1) == 0 ? sine_of_rest(angle.rest) : cosine_of_rest(angle.rest);
  return (angle.quadrant & 2) == 0 ? s : negated(s);
}

IRG_INLINE constexpr unrounded cosine_of(const quadrant_angle& angle) noexcept {
  return sine_of({angle.rest, angle.quadrant + 1});
}

IRG_INLINE constexpr double rounded_sine(const quadrant_angle& angle) noexcept { return round(sine_of(angle)); }
IRG_INLINE constexpr double rounded_cosine(const quadrant_angle& angle) noexcept { return round(cosine_of(angle)); }

/// x times a constant given as a double and its rounding error.
constexpr double multiply_by_constant(double x, double high, double low) noexcept {
  const double size = magnitude(x);
  if (size >= 0x1p-900 && size <= 0x1p990) return round(multiply({x, 0.0}, {high, low}));
  if (!is_finite(x) || x == 0) return x;
  // Near the ends of the range the product is taken of the significand, and rounded where it belongs.
  const scaled_number parts = decompose(x);
  const unrounded exact = multiply({parts.significand, 0.0}, {high, low});
  const scaled_number result = decompose(exact.value);
  const double error = exact.error * power_of_two(-result.exponent);
  return scale({result.significand, error}, result.exponent + parts.exponent);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
