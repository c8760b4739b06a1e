// SPDX-License-Identifier: MIT
// Notes of several threads about the same triangle.
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/core/config.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// Several tiles may note the same triangle at the same time; all write the same. (The header <atomic> would cost every
// user of this chapter a tenth of a second.)
IRG_INLINE constexpr void mark_seen(std::uint8_t& seen) noexcept {
  if (std::is_constant_evaluated()) {
    seen = 1;
    return;
  }
#ifdef __GNUC__
  __atomic_store_n(&seen, std::uint8_t{1}, __ATOMIC_RELAXED);
#else
  *static_cast<volatile std::uint8_t*>(&seen) = 1;
#endif
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
