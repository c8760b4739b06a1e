// SPDX-License-Identifier: MIT
// The triangle stage: cull, clip, sort into tiles, and draw each tile: first which triangle each pixel shows, then the
// colour of what is visible. Tiles are independent of each other, so an executor may draw them in any order on any
// thread, and small enough to stay in the cache while they are drawn.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/render/detail/attribute_kernel.hpp>
#include <irg/render/detail/streamed_rows.hpp>
#include <irg/render/options.hpp>
#include <irg/raster/triangle_batch.hpp>

namespace irg {

/// Whether the picture and its depth are cleared first: tile by tile, just before each is drawn, while it is in the
/// cache.
enum class clearing { none, before_drawing };

/// Whether the depths are wanted afterwards. Where they are not, and the picture is cleared first, the depth raster is
/// left as it is at run time: no work is spent on it.
enum class depth_result { kept, dropped };

/// How drawing is set up: what is left out, and what the picture is cleared to first, if it is.
template <class P>
struct draw_settings {
  face_culling culling = face_culling::back;
  skip_options skip{};
  clearing clear = clearing::none;
  P background{};
  depth_result depth = depth_result::kept;
};

/// The lists that drawing makes. Kept from picture to picture, they spare the next one the allocation.
struct draw_workspace {
  detail::triangle_bins bins;
  std::vector<std::uint8_t> seen;  // by triangle: whether any part of it was not passed over
};

namespace detail {
inline namespace IRG_ABI {

template <class R>
IRG_INLINE constexpr void clear_window(R& raster, const cell_window& w, const pixel_of<R>& value) {
  for (int y = w.y_first; y < w.y_last; ++y) fill_span(raster, {y, w.x_first, w.x_last}, value);
}
template <class Order, class Colour, class Depth>
IRG_INLINE constexpr void clear_window(Colour& colour, Depth& depth, const cell_window& w,
                                       const pixel_of<Colour>& background) {
  clear_window(colour, w, background);
  clear_window(depth, w, Order::farthest);
}

template <class R>
constexpr std::int64_t count_other_than(const R& raster, const cell_window& w, const pixel_of<R>& background) {
  std::int64_t count = 0;
  for (int y = w.y_first; y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x) count += get_pixel(raster, x, y) == background ? 0 : 1;
  return count;
}

// How many triangles there were, and why some were not drawn.
constexpr void add_skips(render_stats& stats, const triangle_bins& bins, std::span<const std::uint8_t> seen,
                         const skip_options& skip) noexcept {
  stats.triangles = static_cast<std::int64_t>(bins.triangle_count);
  stats.skipped = bins.skipped;
  if (skip.occluded == skipping::off || std::is_constant_evaluated()) return;
  stats.skipped.occluded = bins.listed;
  for (const std::uint8_t s : seen) stats.skipped.occluded -= s;
}

// What drawing a tile did.
struct tile_result {
  draw_counts pixels;
  std::int64_t drawn = 0;
};

// A tile, pixel by pixel and triangle by triangle: what the fast way has to equal. Serves constant evaluation, orders
// of depth that are not irg's, and compilers without vector registers.
template <class Order, class T, class Colour, class Depth, class MakeShader>
constexpr draw_counts draw_tile_plainly(Colour& colour, Depth& depth, std::span<const std::uint32_t> numbers,
                                        const triangle_finder<T>& find, const cell_window& window,
                                        const MakeShader& make_shader) {
  draw_counts counts;
  for (const std::uint32_t number : numbers) {
    const triangle_corners c = find.corners(number);
    const triangle_coverage coverage = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    if (coverage.double_area == 0) continue;
    counts += with_pixel_shader(
        make_shader, find, number, coverage.flipped ? facing::front : facing::back, [&](const auto& shader) {
          return draw_triangle<Order>(colour, depth, coverage, *c.v[0], *c.v[1], *c.v[2], shader, window);
        });
  }
  return counts;
}

#ifdef IRG_LANES_VECTOR

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

// Which triangle each pixel of a tile shows, in lanes: the same for all shaders, and so one copy for all of them.
// Leaves the list as it was drawn, in `numbers`; `sorted` holds it if it is not the one that was given.
template <class Order, tile_test Test, class T, class Depth>
IRG_NOINLINE draw_counts find_visible(tile& t, Depth& depth, std::span<const std::uint32_t>& numbers,
                                      std::vector<std::uint32_t>& sorted, float area, const triangle_finder<T>& find,
                                      const cell_window& w, clearing clear, depth_result result, skipping occluded,
                                      std::uint8_t* seen) {
  constexpr float sign = key_sign<Order>;
  clear_tile(t, w.x_last - w.x_first, w.y_last - w.y_first, Order::farthest * sign);
  if (clear == clearing::none) load_depths(t, depth, w, sign);
  // Where pixels are covered more than twice, order and rejection pay. A triangle covers half of its box.
  const bool front_first = Test != tile_test::always && occluded == skipping::on &&
                           area > 4.0f * static_cast<float>((w.x_last - w.x_first) * (w.y_last - w.y_first));
  if (front_first) {
    sorted = front_to_back(numbers, find, sign);
    numbers = sorted;
  }
  tile_painter<T> painter{find, numbers, w, {sign, front_first}, t, seen};
  painter.template draw_list<Test>();
  if (clear == clearing::none || result == depth_result::kept) store_depths<Test>(t, depth, w, sign);
  return {painter.tested, 0, painter.ties};
}

// The window of a tile without triangles and of those to its right; empty for one that has such a tile to its left.
IRG_INLINE cell_window empty_tiles(const triangle_bins& bins, const picture_tiles& grid, std::size_t i) noexcept {
  const auto is_empty = [&](std::size_t k) { return bins.list_of(k).empty(); };
  const auto across = static_cast<std::size_t>(grid.across);
  cell_window w = grid.window(i);
  if (i % across != 0 && is_empty(i - 1)) return {w.x_first, w.y_first, w.x_first, w.y_last};
  while ((i + 1) % across != 0 && is_empty(i + 1)) ++i;
  w.x_last = grid.window(i).x_last;
  return w;
}

// A tile in lanes: see tile_drawing.hpp and tile_shading.hpp.
template <class Order, class T, class Colour, class Depth, class MakeShader>
draw_counts draw_tile_fast(Colour& colour, Depth& depth, std::span<const std::uint32_t> numbers, float area,
                           const triangle_finder<T>& find, const cell_window& w, const MakeShader& make_shader,
                           const draw_settings<pixel_of<Colour>>& settings, std::uint8_t* seen) {
  constexpr tile_test test = std::same_as<Order, drawing_order> ? tile_test::always : tile_test::nearer;
  const bool clear = settings.clear == clearing::before_drawing;
  tile t;
  std::vector<std::uint32_t> sorted;
  draw_counts counts = find_visible<Order, test>(t, depth, numbers, sorted, area, find, w, settings.clear,
                                                 settings.depth, settings.skip.occluded, seen);
  if constexpr (AttributeShading<MakeShader, triangle_batch<T>>) {
    counts.shaded = attribute_kernel<T, MakeShader, Colour>{
        t, {find, numbers, w, make_shader}, colour, clear ? &settings.background : nullptr}();
  } else {
    if (clear) clear_window(colour, w, settings.background);
    counts.shaded = shade_by_triangle(t, find, numbers, w, key_sign<Order>, colour, make_shader);
  }
  return counts;
}

#endif

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Draws batches of triangles into a picture and its depth buffer, and returns what it did.
/// shape   colour and depth are rasters of one size; make_shader(batch, triangle, facing) gives the pixel shader of a
///         triangle of a batch, or is an AttributeShading; first_number of the batches counts their triangles through
/// needs   at most 2^31 triangles; `depth` holds depths of the same order, unless they are cleared first; shaders
///         without memory: each visible pixel is shaded once, in no stated order
/// gives   of equally near triangles the first one; triangles with a corner that is not finite are left out, and those
///         that name a vertex that is not there
/// exact   the same bytes for every executor and for all skips on and off
/// cost    one pass over the triangles, then the pixels; allocates what the workspace lacks
template <DepthOrder Order = nearer_is_greater, Floating T, RowRaster Colour, RowRaster Depth, class MakeShader,
          Executor E = sequential>
constexpr render_stats draw_batches(Colour& colour, Depth& depth,
                                    std::type_identity_t<std::span<const triangle_batch<T>>> batches,
                                    const screen_mapping<T>& mapping, const MakeShader& make_shader,
                                    const draw_settings<pixel_of<Colour>>& settings, draw_workspace& workspace,
                                    const E& executor = {}) {
  const detail::picture_tiles grid(width_of(colour), height_of(colour));
  detail::triangle_bins& bins = workspace.bins;
  detail::bin_triangles(bins, batches, mapping, grid, settings.culling, settings.skip, executor);
  workspace.seen.assign(bins.triangle_count, 0);
  const detail::triangle_finder<T> find{batches, &bins};
  std::vector<detail::tile_result> done(grid.count(), detail::tile_result{});
  executor(grid.count(), [&](std::size_t i) {
    const cell_window window = grid.window(i);
    const std::span<const std::uint32_t> numbers = bins.list_of(i);
#ifdef IRG_LANES_VECTOR
    if constexpr (detail::key_sign<Order> != 0) {
      if (!std::is_constant_evaluated()) {
        if (numbers.empty()) {  // neighbours are cleared together: long runs of pixels are written much faster
          if (settings.clear == clearing::none) return;
          const cell_window w = detail::empty_tiles(bins, grid, i);
          detail::clear_window(colour, w, settings.background);
          if (settings.depth == depth_result::kept) detail::clear_window(depth, w, Order::farthest);
          return;
        }
        done[i].pixels = detail::draw_tile_fast<Order>(colour, depth, numbers, bins.tile_area[i], find, window,
                                                       make_shader, settings, workspace.seen.data());
        done[i].drawn = done[i].pixels.shaded;
        return;
      }
    }
#endif
    if (settings.clear == clearing::before_drawing)
      detail::clear_window<Order>(colour, depth, window, settings.background);
    done[i].pixels = detail::draw_tile_plainly<Order>(colour, depth, numbers, find, window, make_shader);
    done[i].drawn = detail::count_other_than(depth, window, Order::farthest);
  });
  render_stats stats;
  for (const detail::tile_result& r : done) {
    stats.pixels += r.pixels;
    stats.drawn += r.drawn;
  }
  detail::add_skips(stats, bins, workspace.seen, settings.skip);
  return stats;
}

/// Draws the triangles of one object; make_shader(triangle, facing) gives their pixel shaders.
template <DepthOrder Order = nearer_is_greater, Floating T, RowRaster Colour, RowRaster Depth, class MakeShader,
          Executor E = sequential>
constexpr render_stats draw_triangles(Colour& colour, Depth& depth, const projected_vertices<T>& vertices,
                                      std::span<const triangle_indices> triangles, const screen_mapping<T>& mapping,
                                      const MakeShader& make_shader,
                                      const draw_settings<pixel_of<Colour>>& settings = {}, const E& executor = {}) {
  const triangle_batch<T> batch[1] = {{&vertices, triangles, 0}};
  draw_workspace workspace;
  return draw_batches<Order, T>(
      colour, depth, batch, mapping,
      [&](const triangle_batch<T>&, std::uint32_t i, facing side) { return make_shader(i, side); }, settings, workspace,
      executor);
}

}  // namespace IRG_ABI
}  // namespace irg
