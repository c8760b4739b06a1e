// SPDX-License-Identifier: MIT
// The painter's algorithm in its naive form: faces sorted by the depth of their centroids and drawn from far to near.
// An approximation: faces that overlap in depth may come in the wrong order, and faces that hide each other in turn
// have no right one. painter_newell.hpp has the complete algorithm.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/hidden/ray_casting.hpp>
#include <irg/raster/draw_counts.hpp>
#if IRG_BODIES
#include <irg/core/conversion.hpp>
#include <irg/raster/triangle_coverage.hpp>
#endif

namespace irg {

/// A hidden-surface method that is often wrong: faces are drawn in the order of their centroids' depths, far ones
/// first, of equal depths those with the higher number first; in drawing_order those with the lower number.
/// gives   into each pixel that some face covers the number of the last one drawn there: not always the nearest;
///         counts.tested counts the pixels drawn
/// exact   centroids are sums of three floats in double, rounded twice; what hides what is not decided at all
/// cost    a sort, and each pixel as often as it is covered; memory for a copy of the faces, none for depths
/// source  Fabris 2012, 2.3, for whole objects by their distance: textbook::painter_order
template <DepthOrder Order = nearer_is_greater>
struct painter_by_centroid_rounded {
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const;
};

namespace detail::inline IRG_COMPILED_ABI {

template <DepthOrder Order>
IRG_API void paint_by_centroid(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                               draw_counts& counts);

}  // namespace detail::inline IRG_COMPILED_ABI

template <DepthOrder Order>
template <class Faces>
constexpr void painter_by_centroid_rounded<Order>::operator()(const Faces& faces, const cell_window& window,
                                                              image<std::uint32_t>& ids, draw_counts& counts) const {
  std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
  detail::paint_by_centroid<Order>(ids, list, window, counts);
}

}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <DepthOrder Order>
IRG_API void paint_by_centroid(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                               draw_counts& counts) {
  leave_out_repeated<Order>(list);
  const auto depth = [](const screen_face& f) {
    return static_cast<float>((widened(f.v[0].depth) + widened(f.v[1].depth)) + widened(f.v[2].depth));
  };
  std::sort(list.begin(), list.end(), [&](const screen_face& a, const screen_face& b) {
    if (depth_sense<Order> == 0) return a.number < b.number;
    const float da = depth(a), db = depth(b);
    return da != db ? Order::nearer(db, da) : b.number < a.number;
  });
  for (const screen_face& f : list)
    covered_spans(f.coverage, window, [&](const span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x, ++counts.tested) ids(x, s.y) = f.number;
    });
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
