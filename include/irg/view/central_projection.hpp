// SPDX-License-Identifier: MIT
// The textbook projections of points: central by the distance between eye and picture plane, and parallel. For pictures
// with depth and clipping, projection.hpp has the matrices to clip space.
//
//      picture_plane: the slides              eye: Hank
//      x' = x * d / (d - z)                   x' = d * x / z
//      the picture plane is z = 0, the        the eye is the origin, the picture plane z = d,
//      eye is at (0, 0, d), z to the viewer   z away from the viewer
#pragma once

#include <optional>

#include <irg/view/projection.hpp>

namespace irg {

/// Where the origin lies and which way z runs.
enum class projection_origin {
  picture_plane,  // z towards the viewer, who is at (0, 0, distance): right-handed
  eye  // z away from the viewer, the picture plane at z = distance: left-handed
};

namespace detail::inline IRG_ABI {

template <class T>
constexpr bool is_distance(const T& d) noexcept {
  if constexpr (Floating<T>)
    return T(0) < d && d <= (std::numeric_limits<T>::max)();
  else
    return T(0) < d;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The picture of a point on a plane at a distance from the eye.
/// gives   nothing for a point beside or behind the eye, for a distance that is not positive and finite, and for NaN
/// exact   in rationals; in floats (x * d) / depth with each operation rounded once
/// source  Hidden-surface slides; Hank n.d., 4.1.6.2
template <Real T>
[[nodiscard]] constexpr std::optional<point<T, 2>> project_central(const point<T, 3>& p,
                                                                   const std::type_identity_t<T>& distance,
                                                                   projection_origin origin) noexcept {
  if (!(detail::is_distance(distance) && p.x == p.x && p.y == p.y && p.z == p.z)) return std::nullopt;
  const T depth = origin == projection_origin::eye ? p.z : distance - p.z;
  if (!(T(0) < depth)) return std::nullopt;
  return point<T, 2>{product(p.x, distance) / depth, product(p.y, distance) / depth};
}

/// The picture of a point by rays at right angles to the picture plane: z is dropped.
/// exact   no arithmetic
/// source  Mihajlovic 2016, 5.2; Hank n.d., 4.1.6.1
template <Scalar T>
[[nodiscard]] constexpr point<T, 2> project_parallel(const point<T, 3>& p) noexcept {
  return {p.x, p.y};
}

/// The matrix of project_central, or why there is none. It maps (x, y, z, 1) to homogeneous coordinates whose w is the
/// distance from the eye, in front of it positive.
/// shape   picture_plane: depth z comes out as z * d / (d - z), which grows with z and keeps lines and planes straight,
///         so that the matrix can be inverted and depths be compared; eye: z comes out as d, the matrix is singular
/// gives   bad_distance
/// exact   nothing is rounded
template <Real T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> central_projection_checked(
    const T& distance, projection_origin origin) noexcept {
  if (!detail::is_distance(distance)) return detail::refused<T>(projection_status::bad_distance);
  const T d = distance, o = T(0), one = T(1);
  if (origin == projection_origin::eye)
    return {{{{d, o, o, o}, {o, d, o, o}, {o, o, d, o}, {o, o, one, o}}}, projection_status::ok};
  return {{{{d, o, o, o}, {o, d, o, o}, {o, o, d, o}, {o, o, -one, d}}}, projection_status::ok};
}

/// The matrix of project_central; see central_projection_checked.
/// needs   a positive, finite distance; where this is broken and not caught, the identity comes out
template <Real T>
[[nodiscard]] constexpr mat<T, 4, 4> central_projection(const T& distance, projection_origin origin) noexcept {
  return central_projection_checked(distance, origin).expected();
}

}  // namespace IRG_ABI
}  // namespace irg
