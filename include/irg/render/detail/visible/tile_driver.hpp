// SPDX-License-Identifier: MIT
// Batches of triangles, tile by tile: culled, clipped and sorted into tiles, then for each tile what is seen there,
// then what is to be made of it, be it colours, numbers or nothing but depths.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/visible/draw_target.hpp>
#include <irg/render/detail/visible/tile_test.hpp>
#include <irg/render/detail/visible/visible_window.hpp>
#if IRG_BODIES
#include <irg/render/detail/bin/bin_triangles.hpp>
#include <irg/render/detail/bin/corner_lanes.hpp>
#include <irg/render/detail/visible/clear_window.hpp>
#include <irg/render/detail/visible/streamed_rows.hpp>
#include <irg/render/detail/visible/tile_drawing.hpp>
#include <irg/render/detail/visible/tile_kernel.hpp>
#include <irg/render/detail/visible/visible_pixels.hpp>
#endif

namespace irg {

/// Triangles on the screen, of several objects or of one, and the mapping that their vertices were projected with. It
/// refers to all that it is made of. At a call `{batches, mapping}` or `{vertices, triangles, mapping}` is enough for
/// doubles, else `irg::projected_triangles{batches, mapping}`.
template <Floating T>
class projected_triangles {
public:
  IRG_APART constexpr projected_triangles(std::type_identity_t<std::span<const triangle_batch<T>>> batches,
                                          const screen_mapping<T>& mapping) noexcept
      : mapping_(&mapping), batches_(batches) {}
  IRG_APART constexpr projected_triangles(const projected_vertices<T>& vertices,
                                          std::span<const triangle_indices> triangles,
                                          const screen_mapping<T>& mapping) noexcept
      : mapping_(&mapping), alone_{&vertices, triangles} {}

  [[nodiscard]] IRG_APART constexpr const screen_mapping<T>& mapping() const noexcept { return *mapping_; }
  [[nodiscard]] IRG_APART constexpr std::span<const triangle_batch<T>> batches() const& noexcept {
    return alone_.vertices == nullptr ? batches_ : std::span<const triangle_batch<T>>(&alone_, 1);
  }

private:
  const screen_mapping<T>* mapping_;
  std::span<const triangle_batch<T>> batches_{};
  triangle_batch<T> alone_{};
};

namespace detail {

// What is drawn, and how, whatever becomes of it.
template <class T>
struct tile_job {
  std::span<const triangle_batch<T>> batches;
  const screen_mapping<T>& mapping;
  drawing_lists& lists;
  face_culling culling;
  skip_options skip;
  clearing clear;
  depth_result depth = depth_result::kept;

