// SPDX-License-Identifier: MIT
// What becomes of a sight line that passes exactly through an edge or a vertex of the grid.
#pragma once

#include <cstdint>

#include <irg/spatial/grid_concept.hpp>

namespace irg {

/// Whether a corner stops a sight line that runs through it, from one of the cells around it to the opposite one.
enum class corner_rule {
  pinch,   // when no way leads from cell to next cell round it without crossing a full cell or a wall
  open,    // never
  closed,  // when any full cell or wall touches it
};

namespace detail::inline IRG_ABI {

// A step over an edge or a vertex: from a cell to the one that lies ahead along each axis of `axes`, bits 1, 2 and 4.
// The cells round it are the subsets of `axes`.
struct corner_step {
  cell3 from;
  int sign[3];
  unsigned axes;

  IRG_INLINE constexpr cell3 at(unsigned subset) const noexcept {
    return {from.x + ((subset & 1) != 0 ? sign[0] : 0), from.y + ((subset & 2) != 0 ? sign[1] : 0),
            from.z + ((subset & 4) != 0 ? sign[2] : 0)};
  }
};

// Whether a wall stands between the cell c and the next one along the axis in the direction of sign.
template <CellGrid G>
IRG_INLINE constexpr bool wall_ahead(const G& g, cell3 c, int axis, int sign) {
  if (sign < 0) (axis == 0 ? c.x : axis == 1 ? c.y : c.z) -= 1;
  return has_wall(g, c, axis);
}

// Whether an edge stops the step over it: two ways lead round.
template <CellGrid G>
constexpr bool stops_at_edge(const G& g, const corner_step& step, corner_rule rule) {
  const unsigned first = step.axes & (0u - step.axes), second = step.axes & ~first;
  const int i = first == 1 ? 0 : 1, k = second == 4 ? 2 : 1;
  const cell3 a = step.at(first), b = step.at(second);
  const bool by_a = is_full(g, a) || wall_ahead(g, step.from, i, step.sign[i]) || wall_ahead(g, a, k, step.sign[k]);
  if (!by_a && rule == corner_rule::pinch) return false;
  if (by_a && rule == corner_rule::closed) return true;
  return is_full(g, b) || wall_ahead(g, step.from, k, step.sign[k]) || wall_ahead(g, b, i, step.sign[i]);
}

// Whether the corner stops the step. All cells round it are cells of the grid.
template <CellGrid G>
constexpr bool stops_at_corner(const G& g, const corner_step& step, corner_rule rule) {
  if (rule == corner_rule::open) return false;
  if (step.axes != 7) return stops_at_edge(g, step, rule);
  unsigned reached = 1;  // bit s: the cell of subset s can be reached, as far as is known
  for (int round = 0; round < 7; ++round) {
    const unsigned before = reached;
    for (unsigned s = 0; s <= step.axes; ++s) {
      if ((s & ~step.axes) != 0) continue;
      const bool side = s != 0 && s != step.axes, full = side && is_full(g, step.at(s));
      if (full && rule == corner_rule::closed) return true;
      for (int axis = 0; axis < 3; ++axis) {
        const unsigned bit = 1u << axis;
        if ((step.axes & bit) == 0 || (s & bit) != 0) continue;
        const bool wall = wall_ahead(g, step.at(s), axis, step.sign[axis]);
        if (wall && rule == corner_rule::closed) return true;
        const unsigned t = s | bit;
        if (wall || full || (t != step.axes && is_full(g, step.at(t)))) continue;
        if ((reached >> s & 1) != 0 || (reached >> t & 1) != 0) reached |= 1u << s | 1u << t;
      }
    }
    if (reached == before) break;
  }
  return (reached >> step.axes & 1) == 0 && rule == corner_rule::pinch;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

// Here, since every header with a has_line_of_sight includes this one.
IRG_RENAMED(see, has_line_of_sight)

}  // namespace IRG_ABI
}  // namespace irg
