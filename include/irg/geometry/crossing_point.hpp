// SPDX-License-Identifier: MIT
// The point in which two lines of the plane cross, correctly rounded.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <irg/geometry/detail/nearest_quotient.hpp>
#include <irg/geometry/segment.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The point in which the lines `first` and `second` cross: each coordinate is the number nearest to the exact one.
/// shape   lines through the ends of segments; the crossing may lie beyond the ends
/// needs   finite coordinates
/// gives   nothing when the lines do not cross in one point (parallel, or without length); the largest number for a
///         coordinate beyond the range; no zero has a sign
/// exact   correctly rounded, ties to even
/// cost    a quotient of polynomials of degree 3 in doubled precision, in exact numbers where that does not suffice
template <Floating T>
constexpr std::optional<point<T, 2>> crossing_point(const segment<T, 2>& first, const segment<T, 2>& second) noexcept {
  // With f and g twice the areas that `second` spans with a and b, the crossing is (g*a - f*b)/(g - f).
  const auto formula = [](const auto& x) {
    const auto area = [&x](std::size_t end) {
      return (x[6] - x[4]) * (x[end + 1] - x[5]) - (x[7] - x[5]) * (x[end] - x[4]);
    };
    const auto f = area(0), g = area(2);
    return std::array{g - f, x[0] * g - x[2] * f, x[1] * g - x[3] * f};
  };
  const auto at =
      detail::nearest_quotients<3>(formula, std::array<T, 8>{first.a[0], first.a[1], first.b[0], first.b[1],
                                                             second.a[0], second.a[1], second.b[0], second.b[1]});
  if (!at) return std::nullopt;
  return point<T, 2>{(*at)[0], (*at)[1]};
}

}  // namespace IRG_ABI
}  // namespace irg
