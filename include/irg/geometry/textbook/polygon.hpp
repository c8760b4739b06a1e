// SPDX-License-Identifier: MIT
// Area, orientation and point location of polygons by the rules of lectures. polygon_area, orientation_of and
// point_in_polygon are the ones to use.
#pragma once

#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/geometry/polygon_orientation.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The signed area by half the sum of x1*y2 - x2*y1 as it stands, the textbook's shoelace formula.
/// exact   in rationals; in floats off by (n + 1) u times the sum of all |x1*y2| and |x2*y1|, which grows with the
///         square of the distance from the origin: at 10^8 sizes away nothing is left of a double
/// source  Meister 1769 (the shoelace formula)
template <PlanePolygon P>
  requires Real<scalar_of<polygon_point<P>>>
[[nodiscard]] constexpr auto polygon_area(const P& polygon) noexcept {
  using T = scalar_of<polygon_point<P>>;
  T twice(0);
  detail::each_edge(polygon, [&](const auto& p, const auto& q) {
    twice = twice + (product(coordinate(p, 0), coordinate(q, 1)) - product(coordinate(q, 0), coordinate(p, 1)));
  });
  return T(twice / T(2));
}

/// The lecture's criterion 3.2: clockwise or counter-clockwise when every vertex V(i+2) lies on that side of edge i.
/// gives   `degenerate` when the signs differ or one is zero. It looks at three vertices at a time: a pentagram passes,
///         a convex polygon with collinear vertices does not; is_convex and orientation_of decide those
/// exact   as orientation_of
/// source  Mihajlovic 2016, criterion 3.2
template <PlaneRing R>
[[nodiscard]] constexpr orientation orientation_of(const R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  if (n < 3 || !is_finite(ring)) return orientation::degenerate;
  const auto turn = [&](std::size_t i) {
    return orient2d(ring_vertex(ring, i), ring_vertex(ring, i + 1), ring_vertex(ring, i + 2));
  };
  const int first = turn(0);
  for (std::size_t i = 1; i < n; ++i)
    if (turn(i) != first) return orientation::degenerate;
  return static_cast<orientation>(first);
}

/// Rules 3.3 and 3.4 of lectures as they stand, for a clockwise ring: outside when p lies on the left of some edge (a
/// positive value of its equation), inside when it lies on the right of all, boundary otherwise.
/// needs   a clockwise convex ring without repeated vertices: an edge without length has the value 0 everywhere, so
///         that it takes the inside for the boundary
/// gives   `outside` when a coordinate of p is NaN or infinite
/// exact   as point_in_convex_polygon
/// source  Mihajlovic 2016, rules 3.3 and 3.4. Its exercise prints the boundary as inside
template <PlaneRing R>
[[nodiscard]] constexpr location point_in_convex_polygon(const R& ring, const ring_point<R>& p) noexcept {
  if (!is_finite(p)) return location::outside;
  bool all_negative = true;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const int value = orient2d(ring_vertex(ring, i), ring_vertex(ring, i + 1), p);
    if (value > 0) return location::outside;
    all_negative = all_negative && value < 0;
  }
  return all_negative ? location::inside : location::boundary;
}

}  // namespace irg::textbook::inline IRG_ABI
