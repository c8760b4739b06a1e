// SPDX-License-Identifier: MIT
#include <irg/fractal/escape_colour.hpp>

#include "support/check_both.hpp"

TEST_CASE("escape_colour: black for what stays, the palette's stops sixteen counts apart") {
  CHECK_BOTH((irg::escape_colour(200, 200) == irg::rgba8{0, 0, 0, 255}));
  CHECK_BOTH((irg::escape_colour(0, 0) == irg::rgba8{0, 0, 0, 255}));
  CHECK_BOTH((irg::escape_colour(0, 200) == irg::rgba8{18, 32, 74, 255}));
  CHECK_BOTH((irg::escape_colour(16, 200) == irg::rgba8{62, 130, 180, 255}));
  CHECK_BOTH((irg::escape_colour(32, 200) == irg::rgba8{238, 240, 230, 255}));
  CHECK_BOTH((irg::escape_colour(48, 200) == irg::rgba8{226, 160, 62, 255}));
  CHECK_BOTH((irg::escape_colour(64, 200) == irg::rgba8{120, 36, 52, 255}));
  CHECK_BOTH((irg::escape_colour(80, 200) == irg::rgba8{18, 32, 74, 255}));
  CHECK_BOTH((irg::escape_colour(8, 200) == irg::rgba8{40, 81, 127, 255}));  // 128/255 of the way
}
