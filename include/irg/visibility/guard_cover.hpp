// SPDX-License-Identifier: MIT
// Guards on the corners of a plan who see all of it, and the proof: parts that make up the plan, each with a guard who
// sees the whole part. Chosen greedily, with a number that no choice of corners can go below.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <irg/math/vec.hpp>
#include <irg/visibility/detail/guard_chooser.hpp>
#include <irg/visibility/guard_result.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Corners of the plan from which together all of it is seen, and the parts that prove it.
/// shape   rings of any direction and in any order; a ring inside another one is a hole, one inside a hole a room
///         again. They may touch in points. Corners are numbered on from ring to ring
/// needs   fewer than 2^15 corners
/// gives   guards by increasing number, none of whom could be left out; `at_least`: so many parts have no guard in
///         common, whichever corners are chosen. No guards where no ring has an area
/// exact   every decision, for all finite floats and doubles; the corners of parts are the plan's own, bit for bit, or
///         correctly rounded crossings of lines through two of them
/// cost    m sight lines past two corners cut the plan into up to m^2 parts, each of which asks every corner: made for
///         plans of some dozens of corners
/// source  Ghosh 1987 (greedy over the parts that corners see)
template <Floating T>
[[nodiscard]] constexpr guard_cover<T> cover_by_guards(std::span<const std::vector<point<T, 2>>> rings) {
  return detail::guard_chooser<T>().run(rings);
}

}  // namespace IRG_ABI
}  // namespace irg
