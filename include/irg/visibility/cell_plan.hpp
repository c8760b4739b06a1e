// SPDX-License-Identifier: MIT
// cell_plan: a building as convex cells of the plane, and the portals between them through which one sees and walks.
//
// A portal lies on a side of each of its two cells, which lie on both sides of it; all else of a cell's boundary is
// wall. Decisions are exact for the coordinates as they are, so a portal in a slanted wall needs ends that lie on it,
// such as corners of both cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/math/vec.hpp>
#if IRG_BODIES
#include <irg/geometry/compare.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#endif

namespace irg {

/// A room: a convex polygon, counter-clockwise, and how far up it reaches.
template <Floating T>
struct plan_cell {
  std::vector<point<T, 2>> corners;
  T floor = T(0), ceiling = T(1);
  bool operator==(const plan_cell&) const = default;
};

/// An opening between two cells, from a to b; from the higher of their floors to the lower of their ceilings.
template <Floating T>
struct plan_portal {
  std::uint32_t first = 0, second = 0;
  point<T, 2> a{}, b{};
  bool operator==(const plan_portal&) const = default;
};

/// Cells and the portals between them. Cells may lie over each other, as storeys do; only portals connect them.
template <Floating T>
struct cell_plan {
  std::vector<plan_cell<T>> cells;
  std::vector<plan_portal<T>> portals;
  bool operator==(const cell_plan&) const = default;
};

/// What is wrong with a plan.
enum class plan_defect {
  none,
  too_many_cells,  ///< more than 2^31 - 1
  short_cell,  ///< a cell has fewer than three corners
  corner_not_finite,  ///< a coordinate of a cell is infinite or NaN
  cell_not_convex,  ///< it has a corner that turns inwards, or goes round more than once
  cell_not_counter_clockwise,  ///< it runs clockwise, or has no area
  heights_not_in_order,  ///< a floor is not below its ceiling, or one of them is not finite
  portal_to_no_cell,  ///< it names a cell that the plan does not have
  portal_to_itself,  ///< both of its cells are the same: mirrors are no portals
  portal_not_finite,  ///< a coordinate of it is infinite or NaN
  portal_without_length,  ///< its ends are one point
  portal_off_the_wall,  ///< no side of one of its cells holds it whole
  portal_on_one_side,  ///< its cells lie on the same side of it
  portals_overlap,  ///< two portals of a cell share more than a point
};

/// The first defect of a plan; index counts cells or portals, whichever it names. `cell` tells which cell of a portal.
struct plan_finding {
  plan_defect defect = plan_defect::none;
  std::size_t index = 0;
  std::uint32_t cell = 0;
  bool operator==(const plan_finding&) const = default;
};

/// A portal as one passes it: into which cell, and which of its ends are to the right and to the left.
template <Floating T>
struct doorway {
  std::uint32_t to = 0, portal = 0;
  point<T, 2> right{}, left{};
  bool operator==(const doorway&) const = default;
};

namespace detail {

// The doorways of cell c are doors[i] for i from first[c] to first[c + 1].
template <Floating T>
struct door_lists {
  std::vector<std::uint32_t> first{};
  std::vector<doorway<T>> doors{};
};

struct portal_lists;

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API door_lists<T> door_lists_of(const cell_plan<T>& plan);

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

/// The portals of each cell, as one leaves it.
/// needs   a plan without defects
template <Floating T>
class portal_graph {
public:
  /// cost    linear; allocates the result
  IRG_INLINE constexpr explicit portal_graph(const cell_plan<T>& plan) : lists_(detail::door_lists_of(plan)) {}
  [[nodiscard]] IRG_INLINE constexpr std::size_t cell_count() const noexcept { return lists_.first.size() - 1; }
  /// needs   a cell of the plan
  [[nodiscard]] IRG_INLINE constexpr std::span<const doorway<T>> doors(std::uint32_t cell) const noexcept {
    return {lists_.doors.data() + lists_.first[cell], lists_.first[cell + 1] - lists_.first[cell]};
  }

private:
  friend struct detail::portal_lists;

