// SPDX-License-Identifier: MIT
// Where points that were constructed lie against a triangle: above which, on which.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/exact_point.hpp>
#include <irg/solid/detail/exact_vertices.hpp>
#include <irg/solid/detail/upward_crossings.hpp>
#include <irg/solid/detail/triangle_contacts.hpp>

namespace irg::detail::inline IRG_ABI {

// A point, and the numbers nearest to it.
template <class Exact>
struct near_point {
  const Exact& exact;
  point<double, 3> rounded = exact.rounded();

  // How far these may be from it, and more.
  constexpr double slack() const noexcept {
    const double size = maximum(maximum(magnitude(rounded.x), magnitude(rounded.y)), magnitude(rounded.z));
    return size * 0x1p-50 + 0x1p-1000;
  }
};

// orient2d of a, b and a point, seen along an axis: by the rounded point where that tells.
template <class Exact>
constexpr int orientation_near(int axis, const point<double, 3>& a, const point<double, 3>& b,
                               const near_point<Exact>& at) {
  const auto p = seen_along(axis, a), q = seen_along(axis, b), r = seen_along(axis, at.rounded);
  if (const int sign = sure_turn(p, q, r); sign != 0) return sign;
  return irg::orientation_along(axis, Exact(a), Exact(b), at.exact);
}

// As count_upward_crossing.
template <class Exact>
constexpr void count_exact_crossing(const std::vector<point<double, 3>>& positions, const triangle_indices& t,
                                    const near_point<Exact>& p, upward_crossings& out) {
  const auto at = [&](int k) -> const point<double, 3>& { return positions[t.v[k % 3]]; };
  int sign[3]{};
  bool none_right = true, none_left = true;
  for (int k = 0; k < 3; ++k) {
    sign[k] = orientation_near(2, at(k), at(k + 1), p);
    none_right = none_right && sign[k] >= 0;
    none_left = none_left && sign[k] <= 0;
  }
  if (none_right == none_left) return;  // beside, or upright
  const int side = sign_of(side_of_plane(at(0), at(1), at(2), p.exact)), turn = none_right ? 1 : -1;
  if (side == 0) out.on_surface = true;
  if (side == turn || side == 0) return;
  for (int k = 0; k < 3; ++k)
    if (orientation_of_moved(at(k), at(k + 1), sign[k]) != turn) return;
  out.winding += turn;
}

// Whether a point of a triangle lies on another in the same plane: 1 where both look the same way, -1 where they do
// not, 0 where it is elsewhere.
template <class Exact>
constexpr int turn_of_cover(const std::vector<point<double, 3>>& positions, const triangle_indices& own,
                            const triangle_indices& other, const near_point<Exact>& p) {
  const seen_triangle s = see_triangle(positions, other, 0);
  for (int k = 0; k < 3; ++k)
    if (orientation_near(s.axis, *s.p[k], *s.p[(k + 1) % 3], p) * s.turn <= 0) return 0;
  return s.turn * orientation_along(s.axis, positions[own.v[0]], positions[own.v[1]], positions[own.v[2]]);
}

}  // namespace irg::detail::inline IRG_ABI
