// SPDX-License-Identifier: MIT
#include <irg/raster/screen_vertex.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("screen_vertex: an affine picture unless told otherwise") {
  CHECK_BOTH(irg::screen_vertex{}.position == irg::subpixel{0, 0});
  CHECK_BOTH(irg::screen_vertex{}.depth == 0.0f);
  CHECK_BOTH(irg::screen_vertex{{1, 2}, 0.5f}.inverse_w == 1.0f);
}

}  // namespace
