// SPDX-License-Identifier: MIT
// The point in which two lines of the plane cross, correctly rounded.
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg::inline IRG_ABI {

/// The point in which the lines `first` and `second` cross: each coordinate is the number nearest to the exact one.
/// shape   lines through the ends of segments; the crossing may lie beyond the ends
/// needs   finite coordinates
/// gives   nothing when the lines do not cross in one point (parallel, or without length); the largest number for a
///         coordinate beyond the range; no zero has a sign
/// exact   correctly rounded, ties to even
/// cost    a quotient of polynomials of degree 3 in doubled precision, in exact numbers where that does not suffice
template <Floating T>
[[nodiscard]] constexpr std::optional<point<T, 2>> intersection_point(const segment<T, 2>& first,
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

/// On which side of the line `of` the point lies in which the lines `first` and `second` cross: above to its left (y
/// up), below to its right.
/// shape   lines through the ends of segments; the crossing may lie beyond the ends
/// needs   finite coordinates
/// gives   nothing when `first` and `second` do not cross in one point (parallel, or without length), and when
///         something is NaN or infinite; `on` when the ends of `of` are the same point
/// exact   for every finite float and double; other scalars: as exact as their own + - *
/// cost    some 20 ns; where the crossing is nearly on the line, a polynomial of degree 4 in doubled precision, in
///         exact numbers where that does not suffice
template <Scalar T>
  requires(Floating<T> || !std::is_arithmetic_v<T>)
[[nodiscard]] constexpr std::optional<side> side_of_crossing(const segment<T, 2>& first, const segment<T, 2>& second,
                                                             const segment<T, 2>& of) noexcept(Floating<T>) {
  // With f and g twice the areas that `second` spans with a and b, the crossing is (g*a - f*b)/(g - f): its side of a
  // line is the same mean of the sides of a and b.
  const auto [apart, beside] = sign_of<4>(
      [](const auto& a, const auto& b, const auto& c, const auto& d, const auto& from, const auto& to) {
        const auto f = cross(d - c, a - c), g = cross(d - c, b - c);
        return std::array{g - f, cross(to - from, a - from) * g - cross(to - from, b - from) * f};
      },
      first.a, first.b, second.a, second.b, of.a, of.b);
  return apart == 0 ? std::nullopt : std::optional(static_cast<side>(apart * beside));
}

IRG_RENAMED(crossing_point, intersection_point)

}  // namespace irg::inline IRG_ABI
