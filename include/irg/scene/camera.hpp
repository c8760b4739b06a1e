// SPDX-License-Identifier: MIT
// camera<T>: where the picture is taken from and what it shows.
#pragma once

#include <limits>

#include <irg/geometry/box.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/length.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/view/camera_frame.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/oblique.hpp>
#include <irg/view/projection.hpp>

namespace irg {

/// How space is brought onto the picture plane. Axonometries are orthographic, seen from their own directions
/// (view/axonometry.hpp).
enum class projection_kind { perspective, orthographic, oblique };

/// An eye, what it looks at, and how wide it looks.
/// needs   0 < vertical_angle < pi, 0 < near_distance < far_distance (which may be infinite) for perspective
template <Floating T>
struct camera {
  point<T, 3> eye{T(0), T(0), T(1)};
  point<T, 3> target{};
  vec<T, 3> up{T(0), T(1), T(0)};
  projection_kind projection = projection_kind::perspective;
  T vertical_angle = T(40) * pi<T> / T(180);  // parallel projections show as much as this angle does at the target
  T near_distance = T(0.001);
  T far_distance = std::numeric_limits<T>::infinity();
  oblique_depth<T> receding{};  // in oblique projection: what is at the target's depth stays where it is
  bool operator==(const camera&) const = default;
};

namespace detail::inline IRG_ABI {

// A power of two that brings x > 0 into [1, 2), or as near to it as leaves room for 2^62 of everything.
template <class T>
constexpr T scale_towards_one(T x) noexcept {
  constexpr int most = std::numeric_limits<T>::max_exponent - 64;
  T scale = T(1);
  for (int i = 0; i < most && x * scale < T(1); ++i) scale *= T(2);
  for (int i = 0; i < most && x * scale >= T(2); ++i) scale /= T(2);
  return scale;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The camera `like`, put where a frame is and turned as it is, its target `distance` ahead. So a camera that orbits,
/// rolls or flies through its own poles takes pictures.
/// needs   a frame with axes of length 1 and at right angles, distance > 0. In perspective any distance gives the same
///         picture; parallel projections show as much as vertical_angle does there
/// exact   view_projection as from view_matrix(frame), the axes rounded anew: by about 8u, and by
///         u (|position| + distance) / distance. Far from the origin of the world choose a distance of its size
template <Floating T>
[[nodiscard]] constexpr camera<T> camera_from(const camera_frame<T>& frame, std::type_identity_t<T> distance,
                                              camera<T> like = {}) noexcept {
  IRG_EXPECTS(T(0) < distance);
  like.eye = frame.position;
  like.target = frame.position + frame.forward * distance;
  like.up = frame.up;
  return like;
}

/// The frame of a camera: where it stands and how it is turned. What camera_from is the inverse of.
template <Floating T>
[[nodiscard]] constexpr camera_frame<T> frame_of(const camera<T>& c) noexcept {
  return look_at_frame(c.eye, c.target, c.up);
}

/// The matrix from the world to the camera's clip space (reversed depth), for a picture `aspect` times as wide as high,
/// or why there is none.
/// units   clip space is scaled by a power of two so that w, which is 1 in parallel projection, is 1 to 2 at the near
///         plane: however large or small the world, 1/w and depth are ordinary floats
/// gives   what perspective_checked, orthographic_checked and oblique_checked refuse, with the identity. Parallel
///         projection with the eye at the target: what it shows from distance 1. not_representable also where the view
///         makes an entry overflow
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> view_projection_checked(
    const camera<T>& c, std::type_identity_t<T> aspect) noexcept {
  const mat<T, 4, 4> view = look_at(c.eye, c.target, c.up);
  if (c.projection == projection_kind::perspective) {
    const auto p = perspective_checked(c.vertical_angle, aspect, c.near_distance, c.far_distance);
    return p.ok() ? checked_projection(p.value * view * detail::scale_towards_one(c.near_distance)) : p;
  }
  const T away = length(c.target - c.eye), least = (std::numeric_limits<T>::min)();
  const T height = maximum((T(0) < away ? away : T(1)) * tan(c.vertical_angle / T(2)), least);
  const T width = maximum(height * aspect, least);
  const auto p =
      c.projection == projection_kind::oblique
          ? oblique_checked(oblique_depth<T>{c.receding.angle, c.receding.factor, -away},
                            view_window<T>{-width, width, -height, height}, c.near_distance, c.far_distance)
          : orthographic_checked(view_window<T>{-width, width, -height, height}, c.near_distance, c.far_distance);
  return p.ok() ? checked_projection(p.value * view) : p;
}

/// The matrix from the world to the camera's clip space; see view_projection_checked.
/// needs   a camera in its domain, aspect > 0; where this is broken and not caught, the identity comes out
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> view_projection(const camera<T>& c, std::type_identity_t<T> aspect) noexcept {
  return view_projection_checked(c, aspect).expected();
}

/// Where the viewer is, as shading needs to know it: the eye. In parallel projection the viewer is infinitely far away;
/// then a position so far out in that direction that no view vector of the scene is off by more than 2^-28 rad.
/// needs   a camera in its domain
/// gives   for a scene near the end of T's range the farthest position that T has room for
template <Floating T>
[[nodiscard]] constexpr point<T, 3> viewpoint(const camera<T>& c) noexcept {
  if (c.projection == projection_kind::perspective) return c.eye;
  const mat<T, 4, 4> view = look_at(c.eye, c.target, c.up);
  const vec<T, 3> seen =
      c.projection == projection_kind::oblique ? direction_to_viewer(c.receding) : vec<T, 3>{T(0), T(0), T(1)};
  const vec<T, 3> to_viewer = transpose(submatrix(view, 3, 3)) * seen;
  constexpr T room = (std::numeric_limits<T>::max)() / T(0x1p33);
  const auto size = [](T x) { return minimum(magnitude(x), room); };
  const T reach = size(length(c.target - c.eye)) + size(c.near_distance) + size(c.far_distance);
  return c.eye + to_viewer * (reach * T(0x1p30));
}

/// The camera `c` with its depth range laid around a sphere, so that nothing of the sphere in front of the eye is cut
/// off but what is nearer than a thousandth of the distance to its far side.
template <Floating T>
[[nodiscard]] constexpr camera<T> with_depth_range(camera<T> c, const point<T, 3>& centre,
                                                   std::type_identity_t<T> radius) noexcept {
  const T away = length(centre - c.eye) + radius;
  if (c.projection == projection_kind::perspective) {
    c.near_distance = maximum(away / T(1000), (std::numeric_limits<T>::min)());
    c.far_distance = std::numeric_limits<T>::infinity();
  } else {
    c.near_distance = -away;  // parallel rays come from behind the eye as well
    c.far_distance = maximum(away, (std::numeric_limits<T>::min)());
  }
  return c;
}

/// The camera `like`, looking at the centre of a sphere from `direction`, so far away that the sphere touches the
/// picture. In oblique projection it is the sphere's image, an ellipse, that does.
/// gives   distance 1 for a sphere of radius 0
/// needs   a camera in its domain, aspect > 0
template <Floating T>
[[nodiscard]] constexpr camera<T> camera_around(camera<T> like, const point<T, 3>& centre,
                                                std::type_identity_t<T> radius, const vec<T, 3>& direction,
                                                std::type_identity_t<T> aspect) noexcept {
  const T half_height = like.vertical_angle / T(2);
  T distance = T(1);
  if (like.projection == projection_kind::oblique) {
    const T x = product(like.receding.factor, cos(like.receding.angle));
    const T y = product(like.receding.factor, sin(like.receding.angle));
    const T high = product(radius, hypot(T(1), y)), wide = product(radius, hypot(T(1), x)) / aspect;
    if (T(0) < radius) distance = maximum(high, wide) / tan(half_height);
  } else {
    // The narrower of the two half angles decides.
    const T half_width = atan(tan(half_height) * aspect);
    const T narrow = minimum(half_width, half_height);
    const T share = like.projection == projection_kind::perspective ? sin(narrow) : tan(narrow);  // of the distance
    if (T(0) < radius) distance = radius / share;
  }
  like.target = centre;
  like.eye = centre + normalized(direction) * distance;
  return with_depth_range(like, centre, radius);
}

/// A camera in perspective that looks at the centre of a sphere from `direction`, so far away that the sphere touches
/// the picture.
/// gives   distance 1 for a sphere of radius 0
/// needs   0 < angle < pi, aspect > 0
template <Floating T>
[[nodiscard]] constexpr camera<T> camera_around(const point<T, 3>& centre, std::type_identity_t<T> radius,
                                                const vec<T, 3>& direction, std::type_identity_t<T> vertical_angle,
                                                std::type_identity_t<T> aspect) noexcept {
  camera<T> c;
  c.vertical_angle = vertical_angle;
  return camera_around(c, centre, radius, direction, aspect);
}

}  // namespace IRG_ABI
}  // namespace irg
