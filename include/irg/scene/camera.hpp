// SPDX-License-Identifier: MIT
// camera<T>: where the picture is taken from and what it shows.
#pragma once

#include <limits>

#include <irg/geometry/box.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/length.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>

namespace irg {

/// How space is brought onto the picture plane.
enum class projection_kind { perspective, orthographic };

/// An eye, what it looks at, and how wide it looks.
/// needs   0 < vertical_angle < pi, 0 < near_distance < far_distance (which may be infinite) for perspective
template <Floating T>
struct camera {
  point<T, 3> eye{T(0), T(0), T(1)};
  point<T, 3> target{};
  vec<T, 3> up{T(0), T(1), T(0)};
  projection_kind projection = projection_kind::perspective;
  T vertical_angle = T(40) * pi<T> / T(180);  // orthographic pictures show as much as this angle does at the target
  T near_distance = T(0.001);
  T far_distance = std::numeric_limits<T>::infinity();
};

inline namespace IRG_ABI {

/// The matrix from the world to the camera's clip space (reversed depth), for a picture `aspect` times as wide as high.
/// needs   a camera in its domain, aspect > 0
template <Floating T>
constexpr mat<T, 4, 4> view_projection(const camera<T>& c, std::type_identity_t<T> aspect) noexcept {
  const mat<T, 4, 4> view = look_at(c.eye, c.target, c.up);
  if (c.projection == projection_kind::perspective)
    return perspective(c.vertical_angle, aspect, c.near_distance, c.far_distance) * view;
  const T height = length(c.target - c.eye) * tan(c.vertical_angle / T(2)), width = height * aspect;
  return orthographic(-width, width, -height, height, c.near_distance, c.far_distance) * view;
}

/// The camera `c` with its depth range laid around a sphere, so that nothing of the sphere in front of the eye is cut
/// off but what is nearer than a thousandth of the distance to its far side.
template <Floating T>
constexpr camera<T> with_depth_range(camera<T> c, const point<T, 3>& centre, std::type_identity_t<T> radius) noexcept {
  const T away = length(centre - c.eye) + radius;
  if (c.projection == projection_kind::perspective) {
    c.near_distance = greater(away / T(1000), std::numeric_limits<T>::min());
  } else {
    c.near_distance = -away;  // parallel rays come from behind the eye as well
    c.far_distance = greater(away, std::numeric_limits<T>::min());
  }
  return c;
}

/// A camera that looks at the centre of a sphere from `direction`, so far away that the sphere just touches the picture.
/// gives   distance 1 for a sphere of radius 0
/// needs   0 < angle < pi, aspect > 0
template <Floating T>
constexpr camera<T> camera_around(const point<T, 3>& centre, std::type_identity_t<T> radius, const vec<T, 3>& direction,
                                  std::type_identity_t<T> vertical_angle, std::type_identity_t<T> aspect) noexcept {
  camera<T> c;
  c.target = centre;
  c.vertical_angle = vertical_angle;
  // The narrower of the two half angles decides.
  const T half_width = atan(tan(vertical_angle / T(2)) * aspect), half_height = vertical_angle / T(2);
  const T distance = T(0) < radius ? radius / sin(lesser(half_width, half_height)) : T(1);
  c.eye = centre + normalized(direction) * distance;
  return with_depth_range(c, centre, radius);
}

}  // namespace IRG_ABI
}  // namespace irg
