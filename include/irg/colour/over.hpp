// SPDX-License-Identifier: MIT
// A pixel of some opacity over another one: glass before a wall.
#pragma once

#include <irg/colour/mix.hpp>
#include <irg/colour/srgb.hpp>

namespace irg {

/// `above` over `below`, mixed as light: what is seen through glass, a grid too fine to see, or a veil.
/// gives   below for an `above` of opacity 0, above for 255; opacities as Porter's and Duff's "over" has them, not
///         multiplied into the colours
/// exact   the share of `above` rounded once; each channel within 3 roundings of floats, then the nearest code; opacity
///         the nearest integer
/// source  Porter and Duff 1984
struct over_in_light {
  IRG_INLINE constexpr rgba8 operator()(const rgba8& below, const rgba8& above) const noexcept {
    if (above.a == 0) return below;
    if (above.a == 255) return above;
    const unsigned mine = 255u * above.a, all = mine + below.a * (255u - above.a);
    const float share = static_cast<float>(mine) / static_cast<float>(all);
    const rgb<float> b = decode(below), a = decode(above);
    return encode({b.r + product(a.r - b.r, share), b.g + product(a.g - b.g, share), b.b + product(a.b - b.b, share)},
                  mix(below.a, 255, above.a));
  }
};

/// `above` over `below`, mixed as encoded: what most programs show, darker than light would be.
/// needs   an opaque `below`
/// exact   the nearest integers
struct over_as_encoded {
  IRG_INLINE constexpr rgba8 operator()(const rgba8& below, const rgba8& above) const noexcept {
    return mix(below, rgba8{above.r, above.g, above.b, 255}, above.a);
  }
};

}  // namespace irg
