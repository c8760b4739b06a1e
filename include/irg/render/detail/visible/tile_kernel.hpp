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

#include <irg/render/detail/visible/tile.hpp>
#include <irg/raster/draw_triangle.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// Triangles of a tile, ready to be drawn, a lane each. F is taken at the first pixel of the box.
struct tile_triangles {
  static constexpr int most = native_lanes<std::int32_t>;
  std::int32_t f[3][most], right[3][most], down[3][most];
  float gain[3][most], rest[most], low[most], high[most];
  std::int32_t x_first[most], y_first[most], x_last[most], y_last[most];  // within the tile
  std::uint32_t place[most];  // in the tile's list
};

// What the pixels of one triangle share, broadcast.
template <class J>
struct tile_triangle {
  static constexpr int count = lanes<J>::count;
  using floats = pack<float, count>;
  using integer = typename lanes<J>::scalar;
  J ramp[3];  // 0, right, 2 * right, ...
  integer f[3], right[3], down[3];
  floats gain[3], rest, low, high;
  std::uint32_t place;  // in the tile's list
};

// Counts of pixels, lane by lane.
struct tile_counts {
  pack<std::int32_t, native_lanes<std::int32_t>> tested, ties;
};

// Where a register of pixels stands in the tile.
struct pixels_of_tile {
  float* key;
  std::uint32_t* id;
};

// What is counted, and before(a, b): whether of two triangles as near as each other a comes first.
template <class Before>
struct tile_ties {
  tile_counts& counts;
  const Before& before;
};

// One register of pixels: those covered and nearer than what is there become the triangle's. Where it is exactly as
// near, `tied` is set and the pixel kept: see tied_pixels.
// gives   the keys that are there now
template <tile_test Test, class J>
IRG_INLINE pack<float, lanes<J>::count> tile_pixels(const tile_triangle<J>& t, const J (&f)[3],
                                                    const pixels_of_tile& at, tile_counts& counts,
                                                    pack<std::int32_t, lanes<J>::count>& tied) noexcept {
  constexpr int lane_count = lanes<J>::count;
  using F = lanes<pack<float, lane_count>>;
  typedef pack<std::int32_t, lane_count> mask;
  const mask inside = none_negative(f[0], f[1], f[2]);
  const auto key = depth_at<pack<float, lane_count>>(f, t);
  const auto stored = F::load(at.key);
  const mask covered = both(inside, stored < F::broadcast(beyond_everything));
  mask drawn = covered;
  counts.tested = counts.tested - covered;
  if constexpr (Test == tile_test::depth_only) {
    const auto nearest = select(covered, high_of(key, stored), stored);
    F::store(at.key, nearest);
    return nearest;
  }
  if constexpr (Test == tile_test::nearer) {
    tied = tied | both(covered, key == stored);
    drawn = both(covered, stored < key);
  }
  const auto now = select(drawn, key, stored);
  F::store(at.key, now);
  const mask place = lanes<mask>::broadcast(static_cast<std::int32_t>(t.place));
  lanes<mask>::store_bytes(at.id, select(drawn, place, lanes<mask>::load_bytes(at.id)));
  return now;
}

// The pixels of a register that tile_pixels found tied: the triangle's if before(a, b) says of it and the other that it
// comes first. Keys stay as they are.
template <class J, class Before>
IRG_INLINE void tied_pixels(const tile_triangle<J>& t, const J (&f)[3], const pixels_of_tile& at, tile_counts& counts,
                            const Before& before) noexcept {
  constexpr int lane_count = lanes<J>::count;
  using F = lanes<pack<float, lane_count>>;
  typedef pack<std::int32_t, lane_count> mask;
  const auto key = depth_at<pack<float, lane_count>>(f, t);
  const auto stored = F::load(at.key);
  const mask covered = both(none_negative(f[0], f[1], f[2]), stored < F::broadcast(beyond_everything));
  mask tie = both(covered, key == stored);
  for (int i = 0; i < lane_count; ++i)
    if (at.id[i] == t.place) set_lane(tie, i, 0);  // drawn just now
  counts.ties = counts.ties - tie;
  for (int i = 0; i < lane_count; ++i)
    if (tie[i] != 0 && at.id[i] != no_face && before(t.place, at.id[i])) at.id[i] = t.place;
}