  detail::door_lists<T> lists_;
};

namespace detail {

// The lists of a graph.
struct portal_lists {
  template <Floating T>
  IRG_INLINE static constexpr const door_lists<T>& of(const portal_graph<T>& graph) noexcept {
    return graph.lists_;
  }
};

}  // namespace detail

inline namespace IRG_COMPILED_ABI {

/// The first thing that is wrong with a plan, cells first; `none` when its portals and cells keep what cell_plan says.
/// exact   for all coordinates, infinities and NaN included
/// cost    the corners of both cells for each portal, and for each cell the square of its portals; allocates for their
///         lists
template <Floating T>
[[nodiscard]] IRG_API plan_finding validate(const cell_plan<T>& plan);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// On which side of the line ab the corners of a cell lie that are not on it; 0 when there are corners on both sides.
template <class T>
constexpr int side_of_cell(const plan_cell<T>& c, const point<T, 2>& a, const point<T, 2>& b) noexcept {
  int side = 0;
  for (const point<T, 2>& p : c.corners) {
    const int turn = orient2d(a, b, p);
    if (turn != 0 && turn == -side) return 0;
    if (turn != 0) side = turn;
  }
  return side;
}

// The side of ab on which the cell lies that has ab in one of its sides; 0 when it has not.
template <class T>
constexpr int side_of_wall(const plan_cell<T>& c, const point<T, 2>& a, const point<T, 2>& b) noexcept {
  const int side = side_of_cell(c, a, b);
  const point<T, 2>*first = nullptr, *last = nullptr;  // of the corners on the line
  for (const point<T, 2>& p : c.corners) {
    if (side == 0 || orient2d(a, b, p) != 0) continue;
    if (first == nullptr || compare_lexicographic(p, *first) < 0) first = &p;
    if (last == nullptr || compare_lexicographic(p, *last) > 0) last = &p;
  }
  if (first == nullptr || !is_between_ends(*first, *last, a) || !is_between_ends(*first, *last, b)) return 0;
  return side;
}

template <class T>
constexpr bool portals_share_a_stretch(const plan_portal<T>& p, const plan_portal<T>& q) noexcept {
  if (orient2d(p.a, p.b, q.a) != 0 || orient2d(p.a, p.b, q.b) != 0) return false;
  const bool forward = compare_lexicographic(p.a, p.b) < 0, along = compare_lexicographic(q.a, q.b) < 0;
  const point<T, 2>&p_first = forward ? p.a : p.b, &p_last = forward ? p.b : p.a;
  const point<T, 2>&q_first = along ? q.a : q.b, &q_last = along ? q.b : q.a;
  return compare_lexicographic(p_first, q_last) < 0 && compare_lexicographic(q_first, p_last) < 0;
}

template <class T>
constexpr plan_defect defect_of_cell(const plan_cell<T>& c) noexcept {
  if (c.corners.size() < 3) return plan_defect::short_cell;
  for (const point<T, 2>& p : c.corners)
    if (!is_convex(std::span(&p, 1))) return plan_defect::corner_not_finite;
  if (!is_convex(c.corners)) return plan_defect::cell_not_convex;
  if (orientation_of(c.corners) != orientation::counter_clockwise) return plan_defect::cell_not_counter_clockwise;
  const point<T, 2> heights{c.floor, c.ceiling};
  return c.floor < c.ceiling && is_convex(std::span(&heights, 1)) ? plan_defect::none
                                                                  : plan_defect::heights_not_in_order;
}

// needs   valid cells
template <class T>
constexpr plan_finding find_portal_defect(const cell_plan<T>& plan, std::size_t i) noexcept {
  const plan_portal<T>& p = plan.portals[i];
  for (const std::uint32_t c : {p.first, p.second})
    if (c >= plan.cells.size()) return {plan_defect::portal_to_no_cell, i, c};
  if (p.first == p.second) return {plan_defect::portal_to_itself, i, p.first};
  for (const point<T, 2>& end : {p.a, p.b})
    if (!is_convex(std::span(&end, 1))) return {plan_defect::portal_not_finite, i, p.first};
  if (p.a == p.b) return {plan_defect::portal_without_length, i, p.first};
  const int side = side_of_wall(plan.cells[p.first], p.a, p.b), beyond = side_of_wall(plan.cells[p.second], p.a, p.b);
  if (side == 0 || beyond == 0) return {plan_defect::portal_off_the_wall, i, side == 0 ? p.first : p.second};
  if (side == beyond) return {plan_defect::portal_on_one_side, i, p.first};
  return {};
}

// Follows all ways through doors that enter(door) lets pass, depth first; leave() takes the last door back. False when
// more than most_doors were asked.
// shape   doors(cell): the doors of a cell, which lead `to` another one
template <class Doors, class Enter, class Leave>
constexpr bool walk_ways(std::uint32_t cell, std::uint64_t most_doors, const Doors& doors, const Enter& enter,
                         const Leave& leave) {
  struct step {
    std::uint32_t cell;
    std::size_t next_door;
  };
  std::vector<step> way(1, step{cell, 0});
  for (std::uint64_t count = 0; !way.empty();) {
    const auto& ahead = doors(way.back().cell);
    if (way.back().next_door == ahead.size()) {
      way.pop_back();
      if (!way.empty()) leave();
      continue;
    }
    if (count++ == most_doors) return false;
    if (const auto& door = ahead[way.back().next_door++]; enter(door)) way.push_back({door.to, 0});
  }
  return true;
}

template <Floating T>
constexpr std::span<const doorway<T>> doors_at(const door_lists<T>& lists, std::uint32_t cell) noexcept {
  return {lists.doors.data() + lists.first[cell], lists.first[cell + 1] - lists.first[cell]};
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API door_lists<T> door_lists_of(const cell_plan<T>& plan) {
  door_lists<T> lists{std::vector<std::uint32_t>(plan.cells.size() + 1, std::uint32_t{0})};
  auto& [first, doors] = lists;
  for (const plan_portal<T>& p : plan.portals) ++first[p.first + 1], ++first[p.second + 1];
  for (std::size_t c = 0; c + 1 < first.size(); ++c) first[c + 1] += first[c];
  std::vector<std::uint32_t> next(first.begin(), first.end());
  doors.assign(2 * plan.portals.size(), doorway<T>{});
  for (std::size_t i = 0; i < plan.portals.size(); ++i) {
    const plan_portal<T>& p = plan.portals[i];
    const auto number = static_cast<std::uint32_t>(i);
    const bool is_first_left = side_of_cell(plan.cells[p.first], p.a, p.b) > 0;
    const point<T, 2>&right = is_first_left ? p.a : p.b, &left = is_first_left ? p.b : p.a;
    doors[next[p.first]++] = {p.second, number, right, left};
    doors[next[p.second]++] = {p.first, number, left, right};
  }
  return lists;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API plan_finding validate(const cell_plan<T>& plan) {
  if (plan.cells.size() > 0x7fffffff) return {plan_defect::too_many_cells, 0x7fffffff, 0};
  for (std::size_t c = 0; c < plan.cells.size(); ++c)
    if (const plan_defect d = detail::defect_of_cell(plan.cells[c]); d != plan_defect::none)
      return {d, c, static_cast<std::uint32_t>(c)};
  for (std::size_t i = 0; i < plan.portals.size(); ++i)
    if (const plan_finding f = detail::find_portal_defect(plan, i); f.defect != plan_defect::none) return f;
  const portal_graph<T> graph(plan);
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c)
    for (const doorway<T>& d : graph.doors(c))
      for (const doorway<T>& other : graph.doors(c))
        if (other.portal < d.portal &&
            detail::portals_share_a_stretch(plan.portals[d.portal], plan.portals[other.portal]))
          return {plan_defect::portals_overlap, d.portal, c};
  return {};
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
