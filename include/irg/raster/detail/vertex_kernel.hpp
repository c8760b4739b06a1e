// SPDX-License-Identifier: MIT
// A range of vertices from the world to the screen, a register of them at a time. Bit for bit what to_screen and
// classify give one by one.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lanes.hpp>
#include <irg/raster/vertex_lanes.hpp>
#include <irg/raster/screen_mapping.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

template <class T>
IRG_INLINE constexpr clip_code_pair project_one(screen_vertex& screen, clip_code_pair& codes, const point<T, 3>& p,
                                                const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping) {
  const hpoint<T, 3> clip = to_clip * p;
  codes = classify(clip, mapping);
  screen = codes.cut == 0 ? to_screen(clip, mapping) : screen_vertex{};
  return codes;
}

// snap() of a number that can be snapped, in every lane; whatever it gives for others is not used.
template <int N>
IRG_INLINE pack<std::int32_t, N> snap_lanes(const pack<float, N>& pixels) noexcept {
  using F = lanes<pack<float, N>>;
  const auto scaled = pixels * F::broadcast(one_pixel);
  // Out of range the conversion is undefined in the language, though not on any machine: keep it in.
  const auto limit = F::broadcast(static_cast<float>(snap_limit) * one_pixel / 2);
  const auto sane = low_of(high_of(scaled, F::broadcast(0) - limit), limit);
  const auto toward_zero = converted<std::int32_t>(sane);
  const auto rest = sane - to_float(toward_zero);
  return toward_zero - (rest >= F::broadcast(0.5f)) + (rest < F::broadcast(-0.5f));
}

// N vertices. The matrix' entries stand broadcast in m, row by row.
template <int N>
IRG_INLINE clip_code_pair project_lanes(screen_vertex* screen, clip_code_pair* codes, const point<float, 3>* p,
                                        const pack<float, N> (&m)[16], const mat<float, 4, 4>& to_clip,
                                        const screen_mapping<float>& mapping) noexcept {
  using pack_f = pack<float, N>;
  using pack_i = pack<std::int32_t, N>;
  using F = lanes<pack_f>;
  using I = lanes<pack_i>;
  static_assert(sizeof *p == 3 * sizeof(float));
  const auto at = load_triples<N>(&p->x);
  const auto row = [&](int r) { return ((m[r] * at.x + m[r + 1] * at.y) + m[r + 2] * at.z) + m[r + 3]; };
  const pack_f cx = row(0), cy = row(4), cz = row(8), cw = row(12), zero = F::broadcast(0);

  const auto beyond = [&](const pack_f& distance, clip_planes plane) {
    const auto bit = I::broadcast(static_cast<std::int32_t>(plane));
    return bit - both(bit, distance >= zero);  // the bit where the distance is negative or NaN
  };
  const auto sides = [&](const pack_f& across, const pack_f& up) {
    return (beyond(across + cx, clip_planes::left) | beyond(across - cx, clip_planes::right)) |
           (beyond(up + cy, clip_planes::bottom) | beyond(up - cy, clip_planes::top));
  };
  const pack_i depth = beyond(cw - cz, clip_planes::z_near) | beyond(cz, clip_planes::z_far);
  const pack_i outside =
      depth | sides(F::broadcast(mapping.picture.guard_x) * cw, F::broadcast(mapping.picture.guard_y) * cw);
  const pack_i cut = depth | sides(F::broadcast(mapping.guard.guard_x) * cw, F::broadcast(mapping.guard.guard_y) * cw);

  // Where 1/w would overflow, one by one.
  const auto subnormal = cw < F::broadcast((std::numeric_limits<float>::min)());
  if (mask_bits(both(subnormal, cut == I::broadcast(0))) != 0) [[unlikely]] {
    clip_code_pair any;
    for (int i = 0; i < N; ++i) any = any | project_one(screen[i], codes[i], p[i], to_clip, mapping);
    return any;
  }
  const pack_f inverse = F::broadcast(1) / cw;
  const pack_f sx = (cx * inverse) * F::broadcast(mapping.half_width) + F::broadcast(mapping.centre_x);
  const pack_f sy = F::broadcast(mapping.centre_y) - (cy * inverse) * F::broadcast(mapping.half_height);
  const auto kept = cut == I::broadcast(0);
  const pack_i snapped_x = both(snap_lanes(sx), kept), snapped_y = both(snap_lanes(sy), kept);
  const pack_f z_screen = select(kept, cz * inverse, zero), w_screen = select(kept, inverse, F::broadcast(1));
  store_vertices<N>(screen, {snapped_x, snapped_y, z_screen, w_screen});
  static_assert(sizeof(clip_code_pair) == 2);
  const pack_i pairs = (outside << byte_shift<2>(0)) | (cut << byte_shift<2>(1));
  lanes<pack<std::uint16_t, N>>::store_bytes(codes, converted<std::uint16_t>(pairs));
  clip_code_pair any;
  if (!all_lanes(pairs == I::broadcast(0)))
    for (int i = 0; i < N; ++i) any = any | codes[i];
  return any;
}

// The vertices [first, last), and the planes that some of them are beyond.
template <class T>
constexpr clip_code_pair project_range(screen_vertex* screen, clip_code_pair* codes, const point<T, 3>* positions,
                                       std::size_t first, std::size_t last, const mat<T, 4, 4>& to_clip,
                                       const screen_mapping<T>& mapping) noexcept {
  clip_code_pair any;
  std::size_t i = first;
  if constexpr (std::same_as<T, float>) {
    if (!std::is_constant_evaluated()) {
      constexpr int count = native_lanes<float>;
      pack<float, count> m[16];
      for (int k = 0; k < 16; ++k) m[k] = lanes<pack<float, count>>::broadcast(to_clip(k / 4, k % 4));
      for (; i + static_cast<std::size_t>(count) <= last; i += static_cast<std::size_t>(count))
        any = any | project_lanes<count>(screen + i, codes + i, positions + i, m, to_clip, mapping);
    }
  }
  for (; i < last; ++i) any = any | project_one(screen[i], codes[i], positions[i], to_clip, mapping);
  return any;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
