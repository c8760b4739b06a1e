// SPDX-License-Identifier: MIT
// Projections from camera space (right-handed, the view along -z) into clip space: after the division by w, x and y lie
// in [-1, 1] with y up, and z in [0, 1]. Depth is reversed unless asked otherwise. from_other_handedness
// (handedness.hpp) makes of each one the form for left-handed camera space, the view along +z.
#pragma once

#include <limits>

#include <irg/core/vocabulary.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/mat.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/view/view_window.hpp>

namespace irg {

/// Which end of the depth range is 1. Reversed floats lose least: they are dense near 0, where perspective crowds the
/// far part of the scene (Upchurch and Desbrun 2012).
enum class depth_range {
  reversed,  // near 1, far 0: nearer_is_greater
  standard  // near 0, far 1: nearer_is_less
};

/// What the arguments of a projection amount to.
enum class [[nodiscard]] projection_status {
  ok,
  bad_angle,  // not between 0 and pi; oblique: not finite
  bad_aspect,  // not positive and finite
  bad_window,  // without width or height, or not finite
  bad_distance,  // of the picture plane from the eye: not positive and finite
  bad_factor,  // of an oblique projection: not finite
  bad_depth,  // near not in front of far; perspective: near not in front of the eye
  not_representable,  // an entry of the matrix would overflow
  ordinary [[deprecated("irg: ordinary is now ok")]] = ok
};

namespace detail::inline IRG_ABI {

template <class T, class S>
constexpr checked<mat<T, 4, 4>, S> refused(S why) noexcept {
  return {identity_matrix<T, 4>(), why};
}

// a/b, or infinity where that would overflow (which constant evaluation has no word for).
template <class T>
constexpr T quotient(T a, T b) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)() * (T(1) - std::numeric_limits<T>::epsilon());
  const bool fits = T(1) <= magnitude(b) || magnitude(a) <= magnitude(b) * most;
  return b != T(0) && fits ? a / b : infinity<T>;
}

// 2a/b, or infinity: a/(b/2), but among subnormal numbers a half is rounded.
template <class T>
constexpr T twice_quotient(T a, T b) noexcept {
  const T q = quotient(a, b);
  return magnitude(q) <= (std::numeric_limits<T>::max)() / 2 ? 2 * q : infinity<T>;
}

// Two different numbers whose sum and difference are finite.
template <class T>
constexpr bool make_extent(T a, T b) noexcept {
  constexpr T limit = (std::numeric_limits<T>::max)() / 2;
  return magnitude(a) <= limit && magnitude(b) <= limit && a != b;
}

// The third row of a central projection: depth = (scale * z + offset) / -z. The offset may be infinite.
template <class T>
struct perspective_depth {
  T scale, offset;
};

