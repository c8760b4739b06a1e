// SPDX-License-Identifier: MIT
// On which side of the line through two points a third one lies, decided exactly.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/orient2d_steps.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

inline namespace IRG_ABI {

/// 1 when the way from a over b to c turns left (counter-clockwise, y up), -1 when it turns right, 0 when the three
/// points lie on a line.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 10 operations on floats where the points are not nearly collinear, else 50; integers of 128 bits where
///         that leaves it open, of 256 where exponents differ by more than 8; beyond 72 another 150 operations on
///         floats, and an exact sum of 6 products for points that are nearly collinear even so
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] IRG_INLINE constexpr int orient2d(const P& a, const P& b,
                                                const P& c) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c);
}

IRG_REFUSES_VECTORS(orient2d);

}  // namespace IRG_ABI
}  // namespace irg
