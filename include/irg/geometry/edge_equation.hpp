// SPDX-License-Identifier: MIT
// The line through an edge of a polygon by the plain formula.
#pragma once

#include <irg/geometry/line.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// The line a*x + b*y + c = 0 through an edge; the value is positive on the left of the edge's direction.
template <Scalar T>
using edge_equation = line<T>;

inline namespace IRG_ABI {

/// The line through an edge from p to q: a = y1 - y2, b = x2 - x1, c = x1*y2 - x2*y1.
/// gives   (0, 0, 0) when the points coincide
/// exact   in integers (without overflow) and rationals; in floats a and b are rounded once, c is within 1 ulp (2^-1073
///         more where it underflows)
/// source  Mihajlovic 2016, formulas 2.6 and 3.1
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr edge_equation<scalar_of<P>> edge_through(const P& p, const P& q) noexcept {
  using T = scalar_of<P>;
  const T x1 = coordinate(p, 0), y1 = coordinate(p, 1), x2 = coordinate(q, 0), y2 = coordinate(q, 1);
  if constexpr (Floating<T>)
    return {y1 - y2, x2 - x1, difference_of_products(x1, y2, x2, y1)};
  else
    return {static_cast<T>(y1 - y2), static_cast<T>(x2 - x1), static_cast<T>(x1 * y2 - x2 * y1)};
}

IRG_REFUSES_VECTORS(edge_through);

}  // namespace IRG_ABI
}  // namespace irg
