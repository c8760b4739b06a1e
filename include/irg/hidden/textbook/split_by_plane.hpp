// SPDX-License-Identifier: MIT
// How depth sort splits a polygon by the plane of another, and how much of the screen two polygons share by the same
// step. irg::split_polygon takes polygons that are not convex, and orders what lies on the plane exactly.
#pragma once

#include <vector>

#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/hidden/textbook/newell_tests.hpp>

namespace irg::textbook {

inline namespace IRG_ABI {

/// What of a convex polygon lies on one side of a plane; both sides get the same new points.
/// exact   a new point is within 0.501 ulp of where the edge crosses the plane
template <Floating T>
[[nodiscard]] constexpr std::vector<point<T, 3>> part_on_side(const std::vector<point<T, 3>>& ring,
                                                              const visible_plane<T>& plane, int side) {
  std::vector<point<T, 3>> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const point<T, 3>&a = ring[i], &b = ring_vertex(ring, i + 1);
    const int at_a = viewed_side(plane, a), at_b = viewed_side(plane, b);
    if (at_a == side || at_a == 0) kept.push_back(a);
    if (at_a * at_b < 0)
      kept.push_back(at_a < 0 ? intersect_plane_line(plane.p, plane.q, plane.r, a, b).at
                              : intersect_plane_line(plane.p, plane.q, plane.r, b, a).at);
  }
  return kept;
}

/// The area that two convex polygons have in common on the screen: that of what of P is inside the prism over Q.
template <Floating T>
[[nodiscard]] constexpr T area_in_common(std::vector<point<T, 3>> p, const std::vector<point<T, 3>>& q) {
  const int up = visible_plane_of(q).up;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const point<T, 3>&a = q[i], &b = ring_vertex(q, i + 1);
    p = part_on_side(p, {{a.x, a.y, 0}, {b.x, b.y, 0}, {a.x, a.y, 1}, 1}, -up);
  }
  return magnitude(polygon_area(without_depth(p)));
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
