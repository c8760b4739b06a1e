// SPDX-License-Identifier: MIT
// Ray casting: through the centre of every pixel a ray, and of all faces that it meets the nearest one. It is the
// definition of the picture, carried out; the other methods give the same and do less.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/raster/draw_counts.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/raster/image.hpp>
#include <irg/hidden/detail/ray_casting_steps.hpp>

namespace irg {

/// A hidden-surface method: each pixel asks each face.
/// shape   ray_casting<>{}(faces, window, ids, counts): faces a container of screen_face, ids a raster that holds the
///         window; counts.tested counts the faces that rays meet, counts.ties the equal depths among them
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are
/// exact   as picture_face_at, in every pixel
/// cost    pixels times faces; memory for a copy of the faces, none for depths
/// source  Appel 1968
template <DepthOrder Order = nearer_is_greater>
struct ray_casting {
  /// Whether the picture is the exact one.
  [[nodiscard]] IRG_APART static constexpr bool finds_nearest() noexcept { return true; }

  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    const std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
    for (int y = window.y_first; y < window.y_last; ++y)
      for (int x = window.x_first; x < window.x_last; ++x) {
        const screen_face* nearest = nullptr;
        for (const screen_face& f : list) {
          if (!covers(f, x, y)) continue;
          ++counts.tested;
          if (nearest != nullptr && compare_depths<Order>(f, *nearest, x, y) == 0) ++counts.ties;
          if (nearest == nullptr || is_nearer<Order>(f, *nearest, x, y)) nearest = &f;
        }
        if (nearest != nullptr) ids(x, y) = nearest->number;
      }
  }
};

}  // namespace irg
