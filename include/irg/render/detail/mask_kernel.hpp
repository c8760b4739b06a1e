// SPDX-License-Identifier: MIT
// Triangles into an occlusion mask: exact coverage, and depths that are never nearer than those that drawing gives.
//
// The greatest key counts, so triangles may come in any order; small ones are set up N at a time and go in at once,
// without lists. The mask is kept in strips of 64 columns, so that a small triangle rarely meets a border; each strip
// is made of tiles of 64 rows, and what no triangle has touched is not even cleared.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/render/detail/tile_drawing.hpp>

namespace irg {
namespace detail {

// The memory of a mask.
struct mask_target {
  int width, height, across, down;  // in pixels and in tiles
  float sign, farthest;  // of keys, as in tile.hpp
  float* key;  // strips of 64 * down rows of tile_stride
  float* far;  // 64 blocks for each tile: a key that no pixel of it lies behind
  float* tile_far;
  std::uint64_t* stale;  // the blocks of each tile of which `far` is not known
  std::uint8_t* touched;  // by tile

  IRG_INLINE constexpr std::size_t tile_at(int tx, int ty) const noexcept {
    return static_cast<std::size_t>(tx) * static_cast<std::size_t>(down) + static_cast<std::size_t>(ty);
  }
  IRG_INLINE constexpr float* pixel(int x, int y) const noexcept {
    const auto row = static_cast<std::size_t>(x / tile_size) * static_cast<std::size_t>(down * tile_size) +
                     static_cast<std::size_t>(y);
    return key + row * tile_stride + x % tile_size;
  }
  IRG_INLINE constexpr float& block_far(int bx, int by) const noexcept {
    return far[tile_at(bx / blocks_across, by / blocks_across) * 64 +
               static_cast<std::size_t>(by % blocks_across * blocks_across + bx % blocks_across)];
  }
};

inline namespace IRG_ABI {

// What the pixels beyond the picture hold: they never count as the farthest.
inline constexpr float mask_outside = std::numeric_limits<float>::infinity();

// A tile's pixels before the first triangle.
constexpr void clear_mask_tile(const mask_target& m, int tx, int ty) noexcept {
  const int x0 = tx * tile_size, y0 = ty * tile_size;
  const int width = lesser(m.width - x0, tile_size), height = lesser(m.height - y0, tile_size);
  float* row = m.pixel(x0, y0);
  if (width == tile_size && height == tile_size) {
    for (int i = 0; i < tile_size * tile_stride; ++i) row[i] = m.farthest;
  } else {
    for (int y = 0; y < tile_size; ++y, row += tile_stride)
      for (int x = 0; x < tile_stride; ++x) row[x] = x < width && y < height ? m.farthest : mask_outside;
  }
  const std::size_t tile = m.tile_at(tx, ty);
  for (int b = 0; b < 64; ++b)
    m.far[tile * 64 + static_cast<std::size_t>(b)] =
        b % blocks_across * block_size < width && b / blocks_across * block_size < height ? m.farthest : mask_outside;
  m.tile_far[tile] = m.farthest;
  m.stale[tile] = 0;
  m.touched[tile] = 1;
}
IRG_INLINE constexpr void touch_mask_tile(const mask_target& m, int tx, int ty) noexcept {
  if (m.touched[m.tile_at(tx, ty)] == 0) [[unlikely]]
    clear_mask_tile(m, tx, ty);
}

// A plane of keys, lowered by what rounding may amount to, here and in draw_triangle: the key of a pixel is
// (base + right * X) + down * Y, and `low` at least, with (X, Y) counted from vertex 0 in 1/256 pixel. A covered pixel's
// key is not above what draw_triangle gives. The order of operations is fixed, so all paths have the same bits.
template <class F>
struct mask_plane {
  F base, right, down, low, high;

  IRG_INLINE constexpr F key(const F& across, const F& y) const noexcept {
    return high_of(across + product(down, y), low);
  }
  IRG_INLINE constexpr F across(const F& x) const noexcept { return base + product(right, x); }
};

// The plane through the vertices 0, (x1, y1), (x2, y2) with their keys; `area` is x1 * y2 - y1 * x2, and no covered
// centre is farther from vertex 0 than `width` and `height`.
template <class F>
IRG_INLINE constexpr mask_plane<F> make_mask_plane(const F& x1, const F& y1, const F& x2, const F& y2, const F& area,
                                                   const F& width, const F& height, const F (&key)[3]) noexcept {
  using f = lanes<F>;
  const F inverse = f::broadcast(1.0f) / area, zero = f::broadcast(0.0f);
  const auto absolute = [&](const F& v) { return high_of(v, zero - v); };
  const F k1 = key[1] - key[0], k2 = key[2] - key[0];
  const F a = product(k1, y2), b = product(k2, y1), c = product(k2, x1), d = product(k1, x2);
  const F size_right = product(absolute(a) + absolute(b), absolute(inverse)),
          size_down = product(absolute(c) + absolute(d), absolute(inverse));
  const F size = (product(size_right, width) + product(size_down, height)) +
                 high_of(high_of(absolute(key[0]), absolute(key[1])), absolute(key[2]));
  // Each path from vertices to a key takes less than 12 roundings of 2^-24, and draw_triangle's errs by 8 of them.
  const F bias = product(size, f::broadcast(0x1p-19f)) + f::broadcast(0x1p-140f);
  return {key[0] - bias, product(a - b, inverse), product(c - d, inverse), low_of(low_of(key[0], key[1]), key[2]),
          high_of(high_of(key[0], key[1]), key[2])};
}

// The plane of one triangle.
IRG_INLINE constexpr mask_plane<float> mask_plane_of(const screen_vertex& a, const screen_vertex& b,
                                                     const screen_vertex& c, float sign) noexcept {
  const subpixel &p = a.position, &q = b.position, &r = c.position;
  const float key[3] = {product(a.depth, sign), product(b.depth, sign), product(c.depth, sign)};
  const auto number = [](std::int64_t i) { return static_cast<float>(i); };
  return make_mask_plane<float>(number(q.x - p.x), number(q.y - p.y), number(r.x - p.x), number(r.y - p.y),
                                number(signed_double_area(p, q, r)),
                                number(greater(greater(p.x, q.x), r.x) - lesser(lesser(p.x, q.x), r.x)),
                                number(greater(greater(p.y, q.y), r.y) - lesser(lesser(p.y, q.y), r.y)), key);
}

// From a vertex to the centre of a pixel, in 1/256 pixel; exact.
IRG_INLINE constexpr float mask_offset(int pixel, std::int32_t vertex) noexcept {
  return static_cast<float>(pixel * one_pixel + half_pixel - vertex);
}

// One triangle, pixel by pixel: what the fast way has to equal.
constexpr void draw_mask_plainly(const mask_target& m, const screen_vertex& a, const screen_vertex& b,
                                 const screen_vertex& c, const cell_window& window) {
  const triangle_coverage coverage = cover_triangle(a.position, b.position, c.position);
  if (coverage.double_area == 0) return;
  const mask_plane<float> plane = mask_plane_of(a, b, c, m.sign);
  covered_spans(coverage, window, [&](const span_of_cells& span) {
    for (int x = span.x_first; x < span.x_last; ++x) {
      touch_mask_tile(m, x / tile_size, span.y / tile_size);
      float& stored = *m.pixel(x, span.y);
      stored =
          high_of(plane.key(plane.across(mask_offset(x, a.position.x)), mask_offset(span.y, a.position.y)), stored);
      m.stale[m.tile_at(x / tile_size, span.y / tile_size)] |=
          std::uint64_t{1} << (span.y % tile_size / block_size * blocks_across + x % tile_size / block_size);
    }
  });
}

// The farthest key of a block.
IRG_INLINE constexpr float mask_block_least(const float* row) noexcept {
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated()) {
    using F = lanes<pack<float, tile_lanes>>;
    auto least = F::load(row);
    for (int r = 0; r < block_size; ++r, row += tile_stride)
      for (int k = 0; k < block_size; k += tile_lanes) least = low_of(F::load(row + k), least);
    return least_of(least);
  }
#endif
  float least = *row;
  for (int r = 0; r < block_size; ++r, row += tile_stride)
    for (int k = 0; k < block_size; ++k) least = lesser(row[k], least);
  return least;
}

// Makes the farthest keys of all blocks of a tile, and of the tile, known.
IRG_INLINE constexpr void finish_mask_tile(const mask_target& m, int tx, int ty) noexcept {
  const std::size_t tile = m.tile_at(tx, ty);
  if (m.touched[tile] == 0) return;
  float* far = m.far + tile * 64;
  for (std::uint64_t stale = m.stale[tile]; stale != 0; stale &= stale - 1) {
    const int b = std::countr_zero(stale);
    far[b] = mask_block_least(
        m.pixel(tx * tile_size + b % blocks_across * block_size, ty * tile_size + b / blocks_across * block_size));
  }
  m.stale[tile] = 0;
  float least = far[0];
  for (int b = 1; b < 64; ++b) least = lesser(far[b], least);
  m.tile_far[tile] = least;
}

#ifdef IRG_LANES_VECTOR

// Small triangles, ready to be drawn, a lane each. F is taken at the first pixel of the box.
struct mask_group {
  static constexpr int most = native_lanes<std::int32_t>;
  std::int32_t f[3][most], right[3][most], down[3][most], x[most], y[most];
  float base[most], plane_right[most], plane_down[most], low[most];
  std::int32_t x_first[most], y_first[most], x_last[most], y_last[most];
};

struct mask_painter {
  static constexpr int count = mask_group::most;
  using integers = pack<std::int32_t, count>;
  using floats = pack<float, count>;
  static constexpr int small = 2 * block_size;  // boxes up to this size are drawn row by row

