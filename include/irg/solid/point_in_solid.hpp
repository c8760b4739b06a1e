// SPDX-License-Identifier: MIT
// Where a point lies against a body: by the sides of its planes for convex ones, for all others by a ray.
//
// The ray goes up from the point, along z. Each triangle that it leaves the body by counts 1, each that it enters by
// -1: the sum tells how often the surface runs round the point. Rays through a side or a corner are no special case:
// the point stands as if it had been moved by an infinitely small e along x and e^2 along y, so that, seen from above,
// it is on no side. Where orient2d is zero, the sign of what the move adds decides; both triangles at a side agree on
// it, up to the side's direction. What the move must not hide, a point on the surface itself, is asked first.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <irg/geometry/compare.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/point_on_triangle.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/to_mesh.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/solid/detail/upward_crossings.hpp>

namespace irg::inline IRG_ABI {

/// How often a closed surface runs round p: 1 inside of a body whose faces are counter-clockwise seen from outside, -1
/// where they are turned inside out, 2 where two bodies overlap.
/// needs   a mesh in which validate() finds no defect. Where it is not closed, the number counts what a ray upward from
///         p meets, no more
/// gives   nothing when p is on the surface; 0 for a mesh without faces and when p is not finite. Faces with positions
///         that are not finite count as missing
/// exact   for all finite floats and doubles, and for the triangles that triangulated() makes of the faces: they cover
///         a plane simple face exactly, and a face that is not plane is its triangles
/// cost    linear; allocates the triangles. solid_locator keeps them for many points
/// source  Hoffmann 1989 (the ray), Edelsbrunner and Muecke 1990 (the move)
template <SpaceMesh M>
[[nodiscard]] constexpr std::optional<int> winding_number(const M& body, const mesh_point<M>& p) {
  const detail::upward_crossings count = detail::count_upward_crossings(body, p);
  if (count.on_surface) return std::nullopt;
  return count.winding;
}

/// Where p lies against a body, convex or not, of any number of shells: on a face, side or corner, inside or outside.
/// shape   `rule` says which winding numbers are inside: even_odd is the parity of the faces that a ray meets
/// needs   as winding_number
/// gives   as winding_number
/// exact   as winding_number
/// cost    as winding_number
/// source  Mihajlovic 2016, 4.8 (the parity of a ray's faces); Hoffmann 1989
template <SpaceMesh M>
[[nodiscard]] constexpr location point_in_solid(const M& body, const mesh_point<M>& p,
                                                fill_rule rule = fill_rule::non_zero) {
  return detail::location_by_winding(detail::count_upward_crossings(body, p), rule);
}

/// Where p lies against a convex body: inside when it is behind all faces, outside when it is in front of one.
/// needs   a mesh for which is_convex_body() holds; for others the answer is that of the common part of the half-spaces
///         behind the faces
/// gives   outside when p is not finite, and for a mesh without faces
/// exact   for all finite floats and doubles
/// cost    one orient3d for each face, up to the first that p is in front of; nothing allocated
/// source  Mihajlovic 2016, formulas 4.12 and 4.13
template <SpaceMesh M>
[[nodiscard]] constexpr location point_in_convex_solid(const M& body, const mesh_point<M>& p) {
  const std::size_t faces = mesh_face_count(body);
  if (faces == 0 || !is_finite(p)) return location::outside;
  location where = location::inside;
  for (std::size_t f = 0; f < faces; ++f) {
    const std::size_t n = mesh_face_size(body, f);
    const auto corner = [&](std::size_t k) { return mesh_position(body, mesh_face_vertex(body, f, k)); };
    const mesh_point<M> first = corner(0);
    std::size_t k = 2;
    while (k < n && are_collinear(first, corner(k - 1), corner(k))) ++k;
    const int side = k < n ? orient3d(first, corner(k - 1), corner(k), p) : -1;
    if (side > 0) return location::outside;
    if (side == 0) where = location::boundary;
  }
  return where;
}

}  // namespace irg::inline IRG_ABI
