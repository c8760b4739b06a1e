// SPDX-License-Identifier: MIT
// Where a ring turns back on itself.
#pragma once

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg::detail::inline IRG_ABI {

// Whether the way from a over b to c turns back at b, or stands still.
template <Point P>
constexpr bool is_fold(const P& a, const P& b, const P& c) noexcept {
  if (orient2d(a, b, c) != 0) return false;
  return same_place(a, b) || same_place(b, c) || comes_before(a, b) != comes_before(b, c);
}

}  // namespace irg::detail::inline IRG_ABI
