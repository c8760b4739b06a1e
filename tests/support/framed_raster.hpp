// SPDX-License-Identifier: MIT
// A view into the middle of a larger memory, to see whether drawing stays within it.
#pragma once

#include <cstddef>
#include <vector>

#include <irg/raster/image.hpp>

namespace test {

/// 10 x 7 pixels with 10 between rows, and with rows before and behind; all memory is 9 at first.
template <class P>
struct framed_raster {
  static constexpr int stride = 20, rows = 12, left = 3, top = 2, width = 10, height = 7;

  std::vector<P> memory = std::vector<P>(stride * rows, P(9));
  irg::image_view<P> view{memory.data() + top * stride + left, width, height, stride * sizeof(P)};

  framed_raster() = default;
  framed_raster(const framed_raster&) = delete;
  framed_raster& operator=(const framed_raster&) = delete;

  /// Whether nothing around the view has changed.
  bool frame_is_whole() const { return count_changed(false) == 0; }
  /// How many pixels of the view are no longer 9.
  int painted() const { return count_changed(true); }

  int count_changed(bool in_view) const {
    int n = 0;
    for (std::size_t i = 0; i < memory.size(); ++i) {
      const int x = static_cast<int>(i) % stride - left, y = static_cast<int>(i) / stride - top;
      const bool in = x >= 0 && x < width && y >= 0 && y < height;
      n += in == in_view && memory[i] != P(9);
    }
    return n;
  }
};

}  // namespace test
