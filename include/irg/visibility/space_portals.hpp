// SPDX-License-Identifier: MIT
// Cells and portals in space: convex cells of any kind, and the flat convex openings between them. Which cells may be
// seen from which, and what an eye sees: too much, never too little.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/spatial/cell_grid.hpp>
#include <irg/visibility/detail/space_stabbing.hpp>
#include <irg/visibility/potentially_visible.hpp>
#include <irg/visibility/space_plan.hpp>
#include <irg/visibility/view_through_portals.hpp>
#include <irg/visibility/detail/space_portals_steps.hpp>

namespace irg {

inline namespace IRG_ABI {

/// For each cell the cells of which something may be seen from somewhere in it, itself among them.
/// shape   as potentially_visible of plans in the plane; symmetric
/// needs   a plan without defects, fewer than 2^31 cells
/// gives   exactly what lines see that pass portals within their edges, and too much, never too little, where it says
///         so: ways on which it finds neither a line nor that there is none in options.most_parts parts, as where lines
///         touch edges only, are held to be open and counted; where a search would look at more than options.most_doors
///         portals it gives all cells that see this one, and such searches are counted
/// exact   lines are found by signs, and none is ruled out but by signs and bounds of what rounding does. With
///         coordinates above 2^300, or all below 2^-300, the middle one of each three portals on a way meets the hull
///         of the others, and ways are counted as undecided
/// cost    for each sequence of portals that is tried the pairs of portals before, each the planes through three of
///         their corners, and a part of the search for a line, seldom more than one. At most most_doors times
///         most_parts of them for each cell
/// source  Teller and Sequin 1991, with a search for their stabbing lines
template <Floating T>
[[nodiscard]] constexpr visible_sets potentially_visible(const space_plan<T>& plan,
                                                         const visible_set_options& options = {}) {
  const auto cells = static_cast<int>(plan.cells.size());
  visible_sets out{cell_grid(grid_extent{cells, cells, 1}), 0, 0};
  const detail::space_walk<T> walk(plan);
  for (int row = 0; row < cells; ++row) {
    detail::space_stabbing<T> lines(options.most_parts);
    const auto may_pass = [&](const auto& passed, const detail::space_doorway<T>& d) {
      if (!walk.face_each_other(passed, d)) return false;
      while (lines.size() > passed.size()) lines.leave();
      lines.enter(d.ring);
      if (lines.is_passed_as_before()) return true;
      if (!walk.meet_hulls(passed, d)) return false;
      const auto is_passed = lines.is_passed();
      if (!is_passed) ++out.undecided;
      return is_passed.value_or(true);
    };
    const auto see = [&](std::uint32_t c) { out.seen.set({static_cast<int>(c), row, 0}); };
    if (walk.from(static_cast<std::uint32_t>(row), options.most_doors, may_pass, see)) continue;
    for (std::uint32_t c = 0; c < plan.cells.size(); ++c) see(c);
    ++out.unfinished;
  }
  for (int row = 0; row < cells; ++row)  // what one way rules out is not seen the other way
    for (int c = 0; c < row; ++c)
      for (const cell3& at : {cell3{c, row, 0}, cell3{row, c, 0}})
        if (!out.seen.is_full({at.y, at.x, 0})) out.seen.set(at, false);
  return out;
}

/// Calls sink(cell) for each cell that an eye may see and each way on which it may, its own cell first.
/// needs   a plan without defects; the cell that holds the eye, which is finite
/// gives   too much, never too little, of what is seen within the edges of portals: each two portals on a way are seen
///         through one another. Nothing through a portal in whose plane the eye is
/// exact   for all finite coordinates
/// cost    the edges times the corners of each two portals on a way
/// source  Luebke and Georges 1995
template <Floating T, class Sink>
  requires std::invocable<const Sink&, std::uint32_t>
constexpr void view_through_portals(const space_plan<T>& plan, std::uint32_t cell, const point<T, 3>& eye,
                                    const Sink& sink) {
  if (cell >= plan.cells.size()) return;
  const auto may_pass = [&](const auto& passed, const detail::space_doorway<T>& d) {
    if (orient3d(d.ring[0], d.ring[1], d.ring[2], eye) <= 0) return false;
    for (const auto* before : passed)
      if (!seen_through_both(eye, before->ring, d.ring)) return false;
    return true;
  };
  detail::space_walk<T>(plan).from(cell, ~std::uint64_t{0}, may_pass, sink);
}

}  // namespace IRG_ABI
}  // namespace irg
