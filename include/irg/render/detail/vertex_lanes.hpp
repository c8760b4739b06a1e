// SPDX-License-Identifier: MIT
// Vertices anywhere in memory, read whole and turned into lanes: one load each, where gathering words takes four.
#pragma once

#include <cstdint>
#include <cstring>

#include <irg/core/lanes.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/draw_triangle.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

static_assert(sizeof(screen_vertex) == 16);  // x, y, depth, 1/w

// N vertices, a lane each.
template <int N>
struct vertex_lanes {
  pack<std::int32_t, N> x, y;
  pack<float, N> depth, inverse_w;
};

// The vertices screen[index(i)], i the lane.
template <int N, class Index>
IRG_INLINE vertex_lanes<N> load_vertices(const screen_vertex* screen, const Index& index) noexcept {
#if __has_builtin(__builtin_shufflevector)
  typedef float four __attribute__((vector_size(16)));
  const auto row = [&](int i) {
    four words;
    std::memcpy(&words, screen + index(i), sizeof words);
    return words;
  };
  using integers = typename pack<std::int32_t, N>::storage;
  if constexpr (N == 4) {
    const four r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const four xy01 = __builtin_shufflevector(r0, r1, 0, 4, 1, 5), xy23 = __builtin_shufflevector(r2, r3, 0, 4, 1, 5),
               zw01 = __builtin_shufflevector(r0, r1, 2, 6, 3, 7), zw23 = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
    return {{reinterpret_cast<integers>(__builtin_shufflevector(xy01, xy23, 0, 1, 4, 5))},
            {reinterpret_cast<integers>(__builtin_shufflevector(xy01, xy23, 2, 3, 6, 7))},
            {__builtin_shufflevector(zw01, zw23, 0, 1, 4, 5)},
            {__builtin_shufflevector(zw01, zw23, 2, 3, 6, 7)}};
  }
  if constexpr (N == 8) {
    // Lanes i and i + 4 in the two halves of a register, so that no word has to cross over later.
    const auto rows = [&](int i) { return __builtin_shufflevector(row(i), row(i + 4), 0, 1, 2, 3, 4, 5, 6, 7); };
    const auto r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
    const auto xy01 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13),
               xy23 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13),
               zw01 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15),
               zw23 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
    return {{reinterpret_cast<integers>(__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13))},
            {reinterpret_cast<integers>(__builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15))},
            {__builtin_shufflevector(zw01, zw23, 0, 1, 8, 9, 4, 5, 12, 13)},
            {__builtin_shufflevector(zw01, zw23, 2, 3, 10, 11, 6, 7, 14, 15)}};
  }
#endif
  vertex_lanes<N> v;
  for (int i = 0; i < N; ++i) {
    const screen_vertex& from = screen[index(i)];
    v.x.v[i] = from.position.x;
    v.y.v[i] = from.position.y;
    v.depth.v[i] = from.depth;
    v.inverse_w.v[i] = from.inverse_w;
  }
  return v;
}

// The reverse: N vertices from `to` on.
template <int N>
IRG_INLINE void store_vertices(screen_vertex* to, const vertex_lanes<N>& v) noexcept {
#if __has_builtin(__builtin_shufflevector)
  using floats = typename pack<float, N>::storage;
  const floats x = reinterpret_cast<floats>(v.x.v), y = reinterpret_cast<floats>(v.y.v);
  const floats z = v.depth.v, w = v.inverse_w.v;
  if constexpr (N == 4) {
    const floats xy01 = __builtin_shufflevector(x, y, 0, 4, 1, 5), xy23 = __builtin_shufflevector(x, y, 2, 6, 3, 7),
                 zw01 = __builtin_shufflevector(z, w, 0, 4, 1, 5), zw23 = __builtin_shufflevector(z, w, 2, 6, 3, 7);
    const floats rows[4] = {
        __builtin_shufflevector(xy01, zw01, 0, 1, 4, 5), __builtin_shufflevector(xy01, zw01, 2, 3, 6, 7),
        __builtin_shufflevector(xy23, zw23, 0, 1, 4, 5), __builtin_shufflevector(xy23, zw23, 2, 3, 6, 7)};
    std::memcpy(static_cast<void*>(to), rows, sizeof rows);
    return;
  }
  if constexpr (N == 8) {
    const floats xy01 = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13),
                 xy23 = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15),
                 zw01 = __builtin_shufflevector(z, w, 0, 8, 1, 9, 4, 12, 5, 13),
                 zw23 = __builtin_shufflevector(z, w, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto store = [&](int i, const floats& rows) {  // vertices i and i + 4
      std::memcpy(static_cast<void*>(to + i), &rows, sizeof *to);
      std::memcpy(static_cast<void*>(to + i + 4), reinterpret_cast<const char*>(&rows) + sizeof *to, sizeof *to);
    };
    store(0, __builtin_shufflevector(xy01, zw01, 0, 1, 8, 9, 4, 5, 12, 13));
    store(1, __builtin_shufflevector(xy01, zw01, 2, 3, 10, 11, 6, 7, 14, 15));
    store(2, __builtin_shufflevector(xy23, zw23, 0, 1, 8, 9, 4, 5, 12, 13));
    store(3, __builtin_shufflevector(xy23, zw23, 2, 3, 10, 11, 6, 7, 14, 15));
    return;
  }
#endif
  for (int i = 0; i < N; ++i) to[i] = {{v.x.v[i], v.y.v[i]}, v.depth.v[i], v.inverse_w.v[i]};
}

#endif

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
