// SPDX-License-Identifier: MIT
// Polar cameras as the sources form them: left-handed, and by added right angles.
#pragma once

#include <irg/view/polar_camera.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The axes of Hank's camera as he forms them: Y = polar(a, b + 90 degrees), Z = polar(a, b + 180 degrees),
/// X = Z x Y, the position at distance R from the origin. Left-handed: right, up and forward are X, Y and Z. X points
/// to the viewer's right; his sentence that it points left contradicts his own formula.
/// units   radians
/// needs   finite arguments
/// exact   axes within 4u of irg::polar_frame's for angles up to pi; the added right angles round larger ones
template <Floating T>
[[nodiscard]] constexpr camera_frame<T> polar_frame(T distance, std::type_identity_t<T> azimuth,
                                                    std::type_identity_t<T> elevation) noexcept {
  const vec<T, 3> y = polar_to_cartesian(polar_coordinates<T>{T(1), azimuth, elevation + pi<T> / T(2)});
  const vec<T, 3> z = polar_to_cartesian(polar_coordinates<T>{T(1), azimuth, elevation + pi<T>});
  return {to_point(polar_to_cartesian(polar_coordinates<T>{distance, azimuth, elevation})), cross(z, y), y, z};
}

/// The viewer of the hidden-surface slides: on the z axis at (0, 0, d), looking at the origin, the scene's z axis
/// towards the viewer. It is the polar camera of both angles 0; the slides keep the scene's own depth, so that z is d
/// minus the distance along the view.
template <Floating T>
[[nodiscard]] constexpr camera_frame<T> viewer_frame(T d) noexcept {
  return {{T(0), T(0), d}, {T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(-1)}};
}

}  // namespace irg::textbook::inline IRG_ABI
