// SPDX-License-Identifier: MIT
// Quotients of integers, rounded down or up whatever their sign; the language's own division rounds towards 0.
#pragma once

#include <irg/core/config.hpp>
#include <irg/math/int128.hpp>

namespace irg::inline IRG_ABI {

/// The greatest integer that is not above n / d.
/// shape   signed integers of any width
/// needs   d > 0
template <class J>
[[nodiscard]] IRG_INLINE constexpr J floor_div(J n, J d) noexcept {
  const J q = n / d;
  return q * d > n ? q - 1 : q;
}

/// The least integer that is not below n / d.
/// shape   as floor_div
/// needs   d > 0
template <class J>
[[nodiscard]] IRG_INLINE constexpr J ceil_div(J n, J d) noexcept {
  const J q = n / d;
  return q * d < n ? q + 1 : q;
}

}  // namespace irg::inline IRG_ABI
