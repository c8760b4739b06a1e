// SPDX-License-Identifier: MIT
// Where a point lies against any polygon, and how often the polygon runs round it: by exact crossings of the ray to the
// right.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/core/location.hpp>
#include <irg/geometry/detail/point_in_polygon_steps.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg::inline IRG_ABI {

/// How often the polygon's rings run round p, counter-clockwise (y up); clockwise rounds count negative.
/// gives   nothing when p is on an edge or a vertex, where the number is not defined, and when a coordinate is NaN or
///         infinite; 0 for a polygon without rings
/// exact   for all finite floats and all integers; other scalars: as exact as their own + - * are
/// cost    one pass; nothing allocates
template <PlanePolygon P>
[[nodiscard]] constexpr std::optional<int> winding_number(const P& polygon, const polygon_point<P>& p) noexcept {
  int winding = 0;
  if (detail::count_crossings_of(polygon, p, winding) != detail::crossing_count::counted) return std::nullopt;
  return winding;
}

/// Where p lies: on an edge or vertex of any ring, inside or outside of the polygon, which may be convex or not, cross
/// itself and have holes.
/// shape   `rule` says which winding numbers are inside. An edge with the inside on both sides is boundary, too
/// gives   `outside` when a coordinate is NaN or infinite, and for empty rings
/// exact   as winding_number
/// cost    as winding_number
/// source  Hormann and Agathos 2001 (the crossings rule)
template <PlanePolygon P>
[[nodiscard]] constexpr location point_in_polygon(const P& polygon, const polygon_point<P>& p,
                                                  fill_rule rule = fill_rule::non_zero) noexcept {
  int winding = 0;
  switch (detail::count_crossings_of(polygon, p, winding)) {
    case detail::crossing_count::on_edge: return location::boundary;
    case detail::crossing_count::not_finite: return location::outside;
    default: break;
  }
  const bool inside = rule == fill_rule::even_odd ? winding % 2 != 0 : winding != 0;
  return inside ? location::inside : location::outside;
}

/// point_in_polygon of one ring by the non-zero rule.
template <PlaneRing R>
[[nodiscard]] constexpr location locate_point(const R& ring, const ring_point<R>& p) noexcept {
  return point_in_polygon(ring, p);
}

}  // namespace irg::inline IRG_ABI
