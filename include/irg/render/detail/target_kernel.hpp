// SPDX-License-Identifier: MIT
// Batches of triangles drawn for their depths, or their depths and numbers, without colours: the same tiles, and the
// same kernel, as draw_batches.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include <irg/render/draw_triangles.hpp>

namespace irg {
namespace detail {

// Stands in for a raster of numbers where none is wanted.
struct no_numbers {};

// The farthest key of a tile, and of each of its blocks; blocks beyond the picture never hold it.
struct farthest_keys {
  float tile;
  float block[blocks_across * blocks_across];
};

inline namespace IRG_ABI {

// The pixels of a window that a triangle covers, one by one: emit(x, y, depth).
template <class Emit>
constexpr void covered_depths(const triangle_corners& c, const cell_window& window, const Emit& emit) {
  const triangle_coverage coverage = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
  if (coverage.double_area == 0) return;
  const triangle_setup s = set_up(coverage, *c.v[0], *c.v[1], *c.v[2]);
  covered_spans(coverage, window, [&](const span_of_cells& span) {
    for (int x = span.x_first; x < span.x_last; ++x)
      emit(x, span.y,
           depth_at<float>(s.edge[0](x, span.y), s.edge[1](x, span.y), s.edge[2](x, span.y), s.depth_gain[0],
                           s.depth_gain[1], s.depth_gain[2], s.depth_rest, s.depth_low, s.depth_high));
  });
}

template <class Order, class T, class Ids, class Depth>
constexpr draw_counts draw_target_plainly(Ids& ids, Depth& depth, std::span<const std::uint32_t> numbers,
                                          const triangle_finder<T>& find, const cell_window& window) {
  draw_counts counts;
  for (const std::uint32_t number : numbers)
    covered_depths(find.corners(number), window, [&](int x, int y, float here) {
      float& stored = raster_traits<Depth>::row(depth, y)[x];
      ++counts.tested;
      if (!Order::nearer(here, stored)) return;
      stored = here;
      if constexpr (!std::same_as<Ids, const no_numbers>) set_pixel(ids, x, y, find.source(number));
    });
  return counts;
}

template <class Depth>
constexpr farthest_keys farthest_plainly(const Depth& depth, const cell_window& w, float sign) {
  farthest_keys keys{};
  keys.tile = std::numeric_limits<float>::infinity();
  for (float& block : keys.block) block = keys.tile;
  for (int y = 0; y < w.y_last - w.y_first; ++y)
    for (int x = 0; x < w.x_last - w.x_first; ++x) {
      const float key = get_pixel(depth, w.x_first + x, w.y_first + y) * sign;
      float& block = keys.block[y / block_size * blocks_across + x / block_size];
      block = lesser(key, block);
      keys.tile = lesser(key, keys.tile);
    }
  return keys;
}

template <class Order, class Ids, class Depth>
IRG_INLINE constexpr void clear_target(Ids& ids, Depth& depth, const cell_window& w) {
  for (int y = w.y_first; y < w.y_last; ++y) {
    fill_span(depth, {y, w.x_first, w.x_last}, Order::farthest);
    if constexpr (!std::same_as<Ids, const no_numbers>) fill_span(ids, {y, w.x_first, w.x_last}, no_triangle);
  }
}

#ifdef IRG_LANES_VECTOR

// The source triangles of what a tile holds; where nothing was drawn, the raster keeps what it has.
template <class T, class Ids>
IRG_INLINE void store_numbers(const tile& t, Ids& ids, std::span<const std::uint32_t> numbers,
                              const triangle_finder<T>& find, const cell_window& w) {
  for (int y = w.y_first; y < w.y_last; ++y) {
    std::uint32_t* row = raster_traits<Ids>::row(ids, y);
    const std::uint32_t* id = t.id + (y - w.y_first) * tile_stride;
    for (int x = w.x_first; x < w.x_last; ++x, ++id)
      if (*id != no_triangle) row[x] = find.source(numbers[*id]);
  }
}

template <class Order, class T, class Ids, class Depth>
draw_counts draw_target_fast(Ids& ids, Depth& depth, std::span<const std::uint32_t> numbers, float area,
                             const triangle_finder<T>& find, const cell_window& w, const skip_options& skip,
                             clearing clear, std::uint8_t* seen, farthest_keys* farthest) {
  constexpr bool numbered = !std::same_as<Ids, const no_numbers>;
  constexpr tile_test test = numbered ? tile_test::nearer : tile_test::depth_only;
  tile t;
  std::vector<std::uint32_t> sorted;
  const draw_counts counts = find_visible<Order, test>(t, depth, numbers, sorted, area, find, w, clear,
                                                       depth_result::kept, skip.occluded, seen);
  if constexpr (numbered) {
    if (clear == clearing::before_drawing)
      for (int y = w.y_first; y < w.y_last; ++y) fill_span(ids, {y, w.x_first, w.x_last}, no_triangle);
    store_numbers(t, ids, numbers, find, w);
  }
  if (farthest != nullptr) {
    t.stale = ~std::uint64_t{0};
    refresh_far(t);
    farthest->tile = t.farthest;
    std::memcpy(farthest->block, t.farthest_key, sizeof farthest->block);
  }
  return counts;
}

#endif

// A tile that has triangles; with its farthest keys, where they are wanted.
template <class Order, class T, class Ids, class Depth>
constexpr draw_counts draw_target_tile(Ids& ids, Depth& depth, const triangle_finder<T>& find, std::size_t i,
                                       const cell_window& w, [[maybe_unused]] const skip_options& skip, clearing clear,
                                       [[maybe_unused]] std::uint8_t* seen, farthest_keys* farthest) {
  const std::span<const std::uint32_t> numbers = find.bins->list_of(i);
#ifdef IRG_LANES_VECTOR
  if constexpr (key_sign<Order> != 0)
    if (!std::is_constant_evaluated())
      return draw_target_fast<Order>(ids, depth, numbers, find.bins->tile_area[i], find, w, skip, clear, seen,
                                     farthest);
#endif
  if (clear == clearing::before_drawing) clear_target<Order>(ids, depth, w);
  const draw_counts counts = draw_target_plainly<Order>(ids, depth, numbers, find, w);
  if (farthest != nullptr) *farthest = farthest_plainly(depth, w, key_sign<Order>);
  return counts;
}

// All tiles.
template <class Order, class T, class Ids, class Depth, class E>
constexpr render_stats draw_target(Ids& ids, Depth& depth, std::span<const triangle_batch<T>> batches,
                                   const screen_mapping<T>& mapping, face_culling culling, const skip_options& skip,
                                   clearing clear, draw_workspace& workspace, const E& executor) {
  const picture_tiles grid(width_of(depth), height_of(depth));
  triangle_bins& bins = workspace.bins;
  bin_triangles(bins, batches, mapping, grid, culling, skip, executor);
  workspace.seen.assign(bins.triangle_count, 0);
  const triangle_finder<T> find{batches, &bins};
  std::vector<draw_counts> done(grid.count(), draw_counts{});
  executor(grid.count(), [&](std::size_t i) {
    const cell_window window = grid.window(i);
    if (!bins.list_of(i).empty()) {
      done[i] = draw_target_tile<Order>(ids, depth, find, i, window, skip, clear, workspace.seen.data(), nullptr);
    } else if (clear == clearing::before_drawing) {
#ifdef IRG_LANES_VECTOR
      if (!std::is_constant_evaluated()) return clear_target<Order>(ids, depth, empty_tiles(bins, grid, i));
#endif
      clear_target<Order>(ids, depth, window);
    }
  });
  render_stats stats;
  for (const draw_counts& c : done) stats.pixels += c;
  add_skips(stats, bins, workspace.seen, skip);
  return stats;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
