// SPDX-License-Identifier: MIT
// Whether a mesh is closed, and whether it is the surface of a convex body: of such a body nothing but back faces is
// hidden by itself. A closed surface that bends one way at every edge may still wind round more than once; so the rays
// from a point within are counted, too.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/point_on_triangle.hpp>
#include <irg/mesh/detail/convex_body_steps.hpp>
#include <irg/mesh/face_normal.hpp>

namespace irg {

inline namespace IRG_ABI {

/// Whether a mesh is closed: along each side of a face one other side runs the other way.
/// gives   true for a mesh without faces; false where a side joins a position to itself or more than two faces meet.
///         Positions are told apart by their numbers: seams of equal positions are open
/// exact   no arithmetic
/// cost    sorts the sides; allocates them
template <Mesh M>
[[nodiscard]] constexpr bool is_closed(const M& m) {
  return detail::are_paired(detail::sorted_sides(m));
}

/// Whether a mesh is the whole surface of one convex body, its faces counter-clockwise seen from outside. Its front
/// faces then hide none of each other.
/// needs   as validate: faces that name positions of the mesh
/// gives   false for faces that are not plane, even in their last bit, and for faces without area, whose triangles may
///         bound a convex body all the same; for bodies turned inside out, and for positions that are not finite. Faces
///         in one plane may meet, and corners may lie on a line
/// exact   for the numbers as they are
/// cost    sorts the sides, then some eight signs of orient3d for each triangle; allocates sides and corners
/// source  Mehlhorn et al. 1999 (convexity by edges and one ray)
template <detail::mesh_in_space M>
[[nodiscard]] constexpr bool is_convex_body(const M& m) {
  return detail::convexity_check<M>(m)();
}

}  // namespace IRG_ABI
}  // namespace irg
