// SPDX-License-Identifier: MIT
// Where a point lies against any polygon, and how often the polygon runs round it: by exact crossings of the ray to the
// right.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg::inline IRG_ABI {

/// How often the polygon's rings run round p, counter-clockwise (y up); clockwise rounds count negative.
/// gives   nothing when p is on an edge or a vertex, where the number is not defined, and when a coordinate is NaN or
///         infinite; 0 for a polygon without rings
/// exact   for all finite floats and all integers; other scalars: as exact as their own + - * are
/// cost    one pass; nothing allocates
template <PlanePolygon P>
[[nodiscard]] constexpr std::optional<int> winding_number(const P& polygon, const polygon_point<P>& p) noexcept;

/// Where p lies: on an edge or vertex of any ring, inside or outside of the polygon, which may be convex or not, cross
/// itself and have holes.
/// shape   `rule` says which winding numbers are inside. An edge with the inside on both sides is boundary, too
/// gives   `outside` when a coordinate is NaN or infinite, and for empty rings
/// exact   as winding_number
/// cost    as winding_number
/// source  Hormann and Agathos 2001 (the crossings rule)
template <PlanePolygon P>
[[nodiscard]] constexpr location point_in_polygon(const P& polygon, const polygon_point<P>& p,
                                                  fill_rule rule = fill_rule::non_zero) noexcept;

/// point_in_polygon of one ring by the non-zero rule.
template <PlaneRing R>
[[nodiscard]] constexpr location locate_point(const R& ring, const ring_point<R>& p) noexcept;

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// Adds the crossings of a ring with the ray to the right from p: upward ones count 1, downward ones -1. False when a
// coordinate is NaN or infinite.
template <PlaneRing R>
constexpr bool count_crossings(const R& ring, const ring_point<R>& p, int& winding, bool& on_edge) noexcept {
  const auto height = coordinate(p, 1);
  const std::size_t n = ring_size(ring);
  if (n == 0) return true;
  const auto level = [&](const ring_point<R>& v) {  // 1 above p, -1 below, 0 beside it
    return static_cast<int>(height < coordinate(v, 1)) - static_cast<int>(coordinate(v, 1) < height);
  };
  int from = level(ring_vertex(ring, n - 1));
  for (std::size_t i = 0; i < n; ++i) {
    const auto b = ring_traits<R>::vertex(ring, i);
    const int to = level(b);
    if (from * to <= 0) {  // NaN is beside everything
      const auto a = ring_vertex(ring, i == 0 ? n - 1 : i - 1);
      if (!is_finite(a, b)) return false;
      const int turn = orient2d(a, b, p);
      if (turn == 0 && is_between(a, b, p))
        on_edge = true;
      else if ((from > 0) != (to > 0) && (turn > 0) == (to > 0))
        winding += to > 0 ? 1 : -1;
    }
    from = to;
  }
  return is_finite(ring);
}

enum class crossing_count { counted, on_edge, not_finite };

template <PlanePolygon P>
constexpr crossing_count count_crossings_of(const P& polygon, const polygon_point<P>& p, int& winding) noexcept {
  bool on_edge = false;
  if (!is_finite(p) ||
      !each_ring(polygon, [&](const auto& ring) { return count_crossings(ring, p, winding, on_edge); }))
    return crossing_count::not_finite;
  return on_edge ? crossing_count::on_edge : crossing_count::counted;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <PlanePolygon P>
[[nodiscard]] constexpr std::optional<int> winding_number(const P& polygon, const polygon_point<P>& p) noexcept {
  int winding = 0;
  if (detail::count_crossings_of(polygon, p, winding) != detail::crossing_count::counted) return std::nullopt;
  return winding;
}

template <PlanePolygon P>
[[nodiscard]] constexpr location point_in_polygon(const P& polygon, const polygon_point<P>& p,
                                                  fill_rule rule) noexcept {
  int winding = 0;
  switch (detail::count_crossings_of(polygon, p, winding)) {
    case detail::crossing_count::on_edge: return location::boundary;
    case detail::crossing_count::not_finite: return location::outside;
    default: break;
  }
  const bool inside = rule == fill_rule::even_odd ? winding % 2 != 0 : winding != 0;
  return inside ? location::inside : location::outside;
}

template <PlaneRing R>
[[nodiscard]] constexpr location locate_point(const R& ring, const ring_point<R>& p) noexcept {
  return point_in_polygon(ring, p);
}

}  // namespace irg::inline IRG_ABI
