// SPDX-License-Identifier: MIT
// Whether points of space lie on a line, on a segment, on a triangle: decided by what they look like along the axes.
#pragma once

#include <irg/geometry/orient2d.hpp>
#include <irg/math/vec.hpp>

namespace irg::inline IRG_ABI {

/// A point of space as it is seen along an axis: without coordinate `axis`.
/// needs   axis 0, 1 or 2
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] IRG_INLINE constexpr point<scalar_of<P>, 2> seen_along(int axis, const P& p) noexcept {
  return {coordinate(p, axis == 0 ? 1 : 0), coordinate(p, axis == 2 ? 1 : 2)};
}

/// orient2d of three points of space as they are seen along an axis.
/// needs   finite coordinates; axis 0, 1 or 2
/// exact   as orient2d
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr int orientation_along(int axis, const P& a, const P& b, const P& c) noexcept {
  return orient2d(seen_along(axis, a), seen_along(axis, b), seen_along(axis, c));
}

/// Whether three points of space lie on one line.
/// needs   finite coordinates
/// gives   true where two of them are equal
/// exact   for every float, double and integer, as orient2d
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr bool are_collinear(const P& a, const P& b, const P& c) noexcept {
  for (int axis = 0; axis < 3; ++axis)
    if (orientation_along(axis, a, b, c) != 0) return false;
  return true;
}

/// Whether p lies on the segment from a to b, its ends included.
/// needs   finite coordinates
/// exact   as are_collinear
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr bool is_on_segment(const P& a, const P& b, const P& p) noexcept {
  for (int i = 0; i < 3; ++i) {
    const auto from = coordinate(a, i), to = coordinate(b, i), at = coordinate(p, i);
    if ((at < from && at < to) || (from < at && to < at)) return false;
  }
  return are_collinear(a, b, p);
}

/// Whether p, a point of the triangle's plane, lies on the triangle, its sides included.
/// needs   finite coordinates; orient3d(a, b, c, p) == 0
/// gives   for a triangle without area whether p lies on one of its sides
/// exact   as are_collinear
/// cost    four calls of orient2d where the triangle has an area along the first axis
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr bool is_on_triangle(const P& a, const P& b, const P& c, const P& p) noexcept {
  for (int axis = 0; axis < 3; ++axis)
    if (const int turn = orientation_along(axis, a, b, c); turn != 0)
      return orientation_along(axis, a, b, p) * turn >= 0 && orientation_along(axis, b, c, p) * turn >= 0 &&
             orientation_along(axis, c, a, p) * turn >= 0;
  return is_on_segment(a, b, p) || is_on_segment(b, c, p) || is_on_segment(c, a, p);
}

IRG_REFUSES_VECTORS(are_collinear);
IRG_REFUSES_VECTORS(is_on_segment);
IRG_REFUSES_VECTORS(is_on_triangle);

}  // namespace irg::inline IRG_ABI
