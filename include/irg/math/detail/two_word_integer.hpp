// SPDX-License-Identifier: MIT
// An integer of 128 bits made of two words, for compilers that have none of their own: what the language's operators do
// to their integers, they do to it. Slower than a compiler's; the same values.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/config.hpp>

namespace irg::detail {

enum class number_sign { none, twos_complement };

template <number_sign Sign>
class IRG_APART two_word_integer {
public:
  static constexpr bool is_signed = Sign == number_sign::twos_complement;

  two_word_integer() = default;
  template <std::integral T>
  constexpr two_word_integer(T value) noexcept
      : low_(static_cast<std::uint64_t>(value)), high_(value < T{} ? ~0ull : 0) {}
  template <number_sign Other>
    requires(Other != Sign)
  constexpr explicit two_word_integer(const two_word_integer<Other>& value) noexcept
      : low_(value.low()), high_(value.high()) {}
  /// The value without its fraction.
  /// needs   one that fits
  template <std::floating_point T>
  constexpr explicit two_word_integer(T value) noexcept : two_word_integer() {
    constexpr T word = T(4294967296) * T(4294967296);
    const T size = value < 0 ? -value : value;
    const auto above = static_cast<std::uint64_t>(size / word);
    *this = two_word_integer(static_cast<std::uint64_t>(size - static_cast<T>(above) * word), above);
    if (value < 0) *this = -*this;
  }

  constexpr std::uint64_t low() const noexcept { return low_; }
  constexpr std::uint64_t high() const noexcept { return high_; }

  template <std::integral T>
  constexpr explicit operator T() const noexcept {
    if constexpr (std::same_as<T, bool>)
      return (low_ | high_) != 0;
    else
      return static_cast<T>(low_);
  }
  /// The nearest number, ties to even.
  template <std::floating_point T>
  constexpr explicit operator T() const noexcept {
    if (negative()) return -static_cast<T>(magnitude());
    if (high_ == 0) return static_cast<T>(low_);
    const int up = width() - 64;  // what is lost below 64 bits counts as one bit of them
    const std::uint64_t kept = up == 64 ? high_ : high_ << (64 - up) | low_ >> up;
    const std::uint64_t lost = up == 64 ? low_ : low_ << (64 - up);
    const T half = static_cast<T>(kept | (lost != 0)) * static_cast<T>(std::uint64_t{1} << (up / 2));
    return half * static_cast<T>(std::uint64_t{1} << (up - up / 2));
  }

  friend constexpr bool operator==(const two_word_integer&, const two_word_integer&) = default;
  friend constexpr std::strong_ordering operator<=>(const two_word_integer& a, const two_word_integer& b) noexcept {
    if (a.high_ != b.high_) {
      if constexpr (is_signed)
        return static_cast<std::int64_t>(a.high_) <=> static_cast<std::int64_t>(b.high_);
      else
        return a.high_ <=> b.high_;
    }
    return a.low_ <=> b.low_;
  }

  constexpr two_word_integer operator+() const noexcept { return *this; }
  constexpr two_word_integer operator~() const noexcept { return {~low_, ~high_}; }
  constexpr two_word_integer operator-() const noexcept { return {~low_ + 1, ~high_ + (low_ == 0)}; }
  constexpr bool operator!() const noexcept { return (low_ | high_) == 0; }

