// SPDX-License-Identifier: MIT
// Grids of any type: boxes of cells that are full or empty, with walls between them where the type knows walls.
//
// The one customisation point is grid_traits<T>. It fits, without a word from the user, types with members extent() and
// is_full(cell3), and of these the ones with has_wall(cell3, axis) as grids with walls.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <irg/core/sinks.hpp>

namespace irg {

// Cells of grids in space, and the box of cells that a grid has.

/// One cell of a grid in space: its centre is the point (x, y, z), its sides are half a unit away.
struct cell3 {
  int x = 0, y = 0, z = 0;

  constexpr cell3() = default;
  IRG_INLINE constexpr cell3(int column, int row, int layer) noexcept : x(column), y(row), z(layer) {}
  /// The cell of a flat grid, which is the layer 0 of one in space.
  IRG_INLINE constexpr cell3(cell c) noexcept : x(c.x), y(c.y) {}
  friend constexpr bool operator==(const cell3&, const cell3&) = default;
  friend constexpr bool operator<(const cell3& a, const cell3& b) noexcept {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  }

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
  bool operator==(const grid_extent&) const = default;
};

/// Receives cells in space, one call each.
template <class S>
concept Cell3Sink = requires(S& sink, const cell3& c) { sink(c); };

inline namespace IRG_ABI {

/// Writes "(x, y, z)".
template <class S, std::same_as<cell3> C>
  requires TextStream<S>
constexpr S& operator<<(S& stream, const C& c) {
  return print_list(stream, 3, [&](int i) { return c[i]; });
}

}  // namespace IRG_ABI
}  // namespace irg

/// The hash of a cell, for std::unordered_map and its like.
template <>
struct std::hash<irg::cell3> {
  IRG_INLINE constexpr std::size_t operator()(const irg::cell3& c) const noexcept {
    const auto x = static_cast<std::uint32_t>(c.x), y = static_cast<std::uint32_t>(c.y);
    const std::uint64_t z = static_cast<std::uint32_t>(c.z);
    const std::uint64_t h = (std::uint64_t{x} << 32 | y) * 0x9e3779b97f4a7c15u + z * 0xc2b2ae3d27d4eb4fu;
    return static_cast<std::size_t>(h ^ h >> 32);
  }
};

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
