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
#include <irg/math/float_bits.hpp>
#include <irg/math/int128.hpp>
#include <irg/math/wide_int.hpp>

namespace irg {

namespace detail {

// A stretch of words, from low to high: those below `first` are zero, those from `last` on repeat the sign.
struct word_range {
  int first, last;
};

}  // namespace detail

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
  IRG_INLINE constexpr void add(X... x) noexcept;
  /// Subtracts the product of the factors.
  /// needs   1 to K finite factors
  template <std::same_as<double>... X>
    requires(sizeof...(X) >= 1 && sizeof...(X) <= K)
  IRG_INLINE constexpr void subtract(X... x) noexcept;

  /// Adds the sum v times x.
  /// needs   x finite
  template <int L>
    requires(L < K)
  IRG_APART constexpr void add(const exact_accumulator<L>& v, double x) noexcept;

  /// -1, 0 or 1, as the sum is negative, zero or positive.
  [[nodiscard]] IRG_INLINE constexpr int sign() const noexcept;

  /// The exponent e of the sum: 2^e <= |sum| < 2^(e + 1).
  /// needs   a sum that is not zero
  [[nodiscard]] IRG_INLINE constexpr int exponent() const noexcept;

  /// The double nearest to the sum times 2^shift.
  /// gives   infinity of the sum's sign where the sum rounds beyond the largest double; 0 (not -0) for zero
  /// exact   correctly rounded, ties to even, subnormals included
  [[nodiscard]] IRG_INLINE constexpr double rounded(int shift = 0) const noexcept;

  /// The sum times 2^shift as the nearest double and what is left of it, rounded in its turn.
  /// gives   error 0 where value is infinite
  /// exact   value + error is within 2^-106 of the sum's size, unless error underflows
  [[nodiscard]] IRG_INLINE constexpr exact_sum<double> rounded_parts(int shift = 0) const noexcept;

private:
  template <int L>
  friend class exact_accumulator;

  static constexpr int lowest = -1074 * K;
  static constexpr int words = (2098 * K + 64 + 63) / 64 + 1;

  // Words outside of the range are not initialised: what is not used costs nothing.
  std::uint64_t word_[static_cast<unsigned>(words)];
  detail::word_range range_{0, 0};
};

