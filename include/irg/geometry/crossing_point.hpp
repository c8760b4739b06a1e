// SPDX-License-Identifier: MIT
// The point in which two lines of the plane cross, correctly rounded.
#pragma once

#include <array>
#include <optional>

#include <irg/geometry/segment.hpp>
#include <irg/math/exact/quotients_of.hpp>

namespace irg::inline IRG_ABI {

/// The point in which the lines `first` and `second` cross: each coordinate is the number nearest to the exact one.
/// shape   lines through the ends of segments; the crossing may lie beyond the ends
/// needs   finite coordinates
/// gives   nothing when the lines do not cross in one point (parallel, or without length); the largest number for a
///         coordinate beyond the range; no zero has a sign
/// exact   correctly rounded, ties to even
/// cost    a quotient of polynomials of degree 3 in doubled precision, in exact numbers where that does not suffice
template <Floating T>
[[nodiscard]] constexpr std::optional<point<T, 2>> crossing_point(const segment<T, 2>& first,
                                                                  const segment<T, 2>& second) noexcept {
  // With f and g twice the areas that `second` spans with a and b, the crossing is (g*a - f*b)/(g - f).
  const auto at = quotients_of<3>(
      [](const auto& a, const auto& b, const auto& c, const auto& d) {
        const auto f = cross(d - c, a - c), g = cross(d - c, b - c);
        return std::array{g - f, a.x * g - b.x * f, a.y * g - b.y * f};
      },
      first.a, first.b, second.a, second.b);
  if (!at) return std::nullopt;
  return point<T, 2>{(*at)[0], (*at)[1]};
}

}  // namespace irg::inline IRG_ABI
