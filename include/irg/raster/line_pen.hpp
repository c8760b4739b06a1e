// SPDX-License-Identifier: MIT
// What a thick line's user may choose: its width and its ends.
#pragma once

#include <irg/raster/subpixel.hpp>

namespace irg {

/// How a thick line ends.
enum class line_caps {
  butt,  // at its end points, square to its direction
  square,  // half the width further
  round,  // with half a disc around the end point
};

/// What a thick line is drawn with.
struct line_pen {
  std::int32_t width = one_pixel;  // in 1/256 pixel; nothing is drawn when it is not positive
  line_caps caps = line_caps::butt;
  constexpr bool operator==(const line_pen&) const = default;
};

}  // namespace irg
