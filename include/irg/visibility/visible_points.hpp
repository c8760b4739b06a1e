// SPDX-License-Identifier: MIT
// Points that hide each other: on a line those next to the viewer are seen, in the plane the nearest on each ray.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/math/vec.hpp>
#if IRG_BODIES
#include <irg/visibility/detail/direction_order.hpp>
#endif

namespace irg {

/// What a viewer on a line sees: the places of the nearest points below and above in a sorted list, where there are
/// any, and how many points stand where the viewer does.
struct line_neighbours {
  std::optional<std::size_t> below{}, above{};
  std::size_t here = 0;
  bool operator==(const line_neighbours&) const = default;
};

inline namespace IRG_ABI {

/// The nearest of sorted points on each side of a viewer on their line.
/// needs   points in rising order, none of them NaN
/// gives   nothing on a side without points, on both for a viewer that is NaN; of equal points the one next to the
///         viewer in the list. Points where the viewer stands hide nothing
/// exact   comparisons alone
/// cost    log n
template <Scalar T>
[[nodiscard]] constexpr line_neighbours see_on_line(std::span<const T> sorted,
                                                    std::type_identity_t<T> viewer) noexcept {
  line_neighbours seen;
  if (!(viewer == viewer)) return seen;
  const auto first = std::lower_bound(sorted.begin(), sorted.end(), viewer),
             last = std::upper_bound(sorted.begin(), sorted.end(), viewer);
  if (first != sorted.begin()) seen.below = static_cast<std::size_t>(first - sorted.begin()) - 1;
  if (last != sorted.end()) seen.above = static_cast<std::size_t>(last - sorted.begin());
  seen.here = static_cast<std::size_t>(last - first);
  return seen;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// Whether each of many points in the plane is seen from a viewer: it is when no other one stands before it on its ray.
/// gives   equal points are seen together; a point where the viewer stands is seen and hides nothing; one with a
///         coordinate that is NaN or infinite is not seen and hides nothing; none is seen from a viewer that is not
///         finite
/// exact   for all finite floats and doubles
/// cost    n log n; allocates the order of the directions
/// source  irg's own: the plane as a bundle of lines
template <Floating T>
[[nodiscard]] IRG_API std::vector<std::uint8_t> visible_points(std::span<const point<T, 2>> points,
                                                               const point<T, 2>& viewer);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API std::vector<std::uint8_t> visible_points(std::span<const point<T, 2>> points,
                                                               const point<T, 2>& viewer) {
  constexpr T most = (std::numeric_limits<T>::max)();
  const auto is_place = [](const point<T, 2>& p) { return -most <= p.x && p.x <= most && -most <= p.y && p.y <= most; };
  std::vector<std::uint8_t> seen(points.size(), std::uint8_t{0});
  if (!is_place(viewer)) return seen;
  std::vector<point<T, 2>> others;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] == viewer) seen[i] = 1;
    if (points[i] == viewer || !is_place(points[i])) continue;
    others.push_back(points[i]);
    number.push_back(i);
  }
  const auto rays = detail::ordered_directions(viewer, others);
  for (std::size_t r = 0; r < rays.first.size(); ++r) {
    const std::size_t from = rays.first[r], to = r + 1 < rays.first.size() ? rays.first[r + 1] : others.size();
    // On one ray the nearer point is nearer along both axes: comparisons tell.
    const auto is_nearer = [&](const point<T, 2>& p, const point<T, 2>& q) {
      if (p.x != q.x) return (viewer.x < p.x) == (p.x < q.x);
      return p.y != q.y && (viewer.y < p.y) == (p.y < q.y);
    };
    std::size_t nearest = from;
    for (std::size_t k = from + 1; k < to; ++k)
      if (is_nearer(others[rays.order[k]], others[rays.order[nearest]])) nearest = k;
    for (std::size_t k = from; k < to; ++k)
      if (others[rays.order[k]] == others[rays.order[nearest]]) seen[number[rays.order[k]]] = 1;
  }
  return seen;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
