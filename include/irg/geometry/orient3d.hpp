// SPDX-License-Identifier: MIT
// On which side of the plane through three points a fourth one lies, decided exactly.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/orient3d_steps.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

inline namespace IRG_ABI {

/// 1 when d lies on the side of the plane abc from which a, b, c are seen counter-clockwise, which is the sign of
/// plane_through(a, b, c) at d; -1 on the other side, 0 on the plane and when a, b, c lie on a line.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 40 operations on floats where the points are not nearly coplanar, else 200 where multiply-adds are
///         fused; integers of 192 bits where that leaves it open, of 384 where exponents differ by more than 8; beyond
///         72 another 400 operations on floats, and an exact sum of 24 products for points nearly coplanar even so
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] IRG_INLINE constexpr int orient3d(const P& a, const P& b, const P& c,
                                                const P& d) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c, d);
}

IRG_REFUSES_VECTORS(orient3d);

}  // namespace IRG_ABI
}  // namespace irg
