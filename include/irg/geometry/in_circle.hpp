// SPDX-License-Identifier: MIT
// Whether a point lies inside the circle through three others, or in space inside the sphere through four, decided
// exactly.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/in_circle_steps.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>

namespace irg {

inline namespace IRG_ABI {

/// 1 when d lies inside the circle through a, b, c, -1 when it lies outside, 0 when it lies on it; for a, b, c that
/// turn left. Where they turn right the signs are the other way round; where they lie on a line, the sign is 0 when d
/// does, too, and else tells on which side of the line d lies.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 50 operations on floats where the points are not nearly on a circle; else integers of 256 bits, of 512
///         where exponents differ by more than 8; beyond 72 another 500 operations on floats, and an exact sum of 48
///         products for points that are nearly on a circle even so
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] IRG_INLINE constexpr int in_circle(const P& a, const P& b, const P& c,
                                                 const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c, d);
}

/// 1 when e lies inside the sphere through a, b, c, d, -1 when it lies outside, 0 when it lies on it; for
/// orient3d(a, b, c, d) = 1. Where that is -1 the signs are the other way round; where it is 0, the sign is 0 when e
/// lies in the plane, too, or a, b, c, d on a circle.
/// needs   finite coordinates
/// exact   as in_circle
/// cost    about 120 operations on floats where the points are not nearly on a sphere; else integers of 320 bits, of
///         640 where exponents differ by more than 8; beyond 72 another 1200 operations on floats, and an exact sum of
///         360 products for points that are nearly on a sphere even so
/// source  as in_circle
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] IRG_INLINE constexpr int in_sphere(const P& a, const P& b, const P& c, const P& d,
                                                 const P& e) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c, d, e);
}

IRG_REFUSES_VECTORS(in_circle);
IRG_REFUSES_VECTORS(in_sphere);

}  // namespace IRG_ABI
}  // namespace irg
