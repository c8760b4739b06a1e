// SPDX-License-Identifier: MIT
#include <irg/raster/line_pen.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("line_pen: one pixel wide with butt caps unless asked otherwise") {
  CHECK_BOTH(irg::line_pen{} == irg::line_pen{.width = 256, .caps = irg::line_caps::butt});
  CHECK_BOTH(irg::line_pen{} != irg::line_pen{.caps = irg::line_caps::round});
}

}  // namespace
