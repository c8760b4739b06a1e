// SPDX-License-Identifier: MIT
#include <irg/raster/line_aa_options.hpp>

#include "support/check_both.hpp"

namespace {

TEST_CASE("line_aa_options: one pixel wide, ends cut at the points") {
  CHECK_BOTH(irg::line_aa_options{} == irg::line_aa_options{.width = 256, .caps = irg::line_aa_caps::butt});
  CHECK_BOTH(irg::line_aa_options{.width = 128} != irg::line_aa_options{});
}

}  // namespace
