// SPDX-License-Identifier: MIT
// Sutherland and Hodgman's clipping as Hank's text has it, for teaching and comparison: one boundary after the
// other, a whole list of vertices between two of them, points on a boundary inside, whatever comes out. Cuts are made
// on what the boundaries before have left, each of them rounded. clip_sutherland_hodgman is the one to use.
#pragma once

#include <cstddef>
#include <vector>

#include <irg/geometry/line.hpp>
#include <irg/geometry/plane.hpp>

namespace irg::detail::inline IRG_ABI {

template <class T, Point P>
  requires(size_of<P> == 2 && std::same_as<scalar_of<P>, T>)
IRG_INLINE constexpr T boundary_value(const line<T>& l, const P& p) noexcept {
  return line_value(l, p);
}
template <class T, Point P>
  requires(size_of<P> == 3 && std::same_as<scalar_of<P>, T>)
IRG_INLINE constexpr T boundary_value(const plane<T>& l, const P& p) noexcept {
  return plane_value(l, p);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook::inline IRG_ABI {

/// What one boundary leaves of a polygon: the part where its value is positive or zero.
/// shape   a line<T> for rings of the plane, a plane<T> for rings in space. For each edge, from the first vertex on: in
///         to in adds the end, in to out the cut, out to out nothing, out to in the cut and the end
/// gives   vertices twice, or a chain of two, where the polygon touches the boundary; with NaN whatever comes out
/// exact   in rationals; in floats each operation rounded once
/// cost    one pass; allocates the result
/// source  Hank n.d., 4.1.5.3
template <PolygonRing R, class Boundary>
  requires requires(const R& ring, const Boundary& b) { detail::boundary_value(b, ring_vertex(ring, 0)); }
[[nodiscard]] constexpr std::vector<ring_point<R>> clip_stage(const R& ring, const Boundary& boundary) {
  using P = ring_point<R>;
  using T = scalar_of<P>;
  std::vector<P> kept;
  const std::size_t n = ring_size(ring);
  for (std::size_t i = 0; i < n; ++i) {
    const P from = ring_vertex(ring, i), to = ring_vertex(ring, i + 1);
    const T here = detail::boundary_value(boundary, from), there = detail::boundary_value(boundary, to);
    const bool leaves = !(here < T(0)) && there < T(0), enters = here < T(0) && !(there < T(0));
    if (leaves || enters) {
      const T t = here / (here - there);
      kept.push_back(generate_coordinates<P>(
          [&](int k) { return coordinate(from, k) + product(t, coordinate(to, k) - coordinate(from, k)); }));
    }
    if (!(there < T(0))) kept.push_back(to);
  }
  return kept;
}

/// What a list of boundaries leaves of a polygon, taken in turn, each by clip_stage.
/// shape   boundaries: a container of line<T> or plane<T>, positive inside
/// gives   as clip_stage; a concave polygon stays one ring, whose edges may overlap
/// exact   as clip_stage; in floats cuts may lie outside of the region by some ulps, and clipping again may
///         change them
/// source  Hank n.d., 4.1.5.3
template <PolygonRing R, class Boundaries>
  requires requires(const R& ring, const Boundaries& b) { clip_stage(ring, *std::begin(b)); }
[[nodiscard]] constexpr std::vector<ring_point<R>> clip_sutherland_hodgman(const R& ring,
                                                                           const Boundaries& boundaries) {
  std::vector<ring_point<R>> kept;
  for (std::size_t i = 0; i < ring_size(ring); ++i) kept.push_back(ring_vertex(ring, i));
  for (const auto& boundary : boundaries) kept = clip_stage(kept, boundary);
  return kept;
}

}  // namespace irg::textbook::inline IRG_ABI
