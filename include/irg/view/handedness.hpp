// SPDX-License-Identifier: MIT
// From right-handed to left-handed camera space and back, for what camera_frame.hpp has no say in: projections, planes,
// maps of the space into itself. The two spaces count z the other way; irg's own is right-handed, the view along -z.
#pragma once

#include <irg/geometry/plane.hpp>
#include <irg/math/mat.hpp>
#include <irg/view/camera_frame.hpp>

namespace irg::inline IRG_ABI {

/// The same homogeneous position in coordinates of the other handedness.
/// exact   z changes sign, nothing is rounded
template <class T>
[[nodiscard]] IRG_INLINE constexpr hpoint<T, 3> change_handedness(const hpoint<T, 3>& p) noexcept {
  return {p.x, p.y, T(0) - p.z, p.w};
}

/// The same plane, with the same upper side, in coordinates of the other handedness.
/// exact   one coefficient changes sign, nothing is rounded
template <class T>
[[nodiscard]] IRG_INLINE constexpr plane<T> change_handedness(const plane<T>& p) noexcept {
  return {p.a, p.b, T(0) - p.c, p.d};
}

/// The same projection for camera space of the other handedness: perspective, orthographic and the others, which are
/// for right-handed camera space, become those for the left-handed one (z away from the viewer), and the other way.
/// Clip space stays what it is.
/// exact   the third column changes sign, nothing is rounded
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> from_other_handedness(const mat<T, 4, 4>& projection) noexcept {
  return generate_mat<T, 4, 4>([&](int r, int c) { return c == 2 ? T(T(0) - projection(r, c)) : projection(r, c); });
}

/// The same map of a space into itself, in coordinates of the other handedness. Rotations stay rotations.
/// exact   entries change sign, nothing is rounded
template <class T>
[[nodiscard]] constexpr mat<T, 4, 4> in_other_handedness(const mat<T, 4, 4>& m) noexcept {
  return generate_mat<T, 4, 4>([&](int r, int c) { return (r == 2) != (c == 2) ? T(T(0) - m(r, c)) : m(r, c); });
}

}  // namespace irg::inline IRG_ABI
