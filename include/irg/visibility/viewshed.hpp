// SPDX-License-Identifier: MIT
// viewshed: the cells of a height field that are seen from a point above one of them.
//
// A cell is an upright prism up to its height. The sight line from the eye to the target, both above their cells'
// centres, is free when it passes through no prism between them; touching one is passing it by.
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/core/raster_concept.hpp>
#include <irg/math/wide_int.hpp>
#include <irg/spatial/cell_grid.hpp>
#include <irg/visibility/see.hpp>

namespace irg {

/// How far above their cells the eye and what it looks for are.
struct sight_heights {
  int eye = 0, target = 0;
};

namespace detail {
inline namespace IRG_ABI {

// The sight line's height at n/d of its way is not below h: (eye - h) d + (target - eye) n >= 0.
constexpr bool passes_above(std::int64_t eye, std::int64_t target, std::int64_t h, std::int64_t n,
                            std::int64_t d) noexcept {
  return (wide_int<1>(eye - h) * wide_int<1>(d) + wide_int<1>(target - eye) * wide_int<1>(n)).sign() >= 0;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Whether the point above b is seen from the point above a.
/// shape   heights: a raster of integers below 2^61
/// gives   false when a or b is no cell of the raster. The cells of a and b hide nothing. A line through a corner is
///         free when one of the two cells beside it lets it pass
/// exact   always; with equal heights above the cells the same both ways
/// cost    two products of 64 bits per cell on the way
template <ReadableRaster R>
  requires std::integral<pixel_of<R>>
[[nodiscard]] constexpr bool see_over(const R& heights, cell a, cell b, const sight_heights& above = {}) {
  const grid_extent e{width_of(heights), height_of(heights), 1};
  if (!e.holds(a) || !e.holds(b)) return false;
  const auto height = [&](const cell3& c) { return static_cast<std::int64_t>(get_pixel(heights, c.x, c.y)); };
  const std::int64_t eye = height(a) + above.eye, target = height(b) + above.target;
  detail::sight_steps steps(a, b);
  while (!(steps.at() == cell3(b))) {
    const unsigned axes = steps.next();
    const cell3 from = steps.at();
    steps.go(axes);
    const cell3 to = steps.at();
    const int axis = (axes & 1) != 0 ? 0 : 1;
    const std::int64_t way = std::int64_t{cell3(b)[axis]} - cell3(a)[axis],
                       gone = std::int64_t{to[axis]} - cell3(a)[axis];
    const std::int64_t d = 2 * (way < 0 ? -way : way), n = 2 * (gone < 0 ? -gone : gone) - 1;
    const auto free = [&](const cell3& c) { return detail::passes_above(eye, target, height(c), n, d); };
    if (!(from == cell3(a)) && !free(from)) return false;
    if (!(to == cell3(b)) && !free(to)) return false;
    if (axes == 3 && !free({to.x, from.y, 0}) && !free({from.x, to.y, 0})) return false;
  }
  return true;
}

/// The cells that are seen from the eye over one of them, its own among them.
/// gives   no cell when the eye is over none
/// exact   always
/// cost    see_over() for each cell
template <ReadableRaster R>
  requires std::integral<pixel_of<R>>
[[nodiscard]] constexpr cell_grid viewshed(const R& heights, cell eye, const sight_heights& above = {}) {
  const grid_extent e{width_of(heights), height_of(heights), 1};
  cell_grid out(e);
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x)
      if (see_over(heights, eye, {x, y}, above)) out.set(cell{x, y});
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
