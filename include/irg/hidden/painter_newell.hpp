// SPDX-License-Identifier: MIT
// The painter's algorithm of Newell, Newell and Sancha, complete. Faces are sorted by their farthest vertex and drawn
// from the far end. Before a face P is drawn, every face Q whose depths begin before P's end is asked whether P might
// hide it. Five tests, in order of cost, say no: the extents are apart in x; in y; P lies behind the plane of Q; Q lies
// in front of the plane of P; the projections are apart. Where all fail, Q is drawn first, unless that was done with Q
// already: then faces hide each other in turn, and Q is split.
//
// A part of a face is its face, limits (face_fragment) and a window: splitting makes no coordinate. Of planes equally
// deep the lower number is in front, so that coplanar faces have an order, too. A window whose list is long and
// overlaps in depth is cut into four first, and what a face hides in all of a window is left out there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/hidden/detail/depth_sort.hpp>
#include <irg/hidden/detail/painted_list.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/raster/draw_counts.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Writes the numbers of the faces that are seen in a window's pixels, by drawing faces from far to near in the order
/// of Newell, Newell and Sancha.
/// shape   faces: a container of screen_face; ids holds the window; observer(step, number of P, number of Q) for each
///         test that tells, each reordering and each split
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are. The
///         counts say how often each test told, what was moved, split and drawn
/// exact   as picture_face_at, in every pixel: every test is decided by is_nearer or in integers
/// cost    a sort, the tests of faces that overlap in depth, and each pixel as often as it is drawn; memory for the
///         list, none for depths
/// source  Newell, Newell and Sancha 1972
template <DepthOrder Order = nearer_is_greater, class Faces, class Observer = no_newell_observer>
constexpr newell_counts draw_painter_newell(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                            Observer&& observer = {}) {
  const std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
  detail::newell_painter<Order, std::remove_reference_t<Observer>> painter(ids, observer);
  painter.paint(detail::sorted_by_depth<Order>(list), window);
  return painter.counts();
}

}  // namespace IRG_ABI

/// The painter's algorithm of Newell, Newell and Sancha as a hidden-surface method for render.
/// gives   what draw_painter_newell gives; counts.tested counts the faces and parts drawn
template <DepthOrder Order = nearer_is_greater>
struct painter_newell {
  /// Whether the picture is the exact one.
  [[nodiscard]] IRG_APART static constexpr bool finds_nearest() noexcept { return true; }

  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    counts.tested += draw_painter_newell<Order>(faces, window, ids)[newell_step::drawn];
  }
};

}  // namespace irg