// The rows of a box, from its first column on; `steps` are taken to the right, each of a register.
template <tile_test Test, class J, class Before>
IRG_INLINE void tile_rows(tile& out, const tile_triangle<J>& t, const cell_window& box,
                          const tile_ties<Before>& ties) noexcept {
  tile_counts counts = ties.counts;
  constexpr int lane_count = lanes<J>::count;
  using K = lanes<J>;
  using mask = pack<std::int32_t, lane_count>;
  const auto for_each_register = [&](const auto& pixels) {
    for (int x = box.x_first; x < box.x_last; x += lane_count) {
      const auto steps = static_cast<typename tile_triangle<J>::integer>(x - box.x_first);
      J f[3];
      for (int i = 0; i < 3; ++i) f[i] = t.ramp[i] + K::broadcast(t.f[i] + t.right[i] * steps);
      const J down0 = K::broadcast(t.down[0]), down1 = K::broadcast(t.down[1]), down2 = K::broadcast(t.down[2]);
      int at = box.y_first * tile_stride + x;
      for (int y = box.y_first; y < box.y_last; ++y, at += tile_stride) {
        pixels(f, at);
        f[0] = f[0] + down0;
        f[1] = f[1] + down1;
        f[2] = f[2] + down2;
      }
    }
  };
  mask tied = lanes<mask>::broadcast(0);
  for_each_register(
      [&](const J(&f)[3], int at) { tile_pixels<Test>(t, f, {out.key + at, out.id + at}, counts, tied); });
  if (Test == tile_test::nearer && mask_bits(tied) != 0) [[unlikely]]
    for_each_register(
        [&](const J(&f)[3], int at) { tied_pixels(t, f, {out.key + at, out.id + at}, counts, ties.before); });
  ties.counts = counts;
}

// The blocks of a box that the edges let in and, `by_depth`, whose pixels are not all nearer than the triangle: a bit
// each.
template <class J>
IRG_INLINE std::uint64_t blocks_to_draw(const tile& out, const tile_triangle<J>& t, const cell_window& box,
                                        bool by_depth) noexcept {
  constexpr int lane_count = lanes<J>::count, chunks = blocks_across / lane_count;
  using K = lanes<J>;
  using F = lanes<pack<float, lane_count>>;
  using integer = typename tile_triangle<J>::integer;
  const int bx_first = box.x_first / block_size, bx_last = (box.x_last - 1) / block_size + 1;
  const int by_first = box.y_first / block_size, by_last = (box.y_last - 1) / block_size + 1;
  const auto zero = F::broadcast(0), last = F::broadcast(block_size - 1);
  const auto absolute = [&](const pack<float, lane_count>& v) { return high_of(v, zero - v); };
  const auto across = F::broadcast(static_cast<float>((bx_last - bx_first) * block_size)),
             along = F::broadcast(static_cast<float>((by_last - by_first) * block_size));
  // The greatest F in each block of a row; and the depth at the first block's first pixel, and its slopes.
  J greatest[static_cast<unsigned>(chunks)][3], down[3];
  pack<float, lane_count> start[3], slope_right = zero, slope_down = zero, size = absolute(t.rest);
  for (int i = 0; i < 3; ++i) {
    const integer corner = t.f[i] + t.right[i] * static_cast<integer>(bx_first * block_size - box.x_first) +
                           t.down[i] * static_cast<integer>(by_first * block_size - box.y_first);
    const integer reach = (t.right[i] > 0 ? t.right[i] : integer(0)) * (block_size - 1) +
                          (t.down[i] > 0 ? t.down[i] : integer(0)) * (block_size - 1);
    const integer first = corner + reach - t.right[i] * static_cast<integer>(bx_first * block_size);
    const J step = K::ramp() * K::broadcast(t.right[i] * block_size);
    for (int c = 0; c < chunks; ++c)
      greatest[c][i] = K::broadcast(first + t.right[i] * static_cast<integer>(c * lane_count * block_size)) + step;
    down[i] = K::broadcast(t.down[i] * block_size);
    const auto gain_right = F::broadcast(static_cast<float>(t.right[i])) * t.gain[i],
               gain_down = F::broadcast(static_cast<float>(t.down[i])) * t.gain[i];
    start[i] = F::broadcast(static_cast<float>(corner)) * t.gain[i];
    slope_right = slope_right + gain_right;
    slope_down = slope_down + gain_down;
    size = size + (absolute(start[i]) + (absolute(gain_right) * across + absolute(gain_down) * along));
  }
  // The nearest that the plane comes within a block, and as much nearer as rounding may amount to, here and where a
  // pixel's depth is reckoned. Of subnormal numbers each product loses up to 2^-150, those of slopes times the pixels
  // of a tile: less than 2^-140 together.
  const auto rise = high_of(slope_right, zero) * last + high_of(slope_down, zero) * last;
  const auto nearest_first = ((start[0] + t.rest) + (start[1] + start[2])) +
                             (rise + (size * F::broadcast(0x1p-18f) + F::broadcast(0x1p-140f)));
  pack<float, lane_count> nearest[static_cast<unsigned>(chunks)];
  for (int c = 0; c < chunks; ++c)
    nearest[c] =
        nearest_first + slope_right * ((F::ramp() + F::broadcast(static_cast<float>(c * lane_count - bx_first))) *
                                       F::broadcast(block_size));
  const auto nearest_down = slope_down * F::broadcast(block_size);
  std::uint64_t blocks = 0;
  for (int by = by_first; by < by_last; ++by)
    for (int c = 0; c < chunks; ++c) {
      auto seen = none_negative(greatest[c][0], greatest[c][1], greatest[c][2]);
      const int block = by * blocks_across + c * lane_count;
      if (by_depth)  // no pixel is nearer than the nearest vertex, nor farther than the farthest one
        seen = both(seen, low_of(t.high, high_of(t.low, nearest[c])) >= F::load(out.farthest_key + block));
      blocks |= std::uint64_t{mask_bits(seen)} << block;
      for (int i = 0; i < 3; ++i) greatest[c][i] = greatest[c][i] + down[i];
      nearest[c] = nearest[c] + nearest_down;
    }
  const std::uint64_t row = ((1u << bx_last) - 1) & ~((1u << bx_first) - 1);
  return blocks & (row * 0x0101010101010101u);
}

