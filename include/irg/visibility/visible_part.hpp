// SPDX-License-Identifier: MIT
// How much of each cell is seen from the centre of one: as a percentage of the directions to it, any of it, all of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/detail/visible_part_steps.hpp>

namespace irg {

inline namespace IRG_ABI {

/// How much of each cell of a flat map is seen, in percent: the angle of the directions from the viewer's centre that
/// reach the cell unblocked, over the angle that the cell subtends.
/// shape   row by row; the viewer's own cell has 100, as has every cell whose directions are all free
/// gives   an empty list when the viewer is no cell of the map or the map is not flat
/// exact   0 and 100; what is between is the quotient of two sums of angles, within 8 ulp per summand
/// cost    as field_of_view, and an arc tangent per cell and gap
/// source  Fabris 2012, 6, which asks for it
template <CellGrid G>
[[nodiscard]] constexpr std::vector<double> visible_percentages(const G& map, cell viewer) {
  const grid_extent e = extent_of(map);
  std::vector<double> out;
  if (!e.holds(viewer) || e.depth != 1) return out;
  const walled_grid bits = with_walls(map);
  const std::size_t size = static_cast<std::size_t>(e.width) * static_cast<std::size_t>(e.height);
  std::vector<detail::light_sums::sum> sums(size, detail::light_sums::sum{});
  view_memory memory;
  for (int sign_y = -1; sign_y <= 1; sign_y += 2)
    for (int sign_x = -1; sign_x <= 1; sign_x += 2) {
      detail::light_sums light{&sums, e.width, viewer, sign_x, sign_y};
      detail::row_sweep<detail::light_sums>(
          {&bits, viewer, sign_x, sign_y, corner_rule::pinch, (std::numeric_limits<int>::max)()}, memory.now,
          memory.next, light)
          .run();
    }
  out.assign(size, 0.0);
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(e.width) + static_cast<std::size_t>(x);
      const std::int64_t dx = x < viewer.x ? viewer.x - x : x - viewer.x,
                         dy = y < viewer.y ? viewer.y - y : y - viewer.y;
      const int parts = dx == 0 || dy == 0 ? 2 : 1;
      const detail::cell_slopes s = detail::slopes_of(dx, dy);
      if ((dx == 0 && dy == 0) || sums[i].wholes == parts)
        out[i] = 100;
      else
        out[i] = 100 * (sums[i].lit / (parts * detail::angle_between(s.low, s.high)));
    }
  return out;
}

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

template <class G, class Keep>
constexpr cell_grid cells_by_percentage(const G& map, cell viewer, const Keep& keep) {
  const std::vector<double> percent = visible_percentages(map, viewer);
  cell_grid out(extent_of(map));
  const int width = extent_of(map).width;
  for (std::size_t i = 0; i < percent.size(); ++i)
    if (keep(percent[i]))
      out.set(cell{static_cast<int>(i % static_cast<std::size_t>(width)),
                   static_cast<int>(i / static_cast<std::size_t>(width))});
  return out;
}
}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The cells of a flat map that are seen at all, be it a sliver. Not symmetric.
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view_permissive(const G& map, cell viewer) {
  return detail::cells_by_percentage(map, viewer, [](double p) { return p > 0; });
}

/// The cells of a flat map that are seen whole: every direction to them is free. Not symmetric.
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view_restrictive(const G& map, cell viewer) {
  return detail::cells_by_percentage(map, viewer, [](double p) { return p == 100; });
}

}  // namespace IRG_ABI
}  // namespace irg
