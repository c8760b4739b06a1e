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
      : grid_(width, height), pixels_(width, height), farthest_(grid_.count(), detail::farthest_keys{}),
        touched_(grid_.count(), 0) {}

  IRG_INLINE constexpr int width() const noexcept { return grid_.width; }
  IRG_INLINE constexpr int height() const noexcept { return grid_.height; }

  /// Forgets all occluders.
  /// cost    one byte for each tile: pixels are cleared when a tile is first drawn to
  IRG_INLINE constexpr void clear() noexcept {
    for (std::uint8_t& t : touched_) t = 0;
  }

  /// Draws occluders.
  /// needs   vertices projected with `mapping`, a mapping onto this mask's size
  /// gives   triangles with a corner that is not finite are left out, and those that name a vertex that is not there
  /// cost    that of draw_depth, and the farthest depths of the tiles that the occluders' boxes touch
  template <Floating T, Executor E = sequential>
  constexpr occluder_counts draw(std::span<const triangle_batch<T>> batches, const screen_mapping<T>& mapping,
                                 face_culling culling = face_culling::back, const E& executor = {}) {
    auto& [bins, seen] = workspace_;
    detail::bin_triangles(bins, batches, mapping, grid_, culling, skip_options{}, executor);
    seen.assign(bins.triangle_count, 0);
    const detail::triangle_finder<T> find{batches, &bins};
    executor(grid_.count(), [&](std::size_t i) {
      if (bins.list_of(i).empty()) return;
      const detail::no_numbers none{};
      detail::draw_target_tile<Order>(none, pixels_, find, i, grid_.window(i), skip_options{},
                                      touched_[i] == 0 ? clearing::before_drawing : clearing::none, seen.data(),
                                      &farthest_[i]);
      touched_[i] = 1;
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
  IRG_INLINE constexpr float depth(int x, int y) const noexcept {
    return touched_[tile_of(x, y)] != 0 ? pixels_(x, y) : Order::farthest;
  }
  /// The farthest depth in the block of 8 x 8 pixels that holds a pixel.
  /// needs   0 <= x < width(), 0 <= y < height()
  IRG_INLINE constexpr float block_depth(int x, int y) const noexcept {
    const std::size_t i = tile_of(x, y);
    return touched_[i] != 0 ? farthest_[i].block[block_of(x / block, y / block)] * sign + 0.0f : Order::farthest;
  }

private:
  static constexpr int block = detail::block_size, tile = detail::tile_size;
  static constexpr float sign = detail::key_sign<Order>;

  IRG_INLINE constexpr std::size_t tile_of(int x, int y) const noexcept {
    return static_cast<std::size_t>(y / tile * grid_.across + x / tile);
  }
  // Where in its tile the block in a column and row of blocks is.
  IRG_INLINE static constexpr int block_of(int column, int row) noexcept {
    return row % detail::blocks_across * detail::blocks_across + column % detail::blocks_across;
  }
  IRG_INLINE constexpr occlusion test_rectangle(const cell_window& pixels, float nearest,
                                                occlusion_counts& work) const noexcept {
    const cell_window w = intersect(pixels, {0, 0, width(), height()});
    if (w.empty()) return occlusion::outside;
    if (!(nearest == nearest)) return occlusion::visible;
    const float key = product(nearest, sign);
    const bool seen = detail::any_square(w, tile, [&](const cell_window& in_tile, int, int) {
      const std::size_t i = tile_of(in_tile.x_first, in_tile.y_first);
      ++work.tiles;
      if (touched_[i] == 0) return Order::nearer(nearest, Order::farthest);
      if (key <= farthest_[i].tile) return false;
      return detail::any_square(in_tile, block, [&](const cell_window& in_block, int bx, int by) {
        ++work.blocks;
        if (key <= farthest_[i].block[block_of(bx, by)]) return false;
        return detail::any_square(in_block, 1, [&](const cell_window&, int x, int y) {
          ++work.pixels;
          return Order::nearer(nearest, pixels_(x, y));
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
      seen = Order::nearer(depth, this->depth(x, y));
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
  image<float> pixels_;  // of no account in tiles that are not touched, as `farthest_`
  std::vector<detail::farthest_keys> farthest_;  // by tile
  std::vector<std::uint8_t> touched_;  // by tile
  draw_workspace workspace_;
};

}  // namespace irg
