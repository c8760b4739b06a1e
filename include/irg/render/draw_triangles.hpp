// SPDX-License-Identifier: MIT
// The triangle stage: cull, clip, sort into tiles, and draw each tile: first which triangle each pixel shows, then the
// colour of what is visible. Tiles are independent of each other, so an executor may draw them in any order on any
// thread, and small enough to stay in the cache while they are drawn.
#pragma once

#include <cstdint>
#include <span>

#include <irg/render/detail/shade/attribute_kernel.hpp>
#include <irg/render/detail/visible/clear_window.hpp>
#include <irg/render/detail/visible/tile_driver.hpp>

namespace irg {

/// How drawing is set up: what is left out, and what the picture is cleared to first, if it is.
template <class P>
struct draw_options {
  face_culling culling = face_culling::back;
  skip_options skip{};
  clearing clear = clearing::none;
  P background{};
  depth_result depth = depth_result::kept;
  draw_workspace* workspace = nullptr;  // the caller's lists, kept from picture to picture; null: lists for this one
  bool operator==(const draw_options&) const = default;
};

inline namespace IRG_ABI {

/// Draws batches of triangles into a picture and its depth buffer, and returns what it did.
/// shape   make_shader(batch, triangle, facing) gives the pixel shader of a
///         triangle of a batch, or is an AttributeShading; first_number of the batches counts their triangles through
/// needs   at most 2^31 triangles; `depth` holds depths of the same order, unless they are cleared first; shaders
///         without memory: each visible pixel is shaded once, in no stated order
/// gives   of equally near triangles the first one; triangles with a corner that is not finite are left out, and those
///         that name a vertex that is not there
/// exact   the same bytes for every executor and for all skips on and off
/// cost    one pass over the triangles, then the pixels; allocates what the workspace lacks
template <DepthOrder Order = nearer_is_greater, Floating T = double, RowRaster Colour = image_view<rgba8>,
          RowRaster Depth = image_view<float>, class MakeShader, Executor E = sequential>
  requires std::same_as<pixel_of<Depth>, float> && detail::shades_into<MakeShader, T, pixel_of<Colour>>
constexpr render_counts shade_batches(render_target<Colour, Depth> target, const projected_triangles<T>& triangles,
                                      const MakeShader& make_shader,
                                      const draw_options<pixel_of<Colour>>& settings = {}, const E& executor = {});

/// Draws the triangles of one object; make_shader(triangle, facing) gives their pixel shaders.
template <DepthOrder Order = nearer_is_greater, Floating T = double, RowRaster Colour = image_view<rgba8>,
          RowRaster Depth = image_view<float>, class MakeShader, Executor E = sequential>
  requires std::same_as<pixel_of<Depth>, float> && requires(const MakeShader& make_shader) {
    { make_shader(std::uint32_t{}, facing::front) } -> PixelShader<pixel_of<Colour>>;
  }
constexpr render_counts shade_triangles(render_target<Colour, Depth> target, const projected_triangles<T>& triangles,
                                        const MakeShader& make_shader,
                                        const draw_options<pixel_of<Colour>>& settings = {}, const E& executor = {}) {
  return shade_batches<Order>(
      target, triangles, [&](const triangle_batch<T>&, std::uint32_t i, facing side) { return make_shader(i, side); },
      settings, executor);
}

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_ABI {

// Colours what tiles show.
template <class T, class Colour, class MakeShader>
class colour_tiles final : public tile_finish<T> {
public:
  constexpr colour_tiles(Colour& colour, const MakeShader& make_shader, clearing clear,
                         const pixel_of<Colour>& background) noexcept
      : colour_(colour), make_shader_(make_shader),
        background_(clear == clearing::before_drawing ? &background : nullptr) {}

  constexpr void clear(const cell_window& w) const override { clear_window(colour_, w, *background_); }

  constexpr std::int64_t operator()(const visible_window& v, const triangle_finder<T>& find) const override {
    if (!std::is_constant_evaluated()) {
      if constexpr (AttributeShading<MakeShader, triangle_batch<T>> && !is_dear<MakeShader>) {
        attribute_pass<T, MakeShader, Colour> pass{
            v.place, {find, v.numbers, v.window, make_shader_}, colour_, background_};
        return shade_by_attributes(pass);
      }
      if (background_ != nullptr) clear(v.window);
      return shade_by_triangle<T, MakeShader>{v, find, make_shader_}.template in_lanes<pack<float, tile_lanes>>(
          colour_);
    }
    if (background_ != nullptr) clear(v.window);
    return shade_by_triangle<T, MakeShader>{v, find, make_shader_}.template in_lanes<float>(colour_);
  }

private:
  Colour& colour_;
  const MakeShader& make_shader_;
  const pixel_of<Colour>* background_;  // for pixels without a triangle; null when they keep what is there
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <DepthOrder Order, Floating T, RowRaster Colour, RowRaster Depth, class MakeShader, Executor E>
  requires std::same_as<pixel_of<Depth>, float> && detail::shades_into<MakeShader, T, pixel_of<Colour>>
constexpr render_counts shade_batches(render_target<Colour, Depth> target, const projected_triangles<T>& triangles,
                                      const MakeShader& make_shader, const draw_options<pixel_of<Colour>>& settings,
                                      const E& executor) {
  draw_workspace own;
  const detail::tile_job<T> job = detail::job_of(triangles, settings, own);
  return detail::on_rows(target.colour, [&]<class Rows>(Rows& colour) {
    return detail::draw_by_depth<Order, detail::test_of<Order>, T>(
        target.depth, job,
        detail::colour_tiles<T, Rows, MakeShader>(colour, make_shader, settings.clear, settings.background),
        as_executor(executor));
  });
}

// The old names, spelled out for calls with braces.
template <DepthOrder Order = nearer_is_greater, Floating T = double, RowRaster Colour = image_view<rgba8>,
          RowRaster Depth = image_view<float>, class MakeShader, Executor E = sequential>
[[deprecated("irg: now shade_batches")]] constexpr render_counts draw_batches(
    render_target<Colour, Depth> target, const projected_triangles<T>& triangles, const MakeShader& make_shader,
    const draw_options<pixel_of<Colour>>& settings = {}, const E& executor = {}) {
  return shade_batches<Order, T, Colour, Depth>(target, triangles, make_shader, settings, executor);
}
template <DepthOrder Order = nearer_is_greater, Floating T = double, RowRaster Colour = image_view<rgba8>,
          RowRaster Depth = image_view<float>, class MakeShader, Executor E = sequential>
[[deprecated("irg: now shade_triangles")]] constexpr render_counts draw_triangles(
    render_target<Colour, Depth> target, const projected_triangles<T>& triangles, const MakeShader& make_shader,
    const draw_options<pixel_of<Colour>>& settings = {}, const E& executor = {}) {
  return shade_triangles<Order, T, Colour, Depth>(target, triangles, make_shader, settings, executor);
}

}  // namespace irg::inline IRG_ABI
