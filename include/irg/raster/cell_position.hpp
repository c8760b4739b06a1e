// SPDX-License-Identifier: MIT
// Cells named by points of others.
#pragma once

#include <concepts>

#include <irg/core/coordinates.hpp>
#include <irg/core/sinks.hpp>

namespace irg {

struct subpixel;

/// Points of ints that name a cell without being one: glm::ivec2, cv::Point, std::array<int, 2>, structs of x and y.
template <class P>
concept CellPosition = Point<P> && size_of<P> == 2 && std::same_as<scalar_of<P>, int> && !std::same_as<P, cell> &&
                       !std::same_as<P, subpixel>;

inline namespace IRG_ABI {

/// The cell that a point of ints names.
template <CellPosition P>
[[nodiscard]] IRG_INLINE constexpr cell as_cell(const P& p) noexcept {
  return {coordinate(p, 0), coordinate(p, 1)};
}
[[nodiscard]] IRG_INLINE constexpr cell as_cell(cell c) noexcept { return c; }

}  // namespace IRG_ABI
}  // namespace irg
