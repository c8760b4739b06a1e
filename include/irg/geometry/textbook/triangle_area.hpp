// SPDX-License-Identifier: MIT
// Heron's formula. triangle_area_from_sides (geometry/triangle_area.hpp) is the one to use.
#pragma once

#include <optional>

#include <irg/geometry/triangle_area.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The area of the triangle with sides of these lengths by Heron's formula as the textbooks have it.
/// exact   needles lose all digits
/// source  Heron, Metrica
template <Floating T>
[[nodiscard]] constexpr std::optional<T> triangle_area_from_sides(T a, T b, T c) noexcept {
  const T s = (a + b + c) / 2;
  const T square = product(product(s, s - a), product(s - b, s - c));
  return square >= 0 ? std::optional<T>(sqrt(square)) : std::nullopt;
}

}  // namespace irg::textbook::inline IRG_ABI
