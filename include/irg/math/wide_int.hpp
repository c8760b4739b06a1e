// SPDX-License-Identifier: MIT
// Signed integers of 64, 128, 192, ... bits, for results that must be exact and whose size is known beforehand: sums
// keep the width, products get the width of both factors together. Nothing is checked, as with built-in integers, but
// what does not fit wraps around. Plain words and carries, so that constant evaluation and every target agree.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include <irg/core/config.hpp>
#include <irg/math/int128.hpp>

namespace irg {

namespace detail {

template <class T>
concept word_sized = std::integral<T> && sizeof(T) <= 8;

inline namespace IRG_ABI {

// The low and the high word of a double word.
IRG_INLINE constexpr std::uint64_t low_word(uint128 v) noexcept { return static_cast<std::uint64_t>(v); }
IRG_INLINE constexpr std::uint64_t high_word(uint128 v) noexcept { return static_cast<std::uint64_t>(v >> 64); }
IRG_INLINE constexpr uint128 two_words(const std::uint64_t* w) noexcept { return (uint128{w[1]} << 64) | w[0]; }
// All bits set when the sign bit of w is.
IRG_INLINE constexpr std::uint64_t sign_mask(std::uint64_t w) noexcept {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(w) >> 63);
}

// word[0..N) += v[0..N) + carry; what is carried out of the last word is lost.
template <int N>
IRG_INLINE constexpr void add_words(std::uint64_t* word, const std::uint64_t* v, std::uint64_t flip,
                                    std::uint64_t carry) noexcept {
  if constexpr (N == 1) {
    word[0] += (v[0] ^ flip) + carry;
  } else {  // in pairs, for which there are instructions
    const uint128 x = two_words(word), y = two_words(v) ^ ((uint128{flip} << 64) | flip);
    const uint128 sum = x + y, total = sum + carry;
    word[0] = low_word(total);
    word[1] = high_word(total);
    if constexpr (N > 2)
      add_words<N - 2>(word + 2, v + 2, flip, static_cast<std::uint64_t>(sum < x) | (total < sum ? 1u : 0u));
  }
}

}  // namespace IRG_ABI
}  // namespace detail

/// A signed integer of N words of 64 bits, two's complement.
/// shape   word[0] is the lowest; the top bit of word[N - 1] is the sign
template <int N>
  requires(N >= 1)
struct wide_int {
  std::uint64_t word[static_cast<unsigned>(N)]{};

  wide_int() = default;
  /// The value of a built-in integer.
  /// needs   one that fits: N >= 2 for unsigned 64 bits and for 128 bits
  template <detail::word_sized T>
  IRG_INLINE constexpr wide_int(T v) noexcept {
    word[0] = static_cast<std::uint64_t>(v);
    if constexpr (std::is_signed_v<T>)
      for (int i = 1; i < N; ++i) word[i] = detail::sign_mask(word[0]);
  }
  IRG_INLINE constexpr wide_int(int128 v) noexcept {
    word[0] = static_cast<std::uint64_t>(v);
    if constexpr (N >= 2) word[1] = static_cast<std::uint64_t>(v >> 64);
    for (int i = 2; i < N; ++i) word[i] = detail::sign_mask(word[1]);
  }
  /// The same value in more words.
  template <int M>
    requires(M < N)
  IRG_INLINE constexpr wide_int(const wide_int<M>& v) noexcept {
    for (int i = 0; i < N; ++i) word[i] = i < M ? v.word[i] : detail::sign_mask(v.word[M - 1]);
  }

  /// -1, 0 or 1.
  [[nodiscard]] IRG_INLINE constexpr int sign() const noexcept {
    std::uint64_t any = 0;
    for (int i = 0; i < N; ++i) any |= word[i];
    return static_cast<int>(static_cast<std::int64_t>(word[N - 1]) >> 63) | static_cast<int>(any != 0);  // no branch
  }
  [[nodiscard]] IRG_INLINE constexpr bool is_negative() const noexcept { return word[N - 1] >> 63 != 0; }

  IRG_INLINE constexpr wide_int& operator+=(const wide_int& v) noexcept {
    detail::add_words<N>(word, v.word, 0, 0);
    return *this;
  }
  IRG_INLINE constexpr wide_int& operator-=(const wide_int& v) noexcept {
    detail::add_words<N>(word, v.word, ~std::uint64_t{0}, 1);
    return *this;
  }
  IRG_INLINE friend constexpr wide_int operator+(wide_int a, const wide_int& b) noexcept { return a += b; }
  IRG_INLINE friend constexpr wide_int operator-(wide_int a, const wide_int& b) noexcept { return a -= b; }
  IRG_INLINE constexpr wide_int operator-() const noexcept { return wide_int() - *this; }

