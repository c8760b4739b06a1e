// SPDX-License-Identifier: MIT
// Powers, logarithms and the cube root, the same bits in constant evaluation and at run time, on every compiler and
// instruction set. float arguments are computed in double and rounded once more.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/exponential_tables.hpp>
#include <irg/math/detail/hard_floats.hpp>
#include <irg/math/detail/unrounded.hpp>

namespace irg::inline IRG_ABI {

/// e^x.
/// gives   NaN for NaN; infinity beyond 709.78 (float 88.72), 0 below -745.13 (float -103.97)
/// exact   double within 0.52 ulp, subnormal results too; float the nearest one
/// cost    a table lookup and about 25 operations
/// source  Tang 1989 (table and short polynomial); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] constexpr T exp(T x) noexcept;

/// 2^x.
/// gives   NaN for NaN; exact powers for integers x
/// exact   as exp
/// cost    as exp
template <Floating T>
[[nodiscard]] constexpr T exp2(T x) noexcept;

/// The natural logarithm of x.
/// gives   -infinity for 0 and -0, infinity for infinity, NaN for NaN and everything below zero; +0 for 1
/// exact   double within 0.51 ulp; float the nearest one
/// cost    a table lookup and about 30 operations, and 50 more once in some 100 times, or where |x - 1| is small;
///         float: about 20, and 50 more once in some 500 times
/// source  Tang 1990 (table and short polynomial); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log(T x) noexcept;

/// The logarithm of x to base 2.
/// gives   as log; exact integers for powers of two
/// exact   as log
/// cost    log and a product
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log2(T x) noexcept;

/// The logarithm of x to base 10.
/// gives   as log; exact integers for powers of ten
/// exact   as log
/// cost    log and a product
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log10(T x) noexcept;

/// x to the power y.
/// gives   what Annex F of C says: 1 for y = 0 or x = 1 even beside NaN; NaN for negative x and y no integer;
///         0 or infinity with x's sign where y is an odd integer and without it elsewhere
/// exact   double within 0.52 ulp, subnormal results too; float within 0.5001 ulp
/// cost    log, an exact product and exp
/// source  irg's own: the logarithm carries 14 bits beyond double
template <Floating T>
[[nodiscard]] constexpr T pow(T x, std::type_identity_t<T> y) noexcept;

/// The cube root of x.
/// gives   NaN for NaN; infinities and zeros with their signs
/// exact   double within 0.501 ulp; float the nearest one; perfect cubes exactly
/// cost    two divisions, an exact product
/// source  Halley 1694; the last step compares the exact cube of a 26-bit root
template <Floating T>
[[nodiscard]] constexpr T cbrt(T x) noexcept;

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// e^x, the natural logarithm and the special cases of the power function.

/// x with its last 27 bits cleared: the product of two such numbers is exact.
IRG_INLINE constexpr double cut_to_26_bits(double x) noexcept {
  return from_bits(bits_of(x) & ~std::uint64_t{0x7ffffff});
}

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
  const unrounded linear = fast_two_sum(base, r.value);  // base is 0 or the larger one
  const unrounded quadratic = fast_two_sum(linear.value, -half_square);
  const double low = (linear.error + quadratic.error) + (base_low + (r.error - square_rest)) + cube;
  return fast_two_sum(quadratic.value, low);
}

// The quick ways below are right but for a bound that their callers add: where every number within the bound rounds to
// the same result, that is the result. So they need no guards, and may be fused: the rounded result stays the same.

/// Whether x is positive, normal and finite.
IRG_INLINE constexpr bool is_positive_normal(float x) noexcept {
  return std::bit_cast<std::uint32_t>(x) - 0x00800000u < 0x7f000000u;
}
IRG_INLINE constexpr bool is_positive_normal(double x) noexcept {
  return bits_of(x) - 0x0010000000000000u < 0x7fe0000000000000u;
}

/// Logarithms of a base whose natural logarithm is 1 over high + low.
struct logarithm_base {
  double high, low;
};
inline constexpr logarithm_base natural_base{1, 0}, binary{inverse_log_two_high, inverse_log_two_low},
    decimal{inverse_log_ten_high, inverse_log_ten_low};

