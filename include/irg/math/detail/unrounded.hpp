// SPDX-License-Identifier: MIT
// Double-double arithmetic without a look at the range: on unrounded numbers, an exact_sum<double> whose value is near
// the sum but need not be the sum rounded. The last steps of the elementary functions are taken in it; with a bound of
// the error beside it, it is what values_of computes in first, with an exponent of its own, a scaled_double_double.
// Relative errors are of the order 2^-102.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::detail::inline IRG_ABI {

using unrounded = exact_sum<double>;

IRG_INLINE constexpr unrounded negated(const unrounded& x) noexcept { return {-x.value, -x.error}; }

IRG_INLINE constexpr double round(const unrounded& x) noexcept { return x.value + x.error; }

/// The same number with the value rounded.
IRG_INLINE constexpr unrounded renormalised(const unrounded& x) noexcept { return fast_two_sum(x.value, x.error); }

/// a + b, off by some 2^-104 of |a| + |b|.
IRG_INLINE constexpr unrounded add(const unrounded& a, const unrounded& b) noexcept {
  const unrounded heads = two_sum(a.value, b.value);
  return fast_two_sum(heads.value, heads.error + (a.error + b.error));
}

/// a + b, off by at most 3u^2 + 13u^3 of the sum, u = 2^-53 (float: 2^-24), also where a and b cancel.
/// needs   values that are the numbers rounded, heads == two_sum(a.value, b.value)
/// source  Li et al. 2002 (AccurateDWPlusDW); Joldes, Muller and Popescu 2017 (its bound)
template <Floating T>
IRG_INLINE constexpr exact_sum<T> accurate_sum(const exact_sum<T>& heads, const exact_sum<T>& a,
                                               const exact_sum<T>& b) noexcept {
  const exact_sum<T> tails = two_sum(a.error, b.error);
  const exact_sum<T> upper = fast_two_sum(heads.value, heads.error + tails.value);
  return fast_two_sum(upper.value, tails.error + upper.error);
}
IRG_INLINE constexpr unrounded accurate_sum(const unrounded& a, const unrounded& b) noexcept {
  return accurate_sum(two_sum(a.value, b.value), a, b);
}

/// a * b, off by at most 5u^2 of it.
/// needs   heads == two_product(a.value, b.value)
/// source  Dekker 1971 (DWTimesDW1); Joldes, Muller and Popescu 2017 (its bound)
template <Floating T>
IRG_INLINE constexpr exact_sum<T> multiply(const exact_sum<T>& heads, const exact_sum<T>& a,
                                           const exact_sum<T>& b) noexcept {
  return fast_two_sum(heads.value, heads.error + (product(a.value, b.error) + product(a.error, b.value)));
}
IRG_INLINE constexpr unrounded multiply(const unrounded& a, const unrounded& b) noexcept {
  return multiply(fast_two_product(a.value, b.value), a, b);
}

/// a - quotient * b, exactly but for the last rounding, where quotient is about a/b.
IRG_INLINE constexpr double residual(double a, double quotient, double b) noexcept {
  const unrounded back = fast_two_product(quotient, b);
  return (a - back.value) - back.error;
}
IRG_INLINE constexpr double residual(const unrounded& a, double quotient, const unrounded& b) noexcept {
  return residual(a.value, quotient, b.value) + (a.error - product(quotient, b.error));
}

/// needs   values that are the numbers rounded
IRG_INLINE constexpr unrounded divide(const unrounded& a, const unrounded& b) noexcept {
  const double quotient = a.value / b.value;
  return {quotient, residual(a, quotient, b) / b.value};
}

/// The square root of an unrounded number: the rounded root and one step of Newton's iteration.
IRG_INLINE constexpr unrounded unrounded_sqrt(const unrounded& x) noexcept {
  const double root = sqrt(x.value);
  if (!(root > 0)) return {root, 0.0};
  return {root, (residual(x.value, root, root) + x.error) / (2 * root)};
}

/// Whether every number within 2^-52 * Units of y's size rounds to the same float.
/// needs   y is 0 or of a normal float's size
template <int Units>
IRG_INLINE constexpr bool rounds_to_one_float(double y) noexcept {
  constexpr std::uint64_t half = 0x10000000, all = 0x1fffffff, units = Units;
  return ((bits_of(y) - half + units) & all) > 2 * units;
}

