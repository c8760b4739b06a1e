// SPDX-License-Identifier: MIT
// A natural number of bounded size on the stack, for the exact conversion of decimal text: as many operations as that
// needs and no more.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/config.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// 5^0 to 5^27: all that fit 64 bits.
struct five_powers {
  std::uint64_t value[28]{};
  constexpr five_powers() noexcept {
    value[0] = 1;
    for (int i = 1; i < 28; ++i) value[i] = value[i - 1] * 5;
  }
  constexpr std::uint64_t operator[](int i) const noexcept { return value[i]; }
};
inline constexpr five_powers powers_of_five{};

/// A natural number below 2^2816.
/// shape   words from low to high; the highest of `size` words is not 0; words from `size` on are 0
struct natural {
  static constexpr int capacity = 88;
  std::uint32_t words[capacity]{};
  int size = 0;

  /// needs   value > 0
  static constexpr natural from(std::uint64_t value) noexcept {
    natural n;
    n.words[0] = static_cast<std::uint32_t>(value);
    n.words[1] = static_cast<std::uint32_t>(value >> 32);
    n.size = n.words[1] != 0 ? 2 : 1;
    return n;
  }

  constexpr void multiply_add(std::uint32_t factor, std::uint32_t addend) noexcept {
    std::uint64_t carry = addend;
    for (int i = 0; i < size; ++i) {
      carry += std::uint64_t{factor} * words[i];
      words[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    if (carry != 0) words[size++] = static_cast<std::uint32_t>(carry);
  }

  constexpr void multiply_power_of_five(int exponent) noexcept {
    for (; exponent >= 13; exponent -= 13) multiply_add(static_cast<std::uint32_t>(powers_of_five[13]), 0);
    multiply_add(static_cast<std::uint32_t>(powers_of_five[exponent]), 0);
  }

  constexpr int bit_length() const noexcept { return size == 0 ? 0 : 32 * size - std::countl_zero(words[size - 1]); }

  constexpr void shift_left(int bits) noexcept {
    if (size == 0) return;
    const int whole = bits / 32, part = bits % 32;
    for (int i = size; i >= 0; --i) {
      const std::uint64_t pair = (std::uint64_t{i < size ? words[i] : 0} << 32) | (i > 0 ? words[i - 1] : 0);
      words[i + whole] = static_cast<std::uint32_t>((pair << part) >> 32);
    }
    for (int i = 0; i < whole; ++i) words[i] = 0;
    size += whole + 1;
    if (words[size - 1] == 0) --size;
  }
};

/// The quotient of two naturals, and whether a remainder is left.
struct natural_quotient {
  std::uint64_t value;
  bool inexact;
};

/// a / b in whole numbers.
/// needs   the top bit of b's highest word set, and a < b * 2^64
/// source  Knuth 1969, The Art of Computer Programming 2, algorithm D, cut to its two digits of 32 bits
constexpr natural_quotient divide(natural& a, const natural& b) noexcept {
  const int n = b.size;
  std::uint64_t value = 0;
  for (int j = 1; j >= 0; --j) {
    const std::uint64_t top = (std::uint64_t{a.words[j + n]} << 32) | a.words[j + n - 1];
    std::uint64_t digit = top / b.words[n - 1];  // at most 2 too large, for b's top bit is set
    if (digit > 0xffffffffu) digit = 0xffffffffu;
    std::int64_t borrow = 0;
    for (int i = 0; i < n; ++i) {
      const std::uint64_t part = digit * b.words[i];
      const std::int64_t t = std::int64_t{a.words[i + j]} - static_cast<std::int64_t>(part & 0xffffffffu) + borrow;
      a.words[i + j] = static_cast<std::uint32_t>(t);
      borrow = (t >> 32) - static_cast<std::int64_t>(part >> 32);
    }
    std::int64_t high = std::int64_t{a.words[j + n]} + borrow;
    while (high < 0) {
      --digit;
      std::uint64_t carry = 0;
      for (int i = 0; i < n; ++i) {
        carry += std::uint64_t{a.words[i + j]} + b.words[i];
        a.words[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      high += static_cast<std::int64_t>(carry);
    }
    a.words[j + n] = static_cast<std::uint32_t>(high);
    value = (value << 32) | digit;
  }
  bool inexact = false;
  for (int i = 0; i < n; ++i) inexact = inexact || a.words[i] != 0;
  return {value, inexact};
}

}  // namespace IRG_ABI
}  // namespace irg::detail
