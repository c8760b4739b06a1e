// SPDX-License-Identifier: MIT
// Vertices on the screen, a register of them at a time.
#pragma once

#include <cstdint>

#include <irg/core/interleaved_lanes.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::inline IRG_ABI {

static_assert(sizeof(screen_vertex) == 16);  // x, y, depth, 1/w

/// N vertices, a lane each.
template <int N>
struct vertex_lanes {
  pack<std::int32_t, N> x, y;
  pack<float, N> depth, inverse_w;
};

/// The vertices screen[index(i)], i the lane.
template <int N, class Index>
[[nodiscard]] IRG_INLINE vertex_lanes<N> load_vertices(const screen_vertex* screen, const Index& index) noexcept {
  const auto [x, y, z, w] = load_quadruples<N>([&](int i) { return screen + index(i); });
  return {bits_as<std::int32_t>(x), bits_as<std::int32_t>(y), z, w};
}

/// The reverse: N vertices from `to` on.
template <int N>
IRG_INLINE void store_vertices(screen_vertex* to, const vertex_lanes<N>& v) noexcept {
  store_quadruples<N>(to, {bits_as<float>(v.x), bits_as<float>(v.y), v.depth, v.inverse_w});
}

}  // namespace irg::inline IRG_ABI