/// The T nearest to an unrounded number; a float is rounded once.
template <Floating T>
IRG_INLINE constexpr T round_to(const unrounded& x) noexcept {
  const unrounded parts = renormalised(x);
  return rounded_once<T>(parts.value, parts.error);
}

/// x * 2^k with one rounding.
/// needs   1/2 <= |x| <= 2 or so
/// gives   infinity when the product overflows
constexpr double scale(const unrounded& x, int k) noexcept {
  const double rounded = round(x);
  if (k >= -1022 && k <= 1022 && (k > -1022 || magnitude(rounded) >= 1)) return rounded * power_of_two(k);
  if (k > 1022) {
    const double half = rounded * 0.5;
    if (k > 1024 || (k == 1024 && magnitude(half) >= 0.5) || magnitude(half) >= 1)
      return x.value > 0 ? infinity<double> : -infinity<double>;
    return half * 0x1p1023 * (k == 1024 ? 4 : 2);
  }
  if (k < -1077) return with_sign(0, x.value);
  // Rounded to a multiple of 2^-1074-k by adding a number whose last place that is.
  const double anchor = with_sign(power_of_two(-1074 - k + 52), x.value);
  const unrounded sum = two_sum(anchor, x.value);
  const double units = (sum.value + (sum.error + x.error)) - anchor;
  return with_sign(units * 0x1p-1022 * power_of_two(k + 1022), x.value);
}

/// What nearest_scaled does where rounding x.value first might not do.
template <Floating T, class Side>
IRG_NOINLINE constexpr T nearest_in_units(const unrounded& x, int e, const Side& side) noexcept {
  constexpr int digits = std::numeric_limits<T>::digits, lowest = std::numeric_limits<T>::min_exponent - digits;
  scaled_number parts = decompose(x.value);
  double rest = times_power_of_two(x.value < 0 ? -x.error : x.error, -parts.exponent);
  double size = magnitude(parts.significand);
  if (size == 1 && rest < 0) {
    size = 2;
    rest = 2 * rest;
    --parts.exponent;
  }
  // In units of the last place of the result.
  const int exponent = parts.exponent + e;
  const int last = exponent - (digits - 1) < lowest ? lowest : exponent - (digits - 1), places = exponent - last;
  if (places < -2) return converted<T>(with_sign(0.0, x.value));
  const double scaled = size * power_of_two(places);
  double units = scaled < 0x1p52 ? (scaled + 0x1p52) - 0x1p52 : scaled;
  rest = (scaled - units) + rest * power_of_two(places);
  const auto number = [&](double n) { return times_power_of_two(with_sign(n, x.value), last); };
  if (magnitude(magnitude(rest) - 0.5) < 0x1p-40) {
    const double lower = rest < 0 ? units - 1 : units;
    const int beyond = side(number(lower), number(1));
    const bool is_odd = (static_cast<std::int64_t>(lower) & 1) != 0;
    units = beyond > 0 || (beyond == 0 && is_odd) ? lower + 1 : lower;
  } else if (magnitude(rest) > 0.5) {
    units = rest < 0 ? units - 1 : units + 1;
  }
  return narrowed<T>(number(units));
}

/// The T nearest to x * 2^e, ties to even, subnormal results too.
/// needs   a value that is the number rounded, not zero. Where x is within 2^-40 of the last place of the middle
///         between two Ts, side(t, step) says whether the true number is nearer to 0 than the middle of t and t +
///         step, or farther: -1, 1, or 0 for a tie
template <Floating T, class Side>
IRG_INLINE constexpr T nearest_scaled(const unrounded& x, int e, const Side& side) noexcept {
  const double rounded = times_power_of_two(x.value, e);
  const double widest = product(x.error, 1 + 0x1p-35);
  if constexpr (std::is_same_v<T, double>)
    if (magnitude(rounded) >= 0x1p-1022 && is_finite(rounded) && x.value + widest == x.value) return rounded;
  return nearest_in_units<T>(x, e, side);
}

}  // namespace irg::detail::inline IRG_ABI
