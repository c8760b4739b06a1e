// SPDX-License-Identifier: MIT
// Grids of any type: boxes of cells that are full or empty, with walls between them where the type knows walls.
//
// The one customisation point is grid_traits<T>. It fits, without a word from the user, types with members extent() and
// is_full(cell3), and of these the ones with has_wall(cell3, axis) as grids with walls.
#pragma once

#include <concepts>
#include <utility>

#include <irg/spatial/cell3.hpp>

namespace irg {

/// How irg reads a grid. Members: extent(g), is_full(g, c) for cells of the extent, and where there are walls
/// has_wall(g, c, axis): whether something that blocks stands between c and the next cell along the axis.
template <class T>
struct grid_traits {};

template <class T>
  requires requires(const T& g, const cell3& c) {
    { g.extent() } -> std::convertible_to<grid_extent>;
    { g.is_full(c) } -> std::convertible_to<bool>;
  }
struct grid_traits<T> {
  IRG_INLINE static constexpr grid_extent extent(const T& g) { return g.extent(); }
  IRG_INLINE static constexpr bool is_full(const T& g, const cell3& c) { return static_cast<bool>(g.is_full(c)); }
  IRG_INLINE static constexpr bool has_wall(const T& g, const cell3& c, int axis)
    requires requires {
      { g.has_wall(c, axis) } -> std::convertible_to<bool>;
    }
  {
    return static_cast<bool>(g.has_wall(c, axis));
  }
};

/// A box of cells that are full or empty.
template <class T>
concept CellGrid = requires(const T& g, const cell3& c) {
  { grid_traits<T>::extent(g) } -> std::convertible_to<grid_extent>;
  { grid_traits<T>::is_full(g, c) } -> std::convertible_to<bool>;
};

/// A box of cells with walls between them.
template <class T>
concept WalledCellGrid = CellGrid<T> && requires(const T& g, const cell3& c) {
  { grid_traits<T>::has_wall(g, c, 0) } -> std::convertible_to<bool>;
};

inline namespace IRG_ABI {

/// The cells that g has.
template <CellGrid G>
[[nodiscard]] IRG_INLINE constexpr grid_extent extent_of(const G& g) {
  return grid_traits<G>::extent(g);
}

/// Whether a cell is full.
/// needs   a cell of the grid
template <CellGrid G>
[[nodiscard]] IRG_INLINE constexpr bool is_full(const G& g, const cell3& c) {
  return grid_traits<G>::is_full(g, c);
}

/// Whether a wall that blocks stands between c and the next cell along the axis; never in grids without walls.
/// needs   a cell of the grid, and an axis from 0 to 2
template <CellGrid G>
[[nodiscard]] IRG_INLINE constexpr bool has_wall([[maybe_unused]] const G& g, [[maybe_unused]] const cell3& c,
                                                 [[maybe_unused]] int axis) {
  if constexpr (WalledCellGrid<G>)
    return grid_traits<G>::has_wall(g, c, axis);
  else
    return false;
}

}  // namespace IRG_ABI
}  // namespace irg