  const mask_target& m;
  cell_window window;
  triangle_corners queue[count];
  int queued = 0;

  // The positions and keys of one vertex of each triangle in the queue.
  IRG_INLINE void gather(int k, integers& x, integers& y, floats& key) const noexcept {
    for (int i = 0; i < count; ++i) {
      const screen_vertex& v = *queue[i].v[k];
      x.v[i] = v.position.x;
      y.v[i] = v.position.y;
      key.v[i] = v.depth;
    }
    key = key * lanes<floats>::broadcast(m.sign);
  }

  IRG_INLINE void set_up(mask_group& g) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    integers x[3], y[3];
    floats key[3];
    for (int k = 0; k < 3; ++k) gather(k, x[k], y[k], key[k]);
    const integers left = low_of(low_of(x[0], x[1]), x[2]), right = high_of(high_of(x[0], x[1]), x[2]);
    const integers top = low_of(low_of(y[0], y[1]), y[2]), bottom = high_of(high_of(y[0], y[1]), y[2]);
    const integers zero = I::broadcast(0), one = I::broadcast(1);
    const integers before = I::broadcast(half_pixel - 1), behind = I::broadcast(one_pixel - half_pixel);
    const integers x_first = high_of({(left + before).v >> subpixel_bits}, I::broadcast(window.x_first)),
                   x_last = low_of({(right + behind).v >> subpixel_bits}, I::broadcast(window.x_last)),
                   y_first = high_of({(top + before).v >> subpixel_bits}, I::broadcast(window.y_first)),
                   y_last = low_of({(bottom + behind).v >> subpixel_bits}, I::broadcast(window.y_last));
    I::store(g.x_first, x_first);
    I::store(g.x_last, x_last);
    I::store(g.y_first, y_first);
    I::store(g.y_last, y_last);
    I::store(g.x, x[0]);
    I::store(g.y, y[0]);

