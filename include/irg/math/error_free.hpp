// SPDX-License-Identifier: MIT
// Error-free transformations: the rounded sum or product of two numbers together with its rounding error, and what is
// built on them first, a*b - c*d without cancellation. The forms with and without a fused multiply-add give the same
// bits, so the instruction set does not show in any result.
#pragma once

#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/contraction.hpp>
#include <irg/core/instructions.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/float_bits.hpp>

namespace irg {

/// A number in two parts: value + error exactly, value being the sum rounded.
template <Floating T>
struct exact_sum {
  T value{}, error{};
  friend constexpr bool operator==(const exact_sum&, const exact_sum&) = default;
};

/// The two halves of a significand: high + low exactly, each with at most half the bits.
template <Floating T>
struct split_number {
  T high{}, low{};
  friend constexpr bool operator==(const split_number&, const split_number&) = default;
};

inline namespace IRG_ABI {

/// a + b, rounded, and what rounding took away.
/// needs   arguments that are no bare products (write product(x, y)), so that nothing fuses into the sum
/// gives   an error that is NaN when the sum overflows
/// exact   value + error == a + b, underflow included
/// cost    6 operations
/// source  Moller 1965; Knuth 1969 (TwoSum)
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr exact_sum<T> two_sum(T a, T b) noexcept {
  const T sum = a + b;
  const T b_part = sum - a;
  const T a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// large + small, rounded, and what rounding took away.
/// needs   |large| >= |small|, or large == 0; no bare products
/// exact   value + error == large + small
/// cost    3 operations
/// source  Dekker 1971 (FastTwoSum)
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr exact_sum<T> fast_two_sum(T large, T lesser_one) noexcept {
  const T sum = large + lesser_one;
  return {sum, lesser_one - (sum - large)};
}

/// x as two numbers of half the bits: 26 + 26 for double, 12 + 12 for float.
/// needs   |x| <= 2^995 (double), 2^114 (float)
/// exact   high + low == x
/// source  Veltkamp 1968; Dekker 1971
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr split_number<T> split(T x) noexcept {
  constexpr T factor = std::is_same_v<T, double> ? T(134217729) : T(4097);  // 2^27 + 1, 2^12 + 1
  const T scaled = product(factor, x);
  const T high = scaled - (scaled - x);
  return {high, x - high};
}

/// a*b, rounded, and what rounding took away, for arguments of moderate size.
/// needs   double: |a|, |b| <= 2^995 and a*b == 0 or 2^-968 <= |a*b| < 2^1021; float: a finite product
/// exact   value + error == a*b (float: unless the error underflows); outside of `needs` the bits of the error may
///         depend on the instruction set
/// cost    2 operations with a fused multiply-add, 17 without
/// source  Dekker 1971
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr exact_sum<T> fast_two_product(T a, T b) noexcept {
  if constexpr (std::is_same_v<T, float>) {
    const double exact = widened(a) * widened(b);
    const float value = converted<float>(exact);
    return {value, converted<float>(exact - widened(value))};
  } else {
    const double value = product(a, b);
    if constexpr (has_fused_multiply_add)
      if (!std::is_constant_evaluated()) return {value, fused_multiply_add(a, b, -value)};
    const auto [a_high, a_low] = split(a);
    const auto [b_high, b_low] = split(b);
    const double head = product(a_high, b_high) - value;
    const double middle = (head + product(a_high, b_low)) + product(a_low, b_high);
    return {value, middle + product(a_low, b_low)};
  }
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

/// a*b where a factor is NaN or infinite, 0 elsewhere: without an operation, which constant evaluation would refuse.
constexpr double endless_product(double a, double b) noexcept {
  if (is_finite(a) && is_finite(b)) return 0;
  if (is_nan(a) || is_nan(b) || a == 0 || b == 0) return not_a_number<double>;
  return is_negative(a) == is_negative(b) ? infinity<double> : -infinity<double>;
}

/// two_product where the product is not moderate, for constant evaluation, which refuses a product that overflows.
constexpr exact_sum<double> two_product_constant(double a, double b) noexcept {
  if (!is_finite(a) || !is_finite(b)) return {endless_product(a, b), 0.0};
  const scaled_number near_a = decompose(a), near_b = decompose(b);
  const int exponent = near_a.exponent + near_b.exponent;
  const exact_sum<double> near_product = fast_two_product(near_a.significand, near_b.significand);
  const double value = times_power_of_two(near_product.value, exponent);
  return {value, is_finite(value) ? times_power_of_two(near_product.error, exponent) : 0.0};
}

/// Whether constant evaluation refuses a + b, because it overflows; a and b are finite.
template <Floating T>
IRG_INLINE constexpr bool is_refused_sum(T a, T b) noexcept {
  constexpr T limit = (std::numeric_limits<T>::max)() / 2;
  return std::is_constant_evaluated() && magnitude(T(0.5) * a + T(0.5) * b) > limit;
}
/// Whether constant evaluation refuses a / b, because it overflows; a and b are finite, b is not 0.
IRG_INLINE constexpr bool is_refused_quotient(double a, double b) noexcept {
  if (!std::is_constant_evaluated() || a == 0) return false;
  const scaled_number x = decompose(a), y = decompose(b);
  return !is_finite(times_power_of_two(x.significand / y.significand, x.exponent - y.exponent));
}

/// two_product where fast_two_product does not hold: zeros, and products or factors near an end of the exponent range.
constexpr exact_sum<double> two_product_scaled(double a, double b) noexcept {
  const double value = product(a, b);
  // Below 2^-1021 the error is at most half the smallest number, which rounds to zero.
  if (magnitude(value) < 0x1p-1021 || !is_finite(value)) return {value, 0.0};
  const scaled_number near_a = decompose(a);
  const scaled_number near_b = decompose(b);
  const exact_sum<double> near_product = fast_two_product(near_a.significand, near_b.significand);
  // The exponents add up to -1023 at least, so that one multiplication, and one rounding, leads back.
  return {value, product(near_product.error, power_of_two(near_a.exponent + near_b.exponent))};
}

/// Whether a and b are finite and |a*b| < 2^1022. Told from the exponents: a product of scaled numbers would be
/// subnormal for the most usual ones, which costs processors a hundred cycles.
IRG_INLINE constexpr bool product_is_moderate(double a, double b) noexcept {
  const auto exponent = [](double x) { return static_cast<int>((bits_of(x) >> 52) & 0x7ff); };
  const int x = exponent(a), y = exponent(b);
  return x + y <= 2 * 1023 + 1020 && x != 0x7ff && y != 0x7ff;
}

constexpr double difference_of_products_scaled(double a, double b, double c, double d) noexcept;

/// a*b - 1, rounded once, or twice where that is as good.
/// needs   1/2 <= a*b <= 2, b of at most 24 bits
IRG_INLINE constexpr double product_less_one(double a, double b) noexcept {
  if (has_fused_multiply_add && !std::is_constant_evaluated()) return fused_multiply_add(a, b, -1.0);
  const double a_high = from_bits(bits_of(a) & ~std::uint64_t{0x3fffffff});  // 23 bits
  return (a_high * b - 1) + (a - a_high) * b;  // but for the sum, exact
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// a*b, rounded, and what rounding took away, for all arguments.
/// gives   error 0 when the product is not finite
/// exact   value + error == a*b unless the error underflows (|a*b| < 2^-968); then error is rounded once
/// cost    as fast_two_product and one predictable branch
/// source  Dekker 1971
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr exact_sum<T> two_product(T a, T b) noexcept {
  if constexpr (std::is_same_v<T, float>) {
    if (std::is_constant_evaluated() && !(is_finite(a) && is_finite(b)))
      return {static_cast<float>(detail::endless_product(widened(a), widened(b))), 0.0f};
    const exact_sum<float> p = fast_two_product(a, b);
    return {p.value, is_finite(p.value) ? p.error : 0.0f};
  } else {
    if (std::is_constant_evaluated() && !detail::product_is_moderate(a, b)) return detail::two_product_constant(a, b);
    const double size = magnitude(a * b);
    if (size >= 0x1p-968 && size < 0x1p1021 && magnitude(a) <= 0x1p995 && magnitude(b) <= 0x1p995)
      return fast_two_product(a, b);
    return detail::two_product_scaled(a, b);
  }
}

/// a*b - c*d without cancellation.
/// gives   infinity or NaN for infinite or NaN arguments; for finite ones never NaN, infinity only when the
///         difference itself overflows
/// exact   within 1 ulp (measured: 0.51), where |a*b| or |c*d| is at least 2^-900;
///         below, within 2^-1073 more; exactly zero when the products are equal
/// cost    two two_products and about 12 operations; float: 3 operations in double
/// source  Jeannerod, Louvet and Muller 2013 (Kahan's algorithm). Here both errors are kept, which needs no fused
///         multiply-add.
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T difference_of_products(T a, T b, T c, T d) noexcept {
  if constexpr (std::is_same_v<T, float>) {
    if (std::is_constant_evaluated() && !(is_finite(a) && is_finite(b) && is_finite(c) && is_finite(d)))
      return static_cast<float>(detail::difference_of_products_scaled(widened(a), widened(b), widened(c), widened(d)));
    return converted<float>(widened(a) * widened(b) - widened(c) * widened(d));
  } else {
    if (!detail::product_is_moderate(a, b) || !detail::product_is_moderate(c, d))
      return detail::difference_of_products_scaled(a, b, c, d);
    const exact_sum<double> left = two_product(a, b);
    const exact_sum<double> right = two_product(c, d);
    // Where the heads cancel, their difference and that of the errors are exact; elsewhere the errors are small.
    const exact_sum<double> heads = two_sum(left.value, -right.value);
    return heads.value + (heads.error + (left.error - right.error));
  }
}

/// a*b + c*d without cancellation.
/// exact   as difference_of_products
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T sum_of_products(T a, T b, T c, T d) noexcept {
  return difference_of_products(a, b, -c, d);
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

/// difference_of_products where a product overflows: at 2^-1200 of its size, where a product that loses bits is too
/// small to count beside the other.
constexpr double difference_of_products_scaled(double a, double b, double c, double d) noexcept {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c) || !is_finite(d)) {
    const double left = endless_product(a, b), right = endless_product(c, d);
    if (is_nan(left) || is_nan(right) || (left != 0 && left == right)) return not_a_number<double>;
    return left != 0 ? left : -right;
  }
  const double difference = difference_of_products(a * 0x1p-600, b * 0x1p-600, c * 0x1p-600, d * 0x1p-600);
  return times_power_of_two(difference, 1200);
}

}  // namespace detail::inline IRG_ABI
}  // namespace irg
