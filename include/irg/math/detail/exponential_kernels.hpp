// SPDX-License-Identifier: MIT
// e^x, the natural logarithm and the special cases of the power function.
#pragma once

#include <irg/math/detail/exponential_tables.hpp>
#include <irg/math/detail/unrounded.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// 2^(steps/128) * e^rest.
/// needs   |rest| <= ln(2)/256 and a little
IRG_INLINE constexpr double exp_of_parts(int steps, double rest) noexcept {
  const exp_row& row = exp_table[steps & 127];
  const double square = product(rest, rest);
  const auto& c = exp_coefficients;
  const double tail = (c[0] + product(rest, c[1])) + product(square, c[2] + product(rest, c[3]));
  const double less_one = rest + product(square, tail);
  return scale({row.power, row.power_low + product(row.power, less_one)}, steps >> 7);
}

/// e^x, of an unrounded x.
/// gives   infinity from 709.8 on, 0 below -745.2
constexpr double exp_of(const unrounded& x) noexcept {
  if (!(x.value < 710)) return x.value > 0 ? infinity<double> : not_a_number<double>;
  if (x.value < -746) return 0;
  const double shifted = product(x.value, exp_steps_per_unit) + 0x1.8p52;
  const double steps = shifted - 0x1.8p52;
  const double rest = (x.value - steps * exp_step_high) + (x.error - product(steps, exp_step_low));
  return exp_of_parts(static_cast<int>(steps), rest);
}

/// 2^x.
/// gives   infinity from 1024 on, 0 below -1075
constexpr double exp2_of(double x) noexcept {
  if (!(x < 1024)) return x > 0 ? infinity<double> : not_a_number<double>;
  if (x < -1076) return 0;
  const double steps = (x * 128 + 0x1.8p52) - 0x1.8p52;
  return exp_of_parts(static_cast<int>(steps), product(x - steps * 0x1p-7, natural_log_of_two));
}

/// ln x within 2^-67 of it.
/// needs   0 < x < infinity
IRG_INLINE constexpr unrounded log_of(double x) noexcept {
  const bool is_subnormal = x < 0x1p-1022;
  const std::uint64_t bits = bits_of(is_subnormal ? x * 0x1p54 : x);
  const std::uint64_t offset = bits - log_table_first;  // modulo 2^64: the exponent is signed
  const log_row& row = log_table[(offset >> 45) & 127];
  const double power = static_cast<double>(static_cast<std::int64_t>(offset) >> 52) - (is_subnormal ? 54 : 0);
  const std::uint64_t significand = bits - (offset & 0xfff0000000000000u);
  // With c of 10 bits, both (high part of z) * c - 1, a multiple of 2^-33, and (low part) * c are exact.
  const double z = from_bits(significand);
  // The high part is rounded to nearest, so that it is never much larger than z - 1 beside 1.
  const double z_high = from_bits((significand + 0x20000000u) & ~std::uint64_t{0x3fffffff});
  const double r_high = z_high * row.inverse - 1;
  const double r_low = (z - z_high) * row.inverse;
  const unrounded r = fast_two_sum(r_high, r_low);

  // ln x = power ln 2 + ln 1/c + r - r^2/2 + r^3 q(r), where r^2 = r_high^2, exact, + r_low (r_high + r).
  const double half_square = 0.5 * (r_high * r_high);
  const double square_rest = product(0.5 * r_low, r_high + r.value);
  const double square = product(r.value, r.value);
  const auto& c = log_coefficients;
  const double q = (c[0] + product(r.value, c[1])) +
                   product(square, (c[2] + product(r.value, c[3])) + product(square, c[4] + product(r.value, c[5])));
  const double cube = product(product(r.value, square), q);
  const double base = power * log_two_high + row.log;  // exact: both are multiples of 2^-42
  const double base_low = product(power, log_two_low) + row.log_low;
  const unrounded linear = two_sum(base, r.value);
  const unrounded quadratic = fast_two_sum(linear.value, -half_square);
  const double low = (linear.error + quadratic.error) + (base_low + (r.error - square_rest)) + cube;
  return fast_two_sum(quadratic.value, low);
}

/// ln x within 2^-40 of its size, of a double that was a float: with so few digits r is exact. Nearly always that says
/// which float is nearest.
/// needs   0 < x < infinity
IRG_INLINE constexpr double quick_log_of(double x) noexcept {
  const std::uint64_t bits = bits_of(x), offset = bits - log_table_first;
  const log_row& row = log_table[(offset >> 45) & 127];
  const double power = static_cast<double>(static_cast<std::int32_t>(static_cast<std::int64_t>(offset) >> 52));
  const double r = product(from_bits(bits - (offset & 0xfff0000000000000u)), row.inverse) - 1;
  const double square = product(r, r);
  const auto& c = log_coefficients;
  const double tail = (product(r, c[0]) - 0.5) + product(square, c[1] + product(r, c[2]));
  return (product(power, natural_log_of_two) + row.log) + ((r + row.log_low) + product(square, tail));
}

/// Whether every number within 2^-52 * Units of y's size rounds to the same float.
/// needs   y is 0 or of a normal float's size
template <int Units>
IRG_INLINE constexpr bool rounds_to_one_float(double y) noexcept {
  constexpr std::uint64_t half = 0x10000000, all = 0x1fffffff, units = Units;
  return ((bits_of(y) - half + units) & all) > 2 * units;
}

