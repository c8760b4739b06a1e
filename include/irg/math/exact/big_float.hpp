// SPDX-License-Identifier: MIT
// big_float: words of 64 bits and an exponent, with exact sum, difference and product. Polynomials of doubles are
// computed in it where rounded numbers do not tell their sign; whatever the exponents, nothing is rounded.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/core/config.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/exact/scaled_double_double.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/int128.hpp>

namespace irg {

/// A real number that is a whole multiple of a power of two, with room for every polynomial of this degree in finite
/// doubles, of up to 2^60 terms.
/// shape   a sign, and the words of the magnitude from the lowest that is not zero to the highest; word 0 counts in
///         units of 2^(64 place)
template <int Degree>
class big_float {
  static constexpr int most_words = (2098 * Degree + 60) / 64 + 4;

public:
  IRG_INLINE constexpr big_float() noexcept {}  // zero; the words beyond `size_` are never read

  IRG_INLINE constexpr explicit big_float(double x) noexcept {
    const auto [significand, place, negative] = integer_parts_of(x);
    const int lift = place - 1074 + 18 * 64;  // the last bit's exponent, made positive
    negative_ = negative;
    place_ = lift / 64 - 18;
    const int shift = lift % 64;
    put(significand << shift);
    put(shift == 0 ? 0 : significand >> (64 - shift));
    trim();
  }

  IRG_INLINE constexpr big_float(const big_float& other) noexcept { take(other); }
  IRG_INLINE constexpr big_float& operator=(const big_float& other) noexcept {
    if (this != &other) take(other);
    return *this;
  }

  /// What words() gave of another.
  /// needs   room for them: those of a degree that is not higher
  IRG_APART constexpr big_float(const std::uint64_t* words, int size, int place, bool negative) noexcept {
    for (int i = 0; i < size; ++i) word_[i] = words[i];
    size_ = size, place_ = place, negative_ = negative;
  }
  [[nodiscard]] IRG_INLINE constexpr const std::uint64_t* words() const noexcept { return word_; }
  [[nodiscard]] IRG_INLINE constexpr int size() const noexcept { return size_; }
  [[nodiscard]] IRG_INLINE constexpr int place() const noexcept { return place_; }
  IRG_APART friend constexpr bool operator==(const big_float& a, const big_float& b) noexcept {
    return (a - b).sign() == 0;
  }

