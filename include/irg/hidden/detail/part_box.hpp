// SPDX-License-Identifier: MIT
// The pixels that a part of a face may have, as a window.
#pragma once

#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/face_fragment.hpp>
#include <irg/raster/window_coverage.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The box without the halves at its four sides, and their halves in turn, that hold no pixel of the part, as far as its
// last limit tells.
template <DepthOrder Order>
constexpr cell_window trimmed_box(const face_fragment& part, cell_window box) noexcept {
  const face_limit& limit = part.limits.back();
  const window_order out = limit.part == face_part::nearer ? window_order::farther : window_order::nearer;
  for (int side = 0; side < 4; ++side)
    for (;;) {
      const int low = side < 2 ? box.x_first : box.y_first, high = side < 2 ? box.x_last : box.y_last;
      if (high - low < 2) break;
      cell_window cut = box, rest = box;
      const int middle = low + (high - low) / 2;
      (side == 0 ? cut.x_last : side == 1 ? cut.x_first : side == 2 ? cut.y_last : cut.y_first) = middle;
      (side == 0 ? rest.x_first : side == 1 ? rest.x_last : side == 2 ? rest.y_first : rest.y_last) = middle;
      if (classify(part.face->coverage, cut) != containment::outside &&
          order_in_window<Order>(*part.face, *limit.plane, cut) != out)
        break;
      box = rest;
    }
  return box;
}

// Whether a part surely has no pixel: small windows are searched.
template <DepthOrder Order>
constexpr bool has_no_pixel(const face_fragment& part, const cell_window& box) noexcept {
  constexpr std::int64_t searched = 64;
  if (box.empty()) return true;
  if (std::int64_t{box.x_last - box.x_first} * (box.y_last - box.y_first) > searched) return false;
  for (int y = box.y_first; y < box.y_last; ++y)
    for (int x = box.x_first; x < box.x_last; ++x)
      if (covers<Order>(part, x, y)) return false;
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
