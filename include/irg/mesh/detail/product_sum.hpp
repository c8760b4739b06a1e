// SPDX-License-Identifier: MIT
// The sign of a sum of products of doubles, decided in integers for every finite input: what triangulation needs to
// tell left turns from right ones and to know which way round a polygon goes.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <irg/core/contraction.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// A fixed-point number wide enough for every sum of 2^28 products of two finite doubles.
/// shape   limb i counts in units of 2^(32 i - 2148); limbs are signed and carry nothing until sign() is asked for
class product_sum {
public:
  /// Adds x * y, or subtracts it.
  /// needs   finite x and y
  constexpr void add(double x, double y) noexcept { add(x, y, 1); }
  constexpr void subtract(double x, double y) noexcept { add(x, y, -1); }

  /// -1, 0 or 1.
  constexpr int sign() const noexcept {
    std::int64_t carry = 0;
    bool rest = false;
    for (std::size_t i = lowest_; i < end_; ++i) {
      const std::int64_t t = limbs_[i] + carry;
      rest = rest || (t & 0xffffffff) != 0;
      carry = t >> 32;
    }
    return carry < 0 ? -1 : carry > 0 || rest ? 1 : 0;
  }

private:
  static constexpr std::size_t limb_count = 136;
  std::int64_t limbs_[limb_count]{};
  std::size_t lowest_ = limb_count, end_ = 0;  // the limbs in use

  struct parts {
    std::uint64_t significand;
    int exponent;  // of the significand's last bit, counted from that of the smallest subnormal
    bool negative;
  };
  static constexpr parts split(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto fraction = bits & 0xfffffffffffffu;
    const auto field = static_cast<int>((bits >> 52) & 0x7ff);
    return {field == 0 ? fraction : fraction | 0x10000000000000u, field == 0 ? 0 : field - 1, bits >> 63 != 0};
  }

  constexpr void add(double x, double y, int sign) noexcept {
    const parts a = split(x), b = split(y);
    if (a.significand == 0 || b.significand == 0) return;
    if (a.negative != b.negative) sign = -sign;
    const std::uint64_t a0 = a.significand & 0xffffffffu, a1 = a.significand >> 32;
    const std::uint64_t b0 = b.significand & 0xffffffffu, b1 = b.significand >> 32;
    const int bit = a.exponent + b.exponent;
    put(bit, a0 * b0, sign);
    put(bit + 32, a0 * b1 + a1 * b0, sign);
    put(bit + 64, a1 * b1, sign);
  }

  constexpr void put(int bit, std::uint64_t value, int sign) noexcept {
    const std::size_t i = static_cast<std::size_t>(bit / 32);
    const int shift = bit % 32;
    limbs_[i] += sign * static_cast<std::int64_t>((value << shift) & 0xffffffffu);
    limbs_[i + 1] += sign * static_cast<std::int64_t>((value >> (32 - shift)) & 0xffffffffu);
    if (shift != 0) limbs_[i + 2] += sign * static_cast<std::int64_t>(value >> (64 - shift));
    lowest_ = i < lowest_ ? i : lowest_;
    end_ = i + 3 > end_ ? i + 3 : end_;
  }
};

template <class T>
constexpr int sign_of(const T& x) noexcept(noexcept(x < x)) {
  return x < static_cast<T>(0) ? -1 : static_cast<T>(0) < x ? 1 : 0;
}

IRG_NOINLINE constexpr int turn_by_integers(const point<double, 2>& a, const point<double, 2>& b,
                                            const point<double, 2>& c) noexcept {
  product_sum sum;  // a x b + b x c + c x a
  sum.add(a.x, b.y), sum.subtract(a.y, b.x);
  sum.add(b.x, c.y), sum.subtract(b.y, c.x);
  sum.add(c.x, a.y), sum.subtract(c.y, a.x);
  return sum.sign();
}

/// 1 when a, b, c turn left (y up), -1 when they turn right, 0 when they lie on a line.
/// needs   finite coordinates
/// exact   for every finite double; for other scalars as their own arithmetic is
/// source  Shewchuk 1997, Adaptive Precision Floating-Point Arithmetic (the filter's bound)
template <Scalar T>
constexpr int turn(const point<T, 2>& a, const point<T, 2>& b, const point<T, 2>& c) noexcept {
  if constexpr (std::same_as<T, double>) {
    const auto abs = [](double x) { return x < 0 ? -x : x; };
    const double largest =
        greater(greater(greater(abs(a.x), abs(a.y)), greater(abs(b.x), abs(b.y))), greater(abs(c.x), abs(c.y)));
    if (largest < 0x1p400) {  // so that nothing overflows; the lower limit makes flushed subnormals harmless
      const double left = product(a.x - c.x, b.y - c.y), right = product(a.y - c.y, b.x - c.x);
      const double det = left - right, size = abs(left) + abs(right);
      constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;
      if (size > 0x1p-500 && abs(det) > product((3 + 16 * half_ulp) * half_ulp, size)) return sign_of(det);
    }
    return turn_by_integers(a, b, c);
  } else {
    return sign_of((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x));
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail
