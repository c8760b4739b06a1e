// SPDX-License-Identifier: MIT
// Triangles into a tile: set-up of N triangles at once, coverage and depth of N pixels at once, rejection of whole
// blocks by the depths that are there already.
//
// Each pixel gets the coverage and the depth that shade_triangle gives it, bit for bit, and keeps the nearest triangle,
// of equally near ones the one with the lowest number. Depths are compared as they were rounded where that is sure to
// give the order of the exact ones; where it is not, the pixel is `close`, and decided apart, exactly. So the order in
// which triangles come does not matter, and what is rejected could not have been seen.
//
// The pixel's key is that of the triangle that is seen, which may be less than what was there before by as much as
// rounding may amount to. A key that no pixel lies behind is one still: the triangles that are seen only come nearer.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/render/detail/visible/tile.hpp>
#include <irg/raster/draw_triangle.hpp>

namespace irg::detail::inline IRG_ABI {

// How a tile's list is drawn.
struct tile_order {
  float sign;  // of keys
  bool front_to_back;  // nearer ones first, and with rejection by depth
};

// Triangles of a tile, ready to be drawn, a lane each. F is taken at the first pixel of the box.
struct tile_triangles {
  std::int32_t f[3][tile_lanes], right[3][tile_lanes], down[3][tile_lanes];
  float gain[3][tile_lanes], rest[tile_lanes], low[tile_lanes], high[tile_lanes], slack[tile_lanes];
  std::int32_t x_first[tile_lanes], y_first[tile_lanes], x_last[tile_lanes], y_last[tile_lanes];  // within the tile
  std::uint32_t place[tile_lanes];  // in the tile's list
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
  floats slack, minus_slack;  // keys that differ by more are in the order of the exact depths: see slack_of
  std::uint32_t place;  // in the tile's list
};

// By how much the key of a triangle has to differ from another so that the order of both is that of the exact depths.
// `largest` is the size of the triangle's keys.
//
// A key errs by 8 roundings of 2^-24 at most (see depth_at), less than 2^-21 (1 + 2^-15) of its size: all its terms
// have one sign. Of two keys of which the farther is less than half as large again as `largest`, both errors together
// are less than 2^-19 of `largest`; where it is larger, they differ by a third of it. Of subnormal numbers each product
// loses up to 2^-126, times edge functions below 2^53: less than 2^-72 in all. Where the depths of a triangle have both
// signs, terms cancel, and its keys err by as much of the largest: whoever meets it needs its slack, too.
template <class F>
IRG_INLINE F slack_of(const F& largest) noexcept {
  return largest * lanes<F>::broadcast(0x1p-19f) + lanes<F>::broadcast(0x1p-60f);
}

// Counts of pixels, lane by lane.
struct tile_counts {
  tile_integers tested, ties;
};

// Where a register of pixels stands in the tile.
struct pixels_of_tile {
  float* key;
  std::uint32_t* id;
};

// What drawing a triangle leaves to be done: in a window, or in blocks, a bit each. `close` has pixels whose keys are
// too close to tell, `beside` such as lie beside the picture, and were counted all the same.
struct tile_rest {
  std::uint64_t close = 0, beside = 0;
  cell_window window{};  // empty: in blocks

  IRG_INLINE bool any() const noexcept { return (close | beside) != 0; }
  // part(window) for what the bits stand for.
  template <class Part>
  IRG_INLINE void for_each(std::uint64_t bits, const Part& part) const noexcept {
    if (!window.empty() && bits != 0) return part(window);
    for (; bits != 0; bits &= bits - 1) {
      const int block = std::countr_zero(bits), x = block % blocks_across * block_size,
                y = block / blocks_across * block_size;
      part(cell_window{x, y, x + block_size, y + block_size});
    }
  }
};

// One register of pixels: those covered and nearer than what is there become the triangle's. Where keys are too close
// to tell, `close` is set and the pixel kept: see close_pixels. Pixels beside the picture are counted, too: see
// uncount_beside.
template <tile_test Test, class J>
IRG_INLINE void tile_pixels(const tile_triangle<J>& t, const J (&f)[3], const pixels_of_tile& at,
                            pack<std::int32_t, lanes<J>::count>& tested,
                            pack<std::int32_t, lanes<J>::count>& close) noexcept {
  constexpr int lane_count = lanes<J>::count;
  using F = lanes<pack<float, lane_count>>;
  typedef pack<std::int32_t, lane_count> mask;
  const mask inside = none_negative(f[0], f[1], f[2]);
  const auto key = depth_at<pack<float, lane_count>>(f, t);
  const auto stored = F::load(at.key);
  mask drawn = inside;
  if constexpr (Test != tile_test::nearer) drawn = both(inside, stored < F::broadcast(beyond_everything));
  tested = tested - drawn;
  if constexpr (Test == tile_test::depth_only) return F::store(at.key, select(drawn, maximum(key, stored), stored));
  if constexpr (Test == tile_test::nearer) {
    const auto ahead = key - stored;  // beside the picture infinitely far behind
    drawn = both(inside, t.slack < ahead);
    close = close | (both(inside, t.minus_slack <= ahead) ^ drawn);
  }
  F::store(at.key, select(drawn, key, stored));
  const mask place = lanes<mask>::broadcast(static_cast<std::int32_t>(t.place));
  lanes<mask>::store_bytes(at.id, select(drawn, place, lanes<mask>::load_bytes(at.id)));
}

// pixels(f, at) for the registers of `part`; `box` begins with the pixel that F of the triangle is taken at.
template <class J, class Pixels>
IRG_INLINE void for_each_register(const tile_triangle<J>& t, const cell_window& box, const cell_window& part,
                                  const Pixels& pixels) noexcept {
  using K = lanes<J>;
  using integer = typename tile_triangle<J>::integer;
  for (int y = part.y_first; y < part.y_last; ++y)
    for (int x = part.x_first; x < part.x_last; x += K::count) {
      J f[3];
      for (int i = 0; i < 3; ++i)
        f[i] = t.ramp[i] + K::broadcast(t.f[i] + t.right[i] * static_cast<integer>(x - box.x_first) +
                                        t.down[i] * static_cast<integer>(y - box.y_first));
      pixels(f, y * tile_stride + x);
    }
}

// The pixels of a part that tile_pixels may have found close: decide(key, at) for each.
template <class J, class Decide>
IRG_INLINE void close_pixels(const tile& out, const tile_triangle<J>& t, const cell_window& box,
                             const cell_window& part, const Decide& decide) noexcept {
  constexpr int lane_count = lanes<J>::count;
  using F = lanes<pack<float, lane_count>>;
  typedef pack<std::int32_t, lane_count> mask;
  for_each_register(t, box, part, [&](const J(&f)[3], int at) {
    const auto key = depth_at<pack<float, lane_count>>(f, t);
    const auto ahead = key - F::load(out.key + at);
    mask close = both(none_negative(f[0], f[1], f[2]), both(ahead <= t.slack, t.minus_slack <= ahead));
    for (int i = 0; i < lane_count; ++i)
      if (out.id[at + i] == t.place) set_lane(close, i, 0);  // drawn just now
    for (int i = 0; i < lane_count; ++i)
      if (close[i] != 0) decide(key[i], at + i);
  });
}

// Takes back that pixels beside the picture were counted as tested.
template <class J>
IRG_INLINE void uncount_beside(const tile& out, const tile_triangle<J>& t, const cell_window& box,
                               const cell_window& part, tile_counts& counts) noexcept {
  using F = lanes<pack<float, lanes<J>::count>>;
  for_each_register(t, box, part, [&](const J(&f)[3], int at) {
    counts.tested =
        counts.tested + both(none_negative(f[0], f[1], f[2]), F::load(out.key + at) == F::broadcast(beyond_everything));
  });
}

// The rows of a box, a column of registers after the other. Where it ends with the tile the registers do, too, if the
// tile is wide enough: the triangle does not cover what they begin with.
template <tile_test Test, class J>
IRG_INLINE tile_rest tile_rows(tile& out, const tile_triangle<J>& t, const cell_window& box,
                               tile_counts& counts) noexcept {
  constexpr int lane_count = lanes<J>::count;
  using K = lanes<J>;
  using mask = pack<std::int32_t, lane_count>;
  mask tested = counts.tested, close = lanes<mask>::broadcast(0);
  int x_first = box.x_first;
  if (Test == tile_test::nearer && box.x_last == out.width) [[unlikely]]
    x_first = maximum(out.width - (out.width - x_first + (lane_count - 1)) / lane_count * lane_count, 0);
  for (int x = x_first; x < box.x_last; x += lane_count) {
    const auto steps = static_cast<typename tile_triangle<J>::integer>(x - box.x_first);
    J f[3];
    for (int i = 0; i < 3; ++i) f[i] = t.ramp[i] + K::broadcast(t.f[i] + t.right[i] * steps);
    const J down0 = K::broadcast(t.down[0]), down1 = K::broadcast(t.down[1]), down2 = K::broadcast(t.down[2]);
    int at = box.y_first * tile_stride + x;
    for (int rows = box.y_last - box.y_first; rows > 0; --rows, at += tile_stride) {
      tile_pixels<Test>(t, f, {out.key + at, out.id + at}, tested, close);
      f[0] = f[0] + down0;
      f[1] = f[1] + down1;
      f[2] = f[2] + down2;
    }
  }
  counts.tested = tested;
  tile_rest rest{mask_bits(close), 0, {x_first, box.y_first, box.x_last, box.y_last}};
  if (Test == tile_test::nearer && box.x_last == out.width) [[unlikely]]
    rest.beside = (out.width - x_first) % lane_count != 0 ? 1 : 0;
  return rest;
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
  const auto absolute = [&](const pack<float, lane_count>& v) { return maximum(v, zero - v); };
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
  // The nearest that the plane comes within a block, and as much nearer as rounding may amount to, here and where the
  // keys of pixels are computed. Of subnormal numbers each product loses up to 2^-150, those of slopes times the pixels
  // of a tile: less than 2^-140 together, and slack is more.
  const auto rise = maximum(slope_right, zero) * last + maximum(slope_down, zero) * last;
  const auto nearest_first =
      ((start[0] + t.rest) + (start[1] + start[2])) + (rise + (size * F::broadcast(0x1p-18f) + t.slack));
  pack<float, lane_count> nearest[static_cast<unsigned>(chunks)];
  for (int c = 0; c < chunks; ++c)
    nearest[c] =
        nearest_first + slope_right * ((F::ramp() + F::broadcast(static_cast<float>(c * lane_count - bx_first))) *
                                       F::broadcast(block_size));
  const auto nearest_down = slope_down * F::broadcast(block_size), high = t.high + t.slack, low = t.low + t.slack;
  std::uint64_t blocks = 0;
  for (int by = by_first; by < by_last; ++by)
    for (int c = 0; c < chunks; ++c) {
      auto seen = none_negative(greatest[c][0], greatest[c][1], greatest[c][2]);
      const int block = by * blocks_across + c * lane_count;
      if (by_depth)  // no pixel is nearer than the nearest vertex, nor farther than the farthest one
        seen = both(seen, minimum(high, maximum(low, nearest[c])) >= F::load(out.farthest_key + block));
      blocks |= std::uint64_t{mask_bits(seen)} << block;
      for (int i = 0; i < 3; ++i) greatest[c][i] = greatest[c][i] + down[i];
      nearest[c] = nearest[c] + nearest_down;
    }
  const std::uint64_t row = ((1u << bx_last) - 1) & ~((1u << bx_first) - 1);
  return blocks & (row * 0x0101010101010101u);
}

// Blocks of a tile that a box meets, a bit each.
struct blocks_of_box {
  const cell_window& box;
  std::uint64_t bits;
};

// These blocks, one after the other.
template <tile_test Test, class J>
IRG_INLINE tile_rest tile_blocks(tile& out, const tile_triangle<J>& t, const blocks_of_box& blocks, tile_counts& counts,
                                 bool by_depth) noexcept {
  constexpr int lane_count = lanes<J>::count, parts = block_size / lane_count;
  using K = lanes<J>;
  using integer = typename tile_triangle<J>::integer;
  using mask = pack<std::int32_t, lane_count>;
  const J down[3] = {K::broadcast(t.down[0]), K::broadcast(t.down[1]), K::broadcast(t.down[2])};
  mask tested = counts.tested;
  tile_rest rest;
  for (std::uint64_t bits = blocks.bits; bits != 0; bits &= bits - 1) {
    const int block = std::countr_zero(bits), bx = block % blocks_across, by = block / blocks_across;
    mask close = lanes<mask>::broadcast(0);
    J f[static_cast<unsigned>(parts)][3];
    for (int i = 0; i < 3; ++i)
      for (int part = 0; part < parts; ++part)
        f[part][i] =
            t.ramp[i] +
            K::broadcast(t.f[i] +
                         t.right[i] * static_cast<integer>(bx * block_size + part * lane_count - blocks.box.x_first) +
                         t.down[i] * static_cast<integer>(by * block_size - blocks.box.y_first));
    int at = by * block_size * tile_stride + bx * block_size;
    for (int y = 0; y < block_size; ++y, at += tile_stride)
      for (int part = 0; part < parts; ++part) {
        const int here = at + part * lane_count;
        tile_pixels<Test>(t, f[part], {out.key + here, out.id + here}, tested, close);
        for (int i = 0; i < 3; ++i) f[part][i] = f[part][i] + down[i];
      }
    if (by_depth) out.farthest_key[block] = farthest_of_block(out, block);
    if (Test == tile_test::nearer && mask_bits(close) != 0) [[unlikely]]
      rest.close |= std::uint64_t{1} << block;
  }
  counts.tested = tested;
  if (Test == tile_test::nearer && out.width % block_size != 0) [[unlikely]]
    rest.beside |= blocks.bits & std::uint64_t{0x0101010101010101u} << out.width / block_size;
  if (Test == tile_test::nearer && out.height % block_size != 0) [[unlikely]]
    rest.beside |= blocks.bits & std::uint64_t{0xff} << out.height / block_size * blocks_across;
  return rest;
}

}  // namespace irg::detail::inline IRG_ABI
