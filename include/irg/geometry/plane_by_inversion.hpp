// SPDX-License-Identifier: MIT
// The lecture's plane by inversion of a 4 x 4 matrix: its rows are three homogeneous points and (0 0 0 1), the right
// side is (0 0 0 D). It needs a plane that avoids the origin; plane_through for homogeneous points needs not.
#pragma once

#include <irg/core/vocabulary.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/plane_through_points.hpp>

namespace irg {

/// What the inversion finds: a plane; that the matrix is singular since the plane passes through the origin, or since
/// the points span no plane; or that a number is NaN or infinite, or D zero.
enum class [[nodiscard]] inversion_status {
  ok,
  through_origin,
  collinear,
  invalid,
  plane [[deprecated("irg: plane is now ok")]] = ok
};

inline namespace IRG_ABI {

/// The plane (a, b, c, d) with last coefficient d through three homogeneous points: the solution of the equations with
/// rows p1, p2, p3 and (0 0 0 1) and right side (0 0 0 d). The choice of d decides which side is the upper one.
/// shape   value has a meaning only where the status is `ok`
/// exact   the outcome for all finite points; each coefficient within 0.501 ulp, d itself. Infinity where a coefficient
///         is beyond the range
/// source  Mihajlovic 2016, formula 4.3 in its consistent form
template <HomogeneousPoint P>
  requires(size_of<P> == 4 && Real<scalar_of<P>>)
[[nodiscard]] constexpr checked<plane<scalar_of<P>>, inversion_status> plane_by_inversion(
    const P& p1, const P& p2, const P& p3, scalar_of<P> d = scalar_of<P>(1)) noexcept {
  using T = scalar_of<P>;
  if (d == T(0) || !is_finite(d)) return {{}, inversion_status::invalid};
  const auto minors = detail::homogeneous_plane(p1, p2, p3);
  if (!minors) return {{}, inversion_status::invalid};
  const auto& m = *minors;
  if (sign_of(m[3]) == 0)
    return {{},
            detail::is_zero(vec{m[0], m[1], m[2]}) ? inversion_status::collinear : inversion_status::through_origin};
  const auto factor = [&] {
    if constexpr (Floating<T>) {
      const auto [significand, exponent] = decompose(widened(d));  // subnormals are no double-doubles
      return scaled_double_double{significand, 0, exponent};
    } else {
      return d;
    }
  }();
  const auto coefficient = [&](std::size_t i) { return rounded_to<T>(m[i] * factor / m[3]); };
  return {{coefficient(0), coefficient(1), coefficient(2), d}, inversion_status::ok};
}

}  // namespace IRG_ABI
}  // namespace irg
