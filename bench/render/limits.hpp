// SPDX-License-Identifier: MIT
// What memory allows: clearing colour and depth, and depth tests that stream over known pixels.
#pragma once

#include <cstdint>
#include <cstring>

#include <irg/core/lanes.hpp>
#include <irg/raster/image.hpp>

namespace bench {

/// Clears colour and depth to zeros.
inline void clear_both(irg::image<irg::rgba8>& picture, irg::image<float>& depth) {
  const std::size_t bytes = 4 * static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height());
  std::memset(static_cast<void*>(picture.data()), 0, bytes);
  std::memset(static_cast<void*>(depth.data()), 0, bytes);
  asm volatile("" : : "r"(picture.data()), "r"(depth.data()) : "memory");
}

/// Clears, and tests `tests` pixels: load a depth, compare, store depth and colour where nearer. The pixels are those
/// of tiles of 64 KB colour and 64 KB depth, each tile finished before the next, so that they stay in the second cache.
/// Every test finds its pixel nearer, as in a scene that is drawn back to front.
inline void stream_depth_tests(irg::image<irg::rgba8>& picture, irg::image<float>& depth, std::int64_t tests) {
  constexpr std::int64_t tile = 16384;
  constexpr int count = irg::native_lanes<float>;
  using floats = irg::pack<float, count>;
  using integers = irg::pack<std::int32_t, count>;
  const std::int64_t pixels = std::int64_t{picture.width()} * picture.height();
  const double layers = static_cast<double>(tests) / static_cast<double>(pixels);
  auto* const colours = reinterpret_cast<std::int32_t*>(picture.data());
  for (std::int64_t first = 0; first < pixels; first += tile) {
    const std::int64_t n = std::min(tile, pixels - first) / count * count;
    std::memset(colours + first, 0, static_cast<std::size_t>(4 * n));
    std::memset(depth.data() + first, 0, static_cast<std::size_t>(4 * n));
    std::int64_t left = static_cast<std::int64_t>(layers * static_cast<double>(n));
    for (int layer = 1; left > 0; ++layer, left -= n) {
      const auto z = irg::lanes<floats>::broadcast(static_cast<float>(layer));
      const auto colour = irg::lanes<integers>::broadcast(layer);
      const std::int64_t last = first + std::min(left, n) / count * count;
      for (std::int64_t i = first; i < last; i += count) {
        const floats stored = irg::lanes<floats>::load(depth.data() + i);
        const auto nearer = stored < z;
        irg::lanes<floats>::store(depth.data() + i, irg::select(nearer, z, stored));
        irg::lanes<integers>::store(colours + i, irg::select(nearer, colour, irg::lanes<integers>::load(colours + i)));
      }
      asm volatile("" : : "r"(colours), "r"(depth.data()) : "memory");
    }
  }
}

}  // namespace bench
