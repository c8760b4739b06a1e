// SPDX-License-Identifier: MIT
// draw_depth: triangles drawn for their depths alone, as shadows and occlusion want them. The depths are those that
// shade_batches leaves; no colour is touched, and nobody keeps account of which triangle is seen. So where two faces
// are too close to tell by their computed depths, the nearer of these stays, be it the seen one's or not.
#pragma once

#include <span>

#include <irg/render/detail/visible/tile_driver.hpp>

namespace irg {

/// How depths are drawn without colours: what is left out, and whether the target is cleared first.
struct draw_depth_options {
  face_culling culling = face_culling::back;
  skip_options skip{};
  clearing clear = clearing::none;
  draw_workspace* workspace = nullptr;  // the caller's lists, kept from picture to picture; null: lists for this one
  bool operator==(const draw_depth_options&) const = default;
};

namespace detail::inline IRG_ABI {

// Makes nothing of what tiles show.
template <class T>
struct depths_alone final : tile_finish<T> {
  constexpr void clear(const cell_window&) const override {}
  constexpr std::int64_t operator()(const visible_window&, const triangle_finder<T>&) const override { return 0; }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Draws the depths of batches of triangles, and returns what that took; nothing is shaded, and ties are not counted.
/// shape   first_number of the batches counts their triangles through
/// needs   at most 2^31 triangles; `depth` holds depths of the same order, unless cleared first
/// gives   triangles with a corner that is not finite are left out, and those that name a vertex that is not there
/// exact   the nearest of the computed depths, for every executor and with all skips on and off: equal to what
///         shade_batches leaves, or within 8 ulp of it where two faces lie that close
/// cost    one pass over the triangles, then the pixels; allocates what the workspace lacks
template <DepthOrder Order = nearer_is_greater, Floating T = double, RowRaster Depth, Executor E = sequential>
  requires std::same_as<pixel_of<Depth>, float>
constexpr render_counts draw_depth(Depth& depth, const projected_triangles<T>& triangles,
                                   const draw_depth_options& settings = {}, const E& executor = {}) {
  constexpr auto test = std::same_as<Order, drawing_order> ? detail::tile_test::always : detail::tile_test::depth_only;
  draw_workspace own;
  return detail::draw_by_depth<Order, test, T>(depth, detail::job_of(triangles, settings, own),
                                               detail::depths_alone<T>{}, as_executor(executor));
}

}  // namespace IRG_ABI
}  // namespace irg
