// SPDX-License-Identifier: MIT
// Square roots of integers, rounded down, exact.
#pragma once

#include <cstdint>

#include <irg/math/sqrt.hpp>
#include <irg/math/floor_division.hpp>

namespace irg::detail::inline IRG_ABI {

// floor(sqrt(n)); 0 <= n < 2^62. The floating root is off by one at most, whatever the rounding of n.
constexpr std::int64_t floor_sqrt(std::int64_t n) noexcept {
  auto root = static_cast<std::int64_t>(sqrt(static_cast<double>(n)));
  while (root * root > n) --root;
  while ((root + 1) * (root + 1) <= n) ++root;
  return root;
}

// floor(sqrt(n)) for every n < 2^127: Newton's iteration from above, which falls until it is there. The first guess is
// the root of the leading 62 bits, right to about 30 of them.
constexpr std::uint64_t floor_sqrt_wide(uint128 n) noexcept {
  int shift = 0;
  while ((n >> shift) >> 62 != 0) shift += 2;
  const auto leading = static_cast<std::uint64_t>(floor_sqrt(static_cast<std::int64_t>(n >> shift)));
  if (shift == 0) return leading;
  uint128 root = uint128{leading + 1} << (shift / 2);
  for (;;) {
    const uint128 next = (root + n / root) / 2;
    if (next >= root) return static_cast<std::uint64_t>(root);
    root = next;
  }
}

}  // namespace irg::detail::inline IRG_ABI
