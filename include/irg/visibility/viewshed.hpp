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
  bool operator==(const sight_heights&) const = default;
};

/// What a viewshed took. A line of sight goes from cell to cell, each time over the border between two of them.
struct viewshed_counts {
  std::int64_t lines = 0;        // lines of sight, one for each cell
  std::int64_t cut_short = 0;    // of these, stopped on their way
  std::int64_t steps = 0;        // borders at which lines were held against heights
  std::int64_t passed_over = 0;  // borders behind what stopped a line: not looked at

  constexpr viewshed_counts& operator+=(const viewshed_counts& o) noexcept {
    lines += o.lines;
    cut_short += o.cut_short;
    steps += o.steps;
    passed_over += o.passed_over;
    return *this;
  }
  bool operator==(const viewshed_counts&) const = default;
};

namespace detail::inline IRG_ABI {

// The sight line's height at n/d of its way is not below h: (eye - h) d + (target - eye) n >= 0.
constexpr bool passes_above(std::int64_t eye, std::int64_t target, std::int64_t h, std::int64_t n,
                            std::int64_t d) noexcept {
  return (wide_int<1>(eye - h) * wide_int<1>(d) + wide_int<1>(target - eye) * wide_int<1>(n)).sign() >= 0;
}

// Takes a line from a, a height above which its eye is, step by step to b; false when something stops it before.
template <ReadableRaster R>
IRG_INLINE constexpr bool go_over(const R& heights, const cell3& a, const cell3& b, const sight_heights& above,
                                  sight_steps& steps) {
  const auto height = [&](const cell3& c) { return static_cast<std::int64_t>(get_pixel(heights, c.x, c.y)); };
  const std::int64_t eye = height(a) + above.eye, target = height(b) + above.target;
  while (!(steps.at() == b)) {
    const unsigned axes = steps.next();
    const cell3 from = steps.at();
    steps.go(axes);
    const cell3 to = steps.at();
    const int axis = (axes & 1) != 0 ? 0 : 1;
    const std::int64_t way = std::int64_t{b[axis]} - a[axis], gone = std::int64_t{to[axis]} - a[axis];
    const std::int64_t d = 2 * (way < 0 ? -way : way), n = 2 * (gone < 0 ? -gone : gone) - 1;
    const auto free = [&](const cell3& c) { return passes_above(eye, target, height(c), n, d); };
    if (!(from == a) && !free(from)) return false;
    if (!(to == b) && !free(to)) return false;
    if (axes == 3 && !free({to.x, from.y, 0}) && !free({from.x, to.y, 0})) return false;
  }
  return true;
}

// How many steps a line still has to go.
constexpr std::int64_t steps_to(sight_steps steps, const cell3& b) noexcept {
  std::int64_t n = 0;
  for (; !(steps.at() == b); ++n) steps.go(steps.next());
  return n;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether the point above b is seen from the point above a.
/// shape   heights: a raster of integers below 2^61
/// gives   false when a or b is no cell of the raster. The cells of a and b hide nothing. A line through a corner is
///         free when one of the two cells beside it lets it pass
/// exact   always; with equal heights above the cells the same both ways
/// cost    two products of 64 bits per cell on the way
template <ReadableRaster R>
  requires std::integral<pixel_of<R>>
[[nodiscard]] constexpr bool has_line_of_sight(const R& heights, cell a, cell b, const sight_heights& above = {}) {
  const grid_extent e{width_of(heights), height_of(heights), 1};
  if (!e.holds(a) || !e.holds(b)) return false;
  detail::sight_steps steps(a, b);
  return detail::go_over(heights, a, b, above, steps);
}

/// The cells that are seen from the eye over one of them, its own among them.
/// gives   no cell when the eye is over none
/// exact   always
/// cost    has_line_of_sight() for each cell
template <ReadableRaster R>
  requires std::integral<pixel_of<R>>
[[nodiscard]] constexpr cell_grid viewshed(const R& heights, cell eye, const sight_heights& above = {}) {
  const grid_extent e{width_of(heights), height_of(heights), 1};
  cell_grid out(e);
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x)
      if (has_line_of_sight(heights, eye, {x, y}, above)) out.set(cell{x, y});
  return out;
}

/// The same, and adds to the counts what it took.
/// gives   the same cells; no counts when the eye is over none
template <ReadableRaster R>
  requires std::integral<pixel_of<R>>
[[nodiscard]] constexpr cell_grid viewshed(const R& heights, cell eye, const sight_heights& above,
                                           viewshed_counts& counts) {
  const grid_extent e{width_of(heights), height_of(heights), 1};
  cell_grid out(e);
  if (!e.holds(eye)) return out;
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) {
      const cell3 to{x, y, 0};
      detail::sight_steps steps(eye, to);
      const std::int64_t all = detail::steps_to(steps, to);
      const bool seen = detail::go_over(heights, eye, to, above, steps);
      const std::int64_t left = detail::steps_to(steps, to);
      counts += {1, seen ? 0 : 1, all - left, left};
      if (seen) out.set(cell{x, y});
    }
  return out;
}

IRG_RENAMED(see_over, has_line_of_sight)

}  // namespace IRG_ABI
}  // namespace irg
