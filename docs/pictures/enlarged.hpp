// SPDX-License-Identifier: MIT
// What the documentation's pictures share: colours, pixels shown as squares, dots, one picture on another.
#pragma once

#include <irg/colour/pixel.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>

namespace enlarging {

using picture = irg::image<irg::rgba8>;
inline constexpr irg::rgba8 paper{250, 249, 246, 255}, ink{32, 44, 66, 255}, pale{222, 220, 214, 255};

// Each pixel as a square of `size` pixels, with thin lines between them.
inline picture enlarged(const picture& small, int size) {
  picture big(small.width() * size + 1, small.height() * size + 1, pale);
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x)
      for (int row = 1; row < size; ++row)
        irg::fill_span(big, {y * size + row, x * size + 1, (x + 1) * size}, small(x, y));
  return big;
}

inline void dot(picture& p, irg::cell centre, int radius, irg::rgba8 colour) {
  for (int dy = -radius; dy <= radius; ++dy) {
    int half = 0;
    while ((half + 1) * (half + 1) + dy * dy <= radius * radius + radius) ++half;
    irg::fill_span(p, {centre.y + dy, centre.x - half, centre.x + half + 1}, colour);
  }
}

inline void paste(picture& onto, const picture& p, int left, int top) {
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) onto(left + x, top + y) = p(x, y);
}

}  // namespace enlarging
