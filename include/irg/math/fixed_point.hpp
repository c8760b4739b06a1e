// SPDX-License-Identifier: MIT
// fixed_point<N>: numbers with 64 (N - 1) binary places, for orbits that need more digits than floats have.
#pragma once

#include <optional>
#include <string_view>

#include <irg/math/decimal_digit.hpp>
#include <irg/math/wide_int.hpp>

namespace irg {

/// The number units * 2^-64(N - 1): the highest word is its integer part, rounded down.
/// needs   values of less than 2^63, of factors less than 2^31: what does not fit wraps around
template <int N>
  requires(N >= 2)
struct fixed_point {
  wide_int<N> units{};

  constexpr fixed_point() = default;
  /// The number x.
  /// exact   but for what lies below the last place, which is cut off
  IRG_APART constexpr explicit fixed_point(double x) noexcept {
    double rest = x < 0 ? -x : x;
    for (int i = N - 1; i >= 0; --i, rest *= 0x1p64) {
      units.word[i] = static_cast<std::uint64_t>(rest);
      rest -= static_cast<double>(units.word[i]);
    }
    if (x < 0) units = -units;
  }

  IRG_APART friend constexpr fixed_point operator+(const fixed_point& a, const fixed_point& b) noexcept {
    return made_of(a.units + b.units);
  }
  IRG_APART friend constexpr fixed_point operator-(const fixed_point& a, const fixed_point& b) noexcept {
    return made_of(a.units - b.units);
  }
  IRG_APART constexpr fixed_point operator-() const noexcept { return made_of(-units); }
  /// exact   rounded down to the last place
  IRG_APART friend constexpr fixed_point operator*(const fixed_point& a, const fixed_point& b) noexcept {
    const wide_int<2 * N> all = a.units * b.units;
    fixed_point p;
    for (int i = 0; i < N; ++i) p.units.word[i] = all.word[i + N - 1];
    return p;
  }
  constexpr bool operator==(const fixed_point&) const noexcept = default;

  /// The number as a double.
  /// exact   relative error below 2^-52
  IRG_APART constexpr explicit operator double() const noexcept {
    const bool negative = units.is_negative();
    const wide_int<N> size = negative ? -units : units;
    double sum = 0, place = 1;
    for (int i = N - 1, used = 0; i >= 0 && used < 2; --i, place *= 0x1p-64) {
      sum += static_cast<double>(size.word[i]) * place;
      used += sum != 0;
    }
    return negative ? -sum : sum;
  }

  /// The number of those units.
  [[nodiscard]] IRG_APART static constexpr fixed_point made_of(const wide_int<N>& units) noexcept {
    fixed_point p;
    p.units = units;
    return p;
  }
};

inline namespace IRG_ABI {

/// The number that a decimal text spells: an optional sign, digits, an optional point and digits.
/// gives   nothing for any other text, and for an integer part of 2^31 and more
/// exact   an error below 2 units of the last place
template <int N>
[[nodiscard]] constexpr std::optional<fixed_point<N>> parse_fixed_point(std::string_view text) noexcept {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative || (!text.empty() && text.front() == '+')) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view places = point < text.size() ? text.substr(point + 1) : std::string_view();
  if (whole.empty() && places.empty()) return std::nullopt;

  wide_int<N> units;
  // From the last place to the first: a tenth of the digit with what follows it.
  for (std::size_t i = places.size(); i-- > 0;) {
    if (!is_decimal_digit(places[i])) return std::nullopt;
    uint128 rest = static_cast<unsigned>(places[i] - '0');
    for (int w = N - 2; w >= 0; --w) {
      const uint128 dividend = (rest << 64) | units.word[w];
      units.word[w] = static_cast<std::uint64_t>(dividend / 10);
      rest = dividend % 10;
    }
  }
  std::uint64_t integer = 0;
  for (const char c : whole) {
    if (!is_decimal_digit(c)) return std::nullopt;
    integer = 10 * integer + static_cast<std::uint64_t>(c - '0');
    if (integer >> 31 != 0) return std::nullopt;
  }
  units.word[N - 1] = integer;
  return fixed_point<N>::made_of(negative ? -units : units);
}

}  // namespace IRG_ABI
}  // namespace irg
