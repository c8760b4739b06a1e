// SPDX-License-Identifier: MIT
// Triangles into a tile: set-up of N triangles at once, coverage and depth of N pixels at once, rejection of whole
// blocks by the depths that are there already.
//
// Each pixel gets the coverage and the depth that draw_triangle gives it, bit for bit, and keeps the nearest triangle,
// of equally near ones the one with the lowest number. So the order in which triangles come does not matter, and what
// is rejected could not have been seen.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <irg/render/detail/tile.hpp>
#include <irg/raster/draw_triangle.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

// Triangles of a tile, ready to be drawn, a lane each. F is taken at the first pixel of the box.
struct tile_triangles {
  static constexpr int most = native_lanes<std::int32_t>;
  std::int32_t f[3][most], right[3][most], down[3][most];
  float gain[3][most], rest[most], low[most], high[most];
  std::int32_t x_first[most], y_first[most], x_last[most], y_last[most];  // within the tile
  std::uint32_t place[most];  // in the tile's list
};

// What the pixels of one triangle share, broadcast.
template <class I>
struct tile_triangle {
  static constexpr int count = lanes<I>::count;
  using floats = pack<float, count>;
  using integer = typename lanes<I>::scalar;
  I ramp[3];  // 0, right, 2 * right, ...
  integer f[3], right[3], down[3];
  floats gain[3], rest, low, high;
  std::uint32_t place;  // in the tile's list
};

// Counts of pixels, lane by lane.
struct tile_counts {
  pack<std::int32_t, native_lanes<std::int32_t>> tested, ties;
};

// How pixels are decided in a tile: by depth, always for the later triangle, or by depth where nobody asks whose it is.
enum class tile_test { nearer, always, depth_only };

// One register of pixels: those covered and nearer than what is there become the triangle's; before(a, b) tells of two
// equally near triangles whether a comes first.
// gives   the keys that are there now
template <tile_test Test, class I, class Before>
IRG_INLINE pack<float, lanes<I>::count> tile_pixels(const tile_triangle<I>& t, const I& f0, const I& f1, const I& f2,
                                                    float* key_at, std::uint32_t* id_at, tile_counts& counts,
                                                    const Before& before) noexcept {
  constexpr int lane_count = lanes<I>::count;
  using F = lanes<pack<float, lane_count>>;
  typedef pack<std::int32_t, lane_count> mask;
  const mask inside = none_negative(f0, f1, f2);
  const auto key =
      depth_at<pack<float, lane_count>>(f0, f1, f2, t.gain[0], t.gain[1], t.gain[2], t.rest, t.low, t.high);
  const auto stored = F::load(key_at);
  const mask covered = both(inside, stored < F::broadcast(beyond_everything));
  mask drawn = covered;
  counts.tested = counts.tested - covered;
  if constexpr (Test == tile_test::depth_only) {
    const auto nearest = select(covered, high_of(key, stored), stored);
    F::store(key_at, nearest);
    return nearest;
  }
  if constexpr (Test == tile_test::nearer) {
    const mask tie = both(covered, key == stored);
    counts.ties = counts.ties - tie;
    drawn = both(covered, stored < key);
    if (mask_bits(tie) != 0) [[unlikely]]
      for (int i = 0; i < lane_count; ++i)
        if (tie.v[i] != 0 && id_at[i] != no_triangle && before(t.place, id_at[i])) drawn.v[i] = -1;
  }
  const auto now = select(drawn, key, stored);
  F::store(key_at, now);
  mask id;
  std::memcpy(&id.v, id_at, sizeof id.v);
  id = select(drawn, lanes<mask>::broadcast(static_cast<std::int32_t>(t.place)), id);
  std::memcpy(id_at, &id.v, sizeof id.v);
  return now;
}

// The rows of a small box, from its first column on.
template <tile_test Test, class I, class Before>
IRG_INLINE void tile_rows(tile& out, const tile_triangle<I>& t, int x_first, int y_first, int x_last, int y_last,
                          tile_counts& all_counts, const Before& before) noexcept {
  tile_counts counts = all_counts;
  constexpr int lane_count = lanes<I>::count;
  using J = lanes<I>;
  for (int x = x_first; x < x_last; x += lane_count) {
    const auto steps = static_cast<typename tile_triangle<I>::integer>(x - x_first);
    I f[3];
    for (int i = 0; i < 3; ++i) f[i] = t.ramp[i] + J::broadcast(t.f[i] + t.right[i] * steps);
    const I down0 = J::broadcast(t.down[0]), down1 = J::broadcast(t.down[1]), down2 = J::broadcast(t.down[2]);
    int at = y_first * tile_stride + x;
    for (int y = y_first; y < y_last; ++y, at += tile_stride) {
      tile_pixels<Test>(t, f[0], f[1], f[2], out.key + at, out.id + at, counts, before);
      f[0] = f[0] + down0;
      f[1] = f[1] + down1;
      f[2] = f[2] + down2;
    }
  }
  all_counts = counts;
}

