// SPDX-License-Identifier: MIT
// Questions to an occlusion mask: from the tiles to the blocks to the pixels, as far as each leaves it undecided.
#pragma once

#include <cstdint>
#include <limits>

#include <irg/geometry/box.hpp>
#include <irg/render/detail/mask_draw_kernel.hpp>

namespace irg {
namespace detail {

// In the order of irg::occlusion.
enum class mask_answer { visible, occluded, outside };

struct mask_query_counts {
  std::int64_t tiles = 0, blocks = 0, pixels = 0;
};

// Where a box is on the screen: the pixels that it could touch, and a key that nothing in it exceeds.
enum class mask_place { on_screen, outside, before_the_eye };
struct mask_rectangle {
  mask_place where = mask_place::outside;
  cell_window pixels;
  float key = 0;
};

inline namespace IRG_ABI {

// Whether anything of the pixels of one block, of key `key`, is in front.
IRG_INLINE constexpr bool seen_in_block(const mask_target& m, const cell_window& w, float key,
                                        mask_query_counts& counts) noexcept {
  for (int y = w.y_first; y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x) {
      ++counts.pixels;
      if (m.pixel(x, y) < key) return true;
    }
  return false;
}

IRG_INLINE constexpr bool seen_in_tile(const mask_target& m, std::size_t tile, const cell_window& w, float key,
                                       mask_query_counts& counts) noexcept {
  ++counts.tiles;
  if (m.touched[tile] == 0) return m.farthest < key;
  if (key <= m.tile_far[tile]) return false;
  for (int by = w.y_first / block_size; by <= (w.y_last - 1) / block_size; ++by)
    for (int bx = w.x_first / block_size; bx <= (w.x_last - 1) / block_size; ++bx) {
      ++counts.blocks;
      if (key <= m.block_far(bx, by)) continue;
      const int x = bx * block_size, y = by * block_size;
      if (seen_in_block(m, intersect(w, {x, y, x + block_size, y + block_size}), key, counts)) return true;
    }
  return false;
}

// What is to be said of a rectangle that has this key everywhere.
constexpr mask_answer test_mask(const mask_target& m, const cell_window& pixels, float key,
                                mask_query_counts& counts) noexcept {
  const cell_window w = intersect(pixels, {0, 0, m.width, m.height});
  if (w.empty()) return mask_answer::outside;
  if (!(key == key)) return mask_answer::visible;
  for (int ty = w.y_first / tile_size; ty <= (w.y_last - 1) / tile_size; ++ty)
    for (int tx = w.x_first / tile_size; tx <= (w.x_last - 1) / tile_size; ++tx) {
      const int x = tx * tile_size, y = ty * tile_size;
      const cell_window part = intersect(w, {x, y, x + tile_size, y + tile_size});
      if (seen_in_tile(m, m.tile_at(tx, ty), part, key, counts)) return mask_answer::visible;
    }
  return mask_answer::occluded;
}

// A number and how far rounding may have taken it from what it stands for.
template <class T>
struct mask_interval {
  T low, high;
};

// The quotients of the numbers of an interval and those of a positive one.
template <class T>
IRG_INLINE constexpr mask_interval<T> divide_interval(const mask_interval<T>& a, const mask_interval<T>& w) noexcept {
  return {a.low / (a.low < T(0) ? w.low : w.high), a.high / (a.high < T(0) ? w.high : w.low)};
}

// A coordinate on the screen in 1/256 pixel, kept near the picture and moved outwards by what projecting and snapping a
// vertex may amount to: half a step, and 2^15 pixels times some roundings of a float.
template <class T>
IRG_INLINE constexpr std::int32_t mask_coordinate(const T& v, int size, std::int32_t outwards) noexcept {
  return snap(clamp(v, T(-1), static_cast<T>(size + 1))) + outwards;
}

// The rectangle of a box. All that lies in the box and is projected by the same matrix in T lands in it.
template <class T>
constexpr mask_rectangle project_box(const box<T, 3>& b, const mat<T, 4, 4>& to_clip, int width, int height,
                                     float sign) noexcept {
  constexpr T unit = std::numeric_limits<T>::epsilon();
  if (b.low.x > b.high.x || b.low.y > b.high.y || b.low.z > b.high.z) return {};
  for (int k = 0; k < 3; ++k)
    if (!(b.low[k] >= std::numeric_limits<T>::lowest() && b.high[k] <= (std::numeric_limits<T>::max)()))
      return {mask_place::before_the_eye, {}, 0};
  // A row's sum has four roundings of half a unit, both here and for what lies in the box.
  const auto absolute = [](const T& v) { return v < T(0) ? -v : v; };
  T slack[4]{};
  for (int r = 0; r < 4; ++r) {
    T sum = absolute(to_clip(r, 3));
    for (int k = 0; k < 3; ++k)
      sum = sum + product(absolute(to_clip(r, k)), greater(absolute(b.low[k]), absolute(b.high[k])));
    slack[r] = product(sum, T(8) * unit);
  }
  const T infinity = std::numeric_limits<T>::infinity();
  mask_interval<T> x{infinity, -infinity}, y = x, z = x;
  bool beyond[6] = {true, true, true, true, true, true}, before = false;
  for (int i = 0; i < 8; ++i) {
    const point<T, 3> corner{(i & 1) != 0 ? b.high.x : b.low.x, (i & 2) != 0 ? b.high.y : b.low.y,
                             (i & 4) != 0 ? b.high.z : b.low.z};
    const hpoint<T, 3> p = to_clip * corner;
    const mask_interval<T> px{p.x - slack[0], p.x + slack[0]}, py{p.y - slack[1], p.y + slack[1]},
        pz{p.z - slack[2], p.z + slack[2]}, pw{p.w - slack[3], p.w + slack[3]};
    const bool behind[6] = {pw.high + px.high < T(0), pw.high - px.low < T(0), pw.high + py.high < T(0),
                            pw.high - py.low < T(0),  pw.high - pz.low < T(0), pz.high < T(0)};
    for (int k = 0; k < 6; ++k) beyond[k] = beyond[k] && behind[k];
    // What the near plane cuts, and what is not a number.
    if (!(pw.low > T(0)) || !(sign > 0 ? pz.low <= pw.high : pz.high >= T(0))) {
      before = true;
      continue;
    }
    const auto widen = [&](mask_interval<T>& all, const mask_interval<T>& v) {
      const mask_interval<T> q = divide_interval(v, pw);
      if (!(q.low >= -infinity && q.high <= infinity)) before = true;
      all = {lesser(all.low, q.low), greater(all.high, q.high)};
    };
    widen(x, px);
    widen(y, py);
    widen(z, pz);
  }
  for (const bool all : beyond)
    if (all) return {};
  if (before) return {mask_place::before_the_eye, {}, 0};

  const T half_width = static_cast<T>(width) / T(2), half_height = static_cast<T>(height) / T(2);
  constexpr std::int32_t outwards = 8;
  const cell_window pixels{first_centre(mask_coordinate(product(x.low, half_width) + half_width, width, -outwards)),
                           first_centre(mask_coordinate(half_height - product(y.high, half_height), height, -outwards)),
                           last_centre(mask_coordinate(product(x.high, half_width) + half_width, width, outwards)),
                           last_centre(mask_coordinate(half_height - product(y.low, half_height), height, outwards))};
  const cell_window seen = intersect(pixels, {0, 0, width, height});
  if (seen.empty()) return {};
  // The nearest depth, and some roundings of T and of a float.
  const float key = product(static_cast<float>(sign > 0 ? z.high : z.low), sign);
  return {mask_place::on_screen, seen, key + (product(key < 0 ? -key : key, 0x1p-20f) + 0x1p-140f)};
}

// Whether a triangle on the screen could be seen.
constexpr mask_answer test_mask_triangle(const mask_target& m, const triangle_corners& c,
                                         mask_query_counts& counts) noexcept {
  const triangle_coverage t = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
  if (t.double_area == 0) return mask_answer::outside;
  const triangle_setup s = set_up_triangle(t, *c.v[0], *c.v[1], *c.v[2]);
  const float nearest = m.sign > 0 ? s.depth_high : -s.depth_low;
  const mask_answer box = test_mask(m, t.bounds, nearest, counts);
  if (box != mask_answer::visible) return box;
  bool any = false, seen = false;
  covered_spans(t, {0, 0, m.width, m.height}, [&](const span_of_cells& span) {
    any = true;
    for (int x = span.x_first; x < span.x_last && !seen; ++x) {
      const float depth =
          depth_at<float>(s.edge[0](x, span.y), s.edge[1](x, span.y), s.edge[2](x, span.y), s.depth_gain[0],
                          s.depth_gain[1], s.depth_gain[2], s.depth_rest, s.depth_low, s.depth_high);
      ++counts.pixels;
      const bool touched = m.touched[m.tile_at(x / tile_size, span.y / tile_size)] != 0;
      seen = (touched ? m.pixel(x, span.y) : m.farthest) < product(depth, m.sign);
    }
  });
  return seen ? mask_answer::visible : any ? mask_answer::occluded : mask_answer::outside;
}

// Whether one of the triangles of a batch could be seen.
template <class T>
constexpr mask_answer test_mask_triangles(const mask_target& m, const triangle_batch<T>& batch,
                                          const screen_mapping<T>& mapping, face_culling culling,
                                          mask_query_counts& counts) {
  const picture_tiles grid(m.width, m.height);
  bin_portion scratch = scratch_portion(grid);
  mask_answer answer = mask_answer::outside;
  for (std::uint32_t i = 0; i < batch.triangles.size() && answer != mask_answer::visible; ++i)
    list_and_draw(scratch, batch, i, mapping, grid, culling, [&](const triangle_corners& c) {
      const mask_answer one = test_mask_triangle(m, c, counts);
      if (one == mask_answer::visible || answer == mask_answer::outside) answer = one;
    });
  return answer;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