    const integers area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const integers flip = area < zero;
    const auto turned = [&](const integers& v) { return integers{(v.v ^ flip.v) - flip.v}; };
    const integers centre_x = x_first * I::broadcast(one_pixel) + I::broadcast(half_pixel),
                   centre_y = y_first * I::broadcast(one_pixel) + I::broadcast(half_pixel);
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      const integers dx = turned(x[q] - x[p]), dy = turned(y[q] - y[p]);
      const integers e = dx * (centre_y - y[p]) - dy * (centre_x - x[p]);
      const integers owns = (dy < zero) | both(dy == zero, zero < dx);
      I::store(g.f[k], {((e - one) - owns).v >> subpixel_bits});
      I::store(g.right[k], zero - dy);
      I::store(g.down[k], dx);
    }
    const auto plane = make_mask_plane<floats>(to_float(x[1] - x[0]), to_float(y[1] - y[0]), to_float(x[2] - x[0]),
                                               to_float(y[2] - y[0]), to_float(area), to_float(right - left),
                                               to_float(bottom - top), key);
    F::store(g.base, plane.base);
    F::store(g.plane_right, plane.right);
    F::store(g.plane_down, plane.down);
    F::store(g.low, plane.low);
  }

  // Where a box touches the tiles of a strip: tiles cleared if need be, blocks not known any longer.
  IRG_INLINE void mark(int strip, int x_first, int x_last, int y_first, int y_last) const noexcept {
    const int bx_first = x_first % tile_size / block_size, bx_last = (x_last - 1) % tile_size / block_size;
    const std::uint64_t columns = ((std::uint64_t{2} << bx_last) - (std::uint64_t{1} << bx_first));
    for (int by = y_first / block_size; by <= (y_last - 1) / block_size; ++by) {
      const int ty = by / blocks_across;
      touch_mask_tile(m, strip, ty);
      m.stale[m.tile_at(strip, ty)] |= columns << (by % blocks_across * blocks_across);
    }
  }

