// SPDX-License-Identifier: MIT
// The plane of a polygon in space as textbooks take it, from one corner: three vertices in a row that are not
// collinear, the middle one where the polygon is convex. At a reflex vertex the same three would give the opposite
// side. newell_plane (plane.hpp) uses all vertices and needs no such corner.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/geometry/compare.hpp>
#include <irg/geometry/plane.hpp>

namespace irg::inline IRG_ABI {

/// The plane through the vertex of least x (of these of least y, of these of least z), where a simple polygon is
/// convex whatever its shape, and through the nearest vertices before and behind it that lie elsewhere. A polygon that
/// runs counter-clockwise as seen from outside gets the plane whose normal points outward.
/// needs   a simple, flat polygon
/// gives   nothing when these three are collinear (a polygon without area, or one with a spike there) or fewer than
///         three vertices differ
/// exact   as plane_through: in integers and rationals; in floats of a needle's tip only the rounded plane
/// cost    one pass
/// source  Mihajlovic 2016, 4.7
template <PolygonRing R>
  requires Point<ring_point<R>> && (size_of<ring_point<R>> == 3)
[[nodiscard]] constexpr std::optional<plane<ring_scalar<R>>> plane_at_corner(const R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  if (n < 3) return std::nullopt;
  std::size_t corner = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (compare_lexicographic(ring_vertex(ring, i), ring_vertex(ring, corner)) < 0) corner = i;
  const auto middle = ring_vertex(ring, corner);
  std::size_t before = 1, behind = 1;
  while (before < n && compare_lexicographic(ring_vertex(ring, corner + n - before), middle) == 0) ++before;
  while (behind < n && compare_lexicographic(ring_vertex(ring, corner + behind), middle) == 0) ++behind;
  if (before == n || behind == n) return std::nullopt;
  return plane_through(ring_vertex(ring, corner + n - before), middle, ring_vertex(ring, corner + behind));
}

}  // namespace irg::inline IRG_ABI