/// The logarithm of x within 2^-34 of its size, with four terms 2^-40: with so few digits r is exact.
/// needs   x positive and normal
template <int Terms>
IRG_INLINE constexpr double quick_log_of(float x, const logarithm_base& base) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t offset = bits - log_table_first_single;
  const log_row& row = log_table[(offset >> 16) & 127];
  const double power = static_cast<std::int32_t>(offset) >> 23;
  const std::uint64_t significand = bits - (offset & 0xff800000u);
  const double r = from_bits((significand << 29) + (std::uint64_t{1023 - 127} << 52)) * row.inverse - 1;
  const double square = r * r;
  double rest = 0;
  if constexpr (Terms == 4) {
    const auto& c = log_four_coefficients;
    rest = (r + row.log_low) + square * ((c[0] + r * c[1]) + square * (c[2] + r * c[3]));
  } else {
    const auto& c = log_three_coefficients;
    rest = r + square * ((c[0] + r * c[1]) + square * c[2]);
  }
  return power * (natural_log_of_two * base.high) + (row.log + rest) * base.high;
}

/// A logarithm rounded to T.
template <Floating T>
IRG_NOINLINE constexpr T rounded_log_of(T x, const logarithm_base& base) noexcept {
  if (!(x > T(0))) return x == T(0) ? -infinity<T> : not_a_number<T>;
  if (!(x < infinity<T>)) return x;
  const unrounded logarithm = log_of(widened(x));
  return round_to<T>(base.low == 0 ? logarithm : multiply(logarithm, {base.high, base.low}));
}

/// The same for any x, the quick way where that tells the nearest float.
IRG_INLINE constexpr float nearest_log_of(float x, const logarithm_base& base) noexcept {
  if (is_positive_normal(x))
    if (const double quick = quick_log_of<3>(x, base); rounds_to_one_float<(1 << 19)>(quick))
      return converted<float>(quick);
  return rounded_log_of(x, base);
}

/// ln x within 2^-60, absolutely, but for the last rounding.
/// needs   x positive and normal
IRG_INLINE constexpr unrounded quick_log_of(double x) noexcept {
  const std::uint64_t bits = bits_of(x), offset = bits - log_table_first;
  const log_row& row = log_table[(offset >> 45) & 127];
  const double power = static_cast<double>(static_cast<std::int32_t>(static_cast<std::int64_t>(offset) >> 52));
  const double z = from_bits(bits - (offset & 0xfff0000000000000u));
  const double r = product_less_one(z, row.inverse);
  const double square = r * r;
  const auto& c = log_coefficients;
  const double tail = ((r * c[0] - 0.5) + square * (c[1] + r * c[2])) + square * square * (c[3] + r * c[4]);
  const double base = power * log_two_high + row.log;
  const unrounded head = fast_two_sum(base, r);
  return {head.value, (head.error + (power * log_two_low + row.log_low)) + square * tail};
}