  // Triangle i of a group, row by row.
  IRG_INLINE void draw_small(const mask_group& g, int i) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    const int x_first = g.x_first[i], x_end = g.x_last[i], y_first = g.y_first[i], y_last = g.y_last[i];
    const mask_plane<floats> plane{F::broadcast(g.base[i]),
                                   F::broadcast(g.plane_right[i]),
                                   F::broadcast(g.plane_down[i]),
                                   F::broadcast(g.low[i]),
                                   {}};
    const integers ramp = I::ramp();
    const auto row_y = F::broadcast(mask_offset(y_first, g.y[i])), step = F::broadcast(one_pixel);
    const integers down[3] = {I::broadcast(g.down[0][i]), I::broadcast(g.down[1][i]), I::broadcast(g.down[2][i])};
    for (int x = x_first; x < x_end;) {
      const int strip = x / tile_size, x_last = lesser(x_end, (strip + 1) * tile_size);
      mark(strip, x, x_last, y_first, y_last);
      for (; x < x_last; x += count) {
        integers f[3];
        for (int k = 0; k < 3; ++k)
          f[k] = I::broadcast(g.f[k][i]) + (ramp + I::broadcast(x - x_first)) * I::broadcast(g.right[k][i]);
        const floats across =
            plane.across(to_float(ramp * I::broadcast(one_pixel) + I::broadcast(x * one_pixel + half_pixel - g.x[i])));
        float* at = m.pixel(x, y_first);
        floats y = row_y;
        for (int rows = y_last - y_first; rows > 0; --rows, at += tile_stride) {
          const auto stored = F::load(at);
          F::store(at, select((f[0] | f[1] | f[2]) < I::broadcast(0), stored, high_of(plane.key(across, y), stored)));
          for (int k = 0; k < 3; ++k) f[k] = f[k] + down[k];
          y = y + step;
        }
      }
      x = x_last;
    }
  }

  IRG_NOINLINE void flush() noexcept {
    if (queued == 0) return;
    for (int i = queued; i < count; ++i) queue[i] = queue[0];
    mask_group g;
    set_up(g);
    for (int i = 0; i < queued; ++i)
      if (g.x_first[i] < g.x_last[i] && g.y_first[i] < g.y_last[i]) draw_small(g, i);
    queued = 0;
  }

  // A triangle with sides below 2^15 and a small box, which is not empty.
  IRG_INLINE void add_small(const triangle_corners& c) noexcept {
    queue[queued++] = c;
    if (queued == count) flush();
  }

  // Any triangle, block by block. Blocks that no edge lets in, or that it lies behind, are passed over.
  IRG_NOINLINE void draw_large(const triangle_corners& c) const noexcept {
    const triangle_coverage t = cover_triangle(c.v[0]->position, c.v[1]->position, c.v[2]->position);
    const cell_window w = intersect(t.bounds, window);
    if (t.double_area == 0 || w.empty()) return;
    const mask_plane<float> plane = mask_plane_of(*c.v[0], *c.v[1], *c.v[2], m.sign);
    for (int tx = w.x_first / tile_size; tx <= (w.x_last - 1) / tile_size; ++tx)
      for (int ty = w.y_first / tile_size; ty <= (w.y_last - 1) / tile_size; ++ty) {
        const int x = tx * tile_size, y = ty * tile_size;
        draw_tile(t, plane, c.v[0]->position, tx, ty, intersect(w, {x, y, x + tile_size, y + tile_size}));
      }
  }

  IRG_INLINE void draw_tile(const triangle_coverage& t, const mask_plane<float>& plane, const subpixel& origin, int tx,
                            int ty, const cell_window& w) const noexcept {
    const std::size_t tile = m.tile_at(tx, ty);
    for (int by = w.y_first / block_size; by <= (w.y_last - 1) / block_size; ++by)
      for (int bx = w.x_first / block_size; bx <= (w.x_last - 1) / block_size; ++bx) {
        // An edge that runs through the block has values of 29 bits there at most; the others need not be known.
        const int x = bx * block_size, y = by * block_size;
        std::int32_t f[3], right[3], down[3];
        bool outside = false, inside = true;
        for (int k = 0; k < 3; ++k) {
          const triangle_edge& e = t.edge[k];
          const std::int64_t corner = e(x, y);
          const std::int64_t across = std::int64_t{e.right} * (block_size - 1),
                             along = std::int64_t{e.down} * (block_size - 1);
          const std::int64_t low = corner + lesser(across, std::int64_t{0}) + lesser(along, std::int64_t{0});
          const std::int64_t high = corner + greater(across, std::int64_t{0}) + greater(along, std::int64_t{0});
          outside = outside || high < 0;
          const bool cuts = low < 0 && high >= 0;
          inside = inside && low >= 0;
          f[k] = cuts ? static_cast<std::int32_t>(corner) : 0;
          right[k] = cuts ? e.right : 0;
          down[k] = cuts ? e.down : 0;
        }
        if (outside) continue;
        touch_mask_tile(m, tx, ty);
        const std::uint64_t bit = std::uint64_t{1} << (by % blocks_across * blocks_across + bx % blocks_across);
        float& far = m.block_far(bx, by);
        // Rounding never turns the order of keys round: the greatest is in a corner of the block.
        const float nearest = plane.key(plane.across(mask_offset(x + (plane.right > 0 ? block_size - 1 : 0), origin.x)),
                                        mask_offset(y + (plane.down > 0 ? block_size - 1 : 0), origin.y));
        if ((m.stale[tile] & bit) == 0 && nearest <= far) continue;
        far = inside ? draw_block<true>(f, right, down, plane, origin, x, y)
                     : draw_block<false>(f, right, down, plane, origin, x, y);
        m.stale[tile] &= ~bit;
      }
  }

  // The pixels of a block.
  // gives   the farthest key that is there now
  template <bool Inside>
  IRG_INLINE float draw_block(const std::int32_t (&f)[3], const std::int32_t (&right)[3], const std::int32_t (&down)[3],
                              const mask_plane<float>& p, const subpixel& origin, int x, int y) const noexcept {
    using I = lanes<integers>;
    using F = lanes<floats>;
    constexpr auto parts = static_cast<unsigned>(block_size / count);
    const mask_plane<floats> plane{
        F::broadcast(p.base), F::broadcast(p.right), F::broadcast(p.down), F::broadcast(p.low), {}};
    auto least = F::broadcast(mask_outside);
    for (unsigned part = 0; part < parts; ++part) {
      const int x_part = x + static_cast<int>(part) * count;
      const floats across = plane.across(
          to_float(I::ramp() * I::broadcast(one_pixel) + I::broadcast(x_part * one_pixel + half_pixel - origin.x)));
      integers e[3];
      for (int k = 0; k < 3; ++k)
        e[k] = I::broadcast(f[k]) + (I::ramp() + I::broadcast(x_part - x)) * I::broadcast(right[k]);
      auto row_y = F::broadcast(mask_offset(y, origin.y));
      float* at = m.pixel(x_part, y);
      for (int row = 0; row < block_size; ++row, at += tile_stride) {
        const auto stored = F::load(at);
        auto now = high_of(plane.key(across, row_y), stored);
        if constexpr (!Inside) {
          now = select((e[0] | e[1] | e[2]) < I::broadcast(0), stored, now);
          for (int k = 0; k < 3; ++k) e[k] = e[k] + I::broadcast(down[k]);
        }
        F::store(at, now);
        least = low_of(now, least);
        row_y = row_y + F::broadcast(one_pixel);
      }
    }
    return least_of(least);
  }

  // A triangle of any size.
  IRG_INLINE void add(const triangle_corners& c) noexcept {
    const subpixel &p = c.v[0]->position, &q = c.v[1]->position, &r = c.v[2]->position;
    constexpr int limit = small * one_pixel;
    if (greater(greater(p.x, q.x), r.x) - lesser(lesser(p.x, q.x), r.x) < limit &&
        greater(greater(p.y, q.y), r.y) - lesser(lesser(p.y, q.y), r.y) < limit)
      add_small(c);
    else
      draw_large(c);
  }
};

