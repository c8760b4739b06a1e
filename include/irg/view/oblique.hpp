// SPDX-License-Identifier: MIT
// Oblique parallel projection: what is parallel to the picture plane keeps its true shape, and depth runs off at an
// angle, shortened by a factor. Cavalier: factor 1; cabinet: factor 1/2.
#pragma once

#include <irg/math/length.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/view/projection.hpp>

namespace irg {

/// How much of a length at right angles to the picture plane is drawn.
template <Floating T>
inline constexpr T cavalier_factor = T(1);
template <Floating T>
inline constexpr T cabinet_factor = T(0.5);

/// How depth is drawn: what lies deeper is moved by factor times its depth, at `angle` from the right,
/// counter-clockwise; the plane z = plane_z of camera space stays where it is.
/// units   radians
template <Floating T>
struct oblique_depth {
  T angle = T(45) * pi<T> / T(180);
  T factor = cabinet_factor<T>;
  T plane_z = T(0);
  bool operator==(const oblique_depth&) const = default;
};

inline namespace IRG_ABI {

/// The affine matrix of camera space (right-handed, the view along -z) that moves everything sideways so that a
/// projection along z then shows it obliquely; or why there is none. Depth z stays.
/// shape   factor 0 moves nothing, a negative one moves the other way
/// gives   bad_angle, bad_factor, bad_depth (plane_z) for numbers that are not finite, not_representable
/// exact   entries within 2 ulp, the last column's within 3 unless the one of the same row is subnormal
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> oblique_shear_checked(
    const oblique_depth<T>& how) noexcept {
  const T plane_z = how.plane_z;
  constexpr T largest = (std::numeric_limits<T>::max)();
  if (!is_finite(how.angle)) return detail::refused<T>(projection_status::bad_angle);
  if (!is_finite(how.factor)) return detail::refused<T>(projection_status::bad_factor);
  if (!is_finite(plane_z)) return detail::refused<T>(projection_status::bad_depth);
  const T x = product(how.factor, cos(how.angle)), y = product(how.factor, sin(how.angle));
  if (T(1) < magnitude(plane_z) && largest / magnitude(plane_z) < magnitude(how.factor))
    return detail::refused<T>(projection_status::not_representable);
  auto m = identity_matrix<T, 4>();
  m(0, 2) = T(0) - x;
  m(1, 2) = T(0) - y;
  m(0, 3) = product(x, plane_z);
  m(1, 3) = product(y, plane_z);
  return {m, projection_status::ok};
}

/// The matrix that moves depth sideways; see oblique_shear_checked.
/// needs   what makes that one ok; where this is broken and not caught, the identity comes out
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> oblique_shear(const oblique_depth<T>& how) noexcept {
  return oblique_shear_checked(how).expected();
}

/// The oblique projection of a box, or why there is none.
/// shape   camera space to clip space with w = 1; the window lies in the plane z = plane_z, whose points come out as
///         orthographic_checked has them
/// gives   as oblique_shear_checked and orthographic_checked
/// exact   entries within 4 ulp of the true ones, unless those of the shear are subnormal, and but for cancellation
///         between window and shear in the last column
template <Floating T>
[[nodiscard]] constexpr checked<mat<T, 4, 4>, projection_status> oblique_checked(
    const oblique_depth<T>& how, const view_window<T>& window, std::type_identity_t<T> z_near,
    std::type_identity_t<T> z_far, depth_range depth = depth_range::reversed) noexcept {
  const auto straight = orthographic_checked(window, z_near, z_far, depth);
  if (straight.status != projection_status::ok) return straight;
  const auto shear = oblique_shear_checked(how);
  if (shear.status != projection_status::ok) return shear;
  mat<T, 4, 4> m = straight.value;
  constexpr T largest = (std::numeric_limits<T>::max)();
  for (int row = 0; row < 2; ++row) {
    const T scale = m(row, row), slope = shear.value(row, 2), shift = shear.value(row, 3);
    // Half of the largest number is left for the window's own offset.
    if (T(1) < magnitude(scale) && largest / T(2) / magnitude(scale) < maximum(magnitude(slope), magnitude(shift)))
      return detail::refused<T>(projection_status::not_representable);
    m(row, 2) = product(scale, slope);
    m(row, 3) = product(scale, shift) + m(row, 3);
  }
  return checked_projection(m);
}

/// The oblique projection of a box; see oblique_checked.
/// needs   what makes that one ok; where this is broken and not caught, the identity comes out
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> oblique(const oblique_depth<T>& how, const view_window<T>& window,
                                             std::type_identity_t<T> z_near, std::type_identity_t<T> z_far,
                                             depth_range depth = depth_range::reversed) noexcept {
  return oblique_checked(how, window, z_near, z_far, depth).expected();
}

/// The unit vector in camera space from any point towards the viewer, along the rays of an oblique projection.
/// gives   0, 0, 1 where angle or factor is not finite
template <Floating T>
[[nodiscard]] constexpr vec<T, 3> direction_to_viewer(const oblique_depth<T>& how) noexcept {
  if (!is_finite(how.angle) || !is_finite(how.factor)) return {T(0), T(0), T(1)};
  return normalized(vec<T, 3>{product(how.factor, cos(how.angle)), product(how.factor, sin(how.angle)), T(1)});
}

}  // namespace IRG_ABI
}  // namespace irg