  IRG_INLINE constexpr triangle_finder<T> finder() const noexcept { return {batches, &lists.bins}; }
};

// The job that settings describe; `own` serves where they bring no workspace.
template <class T>
IRG_APART constexpr tile_job<T> job_of(const projected_triangles<T>& triangles, const auto& settings,
                                       draw_workspace& own) noexcept {
  tile_job<T> job{
      triangles.batches(), triangles.mapping(), lists_of(settings.workspace != nullptr ? *settings.workspace : own),
      settings.culling,    settings.skip,       settings.clear};
  if constexpr (requires { settings.depth; }) job.depth = settings.depth;
  return job;
}

}  // namespace detail

namespace detail::inline IRG_COMPILED_ABI {

// Draws all tiles by comparing depths, and hands each to `finish`.
template <class Order, tile_test Test, Floating T, class Depth>
IRG_API render_counts draw_zbuffer(Depth& depth, const tile_job<T>& job, const tile_finish<T>& finish,
                                   const executor_ref& executor);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

template <class Order, tile_test Test, Floating T, RowRaster Depth>
constexpr render_counts draw_by_depth(Depth& depth, const tile_job<T>& job, const tile_finish<T>& finish,
                                      const executor_ref& executor) {
  expect_known_order<Order>();
  return on_rows(depth, [&](auto& rows) { return draw_zbuffer<Order, Test, T>(rows, job, finish, executor); });
}

}  // namespace detail::inline IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The numbers of a tile's list, roughly from the nearest triangle to the farthest, so that what lies behind them can be
// passed over: sorted by 8 bits of the greatest key.
template <class T>
std::vector<std::uint32_t> front_to_back(std::span<const std::uint32_t> numbers, const triangle_finder<T>& find,
                                         float sign) {
  constexpr int count = tile_lanes;
  using F = lanes<tile_floats>;
  const std::size_t size = numbers.size();
  std::vector<float> key(size + count);
  auto least = F::broadcast(beyond_everything), greatest = F::broadcast(-beyond_everything);
  for (std::size_t i = 0; i < size; i += count) {
    corner_lanes<count> c;
    c.collect(find, numbers.data() + i, static_cast<int>(minimum(size - i, std::size_t{count})));
    const auto of = [&](int k) { return c.depth[k] * F::broadcast(sign); };
    const auto nearest = maximum(maximum(of(0), of(1)), of(2));
    F::store(key.data() + i, nearest);
    least = minimum(nearest, least);
    greatest = maximum(nearest, greatest);
  }
  const float front = -reduce_min(F::broadcast(0.0f) - greatest), range = front - reduce_min(least);
  const float scale = 0.0f < range ? 255.0f / range : 0.0f;
  std::vector<std::uint8_t> bucket(size);
  std::uint32_t start[257] = {};
  for (std::size_t i = 0; i < size; ++i) {
    bucket[i] = static_cast<std::uint8_t>(clamped((front - key[i]) * scale, 0.0f, 255.0f));
    ++start[bucket[i] + 1];
  }
  for (int b = 0; b < 256; ++b) start[b + 1] += start[b];
  std::vector<std::uint32_t> sorted(size);
  for (std::size_t i = 0; i < size; ++i) sorted[start[bucket[i]]++] = numbers[i];
  return sorted;
}

// Notes that none of a list is passed over.
template <class T>
IRG_INLINE constexpr void mark_all_seen(const tile_job<T>& job, std::span<const std::uint32_t> numbers) noexcept {
  for (const std::uint32_t number : numbers) store_relaxed(job.lists.seen[job.finder().source(number)], 1);
}

// The window of a tile without triangles and of those to its right; empty for one that has such a tile to its left:
// neighbours are cleared together, since long runs of pixels are written much faster.
IRG_INLINE constexpr cell_window empty_tiles(const triangle_bins& bins, const picture_tiles& grid,
                                             std::size_t i) noexcept {
  const auto is_empty = [&](std::size_t k) { return bins.list_of(k).empty(); };
  const auto across = static_cast<std::size_t>(grid.across);
  cell_window w = grid.window(i);
  if (i % across != 0 && is_empty(i - 1)) return {w.x_first, w.y_first, w.x_first, w.y_last};
  while ((i + 1) % across != 0 && is_empty(i + 1)) ++i;
  w.x_last = grid.window(i).x_last;
  return w;
}

// The depths of a raster into the tile.
template <class Depth>
IRG_INLINE void load_depths(tile& t, Depth& depth, const cell_window& w, float sign) {
  for (int y = w.y_first; y < w.y_last; ++y) {
    const float* row = raster_traits<Depth>::row(depth, y);
    float* key = t.key + (y - w.y_first) * tile_stride;
    for (int x = w.x_first; x < w.x_last; ++x) key[x - w.x_first] = row[x] * sign;
  }
  t.stale = ~std::uint64_t{0};
  refresh_far(t);
}
// The depths of the tile into a raster. Without numbers, a zero's sign would tell which of equally near triangles came
// last; so all zeros are positive.
template <tile_test Test, class Depth>
IRG_INLINE void store_depths(const tile& t, Depth& depth, const cell_window& w, float sign) {
  const row_store how = row_store_for(depth);
  const int width = w.x_last - w.x_first;
  for (int y = w.y_first; y < w.y_last; ++y) {
    const float* key = t.key + (y - w.y_first) * tile_stride;
    float depths[tile_size];
    if (sign != 1 || Test == tile_test::depth_only) {
      constexpr float zero = Test == tile_test::depth_only ? 0.0f : -0.0f;  // adding -0 leaves every number as it is
      for (int x = 0; x < width; ++x) depths[x] = key[x] * sign + zero;
      key = depths;
    }
    copy_row(raster_traits<Depth>::row(depth, y) + w.x_first, key, static_cast<std::size_t>(width) * sizeof *key, how);
  }
  end_of_rows(how);
}

// A tile that is drawn in lanes, and the list that its places are of: the one that was binned, or `sorted`.
struct drawn_tile {
  tile t;
  std::span<const std::uint32_t> numbers;
  std::vector<std::uint32_t> sorted;
};

// Which triangle each pixel of tile i shows, in lanes: the same whatever becomes of it, and so one copy for all.
template <class Order, tile_test Test, class T, class Depth>
IRG_NOINLINE draw_counts find_visible(drawn_tile& out, Depth& depth, const tile_job<T>& job, std::size_t i) {
  auto& [t, numbers, sorted] = out;
  constexpr float sign = key_sign<Order>;
  const picture_tiles grid(width_of(depth), height_of(depth));
  const cell_window w = grid.window(i);
  const triangle_finder<T> find = job.finder();
  numbers = job.lists.bins.list_of(i);
  clear_tile(t, w.x_last - w.x_first, w.y_last - w.y_first, Order::farthest * sign);
  if (job.clear == clearing::none) load_depths(t, depth, w, sign);
  // Where pixels are covered more than twice, order and rejection pay. A triangle covers half of its box.
  const bool front_first =
      Test != tile_test::always && job.skip.occluded == skipping::on &&
      job.lists.bins.tile_area[i] > 4.0f * static_cast<float>((w.x_last - w.x_first) * (w.y_last - w.y_first));
  if (front_first) {
    sorted = front_to_back(numbers, find, sign);
    numbers = sorted;
  }
  tile_pass<T> pass{find, numbers, w, {sign, front_first}, t, job.lists.seen.data(), Order::farthest * sign};
  draw_list<Test>(pass);
  if (job.clear == clearing::none || job.depth == depth_result::kept) store_depths<Test>(t, depth, w, sign);
  return {pass.tested, 0, pass.ties};
}

// The z-buffer, and drawing in the order given: what a tile shows by comparing depths.
template <class Order, tile_test Test>
struct zbuffer_tiles {
  static constexpr float farthest() noexcept { return Order::farthest; }  // the depth where nothing is

