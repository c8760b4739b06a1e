// SPDX-License-Identifier: MIT
// Barycentric coordinates as lectures compute them: by the inverse of the matrix whose columns are the corners, and,
// where that matrix is singular, with one of its rows replaced by t1 + t2 + t3 = 1. The matrix is singular whenever the
// plane of the triangle contains the origin; which row may then be replaced depends on the triangle. barycentric()
// needs no such choice.
#pragma once

#include <irg/geometry/barycentric.hpp>
#include <irg/math/solve_exact.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The solution of A*t1 + B*t2 + C*t3 = T: three equations for three unknowns.
/// needs   finite coordinates
/// gives   nothing when the matrix [A B C] is singular: the plane of the triangle contains the origin, or the triangle
///         has no area; or when a coordinate is too large for the number type. For T off the plane the sum of the
///         coordinates is not 1
/// exact   singularity is decided exactly; each coordinate is rounded once, as by solve_exact. Rationals are exact
/// cost    four exact determinants, about a microsecond
/// source  Mihajlovic 2016, formula 1.3
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<vec<scalar_of<P>, 3>> barycentric_direct(const P& a, const P& b, const P& c,
                                                                               const P& t) noexcept {
  using T = scalar_of<P>;
  const P columns[] = {a, b, c, t};
  mat<T, 3, 4> equations;
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 4; ++k) equations(r, k) = coordinate(columns[k], r);
  if constexpr (Floating<T>) {
    const auto solution = solve_exact(equations);
    return solution ? std::optional(solution.x) : std::nullopt;
  } else {
    const auto solution = irg::solve_gauss(equations);
    return solution ? std::optional(solution.x) : std::nullopt;
  }
}

/// The solution of the system with the equation of one axis (0, 1, 2 for x, y, z) replaced by t1 + t2 + t3 = 1: T is
/// seen along that axis.
/// needs   finite coordinates; 0 <= axis < 3
/// gives   nothing when the triangle shows no area along the axis, in particular when it has none
/// exact   as barycentric
/// source  Mihajlovic 2016, 1.3, the rule for singular cases
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<vec<scalar_of<P>, 3>> barycentric_replaced(const P& a, const P& b, const P& c,
                                                                                 const P& t, int axis) noexcept {
  return detail::barycentric_in(detail::axes_across(axis), a, b, c, t);
}

}  // namespace irg::textbook::inline IRG_ABI
