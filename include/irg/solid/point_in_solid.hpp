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

namespace irg {
namespace detail {

// The triangles that a ray upward has crossed.
struct upward_crossings {
  int winding = 0;
  bool on_surface = false;
};

inline namespace IRG_ABI {

// orient2d of a, b and the moved point, seen from above: not zero where a and b differ there.
template <class P>
constexpr int orientation_of_moved(const P& a, const P& b, int orientation) noexcept {
  if (orientation != 0) return orientation;
  const int down = compare_numbers(coordinate(a, 1), coordinate(b, 1));
  return down != 0 ? down : compare_numbers(coordinate(b, 0), coordinate(a, 0));
}

// Whether the ray upward from p may meet a triangle: its box, seen from above, and its top.
template <class P>
IRG_INLINE constexpr bool may_cross_above(const P& a, const P& b, const P& c, const P& p) noexcept {
  const auto within = [](const auto& u, const auto& v, const auto& w, const auto& at) {
    return !(at < u && at < v && at < w) && !(u < at && v < at && w < at);
  };
  return within(coordinate(a, 0), coordinate(b, 0), coordinate(c, 0), coordinate(p, 0)) &&
         within(coordinate(a, 1), coordinate(b, 1), coordinate(c, 1), coordinate(p, 1)) &&
         !(coordinate(a, 2) < coordinate(p, 2) && coordinate(b, 2) < coordinate(p, 2) &&
           coordinate(c, 2) < coordinate(p, 2));
}

template <class P>
constexpr void count_upward_crossing(const P& a, const P& b, const P& c, const P& p, upward_crossings& out) noexcept {
  if (!may_cross_above(a, b, c, p)) return;
  const int ab = orientation_along(a, b, p, 2), bc = orientation_along(b, c, p, 2), ca = orientation_along(c, a, p, 2);
  const bool none_right = ab >= 0 && bc >= 0 && ca >= 0, none_left = ab <= 0 && bc <= 0 && ca <= 0;
  if (!none_right && !none_left) return;
  const int side = orient3d(a, b, c, p);
  if (side == 0) {
    out.on_surface = out.on_surface || is_on_triangle(a, b, c, p);
    return;
  }
  if (none_right && none_left) return;  // upright, as an edge is seen from above
  const int turn = none_right ? 1 : -1;
  if (side == turn) return;  // below p
  if (orientation_of_moved(a, b, ab) == turn && orientation_of_moved(b, c, bc) == turn &&
      orientation_of_moved(c, a, ca) == turn)
    out.winding += turn;
}

// Calls use(a, b, c) with the corners of all triangles of a mesh that are finite.
template <class T, class Use>
constexpr void each_solid_triangle(const mesh<T>& m, const Use& use) {
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto corner = [&](std::size_t k) { return m.positions[m.corner(f, k).position]; };
    const point<T, 3> a = corner(0), b = corner(1), c = corner(2);
    if (is_finite(a, b, c)) use(a, b, c);
  }
}

template <class M>
constexpr upward_crossings count_upward_crossings(const M& body, const mesh_point<M>& p) {
  using T = scalar_of<mesh_point<M>>;
  upward_crossings count;
  const point<T, 3> from{coordinate(p, 0), coordinate(p, 1), coordinate(p, 2)};
  if (is_finite(from))
    each_solid_triangle(triangulate(to_mesh<T>(body)), [&](const auto& a, const auto& b, const auto& c) {
      count_upward_crossing(a, b, c, from, count);
    });
  return count;
}

constexpr point_location location_by_winding(const upward_crossings& count, fill_rule rule) noexcept {
  if (count.on_surface) return point_location::boundary;
  const bool inside = rule == fill_rule::even_odd ? count.winding % 2 != 0 : count.winding != 0;
  return inside ? point_location::inside : point_location::outside;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// How often a closed surface runs round p: 1 inside of a body whose faces are counter-clockwise seen from outside, -1
/// where they are turned inside out, 2 where two bodies overlap.
/// needs   a mesh in which validate() finds no defect. Where it is not closed, the number counts what a ray upward from
///         p meets, no more
/// gives   nothing when p is on the surface; 0 for a mesh without faces and when p is not finite. Faces with positions
///         that are not finite count as missing
/// exact   for all finite floats and doubles, and for the triangles that triangulate() makes of the faces: they cover a
///         plane simple face exactly, and a face that is not plane is its triangles
/// cost    linear; allocates the triangles. solid_locator keeps them for many points
/// source  Hoffmann 1989 (the ray), Edelsbrunner and Muecke 1990 (the move)
template <detail::mesh_in_space M>
constexpr std::optional<int> winding_number(const M& body, const mesh_point<M>& p) {
  const detail::upward_crossings count = detail::count_upward_crossings(body, p);
  if (count.on_surface) return std::nullopt;
  return count.winding;
}

/// Where p lies against a body, convex or not, of any number of shells: on a face, side or corner, inside or outside.
/// shape   `rule` says which winding numbers are inside: even_odd is the parity of the faces that a ray meets
/// needs, gives, exact, cost   as winding_number
/// source  Mihajlovic 2016, 4.8 (the parity of a ray's faces); Hoffmann 1989
template <detail::mesh_in_space M>
constexpr point_location point_in_solid(const M& body, const mesh_point<M>& p, fill_rule rule = fill_rule::non_zero) {
  return detail::location_by_winding(detail::count_upward_crossings(body, p), rule);
}

/// Where p lies against a convex body: inside when it is behind all faces, outside when it is in front of one.
/// needs   a mesh for which is_convex_body() holds; for others the answer is that of the common part of the half-spaces
///         behind the faces
/// gives   outside when p is not finite, and for a mesh without faces
/// exact   for all finite floats and doubles
/// cost    one orient3d for each face, up to the first that p is in front of; nothing allocated
/// source  Mihajlovic 2016, formulas 4.12 and 4.13
template <detail::mesh_in_space M>
constexpr point_location point_in_convex_solid(const M& body, const mesh_point<M>& p) {
  const std::size_t faces = mesh_face_count(body);
  if (faces == 0 || !is_finite(p)) return point_location::outside;
  point_location where = point_location::inside;
  for (std::size_t f = 0; f < faces; ++f) {
    const std::size_t n = mesh_face_size(body, f);
    const auto corner = [&](std::size_t k) { return mesh_position(body, mesh_face_vertex(body, f, k)); };
    const mesh_point<M> first = corner(0);
    std::size_t k = 2;
    while (k < n && are_collinear(first, corner(k - 1), corner(k))) ++k;
    const int side = k < n ? orient3d(first, corner(k - 1), corner(k), p) : -1;
    if (side > 0) return point_location::outside;
    if (side == 0) where = point_location::boundary;
  }
  return where;
}

}  // namespace IRG_ABI
}  // namespace irg
