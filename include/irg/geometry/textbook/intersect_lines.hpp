// SPDX-License-Identifier: MIT
// Where two lines in space meet, by two of the three coordinate equations, as taught and as printed. intersect_lines
// (geometry/intersect_lines.hpp) is the one to use: it decides exactly.
#pragma once

#include <optional>

#include <irg/geometry/intersect_lines.hpp>

namespace irg::detail::inline IRG_ABI {

// The crossing by two of the coordinate equations, unless their determinant is at most `zero`.
template <Point P>
constexpr std::optional<lines_meeting<P>> cross_in_two(const P& a, const P& b, const P& c, const P& d, int i, int j,
                                                       const scalar_of<P>& zero) noexcept {
  using T = scalar_of<P>;
  const auto way = [](const P& from, const P& to, int k) { return coordinate(to, k) - coordinate(from, k); };
  const auto det = [&](const P& p, const P& q, const P& r, const P& s) {
    return product(way(p, q, i), way(r, s, j)) - product(way(p, q, j), way(r, s, i));
  };
  const T n = det(a, b, c, d);
  if (!(zero < n || n < -zero)) return std::nullopt;
  const T t = det(a, c, c, d) / n, s = det(a, c, a, b) / n;
  const auto at = [&](int k) { return coordinate(a, k) + product(t, way(a, b, k)); };
  return lines_meeting<P>{flat_relation::crossing, generate_coordinates<P>(at), t, s};
}

template <Point P>
constexpr bool fits_third(const lines_meeting<P>& m, const P& c, const P& d, int k,
                          const scalar_of<P>& tolerance) noexcept {
  const auto off = coordinate(m.at, k) - (coordinate(c, k) + product(m.s, coordinate(d, k) - coordinate(c, k)));
  return !(tolerance < off) && !(off < -tolerance);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook {

/// The numbers below which Hank's Gauss elimination takes a pivot for zero.
template <Scalar T>
inline constexpr T printed_zero = T(1) / T(1000000);

inline namespace IRG_ABI {

/// The crossing of two lines in space as Hank computes it: two of the three coordinate equations are solved, the
/// third is checked. Pairs of equations are tried until one can be solved.
/// gives   nothing where no pair can be solved (parallel and coincident lines) or the third equation is not fulfilled
///         within the tolerance (skew ones)
/// exact   in rationals; in floats rounded lines rarely pass the check with tolerance 0: intersect_lines decides
/// source  Hank n.d., 1.3.4, corrected: the first pair alone misses (0,0,0)-(0,1,1) and (0,0,1)-(0,1,0)
template <Point P>
  requires(Real<scalar_of<P>> && size_of<P> == 3)
[[nodiscard]] constexpr std::optional<lines_meeting<P>> intersect_lines(
    const P& a, const P& b, const P& c, const P& d, scalar_of<P> tolerance = scalar_of<P>(0)) noexcept {
  for (int third = 2; third >= 0; --third) {
    const auto m = detail::cross_in_two(a, b, c, d, third == 0 ? 1 : 0, third == 2 ? 1 : 2, scalar_of<P>(0));
    if (!m) continue;
    if (!detail::fits_third(*m, c, d, third, tolerance)) return std::nullopt;
    return m;
  }
  return std::nullopt;
}

/// The crossing of two lines in space as Hank's program finds it: by the equations of x and y alone, with a fixed
/// threshold for zero.
/// gives   nothing as well for crossing lines whose x and y equations depend on each other, and for short ones
/// source  Hank n.d., 1.3.4 as printed
template <Point P>
  requires(Real<scalar_of<P>> && size_of<P> == 3)
[[nodiscard]] constexpr std::optional<lines_meeting<P>> intersect_lines_by_x_and_y(
    const P& a, const P& b, const P& c, const P& d, scalar_of<P> zero = printed_zero<scalar_of<P>>) noexcept {
  const auto m = detail::cross_in_two(a, b, c, d, 0, 1, zero);
  if (!m || !detail::fits_third(*m, c, d, 2, zero)) return std::nullopt;
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
