// SPDX-License-Identifier: MIT
// checked<T, S>: a value and how it came about, for functions that give something harmless whatever they are asked
// for and say so.
#pragma once

#include <irg/core/config.hpp>

namespace irg {

/// A value, and what its arguments amounted to.
/// shape   S is an enum whose first value says that all is well
template <class T, class S>
struct [[nodiscard]] checked {
  T value{};
  S status{};

  /// Whether the value is what was asked for.
  [[nodiscard]] IRG_INLINE constexpr bool is_ordinary() const noexcept { return status == S{}; }
  bool operator==(const checked&) const = default;
};

}  // namespace irg
