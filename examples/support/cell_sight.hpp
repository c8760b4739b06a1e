// SPDX-License-Identifier: MIT
// What units see of a map, cell by cell, as the programs draw it: exactly, or with the three answers of the thesis; and
// the colours of walls.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include <irg/colour/pixel.hpp>
#include <irg/spatial/walled_grid.hpp>
#include <irg/visibility/textbook/sight_3d.hpp>

namespace program {

/// The cells that any unit sees, and those of them that each unit sees in part at most.
struct cell_sight {
  irg::cell_grid seen{}, partial{};
};

/// What the thesis says of b from a: in the layer z = 0 full or partial sight or none, else full sight or none.
inline irg::textbook::sight thesis_sight(const irg::walled_grid& map, const irg::cell3& a, const irg::cell3& b,
                                         irg::textbook::three_axis_rule rule) {
  using irg::textbook::sight;
  const irg::grid_extent e = map.extent();
  if (e.holds(a) && e.holds(b) && a.z == 0 && b.z == 0) return irg::textbook::sight_2d(map, {a.x, a.y}, {b.x, b.y});
  return irg::textbook::sight_3d(map, a, b, rule) ? sight::full : sight::blocked;
}

/// What units see when answer(unit, cell) says how one of them sees a cell: of several answers the best.
template <class Answer>
cell_sight sight_by(const irg::grid_extent& e, std::span<const irg::cell3> units, const Answer& answer) {
  using irg::textbook::sight;
  cell_sight out{irg::cell_grid(e), irg::cell_grid(e)};
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x) {
        const irg::cell3 c{x, y, z};
        sight best = sight::blocked;
        for (std::size_t i = 0; i < units.size() && best != sight::full; ++i)
          best = std::max(best, answer(units[i], c));
        if (best != sight::blocked) out.seen.set(c);
        if (best == sight::partial) out.partial.set(c);
      }
  return out;
}

/// The colours of walls by their kind. Those that block are dark.
inline constexpr std::array<irg::rgba8, 6> wall_colours{irg::rgba8{0, 0, 0, 0}, {32, 44, 66, 255},
                                                        {120, 130, 150, 255},   {200, 132, 48, 255},
                                                        {120, 72, 40, 255},     {220, 40, 60, 255}};

inline constexpr irg::rgba8 colour_of(irg::wall_kind kind) { return wall_colours[static_cast<std::size_t>(kind)]; }

}  // namespace program
