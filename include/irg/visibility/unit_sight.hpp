// SPDX-License-Identifier: MIT
// Who sees whom, and how much of one region is seen from another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/spatial/cell_grid.hpp>
#include <irg/visibility/see.hpp>

namespace irg {

/// Of all pairs of a cell of one region and a cell of another, how many see each other.
struct region_sight {
  std::int64_t pairs = 0, seen = 0;
  bool operator==(const region_sight&) const = default;
};

inline namespace IRG_ABI {

/// Which of n units sees which, as n times n bits: (i, j) and (j, i) are equal. Each sees itself where it stands on the
/// map.
/// exact   always
/// cost    has_line_of_sight() for each pair
template <CellGrid G>
[[nodiscard]] constexpr cell_grid who_sees_whom(const G& map, std::span<const cell3> units,
                                                const line_of_sight_options& rules = {}) {
  const int n = static_cast<int>(units.size());
  cell_grid out(grid_extent{n, n, 1});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      if (has_line_of_sight(map, units[static_cast<std::size_t>(i)], units[static_cast<std::size_t>(j)], rules)) {
        out.set(cell{i, j});
        out.set(cell{j, i});
      }
  return out;
}

/// How many pairs of cells of two regions see each other; the same with the regions exchanged.
/// exact   always
/// cost    has_line_of_sight() for each pair
template <CellGrid G>
[[nodiscard]] constexpr region_sight see_regions(const G& map, std::span<const cell3> a, std::span<const cell3> b,
                                                 const line_of_sight_options& rules = {}) {
  region_sight out{static_cast<std::int64_t>(a.size()) * static_cast<std::int64_t>(b.size()), 0};
  for (const cell3& p : a)
    for (const cell3& q : b) out.seen += has_line_of_sight(map, p, q, rules) ? 1 : 0;
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
