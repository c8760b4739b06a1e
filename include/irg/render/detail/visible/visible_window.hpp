// SPDX-License-Identifier: MIT
// What a window of the picture shows, before it has colours: for each pixel the triangle that is seen there, and its
// depth. Hidden-surface methods end here, and shading begins.
#pragma once

#include <cstdint>
#include <span>

#include <irg/core/sinks.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>

namespace irg::detail {

// The pixels of a window, at most tile_size a side, in rows of tile_stride.
struct visible_window {
  const std::uint32_t* place;  // of the triangle or piece, in `numbers`; no_index where nothing is seen
  const float* key;  // of the depth that is there; infinite beside the window
  float sign;  // of keys
  std::span<const std::uint32_t> numbers;
  cell_window window;
};

// What becomes of what tiles show: colours, numbers, nothing. A virtual call for each tile, so that what finds them is
// compiled once for all.
template <class T>
struct tile_finish {
  virtual constexpr void clear(const cell_window& w) const = 0;  // where no triangle is
  // Returns how many pixels show a triangle.
  virtual constexpr std::int64_t operator()(const visible_window& v, const triangle_finder<T>& find) const = 0;

protected:
  constexpr ~tile_finish() = default;
};

}  // namespace irg::detail
