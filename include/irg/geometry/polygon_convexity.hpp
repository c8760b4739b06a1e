// SPDX-License-Identifier: MIT
// Whether a polygon is convex, decided exactly for the coordinates as they are, however nearly collinear.
#pragma once

#include <cstddef>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/vec.hpp>

namespace irg::inline IRG_ABI {

/// Whether the polygon is convex: it turns one way only, and goes round once. Collinear and repeated vertices are
/// allowed; so are points and segments there and back, which are convex, too. Polygons that cross themselves are not.
/// gives   false when a coordinate is NaN or infinite; true for an empty ring
/// exact   for all finite floats and all integers; other scalars: as exact as their own + - * are
/// cost    one pass; nothing allocates
template <PlaneRing R>
[[nodiscard]] constexpr bool is_convex(const R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  if (!is_finite(ring)) return false;
  std::size_t start = 1;  // an edge that has a length ends there
  while (start <= n && same_place(ring_vertex(ring, start - 1), ring_vertex(ring, start))) ++start;
  if (n == 0 || start > n) return true;
  auto a = as_assignable(ring_vertex(ring, start - 1)), b = as_assignable(ring_vertex(ring, start));
  bool turns_left = false, turns_right = false;
  int changes = 0;  // of leading forward and leading back: two in one round
  for (std::size_t i = start + 1; i <= start + n; ++i) {
    const auto c = as_assignable(ring_vertex(ring, i));
    if (same_place(b, c)) continue;
    const int turn = orient2d(a, b, c);
    turns_left = turns_left || turn > 0;
    turns_right = turns_right || turn < 0;
    changes += comes_before(a, b) != comes_before(b, c);
    if ((turns_left && turns_right) || changes > 2) return false;
    a = b;
    b = c;
  }
  return true;
}

}  // namespace irg::inline IRG_ABI
