// SPDX-License-Identifier: MIT
// cell_window: the rectangle of pixels that drawing may touch.
#pragma once

#include <irg/core/raster_concept.hpp>

namespace irg {

/// The pixels with x_first <= x < x_last and y_first <= y < y_last; none when either range is empty.
struct cell_window {
  int x_first = 0, y_first = 0, x_last = 0, y_last = 0;

  IRG_INLINE constexpr bool empty() const noexcept { return x_first >= x_last || y_first >= y_last; }
  constexpr bool operator==(const cell_window&) const = default;
};

inline namespace IRG_ABI {

/// All pixels of a raster.
template <ReadableRaster R>
IRG_INLINE constexpr cell_window window_of(const R& r) {
  return {0, 0, width_of(r), height_of(r)};
}

/// The pixels that both windows hold.
IRG_INLINE constexpr cell_window intersect(const cell_window& a, const cell_window& b) noexcept {
  return {greater(a.x_first, b.x_first), greater(a.y_first, b.y_first), lesser(a.x_last, b.x_last),
          lesser(a.y_last, b.y_last)};
}

}  // namespace IRG_ABI
}  // namespace irg
