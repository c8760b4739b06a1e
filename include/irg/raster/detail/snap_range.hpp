// SPDX-License-Identifier: MIT
// Whether positions lie in the range that snapped coordinates may have.
#pragma once

#include <irg/core/sinks.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

IRG_INLINE constexpr bool within_snap_limit(const subpixel& p) noexcept {
  constexpr std::int32_t limit = snap_limit * one_pixel;
  return p.x >= -limit && p.x <= limit && p.y >= -limit && p.y <= limit;
}

// Whether the cell's centre does.
IRG_INLINE constexpr bool within_snap_limit(const cell& c) noexcept {
  return c.x >= -snap_limit && c.x < snap_limit && c.y >= -snap_limit && c.y < snap_limit;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
