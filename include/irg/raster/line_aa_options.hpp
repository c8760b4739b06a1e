// SPDX-License-Identifier: MIT
// What the user of an antialiased line may choose.
#pragma once

#include <irg/raster/subpixel.hpp>

namespace irg {

/// How the rectangle of a line ends.
enum class line_aa_caps {
  butt,  // at the end points
  square,  // half a width beyond them
};

/// Lines wider than this, in 1/256 pixel, are not drawn.
inline constexpr std::int32_t max_line_aa_width = 64 * one_pixel;

/// The choices together.
/// units   width in 1/256 pixel
struct line_aa_options {
  std::int32_t width = one_pixel;
  line_aa_caps caps = line_aa_caps::butt;
  constexpr bool operator==(const line_aa_options&) const = default;
};

}  // namespace irg
