// SPDX-License-Identifier: MIT
// Line of sight by the modified Bresenham line, as a thesis builds it: cells are walked in one canonical direction, the
// third cell of a diagonal step is found by comparing the distance D with half the slope, and 45 degrees have a rule of
// their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/spatial/grid_concept.hpp>

namespace irg::textbook {

/// What a line of sight comes to.
enum class sight { blocked, partial, full };

/// Where the line runs between two cells of a diagonal step.
enum class passage {
  none,  // the step is not diagonal
  ahead,  // D < m/2: through the cell one step along the main axis
  aside,  // D > m/2: through the cell one step along the other axis
  corner  // D = m/2: through neither
};

/// What is said where D = m/2.
enum class corner_case {
  both,  // blocked when both cells beside the corner block, partial when one does
  as_printed  // taken for D > m/2
};

/// One step of the line, in canonical direction: D = distance / (2 n) for the main axis' n steps.
struct sight_step {
  cell at, next, ahead, aside;
  std::int64_t distance = 0;
  passage through = passage::none;
};

/// What the checker returns: how the target is seen, and the cells on the way to it.
struct sight_list_result {
  sight seen = sight::blocked;
  std::vector<cell> cells{};
};

inline namespace IRG_ABI {

/// Calls sink(step) for the steps between the cells of a line, in canonical direction: x rising where |dx| > |dy|, y
/// rising otherwise. Ends when sink returns false, and returns whether it never did.
/// exact   for int coordinates; D and half the slope are compared in whole numbers
/// source  Fabris 2012, 4.3.1 and 4.3.2
template <class Emit>
constexpr bool sight_steps(cell a, cell b, Emit&& sink) {
  const auto apart = [](int p, int q) { return p < q ? std::int64_t{q} - p : std::int64_t{p} - q; };
  const std::int64_t dx = apart(a.x, b.x), dy = apart(a.y, b.y);
  const bool flat = dx > dy;
  const bool reverse = flat ? b.x < a.x : b.y < a.y;
  const cell first = reverse ? b : a, last = reverse ? a : b;
  const std::int64_t n = flat ? dx : dy, m = flat ? dy : dx;
  const int sign = flat ? (last.y < first.y ? -1 : 1) : (last.x < first.x ? -1 : 1);
  std::int64_t d = 2 * m - n;  // 2 n D
  cell at = first;
  for (std::int64_t i = 0; i < n; ++i) {
    const cell ahead = flat ? cell{at.x + 1, at.y} : cell{at.x, at.y + 1};
    sight_step step{at, ahead, ahead, ahead, d, passage::none};
    if (d > 0) {
      step.aside = flat ? cell{at.x, at.y + sign} : cell{at.x + sign, at.y};
      step.next = flat ? cell{at.x + 1, at.y + sign} : cell{at.x + sign, at.y + 1};
      step.through = d < m ? passage::ahead : d > m ? passage::aside : passage::corner;
      d -= 2 * n;
    }
    d += 2 * m;
    at = step.next;
    if (!sink(static_cast<const sight_step&>(step))) return false;
  }
  return true;
}

}  // namespace IRG_ABI
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
  const grid_extent e = extent_of(g);
  if (!e.holds(a) || !e.holds(b)) return sight::blocked;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const bool diagonal = dx == dy || dx == -dy;
  bool left = false, right = false, partial = false;
  const bool clear = sight_steps(a, b, [&](const sight_step& s) {
    if (s.next != a && s.next != b && is_full(g, s.next)) return false;
    if (s.through == passage::none) return !detail::wall_between(g, s.at, s.next);
    if (diagonal) {  // D = m/2 at each step: sides are remembered
      left = left || detail::way_blocked(g, s.at, s.ahead, s.next);
      right = right || detail::way_blocked(g, s.at, s.aside, s.next);
      return !(left && right);
    }
    if (s.through == passage::ahead) return !detail::way_blocked(g, s.at, s.ahead, s.next);
    const bool aside = detail::way_blocked(g, s.at, s.aside, s.next);
    if (s.through == passage::aside || corners == corner_case::as_printed) return !aside;
    const bool ahead = detail::way_blocked(g, s.at, s.ahead, s.next);
    partial = partial || ahead || aside;
    return !(ahead && aside);
  });
  return !clear ? sight::blocked : left || right || partial ? sight::partial : sight::full;
}

/// What sight_2d says, with the cells from a to b and each third cell between the two that it joins.
/// gives   no cells where sight is blocked
/// exact   always; from b to a the same cells backwards. Away from corners they are all that the segment crosses
/// cost    two walks, and a cell of memory for each cell listed
/// source  Fabris 2012, 4.3.4; as printed a steep line lists no third cell, the start may be lost and the target stands
///         twice
template <CellGrid G>
[[nodiscard]] constexpr sight_list_result sight_list(const G& g, cell a, cell b,
                                                     corner_case corners = corner_case::both) {
  sight_list_result out;
  out.seen = sight_2d(g, a, b, corners);
  if (out.seen == sight::blocked) return out;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const bool blames_aside = corners == corner_case::as_printed && dx != dy && dx != -dy;
  out.cells.push_back(a);
  sight_steps(a, b, [&](const sight_step& s) {
    out.cells.back() = s.at;
    if (s.through == passage::ahead) out.cells.push_back(s.ahead);
    if (s.through == passage::aside || (s.through == passage::corner && blames_aside)) out.cells.push_back(s.aside);
    out.cells.push_back(s.next);
    return true;
  });
  if (out.cells.front() == a) return out;  // walked as asked for
  for (std::size_t i = 0, k = out.cells.size(); i + 1 < k; ++i) {
    const cell c = out.cells[i];
    out.cells[i] = out.cells[--k];
    out.cells[k] = c;
  }
  return out;
}

}  // namespace irg::textbook::inline IRG_ABI
