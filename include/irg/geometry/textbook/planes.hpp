// SPDX-License-Identifier: MIT
// Planes as the printed sources have them: Newell's, by inverting a matrix, and a parametric one at the middle of three
// points.
#pragma once

#include <optional>

#include <irg/geometry/parametric_plane.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/geometry/plane_by_inversion.hpp>

namespace irg::textbook::inline IRG_ABI {

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

/// The formula as printed, D in the matrix and 1 on the right side: its solution ends in 1/D, not in D.
/// needs   a d that is not zero
/// source  Mihajlovic 2016, formula 4.3
template <HomogeneousPoint P>
  requires(size_of<P> == 4 && Real<scalar_of<P>>)
[[nodiscard]] constexpr checked<plane<scalar_of<P>>, inversion_status> plane_by_inversion(const P& p1, const P& p2,
                                                                                          const P& p3,
                                                                                          scalar_of<P> d) noexcept {
  return irg::plane_by_inversion(p1, p2, p3, scalar_of<P>(1) / d);
}

/// The plane whose origin is the middle point: directions a - b and c - b, origin b.
/// gives   nothing when the points lie exactly on a line, or a coordinate is NaN or infinite
/// exact   as parametric_plane_through
/// source  Hank n.d., 1.3.2, which refuses coincident points only
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr std::optional<parametric_plane<scalar_of<P>>> parametric_plane_at_middle(const P& a, const P& b,
                                                                                                 const P& c) noexcept {
  return parametric_plane_through(b, a, c);
}

/// The same with Hank's check: points must differ from each other, nothing more. (0,0,0), (1,1,1), (2,2,2) pass
/// and give two dependent directions.
/// source  Hank n.d., 1.3.2 as printed
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr std::optional<parametric_plane<scalar_of<P>>> parametric_plane_as_printed(const P& a,
                                                                                                  const P& b,
                                                                                                  const P& c) noexcept {
  using T = scalar_of<P>;
  if (same_place(a, b) || same_place(b, c) || same_place(a, c)) return std::nullopt;
  return parametric_plane<T>{detail::displacement<T>(b, a), detail::displacement<T>(b, c), detail::as_point<T>(b)};
}

}  // namespace irg::textbook::inline IRG_ABI
