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
#include <irg/core/executor.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/bin/bin_triangles.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>
#include <irg/render/detail/shade/tile_shading.hpp>
#include <irg/render/draw_triangles.hpp>
#if IRG_BODIES
#include <algorithm>

#include <irg/raster/depth.hpp>
#endif

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

namespace irg::detail::inline IRG_COMPILED_ABI {

// As bin_triangles; the numbers of all lists, each put in order. With drawing_order they stay as they are.
template <class Order, Floating T>
IRG_API std::vector<std::uint32_t> bin_back_to_front(triangle_bins& bins, std::span<const triangle_batch<T>> batches,
                                                     const listing_rules<T>& rules, const executor_ref& executor);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

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

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The depth of a triangle's centroid: z / w of the sum of its corners in clip space. Not in front of the eye counts as
// nearest of all, and so do triangles that are not drawn because a vertex is not there.
template <class T>
struct centroid_depth {
  T depth = T(0);
  bool behind_eye = false;
  std::uint32_t number = 0;
};

template <class T>
constexpr centroid_depth<T> centroid_depth_of(const triangle_batch<T>& batch, std::uint32_t i) noexcept {
  const auto& [v] = batch.triangles[i];
  const std::uint32_t number = batch.first_number + i;
  if (!has_vertices(batch, i)) return {T(0), true, number};
  const hpoint<T, 3> a = clip_position(*batch.vertices, v[0]), b = clip_position(*batch.vertices, v[1]),
                     c = clip_position(*batch.vertices, v[2]);
  const T z = a.z + (b.z + c.z), w = a.w + (b.w + c.w);
  if (!(T(0) < w)) return {T(0), true, number};
  const T depth = z / w;
  return {depth == depth ? depth : T(0), false, number};
}

// The place of every triangle in the order from the farthest to the nearest; of equal ones the first given first.
template <class Order, class T>
constexpr std::vector<std::uint32_t> back_to_front(std::span<const triangle_batch<T>> batches, std::uint32_t count) {
  std::vector<std::uint32_t> place(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) place[i] = i;
  if constexpr (!std::same_as<Order, drawing_order>) {
    std::vector<centroid_depth<T>> all;
    all.reserve(count);
    for (const triangle_batch<T>& b : batches)
      for (std::uint32_t i = 0; i < b.triangles.size(); ++i) all.push_back(centroid_depth_of(b, i));
    std::sort(all.begin(), all.end(), [](const centroid_depth<T>& a, const centroid_depth<T>& b) {
      if (a.behind_eye != b.behind_eye) return b.behind_eye;
      if (a.depth == b.depth) return a.number < b.number;
      return static_cast<bool>(Order::nearer(b.depth, a.depth));
    });
    for (std::uint32_t i = 0; i < count; ++i) place[all[i].number] = i;
  }
  return place;
}

// The lists of all tiles, each put in the order of places. Two counting sorts: by place, then by tile.
template <class T>
constexpr std::vector<std::uint32_t> sorted_lists(const triangle_bins& bins, const triangle_finder<T>& find,
                                                  const std::vector<std::uint32_t>& place, std::size_t tiles) {
  struct entry {
    std::uint32_t tile = 0, number = 0;
  };
  std::vector<std::uint32_t> start(place.size() + 1, 0), next(bins.tile_first.begin(), bins.tile_first.end());
  for (const std::uint32_t number : bins.numbers) ++start[place[find.source(number)] + 1];
  for (std::size_t i = 0; i < place.size(); ++i) start[i + 1] += start[i];
  std::vector<entry> by_place(bins.numbers.size(), entry{});
  for (std::size_t t = 0; t < tiles; ++t)
    for (std::uint32_t i = bins.tile_first[t]; i < bins.tile_first[t + 1]; ++i)
      by_place[start[place[find.source(bins.numbers[i])]]++] = {static_cast<std::uint32_t>(t), bins.numbers[i]};
  std::vector<std::uint32_t> numbers(bins.numbers.size(), 0);
  for (const entry& e : by_place) numbers[next[e.tile]++] = e.number;
  return numbers;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Order, Floating T>
IRG_API std::vector<std::uint32_t> bin_back_to_front(triangle_bins& bins, std::span<const triangle_batch<T>> batches,
                                                     const listing_rules<T>& rules, const executor_ref& executor) {
  bin_triangles(bins, batches, rules, executor);
  return sorted_lists<T>(bins, {batches, &bins}, back_to_front<Order, T>(batches, bins.triangle_count),
                         rules.grid.count());
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
