// SPDX-License-Identifier: MIT
// The order of two numbers, of floats by their bits: a processor that takes subnormal numbers for zero would find some
// of them equal.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/scalar.hpp>

namespace irg::inline IRG_ABI {

/// -1, 0 or 1, as a is less than b, equal or greater.
/// needs   no NaN
/// exact   -0 and 0 are equal
template <class T>
[[nodiscard]] IRG_INLINE constexpr int compare_numbers(const T& a, const T& b) noexcept {
  if constexpr (Floating<T>) {
    using bits = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
    const auto place = [](const T& x) {  // -0 and 0 have the same
      const auto v = std::bit_cast<bits>(x);
      return v < 0 ? (std::numeric_limits<bits>::min)() - v : v;
    };
    return compare_numbers(place(a), place(b));
  } else {
    return a < b ? -1 : b < a ? 1 : 0;
  }
}

}  // namespace irg::inline IRG_ABI