  friend constexpr two_word_integer operator+(const two_word_integer& a, const two_word_integer& b) noexcept {
    const std::uint64_t low = a.low_ + b.low_;
    return {low, a.high_ + b.high_ + (low < a.low_)};
  }
  friend constexpr two_word_integer operator-(const two_word_integer& a, const two_word_integer& b) noexcept {
    return {a.low_ - b.low_, a.high_ - b.high_ - (a.low_ < b.low_)};
  }
  friend constexpr two_word_integer operator*(const two_word_integer& a, const two_word_integer& b) noexcept {
    const std::uint64_t a0 = a.low_ & 0xffffffff, a1 = a.low_ >> 32, b0 = b.low_ & 0xffffffff, b1 = b.low_ >> 32;
    const std::uint64_t low = a0 * b0, one = a1 * b0 + (low >> 32), other = a0 * b1 + (one & 0xffffffff);
    return {other << 32 | (low & 0xffffffff),
            a1 * b1 + (one >> 32) + (other >> 32) + a.low_ * b.high_ + a.high_ * b.low_};
  }
  friend constexpr two_word_integer operator/(const two_word_integer& a, const two_word_integer& b) noexcept {
    natural rest = a.magnitude();
    const natural q = divide(rest, b.magnitude());
    const two_word_integer size{q.low_, q.high_};
    return a.negative() != b.negative() ? -size : size;
  }
  friend constexpr two_word_integer operator%(const two_word_integer& a, const two_word_integer& b) noexcept {
    natural rest = a.magnitude();
    divide(rest, b.magnitude());
    const two_word_integer size{rest.low_, rest.high_};
    return a.negative() ? -size : size;
  }
  friend constexpr two_word_integer operator&(const two_word_integer& a, const two_word_integer& b) noexcept {
    return {a.low_ & b.low_, a.high_ & b.high_};
  }
  friend constexpr two_word_integer operator|(const two_word_integer& a, const two_word_integer& b) noexcept {
    return {a.low_ | b.low_, a.high_ | b.high_};
  }
  friend constexpr two_word_integer operator^(const two_word_integer& a, const two_word_integer& b) noexcept {
    return {a.low_ ^ b.low_, a.high_ ^ b.high_};
  }
  friend constexpr two_word_integer operator<<(const two_word_integer& a, int bits) noexcept {
    if (bits == 0) return a;
    if (bits >= 64) return {0, a.low_ << (bits - 64)};
    return {a.low_ << bits, a.high_ << bits | a.low_ >> (64 - bits)};
  }
  friend constexpr two_word_integer operator>>(const two_word_integer& a, int bits) noexcept {
    const auto moved = [](std::uint64_t word, int by) {
      if constexpr (is_signed)
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(word) >> by);
      else
        return word >> by;
    };
    if (bits == 0) return a;
    if (bits >= 64) return {moved(a.high_, bits - 64), a.negative() ? ~0ull : 0};
    return {a.low_ >> bits | a.high_ << (64 - bits), moved(a.high_, bits)};
  }

  constexpr two_word_integer& operator+=(const two_word_integer& b) noexcept { return *this = *this + b; }
  constexpr two_word_integer& operator-=(const two_word_integer& b) noexcept { return *this = *this - b; }
  constexpr two_word_integer& operator*=(const two_word_integer& b) noexcept { return *this = *this * b; }
  constexpr two_word_integer& operator/=(const two_word_integer& b) noexcept { return *this = *this / b; }
  constexpr two_word_integer& operator%=(const two_word_integer& b) noexcept { return *this = *this % b; }
  constexpr two_word_integer& operator&=(const two_word_integer& b) noexcept { return *this = *this & b; }
  constexpr two_word_integer& operator|=(const two_word_integer& b) noexcept { return *this = *this | b; }
  constexpr two_word_integer& operator^=(const two_word_integer& b) noexcept { return *this = *this ^ b; }
  constexpr two_word_integer& operator<<=(int bits) noexcept { return *this = *this << bits; }
  constexpr two_word_integer& operator>>=(int bits) noexcept { return *this = *this >> bits; }
  constexpr two_word_integer& operator++() noexcept { return *this += 1; }
  constexpr two_word_integer& operator--() noexcept { return *this -= 1; }

private:
  using natural = two_word_integer<number_sign::none>;
  template <number_sign>
  friend class two_word_integer;

  constexpr two_word_integer(std::uint64_t low, std::uint64_t high) noexcept : low_(low), high_(high) {}

  constexpr bool negative() const noexcept { return is_signed && high_ >> 63 != 0; }
  constexpr natural magnitude() const noexcept {
    const two_word_integer m = negative() ? -*this : *this;
    return {m.low_, m.high_};
  }
  constexpr int width() const noexcept {
    return static_cast<int>(high_ != 0 ? 64 + std::bit_width(high_) : std::bit_width(low_));
  }

  // The quotient; what is left of `a` stays there. Bit by bit, from the first at which the divisor fits.
  static constexpr natural divide(natural& a, const natural& b) noexcept {
    if (a.high_ == 0 && b.high_ == 0) {
      const natural quotient = a.low_ / b.low_;
      a.low_ %= b.low_;
      return quotient;
    }
    natural quotient = 0;
    for (int i = a.width() - b.width(); i >= 0; --i)
      if (const natural part = b << i; part <= a) {
        a -= part;
        quotient |= natural(1) << i;
      }
    return quotient;
  }

  std::uint64_t low_, high_;
};

}  // namespace irg::detail
