// SPDX-License-Identifier: MIT
#include <irg/raster/window.hpp>

#include <irg/raster/image.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("cell_window: intersection and emptiness") {
  CHECK_BOTH(irg::intersect({0, 0, 4, 4}, {2, -1, 9, 3}) == irg::cell_window{2, 0, 4, 3});
  CHECK_BOTH(irg::intersect({0, 0, 4, 4}, {4, 0, 9, 3}).empty());
  CHECK_BOTH(irg::cell_window{}.empty());
  CHECK_BOTH(irg::cell_window{} == irg::cell_window{0, 0, 0, 0});
  CHECK_BOTH(irg::cell_window{3, 0, 1, 9}.empty());
  CHECK_BOTH(irg::window_of(irg::image<int>(3, 2)) == irg::cell_window{0, 0, 3, 2});
}

}  // namespace
