// SPDX-License-Identifier: MIT
// A tile's list with nearer triangles first, so that what lies behind them can be passed over.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/render/detail/visible/tile_kernel.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The numbers of a list, roughly from the nearest triangle to the farthest: sorted by 8 bits of the greatest key.
template <class T>
std::vector<std::uint32_t> front_to_back(std::span<const std::uint32_t> numbers, const triangle_finder<T>& find,
                                         float sign) {
  constexpr int count = tile_triangles::most;
  using F = lanes<pack<float, count>>;
  const std::size_t size = numbers.size();
  std::vector<float> key(size + count);
  auto least = F::broadcast(beyond_everything), greatest = F::broadcast(-beyond_everything);
  for (std::size_t i = 0; i < size; i += count) {
    corner_lanes<count> c;
    c.collect(find, numbers.data() + i, static_cast<int>(lesser(size - i, std::size_t{count})));
    const auto of = [&](int k) { return c.depth[k] * F::broadcast(sign); };
    const auto nearest = high_of(high_of(of(0), of(1)), of(2));
    F::store(key.data() + i, nearest);
    least = low_of(nearest, least);
    greatest = high_of(nearest, greatest);
  }
  const float front = -least_of(F::broadcast(0.0f) - greatest), range = front - least_of(least);
  const float scale = 0.0f < range ? 255.0f / range : 0.0f;
  std::vector<std::uint8_t> bucket(size);
  std::uint32_t start[257] = {};
  for (std::size_t i = 0; i < size; ++i) {
    bucket[i] = static_cast<std::uint8_t>(clamp((front - key[i]) * scale, 0.0f, 255.0f));
    ++start[bucket[i] + 1];
  }
  for (int b = 0; b < 256; ++b) start[b + 1] += start[b];
  std::vector<std::uint32_t> sorted(size);
  for (std::size_t i = 0; i < size; ++i) sorted[start[bucket[i]]++] = numbers[i];
  return sorted;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
