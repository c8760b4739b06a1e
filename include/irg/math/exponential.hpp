// SPDX-License-Identifier: MIT
// Powers, logarithms and the cube root, the same bits in constant evaluation and at run time, on every compiler and
// instruction set. float arguments are computed in double and rounded once more.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/math/detail/exponential_kernels.hpp>
#include <irg/math/detail/hard_floats.hpp>

namespace irg {
inline namespace IRG_ABI {

/// e^x.
/// gives   NaN for NaN; infinity beyond 709.78 (float 88.72), 0 below -745.13 (float -103.97)
/// exact   double within 0.52 ulp, subnormal results too; float the nearest one
/// cost    a table lookup and about 25 operations
/// source  Tang 1989 (table and short polynomial); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] constexpr T exp(T x) noexcept {
  return detail::narrow<T>(detail::exp_of({widened(x), 0.0}));
}

/// 2^x.
/// gives   NaN for NaN; exact powers for integers x
/// exact   as exp
/// cost    as exp
template <Floating T>
[[nodiscard]] constexpr T exp2(T x) noexcept {
  return detail::nearest_result<detail::symmetry::none>(x, detail::exp2_of(widened(x)), detail::hard_powers_of_two);
}

/// The natural logarithm of x.
/// gives   -infinity for 0 and -0, infinity for infinity, NaN for NaN and everything below zero; +0 for 1
/// exact   double within 0.51 ulp; float the nearest one
/// cost    a table lookup and about 30 operations, and 50 more once in some 100 times, or where |x - 1| is small;
///         float: about 20, and 50 more once in some 500 times
/// source  Tang 1990 (table and short polynomial); coefficients by scripts/generate
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log(T x) noexcept {
  return detail::nearest_log_of(x, detail::natural_base);
}

/// The logarithm of x to base 2.
/// gives   as log; exact integers for powers of two
/// exact   as log
/// cost    log and a product
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log2(T x) noexcept {
  return detail::nearest_log_of(x, detail::binary);
}

/// The logarithm of x to base 10.
/// gives   as log; exact integers for powers of ten
/// exact   as log
/// cost    log and a product
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr T log10(T x) noexcept {
  return detail::nearest_log_of(x, detail::decimal);
}

/// x to the power y.
/// gives   what Annex F of C says: 1 for y = 0 or x = 1 even beside NaN; NaN for negative x and y no integer;
///         0 or infinity with x's sign where y is an odd integer and without it elsewhere
/// exact   double within 0.52 ulp, subnormal results too; float within 0.5001 ulp
/// cost    log, an exact product and exp
/// source  irg's own: the logarithm carries 14 bits beyond double
template <Floating T>
[[nodiscard]] constexpr T pow(T x, std::type_identity_t<T> y) noexcept {
  if constexpr (std::is_same_v<T, float>)
    if (const float power = detail::quick_pow_of(x, y); power == power) return power;
  return detail::narrow<T>(detail::pow_of(widened(x), widened(y)));
}

/// The cube root of x.
/// gives   NaN for NaN; infinities and zeros with their signs
/// exact   double within 0.501 ulp; float the nearest one; perfect cubes exactly
/// cost    two divisions, an exact product
/// source  Halley 1694; the last step compares the exact cube of a 26-bit root
template <Floating T>
[[nodiscard]] constexpr T cbrt(T x) noexcept {
  const double size = detail::magnitude(widened(x));
  if (!(size > 0 && size < detail::infinity<double>)) return x;
  return detail::narrow<T>(detail::with_sign(detail::cbrt_of(size), widened(x)));
}

}  // namespace IRG_ABI
}  // namespace irg
