// SPDX-License-Identifier: MIT
// The part of a line that can be snapped, so that lines may end anywhere.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::detail::inline IRG_ABI {

// The line from a to b within snap_limit, snapped; `finite` tells whether its ends are numbers, `in_reach` whether a
// part of it is within.
struct snapped_line {
  bool finite = true, in_reach = true;
  subpixel from{}, to{};
};

// A position in pixels.
template <ScreenPosition P>
IRG_INLINE constexpr point<double, 2> in_pixels(const P& p) noexcept {
  if constexpr (std::same_as<P, subpixel>)
    return {p.x * (1.0 / one_pixel), p.y * (1.0 / one_pixel)};
  else if constexpr (CellOrPosition<P>)
    return {as_cell(p).x + 0.5, as_cell(p).y + 0.5};
  else
    return {widened(coordinate(p, 0)), widened(coordinate(p, 1))};
}

// exact   an end beyond the reach is moved to where the line enters it, correctly rounded, then snapped: between the
//         new ends the line is at most 1/512 pixel aside on each axis
template <ScreenPosition P>
constexpr snapped_line snap_line(const P& a, const P& b) noexcept {
  if (can_snap(a) && can_snap(b)) return {true, true, snap(a), snap(b)};
  const point<double, 2> from = in_pixels(a), to = in_pixels(b);
  if (!is_finite(from, to)) return {.finite = false, .in_reach = false};
  constexpr double reach = snap_limit;
  const auto part = clip_line_liang_barsky(from, to, box<double, 2>{{-reach, -reach}, {reach, reach}});
  if (!part) return {.in_reach = false};
  return {true, true, snap(part->first), snap(part->second)};
}

}  // namespace irg::detail::inline IRG_ABI