// A box block by block. Blocks that no edge lets in, or that lie behind what is drawn there, are passed over.
// gives   whether any block was gone into
template <tile_test Test, class J, class Before>
IRG_INLINE bool tile_blocks(tile& out, const tile_triangle<J>& t, const cell_window& box, const tile_ties<Before>& ties,
                            bool by_depth) noexcept {
  const std::uint64_t blocks = blocks_to_draw(out, t, box, by_depth);
  if (blocks == 0) return false;
  tile_counts counts = ties.counts;
  constexpr int lane_count = lanes<J>::count, parts = block_size / lane_count;
  using K = lanes<J>;
  using F = lanes<pack<float, lane_count>>;
  using integer = typename tile_triangle<J>::integer;
  using mask = pack<std::int32_t, lane_count>;
  const J down[3] = {K::broadcast(t.down[0]), K::broadcast(t.down[1]), K::broadcast(t.down[2])};
  const auto for_each_register = [&](int bx, int by, const auto& pixels) {
    J f[static_cast<unsigned>(parts)][3];
    for (int i = 0; i < 3; ++i)
      for (int part = 0; part < parts; ++part)
        f[part][i] =
            t.ramp[i] +
            K::broadcast(t.f[i] + t.right[i] * static_cast<integer>(bx * block_size + part * lane_count - box.x_first) +
                         t.down[i] * static_cast<integer>(by * block_size - box.y_first));
    int at = by * block_size * tile_stride + bx * block_size;
    for (int y = 0; y < block_size; ++y, at += tile_stride)
      for (int part = 0; part < parts; ++part) {
        pixels(f[part], at + part * lane_count);
        for (int i = 0; i < 3; ++i) f[part][i] = f[part][i] + down[i];
      }
  };
  for (std::uint64_t bits = blocks; bits != 0; bits &= bits - 1) {
    const int block = std::countr_zero(bits), bx = block % blocks_across, by = block / blocks_across;
    auto least = F::broadcast(beyond_everything);
    mask tied = lanes<mask>::broadcast(0);
    for_each_register(bx, by, [&](const J(&f)[3], int at) {
      least = low_of(tile_pixels<Test>(t, f, {out.key + at, out.id + at}, counts, tied), least);
    });
    if (Test == tile_test::nearer && mask_bits(tied) != 0) [[unlikely]]
      for_each_register(
          bx, by, [&](const J(&f)[3], int at) { tied_pixels(t, f, {out.key + at, out.id + at}, counts, ties.before); });
    if (by_depth) out.farthest_key[block] = least_of(least);
  }
  ties.counts = counts;
  return true;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
