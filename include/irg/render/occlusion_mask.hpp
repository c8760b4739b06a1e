// SPDX-License-Identifier: MIT
// occlusion_mask: what the large things in front hide, so that an application need not bother with what is behind them.
// Draw the occluders, then ask for boxes, rectangles or triangles whether anything of them could be seen. The answer
// "occluded" is certain; "visible" may be wrong.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/geometry/box.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/detail/mask_query.hpp>
#include <irg/render/detail/scratch_portion.hpp>
#include <irg/render/draw_depth.hpp>

namespace irg {

/// What an occlusion mask says of an object. `outside`: it holds no pixel centre of the picture. `occluded`: at each of
/// its pixel centres something is drawn that is as near or nearer.
enum class occlusion { visible, occluded, outside };

/// What drawing occluders did.
struct occluder_counts {
  std::int64_t triangles = 0;
  skip_counts skipped;  // `occluded` is not counted
  std::int64_t drawn = 0;  // triangles that were not skipped

  constexpr bool operator==(const occluder_counts&) const = default;
};

/// How far a question had to be followed up. Added to, so that the counts of many questions come to a sum.
struct occlusion_counts {
  std::int64_t visible = 0, occluded = 0, outside = 0;  // answers
  std::int64_t tiles = 0, blocks = 0, pixels = 0;  // depths that were compared

  constexpr bool operator==(const occlusion_counts&) const = default;
};

/// The depths of occluders over a picture, with the farthest of each 8 x 8 block and each 64 x 64 tile.
/// shape   width x height pixels, each at the farthest depth at first
/// needs   1 <= width, height <= 65536 when anything is drawn
/// exact   depths equal to those of draw_batches; the same answers for every executor, compiler and instruction set
template <DepthOrder Order = nearer_is_greater>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
class occlusion_mask {
public:
  occlusion_mask() = default;
  IRG_INLINE constexpr occlusion_mask(int width, int height)
      : grid_(width, height), pixels_(grid_.across * tile, grid_.down * tile, beyond),
        blocks_(grid_.across * block, grid_.down * block, beyond), tiles_(grid_.across, grid_.down, beyond),
        touched_(grid_.count(), 1) {
    clear();
  }

  IRG_INLINE constexpr int width() const noexcept { return grid_.width; }
  IRG_INLINE constexpr int height() const noexcept { return grid_.height; }

  /// Forgets all occluders.
  /// cost    the pixels of the tiles that were drawn to
  constexpr void clear() noexcept {
    for (std::size_t i = 0; i < grid_.count(); ++i) {
      if (touched_[i] == 0) continue;
      touched_[i] = 0;
      const cell_window w = grid_.window(i);
      detail::clear_window(pixels_, w, Order::farthest);
      detail::clear_window(blocks_, detail::squares_of(w, block), Order::farthest);
      detail::clear_window(tiles_, detail::squares_of(w, tile), Order::farthest);
    }
  }

  /// Draws occluders.
  /// needs   vertices projected with `mapping`, a mapping onto this mask's size
  /// gives   triangles with a corner that is not finite are left out, and those that name a vertex that is not there
  /// cost    that of draw_depth, then the pixels of the tiles that the occluders' boxes touch
  template <Floating T, Executor E = sequential>
  constexpr occluder_counts draw(std::span<const triangle_batch<T>> batches, const screen_mapping<T>& mapping,
                                 face_culling culling = face_culling::back, const E& executor = {}) {
    image_view<float> depths(pixels_.data(), width(), height(), pixels_.bytes_per_row());
    draw_depth<Order, T>(depths, batches, mapping, {culling}, workspace_, executor);
    const detail::triangle_bins& bins = workspace_.bins;
    executor(grid_.count(), [&](std::size_t i) {
      if (!bins.list_of(i).empty()) find_farthest(i);
    });
    return {static_cast<std::int64_t>(bins.triangle_count), bins.skipped, bins.listed};
  }
  /// Draws the triangles of one occluder.
  template <Floating T, Executor E = sequential>
  constexpr occluder_counts draw(const projected_vertices<T>& vertices, std::span<const triangle_indices> triangles,
                                 const screen_mapping<T>& mapping, face_culling culling = face_culling::back,
                                 const E& executor = {}) {
    const triangle_batch<T> batch[1] = {{&vertices, triangles, 0}};
    return draw<T>(std::span<const triangle_batch<T>>(batch), mapping, culling, executor);
  }

