// SPDX-License-Identifier: MIT
// How a window of pixels lies with regard to a triangle: one test for tiles, masks and area subdivision.
#pragma once

#include <cstdint>

#include <irg/core/vocabulary.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg::inline IRG_ABI {

/// Whether the triangle covers all pixels of a window, none, or possibly some.
/// shape   any window of ints, that of the whole range included
/// gives   inside exactly if every pixel of the window is covered; outside if the rectangle of the window's pixel
///         centres and the triangle do not meet, so surely none is; crossing for the rest, which may still cover no
///         centre: a sliver may pass between them. An empty window, and any window of a triangle without area: outside
/// exact   decided in integers; neither outside nor inside is missed in the sense above
/// cost    some 30 integer operations; windows outside of the bounds four comparisons
/// source  Pineda 1988; the separating axis theorem
[[nodiscard]] constexpr containment classify(const triangle_coverage& t, const cell_window& w) noexcept {
  // Edge functions are linear, so that the least and the greatest value in a window are those of two of its corners.
  // Two convex shapes that do not meet are parted along a side of one of them: of the rectangle (the bounds) or of the
  // triangle (an edge function that is negative in all corners).
  //
  // No overflow: positions lie within 2^29, so |right|, |down| <= 2^30 and |at_origin| <= 2^52 + 1, which the value of
  // an edge function at any pixel of 32 bits, at most 2 * 2^61 + 2^52 + 1, leaves below 2^63.
  if (w.empty() || t.double_area == 0 || intersect(t.bounds, w).empty()) return containment::outside;
  bool inside = true;
  for (const triangle_edge& e : t.edge) {
    const int left = w.x_first, right = w.x_last - 1, top = w.y_first, bottom = w.y_last - 1;
    const bool grows_right = e.right > 0, grows_down = e.down > 0;
    if (e(grows_right ? right : left, grows_down ? bottom : top) < 0) return containment::outside;
    inside = inside && e(grows_right ? left : right, grows_down ? top : bottom) >= 0;
  }
  return inside ? containment::inside : containment::crossing;
}

}  // namespace irg::inline IRG_ABI
