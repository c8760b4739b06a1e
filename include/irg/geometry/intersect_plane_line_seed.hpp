// SPDX-License-Identifier: MIT
// Hank's program's plane against line: three equations in s1, s2 and t by its own Gauss elimination.
// intersect_plane_line (intersect_plane_line.hpp) is the one to use.
#pragma once

#include <optional>

#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/math/solve_gauss_seed.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The crossing of a parametric plane and a parametric line as Hank's program finds it.
/// gives   nothing when its elimination calls the equations singular: for parallel and contained lines, and for planes
///         and lines whose directions are merely short
/// exact   no bound: the pivot is whatever stands on the diagonal
/// source  Hank n.d., 1.3.5: s1*first + s2*second - t*direction = line's origin - plane's origin
template <Real T>
constexpr std::optional<parametric_meeting<T>> intersect_plane_line_seed(
    const parametric_plane<T>& plane, const parametric_line<T, 3>& line,
    std::type_identity_t<T> zero = seed_zero<T>) noexcept {
  mat<T, 3, 4> equations;
  for (int i = 0; i < 3; ++i) {
    equations(i, 0) = plane.first[i], equations(i, 1) = plane.second[i], equations(i, 2) = -line.direction[i];
    equations(i, 3) = line.origin[i] - plane.origin[i];
  }
  const auto x = solve_gauss_seed(equations, zero);
  if (!x) return std::nullopt;
  return parametric_meeting<T>{plane_line_relation::crossing, point_at(line, x->z), x->x, x->y, x->z};
}

}  // namespace IRG_ABI
}  // namespace irg
