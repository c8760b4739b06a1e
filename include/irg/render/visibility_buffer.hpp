// SPDX-License-Identifier: MIT
// The visibility buffer: in each pixel the number of the triangle that is seen there, and its depth. Whatever else a
// pixel should show can be worked out later, once, from the number and the weights of the triangle's vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <irg/core/executor.hpp>
#include <irg/raster/pixel_weights.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>
#include <irg/render/detail/visible/clear_window.hpp>
#include <irg/render/detail/visible/tile_driver.hpp>
#include <irg/render/draw_depth.hpp>
#if IRG_BODIES
#include <irg/raster/face_order.hpp>
#include <irg/render/detail/bin/scratch_portion.hpp>
#include <irg/render/detail/shade/tile_shading.hpp>
#endif

namespace irg {

inline namespace IRG_ABI {

/// Draws the numbers of visible triangles (first_number of their batch, and their place in it) and their depths.
/// shape   drawn into {ids, depth}; first_number of the batches counts their triangles through
/// needs   at most 2^31 triangles; `depth` holds depths of the same order, unless cleared first
/// gives   no_index where nothing is seen, if cleared first, else what was there; of equally near triangles the
///         first; triangles with a corner that is not finite are left out, and those that name a vertex that is not
///         there
/// exact   the depths and triangles of shade_batches, the same bytes for every executor and all skips on and off
/// cost    one pass over the triangles, then the pixels; allocates what the workspace lacks
/// source  Burns and Hunt 2013
template <DepthOrder Order = nearer_is_greater, Floating T = double, RowRaster Ids = image_view<std::uint32_t>,
          RowRaster Depth = image_view<float>, Executor E = sequential>
  requires std::same_as<pixel_of<Ids>, std::uint32_t> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts draw_visibility(render_target<Ids, Depth> target, const projected_triangles<T>& triangles,
                                        const draw_depth_options& settings = {}, const E& executor = {});

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Stores the source triangles of what tiles show; where nothing was drawn, the raster keeps what it has.
template <class T, class Ids>
struct number_tiles final : tile_finish<T> {
  Ids& ids;
  clearing clear_first;

  constexpr number_tiles(Ids& to, clearing first) noexcept : ids(to), clear_first(first) {}
  constexpr void clear(const cell_window& w) const override { clear_window(ids, w, no_index); }
  constexpr std::int64_t operator()(const visible_window& v, const triangle_finder<T>& find) const override {
    if (clear_first == clearing::before_drawing) clear(v.window);
    std::int64_t shown = 0;
    for (int y = v.window.y_first; y < v.window.y_last; ++y) {
      std::uint32_t* row = raster_traits<Ids>::row(ids, y);
      const std::uint32_t* place = v.place + (y - v.window.y_first) * tile_stride;
      for (int x = v.window.x_first; x < v.window.x_last; ++x, ++place) {
        if (*place == no_index) continue;
        row[x] = find.source(v.numbers[*place]);
        ++shown;
      }
    }
    return shown;
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <DepthOrder Order, Floating T, RowRaster Ids, RowRaster Depth, Executor E>
  requires std::same_as<pixel_of<Ids>, std::uint32_t> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts draw_visibility(render_target<Ids, Depth> target, const projected_triangles<T>& triangles,
                                        const draw_depth_options& settings, const E& executor) {
  draw_workspace own;
  const detail::tile_job<T> job = detail::job_of(triangles, settings, own);
  return detail::on_rows(target.colour, [&]<class Rows>(Rows& ids) {
    return detail::draw_by_depth<Order, detail::test_of<Order>, T>(
        target.depth, job, detail::number_tiles<T, Rows>(ids, settings.clear), as_executor(executor));
  });
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <class Order, Floating T>
IRG_API std::optional<pixel_weights<float>> weights_in_batch(const triangle_batch<T>& batch,
                                                             const screen_mapping<T>& mapping, std::uint32_t number,
                                                             const cell& at);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The weights, corrected for perspective, and the depth of a batch's triangle at the centre of a pixel.
/// shape   the weights are of the second and third vertex of the whole triangle, also where it was clipped
/// needs   vertices projected with the same mapping; 0 <= x, y within the picture
/// gives   nothing where the triangle has not this number in the batch, names a vertex that is not there, or does not
///         cover the pixel
/// exact   the bits that shade_batches gives to pixel shaders
/// cost    one triangle set up; clipped ones are clipped again, which allocates
template <DepthOrder Order = nearer_is_greater, Floating T>
[[nodiscard]] constexpr std::optional<pixel_weights<float>> barycentrics_at(const triangle_batch<T>& batch,
                                                                            const screen_mapping<T>& mapping,
                                                                            std::uint32_t number, int x, int y) {
  detail::expect_known_order<Order>();
  return detail::weights_in_batch<Order>(batch, mapping, number, cell{x, y});
}

/// The same for the triangle of this number among several batches.
template <DepthOrder Order = nearer_is_greater, Floating T>
[[nodiscard]] constexpr std::optional<pixel_weights<float>> barycentrics_at(
    std::type_identity_t<std::span<const triangle_batch<T>>> batches, const screen_mapping<T>& mapping,
    std::uint32_t number, int x, int y) {
  if (batches.empty()) return std::nullopt;
  return barycentrics_at<Order>(detail::triangle_finder<T>{batches, nullptr}.batch_of(number), mapping, number, x, y);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The weights of three vertices on the screen at a pixel.
constexpr std::optional<pixel_weights<float>> weights_of_pixel(const triangle_corners& c, int x, int y) noexcept {
  const covered_triangle t = cover_and_set_up(*c.v[0], *c.v[1], *c.v[2]);
  if (!covers(t.coverage, x, y)) return std::nullopt;
  return weights_at(t.setup, x, y);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Order, Floating T>
IRG_API std::optional<pixel_weights<float>> weights_in_batch(const triangle_batch<T>& batch,
                                                             const screen_mapping<T>& mapping, std::uint32_t number,
                                                             const cell& at) {
  const std::uint32_t i = number - batch.first_number;
  if (number < batch.first_number || i >= batch.triangles.size()) return std::nullopt;
  if (!has_vertices(batch, i)) return std::nullopt;
  const auto [a, b, c] = batch.triangles[i].v;
  const std::vector<clip_code_pair>& codes = batch.vertices->codes;
  if ((codes[a] | codes[b] | codes[c]).cut == 0) return weights_of_pixel(corners_of(batch, i), at.x, at.y);
  const picture_tiles grid(static_cast<int>(mapping.half_width * T(2)), static_cast<int>(mapping.half_height * T(2)));
  bin_portion portion = scratch_portion(grid);
  list_alone(portion, batch, i, {mapping, grid, face_culling::none});
  std::optional<pixel_weights<float>> nearest;
  screen_face first;
  for (const clipped_piece& p : portion.pieces) {
    const auto here = weights_of_pixel(corners_of(p.v), at.x, at.y);
    if (!here) continue;
    const screen_face face = make_screen_face(p.v[0], p.v[1], p.v[2], number);
    if (nearest && compare_depths<Order>(face, first, at.x, at.y) <= 0) continue;
    nearest = in_source(*here, p.weights);
    first = face;
  }
  return nearest;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