  /// Whether a box, and whatever lies in it, could be seen.
  /// gives   visible when the box reaches before the near plane or has a coordinate that is not a number; outside when
  ///         it is empty
  /// exact   conservative for all that is projected with the same matrix in T, its rounding included
  /// cost    eight corners; then the tiles, blocks and pixels of its rectangle as far as they leave it undecided
  template <Floating T>
  IRG_INLINE constexpr occlusion test(const box<T, 3>& bounds, const mat<T, 4, 4>& to_clip,
                                      occlusion_counts* counts = nullptr) const noexcept {
    constexpr float sign = detail::key_sign<Order>;
    const detail::mask_rectangle r = detail::project_box(bounds, to_clip, width(), height(), sign);
    if (r.where == detail::mask_place::outside) return count(occlusion::outside, {}, counts);
    if (r.where == detail::mask_place::before_the_eye) return count(occlusion::visible, {}, counts);
    return test(r.pixels, product(r.key, sign), counts);
  }

  /// Whether something in a rectangle of pixels, nowhere nearer than `nearest`, could be seen.
  IRG_INLINE constexpr occlusion test(const cell_window& pixels, float nearest,
                                      occlusion_counts* counts = nullptr) const noexcept {
    occlusion_counts work;
    const occlusion answer = test_rectangle(pixels, nearest, work);
    return count(answer, work, counts);
  }

  /// Whether triangles could be seen.
  /// needs   vertices projected with a mapping onto this mask's size
  /// gives   triangles that name a vertex that is not there are left out
  /// cost    each triangle as a rectangle first, then as far as it is undecided by its pixels
  template <Floating T>
  constexpr occlusion test(const projected_vertices<T>& vertices, std::span<const triangle_indices> triangles,
                           const screen_mapping<T>& mapping, face_culling culling = face_culling::back,
                           occlusion_counts* counts = nullptr) const {
    occlusion_counts work;
    const triangle_batch<T> batch{&vertices, triangles, 0};
    detail::bin_portion scratch = detail::scratch_portion(grid_);
    occlusion answer = occlusion::outside;
    for (std::uint32_t i = 0; i < triangles.size() && answer != occlusion::visible; ++i)
      detail::list_and_draw(scratch, batch, i, mapping, grid_, culling, [&](const detail::triangle_corners& c) {
        const occlusion one = test_triangle(c, work);
        if (one == occlusion::visible || answer == occlusion::outside) answer = one;
      });
    return count(answer, work, counts);
  }

  /// Whether something could be seen: not occluded, and not outside.
  template <class... Arguments>
  IRG_INLINE constexpr bool is_visible(const Arguments&... arguments) const
    requires requires(const occlusion_mask m) { m.test(arguments...); }
  {
    return test(arguments...) == occlusion::visible;
  }

  /// The mask's depth at a pixel: what draw_batches leaves there.
  /// needs   0 <= x < width(), 0 <= y < height()
  IRG_INLINE constexpr float depth(int x, int y) const noexcept { return pixels_(x, y); }
  /// The farthest depth in the block of 8 x 8 pixels that holds a pixel.
  /// needs   0 <= x < width(), 0 <= y < height()
  IRG_INLINE constexpr float block_depth(int x, int y) const noexcept { return blocks_(x / block, y / block); }

private:
  static constexpr int block = detail::block_size, tile = detail::tile_size;  // a tile has block x block blocks
  // What the pixels beyond the picture hold: they are never the farthest.
  static constexpr float beyond = std::numeric_limits<float>::infinity() * detail::key_sign<Order>;

