// SPDX-License-Identifier: MIT
// What two or three planes have in common, decided exactly; lines and points right to the last bit or nearly so.
#pragma once

#include <array>
#include <cstddef>

#include <irg/geometry/detail/formula.hpp>
#include <irg/geometry/intersect_plane_line.hpp>

namespace irg {

/// How two planes lie: `none` when one of them is none (zero normal, dependent directions) or a number is NaN or
/// infinite.
enum class planes_relation { none, crossing, parallel, coincident };

/// How two planes lie, and the line they have in common.
/// shape   line has a meaning only where the planes cross
template <Scalar T>
struct planes_meeting {
  planes_relation relation = planes_relation::none;
  parametric_line<T, 3> line{};
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
};

namespace detail {
inline namespace IRG_ABI {

// The numbers that are all zero when two planes are one: coefficients proportional, d among them.
template <class N>
constexpr std::array<N, 3> offsets_of(const std::array<N, 3>& n, const N& d, const std::array<N, 3>& m,
                                      const N& e) noexcept {
  return difference_of(multiple_of(n, e), multiple_of(m, d));
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// How two planes lie, and their common line: its origin is the line's point nearest to the origin, its direction the
/// cross product of the normals.
/// gives   never NaN for finite coefficients; infinity where a coordinate is beyond the range
/// exact   the relation; each coordinate of origin and direction within 0.501 ulp
///         for the coefficients as they are; the direction is multiplied by a power of two where it is beyond the range
/// cost    some 300 ns; about 4 us near a degenerate case or for numbers beyond 2^+-80
template <Plane L>
  requires Real<plane_scalar<L>>
constexpr planes_meeting<plane_scalar<L>> intersect_planes(const L& first, const L& second) noexcept {
  using T = plane_scalar<L>;
  if (detail::is_zero_vector(normal_of(first)) || detail::is_zero_vector(normal_of(second))) return {};
  const auto in = detail::gathered<T>(detail::coefficients_of(first), detail::coefficients_of(second));
  const auto direction = detail::evaluate<2>(
      [](const auto& x) { return detail::cross_of(detail::part_of<3>(x, 0), detail::part_of<3>(x, 4)); }, in);
  if (!direction) return {};
  if (detail::are_zero(*direction, 0, 3)) {
    const auto offsets = detail::evaluate<2>(
        [](const auto& x) {
          return detail::offsets_of(detail::part_of<3>(x, 0), x[3], detail::part_of<3>(x, 4), x[7]);
        },
        in);
    if (!offsets) return {};
    return {detail::are_zero(*offsets, 0, 3) ? planes_relation::coincident : planes_relation::parallel, {}};
  }
  // (d (u x m) + e (n x u)) / u.u for the planes n.x + d = 0 and m.x + e = 0 with u = n x m.
  const auto origin = detail::evaluate<4>(
      [](const auto& x) {
        using N = std::remove_cvref_t<decltype(x[0])>;
        const auto n = detail::part_of<3>(x, 0), m = detail::part_of<3>(x, 4), u = detail::cross_of(n, m);
        return detail::joined(std::array<N, 1>{detail::dot_of(u, u)},
                              detail::sum_of(detail::multiple_of(detail::cross_of(u, m), x[3]),
                                             detail::multiple_of(detail::cross_of(n, u), x[7])));
      },
      in);
  if (!origin) return {};
  const auto u = detail::rounded_together<T, 3>(*direction);
  return {planes_relation::crossing,
          {detail::coordinates_over<point<T, 3>>(*origin, 1, (*origin)[0]), {u[0], u[1], u[2]}}};
}

/// What three planes have in common.
/// gives   never NaN for finite coefficients; infinity where a coordinate is beyond the range
/// exact   the relation; the point within 0.501 ulp in each coordinate, a line as
///         for two planes
/// cost    some 200 ns for a point; about 5 us near a degenerate case or for numbers beyond 2^+-80
template <Plane L>
  requires Real<plane_scalar<L>>
constexpr three_planes_meeting<plane_scalar<L>> intersect_planes(const L& first, const L& second,
                                                                 const L& third) noexcept {
  using T = plane_scalar<L>;
  using relation = three_planes_relation;
  const L* planes[] = {&first, &second, &third};
  for (const L* p : planes)
    if (detail::is_zero_vector(normal_of(*p))) return {};
  const auto v = detail::evaluate<3>(
      [](const auto& x) {
        using N = std::remove_cvref_t<decltype(x[0])>;
        const auto a = detail::part_of<3>(x, 0), b = detail::part_of<3>(x, 4), c = detail::part_of<3>(x, 8);
        const auto bc = detail::cross_of(b, c), ca = detail::cross_of(c, a), ab = detail::cross_of(a, b);
        const auto sum = detail::sum_of(detail::sum_of(detail::multiple_of(bc, x[3]), detail::multiple_of(ca, x[7])),
                                        detail::multiple_of(ab, x[11]));
        return detail::joined(std::array<N, 1>{-detail::dot_of(a, bc)}, sum);
      },
      detail::gathered<T>(detail::coefficients_of(first), detail::coefficients_of(second),
                          detail::coefficients_of(third)));
  if (!v) return {};
  if (detail::known_sign((*v)[0]) != 0)
    return {relation::point, detail::coordinates_over<point<T, 3>>(*v, 1, (*v)[0]), {}};
  // The normals lie in a plane or on a line: the pairs tell the rest, and whether the three pencils are one.
  planes_meeting<T> pairs[3];
  int distinct = 0, crossing = -1;
  for (int i = 0; i < 3; ++i) {
    pairs[i] = intersect_planes(*planes[i], *planes[(i + 1) % 3]);
    distinct += pairs[i].relation == planes_relation::parallel;
    if (pairs[i].relation == planes_relation::crossing && crossing < 0) crossing = i;
  }
  if (distinct > 0) return {relation::parallel, {}, {}};
  if (crossing < 0) return {relation::coincident, {}, {}};
  if (!detail::are_zero(*v, 1, 3)) return {relation::prism, {}, {}};
  return {relation::line, {}, pairs[crossing].line};
}

}  // namespace IRG_ABI
}  // namespace irg
