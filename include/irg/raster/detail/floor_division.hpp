// SPDX-License-Identifier: MIT
// Quotients of integers, rounded down or up whatever their sign; the language's own division rounds towards 0.
#pragma once

#include <irg/core/config.hpp>
#include <irg/math/int128.hpp>

namespace irg::detail {

inline namespace IRG_ABI {

// The greatest integer that is not above n / d; d > 0. J is a signed integer of any width.
template <class J>
IRG_INLINE constexpr J floor_div(J n, J d) noexcept {
  const J q = n / d;
  return q * d > n ? q - 1 : q;
}

// The least integer that is not below n / d; d > 0.
template <class J>
IRG_INLINE constexpr J ceil_div(J n, J d) noexcept {
  const J q = n / d;
  return q * d < n ? q + 1 : q;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
