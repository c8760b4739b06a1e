// SPDX-License-Identifier: MIT
// The five tests of Newell, Newell and Sancha, by which a polygon P hides no polygon Q that is drawn after it. The z
// axis points to the viewer, and polygons are projected by leaving z out. depth_sort.hpp has the list that asks them.
#pragma once

#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/polygons_overlap.hpp>
#include <irg/hidden/vocabulary.hpp>

namespace irg::textbook {

/// Three corners of a polygon's plane; up is 1 where they run counter-clockwise for the viewer, -1 where clockwise,
/// and 0 for a polygon that is seen edge on, of whose plane neither side is the viewer's.
template <Scalar T>
struct visible_plane {
  point<T, 3> p{}, q{}, r{};
  int up = 0;
  bool operator==(const visible_plane&) const = default;
};

inline namespace IRG_ABI {

/// A polygon as the viewer sees it.
template <SpaceRing R>
[[nodiscard]] constexpr std::vector<point<ring_scalar<R>, 2>> without_depth(const R& ring) {
  std::vector<point<ring_scalar<R>, 2>> flat;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const auto& p = ring_vertex(ring, i);
    flat.push_back({coordinate(p, 0), coordinate(p, 1)});
  }
  return flat;
}

/// The plane of a polygon's first corner and the first two after it with which it has area on the screen.
template <SpaceRing R>
[[nodiscard]] constexpr visible_plane<ring_scalar<R>> visible_plane_of(const R& ring) {
  const auto flat = without_depth(ring);
  const auto at = [&](std::size_t i) { return to_point(ring_vertex(ring, i)); };
  for (std::size_t i = 1; i < flat.size(); ++i)
    for (std::size_t j = i + 1; j < flat.size(); ++j)
      if (const int up = orient2d(flat[0], flat[i], flat[j])) return {at(0), at(i), at(j), up};
  return {};
}

/// Where a point lies: 1 on the viewer's side of the plane, -1 on the other, 0 in it or where neither is the viewer's.
template <Scalar T>
[[nodiscard]] constexpr int viewed_side(const visible_plane<T>& plane, const point<T, 3>& c) noexcept {
  return plane.up * orient3d(plane.p, plane.q, plane.r, c);
}

/// Whether a ring has a corner on a side of the plane.
template <SpaceRing R>
[[nodiscard]] constexpr bool has_corner_on(const R& ring, const visible_plane<ring_scalar<R>>& plane, int side) {
  for (std::size_t i = 0; i < ring_size(ring); ++i)
    if (viewed_side(plane, to_point(ring_vertex(ring, i))) == side) return true;
  return false;
}

/// Whether a test says that P does not hide Q.
/// needs   one of the first five of newell_step, and simple flat polygons with finite coordinates
/// gives   true for extents and projections that touch, but have no area in common; corners on a plane count for either
///         side. Of a polygon that is seen edge on the plane tests say nothing: its projection has no area
/// exact   for the corners as they are; a polygon's plane is visible_plane_of
/// cost    linear, but for the last: that of polygons_overlap. Allocates
/// source  Hidden-surface slides, after Newell, Newell and Sancha 1972
template <SpaceRing P, SpaceRing Q>
  requires std::same_as<ring_scalar<P>, ring_scalar<Q>>
[[nodiscard]] constexpr bool does_not_hide_by(newell_step test, const P& p, const Q& q) {
  if (test == newell_step::x_apart || test == newell_step::y_apart) {
    const int axis = test == newell_step::x_apart ? 0 : 1;
    const auto a = bounding_box(p), b = bounding_box(q);
    return a.empty() || b.empty() || !(b.low[axis] < a.high[axis]) || !(a.low[axis] < b.high[axis]);
  }
  if (test == newell_step::behind_plane || test == newell_step::in_front_of_plane) {
    const bool behind = test == newell_step::behind_plane;
    const auto plane = behind ? visible_plane_of(q) : visible_plane_of(p);
    return plane.up != 0 && !(behind ? has_corner_on(p, plane, 1) : has_corner_on(q, plane, -1));
  }
  return polygons_overlap(without_depth(p), without_depth(q)) != polygon_overlap::overlapping;
}

/// What the list has to do with P and Q: the first of the five tests that says that P does not hide Q; `moved`, Q
/// before P, where none does.
template <SpaceRing P, SpaceRing Q>
  requires std::same_as<ring_scalar<P>, ring_scalar<Q>>
[[nodiscard]] constexpr newell_step newell_step_of(const P& p, const Q& q) {
  for (const newell_step test : {newell_step::x_apart, newell_step::y_apart, newell_step::behind_plane,
                                 newell_step::in_front_of_plane, newell_step::projections_apart})
    if (does_not_hide_by(test, p, q)) return test;
  return newell_step::moved;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
