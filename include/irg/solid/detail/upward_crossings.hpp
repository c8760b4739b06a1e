// SPDX-License-Identifier: MIT
// How often the ray upward from a point leaves and enters a body, by its triangles, exactly.
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

namespace irg::detail {

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

// orientation_along z. Points over a corner, and over a side along an axis, are common, and need no arithmetic.
template <class P>
IRG_INLINE constexpr int orientation_from_above(const P& a, const P& b, const P& p) noexcept {
  const bool ax = coordinate(a, 0) == coordinate(p, 0), ay = coordinate(a, 1) == coordinate(p, 1);
  const bool bx = coordinate(b, 0) == coordinate(p, 0), by = coordinate(b, 1) == coordinate(p, 1);
  if ((ax && (ay || bx)) || (by && (ay || bx))) return 0;
  return orientation_along(2, a, b, p);
}

template <class P>
constexpr void count_upward_crossing(const P& a, const P& b, const P& c, const P& p, upward_crossings& out) noexcept {
  if (!may_cross_above(a, b, c, p)) return;
  const int ab = orientation_from_above(a, b, p), bc = orientation_from_above(b, c, p);
  if (ab * bc < 0) return;
  const int ca = orientation_from_above(c, a, p);
  const bool none_right = ab >= 0 && bc >= 0 && ca >= 0, none_left = ab <= 0 && bc <= 0 && ca <= 0;
  if (!none_right && !none_left) return;
  const int turn = none_right ? 1 : -1;
  // What is all above p needs no plane: p lies below it, and not on it.
  if (!(coordinate(p, 2) < coordinate(a, 2) && coordinate(p, 2) < coordinate(b, 2) &&
        coordinate(p, 2) < coordinate(c, 2))) {
    const int side = orient3d(a, b, c, p);
    if (side == 0) {
      out.on_surface = out.on_surface || is_on_triangle(a, b, c, p);
      return;
    }
    if (side == turn) return;  // below p
  }
  if (none_right && none_left) return;  // upright, as an edge is seen from above
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
    each_solid_triangle(triangulated(to_mesh<T>(body)), [&](const auto& a, const auto& b, const auto& c) {
      count_upward_crossing(a, b, c, from, count);
    });
  return count;
}

constexpr location location_by_winding(const upward_crossings& count, fill_rule rule) noexcept {
  if (count.on_surface) return location::boundary;
  const bool inside = rule == fill_rule::even_odd ? count.winding % 2 != 0 : count.winding != 0;
  return inside ? location::inside : location::outside;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