  // Tile i, which has a list: what is seen, and then finish(visible_window, finder).
  template <class T, class Depth>
  constexpr draw_counts operator()(Depth& depth, const tile_job<T>& job, std::size_t i,
                                   const tile_finish<T>& finish) const {
    const cell_window w = picture_tiles(width_of(depth), height_of(depth)).window(i);
    if constexpr (key_sign<Order> != 0)
      if (!std::is_constant_evaluated()) return in_lanes(depth, job, i, finish);
    if (job.clear == clearing::before_drawing) clear_window(depth, w, Order::farthest);
    visible_pixels pixels(w);
    const std::span<const std::uint32_t> numbers = job.lists.bins.list_of(i);
    mark_all_seen(job, numbers);
    draw_counts counts = find_visible_plainly<Order, Test>(pixels, depth, numbers, job.finder(), w);
    counts.shaded =
        finish(visible_window{pixels.place.data(), pixels.key.data(), plain_sign<Order>, numbers, w}, job.finder());
    return counts;
  }

private:
  template <class T, class Depth>
  static draw_counts in_lanes(Depth& depth, const tile_job<T>& job, std::size_t i, const tile_finish<T>& finish) {
    drawn_tile d;
    draw_counts counts = find_visible<Order, Test>(d, depth, job, i);
    const cell_window w = picture_tiles(width_of(depth), height_of(depth)).window(i);
    counts.shaded = finish(visible_window{d.t.id, d.t.key, key_sign<Order>, d.numbers, w}, job.finder());
    return counts;
  }
};

// The z-buffer where it matters which triangle is seen.
template <class Order>
using zbuffer_method = zbuffer_tiles<Order, test_of<Order>>;

// All tiles. What is seen is the method's affair, what becomes of it finish's.
template <class T, class Method, class Depth>
constexpr render_counts draw_tiles(const Method& method, Depth& depth, const tile_job<T>& job,
                                   const tile_finish<T>& finish, const executor_ref& executor) {
  const picture_tiles grid(width_of(depth), height_of(depth));
  triangle_bins& bins = job.lists.bins;
  bin_triangles(bins, job.batches, {job.mapping, grid, job.culling, job.skip}, executor);
  job.lists.seen.assign(bins.triangle_count, 0);
  std::vector<draw_counts> done(grid.count(), draw_counts{});
  executor(grid.count(), [&](std::size_t i) {
    if (!bins.list_of(i).empty()) {
      done[i] = method(depth, job, i, finish);
    } else if (job.clear == clearing::before_drawing) {
      const cell_window w = empty_tiles(bins, grid, i);
      finish.clear(w);
      if (job.depth == depth_result::kept) clear_window(depth, w, method.farthest());
    }
  });
  render_counts stats;
  for (const draw_counts& c : done) stats.pixels += c;
  stats.drawn = stats.pixels.shaded;
  add_skips(stats, bins, job.lists.seen, job.skip);
  return stats;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Order, tile_test Test, Floating T, class Depth>
IRG_API render_counts draw_zbuffer(Depth& depth, const tile_job<T>& job, const tile_finish<T>& finish,
                                   const executor_ref& executor) {
  return draw_tiles<T>(zbuffer_tiles<Order, Test>{}, depth, job, finish, executor);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
