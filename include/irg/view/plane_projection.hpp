// SPDX-License-Identifier: MIT
// Projections of space onto any plane, from an eye or along a direction, as 4x4 matrices: pictures on tilted planes,
// and the shadows that a lamp throws on a floor or wall. An eye at infinity is a direction: one formula does both.
#pragma once

#include <limits>

#include <irg/core/vocabulary.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/view/projection.hpp>

namespace irg {

/// What eye and plane amount to.
enum class [[nodiscard]] plane_projection_status {
  ok,
  no_plane,  // the normal is zero
  no_eye,  // the eye's coordinates are all zero: neither a position nor a direction
  eye_in_plane,  // every ray meets the plane in the eye
  direction_parallel,  // the rays do not meet the plane, or lie in it
  not_finite,  // a number is NaN or infinite
  not_representable,  // an entry of the matrix would overflow
  ordinary [[deprecated("irg: ordinary is now ok")]] = ok
};

namespace detail::inline IRG_ABI {

// Entry (r, c) is (height * [r == c] - eye[r] * plane[c]) / height, with height = the sum of all eye[k] * plane[k]. On
// the diagonal the height's own product cancels, so it is left out instead of subtracted.
template <class W>
struct plane_projector {
  W eye[4], plane[4];

  IRG_INLINE constexpr W height_without(int left_out) const noexcept {
    W sum = W(0);
    for (int k = 0; k < 4; ++k)
      if (k != left_out) sum = sum + product(eye[k], plane[k]);
    return sum;
  }
  IRG_INLINE constexpr W numerator(int r, int c) const noexcept {
    return r == c ? height_without(r) : W(0) - product(eye[r], plane[c]);
  }
};

// The numbers in the precision of the computation: floats and doubles as doubles whose scale, which is free, leaves
// room below for products of the smallest; others as they are.
template <class T>
constexpr auto plane_projector_of(const T (&eye)[4], const T (&plane)[4]) noexcept {
  if constexpr (Floating<T>) {
    constexpr double up = 0x1p500;
    const auto e = scaled_near_one(vec<T, 4>{eye[0], eye[1], eye[2], eye[3]});
    const auto p = scaled_near_one(vec<T, 4>{plane[0], plane[1], plane[2], plane[3]});
    return plane_projector<double>{{e.c[0] * up, e.c[1] * up, e.c[2] * up, e.c[3] * up},
                                   {p.c[0] * up, p.c[1] * up, p.c[2] * up, p.c[3] * up}};
  } else {
    return plane_projector<T>{{eye[0], eye[1], eye[2], eye[3]}, {plane[0], plane[1], plane[2], plane[3]}};
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The matrix that moves every point along its ray to the eye into a plane, or why there is none. The eye is a position
/// or, with weight 0, the direction of all rays; its scale, the plane's and their signs do not matter.
/// shape   the image of a position has w = 1 - h(p)/h(eye), h being the distance from the plane: w is 1 on the plane
///         and, for a direction, everywhere; it is 0 in the plane through the eye parallel to the plane, and negative
///         behind it. Points of the plane stay
/// gives   eye_in_plane, direction_parallel, no_plane, no_eye, not_finite, not_representable. In floats the eye is in
///         the plane when its distance comes out as 0; otherwise a near miss gives large entries
/// exact   in rationals; in floats an entry e is off by at most 6u s (1 + |e|) (u = 2^-53; then rounded to T), s being
///         the sum of the absolute values of the products in the distance over the distance, as long as s is below
///         2^48, and the numbers of the eye, and those of the plane, differ by less than a factor of 2^900. The
///         rounding does not depend on scale
/// source  Blinn 1988
template <Plane P>
[[nodiscard]] constexpr checked<mat<typename plane_traits<P>::scalar, 4, 4>, plane_projection_status>
projection_onto_plane_checked(const P& onto, const hpoint<typename plane_traits<P>::scalar, 3>& eye) noexcept
  requires Real<typename plane_traits<P>::scalar>
{
  using T = typename plane_traits<P>::scalar;
  using enum plane_projection_status;
  const T plane[4] = {plane_traits<P>::coefficient(onto, 0), plane_traits<P>::coefficient(onto, 1),
                      plane_traits<P>::coefficient(onto, 2), plane_traits<P>::coefficient(onto, 3)};
  const T from[4] = {eye.x, eye.y, eye.z, eye.w};
  if constexpr (Floating<T>)
    for (int k = 0; k < 4; ++k)
      if (!is_finite(plane[k]) || !is_finite(from[k])) return detail::refused<T>(not_finite);
  const T zero = T(0);
  if (plane[0] == zero && plane[1] == zero && plane[2] == zero) return detail::refused<T>(no_plane);
  if (from[0] == zero && from[1] == zero && from[2] == zero && from[3] == zero) return detail::refused<T>(no_eye);

  const auto projector = detail::plane_projector_of<T>(from, plane);
  const auto height = projector.height_without(4);
  using wide = std::remove_cv_t<decltype(height)>;
  if (height == wide(0)) return detail::refused<T>(from[3] == zero ? direction_parallel : eye_in_plane);
  checked<mat<T, 4, 4>, plane_projection_status> result{};
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      const wide n = projector.numerator(r, c);
      if constexpr (Floating<T>) {
        const double entry = detail::quotient(n, height);
        if (!(magnitude(entry) <= static_cast<double>((std::numeric_limits<T>::max)())))
          return detail::refused<T>(not_representable);
        result.value(r, c) = converted<T>(entry);
      } else {
        result.value(r, c) = n / height;
      }
    }
  return result;
}

/// The matrix that moves every point along its ray to the eye into a plane; see projection_onto_plane_checked.
/// needs   what makes that one ok; where this is broken and not caught, the identity comes out
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr mat<plane_scalar<P>, 4, 4> projection_onto_plane(
    const P& onto, const hpoint<typename plane_traits<P>::scalar, 3>& eye) noexcept {
  return projection_onto_plane_checked(onto, eye).expected();
}

/// The central projection onto a plane: from an eye.
/// gives   as projection_onto_plane_checked
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr auto central_projection_onto_checked(
    const P& onto, const point<typename plane_traits<P>::scalar, 3>& eye) noexcept {
  return projection_onto_plane_checked(onto, to_homogeneous(eye));
}

/// The central projection onto a plane: from an eye.
/// needs   as projection_onto_plane
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr auto central_projection_onto(const P& onto,
                                                     const point<typename plane_traits<P>::scalar, 3>& eye) noexcept {
  return projection_onto_plane(onto, to_homogeneous(eye));
}

/// The parallel projection onto a plane: along a direction, either way. The matrix is affine.
/// gives   as projection_onto_plane_checked; no_eye for the zero vector
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr auto parallel_projection_onto_checked(
    const P& onto, const vec<typename plane_traits<P>::scalar, 3>& direction) noexcept {
  using T = typename plane_traits<P>::scalar;
  return projection_onto_plane_checked(onto, hpoint<T, 3>{direction.x, direction.y, direction.z, T(0)});
}

/// The parallel projection onto a plane: along a direction, either way. The matrix is affine.
/// needs   as projection_onto_plane; a direction that is not the zero vector
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr auto parallel_projection_onto(
    const P& onto, const vec<typename plane_traits<P>::scalar, 3>& direction) noexcept {
  return parallel_projection_onto_checked(onto, direction).expected();
}

/// The matrix that throws shadows on a plane: projection_onto_plane_checked with a light's position for the eye. Of a
/// position between the light and the plane the image has 0 < w <= 1 and is its shadow; beyond the plane w > 1, and
/// nothing is thrown there; at the light's height and above it w <= 0, and there is no shadow either. For a light at
/// infinity w is 1 everywhere: cut away yourself what lies beyond the plane.
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr auto shadow_matrix_checked(
    const P& onto, const hpoint<typename plane_traits<P>::scalar, 3>& light_position) noexcept {
  return projection_onto_plane_checked(onto, light_position);
}

/// The matrix that throws shadows on a plane; see shadow_matrix_checked.
/// needs   as projection_onto_plane
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr auto shadow_matrix(const P& onto,
                                           const hpoint<typename plane_traits<P>::scalar, 3>& light_position) noexcept {
  return projection_onto_plane(onto, light_position);
}

}  // namespace IRG_ABI
}  // namespace irg
