// SPDX-License-Identifier: MIT
// Floating-point numbers in order: the number of each, which of two is less, and the one nearest to a value that can
// only be compared, exactly, with sums of two numbers.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/scalar.hpp>

namespace irg {

/// An integer for each number of type T.
template <Floating T>
using float_ordinal = std::conditional_t<std::is_same_v<T, double>, std::int64_t, std::int32_t>;

inline namespace IRG_ABI {

/// The number of x among the floating-point numbers in order: zero (either) is 0, its neighbours are 1 and -1.
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr float_ordinal<T> ordinal_of(T x) noexcept {
  using J = float_ordinal<T>;
  const auto bits = std::bit_cast<J>(x);
  return bits < 0 ? (std::numeric_limits<J>::min)() - bits : bits;
}

/// -1, 0 or 1, as a is less than b, equal or greater; floats by their bits, since a processor that takes subnormal
/// numbers for zero would find some of them equal.
/// needs   no NaN
/// exact   -0 and 0 are equal
template <class T>
[[nodiscard]] IRG_INLINE constexpr int compare_numbers(const T& a, const T& b) noexcept {
  if constexpr (Floating<T>) {
    return compare_numbers(ordinal_of(a), ordinal_of(b));
  } else {
    return a < b ? -1 : b < a ? 1 : 0;
  }
}

/// The floating-point number with this number.
template <Floating T>
[[nodiscard]] constexpr T float_at(float_ordinal<T> k) noexcept {
  return std::bit_cast<T>(k < 0 ? (std::numeric_limits<float_ordinal<T>>::min)() - k : k);
}

/// The T nearest to an exact value y, ties to even, found by comparisons alone.
/// shape   side(p, q) is the sign of 2*y - (p + q); the search begins at `guess`
/// needs   low <= y <= high
template <Floating T, class Side>
[[nodiscard]] constexpr T nearest_by_sign(T low, T high, T guess, const Side& side) noexcept {
  using J = float_ordinal<T>;
  J floor = ordinal_of(low), ceiling = ordinal_of(high);  // floor's number <= y <= ceiling's
  J at = low <= guess && guess <= high ? ordinal_of(guess) : floor + (ceiling / 2 - floor / 2);
  for (J step = 1; floor < ceiling;) {
    const int s = side(float_at<T>(at), float_at<T>(at));
    if (s == 0) return float_at<T>(at);
    (s > 0 ? floor : ceiling) = at;
    const bool wide = ceiling / 2 - floor / 2 > step;
    if (!wide && ceiling - floor <= 1) break;
    at = !wide   ? static_cast<J>(floor + (ceiling - floor) / 2)
         : s > 0 ? static_cast<J>(floor + step)
                 : static_cast<J>(ceiling - step);
    if (wide && step <= (std::numeric_limits<J>::max)() / 2) step = static_cast<J>(step * 2);
  }
  const int s = side(float_at<T>(floor), float_at<T>(ceiling));
  return float_at<T>(s < 0 || (s == 0 && floor % 2 == 0) ? floor : ceiling);
}

}  // namespace IRG_ABI
}  // namespace irg
