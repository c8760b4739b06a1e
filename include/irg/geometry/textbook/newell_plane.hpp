// SPDX-License-Identifier: MIT
// Newell's plane of a polygon as printed. newell_plane (geometry/plane.hpp) counts from the first vertex, which is far
// more accurate away from the origin.
#pragma once

#include <optional>

#include <irg/geometry/plane.hpp>

namespace irg::textbook {
inline namespace IRG_ABI {

/// The plane of a polygon by Newell's sums over the coordinates as they are, through the first vertex.
/// gives   nothing for fewer than three vertices and when the normal comes out as zero
/// exact   in integers and rationals. In floats the error of the normal grows with the square of the distance from the
///         origin over the polygon's size
/// source  Mihajlovic 2016, formula 4.2, with j = i + 1 for i != n - 1 where i != n is printed
template <PolygonRing R>
  requires Point<ring_point<R>> && (size_of<ring_point<R>> == 3)
[[nodiscard]] constexpr std::optional<plane<ring_scalar<R>>> newell_plane(const R& ring) noexcept {
  using T = ring_scalar<R>;
  const std::size_t n = ring_size(ring);
  if (n < 3) return std::nullopt;
  vec<T, 3> normal{T(0), T(0), T(0)};
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = ring_vertex(ring, i), q = ring_vertex(ring, i + 1);
    const auto term = [&](int k, int l) {
      return product(coordinate(p, k) - coordinate(q, k), coordinate(p, l) + coordinate(q, l));
    };
    normal = vec<T, 3>{normal.x + term(1, 2), normal.y + term(2, 0), normal.z + term(0, 1)};
  }
  return detail::plane_with_normal(normal, ring_vertex(ring, 0));
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
