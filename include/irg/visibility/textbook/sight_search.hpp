// SPDX-License-Identifier: MIT
// All cells that units see, found by testing cell by cell, as a thesis does it, with its two optimisations.
#pragma once

#include <cstdint>
#include <span>

#include <irg/spatial/cell_grid.hpp>
#include <irg/visibility/textbook/sight_2d.hpp>

namespace irg::textbook {

/// What spares tests.
enum class sight_saving {
  none,             // every cell for every unit
  auxiliary_field,  // no cell that a unit before has seen
  visible_list      // and, on a line of 45 degrees, all cells between are taken as seen with its end
};

/// The cells that are seen, and how many lines were tested for it.
struct sight_search_result {
  cell_grid seen;
  std::int64_t calls = 0;
  bool operator==(const sight_search_result&) const = default;
};

inline namespace IRG_ABI {

/// The cells of the layer z = 0 that any of the units sees, partially or fully; full cells are seen, too.
/// gives   the same cells with every saving; units outside of the map see nothing
/// cost    one line per cell and unit at most
/// source  Fabris 2012, 4.4 and 4.4.1
template <CellGrid G>
[[nodiscard]] constexpr sight_search_result sight_search(const G& g, std::span<const cell> units, sight_saving saving) {
  const grid_extent e = extent_of(g);
  sight_search_result out{cell_grid(grid_extent{e.width, e.height, 1}), 0};
  for (const cell u : units) {
    if (!e.holds(u)) continue;
    const auto search = [&](int y, int x) {
      if (saving != sight_saving::none && out.seen.is_full(cell{x, y})) return;
      ++out.calls;
      if (sight_2d(g, u, {x, y}) == sight::blocked) return;
      out.seen.set(cell{x, y});
      const int dx = x < u.x ? -1 : 1, dy = y < u.y ? -1 : 1;
      if (saving == sight_saving::visible_list && (x - u.x) * dx == (y - u.y) * dy)
        for (cell c = u; c.x != x; c = {c.x + dx, c.y + dy}) out.seen.set(c);
    };
    // From the far ends inwards, so that a diagonal is met at its end first.
    for (int y = 0; y < u.y; ++y)
      for (int x = 0; x < e.width; ++x) search(y, x);
    for (int y = e.height - 1; y >= u.y; --y)
      for (int x = 0; x < e.width; ++x) search(y, x);
  }
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
