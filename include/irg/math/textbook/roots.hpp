// SPDX-License-Identifier: MIT
// The roots of a quadratic by the formula of the textbooks. quadratic_roots (math/roots.hpp) is the one to use.
#pragma once

#include <irg/math/roots.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The real roots of a*x^2 + b*x + c = 0 by the formula of the textbooks, (-b +- sqrt(b*b - 4*a*c)) / (2*a).
/// needs   a not 0; a*c and b*b neither over- nor underflow
/// exact   near-double roots lose up to half the digits, and their number can be wrong; the smaller root has no right
///         digit when the roots are 10^8 apart (float: 10^4)
template <Floating T>
[[nodiscard]] constexpr real_roots<T, 2> quadratic_roots(T a, T b, T c) noexcept {
  real_roots<T, 2> roots;
  const T discriminant = product(b, b) - product(4 * a, c);
  if (!(discriminant >= 0)) return roots;
  const T root = sqrt(discriminant);
  return detail::two_real_roots((-b - root) / (2 * a), (-b + root) / (2 * a), discriminant == 0);
}

}  // namespace irg::textbook::inline IRG_ABI
