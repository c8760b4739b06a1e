// SPDX-License-Identifier: MIT
// The colours of escape counts in a picture.
#pragma once

#include <irg/colour/palette.hpp>

namespace irg {

/// Blue, sand and red, sixteen counts from one to the next.
inline constexpr cyclic_palette<rgba8, 5> escape_palette{
    {{{18, 32, 74, 255}, {62, 130, 180, 255}, {238, 240, 230, 255}, {226, 160, 62, 255}, {120, 36, 52, 255}}}, 16};

inline namespace IRG_ABI {

/// The colour of a count that was made with `most` steps: of escape_palette, black for an orbit that stayed.
[[nodiscard]] constexpr rgba8 escape_colour(int count, int most) noexcept {
  return count < most ? escape_palette(count) : rgba8{0, 0, 0, 255};
}

}  // namespace IRG_ABI
}  // namespace irg
