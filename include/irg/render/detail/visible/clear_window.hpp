// SPDX-License-Identifier: MIT
// A window of a raster cleared: where a tile shows nothing.
#pragma once

#include <irg/raster/fill_span.hpp>

namespace irg::detail::inline IRG_ABI {

template <class R>
IRG_INLINE constexpr void clear_window(R& raster, const cell_window& w, const pixel_of<R>& value) {
  for (int y = w.y_first; y < w.y_last; ++y) fill_span(raster, {y, w.x_first, w.x_last}, value);
}

}  // namespace irg::detail::inline IRG_ABI
