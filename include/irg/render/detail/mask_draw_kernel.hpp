// SPDX-License-Identifier: MIT
// Batches of triangles into an occlusion mask: on one thread as they come, on several by the lists of tiles.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include <irg/core/executor.hpp>
#include <irg/render/detail/mask_painter.hpp>
#include <irg/render/detail/scratch_portion.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// What drawing into a mask did not have to do.
struct mask_draw_result {
  skip_counts skipped;
  std::int64_t listed = 0;
};

// Triangles [first, last) of a batch one by one: culled, clipped if need be, and given to draw(corners).
template <class T, class Draw>
constexpr void list_and_draw(bin_portion& scratch, const triangle_batch<T>& batch, std::uint32_t i,
                             const screen_mapping<T>& mapping, const picture_tiles& grid, face_culling culling,
                             const Draw& draw) {
  const bool listed = list_alone(scratch, batch, i, mapping, grid, culling);
  for (const clipped_piece& p : scratch.pieces) draw(triangle_corners{{&p.v[0], &p.v[1], &p.v[2]}});
  if (!scratch.pieces.empty() || !listed) return;
  const screen_vertex* screen = batch.vertices->screen.data();
  const auto& [v] = batch.triangles[i];
  draw(triangle_corners{{screen + v[0], screen + v[1], screen + v[2]}});
}

// A batch, triangle after triangle.
template <class T>
constexpr mask_draw_result draw_mask_batch(const mask_target& m, const triangle_batch<T>& batch,
                                           const screen_mapping<T>& mapping, face_culling culling) {
  const picture_tiles grid(m.width, m.height);
  const cell_window window{0, 0, m.width, m.height};
  const auto n = static_cast<std::uint32_t>(batch.triangles.size());
  bin_portion scratch = scratch_portion(grid);
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated() && !batch.vertices->screen.empty()) {
    triangle_bins no_pieces;
    no_pieces.triangle_count = 0xffffffff;
    mask_painter<T> painter{{m, window, {{&batch, 1}, &no_pieces}}, {m, window}};
    constexpr std::uint32_t count = native_lanes<std::int32_t>;
    const cull_kernel<static_cast<int>(count)> kernel{batch.vertices->screen.data(),
                                                      batch.vertices->codes.data(),
                                                      static_cast<std::int32_t>(batch.vertices->screen.size()),
                                                      batch.vertices->any,
                                                      window,
                                                      culling};
    // Pieces do not outlive their triangle, so they are not queued.
    const auto one = [&](std::uint32_t i) {
      list_and_draw(scratch, batch, i, mapping, grid, culling,
                    [&](const triangle_corners& c) { painter.large_ones.draw(c); });
    };
    using I = lanes<pack<std::int32_t, static_cast<int>(count)>>;
    const auto limit = I::broadcast(painter.small_ones.few + 1);
    // Vertices that the cache has anyway need not be asked for.
    const bool ahead = batch.vertices->screen.size() > 1 << 16;
    std::uint32_t i = 0;
    mask_draw_result result;
    for (; i + count <= n; i += count) {
      const triangle_indices* const t = batch.triangles.data() + i;
      if (ahead && i + 3 * count <= n) kernel.fetch_ahead(t + 2 * count);
      const auto group = kernel(t, skip_options{});
      result.skipped += group.skipped;
      result.listed += std::popcount(group.listed);
      const auto x_first = I::load(group.x_first), x_last = I::load(group.x_last), y_first = I::load(group.y_first),
                 y_last = I::load(group.y_last);
      const unsigned few = group.listed & mask_bits(both(x_last - x_first < limit, y_last - y_first < limit));
      if (few != 0)
        painter.small_ones.add(I::broadcast(static_cast<std::int32_t>(batch.first_number + i)) + I::ramp(), few,
                               painter.small_ones.shape_of(x_first, y_first, x_last, y_last));
      for (unsigned bits = (group.listed | group.special) & ~few; bits != 0; bits &= bits - 1) {
        const auto k = static_cast<std::uint32_t>(std::countr_zero(bits));
        if ((group.special >> k & 1) != 0)
          one(i + k);
        else
          painter.large_ones.draw(painter.small_ones.find.corners(batch.first_number + i + k));
      }
    }
    for (; i < n; ++i) one(i);
    painter.small_ones.flush();
    result.skipped += scratch.skipped;
    result.listed += scratch.listed;
    return result;
  }
#endif
  for (std::uint32_t i = 0; i < n; ++i)
    list_and_draw(scratch, batch, i, mapping, grid, culling,
                  [&](const triangle_corners& c) { draw_mask_plainly(m, *c.v[0], *c.v[1], *c.v[2], window); });
  return {scratch.skipped, scratch.listed};
}

// The triangles of a tile's list, cut to the tile.
template <class T>
constexpr void draw_mask_tile(const mask_target& m, std::span<const std::uint32_t> numbers,
                              const triangle_finder<T>& find, const cell_window& window) {
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated()) {
    mask_painter<T> painter{{m, window, find}, {m, window}};
    constexpr std::size_t at_once = mask_lanes::count;
    for (std::size_t i = 0; i < numbers.size(); i += at_once)
      painter.add(numbers.data() + i, static_cast<int>(lesser(numbers.size() - i, at_once)));
    return painter.small_ones.flush();
  }
#endif
  for (const std::uint32_t number : numbers) {
    const triangle_corners c = find.corners(number);
    draw_mask_plainly(m, *c.v[0], *c.v[1], *c.v[2], window);
  }
}

// All batches: at once on one thread, by lists of tiles on several.
template <class T, class E>
constexpr mask_draw_result draw_mask(const mask_target& m, std::span<const triangle_batch<T>> batches,
                                     const screen_mapping<T>& mapping, face_culling culling, triangle_bins& bins,
                                     const E& executor) {
  mask_draw_result result;
  if constexpr (std::same_as<E, sequential>) {
    for (const triangle_batch<T>& b : batches) {
      const mask_draw_result r = draw_mask_batch(m, b, mapping, culling);
      result.skipped += r.skipped;
      result.listed += r.listed;
    }
  } else {
    const picture_tiles grid(m.width, m.height);
    bin_triangles(bins, batches, mapping, grid, culling, skip_options{}, executor);
    const triangle_finder<T> find{batches, &bins};
    executor(grid.count(), [&](std::size_t i) { draw_mask_tile(m, bins.list_of(i), find, grid.window(i)); });
    result = {bins.skipped, bins.listed};
  }
  for (int tx = 0; tx < m.across; ++tx)
    for (int ty = 0; ty < m.down; ++ty) finish_mask_tile(m, tx, ty);
  return result;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
