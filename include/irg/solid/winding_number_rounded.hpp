// SPDX-License-Identifier: MIT
// How much of the view from a point is covered by a surface, its back counted positive: of a closed body a whole
// number, of a scan with holes one between, so that most of inside and outside can still be told.
//
// The angle that a triangle covers comes from the unit vectors a, b, c towards its corners: tan(angle / 2) is
// det(a, b, c) over 1 + ab + bc + ca. Both are far from overflow at any size of the body.
#pragma once

#include <cstddef>

#include <irg/math/length.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/solid/point_in_solid.hpp>

namespace irg {
namespace detail::inline IRG_ABI {

// Half the solid angle of a triangle seen from the origin, positive where it turns its back; 0 with a corner there.
constexpr double half_solid_angle(const vec<double, 3>& to_a, const vec<double, 3>& to_b,
                                  const vec<double, 3>& to_c) noexcept {
  const vec<double, 3> a = normalized(to_a), b = normalized(to_b), c = normalized(to_c);
  const double volume = dot(a, cross(b, c));
  const double rest = 1 + (dot(a, b) + (dot(b, c) + dot(c, a)));
  return volume == 0 ? 0 : atan2(volume, rest);
}

// The way from p to q, halved where it could be infinite.
template <class P>
constexpr vec<double, 3> way_to(const P& p, const P& q) noexcept {
  double reach = 0;
  for (int i = 0; i < 3; ++i)
    reach = maximum(reach, maximum(magnitude(widened(coordinate(p, i))), magnitude(widened(coordinate(q, i)))));
  const double factor = reach < 0x1p1022 ? 1 : 0.5;
  const auto part = [factor](const auto& x) { return product(widened(x), factor); };
  return {part(coordinate(q, 0)) - part(coordinate(p, 0)), part(coordinate(q, 1)) - part(coordinate(p, 1)),
          part(coordinate(q, 2)) - part(coordinate(p, 2))};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The winding number of any surface, closed or not, round p: the solid angle that its faces cover, over that of the
/// whole sphere; faces that turn their backs to p count positive.
/// gives   close to a whole number for a closed surface, 1 inside of a body and 0 outside; between for surfaces with
///         holes, one half being the place to part inside from outside; 0 for faces in whose plane p lies; 0 when p is
///         not finite
/// exact   rounded: each triangle is off by less than 32u (1 + d/h), d the largest distance of its corners from p and h
///         the distance of p from its sides (u = 2^-53); winding_number decides exactly where the surface is closed
/// cost    three roots, nine divisions and an arc tangent a triangle; allocates the triangles
/// source  Van Oosterom and Strackee 1983 (the angle); Jacobson et al. 2013 (the number for open surfaces)
template <SpaceMesh M>
[[nodiscard]] constexpr double winding_number_rounded(const M& surface, const mesh_point<M>& p) {
  using T = scalar_of<mesh_point<M>>;
  if (!is_finite(p)) return 0;
  const point<T, 3> from{coordinate(p, 0), coordinate(p, 1), coordinate(p, 2)};
  double sum = 0, error = 0;
  detail::each_solid_triangle(triangulated(to_mesh<T>(surface)), [&](const auto& a, const auto& b, const auto& c) {
    const auto next = two_sum(
        sum, detail::half_solid_angle(detail::way_to(from, a), detail::way_to(from, b), detail::way_to(from, c)));
    sum = next.value, error = error + next.error;
  });
  return (sum + error) / two_pi<double>;
}

}  // namespace IRG_ABI
}  // namespace irg
