// SPDX-License-Identifier: MIT
// The picture by rays through a tree: what each pixel's centre shows of the faces whose boxes its ray meets. Where
// ray_casting asks every face, this asks a few; the picture is the same, bit for bit.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/raster/depth.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/raster/window.hpp>
#if IRG_BODIES
#include <optional>
#include <span>

#include <irg/geometry/box.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/spatial/bvh.hpp>
#include <irg/spatial/bvh_hits.hpp>
#endif

namespace irg {

namespace detail::inline IRG_COMPILED_ABI {

// The numbers of the faces that the window's pixels see.
// needs   faces with an area that reach into the window
template <class Order>
IRG_API void trace_faces(const std::vector<screen_face>& list, const cell_window& window, image<std::uint32_t>& ids,
                         draw_counts& counts);

}  // namespace detail::inline IRG_COMPILED_ABI

/// A hidden-surface method: each pixel asks the faces over it.
/// shape   as ray_casting; counts.tested counts the faces that rays meet, counts.ties the equal depths among them
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are
/// exact   as picture_face_at, in every pixel: boxes decide nothing but whom to ask
/// cost    n log n for a window's n faces, and log n and the faces over it for a pixel; memory for the faces and a tree
/// source  Appel 1968
template <DepthOrder Order = nearer_is_greater>
struct ray_tracing {
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    static_assert(IRG_BODIES != 0 || std::same_as<Order, nearer_is_greater> || std::same_as<Order, nearer_is_less> ||
                      std::same_as<Order, drawing_order>,
                  "irg::compiled knows the orders of depth in raster/depth.hpp: for one of your own define "
                  "IRG_HEADER_ONLY before the first header of irg");
    std::vector<screen_face> list;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const screen_face f = faces[i];
      if (f.coverage.double_area != 0 && !intersect(f.coverage.bounds, window).empty()) list.push_back(f);
    }
    detail::trace_faces<Order>(list, window, ids, counts);
  }
};

}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Order>
IRG_API void trace_faces(const std::vector<screen_face>& list, const cell_window& window, image<std::uint32_t>& ids,
                         draw_counts& counts) {
  std::vector<box<double, 3>> boxes;
  for (const screen_face& f : list) {
    const cell_window w = intersect(f.coverage.bounds, window);
    boxes.push_back({{double(w.x_first), double(w.y_first), 0}, {double(w.x_last), double(w.y_last), 0}});
  }
  const bvh tree = build_bvh(std::span<const box<double, 3>>(boxes), {bvh_method::morton});
  for (int y = window.y_first; y < window.y_last; ++y)
    for (int x = window.x_first; x < window.x_last; ++x) {
      const screen_face* nearest = nullptr;
      const auto meet = [&](std::uint32_t i, const ray<double, 3>&) -> std::optional<double> {
        const screen_face& f = list[i];
        if (!covers(f, x, y)) return std::nullopt;
        ++counts.tested;
        if (nearest != nullptr && compare_depths<Order>(f, *nearest, x, y) == 0) ++counts.ties;
        if (nearest == nullptr || is_nearer<Order>(f, *nearest, x, y)) nearest = &f;
        return std::nullopt;
      };
      static_cast<void>(any_hit(tree, ray<double, 3>{{x + 0.5, y + 0.5, -1}, {0, 0, 1}, 1, 1}, meet));
      if (nearest != nullptr) ids(x, y) = nearest->number;
    }
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
