// SPDX-License-Identifier: MIT
// The exact sum of products of two doubles, for any finite doubles and any number of terms a computer can add: one
// fixed point number wide enough for the smallest and the largest product. Slow (some 100 ns for a sign), so it stands
// behind a filter; what it decides is decided in integers, whatever the floating-point flags and modes.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/config.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

__extension__ typedef unsigned __int128 product_of_significands;

// x = +-significand * 2^exponent, the significand an integer.
struct integer_double {
  std::uint64_t significand;
  int exponent;
  bool negative;
};
constexpr integer_double integer_parts(double x) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t fraction = bits & 0xfffffffffffffu;
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  return {biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52), biased == 0 ? -1074 : biased - 1075,
          bits >> 63 != 0};
}

// A two's complement number whose lowest bit is worth 2^-2148, the smallest product of two doubles. The largest, below
// 2^2048, ends at bit 4196; 92 bits are left for the carries of many terms and the sign.
class exact_products {
public:
  // Adds x*y, exactly.
  constexpr void add(double x, double y) noexcept { accumulate(integer_parts(x), integer_parts(y), false); }
  // Subtracts x*y, exactly.
  constexpr void subtract(double x, double y) noexcept { accumulate(integer_parts(x), integer_parts(y), true); }

  // -1, 0 or 1, as the sum is negative, zero or positive.
  constexpr int sign() const noexcept {
    if (word_[words - 1] >> 63 != 0) return -1;
    for (const std::uint64_t w : word_)
      if (w != 0) return 1;
    return 0;
  }

private:
  static constexpr int words = 67;

  constexpr void accumulate(const integer_double& x, const integer_double& y, bool minus) noexcept {
    const product_of_significands p = product_of_significands{x.significand} * y.significand;
    if (p == 0) return;
    const int place = x.exponent + y.exponent + 2148, shift = place % 64;
    const auto low = static_cast<std::uint64_t>(p), high = static_cast<std::uint64_t>(p >> 64);
    const std::uint64_t part[3] = {low << shift, shift == 0 ? high : (low >> (64 - shift)) | (high << shift),
                                   shift == 0 ? 0 : high >> (64 - shift)};
    const bool negative = (x.negative != y.negative) != minus;
    std::uint64_t carry = 0;
    for (int i = place / 64, k = 0; i < words && (k < 3 || carry != 0); ++i, ++k)
      carry = negative ? take_away(word_[i], k < 3 ? part[k] : 0, carry) : put(word_[i], k < 3 ? part[k] : 0, carry);
  }
  static constexpr std::uint64_t put(std::uint64_t& w, std::uint64_t v, std::uint64_t carry) noexcept {
    const std::uint64_t sum = w + v, total = sum + carry;
    const std::uint64_t out = static_cast<std::uint64_t>(sum < v) | static_cast<std::uint64_t>(total < sum);
    w = total;
    return out;
  }
  static constexpr std::uint64_t take_away(std::uint64_t& w, std::uint64_t v, std::uint64_t borrow) noexcept {
    const std::uint64_t rest = w - v, total = rest - borrow;
    const std::uint64_t out = static_cast<std::uint64_t>(w < v) | static_cast<std::uint64_t>(rest < borrow);
    w = total;
    return out;
  }

  std::uint64_t word_[words]{};
};

}  // namespace IRG_ABI
}  // namespace irg::detail
