// SPDX-License-Identifier: MIT
// The corners of the viewing pyramid as printed.
#pragma once

#include <irg/view/view_pyramid.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The corners as Hank prints them (4.1.5.2): the far ones by the factor n/h, which puts them before the near ones.
template <Real T>
[[nodiscard]] constexpr pyramid_corner_points<T> pyramid_corners(const view_pyramid<T>& p,
                                                                 handedness hand = handedness::left) noexcept {
  return irg::detail::corners_by_factors(p, T(p.near_distance / p.distance), T(p.near_distance / p.far_distance), hand);
}

}  // namespace irg::textbook::inline IRG_ABI