namespace detail::inline IRG_ABI {

// Makes the words first to last part of the range.
constexpr void widen_range(std::uint64_t* word, word_range& range, int first, int last) noexcept {
  if (range.first == range.last) range = {first, first};
  while (range.first > first) word[--range.first] = 0;
  const std::uint64_t sign = range.last > range.first && word[range.last - 1] >> 63 != 0 ? ~std::uint64_t{0} : 0;
  while (range.last < last) word[range.last++] = sign;
}

// Adds magnitude[0..n) * 2^place, or subtracts it. The top word of the range keeps a bit to spare.
constexpr void accumulate(std::uint64_t* word, word_range& range, const std::uint64_t* magnitude, int n, int place,
                          bool negative) noexcept {
  const int shift = place % 64, base = place / 64;
  widen_range(word, range, base, base + n + 1);
  const std::uint64_t flip = negative ? ~std::uint64_t{0} : 0;
  std::uint64_t carry = negative ? 1 : 0;
  for (int i = base; i < range.last; ++i) {
    const int k = i - base;
    const std::uint64_t high = k < n ? magnitude[k] << shift : 0;
    const std::uint64_t low = shift != 0 && k >= 1 && k <= n ? magnitude[k - 1] >> (64 - shift) : 0;
    const uint128 sum = uint128{word[i]} + ((high | low) ^ flip) + carry;
    word[i] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
  const std::uint64_t top = word[range.last - 1];
  if ((top ^ (top << 1)) >> 63 != 0) widen_range(word, range, range.first, range.last + 1);
}

// magnitude[0..n] = magnitude[0..n) * factor.
constexpr void multiply_in(std::uint64_t* magnitude, int n, std::uint64_t factor) noexcept {
  std::uint64_t carry = 0;
  for (int i = 0; i < n; ++i) {
    const uint128 p = uint128{magnitude[i]} * factor + carry;
    magnitude[i] = static_cast<std::uint64_t>(p);
    carry = static_cast<std::uint64_t>(p >> 64);
  }
  magnitude[n] = carry;
}

// Adds the product of x[0..k), each a double, into a number whose lowest bit is worth 2^lowest.
constexpr void accumulate_product(std::uint64_t* word, word_range& range, const double* x, int k, int lowest,
                                  bool negative) noexcept {
  std::uint64_t magnitude[8]{};
  int place = -1074 * k - lowest;
  for (int i = 0; i < k; ++i) {
    const integer_parts<double> v = integer_parts_of(x[i]);
    if (v.significand == 0) return;
    if (i == 0)
      magnitude[0] = v.significand;
    else
      multiply_in(magnitude, i, v.significand);
    place += v.place;
    negative = negative != v.negative;
  }
  accumulate(word, range, magnitude, k, place, negative);
}

constexpr int sign_of_words(const std::uint64_t* word, word_range range) noexcept {
  if (range.first == range.last) return 0;
  if (word[range.last - 1] >> 63 != 0) return -1;
  for (int i = range.last - 1; i >= range.first; --i)
    if (word[i] != 0) return 1;
  return 0;
}

// The number of the highest bit of the absolute value of a number that is not zero.
constexpr int highest_bit(const std::uint64_t* word, word_range range) noexcept {
  const bool negative = word[range.last - 1] >> 63 != 0;
  int low = range.first, top = range.last - 1;
  while (word[low] == 0) ++low;
  const auto magnitude = [&](int i) { return !negative ? word[i] : i == low ? std::uint64_t{0} - word[i] : ~word[i]; };
  while (magnitude(top) == 0) --top;
  return 64 * top + 63 - std::countl_zero(magnitude(top));
}

// The nearest double, ties to even, of a number whose lowest bit is worth 2^lowest.
constexpr double nearest_double(const std::uint64_t* word, word_range range, int lowest) noexcept {
  const int sign = sign_of_words(word, range);
  if (sign == 0) return 0;
  int low = range.first;
  while (word[low] == 0) ++low;
  const auto magnitude = [&](int i) -> std::uint64_t {  // word i of the absolute value
    if (i < low || i >= range.last) return 0;
    return sign > 0 ? word[i] : i == low ? std::uint64_t{0} - word[i] : ~word[i];
  };
  const int highest = highest_bit(word, range);
  if (highest + lowest > 1023) return std::bit_cast<double>(sign < 0 ? 0xfffull << 52 : 0x7ffull << 52);
  // The result's last bit, as a bit of the number: not below the smallest subnormal.
  const int last = highest - 52 + lowest < -1074 ? -1074 - lowest : highest - 52;
  const auto bits_from = [&](int bit) {  // 64 bits from `bit` on
    const int i = bit >= 0 ? bit / 64 : -((63 - bit) / 64), shift = bit - 64 * i;
    return shift == 0 ? magnitude(i) : (magnitude(i) >> shift) | (magnitude(i + 1) << (64 - shift));
  };
  std::uint64_t rounded = bits_from(last) & ((std::uint64_t{1} << 53) - 1);
  if ((bits_from(last - 1) & 1) != 0) {
    bool up = (rounded & 1) != 0;  // half-way goes to the even one, what lies beyond goes up
    for (int i = low; 64 * i < last - 1 && !up; ++i) {
      const int bits = last - 1 - 64 * i;
      up = (bits >= 64 ? magnitude(i) : magnitude(i) << (64 - bits)) != 0;
    }
    rounded += up ? 1 : 0;
  }
  // A carry out of the significand raises the exponent by itself, up to infinity.
  rounded += static_cast<std::uint64_t>(last + lowest + 1074) << 52;
  return std::bit_cast<double>(rounded | (sign < 0 ? std::uint64_t{1} << 63 : 0));
}

}  // namespace detail::inline IRG_ABI

template <int K>
template <std::same_as<double>... X>
  requires(sizeof...(X) >= 1 && sizeof...(X) <= K)
IRG_INLINE constexpr void exact_accumulator<K>::add(X... x) noexcept {
  const double factors[] = {x...};
  detail::accumulate_product(word_, range_, factors, sizeof...(X), lowest, false);
}

template <int K>
template <std::same_as<double>... X>
  requires(sizeof...(X) >= 1 && sizeof...(X) <= K)
IRG_INLINE constexpr void exact_accumulator<K>::subtract(X... x) noexcept {
  const double factors[] = {x...};
  detail::accumulate_product(word_, range_, factors, sizeof...(X), lowest, true);
}

template <int K>
template <int L>
  requires(L < K)
IRG_APART constexpr void exact_accumulator<K>::add(const exact_accumulator<L>& v, double x) noexcept {
  const integer_parts<double> factor = integer_parts_of(x);
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

template <int K>
[[nodiscard]] IRG_INLINE constexpr int exact_accumulator<K>::sign() const noexcept {
  return detail::sign_of_words(word_, range_);
}

template <int K>
[[nodiscard]] IRG_INLINE constexpr int exact_accumulator<K>::exponent() const noexcept {
  return detail::highest_bit(word_, range_) + lowest;
}

template <int K>
[[nodiscard]] IRG_INLINE constexpr double exact_accumulator<K>::rounded(int shift) const noexcept {
  return detail::nearest_double(word_, range_, lowest + shift);
}

template <int K>
[[nodiscard]] IRG_INLINE constexpr exact_sum<double> exact_accumulator<K>::rounded_parts(int shift) const noexcept {
  const double value = rounded(shift);
  const integer_parts<double> v = integer_parts_of(value);
  if (!is_finite(value) || v.significand == 0) return {value, 0.0};
  // The value times 2^-shift is a multiple of the lowest bit; its significand may reach further, in zeros.
  const int place = v.place - 1074 - shift - lowest;
  const std::uint64_t significand = place < 0 ? v.significand >> -place : v.significand;
  exact_accumulator rest = *this;
  detail::accumulate(rest.word_, rest.range_, &significand, 1, place < 0 ? 0 : place, !v.negative);
  return {value, rest.rounded(shift)};
}

inline namespace IRG_ABI {

/// The double nearest to v * 2^shift, ties to even.
/// gives   infinity of v's sign where it rounds beyond the largest double; 0 (not -0) for zero
/// exact   correctly rounded, subnormals included
template <int N>
[[nodiscard]] constexpr double rounded_to_double(const wide_int<N>& v, int shift = 0) noexcept {
  return detail::nearest_double(v.word, {0, N}, shift);
}

}  // namespace IRG_ABI
}  // namespace irg