  IRG_INLINE friend constexpr bool operator==(const wide_int& a, const wide_int& b) noexcept {
    std::uint64_t different = 0;
    for (int i = 0; i < N; ++i) different |= a.word[i] ^ b.word[i];
    return different == 0;
  }
  IRG_INLINE friend constexpr std::strong_ordering operator<=>(const wide_int& a, const wide_int& b) noexcept {
    if (a.is_negative() != b.is_negative()) return b.is_negative() <=> a.is_negative();
    for (int i = N - 1; i > 0; --i)
      if (a.word[i] != b.word[i]) return a.word[i] <=> b.word[i];
    return a.word[0] <=> b.word[0];
  }
};

namespace detail::inline IRG_ABI {

// a * b as unsigned numbers, from whose upper half a negative factor takes away the other.
template <int N, int M>
IRG_INLINE constexpr wide_int<N + M> long_product(const wide_int<N>& a, const wide_int<M>& b) noexcept {
  wide_int<N + M> p;
  for (int j = 0; j < M; ++j) {
    std::uint64_t carry = 0;
    for (int i = 0; i < N; ++i) {
      const uint128 t = uint128{a.word[i]} * b.word[j] + p.word[i + j] + carry;
      p.word[i + j] = low_word(t);
      carry = high_word(t);
    }
    p.word[j + N] = carry;
  }
  const std::uint64_t a_mask = sign_mask(a.word[N - 1]), b_mask = sign_mask(b.word[M - 1]);
  wide_int<M> from_a;
  for (int i = 0; i < M; ++i) from_a.word[i] = b.word[i] & a_mask;
  add_words<M>(p.word + N, from_a.word, ~std::uint64_t{0}, 1);
  wide_int<N> from_b;
  for (int i = 0; i < N; ++i) from_b.word[i] = a.word[i] & b_mask;
  add_words<N>(p.word + M, from_b.word, ~std::uint64_t{0}, 1);
  return p;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// a * b, in full.
/// exact   for all values
template <int N, int M>
[[nodiscard]] IRG_INLINE constexpr wide_int<N + M> operator*(const wide_int<N>& a, const wide_int<M>& b) noexcept {
  if constexpr (N == 1 && M == 1) {
    return int128{static_cast<std::int64_t>(a.word[0])} * static_cast<std::int64_t>(b.word[0]);
  } else if constexpr (N < M) {
    return b * a;
  } else if constexpr (N == 2 && M == 1) {
    const uint128 low = uint128{a.word[0]} * b.word[0];
    const std::uint64_t middle = detail::high_word(low) - (a.word[0] & detail::sign_mask(b.word[0]));
    const int128 high = int128{static_cast<std::int64_t>(a.word[1])} * static_cast<std::int64_t>(b.word[0]) +
                        static_cast<std::int64_t>(middle);
    wide_int<3> p;
    p.word[0] = detail::low_word(low);
    p.word[1] = static_cast<std::uint64_t>(high);
    p.word[2] = static_cast<std::uint64_t>(high >> 64);
    return p;
  } else if constexpr (N == 2 && M == 2) {
    // In double words: through arrays, g++ would have vector loads wait for stores of words.
    const uint128 low = uint128{a.word[0]} * b.word[0], high = uint128{a.word[1]} * b.word[1];
    const uint128 one = uint128{a.word[1]} * b.word[0], other = uint128{a.word[0]} * b.word[1];
    const uint128 middle = uint128{detail::high_word(low)} + detail::low_word(one) + detail::low_word(other);
    const std::uint64_t a_mask = detail::sign_mask(a.word[1]), b_mask = detail::sign_mask(b.word[1]);
    const uint128 from_a = (uint128{b.word[1] & a_mask} << 64) | (b.word[0] & a_mask);
    const uint128 from_b = (uint128{a.word[1] & b_mask} << 64) | (a.word[0] & b_mask);
    const uint128 top =
        high + detail::high_word(one) + detail::high_word(other) + detail::high_word(middle) - from_a - from_b;
    wide_int<4> p;
    p.word[0] = detail::low_word(low);
    p.word[1] = detail::low_word(middle);
    p.word[2] = detail::low_word(top);
    p.word[3] = detail::high_word(top);
    return p;
  } else {
    return detail::long_product(a, b);
  }
}

}  // namespace IRG_ABI
}  // namespace irg