template <class T>
constexpr perspective_depth<T> depth_of_perspective(T z_near, T z_far, depth_range depth) noexcept {
  constexpr T largest = (std::numeric_limits<T>::max)();
  // far/(far - near) and near/(far - near); their difference is 1.
  const bool endless = z_far > largest;
  const T far_share = endless ? T(1) : z_far / (z_far - z_near);
  const T near_share = endless ? T(0) : z_near / (z_far - z_near);
  const T offset = z_near <= largest / far_share ? z_near * far_share : infinity<T>;
  if (depth == depth_range::reversed) return {near_share, offset};
  return {-far_share, -offset};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The matrix as a projection, or the identity and not_representable where an entry is NaN or infinite.
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> checked_projection(const mat<T, 4, 4>& m) noexcept {
  if (!is_finite(m)) return {identity_matrix<T, 4>(), projection_status::not_representable};
  return {m, projection_status::ok};
}

/// The central projection with a vertical angle of view, or why there is none.
/// shape   camera space to clip space with w = -z: the distance in front of the eye
/// units   vertical_angle in radians between the lower and the upper border; aspect is width over height; z_near and
///         z_far are distances in front of the eye, z_far may be infinity
/// gives   bad_angle, bad_aspect, bad_depth (z_near <= 0, z_near >= z_far, NaN), not_representable
/// exact   entries within 4 ulp of the true ones
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> perspective_checked(
    T vertical_angle, std::type_identity_t<T> aspect, std::type_identity_t<T> z_near, std::type_identity_t<T> z_far,
    depth_range depth = depth_range::reversed) noexcept {
  constexpr T largest = (std::numeric_limits<T>::max)();
  if (!(T(0) < vertical_angle && vertical_angle < pi<T>)) return detail::refused<T>(projection_status::bad_angle);
  if (!(T(0) < aspect && aspect <= largest)) return detail::refused<T>(projection_status::bad_aspect);
  if (!(T(0) < z_near && z_near < z_far)) return detail::refused<T>(projection_status::bad_depth);

  const T y_scale = detail::quotient(T(1), tan(vertical_angle * T(0.5)));
  const T x_scale = y_scale <= largest ? detail::quotient(y_scale, aspect) : y_scale;
  const auto z = detail::depth_of_perspective(z_near, z_far, depth);
  return checked_projection(
      mat<T, 4, 4>{{{x_scale, 0, 0, 0}, {0, y_scale, 0, 0}, {0, 0, z.scale, z.offset}, {0, 0, -1, 0}}});
}

/// The central projection with a vertical angle of view; see perspective_checked.
/// needs   0 < vertical_angle < pi, 0 < aspect < infinity, 0 < z_near < z_far (which may be infinity); where this is
///         broken and not caught, the identity comes out
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> perspective(T vertical_angle, std::type_identity_t<T> aspect,
                                                 std::type_identity_t<T> z_near, std::type_identity_t<T> z_far,
                                                 depth_range depth = depth_range::reversed) noexcept {
  return perspective_checked(vertical_angle, aspect, z_near, z_far, depth).expected();
}

/// The central projection whose picture is a window of the plane `distance` in front of the eye, or why there is none.
/// The window need not be centred: that makes the halves of a stereo pair and the tiles of a large picture.
/// shape   camera space to clip space with w = -z: the distance in front of the eye
/// units   z_near and z_far are distances in front of the eye, z_far may be infinity; with distance = z_near the window
///         is the one that glFrustum takes
/// gives   bad_window (left == right, bottom == top, not finite), bad_distance, bad_depth (z_near <= 0,
///         z_near >= z_far, NaN), not_representable
/// exact   entries within 2 ulp of the true ones; those of a window off centre within u times
///         (|left| + |right|) / |right - left| more
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> perspective_checked(
    const view_window<T>& window, std::type_identity_t<T> distance, std::type_identity_t<T> z_near,
    std::type_identity_t<T> z_far, depth_range depth = depth_range::reversed) noexcept {
  constexpr T largest = (std::numeric_limits<T>::max)();
  if (!detail::make_extent(window.left, window.right) || !detail::make_extent(window.bottom, window.top))
    return detail::refused<T>(projection_status::bad_window);
  if (!(T(0) < distance && distance <= largest)) return detail::refused<T>(projection_status::bad_distance);
  if (!(T(0) < z_near && z_near < z_far)) return detail::refused<T>(projection_status::bad_depth);
  const T width = window.right - window.left, height = window.top - window.bottom;
  const auto z = detail::depth_of_perspective(z_near, z_far, depth);
  return checked_projection(mat<T, 4, 4>{
      {{detail::twice_quotient(distance, width), 0, detail::quotient(window.left + window.right, width), 0},
       {0, detail::twice_quotient(distance, height), detail::quotient(window.bottom + window.top, height), 0},
       {0, 0, z.scale, z.offset},
       {0, 0, -1, 0}}});
}

/// The central projection of a window; see perspective_checked.
/// needs   what makes that one ok; where this is broken and not caught, the identity comes out
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> perspective(const view_window<T>& window, std::type_identity_t<T> distance,
                                                 std::type_identity_t<T> z_near, std::type_identity_t<T> z_far,
                                                 depth_range depth = depth_range::reversed) noexcept {
  return perspective_checked(window, distance, z_near, z_far, depth).expected();
}

/// The parallel projection of a box, or why there is none.
/// shape   camera space to clip space with w = 1; the box has the window's sides and reaches from z_near to z_far
///         in front of the eye, which may be negative: behind it. Exchanged sides mirror the picture
/// gives   bad_window (left == right, bottom == top, not finite), bad_depth (z_near >= z_far, not finite),
///         not_representable
/// exact   entries within 2 ulp of the true ones; the offsets within u times (|left| + |right|) / |right - left| more
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> orthographic_checked(
    const view_window<T>& window, std::type_identity_t<T> z_near, std::type_identity_t<T> z_far,
    depth_range depth = depth_range::reversed) noexcept {
  const auto& [left, right, bottom, top] = window;
  if (!detail::make_extent(left, right) || !detail::make_extent(bottom, top))
    return detail::refused<T>(projection_status::bad_window);
  if (!detail::make_extent(z_near, z_far) || !(z_near < z_far)) return detail::refused<T>(projection_status::bad_depth);
  const T width = right - left, height = top - bottom, length = z_far - z_near;
  const bool reversed = depth == depth_range::reversed;
  const T z_scale = detail::quotient(T(1), length);
  return checked_projection(
      mat<T, 4, 4>{{{detail::quotient(T(2), width), 0, 0, detail::quotient(T(0) - (right + left), width)},
                    {0, detail::quotient(T(2), height), 0, detail::quotient(T(0) - (top + bottom), height)},
                    {0, 0, reversed ? z_scale : -z_scale, detail::quotient(reversed ? z_far : T(0) - z_near, length)},
                    {0, 0, 0, 1}}});
}

/// The parallel projection of a box; see orthographic_checked.
/// needs   finite numbers, left != right, bottom != top, z_near < z_far; where this is broken and not caught, the
///         identity comes out
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> orthographic(const view_window<T>& window, std::type_identity_t<T> z_near,
                                                  std::type_identity_t<T> z_far,
                                                  depth_range depth = depth_range::reversed) noexcept {
  return orthographic_checked(window, z_near, z_far, depth).expected();
}

}  // namespace IRG_ABI
}  // namespace irg
