// SPDX-License-Identifier: MIT
// How much of each cell is seen from the centre of one: as a percentage of the directions to it, any of it, all of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/spatial/walled_grid.hpp>
#if IRG_BODIES
#include <irg/core/scalar.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/visibility/field_of_view.hpp>
#endif

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
[[nodiscard]] constexpr std::vector<double> visible_percentages(const G& map, cell viewer);

/// The cells of a flat map that are seen at all, be it a sliver. Not symmetric.
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view_permissive(const G& map, cell viewer);

/// The cells of a flat map that are seen whole: every direction to them is free. Not symmetric.
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view_restrictive(const G& map, cell viewer);

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

// needs   a viewer in a flat map
template <class Grid>
IRG_API std::vector<double> percentages_lit(const Grid& bits, cell viewer);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

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

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <CellGrid G>
[[nodiscard]] constexpr std::vector<double> visible_percentages(const G& map, cell viewer) {
  const grid_extent e = extent_of(map);
  std::vector<double> out;
  if (!e.holds(viewer) || e.depth != 1) return out;
  return detail::percentages_lit(with_walls(map), viewer);
}

template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view_permissive(const G& map, cell viewer) {
  return detail::cells_by_percentage(map, viewer, [](double p) { return p > 0; });
}

template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view_restrictive(const G& map, cell viewer) {
  return detail::cells_by_percentage(map, viewer, [](double p) { return p == 100; });
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Light on the cells of a quadrant, for visible_percentages.

// The angle from one direction x/y to another.
constexpr double angle_between(const sweep_slope& a, const sweep_slope& b) noexcept {
  return irg::atan2(static_cast<double>(b.num * a.den - a.num * b.den),
                    static_cast<double>(a.num * b.num + a.den * b.den));
}

// Between which slopes a cell of a quadrant lies.
struct cell_slopes {
  sweep_slope low, high;
};
IRG_INLINE constexpr cell_slopes slopes_of(std::int64_t x, std::int64_t y) noexcept {
  return {x > 0 ? sweep_slope{2 * x - 1, 2 * y + 1} : sweep_slope{},
          y > 0 ? sweep_slope{2 * x + 1, 2 * y - 1} : sweep_slope{1, 0}};
}

// Sums up how much of each cell of a quadrant is lit.
struct light_sums {
  struct sum {
    double lit = 0;
    int wholes = 0;  // of the quadrants that have a part of the cell, those that see all of it
  };
  std::vector<sum>* sums;
  int width;
  cell viewer;
  int sign_x, sign_y;

  constexpr void light(std::int64_t y, std::int64_t first, std::int64_t last, const sweep_slope& low,
                       const sweep_slope& high) const {
    for (std::int64_t x = first; x <= last; ++x) {
      const cell_slopes s = slopes_of(x, y);
      if (compare(s.low, high) >= 0) return;
      if (compare(s.high, low) <= 0) continue;
      const bool cut_low = compare(s.low, low) < 0, cut_high = compare(high, s.high) < 0;
      const sweep_slope a = cut_low ? low : s.low, b = cut_high ? high : s.high;
      if (compare(a, b) >= 0) continue;
      sum& to = (*sums)[static_cast<std::size_t>((viewer.y + sign_y * y) * width + viewer.x + sign_x * x)];
      to.lit += angle_between(a, b);
      to.wholes += cut_low || cut_high ? 0 : 1;
    }
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Grid>
IRG_API std::vector<double> percentages_lit(const Grid& bits, cell viewer) {
  const grid_extent e = bits.extent();
  std::vector<double> out;
  const std::size_t size = static_cast<std::size_t>(e.width) * static_cast<std::size_t>(e.height);
  std::vector<light_sums::sum> sums(size, light_sums::sum{});
  view_memory memory;
  for (int sign_y = -1; sign_y <= 1; sign_y += 2)
    for (int sign_x = -1; sign_x <= 1; sign_x += 2) {
      light_sums light{&sums, e.width, viewer, sign_x, sign_y};
      row_sweep<light_sums>({&bits, viewer, sign_x, sign_y, corner_rule::pinch, (std::numeric_limits<int>::max)()},
                            memory.now, memory.next, light)
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
      const cell_slopes s = slopes_of(dx, dy);
      if ((dx == 0 && dy == 0) || sums[i].wholes == parts)
        out[i] = 100;
      else
        out[i] = 100 * (sums[i].lit / (parts * angle_between(s.low, s.high)));
    }
  return out;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
