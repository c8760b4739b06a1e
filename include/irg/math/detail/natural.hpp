// SPDX-License-Identifier: MIT
// A natural number of bounded size on the stack, for the exact comparison of decimal text with binary numbers: as many
// operations as that needs and no more. And powers of ten to 128 bits, which decide nearly always.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/config.hpp>
#include <irg/math/detail/powers_of_five_table.hpp>
#include <irg/math/int128.hpp>

namespace irg::detail {

#ifdef __SIZEOF_INT128__
#endif

/// high * 2^64 + low.
struct word_pair {
  std::uint64_t high, low;
};

inline namespace IRG_ABI {

/// a * b + addend, which always fits.
IRG_INLINE constexpr word_pair multiply_words(std::uint64_t a, std::uint64_t b, std::uint64_t addend = 0) noexcept {
#ifdef __SIZEOF_INT128__
  const uint128 p = uint128{a} * b + addend;
  return {static_cast<std::uint64_t>(p >> 64), static_cast<std::uint64_t>(p)};
#else
  const std::uint64_t half = 0xffffffffu;
  const std::uint64_t low = (a & half) * (b & half) + (addend & half);
  const std::uint64_t one = (a >> 32) * (b & half) + (low >> 32) + (addend >> 32);
  const std::uint64_t other = (a & half) * (b >> 32) + (one & half);
  return {(a >> 32) * (b >> 32) + (one >> 32) + (other >> 32), (other << 32) | (low & half)};
#endif
}

/// floor(log2(5^n)) and floor(log2(10^n)).
/// needs   -345 <= n <= 329
constexpr int floor_log2_of_power_of_five(int n) noexcept { return (n * 152170) >> 16; }
constexpr int floor_log2_of_power_of_ten(int n) noexcept { return (n * 217706) >> 16; }

/// 5^n / 2^(floor(log2(5^n)) - 127), cut off to an integer of 128 bits.
/// needs   lowest_power_of_five <= n <= highest_power_of_five
IRG_INLINE constexpr word_pair power_of_five_to_128_bits(int n) noexcept {
  const std::uint64_t* const entry = powers_of_five_to_128_bits + 2 * (n - lowest_power_of_five);
  return {entry[0], entry[1]};
}

/// Whether nothing was cut off.
constexpr bool is_exact_to_128_bits(int n) noexcept { return 0 <= n && n <= 55; }

/// A natural number below 2^2816.
/// shape   words from low to high; the highest of `size` words is not 0; words from `size` on are 0
struct natural {
  static constexpr int capacity = 44;
  std::uint64_t words[capacity]{};
  int size = 0;

  /// needs   value > 0
  static constexpr natural from(std::uint64_t value) noexcept {
    natural n;
    n.words[0] = value;
    n.size = 1;
    return n;
  }

  constexpr void multiply_add(std::uint64_t factor, std::uint64_t addend) noexcept {
    std::uint64_t carry = addend;
    for (int i = 0; i < size; ++i) {
      const word_pair p = multiply_words(factor, words[i], carry);
      words[i] = p.low;
      carry = p.high;
    }
    if (carry != 0) words[size++] = carry;
  }

  constexpr void multiply_power_of_five(int exponent) noexcept {
    constexpr std::uint64_t largest = 7450580596923828125u;  // 5^27
    for (; exponent >= 27; exponent -= 27) multiply_add(largest, 0);
    multiply_add(power_of_five_to_128_bits(exponent).high >> (63 - floor_log2_of_power_of_five(exponent)), 0);
  }

  constexpr int bit_length() const noexcept { return size == 0 ? 0 : 64 * size - std::countl_zero(words[size - 1]); }

  constexpr void shift_left(int bits) noexcept {
    if (size == 0 || bits == 0) return;
    const int whole = bits / 64, part = bits % 64;
    const bool grows = part != 0 && words[size - 1] >> (64 - part) != 0;
    for (int i = size - (grows ? 0 : 1); i >= 0; --i) {
      const std::uint64_t high = i < size ? words[i] << part : 0;
      const std::uint64_t low = part != 0 && i > 0 ? words[i - 1] >> (64 - part) : 0;
      words[i + whole] = high | low;
    }
    for (int i = 0; i < whole; ++i) words[i] = 0;
    size += whole + (grows ? 1 : 0);
  }
};

/// -1, 0 or 1: a * 2^shift less than b, equal, more.
/// needs   a > 0, b > 0; shifts one of them, the shorter
constexpr int compare_shifted(natural& a, int shift, natural& b) noexcept {
  const int longer = a.bit_length() + shift - b.bit_length();
  if (longer != 0) return longer < 0 ? -1 : 1;
  if (shift > 0)
    a.shift_left(shift);
  else
    b.shift_left(-shift);
  for (int i = a.size - 1; i >= 0; --i)
    if (a.words[i] != b.words[i]) return a.words[i] < b.words[i] ? -1 : 1;
  return 0;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
