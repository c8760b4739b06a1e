// SPDX-License-Identifier: MIT
#include <irg/raster/draw_line.hpp>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("draw_line: writes the line's pixels and no others") {
  constexpr auto sum = [] {
    irg::image<int> image(5, 3);
    irg::draw_line(image, {-2, 0}, {4, 2}, 1);
    int n = 0;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x) n += image(x, y) << (5 * y + x);
    return n;
  };
  CHECK_BOTH(sum() == (0b00111 << 5 | 0b11000 << 10));
}

}  // namespace
