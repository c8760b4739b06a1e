// SPDX-License-Identifier: MIT
// The digits of decimal text, in any locale: '0' to '9' and nothing else.
#pragma once

#include <irg/core/config.hpp>

namespace irg::inline IRG_ABI {

/// Whether a character is one of '0' to '9'.
[[nodiscard]] IRG_INLINE constexpr bool is_decimal_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// The value of a decimal digit.
/// needs   is_decimal_digit(c)
[[nodiscard]] IRG_INLINE constexpr unsigned decimal_digit_value(char c) noexcept {
  return static_cast<unsigned>(c - '0');
}

}  // namespace irg::inline IRG_ABI
