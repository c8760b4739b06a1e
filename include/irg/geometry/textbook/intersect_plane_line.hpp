// SPDX-License-Identifier: MIT
// A plane and a line: the lecture's formula, and Hank's program's three equations in s1, s2 and t by its own Gauss
// elimination.
// intersect_plane_line (geometry/intersect_plane_line.hpp) is the one to use.
#pragma once

#include <optional>

#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/geometry/textbook/intersect_lines.hpp>
#include <irg/math/textbook/solve_gauss.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The parameter by the lecture's formula, t = -(V1 R)/((V2 - V1) R), as printed for points of weight 1.
/// gives   nothing when the divisor comes out as zero: parallel or contained, or nearly
/// exact   in rationals; in floats each operation rounded once
/// source  Mihajlovic 2016, 4.5
template <Plane L, Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>> && std::same_as<plane_scalar<L>, scalar_of<P>>)
[[nodiscard]] constexpr std::optional<scalar_of<P>> intersect_plane_line(const L& plane, const P& a,
                                                                         const P& b) noexcept {
  using T = scalar_of<P>;
  const T divisor = dot(normal_of(plane), detail::displacement<T>(a, b));
  if (!(divisor < T(0) || T(0) < divisor)) return std::nullopt;
  return -plane_value(plane, a) / divisor;
}

/// The crossing of a parametric plane and a parametric line as Hank's program finds it.
/// gives   nothing when its elimination calls the equations singular: for parallel and contained lines, and for planes
///         and lines whose directions are merely short
/// exact   no bound: the pivot is whatever stands on the diagonal
/// source  Hank n.d., 1.3.5: s1*first + s2*second - t*direction = line's origin - plane's origin
template <Real T>
[[nodiscard]] constexpr std::optional<parametric_meeting<T>> intersect_plane_line_by_gauss(
    const parametric_plane<T>& plane, const parametric_line<T, 3>& line,
    std::type_identity_t<T> zero = printed_zero<T>) noexcept {
  mat<T, 3, 4> equations;
  for (int i = 0; i < 3; ++i) {
    equations(i, 0) = plane.first[i], equations(i, 1) = plane.second[i], equations(i, 2) = -line.direction[i];
    equations(i, 3) = line.origin[i] - plane.origin[i];
  }
  const auto x = textbook::solve_gauss(equations, zero);
  if (!x) return std::nullopt;
  return parametric_meeting<T>{flat_relation::crossing, point_at(line, x->z), x->x, x->y, x->z};
}

}  // namespace irg::textbook::inline IRG_ABI
