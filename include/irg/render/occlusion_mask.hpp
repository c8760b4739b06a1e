// SPDX-License-Identifier: MIT
// occlusion_mask: what the large things in front hide, so that an application need not bother with what is behind them.
// Draw the occluders, then ask for boxes, rectangles or triangles whether anything of them could be seen. The answer
// "occluded" is certain; "visible" may be wrong.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/geometry/box.hpp>
#include <irg/render/detail/mask_query.hpp>

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

/// Depths of occluders over a picture, with the farthest of each 8 x 8 block and each 64 x 64 tile. Coverage is exact;
/// depths are not nearer than those of draw_batches.
/// shape   width x height pixels, each at the farthest depth at first
/// needs   1 <= width, height <= 65536 when anything is drawn
/// exact   the same answers for every executor, compiler and instruction set
template <DepthOrder Order = nearer_is_greater>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
class occlusion_mask {
public:
  occlusion_mask() = default;
  IRG_INLINE constexpr occlusion_mask(int width, int height) : tiles_(width, height) {
    const std::size_t tiles = tiles_.count();
    cells_.resize(tiles * detail::mask_cells_across * detail::mask_cells_down, detail::mask_cell{});
    far_.resize(tiles * 64, 0.0f);
    tile_far_.resize(tiles, 0.0f);
    stale_.resize(tiles, 0);
    touched_.resize(tiles, 0);
  }

  IRG_INLINE constexpr int width() const noexcept { return tiles_.width; }
  IRG_INLINE constexpr int height() const noexcept { return tiles_.height; }

  /// Forgets all occluders.
  /// cost    one byte for each tile: pixels are cleared when a tile is first drawn to
  IRG_INLINE constexpr void clear() noexcept {
    for (std::uint8_t& t : touched_) t = 0;
  }

  /// Draws occluders.
  /// needs   vertices projected with `mapping`, a mapping onto this mask's size
  /// gives   triangles with a corner that is not finite are left out, and those that name a vertex that is not there
  /// cost    each triangle once; nothing is sorted or listed on one thread
  template <Floating T, Executor E = sequential>
  IRG_INLINE constexpr occluder_counts draw(std::span<const triangle_batch<T>> batches,
                                            const screen_mapping<T>& mapping, face_culling culling = face_culling::back,
                                            const E& executor = {}) {
    const detail::mask_draw_result r = detail::draw_mask<T>(memory(), batches, mapping, culling, bins_, executor);
    occluder_counts counts{0, r.skipped, r.listed};
    for (const triangle_batch<T>& b : batches) counts.triangles += static_cast<std::int64_t>(b.triangles.size());
    return counts;
  }
  /// Draws the triangles of one occluder.
  template <Floating T, Executor E = sequential>
  IRG_INLINE constexpr occluder_counts draw(const projected_vertices<T>& vertices,
                                            std::span<const triangle_indices> triangles,
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
    const detail::mask_rectangle r = detail::project_box(bounds, to_clip, width(), height(), detail::key_sign<Order>);
    if (r.where == detail::mask_place::outside) return count(occlusion::outside, counts);
    if (r.where == detail::mask_place::before_the_eye) return count(occlusion::visible, counts);
    return test_key(r.pixels, r.key, counts);
  }

  /// Whether something in a rectangle of pixels, nowhere nearer than `nearest`, could be seen.
  IRG_INLINE constexpr occlusion test(const cell_window& pixels, float nearest,
                                      occlusion_counts* counts = nullptr) const noexcept {
    return test_key(pixels, nearest * detail::key_sign<Order>, counts);
  }

  /// Whether triangles could be seen.
  /// needs   vertices projected with a mapping onto this mask's size
  /// gives   triangles that name a vertex that is not there are left out
  /// cost    each triangle as a rectangle first, then as far as it is undecided by its pixels
  template <Floating T>
  IRG_INLINE constexpr occlusion test(const projected_vertices<T>& vertices,
                                      std::span<const triangle_indices> triangles, const screen_mapping<T>& mapping,
                                      face_culling culling = face_culling::back,
                                      occlusion_counts* counts = nullptr) const {
    detail::mask_query_counts work;
    const triangle_batch<T> batch{&vertices, triangles, 0};
    const detail::mask_answer a = detail::test_mask_triangles<T>(memory(), batch, mapping, culling, work);
    add(work, counts);
    return count(static_cast<occlusion>(a), counts);
  }

  /// Whether something could be seen: not occluded, and not outside.
  template <class... Arguments>
  IRG_INLINE constexpr bool is_visible(const Arguments&... arguments) const
    requires requires(const occlusion_mask m) { m.test(arguments...); }
  {
    return test(arguments...) == occlusion::visible;
  }

  /// The mask's depth at a pixel: what draw_batches leaves there, or a little farther.
  /// needs   0 <= x < width(), 0 <= y < height()
  IRG_INLINE constexpr float depth(int x, int y) const noexcept {
    const detail::mask_target m = memory();
    const bool touched = m.touched[m.tile_at(x / detail::tile_size, y / detail::tile_size)] != 0;
    return touched ? m.pixel(x, y) * m.sign + 0.0f : Order::farthest;
  }
  /// The farthest depth in the block of 8 x 8 pixels that holds a pixel.
  /// needs   0 <= x < width(), 0 <= y < height()
  IRG_INLINE constexpr float block_depth(int x, int y) const noexcept {
    const detail::mask_target m = memory();
    const bool touched = m.touched[m.tile_at(x / detail::tile_size, y / detail::tile_size)] != 0;
    return touched ? m.block_far(x / detail::block_size, y / detail::block_size) * m.sign + 0.0f : Order::farthest;
  }

private:
  IRG_INLINE constexpr occlusion test_key(const cell_window& pixels, float key,
                                          occlusion_counts* counts) const noexcept {
    detail::mask_query_counts work;
    const detail::mask_answer a = detail::test_mask(memory(), pixels, key, work);
    add(work, counts);
    return count(static_cast<occlusion>(a), counts);
  }
  IRG_INLINE static constexpr occlusion count(occlusion answer, occlusion_counts* counts) noexcept {
    if (counts != nullptr)
      ++(answer == occlusion::visible    ? counts->visible
         : answer == occlusion::occluded ? counts->occluded
                                         : counts->outside);
    return answer;
  }
  IRG_INLINE static constexpr void add(const detail::mask_query_counts& work, occlusion_counts* counts) noexcept {
    if (counts == nullptr) return;
    counts->tiles += work.tiles;
    counts->blocks += work.blocks;
    counts->pixels += work.pixels;
  }
  // Queries take the same view of the memory as drawing, and write nothing.
  IRG_INLINE constexpr detail::mask_target memory() const noexcept {
    constexpr float sign = detail::key_sign<Order>;
    return {tiles_.width,
            tiles_.height,
            tiles_.across,
            tiles_.down,
            sign,
            Order::farthest * sign,
            const_cast<detail::mask_cell*>(cells_.data()),
            const_cast<float*>(far_.data()),
            const_cast<float*>(tile_far_.data()),
            const_cast<std::uint64_t*>(stale_.data()),
            const_cast<std::uint8_t*>(touched_.data())};
  }

  detail::picture_tiles tiles_{0, 0};
  std::vector<detail::mask_cell> cells_;
  std::vector<float> far_, tile_far_;
  std::vector<std::uint64_t> stale_;
  std::vector<std::uint8_t> touched_;
  detail::triangle_bins bins_;  // lists of tiles, for several threads
};

}  // namespace irg