  // The farthest of 8 x 8 depths from the first one on.
  IRG_INLINE static constexpr float farthest_of(const image<float>& depths, int x_first, int y_first) noexcept {
    float farthest[block];
    for (float& f : farthest) f = beyond;
    for (int y = y_first; y < y_first + block; ++y) {
      const float* row = depths.row(y) + x_first;
      for (int k = 0; k < block; ++k) farthest[k] = Order::nearer(farthest[k], row[k]) ? row[k] : farthest[k];
    }
    for (const float f : farthest) farthest[0] = Order::nearer(farthest[0], f) ? f : farthest[0];
    return farthest[0];
  }
  // Those of a tile and its blocks, once it is drawn.
  constexpr void find_farthest(std::size_t i) noexcept {
    touched_[i] = 1;
    detail::any_square(grid_.window(i), block, [&](const cell_window&, int x, int y) {
      blocks_(x, y) = farthest_of(pixels_, x * block, y * block);
      return false;
    });
    const int x = static_cast<int>(i) % grid_.across, y = static_cast<int>(i) / grid_.across;
    tiles_(x, y) = farthest_of(blocks_, x * block, y * block);
  }

  IRG_INLINE constexpr occlusion test_rectangle(const cell_window& pixels, float nearest,
                                                occlusion_counts& work) const noexcept {
    const cell_window w = intersect(pixels, {0, 0, width(), height()});
    if (w.empty()) return occlusion::outside;
    if (!(nearest == nearest)) return occlusion::visible;
    const auto shows_in = [&](const image<float>& farthest, std::int64_t& compared, int x, int y) {
      ++compared;
      return Order::nearer(nearest, farthest(x, y));
    };
    const bool seen = detail::any_square(w, tile, [&](const cell_window& in_tile, int tx, int ty) {
      return shows_in(tiles_, work.tiles, tx, ty) &&
             detail::any_square(in_tile, block, [&](const cell_window& in_block, int bx, int by) {
               return shows_in(blocks_, work.blocks, bx, by) &&
                      detail::any_square(in_block, 1, [&](const cell_window&, int x, int y) {
                        return shows_in(pixels_, work.pixels, x, y);
                      });
             });
    });
    return seen ? occlusion::visible : occlusion::occluded;
  }
  constexpr occlusion test_triangle(const detail::triangle_corners& c, occlusion_counts& work) const {
    const auto& [v0, v1, v2] = c.v;
    const auto nearer_of = [](float a, float b) { return Order::nearer(a, b) ? a : b; };
    const occlusion rectangle = test_rectangle(detail::centres_within(v0->position, v1->position, v2->position),
                                               nearer_of(nearer_of(v0->depth, v1->depth), v2->depth), work);
    if (rectangle != occlusion::visible) return rectangle;
    bool any = false, seen = false;
    detail::covered_depths(c, {0, 0, width(), height()}, [&](int x, int y, float depth) {
      any = true;
      if (seen) return;
      ++work.pixels;
      seen = Order::nearer(depth, pixels_(x, y));
    });
    return seen ? occlusion::visible : any ? occlusion::occluded : occlusion::outside;
  }
  IRG_INLINE static constexpr occlusion count(occlusion answer, const occlusion_counts& work,
                                              occlusion_counts* counts) noexcept {
    if (counts == nullptr) return answer;
    counts->visible += answer == occlusion::visible;
    counts->occluded += answer == occlusion::occluded;
    counts->outside += answer == occlusion::outside;
    counts->tiles += work.tiles;
    counts->blocks += work.blocks;
    counts->pixels += work.pixels;
    return answer;
  }

  detail::picture_tiles grid_{0, 0};
  image<float> pixels_, blocks_, tiles_;  // depths, and the farthest of each block and tile
  std::vector<std::uint8_t> touched_;  // by tile: whether it may differ from an empty one
  draw_workspace workspace_;
};

}  // namespace irg
