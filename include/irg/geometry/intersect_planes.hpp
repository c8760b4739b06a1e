// SPDX-License-Identifier: MIT
// What two or three planes have in common, decided exactly; lines and points right to the last bit or nearly so.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg {

/// How two planes lie, and the line they have in common.
/// shape   line has a meaning only where the planes cross
template <Scalar T>
struct planes_meeting {
  flat_relation relation = flat_relation::none;
  parametric_line<T, 3> line{};
  bool operator==(const planes_meeting&) const = default;
};

/// What three planes have in common: a point, a line, the plane they all are, or nothing: since two are parallel and
/// distinct, or since they cross in three parallel lines (`prism`). `none` when one of them is no plane.
enum class three_planes_relation { none, point, line, coincident, parallel, prism };

/// What three planes have in common.
/// shape   at has a meaning for `point`, line for `line`
template <Scalar T>
struct three_planes_meeting {
  three_planes_relation relation = three_planes_relation::none;
  point<T, 3> at{};
  parametric_line<T, 3> line{};
  bool operator==(const three_planes_meeting&) const = default;
};

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API planes_meeting<T> meeting_of_planes(const plane<T>& first, const plane<T>& second) noexcept;
template <Floating T>
IRG_API three_planes_meeting<T> meeting_of_planes(const plane<T>& first, const plane<T>& second,
                                                  const plane<T>& third) noexcept;

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

template <Real T>
constexpr planes_meeting<T> find_meeting_of_planes(const plane<T>& first, const plane<T>& second) noexcept {
  if (is_zero(normal_of(first)) || is_zero(normal_of(second))) return {};
  const auto direction =
      values_of<2>([](const auto& a, const auto& b) { return cross(normal_of(a), normal_of(b)); }, first, second);
  if (!direction) return {};
  if (is_zero(*direction)) {
    // All zero when the coefficients are proportional, d among them.
    const auto offsets = values_of<2>(
        [](const auto& a, const auto& b) { return normal_of(a) * b.d - normal_of(b) * a.d; }, first, second);
    return {is_zero(*offsets) ? flat_relation::coincident : flat_relation::parallel, {}};
  }
  // (d (u x m) + e (n x u)) / u.u for the planes n.x + d = 0 and m.x + e = 0 with u = n x m.
  const auto origin = values_of<4>(
      [](const auto& a, const auto& b) {
        const auto n = normal_of(a), m = normal_of(b), u = cross(n, m);
        return std::tuple{dot(u, u), cross(u, m) * a.d + cross(n, u) * b.d};
      },
      first, second);
  if (!origin) return {};
  const auto& [divisor, at] = *origin;
  const auto u = rounded_together<T, 3>(std::array{direction->x, direction->y, direction->z});
  return {flat_relation::crossing, {rounded_coordinates<point<T, 3>>(at / divisor), {u[0], u[1], u[2]}}};
}

template <Real T>
constexpr three_planes_meeting<T> find_meeting_of_planes(const plane<T>& first, const plane<T>& second,
                                                         const plane<T>& third) noexcept {
  using relation = three_planes_relation;
  const plane<T>* planes[] = {&first, &second, &third};
  for (const plane<T>* p : planes)
    if (is_zero(normal_of(*p))) return {};
  const auto v = values_of<3>(
      [](const auto& p, const auto& q, const auto& r) {
        const auto a = normal_of(p), b = normal_of(q), c = normal_of(r), bc = cross(b, c);
        return std::tuple{-dot(a, bc), bc * p.d + cross(c, a) * q.d + cross(a, b) * r.d};
      },
      first, second, third);
  if (!v) return {};
  const auto& [divisor, at] = *v;
  if (!is_zero(divisor)) return {relation::point, rounded_coordinates<point<T, 3>>(at / divisor), {}};
  // The normals lie in a plane or on a line: the pairs tell the rest, and whether the three pencils are one.
  planes_meeting<T> pairs[3];
  int distinct = 0, crossing = -1;
  for (int i = 0; i < 3; ++i) {
    pairs[i] = find_meeting_of_planes(*planes[i], *planes[(i + 1) % 3]);
    distinct += pairs[i].relation == flat_relation::parallel;
    if (pairs[i].relation == flat_relation::crossing && crossing < 0) crossing = i;
  }
  if (distinct > 0) return {relation::parallel, {}, {}};
  if (crossing < 0) return {relation::coincident, {}, {}};
  if (!is_zero(at)) return {relation::prism, {}, {}};
  return {relation::line, {}, pairs[crossing].line};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// How two planes lie, and their common line: its origin is the line's point nearest to the origin, its direction the
/// cross product of the normals.
/// gives   never NaN for finite coefficients; infinity where a coordinate is beyond the range
/// exact   the relation; each coordinate of origin and direction within 0.501 ulp
///         for the coefficients as they are; the direction is multiplied by a power of two where it is beyond the range
/// cost    some 300 ns; about 4 us near a degenerate case or for numbers beyond 2^+-80
template <Plane L>
  requires Real<plane_scalar<L>>
[[nodiscard]] constexpr planes_meeting<plane_scalar<L>> intersect_planes(const L& first, const L& second) noexcept {
  if constexpr (Floating<plane_scalar<L>>)
    return detail::meeting_of_planes(detail::as_plane(first), detail::as_plane(second));
  else
    return detail::find_meeting_of_planes(detail::as_plane(first), detail::as_plane(second));
}

/// What three planes have in common.
/// gives   never NaN for finite coefficients; infinity where a coordinate is beyond the range
/// exact   the relation; the point within 0.501 ulp in each coordinate, a line as
///         for two planes
/// cost    some 200 ns for a point; about 5 us near a degenerate case or for numbers beyond 2^+-80
template <Plane L>
  requires Real<plane_scalar<L>>
[[nodiscard]] constexpr three_planes_meeting<plane_scalar<L>> intersect_planes(const L& first, const L& second,
                                                                               const L& third) noexcept {
  if constexpr (Floating<plane_scalar<L>>)
    return detail::meeting_of_planes(detail::as_plane(first), detail::as_plane(second), detail::as_plane(third));
  else
    return detail::find_meeting_of_planes(detail::as_plane(first), detail::as_plane(second), detail::as_plane(third));
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API planes_meeting<T> meeting_of_planes(const plane<T>& first, const plane<T>& second) noexcept {
  return find_meeting_of_planes(first, second);
}

template <Floating T>
IRG_API three_planes_meeting<T> meeting_of_planes(const plane<T>& first, const plane<T>& second,
                                                  const plane<T>& third) noexcept {
  return find_meeting_of_planes(first, second, third);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
