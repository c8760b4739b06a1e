// SPDX-License-Identifier: MIT
// Cells of grids in space, and the box of cells that a grid has.
#pragma once

#include <irg/core/sinks.hpp>

namespace irg {

/// One cell of a grid in space: its centre is the point (x, y, z), its sides are half a unit away.
struct cell3 {
  int x = 0, y = 0, z = 0;

  constexpr cell3() = default;
  IRG_INLINE constexpr cell3(int column, int row, int layer) noexcept : x(column), y(row), z(layer) {}
  /// The cell of a flat grid, which is the layer 0 of one in space.
  IRG_INLINE constexpr cell3(cell c) noexcept : x(c.x), y(c.y) {}
  friend constexpr bool operator==(const cell3&, const cell3&) = default;
  friend constexpr auto operator<=>(const cell3&, const cell3&) = default;

  /// The coordinate along axis 0, 1 or 2.
  IRG_INLINE constexpr int operator[](int axis) const noexcept { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// The cells with 0 <= x < width, 0 <= y < height and 0 <= z < depth; none when one of them is not positive.
struct grid_extent {
  int width = 0, height = 0, depth = 1;

  [[nodiscard]] IRG_INLINE constexpr bool empty() const noexcept { return width <= 0 || height <= 0 || depth <= 0; }
  [[nodiscard]] IRG_INLINE constexpr bool holds(const cell3& c) const noexcept {
    return c.x >= 0 && c.x < width && c.y >= 0 && c.y < height && c.z >= 0 && c.z < depth;
  }
  constexpr bool operator==(const grid_extent&) const = default;
};

/// Receives cells in space, one call each.
template <class S>
concept Cell3Sink = requires(S& sink, const cell3& c) { sink(c); };

}  // namespace irg
