// SPDX-License-Identifier: MIT
// view_through_portals: what an eye sees of a plan, and of the storey over it: each portal on the way cuts the view
// down to what passes it.
//
// In the plane the view is a wedge between two rays from the eye through points that were given, ends of portals or of
// the view itself: cutting it compares turns, and makes no new number.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/core/ring.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/visibility/cell_plan.hpp>
#if IRG_BODIES
#include <irg/geometry/compare.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#endif

namespace irg {

/// How far round a view goes.
enum class view_reach {
  all_round,  ///< in all directions; the two points do not matter
  between,  ///< from the ray through `right` counter-clockwise to the ray through `left`, less than half round
};

/// What an eye sees of the plane.
template <Floating T>
struct view_wedge {
  point<T, 2> eye{};
  view_reach reach = view_reach::all_round;
  point<T, 2> right{}, left{};
  bool operator==(const view_wedge&) const = default;
};

inline namespace IRG_ABI {

/// The part of a view that passes a doorway.
/// gives   nothing for a doorway that is behind the eye, edge-on or without length, for one that the view misses or
///         only touches, and for a view that is empty or not less than half round
/// exact   for all finite coordinates; the limits are points that were given
/// cost    up to ten turns
template <Floating T>
[[nodiscard]] constexpr std::optional<view_wedge<T>> narrowed(const view_wedge<T>& view, const doorway<T>& d) noexcept {
  const auto turn = [&](const point<T, 2>& p, const point<T, 2>& q) { return orient2d(view.eye, p, q); };
  if (turn(d.right, d.left) <= 0) return std::nullopt;
  view_wedge<T> out{view.eye, view_reach::between, d.right, d.left};
  if (view.reach == view_reach::all_round) return out;
  if (turn(view.right, view.left) <= 0) return std::nullopt;
  // A ray is within a wedge when it is not right of the right limit, nor left of the left one.
  const bool door_begins = turn(view.right, d.right) >= 0 && turn(d.right, view.left) > 0;
  const bool door_ends = turn(view.right, d.left) > 0 && turn(d.left, view.left) >= 0;
  if (!door_begins) {
    if (turn(d.right, view.right) < 0 || turn(view.right, d.left) <= 0) return std::nullopt;
    out.right = view.right;
  }
  if (!door_ends) {
    if (turn(d.right, view.left) <= 0 || turn(view.left, d.left) < 0) return std::nullopt;
    out.left = view.left;
  }
  return out;
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void send_views(const door_lists<T>& lists, std::uint32_t cell, const view_wedge<T>& view,
                        const function_ref<void(std::uint32_t, const view_wedge<T>&)>& sink);
template <Floating T>
IRG_API void send_views_in_space(const cell_plan<T>& plan, const door_lists<T>& lists, std::uint32_t cell,
                                 const view_wedge<T>& view, T eye_height,
                                 const function_ref<void(std::uint32_t, const view_wedge<T>&)>& sink);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Calls sink(cell, view_wedge) for each cell that is seen and each way it is seen, with what is seen of it.
/// shape   the eye's own cell comes first, with the whole view, and so do the cells beyond portals that the eye stands
///         in. A cell that is seen past two sides of a pillar comes twice; its wedges do not overlap
/// needs   a cell of the plan that holds the eye, its boundary included, and a plan without defects. An eye elsewhere
///         sees something else, in bounded time
/// gives   nothing for an eye that is not finite; through a portal seen edge-on nothing
/// exact   for all finite coordinates
/// cost    ten turns for each doorway of each cell that is reached; allocates the longest way
/// source  Luebke and Georges 1995, with wedges for their rectangles
template <Floating T, class Sink>
  requires std::invocable<Sink&, std::uint32_t, const view_wedge<T>&>
constexpr void view_through_portals(const portal_graph<T>& graph, std::uint32_t cell, const view_wedge<T>& view,
                                    Sink&& sink) {
  detail::send_views<T>(detail::portal_lists::of(graph), cell, view,
                        as_function<void(std::uint32_t, const view_wedge<T>&)>(sink));
}

/// Whether a ray from the eye can pass both of two convex polygons, with room on all sides; one that passes through
/// edges only does not.
/// shape   both run counter-clockwise as the eye sees them
/// needs   finite coordinates; an eye in front of both planes
/// exact   for all finite coordinates: only an edge of one of the two parts their views
/// cost    a determinant for each pair of an edge and a vertex
template <SpaceRing P, SpaceRing Q, Point Eye>
  requires(size_of<Eye> == 3 && std::same_as<ring_point<P>, Eye> && std::same_as<ring_point<Q>, Eye>)
[[nodiscard]] constexpr bool seen_through_both(const Eye& eye, const P& first, const Q& second) noexcept {
  const auto has_corner_within = [&](const auto& p, std::size_t i) {
    bool any = false;
    for (std::size_t k = 0; k < ring_size(p) && !any; ++k)
      any = orient3d(eye, ring_vertex(p, i + 1), ring_vertex(p, i), ring_vertex(p, k)) > 0;
    return any;
  };
  const auto has_area = [&](const auto& p) {
    bool any = false;
    for (std::size_t i = 0; i < ring_size(p) && !any; ++i) any = has_corner_within(p, i);
    return any;
  };
  const auto parts = [&](const auto& p, const auto& q) {
    for (std::size_t i = 0; i < ring_size(p); ++i) {
      bool outside = true;
      for (std::size_t k = 0; k < ring_size(q) && outside; ++k)
        outside = orient3d(eye, ring_vertex(p, i + 1), ring_vertex(p, i), ring_vertex(q, k)) <= 0;
      if (outside && (has_corner_within(p, i) || !has_area(p))) return true;  // no corner that repeats
    }
    return false;
  };
  return !parts(first, second) && !parts(second, first);
}

/// The opening of a doorway in space, counter-clockwise as one sees it who passes: from the higher of its cells' floors
/// to the lower of their ceilings.
/// gives   equal heights where the cells share none
template <Floating T>
[[nodiscard]] constexpr std::array<point<T, 3>, 4> opening_of(const cell_plan<T>& plan, const doorway<T>& d) noexcept {
  const plan_portal<T>& p = plan.portals[d.portal];
  const plan_cell<T>&a = plan.cells[p.first], &b = plan.cells[p.second];
  const T low = a.floor < b.floor ? b.floor : a.floor, lid = a.ceiling < b.ceiling ? a.ceiling : b.ceiling;
  const T high = lid < low ? low : lid;
  const auto at = [](const point<T, 2>& q, T z) { return point<T, 3>{q.x, q.y, z}; };
  return {at(d.left, low), at(d.right, low), at(d.right, high), at(d.left, high)};
}

/// A plan and its doorways.
template <Floating T>
struct plan_with_portals {
  const cell_plan<T>& plan;
  const portal_graph<T>& graph;
};

/// The same in space: an eye that stands somewhere over the plan looks through openings that have floors and ceilings.
/// shape   as in the plane, with the view from above
/// gives   too much, never too little: of openings that are passed each two are seen through one another, and the view
///         from above is exact; three openings over each other may leave no ray
/// exact   for all finite coordinates
/// cost    as in the plane, and 32 determinants for each pair of openings on a way
template <Floating T = double, class Sink>
  requires std::invocable<Sink&, std::uint32_t, const view_wedge<T>&>
constexpr void view_through_openings(const plan_with_portals<std::type_identity_t<T>>& building, std::uint32_t cell,
                                     const view_wedge<T>& view, std::type_identity_t<T> eye_height, Sink&& sink) {
  detail::send_views_in_space<T>(building.plan, detail::portal_lists::of(building.graph), cell, view, eye_height,
                                 as_function<void(std::uint32_t, const view_wedge<T>&)>(sink));
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The cell of the eye, and those beyond portals that it stands in.
template <Floating T>
constexpr std::vector<std::uint32_t> cells_at(const door_lists<T>& lists, std::uint32_t cell, const point<T, 2>& eye) {
  std::vector<std::uint32_t> out(1, cell);
  for (std::size_t i = 0; i < out.size(); ++i)
    for (const doorway<T>& d : doors_at(lists, out[i])) {
      if (orient2d(d.right, d.left, eye) != 0 || !is_between_ends(d.right, d.left, eye)) continue;
      bool known = false;
      for (const std::uint32_t c : out) known = known || c == d.to;
      if (!known) out.push_back(d.to);
    }
  return out;
}

// may_pass(passed, door) says whether a way goes on through a door that the view passes.
template <Floating T, class MayPass, class Sink>
constexpr void view_ways(const door_lists<T>& lists, std::uint32_t cell, const view_wedge<T>& view,
                         const MayPass& may_pass, Sink& sink) {
  for (const std::uint32_t c : cells_at(lists, cell, view.eye)) {
    std::vector<view_wedge<T>> views(1, view);
    std::vector<const doorway<T>*> passed;
    sink(c, view);
    const auto enter = [&](const doorway<T>& d) {
      const auto beyond = narrowed(views.back(), d);
      if (!beyond || !may_pass(passed, d)) return false;
      passed.push_back(&d);
      views.push_back(*beyond);
      sink(d.to, *beyond);
      return true;
    };
    const auto leave = [&] {
      passed.pop_back();
      views.pop_back();
    };
    walk_ways(c, ~std::uint64_t{0}, [&](std::uint32_t at) { return doors_at(lists, at); }, enter, leave);
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void send_views(const door_lists<T>& lists, std::uint32_t cell, const view_wedge<T>& view,
                        const function_ref<void(std::uint32_t, const view_wedge<T>&)>& sink) {
  if (cell >= lists.first.size() - 1 || !is_convex(std::span(&view.eye, 1))) return;
  view_ways(lists, cell, view, [](const auto&, const auto&) { return true; }, sink);
}

template <Floating T>
IRG_API void send_views_in_space(const cell_plan<T>& plan, const door_lists<T>& lists, std::uint32_t cell,
                                 const view_wedge<T>& view, T eye_height,
                                 const function_ref<void(std::uint32_t, const view_wedge<T>&)>& sink) {
  const point<T, 3> eye{view.eye.x, view.eye.y, eye_height};
  const point<T, 2> places[] = {view.eye, {eye_height, eye_height}};  // convex when all are finite
  if (cell >= lists.first.size() - 1 || !is_convex(places)) return;
  const auto has_room = [&](const auto& passed, const doorway<T>& d) {
    const auto ahead = opening_of(plan, d);
    if (!(ahead[0].z < ahead[2].z)) return false;
    for (const doorway<T>* const before : passed)
      if (!seen_through_both(eye, opening_of(plan, *before), ahead)) return false;
    return true;
  };
  view_ways(lists, cell, view, has_room, sink);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