#endif

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
  scratch.entries.clear();
  scratch.pieces.clear();
  list_one(scratch, batch, i, i, mapping, grid, culling, skip_options{});
  for (const clipped_piece& p : scratch.pieces) draw(triangle_corners{{&p.v[0], &p.v[1], &p.v[2]}});
  if (!scratch.pieces.empty() || scratch.entries.empty()) return;
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
  bin_portion scratch;
  scratch.tile_count.assign(grid.count(), 0);
  scratch.tile_area.assign(grid.count(), 0.0f);
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated()) {
    mask_painter painter{m, window, {}};
    constexpr std::uint32_t count = native_lanes<std::int32_t>;
    const cull_kernel<static_cast<int>(count)> kernel{batch.vertices->screen.data(), batch.vertices->codes.data(),
                                                      batch.vertices->any, window, culling};
    const screen_vertex* screen = batch.vertices->screen.data();
    // Pieces do not outlive their triangle, so they are not queued.
    const auto one = [&](std::uint32_t i) {
      list_and_draw(scratch, batch, i, mapping, grid, culling,
                    [&](const triangle_corners& c) { painter.draw_large(c); });
    };
    std::uint32_t i = 0;
    mask_draw_result result;
    for (; i + count <= n; i += count) {
      const auto group = kernel(batch.triangles.data() + i, skip_options{});
      result.skipped += group.skipped;
      result.listed += std::popcount(group.listed);
      for (unsigned bits = group.listed | group.special; bits != 0; bits &= bits - 1) {
        const auto k = static_cast<std::uint32_t>(std::countr_zero(bits));
        if ((group.special >> k & 1) != 0) {
          one(i + k);
          continue;
        }
        const auto& [v] = batch.triangles[i + k];
        painter.add({{screen + v[0], screen + v[1], screen + v[2]}});
      }
    }
    for (; i < n; ++i) one(i);
    painter.flush();
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
    mask_painter painter{m, window, {}};
    for (const std::uint32_t number : numbers) painter.add(find.corners(number));
    return painter.flush();
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
    executor(grid.count(), [&](std::size_t i) {
      const std::span<const std::uint32_t> numbers(bins.numbers.data() + bins.tile_first[i],
                                                   bins.tile_first[i + 1] - bins.tile_first[i]);
      draw_mask_tile(m, numbers, find, grid.window(i));
    });
    result = {bins.skipped, bins.listed};
  }
  for (int tx = 0; tx < m.across; ++tx)
    for (int ty = 0; ty < m.down; ++ty) finish_mask_tile(m, tx, ty);
  return result;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
