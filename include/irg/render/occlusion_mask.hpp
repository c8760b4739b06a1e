// SPDX-License-Identifier: MIT
// occlusion_mask: what the large things in front hide, so that an application need not bother with what is behind them.
// Draw the occluders, then ask for boxes, rectangles or triangles whether anything of them could be seen. The answer
// "occluded" is certain; "visible" may be wrong.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/core/sinks.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/geometry/box.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/depth.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/bin/drawing_lists.hpp>
#include <irg/render/detail/visible/tile_test.hpp>
#if IRG_BODIES
#include <limits>

#include <irg/render/detail/bin/scratch_portion.hpp>
#include <irg/render/detail/occlude/mask_query.hpp>
#include <irg/render/detail/visible/tile_driver.hpp>
#endif

namespace irg {

/// What an occlusion mask says of an object. `outside`: it holds no pixel centre of the picture. `occluded`: at each of
/// its pixel centres something is drawn that is as near or nearer.
enum class occlusion { visible, occluded, outside };

/// What drawing occluders did.
struct occluder_counts {
  std::int64_t triangles = 0;
  skip_counts skipped;  // `occluded` is not counted
  std::int64_t drawn = 0;  // triangles that were not skipped

  bool operator==(const occluder_counts&) const = default;
};

/// How far a question had to be followed up. Added to, so that the counts of many questions come to a sum.
struct occlusion_counts {
  std::int64_t visible = 0, occluded = 0, outside = 0;  // answers
  std::int64_t tiles = 0, blocks = 0, pixels = 0;  // depths that were compared

  bool operator==(const occlusion_counts&) const = default;
};

namespace detail {

// The farthest key of a tile, and of each of its blocks; blocks beyond the picture never hold it.
struct farthest_keys {
  float tile;
  float block[blocks_across * blocks_across];
};

// The memory of a mask.
struct occluder_depths {
  picture_tiles grid{0, 0};
  image<float> pixels;  // meaningless in a tile that is not touched, as are its farthest keys
  std::vector<farthest_keys> farthest;  // by tile
  std::vector<std::uint8_t> touched;  // by tile
  drawing_lists lists;

