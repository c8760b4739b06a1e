// SPDX-License-Identifier: MIT
// view_pyramid<T>: the part of space that a camera sees, as Hank n.d. describes it: a screen of width m1 and height m2
// at the distance d in front of the eye, and what lies between the distances n and h.
#pragma once

#include <irg/math/trigonometry.hpp>
#include <irg/view/frustum.hpp>
#include <irg/view/handedness.hpp>
#include <irg/view/projection.hpp>

namespace irg {

/// A screen before the eye, and the depths between which something is seen.
/// needs   all numbers positive, near_distance < far_distance
template <Scalar T>
struct view_pyramid {
  T distance = T(1);  // d: of the screen from the eye
  T width = T(2), height = T(2);  // m1, m2: of the screen
  T near_distance = T(1), far_distance = T(2);  // n, h
  bool operator==(const view_pyramid&) const = default;
};

inline namespace IRG_ABI {

/// The central projection whose view volume is the pyramid, or why there is none; see perspective_checked for windows.
/// gives   also bad_window for a width or height that is not positive
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> perspective_checked(
    const view_pyramid<T>& p, depth_range depth = depth_range::reversed) noexcept {
  if (!(T(0) < p.width && T(0) < p.height)) return detail::refused<T>(projection_status::bad_window);
  return perspective_checked(centred_window(p.width, p.height), p.distance, p.near_distance, p.far_distance, depth);
}

/// The central projection whose view volume is the pyramid.
/// needs   a pyramid in its domain; far_distance may be infinity. Where this is broken and not caught, the identity
///         comes out
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> perspective(const view_pyramid<T>& p,
                                                 depth_range depth = depth_range::reversed) noexcept {
  const auto result = perspective_checked(p, depth);
  IRG_EXPECTS(result.status == projection_status::ok);
  return result.value;
}

/// The angle between the lower and the upper border of the screen, which `perspective` takes by angle.
/// units   radians
template <Floating T>
[[nodiscard]] constexpr T vertical_angle_of(const view_pyramid<T>& p) noexcept {
  return T(2) * atan2(p.height / T(2), p.distance);
}

/// The distance from which a screen of that height spans that angle: how a picture given by its angle is given by its
/// distance.
/// units   radians
/// needs   0 < vertical_angle < pi
template <Floating T>
[[nodiscard]] constexpr T distance_for_angle(T vertical_angle, std::type_identity_t<T> height) noexcept {
  return (height / T(2)) / tan(vertical_angle / T(2));
}

}  // namespace IRG_ABI

/// The corners of a view pyramid.
template <Scalar T>
using pyramid_corner_points = volume_corners<point<T, 3>>;

namespace detail::inline IRG_ABI {

// The corners of the screen, moved along their rays by a factor for the near end and one for the far end.
template <class T>
constexpr pyramid_corner_points<T> corners_by_factors(const view_pyramid<T>& p, const T& at_near, const T& at_far,
                                                      handedness hand) noexcept {
  pyramid_corner_points<T> corners{};
  for (int k = 0; k < 8; ++k) {
    const T factor = (k & 4) != 0 ? at_far : at_near;
    const T x = product(p.width / T(2), factor), y = product(p.height / T(2), factor), z = product(p.distance, factor);
    corners.at[k] = {(k & 1) != 0 ? x : -x, (k & 2) != 0 ? y : -y, hand == handedness::left ? z : -z};
  }
  return corners;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The corners of the pyramid in camera space: those of the screen times n/d and h/d.
/// exact   in rationals; in floats each coordinate is rounded twice
/// source  Hank n.d., 4.1.5.2, the factor of the far corners corrected
template <Real T>
[[nodiscard]] constexpr pyramid_corner_points<T> pyramid_corners(const view_pyramid<T>& p,
                                                                 handedness hand = handedness::right) noexcept {
  return detail::corners_by_factors(p, T(p.near_distance / p.distance), T(p.far_distance / p.distance), hand);
}

/// The six planes of the pyramid in camera space, normals inward: those of the sides through the eye and two corners of
/// the screen, so that their normals are as long as the parallelogram of the two rays.
/// exact   in rationals; in integers for an even width and height
/// source  Hank n.d., 4.1.5.2: a plane from three points each
template <Scalar T>
[[nodiscard]] constexpr frustum<T> pyramid_planes(const view_pyramid<T>& p,
                                                  handedness hand = handedness::right) noexcept {
  const T x = p.width / T(2), y = p.height / T(2), forward = hand == handedness::left ? T(1) : T(-1);
  const auto through_eye = [&](const vec<T, 3>& a, const vec<T, 3>& b) {
    const vec<T, 3> n = cross(a, b);
    return plane<T>{n.x, n.y, product(forward, n.z), T(0)};
  };
  const vec<T, 3> low_left{-x, -y, p.distance}, low_right{x, -y, p.distance}, high_left{-x, y, p.distance},
      high_right{x, y, p.distance};
  frustum<T> f{};
  f.set(frustum_plane::z_near, {T(0), T(0), forward, -p.near_distance});
  f.set(frustum_plane::z_far, {T(0), T(0), -forward, p.far_distance});
  f.set(frustum_plane::left, through_eye(high_left, low_left));
  f.set(frustum_plane::right, through_eye(low_right, high_right));
  f.set(frustum_plane::bottom, through_eye(low_left, low_right));
  f.set(frustum_plane::top, through_eye(high_right, high_left));
  return f;
}

}  // namespace IRG_ABI
}  // namespace irg
