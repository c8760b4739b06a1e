// SPDX-License-Identifier: MIT
// polar_camera<T>: a camera that looks at a target from a distance, turned about it by two angles. It has axes at every
// elevation, the poles and beyond among them, because they follow from the angles and not from an up vector.
#pragma once

#include <limits>
#include <optional>

#include <irg/math/constants.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/view/camera_frame.hpp>

namespace irg {

/// Which axis of the world elevation rises towards, and where azimuth counts from: counter-clockwise as seen from that
/// axis' tip in either case.
enum class polar_axis {
  y_up,  // azimuth from +z towards +x; Hank's
  z_up  // azimuth from +x towards +y; geography's, for the lecture's scene
};

/// A displacement as its length and two angles.
/// units   radians
template <Floating T>
struct polar_coordinates {
  T distance{}, azimuth{}, elevation{};
  bool operator==(const polar_coordinates&) const = default;
};

/// A camera about a target.
/// units   radians; roll turns the camera counter-clockwise about its view: its up leans to the left
template <Floating T>
struct polar_camera {
  point<T, 3> target{};
  T distance = T(1), azimuth{}, elevation{}, roll{};
  bool operator==(const polar_camera&) const = default;
};

/// The angles of a polar camera by their sines and cosines.
template <Floating T>
struct polar_turn {
  sine_and_cosine<T> azimuth{T(0), T(1)}, elevation{T(0), T(1)}, roll{T(0), T(1)};
  bool operator==(const polar_turn&) const = default;
};

/// How far a camera may be lifted or lowered in an orbit. At the default limits, the poles, it looks straight down or
/// up and its axes are as defined as anywhere.
template <Floating T>
struct orbit_options {
  T lowest = -pi<T> / T(2), highest = pi<T> / T(2);
  bool operator==(const orbit_options&) const = default;
};

namespace detail::inline IRG_ABI {

// (x, y, z) of y_up in the world of the axis given: a cyclic exchange, which keeps the handedness; and back.
template <class C>
IRG_INLINE constexpr C from_y_up(const C& c, polar_axis axis) noexcept {
  return axis == polar_axis::y_up ? c : C{c.z, c.x, c.y};
}
template <class C>
IRG_INLINE constexpr C to_y_up(const C& c, polar_axis axis) noexcept {
  return axis == polar_axis::y_up ? c : C{c.y, c.z, c.x};
}

// The unit vector from the target to the camera, y up.
template <class T>
constexpr vec<T, 3> polar_direction(const sine_and_cosine<T>& a, const sine_and_cosine<T>& e) noexcept {
  return {product(e.cosine, a.sine), e.sine, product(e.cosine, a.cosine)};
}

// The angle of (cosine, sine), 0 where there is none: a negative zero must not make it pi.
template <class T>
constexpr T angle_or_zero(T sine, T cosine) noexcept {
  return sine == T(0) && cosine == T(0) ? T(0) : atan2(sine + T(0), cosine);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The displacement with the given length, azimuth and elevation, Hank's PolarToDescartes:
/// R (cos b sin a, sin b, cos b cos a).
/// units   radians
/// gives   coordinates that are NaN or infinite where the angles or the distance are
/// exact   each coordinate within 4.5 ulp, where sines and cosines have no subnormal product
template <Floating T>
[[nodiscard]] constexpr vec<T, 3> polar_to_cartesian(const polar_coordinates<T>& p,
                                                     polar_axis axis = polar_axis::y_up) noexcept {
  return detail::from_y_up(detail::polar_direction(sin_cos(p.azimuth), sin_cos(p.elevation)) * p.distance, axis);
}

/// The length, azimuth and elevation of a displacement: the inverse of polar_to_cartesian.
/// units   radians, azimuth in [-pi, pi], elevation in [-pi/2, pi/2]
/// gives   azimuth 0 on the pole's axis, 0 for all of the zero vector; an infinite distance where it is beyond the
///         largest number
/// exact   distance within 0.501 ulp, angles within 2 ulp (elevation where the coordinates are not subnormal)
template <Floating T>
[[nodiscard]] constexpr polar_coordinates<T> cartesian_to_polar(const vec<T, 3>& v,
                                                                polar_axis axis = polar_axis::y_up) noexcept {
  constexpr T large = (std::numeric_limits<T>::max)() / 4;
  const vec<T, 3> d = detail::to_y_up(v, axis);
  const bool halved = large < magnitude(d.x) || large < magnitude(d.z);
  const T level = halved ? hypot(d.x / 2, d.z / 2) : hypot(d.x, d.z);
  return {hypot(d.x, d.y, d.z), detail::angle_or_zero(d.x, d.z), detail::angle_or_zero(halved ? d.y / 2 : d.y, level)};
}

/// The frame of a camera about a target, from sines and cosines: with sin_cos_degrees, multiples of 30 degrees have no
/// rounding in their angles at all, and the poles are hit exactly.
/// needs   finite arguments, target and distance within a quarter of the largest number
/// exact   axes of length 1 and at right angles within 8u (u = 2^-53, float 2^-24)
template <Floating T>
constexpr camera_frame<T> polar_frame(const point<T, 3>& target, std::type_identity_t<T> distance,
                                      const polar_turn<T>& turn, polar_axis axis = polar_axis::y_up) noexcept {
  const auto& [azimuth, elevation, roll] = turn;
  const vec<T, 3> back = detail::polar_direction(azimuth, elevation);
  const vec<T, 3> x{azimuth.cosine, T(0), T(0) - azimuth.sine};
  const vec<T, 3> y{T(0) - product(elevation.sine, azimuth.sine), elevation.cosine,
                    T(0) - product(elevation.sine, azimuth.cosine)};
  const vec<T, 3> from_target = detail::from_y_up(back, axis);
  return {target + from_target * distance, detail::from_y_up(x * roll.cosine + y * roll.sine, axis),
          detail::from_y_up(y * roll.cosine - x * roll.sine, axis), -from_target};
}

/// The frame of a polar camera: the eye at target + polar_to_cartesian, the axes by the angles.
/// gives   nothing when a number is NaN or infinite, or target or distance beyond a quarter of the largest number.
///         Beyond the poles the picture is upside down; with a distance of 0 the eye is the target; with a negative one
///         it stands on the other side and looks away from the target
/// exact   as polar_frame
/// source  Hank n.d., 4.1.3.1
template <Floating T>
[[nodiscard]] constexpr std::optional<camera_frame<T>> try_frame_of(const polar_camera<T>& c,
                                                                    polar_axis axis = polar_axis::y_up) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)();
  if (!detail::within(c.target, most / 4) || !(magnitude(c.distance) <= most / 4) ||
      !detail::within(vec<T, 3>{c.azimuth, c.elevation, c.roll}, most))
    return std::nullopt;
  return polar_frame(c.target, c.distance, polar_turn<T>{sin_cos(c.azimuth), sin_cos(c.elevation), sin_cos(c.roll)},
                     axis);
}

/// The frame of a polar camera; the default frame where try_frame_of gives nothing.
template <Floating T>
[[nodiscard]] constexpr camera_frame<T> frame_of(const polar_camera<T>& c,
                                                 polar_axis axis = polar_axis::y_up) noexcept {
  return try_frame_of(c, axis).value_or(camera_frame<T>{});
}

/// The polar camera of a frame whose target lies at `distance` ahead: the inverse of frame_of.
/// units   radians, azimuth and roll in [-pi, pi]; elevation in [-pi, pi] for a frame without roll, which may look
///         upside down from beyond a pole, in [-pi/2, pi/2] for others
/// needs   an orthonormal frame
/// gives   roll exactly 0 where right is level within 8u. Azimuth then follows from right, and so is defined at the
///         poles, too; a frame that looks along the pole's axis has no roll
/// exact   frame_of of the result has the same axes within 16u
template <Floating T>
[[nodiscard]] constexpr polar_camera<T> polar_of(const camera_frame<T>& f, std::type_identity_t<T> distance,
                                                 polar_axis axis = polar_axis::y_up) noexcept {
  const vec<T, 3> x = detail::to_y_up(f.right, axis), y = detail::to_y_up(f.up, axis);
  const vec<T, 3> back = -detail::to_y_up(f.forward, axis);
  polar_camera<T> c{f.position + f.forward * distance, distance};
  if (magnitude(x.y) <= 4 * std::numeric_limits<T>::epsilon()) {
    c.azimuth = detail::angle_or_zero(-x.z, x.x);
    c.elevation = detail::angle_or_zero(back.y, y.y);
    return c;
  }
  const polar_coordinates<T> p = cartesian_to_polar(back);
  c.azimuth = p.azimuth;
  c.elevation = p.elevation;
  const camera_frame<T> level =
      polar_frame(point<T, 3>{}, T(0), polar_turn<T>{sin_cos(c.azimuth), sin_cos(c.elevation)});
  c.roll = detail::angle_or_zero(dot(x, level.up), dot(x, level.right));
  return c;
}

/// The camera moved about its target by two angles.
/// units   radians; azimuth comes out in [-pi, pi] when it left that range
/// needs   a camera whose angles are within a quarter of the largest number
/// gives   an elevation within the limits; a step that is NaN or beyond a quarter of the largest number is no step
template <Floating T>
[[nodiscard]] constexpr polar_camera<T> orbited(polar_camera<T> c, std::type_identity_t<T> by_azimuth,
                                                std::type_identity_t<T> by_elevation,
                                                const orbit_options<T>& limits = {}) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)() / 4;
  if (magnitude(by_azimuth) <= most) c.azimuth = c.azimuth + by_azimuth;
  if (pi<T> < magnitude(c.azimuth)) {
    const sine_and_cosine<T> a = sin_cos(c.azimuth);
    c.azimuth = atan2(a.sine, a.cosine);
  }
  const T lifted = magnitude(by_elevation) <= most ? c.elevation + by_elevation : c.elevation;
  c.elevation = clamped(lifted, limits.lowest, limits.highest);
  return c;
}

}  // namespace IRG_ABI
}  // namespace irg
