// SPDX-License-Identifier: MIT
// Named coordinate systems, told by where their axes point as a viewer sees it, and the matrices that lead from one to
// another: their entries are 0, 1 and -1, so nothing is rounded. Hank's world is right-handed, its camera
// left-handed; files and devices have still other habits.
#pragma once

#include <irg/math/mat.hpp>

namespace irg {

/// Where an axis points, seen by the viewer of the picture.
enum class axis_direction { right, left, up, down, toward_viewer, away_from_viewer };

/// Whether the axes x, y, z lie as thumb, index and middle finger of the right hand or of the left one. For a camera
/// space with x to the right and y up:
enum class handedness {
  right,  // z towards the viewer: the view goes along -z; irg's own
  left  // z along the view: the depth; the eye's and the camera's space of Mihajlovic 2016 and Hank n.d.
};

/// Where the three axes of a coordinate system point.
/// needs   directions on three different lines, for all that takes one
struct coordinate_system {
  axis_direction x, y, z;
  bool operator==(const coordinate_system&) const = default;
};

/// Hank's world, OpenGL's and this library's: y up, z toward the viewer. Right-handed.
inline constexpr coordinate_system world_y_up{axis_direction::right, axis_direction::up, axis_direction::toward_viewer};
/// Maps, architecture, Blender: z up, y away from the viewer. Right-handed.
inline constexpr coordinate_system world_z_up{axis_direction::right, axis_direction::away_from_viewer,
                                              axis_direction::up};
/// Hank's camera, Direct3D's: x right, y up, z into the picture. Left-handed.
inline constexpr coordinate_system camera_left_handed{axis_direction::right, axis_direction::up,
                                                      axis_direction::away_from_viewer};
/// The plane of projection: x right, y up, z the depth behind it. Left-handed, as Hank's camera.
inline constexpr coordinate_system projection_plane = camera_left_handed;
/// Pixels and most image files: x right, y down, z the depth. Right-handed.
inline constexpr coordinate_system screen_y_down{axis_direction::right, axis_direction::down,
                                                 axis_direction::away_from_viewer};

namespace detail::inline IRG_ABI {

// The line of a direction as 0, 1 or 2, and the sense on it as 1 or -1, in world_y_up.
IRG_INLINE constexpr int axis_line(axis_direction d) noexcept { return static_cast<int>(d) / 2; }
IRG_INLINE constexpr int axis_sense(axis_direction d) noexcept { return static_cast<int>(d) % 2 == 0 ? 1 : -1; }
IRG_INLINE constexpr axis_direction axis_of(const coordinate_system& s, int i) noexcept {
  return i == 0 ? s.x : i == 1 ? s.y : s.z;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether the axes lie on three different lines.
[[nodiscard]] constexpr bool is_valid(const coordinate_system& s) noexcept {
  const int x = detail::axis_line(s.x), y = detail::axis_line(s.y), z = detail::axis_line(s.z);
  return x != y && y != z && x != z;
}

/// The matrix that takes coordinates in `from` to coordinates in `to`; the origin is the same.
/// shape   3x3 for vectors, or 4x4 for homogeneous points: conversion<double, 4>(from, to)
/// needs   is_valid(from), is_valid(to)
/// exact   entries 0, 1 and -1; it is orthogonal, and its determinant is -1 when the handedness changes
template <Scalar T, int N = 3>
  requires(N == 3 || N == 4)
[[nodiscard]] constexpr mat<T, N, N> conversion(const coordinate_system& from, const coordinate_system& to) noexcept {
  IRG_EXPECTS(is_valid(from) && is_valid(to));
  return generate_mat<T, N, N>([&](int r, int c) {
    if (r == 3 || c == 3) return r == c ? T(1) : T(0);
    const axis_direction a = detail::axis_of(to, r), b = detail::axis_of(from, c);
    if (detail::axis_line(a) != detail::axis_line(b)) return T(0);
    return detail::axis_sense(a) == detail::axis_sense(b) ? T(1) : T(-1);
  });
}

/// Whether x, y, z make a right hand or a left one.
/// needs   is_valid(s)
[[nodiscard]] constexpr handedness handedness_of(const coordinate_system& s) noexcept {
  return determinant(conversion<int>(s, world_y_up)) > 0 ? handedness::right : handedness::left;
}

/// The same position or direction in another coordinate system.
/// needs   is_valid(from), is_valid(to)
/// exact   coordinates change places and signs, nothing is rounded
template <Coordinates V>
  requires(size_of<V> == 3)
[[nodiscard]] constexpr V convert(const V& v, const coordinate_system& from, const coordinate_system& to) noexcept {
  IRG_EXPECTS(is_valid(from) && is_valid(to));
  return generate_coordinates<V>([&](int r) {
    const axis_direction a = detail::axis_of(to, r);
    int c = 0;
    while (detail::axis_line(detail::axis_of(from, c)) != detail::axis_line(a)) ++c;
    const scalar_of<V> x = coordinate(v, c);
    return detail::axis_sense(detail::axis_of(from, c)) == detail::axis_sense(a) ? x : scalar_of<V>(-x);
  });
}

}  // namespace IRG_ABI
}  // namespace irg
