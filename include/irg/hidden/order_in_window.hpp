// SPDX-License-Identifier: MIT
// How two faces lie behind each other over a whole window of pixels: the question that painter, Warnock and BSP ask,
// and the only one, besides is_nearer at a single pixel, by which they decide. Depth is linear on the screen, so that
// four pixels tell of all between them.
#pragma once

#include <irg/raster/face_order.hpp>

namespace irg {

/// A face against the plane of another over a window: in front of it everywhere, nowhere, or somewhere.
enum class window_order { nearer, farther, crossing };

inline namespace IRG_ABI {

/// Whether face a is_nearer than face b at every pixel of a window, at none, or perhaps at some. Both are taken as
/// their whole planes.
/// needs   a window that is not empty, within snap_limit; faces with an area
/// gives   nearer or farther exactly if all centres of the window say so, `crossing` else
/// exact   by is_nearer at the corners: where the difference of two planes has one sign there, it has it in between,
///         and where it is 0 the lower number is the nearer one, as at a pixel
/// cost    two to four is_nearer
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] constexpr window_order order_in_window(const screen_face& a, const screen_face& b,
                                                     const cell_window& w) noexcept {
  const int x[] = {w.x_first, w.x_last - 1}, y[] = {w.y_first, w.y_last - 1};
  const bool first = is_nearer<Order>(a, b, x[0], y[0]);
  for (const int corner : {3, 1, 2})
    if (is_nearer<Order>(a, b, x[corner % 2], y[corner / 2]) != first) return window_order::crossing;
  return first ? window_order::nearer : window_order::farther;
}

}  // namespace IRG_ABI
}  // namespace irg
