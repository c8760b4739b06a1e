// SPDX-License-Identifier: MIT
#include <irg/raster/text_style.hpp>

static_assert(irg::text_style{} == irg::text_style{20, 0, 0, irg::text_along::left, irg::text_across::baseline});
static_assert(irg::text_extent{} == irg::text_extent{0, 0, 0});
