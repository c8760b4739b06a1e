// SPDX-License-Identifier: MIT
// The order of two numbers, of floats by their bits: a processor that takes subnormal numbers for zero would find some
// of them equal.
#pragma once

#include <irg/core/scalar.hpp>
#include <irg/math/exact/nearest_float.hpp>

namespace irg::inline IRG_ABI {

/// -1, 0 or 1, as a is less than b, equal or greater.
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

}  // namespace irg::inline IRG_ABI
