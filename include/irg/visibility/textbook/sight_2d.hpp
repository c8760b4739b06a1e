// SPDX-License-Identifier: MIT
// Line of sight by the modified Bresenham line of sight_steps.hpp, as a thesis builds it; 45 degrees have a rule.
#pragma once

#include <algorithm>
#include <vector>

#include <irg/spatial/grid_concept.hpp>
#include <irg/visibility/textbook/sight_steps.hpp>

namespace irg::textbook {

/// What a line of sight comes to.
enum class sight { blocked, partial, full };

/// Where D = m/2: blocked when both cells beside the corner block, partial when one does; or taken for D > m/2.
enum class corner_case { both, as_printed };

/// What the checker returns: how the target is seen, and the cells on the way to it.
struct sight_list_result {
  sight seen = sight::blocked;
  std::vector<cell> cells{};
  bool operator==(const sight_list_result&) const = default;
};

}  // namespace irg::textbook

namespace irg::detail::inline IRG_ABI {

// Whether the wall between two neighbours blocks.
template <CellGrid G>
constexpr bool wall_between(const G& g, const cell3& a, const cell3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis]) return has_wall(g, a[axis] < b[axis] ? a : b, axis);
  return false;
}

// Whether the way from one cell to the one diagonally next to it is closed by the cell between them or its walls.
template <CellGrid G>
constexpr bool way_blocked(const G& g, const cell3& from, const cell3& side, const cell3& to) {
  return is_full(g, side) || wall_between(g, from, side) || wall_between(g, side, to);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook::inline IRG_ABI {

/// What is seen of b from a in the layer z = 0: full or partial sight, or none. The end cells are not tested.
/// gives   blocked when a or b is no cell of the layer; full when they are one
/// exact   always; the same from b to a
/// source  Fabris 2012, 4.3.3 and 4.3.4, with its walls between cells taken as their cells
template <CellGrid G>
[[nodiscard]] constexpr sight sight_2d(const G& g, cell a, cell b, corner_case corners = corner_case::both) {
  if (!extent_of(g).holds(a) || !extent_of(g).holds(b)) return sight::blocked;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const bool diagonal = dx == dy || dx == -dy;
  bool left = false, right = false, partial = false;
  const bool clear = sight_steps(a, b, [&](const sight_step& s) {
    if (s.next != a && s.next != b && is_full(g, s.next)) return false;
    if (s.through == passage::none) return !detail::wall_between(g, s.at, s.next);
    const auto closed = [&](const cell& side) { return detail::way_blocked(g, s.at, side, s.next); };
    if (diagonal) {  // D = m/2 at each step: sides are remembered
      left = left || closed(s.ahead);
      right = right || closed(s.aside);
      return !(left && right);
    }
    if (s.through == passage::ahead) return !closed(s.ahead);
    const bool aside = closed(s.aside);
    if (s.through == passage::aside || corners == corner_case::as_printed) return !aside;
    const bool ahead = closed(s.ahead);
    partial = partial || ahead || aside;
    return !(ahead && aside);
  });
  return !clear ? sight::blocked : left || right || partial ? sight::partial : sight::full;
}

/// What sight_2d says, with the cells from a to b and each third cell between the two that it joins.
/// gives   no cells where sight is blocked
/// exact   always; from b to a the same cells backwards. Away from corners they are all that the segment crosses
/// cost    two walks, and a cell of memory for each cell listed
/// source  Fabris 2012, 4.3.4; printed: no third cells of steep lines, the start may be lost, the target stands twice
template <CellGrid G>
[[nodiscard]] constexpr sight_list_result sight_list(const G& g, cell a, cell b, corner_case rule = corner_case::both) {
  sight_list_result out{sight_2d(g, a, b, rule)};
  if (out.seen == sight::blocked) return out;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const bool blames_aside = rule == corner_case::as_printed && dx != dy && dx != -dy;
  out.cells.push_back(a);
  sight_steps(a, b, [&](const sight_step& s) {
    out.cells.back() = s.at;
    if (s.through == passage::ahead) out.cells.push_back(s.ahead);
    if (s.through == passage::aside || (s.through == passage::corner && blames_aside)) out.cells.push_back(s.aside);
    out.cells.push_back(s.next);
    return true;
  });
  if (out.cells.front() != a) std::reverse(out.cells.begin(), out.cells.end());  // walked from b
  return out;
}

}  // namespace irg::textbook::inline IRG_ABI
