// SPDX-License-Identifier: MIT
// walled_grid: full and empty cells with walls of several kinds between them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <irg/spatial/cell_grid.hpp>

namespace irg {

/// What stands between two cells.
enum class wall_kind : std::uint8_t { none, wall, half_wall, open_door, closed_door, laser_field };

/// Which kinds of walls block sight, by their number. The default is the source's table 2.
/// source  Fabris 2012, table 2
struct wall_options {
  std::array<bool, 6> blocks{false, true, false, false, true, false};

  IRG_INLINE constexpr bool operator()(wall_kind kind) const noexcept { return blocks[static_cast<std::size_t>(kind)]; }
  bool operator==(const wall_options&) const = default;
};

/// A map: cells as bits, the walls between them by kind, and as bits those that block.
/// shape   the wall (c, axis) stands between c and the next cell along the axis, at the border between c and nothing
class walled_grid {
public:
  walled_grid() = default;
  IRG_INLINE constexpr explicit walled_grid(const grid_extent& extent, const wall_options& rules = {})
      : walled_grid(cell_grid(extent), rules) {}
  /// The cells of a grid, without walls.
  IRG_INLINE constexpr explicit walled_grid(cell_grid cells, const wall_options& rules = {})
      : cells_(std::move(cells)), rules_(rules) {}

  [[nodiscard]] IRG_INLINE constexpr grid_extent extent() const noexcept { return cells_.extent(); }
  [[nodiscard]] IRG_INLINE constexpr const cell_grid& cells() const noexcept { return cells_; }
  /// Whether any wall was ever set.
  [[nodiscard]] IRG_INLINE constexpr bool walled() const noexcept { return !kinds_.empty(); }
  /// The walls across an axis that block, as bits.
  /// needs   walled()
  [[nodiscard]] IRG_INLINE constexpr const cell_grid& blocking(int axis) const noexcept {
    return axis == 0 ? across_x_ : axis == 1 ? across_y_ : across_z_;
  }

  /// needs   a cell of the extent and an axis from 0 to 2, here and below
  [[nodiscard]] IRG_INLINE constexpr bool is_full(const cell3& c) const noexcept { return cells_.is_full(c); }
  [[nodiscard]] IRG_INLINE constexpr bool has_wall(const cell3& c, int axis) const noexcept {
    return walled() && blocking(axis).is_full(c);
  }
  [[nodiscard]] IRG_INLINE constexpr wall_kind wall(const cell3& c, int axis) const noexcept {
    return walled() ? kinds_[index(c, axis)] : wall_kind::none;
  }

  IRG_INLINE constexpr void set(const cell3& c, bool full = true) noexcept { cells_.set(c, full); }
  /// cost    three bytes and three bits per cell from the first wall on
  template <std::same_as<wall_kind> Kind = wall_kind>
  IRG_INLINE constexpr void set_wall(const cell3& c, int axis, Kind kind) {
    IRG_EXPECTS(extent().holds(c) && axis >= 0 && axis < 3);
    if (!walled()) {
      const grid_extent e = extent();
      constexpr std::int64_t most = (std::numeric_limits<std::ptrdiff_t>::max)();  // more than any vector holds
      const std::int64_t count = 3 * (std::int64_t{e.width} * e.height * e.depth);
      std::vector<Kind> kinds(static_cast<std::size_t>(count < most ? count : most), wall_kind::none);
      cell_grid across_x(e), across_y(e), across_z(e);
      across_x_ = std::move(across_x), across_y_ = std::move(across_y), across_z_ = std::move(across_z);
      kinds_ = std::move(kinds);
    }
    kinds_[index(c, axis)] = kind;
    (axis == 0 ? across_x_ : axis == 1 ? across_y_ : across_z_).set(c, rules_(kind));
  }

  bool operator==(const walled_grid&) const = default;

private:
  [[nodiscard]] IRG_INLINE constexpr std::size_t index(const cell3& c, int axis) const noexcept {
    const grid_extent e = extent();
    const std::int64_t i = (std::int64_t{c.z} * e.height + c.y) * e.width + c.x;
    return 3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(axis);
  }

  cell_grid cells_;
  wall_options rules_;
  std::vector<wall_kind> kinds_{};  // three per cell, or none at all
  cell_grid across_x_{}, across_y_{}, across_z_{};  // an array of them cannot be moved in g++ 12's constant evaluation
};

inline namespace IRG_ABI {

/// The cells and the blocking walls of any grid, as bits.
template <CellGrid G>
[[nodiscard]] constexpr walled_grid with_walls(const G& g) {
  walled_grid out(packed(g));
  const grid_extent e = out.extent();
  for (int z = 0; z < e.depth && WalledCellGrid<G>; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x)
        for (int axis = 0; axis < 3; ++axis)
          if (has_wall(g, {x, y, z}, axis)) out.set_wall({x, y, z}, axis, wall_kind::wall);
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
