// SPDX-License-Identifier: MIT
// The visibility polygon: what is seen in the plane from a point, among segments that may touch, cross, overlap or be
// points, within a box or within rings with holes.
//
// The directions to all ends are sorted; then, from pairs up, lists of what is nearest in which directions are merged.
// Of segments that cross only the crossings that are seen are ever looked at, however many there are.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/ring.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/segment.hpp>
#include <irg/visibility/detail/visible_ring.hpp>
#include <irg/visibility/sight_result.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

// Hands a sweep all that stops sight.
template <class Sweep, Floating T, PlanePolygon Domain>
constexpr void add_walls(Sweep& sweep, const Domain& domain, std::span<const segment<T, 2>> obstacles) {
  sweep.expect_obstacles(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) sweep.add_obstacle(obstacles[i], i);
  if constexpr (PlaneRing<Domain>)
    sweep.add_ring(domain);
  else
    for (std::size_t i = 0; i < std::size(domain); ++i) sweep.add_ring(domain[i]);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// What is seen from the source, counter-clockwise: all points to which the way from the source meets no obstacle
/// before its end and leaves the domain nowhere.
/// shape   `domain` is a ring or a list of rings; `options.rule` says what is inside. All its edges stop sight, also
///         with the inside on both sides. Obstacles may be points, and may reach out of the domain
/// needs   fewer than 2^28 obstacles and edges
/// gives   with closed obstacles the polygon without parts of no width; open ones let sight pass between ends that
///         touch, in needles to what stops it and back. Obstacles through the source, and such as are seen edge-on,
///         stop no sight but along themselves. `source_outside` and nothing where the source is not in the domain, in
///         an empty one, too; from its boundary the parts inside are seen, with the source as a vertex
/// exact   every decision, for all finite floats and doubles. Vertices are ends of obstacles and edges, bit for bit,
///         or where two cross, or a sight line past an end meets one, correctly rounded
/// cost    sorts n directions and merges n lists; O(n log n), with a factor that grows as the inverse of Ackermann's
///         function where obstacles cross
/// source  Hershberger 1989 (what is nearest, by merging); Suri and O'Rourke 1986 (the polygon)
template <Floating T, PlanePolygon Domain>
  requires std::same_as<scalar_of<polygon_point<Domain>>, T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const Domain& domain,
    std::span<const std::type_identity_t<segment<T, 2>>> obstacles = {}, const sight_options& options = {}) {
  detail::visible_ring_builder<T> sweep(source, options);
  detail::add_walls(sweep, domain, obstacles);
  return sweep.run();
}

/// The same in a box.
template <Floating T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const box<T, 2>& domain,
    std::span<const std::type_identity_t<segment<T, 2>>> obstacles = {}, const sight_options& options = {}) {
  const point<T, 2>&low = domain.low, &high = domain.high;
  if (is_empty(domain)) return {visibility_status::source_outside, {}};
  const point<T, 2> ring[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  return visibility_polygon(source, ring, obstacles, options);
}

/// The same, and adds to the counts what it took. Where there is no polygon, all walls are passed over.
template <Floating T, PlanePolygon Domain>
  requires std::same_as<scalar_of<polygon_point<Domain>>, T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const Domain& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options, sight_counts& counts) {
  detail::visible_ring_builder<T, detail::sight_tally> sweep(source, options);
  detail::add_walls(sweep, domain, obstacles);
  visible_region<T> seen = sweep.run();
  counts += sweep.counts(obstacles.size());
  return seen;
}

/// The same in a box. An empty box has no edges.
template <Floating T>
[[nodiscard]] constexpr visible_region<T> visibility_polygon(
    const point<T, 2>& source, const box<T, 2>& domain, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    const sight_options& options, sight_counts& counts) {
  const point<T, 2>&low = domain.low, &high = domain.high;
  const auto walls = static_cast<std::int64_t>(obstacles.size());
  if (is_empty(domain)) {
    counts += {.walls = walls, .passed_over = walls};
    return {visibility_status::source_outside, {}};
  }
  const point<T, 2> ring[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  return visibility_polygon(source, ring, obstacles, options, counts);
}

}  // namespace IRG_ABI
}  // namespace irg
