// SPDX-License-Identifier: MIT
// Whether one point of the plane is seen from another past segments, and what stops sight between them first.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/geometry/vocabulary.hpp>
#include <irg/math/vec.hpp>
#include <irg/visibility/sight_result.hpp>
#if IRG_BODIES
#include <irg/geometry/crossing_point.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/visibility/detail/turn_between.hpp>
#endif

namespace irg {

/// How far sight from p towards q is followed.
enum class sight_reach {
  up_to,    // to q, not included
  onwards,  // without end: a ray through q
};

inline namespace IRG_COMPILED_ABI {

/// The number of the obstacle that the way from p to q meets first, strictly between the two; or the ray from p through
/// q, when it is followed onwards (ray shooting).
/// shape   obstacles may touch, cross, overlap and be points. Those at p or q themselves stop no sight, unless they go
///         on between the two; onwards q is a place as any other
/// needs   finite coordinates
/// gives   nothing when none is in the way, and when p == q; of several met at one place the lowest number
/// exact   for all finite floats and doubles
/// cost    one pass; some 10 ns for each obstacle that lies on one side
template <Floating T>
[[nodiscard]] IRG_API std::optional<std::size_t> first_obstacle(
    const point<T, 2>& p, const point<T, 2>& q, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    obstacle_ends ends = obstacle_ends::closed, sight_reach reach = sight_reach::up_to) noexcept;

/// Whether q is seen from p: no obstacle is in the way, strictly between the two.
/// shape   as first_obstacle
/// needs   finite coordinates
/// gives   true when p == q; has_line_of_sight(p, q, ...) == has_line_of_sight(q, p, ...)
/// exact   for all finite floats and doubles
/// cost    as first_obstacle; ends at an obstacle in the way
template <Floating T>
[[nodiscard]] IRG_API bool has_line_of_sight(const point<T, 2>& p, const point<T, 2>& q,
                                             std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
                                             obstacle_ends ends = obstacle_ends::closed) noexcept;

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// What stops sight from p towards q: where that is, is the point `at` of an obstacle that lies
// along the way, or else the crossing with an obstacle, p being on this side of it.
template <Floating T>
struct sight_hit {
  segment<T, 2> obstacle{};
  std::optional<point<T, 2>> at{};
  int side = 0;
};

// Whether b is further on than a, both on the line from p to q.
template <Floating T>
constexpr bool leads_on(const segment<T, 2>& way, const point<T, 2>& a, const point<T, 2>& b) noexcept {
  const int axis = way.a.x != way.b.x ? 0 : 1;
  return way.a[axis] < way.b[axis] ? a[axis] < b[axis] : b[axis] < a[axis];
}

template <Floating T>
constexpr std::optional<sight_hit<T>> hit_between(const segment<T, 2>& way, const segment<T, 2>& o, obstacle_ends ends,
                                                  sight_reach reach) noexcept {
  const int a = orient2d(way.a, way.b, o.a), b = orient2d(way.a, way.b, o.b);
  if (a * b > 0) return std::nullopt;
  if (a == 0 && b == 0) {
    const bool is_point = o.a == o.b, forward = is_point || leads_on(way, o.a, o.b);
    const point<T, 2>&low = forward ? o.a : o.b, &high = forward ? o.b : o.a;
    if (!leads_on(way, way.a, high)) return std::nullopt;
    if (reach == sight_reach::up_to && !leads_on(way, low, way.b)) return std::nullopt;
    if (is_point && ends == obstacle_ends::open) return std::nullopt;
    return sight_hit<T>{o, leads_on(way, way.a, low) ? low : way.a, 0};
  }
  if (a * b == 0 && ends == obstacle_ends::open) return std::nullopt;
  const int p = orient2d(o.a, o.b, way.a), q = orient2d(o.a, o.b, way.b);
  if (p == 0) return std::nullopt;
  const bool is_ahead = p == -q || (reach == sight_reach::onwards && (q == 0 || turn_between(o, way) == -p));
  return is_ahead ? std::optional<sight_hit<T>>({o, std::nullopt, p}) : std::nullopt;
}

// Whether x comes before y on the way.
template <Floating T>
constexpr bool is_hit_before(const segment<T, 2>& way, const sight_hit<T>& x, const sight_hit<T>& y) noexcept {
  if (x.at && y.at) return leads_on(way, *x.at, *y.at);
  if (x.at) return orient2d(y.obstacle.a, y.obstacle.b, *x.at) == y.side;
  if (y.at) return orient2d(x.obstacle.a, x.obstacle.b, *y.at) == -x.side;
  return side_of_crossing(way, x.obstacle, y.obstacle) == static_cast<side>(y.side);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API std::optional<std::size_t> first_obstacle(
    const point<T, 2>& p, const point<T, 2>& q, std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
    obstacle_ends ends, sight_reach reach) noexcept {
  const segment<T, 2> way{p, q};
  std::optional<std::size_t> first;
  detail::sight_hit<T> best;
  for (std::size_t i = 0; i < obstacles.size() && !(p == q); ++i) {
    const auto hit = detail::hit_between(way, obstacles[i], ends, reach);
    if (!hit || (first && !detail::is_hit_before(way, *hit, best))) continue;
    first = i;
    best = *hit;
  }
  return first;
}

template <Floating T>
[[nodiscard]] IRG_API bool has_line_of_sight(const point<T, 2>& p, const point<T, 2>& q,
                                             std::span<const std::type_identity_t<segment<T, 2>>> obstacles,
                                             obstacle_ends ends) noexcept {
  if (p == q) return true;
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    if (detail::hit_between(segment<T, 2>{p, q}, obstacles[i], ends, sight_reach::up_to)) return false;
  return true;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