  IRG_INLINE constexpr std::size_t tile_of(int x, int y) const noexcept {
    return static_cast<std::size_t>(y / tile_size * grid.across + x / tile_size);
  }
  IRG_INLINE constexpr cell_window picture() const noexcept { return {0, 0, grid.width, grid.height}; }
};

// Where in its tile the block of a pixel is.
IRG_INLINE constexpr int block_of(int x, int y) noexcept {
  return y % tile_size / block_size * blocks_across + x % tile_size / block_size;
}

inline namespace IRG_ABI {

template <class Order>
IRG_INLINE constexpr float depth_of(const occluder_depths& m, int x, int y) noexcept {
  return m.touched[m.tile_of(x, y)] != 0 ? m.pixels(x, y) : Order::farthest;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <class Order, Floating T>
IRG_API void draw_occluders(occluder_depths& m, std::span<const triangle_batch<T>> batches,
                            const screen_mapping<T>& mapping, face_culling culling, const executor_ref& executor);

// What is to be said of a rectangle whose depth is `nearest` everywhere: by its tiles, blocks and pixels, as far as
// each leave it undecided.
template <class Order>
IRG_API occlusion test_rectangle(const occluder_depths& m, const cell_window& pixels, float nearest,
                                 occlusion_counts& work) noexcept;
// The same of a box.
template <class Order, Floating T>
IRG_API occlusion test_box(const occluder_depths& m, const box<T, 3>& bounds, const mat<T, 4, 4>& to_clip,
                           occlusion_counts& work) noexcept;
// The triangles of a batch, until one is visible.
template <class Order, Floating T>
IRG_API occlusion test_triangles(const occluder_depths& m, const triangle_batch<T>& batch,
                                 const screen_mapping<T>& mapping, face_culling culling, occlusion_counts& work);

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

/// The depths of occluders over a picture, with the farthest of each 8 x 8 block and each 64 x 64 tile.
/// shape   made of width and height or an extent2; each pixel at the farthest depth at first
/// needs   1 <= width, height <= 65536 when anything is drawn
/// exact   depths equal to those of draw_depth; the same answers for every executor, compiler and instruction set
template <DepthOrder Order = nearer_is_greater>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
class occlusion_mask {
public:
  occlusion_mask() = default;
  IRG_INLINE constexpr occlusion_mask(int width, int height) {
    memory_.grid = {width, height};
    memory_.pixels = {width, height};
    memory_.farthest.resize(memory_.grid.count(), detail::farthest_keys{});
    memory_.touched.resize(memory_.grid.count(), 0);
  }
  template <std::same_as<extent2> Extent>
  IRG_INLINE constexpr explicit occlusion_mask(const Extent& size) : occlusion_mask(size.width, size.height) {}

  [[nodiscard]] IRG_INLINE constexpr int width() const noexcept { return memory_.grid.width; }
  [[nodiscard]] IRG_INLINE constexpr int height() const noexcept { return memory_.grid.height; }

  /// Forgets all occluders.
  /// cost    one byte for each tile: pixels are cleared when a tile is first drawn to
  IRG_INLINE constexpr void clear() noexcept {
    for (std::uint8_t& t : memory_.touched) t = 0;
  }

  /// Draws occluders.
  /// needs   vertices projected with `mapping`, a mapping onto this mask's size
  /// gives   triangles with a corner that is not finite are left out, and those that name a vertex that is not there
  /// cost    that of draw_depth, of which clearing leaves out the tiles that no occluder's box touches
  template <Floating T, Executor E = sequential>
  IRG_INLINE constexpr occluder_counts draw(std::span<const triangle_batch<T>> batches,
                                            const screen_mapping<T>& mapping, face_culling culling = face_culling::back,
                                            const E& executor = {}) {
    detail::draw_occluders<Order>(memory_, batches, mapping, culling, as_executor(executor));
    const detail::triangle_bins& bins = memory_.lists.bins;
    return {static_cast<std::int64_t>(bins.triangle_count), bins.skipped, bins.listed};
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
    occlusion_counts work;
    const occlusion answer = detail::test_box<Order>(memory_, bounds, to_clip, work);
    return count(answer, work, counts);
  }

  /// Whether something in a rectangle of pixels, nowhere nearer than `nearest`, could be seen.
  IRG_INLINE constexpr occlusion test(const cell_window& pixels, float nearest,
                                      occlusion_counts* counts = nullptr) const noexcept {
    occlusion_counts work;
    const occlusion answer = detail::test_rectangle<Order>(memory_, pixels, nearest, work);
    return count(answer, work, counts);
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
    occlusion_counts work;
    const triangle_batch<T> batch{&vertices, triangles, 0};
    const occlusion answer = detail::test_triangles<Order>(memory_, batch, mapping, culling, work);
    return count(answer, work, counts);
  }

  /// Whether something could be seen: not occluded, and not outside.
  template <class... Arguments>
  [[nodiscard]] IRG_INLINE constexpr bool is_visible(const Arguments&... arguments) const
    requires requires(const occlusion_mask m) { m.test(arguments...); }
  {
    return test(arguments...) == occlusion::visible;
  }

  /// The mask's depth at a pixel: what shade_batches leaves there.
  /// needs   0 <= x < width(), 0 <= y < height()
  [[nodiscard]] IRG_INLINE constexpr float depth(int x, int y) const noexcept {
    return detail::depth_of<Order>(memory_, x, y);
  }
  /// The farthest depth in the block of 8 x 8 pixels that holds a pixel.
  /// needs   0 <= x < width(), 0 <= y < height()
  [[nodiscard]] IRG_INLINE constexpr float block_depth(int x, int y) const noexcept {
    const std::size_t i = memory_.tile_of(x, y);
    if (memory_.touched[i] == 0) return Order::farthest;
    return memory_.farthest[i].block[detail::block_of(x, y)] * detail::key_sign<Order> + 0.0f;
  }

private:
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

  detail::occluder_depths memory_;
};

}  // namespace irg

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// The farthest keys of what a tile shows; beside the window, keys are infinite.
constexpr farthest_keys farthest_of(const visible_window& v) noexcept {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  farthest_keys keys{infinity, {}};
  const int height = v.window.y_last - v.window.y_first;
  for (int by = 0; by < blocks_across; ++by) {
    float least[tile_size];
    for (float& column : least) column = infinity;
    for (int y = by * block_size; y < minimum((by + 1) * block_size, height); ++y)
      for (int x = 0; x < tile_size; ++x) least[x] = minimum(v.key[y * tile_stride + x], least[x]);
    for (int bx = 0; bx < blocks_across; ++bx) {
      float& block = keys.block[by * blocks_across + bx] = infinity;
      for (int x = 0; x < block_size; ++x) block = minimum(least[bx * block_size + x], block);
      keys.tile = minimum(block, keys.tile);
    }
  }
  return keys;
}

// Keeps the farthest keys of a tile.
template <class T>
struct keep_farthest final : tile_finish<T> {
  farthest_keys& farthest;

  constexpr explicit keep_farthest(farthest_keys& to) noexcept : farthest(to) {}
  constexpr void clear(const cell_window&) const override {}
  constexpr std::int64_t operator()(const visible_window& v, const triangle_finder<T>&) const override {
    farthest = farthest_of(v);
    return 0;
  }
};

// A triangle on the screen: as a rectangle, then by its pixels.
template <class Order>
constexpr occlusion test_triangle(const occluder_depths& m, const triangle_corners& c, occlusion_counts& work) {
  const auto& [v0, v1, v2] = c.v;
  const auto nearer_of = [](float a, float b) { return Order::nearer(a, b) ? a : b; };
  const cell_window bounds = cover_triangle(v0->position, v1->position, v2->position).bounds;
  const float nearest = nearer_of(nearer_of(v0->depth, v1->depth), v2->depth);
  const occlusion rectangle = test_rectangle<Order>(m, bounds, nearest, work);
  if (rectangle != occlusion::visible) return rectangle;
  bool any = false, seen = false;
  const covered_triangle t = cover_and_set_up(*v0, *v1, *v2);
  covered_spans(t.coverage, m.picture(), [&](const span_of_cells& s) {
    any = true;
    for (int x = s.x_first; x < s.x_last && !seen; ++x) {
      ++work.pixels;
      seen = Order::nearer(depth_at(t.setup, x, s.y), depth_of<Order>(m, x, s.y));
    }
  });
  return seen ? occlusion::visible : any ? occlusion::occluded : occlusion::outside;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <class Order, Floating T>
IRG_API void draw_occluders(occluder_depths& m, std::span<const triangle_batch<T>> batches,
                            const screen_mapping<T>& mapping, face_culling culling, const executor_ref& executor) {
  triangle_bins& bins = m.lists.bins;
  bin_triangles(bins, batches, {mapping, m.grid, culling}, executor);
  m.lists.seen.assign(bins.triangle_count, 0);
  executor(m.grid.count(), [&](std::size_t i) {
    if (bins.list_of(i).empty()) return;
    const clearing clear = m.touched[i] == 0 ? clearing::before_drawing : clearing::none;
    const tile_job<T> job{batches, mapping, m.lists, culling, skip_options{}, clear};
    zbuffer_tiles<Order, tile_test::depth_only>{}(m.pixels, job, i, keep_farthest<T>(m.farthest[i]));
    m.touched[i] = 1;
  });
}

template <class Order>
IRG_API occlusion test_rectangle(const occluder_depths& m, const cell_window& pixels, float nearest,
                                 occlusion_counts& work) noexcept {
  const cell_window w = intersect(pixels, m.picture());
  if (w.empty()) return occlusion::outside;
  if (!(nearest == nearest)) return occlusion::visible;
  const float key = product(nearest, key_sign<Order>);
  const bool seen = any_square(w, tile_size, [&](const cell_window& in_tile, int, int) {
    const std::size_t i = m.tile_of(in_tile.x_first, in_tile.y_first);
    ++work.tiles;
    if (m.touched[i] == 0) return Order::nearer(nearest, Order::farthest);
    if (key <= m.farthest[i].tile) return false;
    return any_square(in_tile, block_size, [&](const cell_window& in_block, int, int) {
      ++work.blocks;
      if (key <= m.farthest[i].block[block_of(in_block.x_first, in_block.y_first)]) return false;
      return any_square(in_block, 1, [&](const cell_window&, int x, int y) {
        ++work.pixels;
        return Order::nearer(nearest, m.pixels(x, y));
      });
    });
  });
  return seen ? occlusion::visible : occlusion::occluded;
}

template <class Order, Floating T>
IRG_API occlusion test_box(const occluder_depths& m, const box<T, 3>& bounds, const mat<T, 4, 4>& to_clip,
                           occlusion_counts& work) noexcept {
  constexpr float sign = key_sign<Order>;
  const mask_rectangle r = project_box(bounds, to_clip, m.grid.width, m.grid.height, sign);
  if (r.where == mask_place::outside) return occlusion::outside;
  if (r.where == mask_place::before_the_eye) return occlusion::visible;
  return test_rectangle<Order>(m, r.pixels, product(r.key, sign), work);
}

template <class Order, Floating T>
IRG_API occlusion test_triangles(const occluder_depths& m, const triangle_batch<T>& batch,
                                 const screen_mapping<T>& mapping, face_culling culling, occlusion_counts& work) {
  bin_portion scratch = scratch_portion(m.grid);
  occlusion answer = occlusion::outside;
  for (std::uint32_t i = 0; i < batch.triangles.size() && answer != occlusion::visible; ++i)
    list_and_draw(scratch, batch, i, {mapping, m.grid, culling}, [&](const triangle_corners& c) {
      const occlusion one = test_triangle<Order>(m, c, work);
      if (one == occlusion::visible || answer == occlusion::outside) answer = one;
    });
  return answer;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
