// SPDX-License-Identifier: MIT
// exact_accumulator<K>: sums of products of doubles, exact for all finite doubles: one fixed-point number wide enough
// for the smallest and the largest product of K factors. It computes in integers only, so no floating-point flag or
// mode of the processor reaches it.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

#include <irg/core/config.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/int128.hpp>
#include <irg/math/detail/exact_sum_steps.hpp>

namespace irg {

/// A sum of products of up to K finite doubles each, exact for 2^60 terms and more.
/// cost    about 10 ns for a term; sums of terms of like size touch a few words only
/// needs   1 <= K <= 7
template <int K>
class exact_accumulator {
  static_assert(K >= 1 && K <= 7);

public:
  IRG_INLINE constexpr exact_accumulator() noexcept {}
  IRG_INLINE constexpr exact_accumulator(const exact_accumulator& v) noexcept { *this = v; }
  IRG_INLINE constexpr exact_accumulator& operator=(const exact_accumulator& v) noexcept {
    if (this == &v) return *this;
    range_ = v.range_;
    for (int i = range_.first; i < range_.last; ++i) word_[i] = v.word_[i];
    return *this;
  }

  /// Adds the product of the factors.
  /// needs   1 to K finite factors
  template <std::same_as<double>... X>
    requires(sizeof...(X) >= 1 && sizeof...(X) <= K)
  IRG_INLINE constexpr void add(X... x) noexcept {
    const double factors[] = {x...};
    detail::accumulate_product(word_, range_, factors, sizeof...(X), lowest, false);
  }
  /// Subtracts the product of the factors.
  /// needs   1 to K finite factors
  template <std::same_as<double>... X>
    requires(sizeof...(X) >= 1 && sizeof...(X) <= K)
  IRG_INLINE constexpr void subtract(X... x) noexcept {
    const double factors[] = {x...};
    detail::accumulate_product(word_, range_, factors, sizeof...(X), lowest, true);
  }

  /// Adds the sum v times x.
  /// needs   x finite
  template <int L>
    requires(L < K)
  IRG_APART constexpr void add(const exact_accumulator<L>& v, double x) noexcept {
    const detail::integer_double factor = detail::integer_parts(x);
    const int sign = v.sign();
    if (sign == 0 || factor.significand == 0) return;
    const int place = 64 * v.range_.first + exact_accumulator<L>::lowest - lowest - 1074 + factor.place;
    std::uint64_t magnitude[static_cast<unsigned>(words)];
    int n = 0;
    std::uint64_t carry = sign < 0 ? 1u : 0u;
    for (int i = v.range_.first; i < v.range_.last; ++i) {
      magnitude[n] = (sign < 0 ? ~v.word_[i] : v.word_[i]) + carry;
      carry = carry != 0 && magnitude[n] == 0 ? 1u : 0u;
      ++n;
    }
    detail::multiply_in(magnitude, n++, factor.significand);
    detail::multiply_in(magnitude, n++, std::uint64_t{1} << (place % 64));  // so that no word too many is touched
    while (magnitude[n - 1] == 0) --n;
    detail::accumulate(word_, range_, magnitude, n, place - place % 64, (sign < 0) != factor.negative);
  }

  /// -1, 0 or 1, as the sum is negative, zero or positive.
  [[nodiscard]] IRG_INLINE constexpr int sign() const noexcept { return detail::sign_of_words(word_, range_); }

  /// The exponent e of the sum: 2^e <= |sum| < 2^(e + 1).
  /// needs   a sum that is not zero
  [[nodiscard]] IRG_INLINE constexpr int exponent() const noexcept {
    return detail::highest_bit(word_, range_) + lowest;
  }

  /// The double nearest to the sum times 2^shift.
  /// gives   infinity of the sum's sign where the sum rounds beyond the largest double; 0 (not -0) for zero
  /// exact   correctly rounded, ties to even, subnormals included
  [[nodiscard]] IRG_INLINE constexpr double rounded(int shift = 0) const noexcept {
    return detail::nearest_double(word_, range_, lowest + shift);
  }

  /// The sum times 2^shift as the nearest double and what is left of it, rounded in its turn.
  /// gives   error 0 where value is infinite
  /// exact   value + error is within 2^-106 of the sum's size, unless error underflows
  [[nodiscard]] IRG_INLINE constexpr exact_sum<double> rounded_parts(int shift = 0) const noexcept {
    const double value = rounded(shift);
    const detail::integer_double v = detail::integer_parts(value);
    if (!detail::is_finite(value) || v.significand == 0) return {value, 0.0};
    // The value times 2^-shift is a multiple of the lowest bit; its significand may reach further, in zeros.
    const int place = v.place - 1074 - shift - lowest;
    const std::uint64_t significand = place < 0 ? v.significand >> -place : v.significand;
    exact_accumulator rest = *this;
    detail::accumulate(rest.word_, rest.range_, &significand, 1, place < 0 ? 0 : place, !v.negative);
    return {value, rest.rounded(shift)};
  }

private:
  template <int L>
  friend class exact_accumulator;

  static constexpr int lowest = -1074 * K;
  static constexpr int words = (2098 * K + 64 + 63) / 64 + 1;

  // Words outside of the range are not initialised: what is not used costs nothing.
  std::uint64_t word_[static_cast<unsigned>(words)];
  detail::word_range range_{0, 0};
};

}  // namespace irg