/// Logarithms of a base whose natural logarithm is 1 over high + low, rounded to T.
/// needs   0 < x < infinity
struct logarithm_base {
  double high, low;
};
inline constexpr logarithm_base natural_base{1, 0}, binary{inverse_log_two_high, inverse_log_two_low},
    decimal{inverse_log_ten_high, inverse_log_ten_low};
template <Floating T>
IRG_NOINLINE constexpr T rounded_log_of(double x, const logarithm_base& base) noexcept {
  const unrounded logarithm = log_of(x);
  return round_to<T>(base.low == 0 ? logarithm : multiply(logarithm, {base.high, base.low}));
}

/// The same of what was a float, the quick way where it can tell the nearest float.
IRG_INLINE constexpr float nearest_log_of(float x, const logarithm_base& base) noexcept {
  const double wide = widened(x), quick = product(quick_log_of(wide), base.high);
  return rounds_to_one_float<4096>(quick) ? converted<float>(quick) : rounded_log_of<float>(wide, base);
}

/// The cube root.
/// needs   0 < x < infinity
constexpr double cbrt_of(double x) noexcept {
  const scaled_number parts = decompose(x);
  const int third = (parts.exponent + 1080) / 3 - 360;
  const int rest = parts.exponent - 3 * third;
  const double m = parts.significand;
  const double f = m * power_of_two(rest);
  const auto& c = cbrt_coefficients;
  const double guess = product(cbrt_of_power[rest], c[0] + product(m, c[1] + product(m, c[2] + product(m, c[3]))));
  const double guess_cubed = product(product(guess, guess), guess);
  const double better = product(guess, (guess_cubed + 2 * f) / (2 * guess_cubed + f));  // Halley: within 2^-30
  // Cut to 26 bits, the square is exact and the cube is known to the last bit; the rest is a short series.
  const double y = from_bits(bits_of(better) & ~std::uint64_t{0x7ffffff});
  const exact_sum<double> cube = fast_two_product(y * y, y);
  const double excess = ((f - cube.value) - cube.error) / cube.value;
  const double series =
      product(excess, 0x1.5555555555555p-2 + product(excess, -0x1.c71c71c71c71cp-4 + excess * 0x1p-4));
  return (y + product(y, series)) * power_of_two(third);
}

enum class parity { fraction, even, odd };

/// Whether y is an integer, and which.
/// needs   y finite
constexpr parity parity_of(double y) noexcept {
  const double size = magnitude(y);
  if (size >= 0x1p53) return parity::even;
  const auto whole = static_cast<std::int64_t>(size);
  if (static_cast<double>(whole) != size) return parity::fraction;
  return (whole & 1) != 0 ? parity::odd : parity::even;
}

/// |x|^y for x a zero or an infinity, or y an infinity.
constexpr double pow_of_extreme(double x_size, double y) noexcept {
  if (magnitude(y) == infinity<double>) {
    if (x_size == 1) return 1;
    return (x_size > 1) == (y > 0) ? infinity<double> : 0.0;
  }
  return (x_size > 1) == (y > 0) ? infinity<double> : 0.0;
}

/// x^y by C's Annex F.
constexpr double pow_of(double x, double y) noexcept {
  if (y == 0 || x == 1) return 1;
  if (is_nan(x) || is_nan(y)) return not_a_number<double>;
  const double x_size = magnitude(x);
  const bool is_extreme = x_size == 0 || x_size == infinity<double> || magnitude(y) == infinity<double>;
  double sign = 1;
  if (is_negative(x) && magnitude(y) != infinity<double>) {
    const parity kind = parity_of(y);
    if (kind == parity::fraction && !is_extreme) return not_a_number<double>;
    if (kind == parity::odd) sign = -1;
  }
  if (is_extreme) return sign * pow_of_extreme(x_size, y);
  // Beyond these the result is 1 rounded, or too large or small for any x but 1.
  if (x_size == 1 || magnitude(y) < 0x1p-65) return sign;
  if (magnitude(y) > 0x1p65) return sign * ((x_size > 1) == (y > 0) ? infinity<double> : 0.0);
  const unrounded logarithm = log_of(x_size);
  const exact_sum<double> head = fast_two_product(y, logarithm.value);
  return sign * exp_of({head.value, head.error + product(y, logarithm.error)});
}

/// x^y within 2^-33 of its size, or NaN where it might be no normal float, or x or y is none that the formula takes.
/// needs   x and y were floats
IRG_INLINE constexpr double quick_pow_of(double x, double y) noexcept {
  if (!(x > 0 && x < infinity<double> && magnitude(y) < infinity<double>)) return not_a_number<double>;
  const double exponent = product(quick_log_of(x), y);
  if (!(magnitude(exponent) < 85)) return not_a_number<double>;
  const double steps = (product(exponent, exp_steps_per_unit) + 0x1.8p52) - 0x1.8p52;
  const double rest = exponent - product(steps, exp_step_high + exp_step_low);
  const int whole = static_cast<int>(steps);
  const exp_row& row = exp_table[whole & 127];
  const double less_one = rest + product(product(rest, rest), exp_coefficients[0] + product(rest, exp_coefficients[1]));
  return (row.power + product(row.power, less_one)) * power_of_two(whole >> 7);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