// A box block by block. Blocks that no edge lets in, or that lie behind what is drawn there, are passed over.
// gives   whether any block was gone into
template <tile_test Test, class I, class Before>
IRG_INLINE bool tile_blocks(tile& out, const tile_triangle<I>& t, int x_first, int y_first, int x_last, int y_last,
                            bool by_depth, tile_counts& all_counts, const Before& before) noexcept {
  tile_counts counts = all_counts;
  constexpr int lane_count = lanes<I>::count;
  using J = lanes<I>;
  using F = lanes<pack<float, lane_count>>;
  using integer = typename tile_triangle<I>::integer;
  const int bx_first = x_first / block_size, bx_last = (x_last - 1) / block_size + 1;
  const int by_first = y_first / block_size, by_last = (y_last - 1) / block_size + 1;
  // F at the first pixel of the tile's first block, and its greatest value in a block relative to that in its corner.
  integer origin[3], reach[3];
  pack<float, lane_count> slope_right = F::broadcast(0), slope_down = F::broadcast(0);
  for (int i = 0; i < 3; ++i) {
    origin[i] = t.f[i] - t.right[i] * static_cast<integer>(x_first) - t.down[i] * static_cast<integer>(y_first);
    reach[i] = (t.right[i] > 0 ? t.right[i] : integer(0)) * (block_size - 1) +
               (t.down[i] > 0 ? t.down[i] : integer(0)) * (block_size - 1);
    slope_right = slope_right + F::broadcast(static_cast<float>(t.right[i])) * t.gain[i];
    slope_down = slope_down + F::broadcast(static_cast<float>(t.down[i])) * t.gain[i];
  }
  const auto zero = F::broadcast(0), last = F::broadcast(block_size - 1);
  const auto rise = high_of(slope_right, zero) * last + high_of(slope_down, zero) * last;
  const auto absolute = [&](const pack<float, lane_count>& v) { return high_of(v, zero - v); };
  bool any = false;
  for (int by = by_first; by < by_last; ++by)
    for (int bx0 = bx_first; bx0 < bx_last; bx0 += lane_count) {
      // N blocks side by side.
      I corner[3];
      const I step = J::ramp();
      for (int i = 0; i < 3; ++i)
        corner[i] = J::broadcast(origin[i] + t.right[i] * static_cast<integer>(bx0 * block_size) +
                                 t.down[i] * static_cast<integer>(by * block_size)) +
                    step * J::broadcast(t.right[i] * block_size);
      auto seen = none_negative(corner[0] + J::broadcast(reach[0]), corner[1] + J::broadcast(reach[1]),
                                corner[2] + J::broadcast(reach[2]));
      if (by_depth) {
        // The nearest that the plane comes within the block, and as much nearer as the rounding of its summands may
        // amount to; no pixel is nearer than the nearest vertex.
        const auto a = to_float(corner[0]) * t.gain[0], b = to_float(corner[1]) * t.gain[1],
                   c = to_float(corner[2]) * t.gain[2];
        const auto size = (absolute(a) + absolute(b)) + (absolute(c) + (absolute(t.rest) + absolute(rise)));
        const auto nearest = ((a + t.rest) + (b + c)) + (rise + size * F::broadcast(0x1p-20f));
        const auto bound = select(t.high < nearest, t.high, nearest);
        pack<float, lane_count> farthest_key;
        for (int i = 0; i < lane_count; ++i)
          farthest_key.v[i] = out.farthest_key[by * blocks_across + lesser(bx0 + i, blocks_across - 1)];
        seen = both(seen, bound >= farthest_key);
      }
      unsigned bits = mask_bits(seen) & ((1u << lesser(bx_last - bx0, lane_count)) - 1);
      for (; bits != 0; bits &= bits - 1) {
        const int k = std::countr_zero(bits), bx = bx0 + k;
        any = true;
        I f[3][static_cast<unsigned>(block_size / lane_count)];
        for (int i = 0; i < 3; ++i)
          for (int part = 0; part < block_size / lane_count; ++part)
            f[i][part] =
                t.ramp[i] + J::broadcast(lane(corner[i], k) + t.right[i] * static_cast<integer>(part * lane_count));
        int at = by * block_size * tile_stride + bx * block_size;
        auto least = F::broadcast(beyond_everything);
        for (int y = 0; y < block_size; ++y, at += tile_stride)
          for (int part = 0; part < block_size / lane_count; ++part) {
            const auto now = tile_pixels<Test>(t, f[0][part], f[1][part], f[2][part], out.key + at + part * lane_count,
                                               out.id + at + part * lane_count, counts, before);
            least = low_of(now, least);
            for (int i = 0; i < 3; ++i) f[i][part] = f[i][part] + J::broadcast(t.down[i]);
          }
        if (by_depth) out.farthest_key[by * blocks_across + bx] = least_of(least);
      }
    }
  all_counts = counts;
  return any;
}

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
