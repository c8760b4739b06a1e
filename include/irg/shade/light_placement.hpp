// SPDX-License-Identifier: MIT
// Where lights stand: by coordinates, or about a target by a distance and two angles, as polar cameras do. Every one
// radiates equally in all directions: what a surface receives depends on its own turn towards the light only.
#pragma once

#include <limits>
#include <optional>

#include <irg/math/length.hpp>
#include <irg/shade/light.hpp>
#include <irg/view/polar_camera.hpp>

namespace irg::inline IRG_ABI {

/// A lamp at a position.
template <Scalar T, class L>
[[nodiscard]] constexpr light<T, L> light_at(const point<T, 3>& position, const L& intensity) {
  return {to_homogeneous(position), intensity};
}

/// A lamp at infinity, in a direction.
template <Scalar T, class L>
[[nodiscard]] constexpr light<T, L> light_from(const vec<T, 3>& direction, const L& intensity) {
  return {{direction.x, direction.y, direction.z, T(0)}, intensity};
}

/// A lamp about a target, at the distance, azimuth and elevation given: where a polar camera of these numbers stands.
/// units   radians; a distance of infinity puts it at infinity in that direction
/// gives   a light with all coordinates 0, which shines on nothing, when an angle is NaN or infinite, the distance NaN
///         or -infinity, or the target or the distance beyond a quarter of the largest number
/// exact   the polar camera's position, bit by bit
/// source  Hank n.d., 4.1.3.2
template <Floating T, class L>
constexpr light<T, L> light_around(const point<T, 3>& target, const polar_coordinates<T>& p, const L& intensity,
                                   polar_axis axis = polar_axis::y_up) {
  const bool at_infinity = p.distance == std::numeric_limits<T>::infinity();
  const auto f = try_frame_of(polar_camera<T>{target, at_infinity ? T(1) : p.distance, p.azimuth, p.elevation}, axis);
  if (!f) return {hpoint<T, 3>{T(0), T(0), T(0), T(0)}, intensity};
  return at_infinity ? light_from(-f->forward, intensity) : light_at(f->position, intensity);
}

/// Where a light stands about a target: the inverse of light_around. A light at infinity has the distance infinity.
/// units   radians
/// needs   finite coordinates, and a weight by which they may be divided without overflow
/// gives   nothing for a light with all coordinates 0; all 0 for a light in the target itself
template <Floating T, class L>
constexpr std::optional<polar_coordinates<T>> polar_of(const light<T, L>& source, const point<T, 3>& target,
                                                       polar_axis axis = polar_axis::y_up) noexcept {
  const hpoint<T, 3>& s = source.position;
  if (s == hpoint<T, 3>{}) return std::nullopt;
  if (s.w != T(0)) return cartesian_to_polar(to_cartesian(s) - target, axis);
  polar_coordinates<T> p = cartesian_to_polar(vec<T, 3>{s.x, s.y, s.z}, axis);
  p.distance = std::numeric_limits<T>::infinity();
  return p;
}

}  // namespace irg::inline IRG_ABI
