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

// snap() of a number that can be snapped, in every lane; whatever it gives for others is not used.
template <class T, int N>
IRG_INLINE pack<std::int32_t, N> snap_lanes(const pack<T, N>& pixels) noexcept {
  using F = lanes<pack<T, N>>;
  const auto scaled = pixels * F::broadcast(T(one_pixel));
  // Out of range the conversion is undefined in the language, though not on any machine: keep it in.
  const auto limit = F::broadcast(static_cast<T>(snap_limit) * T(one_pixel) / 2);
  const auto sane = low_of(high_of(scaled, F::broadcast(0) - limit), limit);
  const auto toward_zero = converted<std::int32_t>(sane);
  const auto rest = sane - converted<T>(toward_zero);
  return toward_zero - converted<std::int32_t>(rest >= F::broadcast(T(0.5))) +
         converted<std::int32_t>(rest < F::broadcast(T(-0.5)));
}

// Vertices on their way: where they come from, and where they go to.
template <class T>
struct vertex_range {
  screen_vertex* screen;
  clip_code_pair* codes;
  const point<T, 3>* positions;
  const mat<T, 4, 4>& to_clip;
  const screen_mapping<T>& mapping;

  constexpr clip_code_pair project_one(std::size_t i) const {
    const hpoint<T, 3> clip = to_clip * positions[i];
    codes[i] = classify(clip, mapping);
    screen[i] = codes[i].cut == 0 ? to_screen(clip, mapping) : screen_vertex{};
    return codes[i];
  }
};

// N vertices from number `first` on. The matrix' entries stand broadcast in m, row by row.
template <int N, class T>
IRG_INLINE clip_code_pair project_lanes(const vertex_range<T>& v, std::size_t first,
                                        const pack<T, N> (&m)[16]) noexcept {
  using F = lanes<pack<T, N>>;
  using pack_i = typename F::mask;
  using J = lanes<pack_i>;
  const screen_mapping<T>& mapping = v.mapping;
  static_assert(sizeof *v.positions == 3 * sizeof(T));
  const auto at = load_triples<N>(&v.positions[first].x);
  const auto row = [&](int r) { return ((m[r] * at.x + m[r + 1] * at.y) + m[r + 2] * at.z) + m[r + 3]; };
  const pack<T, N> cx = row(0), cy = row(4), cz = row(8), cw = row(12), zero = F::broadcast(0);

  const auto beyond = [&](const pack<T, N>& distance, clip_planes plane) {
    const auto bit = J::broadcast(static_cast<int>(plane));
    return bit - both(bit, distance >= zero);  // the bit where the distance is negative or NaN
  };
  const auto sides = [&](const pack<T, N>& across, const pack<T, N>& up) {
    return (beyond(across + cx, clip_planes::left) | beyond(across - cx, clip_planes::right)) |
           (beyond(up + cy, clip_planes::bottom) | beyond(up - cy, clip_planes::top));
  };
  const pack_i depth = beyond(cw - cz, clip_planes::z_near) | beyond(cz, clip_planes::z_far);
  const pack_i outside =
      depth | sides(F::broadcast(mapping.picture.guard_x) * cw, F::broadcast(mapping.picture.guard_y) * cw);
  const pack_i cut = depth | sides(F::broadcast(mapping.guard.guard_x) * cw, F::broadcast(mapping.guard.guard_y) * cw);
  const auto kept = cut == J::broadcast(0);

  // Where 1/w would overflow, one by one.
  clip_code_pair any;
  if (mask_bits(both(cw < F::broadcast((std::numeric_limits<T>::min)()), kept)) != 0) [[unlikely]] {
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) any = any | v.project_one(first + i);
    return any;
  }
  const pack<T, N> inverse = F::broadcast(1) / cw;
  const pack<T, N> sx = (cx * inverse) * F::broadcast(mapping.half_width) + F::broadcast(mapping.centre_x);
  const pack<T, N> sy = F::broadcast(mapping.centre_y) - (cy * inverse) * F::broadcast(mapping.half_height);
  const auto shown = converted<std::int32_t>(kept);
  const pack<T, N> limited = high_of(F::broadcast(T(0x1p-126)), low_of(inverse, F::broadcast(T(0x1p126))));
  const pack<T, N> z_screen = select(kept, cz * inverse, zero), w_screen = select(kept, limited, F::broadcast(1));
  store_vertices<N>(v.screen + first, {both(snap_lanes(sx), shown), both(snap_lanes(sy), shown),
                                       converted<float>(z_screen), converted<float>(w_screen)});
  static_assert(sizeof(clip_code_pair) == 2);
  const pack_i pairs = (outside << byte_shift<2>(0)) | (cut << byte_shift<2>(1));
  lanes<pack<std::uint16_t, N>>::store_bytes(v.codes + first, converted<std::uint16_t>(converted<std::int32_t>(pairs)));
  if (!all_lanes(pairs == J::broadcast(0)))
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) any = any | v.codes[first + i];
  return any;
}

// The vertices [first, last), and the planes that some of them are beyond.
template <class T>
constexpr clip_code_pair project_range(const vertex_range<T>& v, std::size_t first, std::size_t last) noexcept {
  clip_code_pair any;
  constexpr int count = native_lanes<T>;
  if (!std::is_constant_evaluated()) {
    pack<T, count> m[16];
    for (int k = 0; k < 16; ++k) m[k] = lanes<pack<T, count>>::broadcast(v.to_clip(k / 4, k % 4));
    for (; last - first >= static_cast<std::size_t>(count); first += static_cast<std::size_t>(count))
      any = any | project_lanes<count>(v, first, m);
  }
  for (; first < last; ++first) any = any | v.project_one(first);
  return any;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
