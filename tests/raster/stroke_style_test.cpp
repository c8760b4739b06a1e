// SPDX-License-Identifier: MIT
#include <irg/raster/stroke_style.hpp>

static_assert(irg::stroke_style{} ==
              irg::stroke_style{1, irg::stroke_joins::round, irg::line_caps::butt, 4, irg::polyline_shape::open});
static_assert(irg::stroke_style{.width = 2} != irg::stroke_style{});