  [[nodiscard]] IRG_INLINE constexpr int sign() const noexcept { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

  IRG_APART friend constexpr big_float operator+(const big_float& a, const big_float& b) noexcept {
    if (a.size_ == 0) return b;
    if (b.size_ == 0) return a;
    big_float sum;
    const bool add = a.negative_ == b.negative_, a_larger = add || !is_smaller(a, b);
    const big_float &large = a_larger ? a : b, &lesser_one = a_larger ? b : a;
    const int first = minimum(a.place_, b.place_), last = maximum(a.end(), b.end());
    sum.place_ = first;
    sum.negative_ = large.negative_;
    std::uint64_t carry = 0;
    for (int place = first; place < last; ++place) {
      const std::uint64_t x = large.at(place), y = lesser_one.at(place);
      const std::uint64_t part = add ? x + y : x - y, whole = add ? part + carry : part - carry;
      const bool over = add ? part < x || whole < part : x < y || part < carry;
      sum.put(whole);
      carry = over ? 1 : 0;
    }
    if (carry != 0) sum.put(1);
    sum.trim();
    return sum;
  }
  IRG_APART friend constexpr big_float operator-(const big_float& a) noexcept {
    big_float negated = a;
    negated.negative_ = !a.negative_;
    return negated;
  }
  IRG_APART friend constexpr big_float operator-(const big_float& a, const big_float& b) noexcept { return a + -b; }

  IRG_APART friend constexpr big_float operator*(const big_float& a, const big_float& b) noexcept {
    big_float product;
    if (a.size_ == 0 || b.size_ == 0) return product;
    product.place_ = a.place_ + b.place_;
    product.negative_ = a.negative_ != b.negative_;
    for (int i = 0; i < a.size_ + b.size_; ++i) product.put(0);
    for (int i = 0; i < a.size_; ++i) {
      std::uint64_t carry = 0;
      for (int k = 0; k < b.size_; ++k) {
        const uint128 t = uint128{a.word_[i]} * b.word_[k] + product.word_[i + k] + carry;  // at most 2^128 - 1
        product.word_[i + k] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      product.word_[i + b.size_] = carry;
    }
    product.trim();
    return product;
  }

  /// The number to 106 bits or more.
  /// exact   relative error at most 2^-105
  [[nodiscard]] IRG_APART constexpr scaled_double_double rounded() const noexcept {
    if (size_ == 0) return {};
    const int top = end() - 1, zeros = std::countl_zero(at(top));
    const auto window = [&](int place) {  // 64 bits from the highest one down, then the 64 below
      return zeros == 0 ? at(place) : at(place) << zeros | at(place - 1) >> (64 - zeros);
    };
    const std::uint64_t upper = window(top), lower = window(top - 1);
    // Parts of 53, 53 and 22 bits; those dropped are below 2^-127 of the number.
    const auto part = [](std::uint64_t bits) { return static_cast<double>(static_cast<std::int64_t>(bits)); };
    const double first = part(upper >> 11), second = part((upper & 0x7ff) << 42 | lower >> 22) * 0x1p-53;
    const double high = first + second, low = second - (high - first), scale = negative_ ? -0x1p-52 : 0x1p-52;
    return {high * scale, low * scale, 64 * top + 63 - zeros};
  }

private:
  [[nodiscard]] IRG_INLINE constexpr int end() const noexcept { return place_ + size_; }
  [[nodiscard]] IRG_INLINE constexpr std::uint64_t at(int place) const noexcept {
    return place < place_ || place >= end() ? 0 : word_[place - place_];
  }
  IRG_INLINE constexpr void put(std::uint64_t word) noexcept {
    if (size_ < most_words) word_[size_++] = word;  // a sum's last word is a carry of 0 where no room is left
  }
  IRG_APART constexpr void take(const big_float& other) noexcept {
    for (int i = 0; i < other.size_; ++i) word_[i] = other.word_[i];
    place_ = other.place_, size_ = other.size_, negative_ = other.negative_;
  }
  IRG_APART constexpr void trim() noexcept {
    while (size_ > 0 && word_[size_ - 1] == 0) --size_;
    int zeros = 0;
    while (zeros < size_ && word_[zeros] == 0) ++zeros;
    if (zeros == 0) return;
    for (int i = zeros; i < size_; ++i) word_[i - zeros] = word_[i];
    size_ -= zeros;
    place_ += zeros;
  }
  // In magnitude.
  [[nodiscard]] IRG_APART static constexpr bool is_smaller(const big_float& a, const big_float& b) noexcept {
    if (a.end() != b.end()) return a.end() < b.end();
    const int last = minimum(a.place_, b.place_);
    for (int place = a.end() - 1; place >= last; --place)
      if (a.at(place) != b.at(place)) return a.at(place) < b.at(place);
    return false;
  }

  std::uint64_t word_[static_cast<std::size_t>(most_words)];
  int place_ = 0, size_ = 0;
  bool negative_ = false;
};

inline namespace IRG_ABI {

/// x as a big float.
/// needs   finite x
template <class N, class T>
  requires(Floating<T> || std::is_integral_v<T>)
[[nodiscard]] IRG_INLINE constexpr N exactly(const T& x) noexcept {
  if constexpr (Floating<T>) {
    return N(exactly_widened(x));
  } else if constexpr (sizeof(T) <= 4) {
    return N(static_cast<double>(x));
  } else {
    const T high = x >> 32;
    return N(static_cast<double>(high) * 0x1p32) + N(static_cast<double>(x - (high << 32)));
  }
}

}  // namespace IRG_ABI
}  // namespace irg
