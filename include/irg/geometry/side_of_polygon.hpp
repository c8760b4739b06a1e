// SPDX-License-Identifier: MIT
// Which side of a polygon of space is seen from a point: the sign of Newell's normal times the way from the first
// vertex to the point, exactly, in doubles with a bound where that tells. A polynomial of degree 4 in the coordinates.
#pragma once

#include <cstddef>
#include <limits>

#include <irg/core/ring.hpp>
#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/detail/side_of_polygon_steps.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/exact_number.hpp>
#include <irg/math/exact/filtered_number.hpp>

namespace irg::inline IRG_ABI {

/// On which side of a polygon q lies, of the plane through its first vertex with Newell's normal: above where the
/// vertices run counter-clockwise, seen from q.
/// shape   the polygon need not be plane nor convex. q is homogeneous, its weight not negative: 0 for the direction
///         towards a point infinitely far away
/// gives   `on` for polygons without area or with fewer than three vertices, and when something is NaN or infinite
/// exact   for every finite float and double
/// cost    a few operations per vertex; where roundings do not tell, as for a point in the plane, some microseconds,
///         less for triangles
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's normal)
template <SpaceRing R, HomogeneousPoint Q>
  requires(size_of<Q> == 4 && Floating<scalar_of<Q>> && std::same_as<ring_scalar<R>, scalar_of<Q>>)
[[nodiscard]] constexpr side side_of_polygon(const R& polygon, const Q& q) noexcept {
  using T = scalar_of<Q>;
  const auto position = [&](std::size_t k) { return detail::as_point<T>(ring_vertex(polygon, k)); };
  return static_cast<side>(
      detail::face_volume_sign(ring_size(polygon), position,
                               hpoint<T, 3>{coordinate(q, 0), coordinate(q, 1), coordinate(q, 2), coordinate(q, 3)}));
}

}  // namespace irg::inline IRG_ABI
