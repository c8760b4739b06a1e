// SPDX-License-Identifier: MIT
// shade_visible: ids become colours. Whoever found out which face each pixel shows, it is coloured once, by the same
// shading as everything else.
#pragma once

#include <cstdint>
#include <span>

#include <irg/render/detail/visible/method_tiles.hpp>
#include <irg/render/draw_triangles.hpp>

namespace irg {
namespace detail {

// Finds nothing: the ids are there.
struct ids_as_they_are {
  template <class T>
  IRG_APART constexpr void operator()(const window_faces<T>&, const cell_window&, image<std::uint32_t>&,
                                      draw_counts&) const noexcept {}
};

}  // namespace detail

/// Triangles, and which of them each pixel shows.
template <Floating T>
struct visible_triangles {
  image<std::uint32_t>& ids;
  projected_triangles<T> of;
};

inline namespace IRG_ABI {

/// Colours a picture from the numbers of the triangles that its pixels show, and returns what it did.
/// shape   colour, depth and ids have one size; triangles and make_shader as for shade_batches
/// gives   the depths of what is seen too; pixels whose id is no_index, or names a face that does not cover the pixel,
///         is at the farthest depth there, culled or not there, show the background, or keep what they have where
///         nothing is cleared
/// exact   with the ids of draw_visibility the bytes of shade_batches; the same for every executor
/// cost    the triangles are culled and listed once more; then each pixel once
template <DepthOrder Order = nearer_is_greater, Floating T = double, RowRaster Colour = image_view<rgba8>,
          RowRaster Depth = image_view<float>, class MakeShader, Executor E = sequential>
  requires std::same_as<pixel_of<Depth>, float> && detail::shades_into<MakeShader, T, pixel_of<Colour>>
constexpr render_counts shade_visible(render_target<Colour, Depth> target, const visible_triangles<T>& seen,
                                      const MakeShader& make_shader,
                                      const draw_options<pixel_of<Colour>>& settings = {}, const E& executor = {}) {
  detail::expect_known_order<Order>();
  const detail::ids_as_they_are found{};
  draw_workspace own;
  const detail::tile_job<T> job = detail::job_of(seen.of, settings, own);
  return detail::on_rows_of(target, [&]<class Rows>(Rows& colour, auto& depth) {
    return detail::draw_by_ids<Order, T>(
        as_function<detail::method_signature<T>>(found), seen.ids, depth, job,
        detail::colour_tiles<T, Rows, MakeShader>(colour, make_shader, settings.clear, settings.background),
        as_executor(executor));
  });
}

}  // namespace IRG_ABI
}  // namespace irg