/// The same, rounded to double.
IRG_INLINE constexpr double nearest_log_of(double x, const logarithm_base& base) noexcept {
  if (is_positive_normal(x)) {
    unrounded quick = quick_log_of(x);
    if (base.low != 0) {
      // 26 bits times 26 bits are exact.
      const double head = cut_to_26_bits(quick.value), base_head = cut_to_26_bits(base.high);
      const double rest = (quick.value - head) + quick.error;
      quick = {head * base_head, head * ((base.high - base_head) + base.low) + rest * base.high};
    }
    const double upper = quick.value + (quick.error + 0x1p-59), lower = quick.value + (quick.error - 0x1p-59);
    if (upper == lower) return upper;
  }
  return rounded_log_of(x, base);
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
  const double y = cut_to_26_bits(better);
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

/// y ln x.
/// needs   0 < x < infinity, 2^-65 <= |y| <= 2^65
IRG_INLINE constexpr unrounded exponent_of_power(double x, double y) noexcept {
  const unrounded logarithm = log_of(x);
  const exact_sum<double> head = fast_two_product(y, logarithm.value);
  return {head.value, head.error + product(y, logarithm.error)};
}

/// x^y by C's Annex F.
IRG_NOINLINE constexpr double pow_of_any(double x, double y) noexcept {
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
  return sign * exp_of(exponent_of_power(x_size, y));
}

/// The same, first the usual case.
constexpr double pow_of(double x, double y) noexcept {
  const bool is_usual = x > 0 && x < infinity<double> && magnitude(y) >= 0x1p-65 && magnitude(y) <= 0x1p65;
  return is_usual ? exp_of(exponent_of_power(x, y)) : pow_of_any(x, y);
}

/// x^y, the quick way where that tells the nearest float, or NaN.
IRG_INLINE constexpr float quick_pow_of(float x, float y) noexcept {
  if (!is_positive_normal(x)) return not_a_number<float>;
  const double exponent = quick_log_of<4>(x, natural_base) * widened(y);
  if (!(magnitude(exponent) < 85)) return not_a_number<float>;  // or not to be computed, or no normal float
  const double shifted = exponent * exp_steps_per_unit + 0x1.8p52;
  const double rest = exponent - (shifted - 0x1.8p52) * (exp_step_high + exp_step_low);
  const std::uint64_t steps = bits_of(shifted);
  const double scale = from_bits(bits_of(exp_table[steps & 127].power) + ((steps & ~std::uint64_t{127}) << 45));
  const double power = scale + scale * (rest + rest * rest * (exp_coefficients[0] + rest * exp_coefficients[1]));
  return rounds_to_one_float<(1 << 19)>(power) ? converted<float>(power) : not_a_number<float>;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr T exp(T x) noexcept {
  return narrowed<T>(detail::exp_of({widened(x), 0.0}));
}

template <Floating T>
[[nodiscard]] constexpr T exp2(T x) noexcept {
  return detail::nearest_result<detail::symmetry::none>(x, detail::exp2_of(widened(x)), detail::hard_powers_of_two);
}

template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log(T x) noexcept {
  return detail::nearest_log_of(x, detail::natural_base);
}

template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log2(T x) noexcept {
  return detail::nearest_log_of(x, detail::binary);
}

template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log10(T x) noexcept {
  return detail::nearest_log_of(x, detail::decimal);
}

template <Floating T>
[[nodiscard]] constexpr T pow(T x, std::type_identity_t<T> y) noexcept {
  if constexpr (std::is_same_v<T, float>)
    if (const float power = detail::quick_pow_of(x, y); power == power) return power;
  return narrowed<T>(detail::pow_of(widened(x), widened(y)));
}

template <Floating T>
[[nodiscard]] constexpr T cbrt(T x) noexcept {
  const double size = magnitude(widened(x));
  if (!(size > 0 && size < infinity<double>)) return x;
  return narrowed<T>(with_sign(detail::cbrt_of(size), widened(x)));
}

// Plain forms, for the reason given in trigonometry.hpp.
[[nodiscard]] constexpr double exp(double x) noexcept { return exp<double>(x); }
[[nodiscard]] constexpr float exp(float x) noexcept { return exp<float>(x); }
[[nodiscard]] constexpr double exp2(double x) noexcept { return exp2<double>(x); }
[[nodiscard]] constexpr float exp2(float x) noexcept { return exp2<float>(x); }
[[nodiscard]] constexpr double log(double x) noexcept { return log<double>(x); }
[[nodiscard]] constexpr float log(float x) noexcept { return log<float>(x); }
[[nodiscard]] constexpr double log2(double x) noexcept { return log2<double>(x); }
[[nodiscard]] constexpr float log2(float x) noexcept { return log2<float>(x); }
[[nodiscard]] constexpr double log10(double x) noexcept { return log10<double>(x); }
[[nodiscard]] constexpr float log10(float x) noexcept { return log10<float>(x); }
[[nodiscard]] constexpr double cbrt(double x) noexcept { return cbrt<double>(x); }
[[nodiscard]] constexpr float cbrt(float x) noexcept { return cbrt<float>(x); }
[[nodiscard]] constexpr double pow(double x, double y) noexcept { return pow<double>(x, y); }
[[nodiscard]] constexpr float pow(float x, float y) noexcept { return pow<float>(x, y); }
template <Floating T, class Y>
  requires(std::is_arithmetic_v<Y> && !std::is_same_v<T, Y>)
[[nodiscard]] constexpr T pow(T x, Y y) noexcept {
  return pow<T>(x, static_cast<T>(y));
}

}  // namespace irg::inline IRG_ABI
