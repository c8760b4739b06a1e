// SPDX-License-Identifier: MIT
// Transparent faces: after the opaque ones are drawn, triangles that let light through are sorted from the farthest to
// the nearest, tested against the opaque depths without leaving theirs, and blended over the colours one by one.
//
// The order is one of whole triangles, by the depth of their centroids. It is the true order wherever a plane parallel
// to the picture separates two triangles; where they pass through each other no order is right, and where a large one
// reaches both before and behind a small one this one may be wrong. Cut such triangles into smaller ones.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/colour/over.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/render/detail/bin/back_to_front.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>
#include <irg/render/detail/shade/tile_shading.hpp>
#include <irg/render/draw_triangles.hpp>

namespace irg {

/// How transparent faces are drawn. Both sides of glass are seen, so backs are drawn too unless told otherwise.
template <class Blend = over_in_light>
struct transparent_options {
  face_culling culling = face_culling::none;
  skip_options skip{};
  Blend blend{};  // blend(pixel below, what a pixel shader gives) -> pixel
  bool operator==(const transparent_options&) const
    requires std::equality_comparable<Blend>
  = default;
};

inline namespace IRG_ABI {

/// Draws transparent triangles into a picture whose opaque part, with its depths, is finished; returns what it did.
/// shape   as shade_batches. What a pixel shader gives is handed to blend(pixel below, it) -> pixel; the default takes
///         rgba8 whose `a` is the opacity, the colour not multiplied by it, and mixes light. An AttributeShading with
///         opacity among its attributes gives every vertex an opacity of its own
/// needs   `depth` of the same order and size, no part of it NaN where something is to be seen
/// gives   from the farthest to the nearest, by the depth z/w of the triangles' centroids in clip space, each over what
///         was there; of equal ones the first given first; those whose centroid is not in front of the eye last. With
///         drawing_order, in the order given. Test says which depths are seen: by default those nearer than the opaque
///         ones, so that a face on a wall is hidden by the wall. `depth` stays as it is. Triangles with a corner that
///         is not finite are left out, and those that name a vertex that is not there. Where pieces of a clipped
///         triangle lie on each other (raster/screen_pieces.hpp), it is blended twice
/// exact   the same bytes for every executor, all skips on and off; depths by shade_triangle's arithmetic; centroids
///         rounded in T
/// cost    one pass over the triangles, n log n to sort them once, then their pixels; allocates
/// source  Newell, Newell and Sancha 1972 for the order, Porter and Duff 1984 for "over"
template <DepthOrder Order = nearer_is_greater, depth_test Test = depth_test::nearer, Floating T = double,
          RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>, class MakeShader,
          class Blend = over_in_light, Executor E = sequential>
  requires std::same_as<pixel_of<Depth>, float> && detail::blends_into<Blend, MakeShader, T, pixel_of<Colour>>
constexpr render_counts draw_transparent(render_target<Colour, Depth> target, const projected_triangles<T>& triangles,
                                         const MakeShader& make_shader, const transparent_options<Blend>& settings = {},
                                         const E& executor = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_ABI {

// What transparent triangles need beside shade_triangle: blending, and the depths behind which nothing of them is seen.

// Blends what a shader gives over the pixels that are there.
template <class Shader, class Blend>
struct blend_over {
  const Shader& shader;
  const Blend& blend;
  const piece_weights* piece;

  template <class F, class P>
  IRG_INLINE constexpr void operator()(P* row, unsigned bits, pixel_weights<F> at) const {
    if (piece != nullptr) at = in_source(at, *piece);
    for (; bits != 0; bits &= bits - 1) {
      const int i = std::countr_zero(bits);
      row[i] = blend(row[i], shader(pixel_weights<float>{lane(at.weight1, i), lane(at.weight2, i), lane(at.depth, i)}));
    }
  }
};

// The farthest depths of a tile, block by block, each found when it is first asked for.
template <class Order, class Depth>
struct farthest_depths {
  static constexpr int block = 8, across = 8;
  Depth& depth;
  cell_window window;  // at most 64 x 64 pixels
  std::uint64_t known = 0;
  float farthest[across * across]{};

  // The farthest depth that is a number. (Where there is none, nothing passes, whatever comes out here.)
  constexpr float of_block(int bx, int by) {
    const int i = by * across + bx;
    if ((known >> i & 1) != 0) return farthest[i];
    known |= std::uint64_t{1} << i;
    const int x_first = window.x_first + bx * block, y_first = window.y_first + by * block;
    const int x_last = minimum(x_first + block, window.x_last), y_last = minimum(y_first + block, window.y_last);
    bool any = false;
    float hidden_at = 0;
    for (int y = y_first; y < y_last; ++y) {
      const float* row = raster_traits<Depth>::row(depth, y);
      for (int x = x_first; x < x_last; ++x) {
        if (row[x] != row[x] || (any && !Order::nearer(hidden_at, row[x]))) continue;
        hidden_at = row[x];
        any = true;
      }
    }
    return farthest[i] = hidden_at;
  }

  // Whether no pixel of a triangle in w, none of them nearer than `nearest`, passes.
  template <depth_test Test>
  constexpr bool hides(float nearest, const cell_window& w) {
    for (int by = (w.y_first - window.y_first) / block; window.y_first + by * block < w.y_last; ++by)
      for (int bx = (w.x_first - window.x_first) / block; window.x_first + bx * block < w.x_last; ++bx)
        if (passes<Test, Order>(nearest, of_block(bx, by))) return false;
    return true;
  }
};

// How lists of triangles are blended; seen[i] is set for each source triangle i that was not passed over.
template <class T, class Colour, class Depth, class MakeShader, class Blend>
struct blended_tiles {
  Colour& colour;
  Depth& depth;
  const triangle_finder<T>& find;
  const MakeShader& make_shader;
  const Blend& blend;
  skipping occluded;
  std::vector<std::uint8_t>& seen;
};

// A tile's list, blended in its order.
template <depth_test Test, class Order, class Tiles>
constexpr draw_counts blend_tile(const Tiles& tiles, std::span<const std::uint32_t> numbers,
                                 const cell_window& window) {
  const auto& [colour, depth, find, make_shader, blend, occluded, seen] = tiles;
  using depth_raster = std::remove_reference_t<decltype(tiles.depth)>;
  constexpr bool by_depth = !std::same_as<Order, drawing_order>;
  constexpr bool can_hide = by_depth && (Test == depth_test::nearer || Test == depth_test::nearer_or_equal);
  farthest_depths<Order, depth_raster> hidden_depths{depth, window};
  draw_counts counts;
  for (const std::uint32_t number : numbers) {
    const triangle_corners c = find.corners(number);
    const covered_triangle t = cover_and_set_up(*c.v[0], *c.v[1], *c.v[2]);
    const cell_window w = intersect(t.coverage.bounds, window);
    if (t.coverage.double_area == 0 || w.empty()) continue;
    if constexpr (can_hide) {
      const float nearest =
          Order::nearer(t.setup.depth.low, t.setup.depth.high) ? t.setup.depth.low : t.setup.depth.high;
      if (occluded == skipping::on && hidden_depths.template hides<Test>(nearest, w)) continue;
    }
    store_relaxed(seen[find.source(number)], 1);
    const auto shader = shader_for(make_shader, find, number, t.coverage.flipped ? facing::front : facing::back);
    counts += paint_triangle<Order, depth_policy<Test, depth_write::off>>(
        colour, depth, t,
        blend_over<decltype(shader), std::remove_cvref_t<decltype(blend)>>{shader, blend,
                                                                           piece_weights_of(find, number)},
        window);
  }
  return counts;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <DepthOrder Order, depth_test Test, Floating T, RowRaster Colour, RowRaster Depth, class MakeShader,
          class Blend, Executor E>
  requires std::same_as<pixel_of<Depth>, float> && detail::blends_into<Blend, MakeShader, T, pixel_of<Colour>>
constexpr render_counts draw_transparent(render_target<Colour, Depth> target, const projected_triangles<T>& triangles,
                                         const MakeShader& make_shader, const transparent_options<Blend>& settings,
                                         const E& executor) {
  const detail::picture_tiles grid(width_of(target.colour), height_of(target.colour));
  const std::span<const triangle_batch<T>> batches = triangles.batches();
  detail::expect_known_order<Order>();
  detail::triangle_bins bins;
  const std::vector<std::uint32_t> numbers = detail::bin_back_to_front<Order, T>(
      bins, batches, {triangles.mapping(), grid, settings.culling, settings.skip}, as_executor(executor));
  const detail::triangle_finder<T> find{batches, &bins};
  std::vector<std::uint8_t> seen(bins.triangle_count, 0);
  const detail::blended_tiles<T, Colour, Depth, MakeShader, Blend> tiles{
      target.colour, target.depth, find, make_shader, settings.blend, settings.skip.occluded, seen};
  std::vector<draw_counts> done(grid.count(), draw_counts{});
  executor(grid.count(), [&](std::size_t i) {
    const std::span<const std::uint32_t> list(numbers.data() + bins.tile_first[i],
                                              bins.tile_first[i + 1] - bins.tile_first[i]);
    done[i] = detail::blend_tile<Test, Order>(tiles, list, grid.window(i));
  });
  render_counts stats;
  for (const draw_counts& c : done) stats.pixels += c;
  detail::add_skips(stats, bins, seen, settings.skip);
  return stats;
}

}  // namespace irg::inline IRG_ABI
