// SPDX-License-Identifier: MIT
// Round numbers along an axis, and their texts: steps of 1, 2 or 5 times a power of ten.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <irg/core/instructions.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/decimal.hpp>
#include <irg/mesh/part_name.hpp>

namespace irg {

/// A text that a plot keeps.
using plot_text = part_name;

/// A place on an axis, and the text beside it.
struct axis_tick {
  double value = 0;
  plot_text text{};
  bool operator==(const axis_tick&) const = default;
};

namespace detail::inline IRG_ABI {

// The double nearest to digits * 10^exponent.
template <class Int>
constexpr double decimal_value(Int digits, int exponent) noexcept {
  char text[44] = {};
  char* end = *print_integer(text, text + 20, digits);
  *end++ = 'e';
  end = *print_integer(end, end + 20, exponent);
  return parse_decimal<double>(text, end).value;
}

template <class Tick>
constexpr void add_tick(std::vector<Tick>& ticks, double value) {
  const double shown = value == 0 ? 0 : value;  // no -0
  char text[longest_decimal<double>] = {};
  ticks.push_back({shown, print_decimal(std::span(text), shown)});
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Round numbers from low to high: the multiples of the least step of 1, 2 or 5 times a power of ten that is a
/// `most`th of their difference or longer, so that at most `most` and one more fit in.
/// needs   low <= high; most at least 1
/// gives   one tick where they are equal; both ends where their difference overflows, is below 1e-300, or has less than
///         two digits of theirs, and where such steps are finer than doubles are there; none for NaN and infinities.
///         Texts are the shortest that read as the values
/// exact   values, and `most` steps, which the rounded difference is held against: the doubles nearest to the decimals
template <class Tick = axis_tick>
[[nodiscard]] constexpr std::vector<Tick> axis_ticks(double low, double high, int most) {
  std::vector<Tick> ticks;
  const double span = high - low, size = maximum(magnitude(low), magnitude(high));
  if (!(low <= high) || !(size <= 0x1.fffffffffffffp1023)) return ticks;
  if (low == high) {
    detail::add_tick(ticks, low);
    return ticks;
  }
  const auto both_ends = [&] {
    detail::add_tick(ticks, low);
    detail::add_tick(ticks, high);
    return ticks;
  };
  if (!(span <= 0x1.fffffffffffffp1023) || span < 1e-300 || span < size * 0x1p-45) return both_ends();
  int digit = 1, exponent = -310;
  const auto falls_short = [&](int d, int e) { return detail::decimal_value(std::int64_t{d} * most, e) < span; };
  int above = 308;
  while (exponent + 1 < above) {  // the greatest power of ten that is too small
    const int half = (exponent + above) / 2;
    (falls_short(1, half) ? exponent : above) = half;
  }
  for (int d : {2, 5, 10})
    if (falls_short(digit, exponent)) digit = d;
  const double step = detail::decimal_value(digit, exponent);
  if (!(size / step < 0x1p52)) return both_ends();
  for (auto k = static_cast<std::int64_t>(low / step) - 1;; ++k) {
    const double value = detail::decimal_value(k * digit, exponent);
    if (value > high) break;
    if (value >= low) detail::add_tick(ticks, value);
  }
  return ticks;
}

}  // namespace IRG_ABI
}  // namespace irg
