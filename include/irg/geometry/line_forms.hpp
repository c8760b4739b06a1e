// SPDX-License-Identifier: MIT
// From one form of a line of the plane to another: implicit, parametric, through homogeneous points.
#pragma once

#include <array>
#include <optional>

#include <irg/geometry/line.hpp>
#include <irg/geometry/parametric_line.hpp>

namespace irg::inline IRG_ABI {

/// The implicit form of a parametric line: positive on the left of its direction.
/// gives   nothing when the direction is zero, or a number is NaN or infinite
/// exact   as line_through, for the direction as it is
template <Scalar T>
[[nodiscard]] constexpr std::optional<line<T>> implicit_line_of(const parametric_line<T, 2>& l) noexcept {
  return detail::rounded_line<T>(
      values_of<2>([](const auto& u, const auto& from) { return vec{-u.y, u.x, u.y * from.x - u.x * from.y}; },
                   l.direction, l.origin));
}

/// The implicit form of the line through two homogeneous points.
/// gives   as line_through
/// exact   as line_through
template <Scalar T>
[[nodiscard]] constexpr std::optional<line<T>> implicit_line_of(const homogeneous_line<T, 2>& l) noexcept {
  return line_through(l.start, l.end);
}

/// A parametric form of an implicit line: the origin is where it meets the axis nearest to its normal, the direction
/// (b, -a) has the positive side on its left, so that only the origin is rounded.
/// gives   nothing for the line at infinity (a and b are 0), and when a coefficient is NaN or infinite
/// exact   one quotient, rounded once; infinite where it is too large
template <Real T>
[[nodiscard]] constexpr std::optional<parametric_line<T, 2>> parametric_line_of(const line<T>& l) noexcept {
  for (const T& c : {l.a, l.b, l.c})
    if (!is_finite(c)) return std::nullopt;
  if (l.a == T(0) && l.b == T(0)) return std::nullopt;
  const T a = l.a < T(0) ? -l.a : l.a, b = l.b < T(0) ? -l.b : l.b;
  const point<T, 2> origin = a < b ? point<T, 2>{T(0), -l.c / l.b} : point<T, 2>{-l.c / l.a, T(0)};
  return parametric_line<T, 2>{origin, {l.b, -l.a}};
}

}  // namespace irg::inline IRG_ABI
