// SPDX-License-Identifier: MIT
// twofold: a number in twice the precision of double, with a bound of its error carried along. Polynomials of doubles
// are computed with it first; the bound tells whether sign and value are sure.
#pragma once

#include <irg/math/error_free.hpp>

namespace irg::detail {

/// high + low, at most about `bound` away from the number it stands for.
/// shape   high is high + low rounded; bound is 0 when nothing was rounded on the way
/// needs   numbers made from doubles that are 0 or 2^-80 <= |x| < 2^80, and polynomials of degree 6 at most: all parts
///         are then multiples of 2^-800 below 2^500, so that nothing over- or underflows
struct twofold {
  double high = 0, low = 0, bound = 0;

  constexpr twofold() = default;
  IRG_INLINE constexpr explicit twofold(double x) noexcept : high(x) {}
  IRG_INLINE constexpr twofold(double h, double l, double b) noexcept : high(h), low(l), bound(b) {}

  constexpr bool operator==(const twofold&) const = default;
  IRG_INLINE friend constexpr twofold operator-(const twofold& a) noexcept { return {-a.high, -a.low, a.bound}; }
  /// source  Joldes, Muller and Popescu 2017: AccurateDWPlusDW, at most 3u^2 + 13u^3
  IRG_INLINE friend constexpr twofold operator+(const twofold& a, const twofold& b) noexcept {
    const auto heads = two_sum(a.high, b.high), tails = two_sum(a.low, b.low);
    const auto upper = fast_two_sum(heads.value, heads.error + tails.value);
    const auto sum = fast_two_sum(upper.value, tails.error + upper.error);
    const bool is_exact = a.low == 0 && b.low == 0;
    return {sum.value, sum.error, a.bound + b.bound + (is_exact ? 0.0 : magnitude(sum.value) * 0x1p-104)};
  }
  IRG_INLINE friend constexpr twofold operator-(const twofold& a, const twofold& b) noexcept { return a + -b; }
  /// source  Joldes, Muller and Popescu 2017: DWTimesDW1, at most 5u^2
  IRG_INLINE friend constexpr twofold operator*(const twofold& a, const twofold& b) noexcept {
    const auto heads = fast_two_product(a.high, b.high);
    const double cross = product(a.high, b.low) + product(a.low, b.high);
    const auto whole = fast_two_sum(heads.value, heads.error + cross);
    const bool is_exact = a.low == 0 && b.low == 0;
    const double carried =
        product(magnitude(a.high), b.bound) + product(magnitude(b.high), a.bound) + product(a.bound, b.bound);
    return {whole.value, whole.error, carried + (is_exact ? 0.0 : magnitude(whole.value) * 0x1p-103)};
  }

  /// Whether the number is sure to have this sign and to be off by less than 2^-60 of its size. The factor 2^-61
  /// leaves room for the rounding of `bound` itself.
  IRG_INLINE constexpr bool is_sure() const noexcept { return bound <= magnitude(high) * 0x1p-61; }
};

}  // namespace irg::detail
