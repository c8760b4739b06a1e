// SPDX-License-Identifier: MIT
// Where a line meets a plane given by its coefficients, by three points or by parameters: crossing, parallel or
// contained is decided exactly, and point and parameters are right to the last bit or nearly so.
#pragma once

#include <array>
#include <optional>

#include <irg/geometry/detail/formula.hpp>
#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/parametric_plane.hpp>
#include <irg/geometry/plane.hpp>

namespace irg {

/// How a line lies to a plane: `none` when one of them is none (zero normal, collinear or equal points) or a number is
/// NaN or infinite.
enum class plane_line_relation { none, crossing, parallel, contained };

/// How a line lies to a plane, where it crosses it, and the parameter of that point on the line.
/// shape   at and t have a meaning only where the line crosses the plane
template <Point P>
struct plane_line_meeting {
  plane_line_relation relation = plane_line_relation::none;
  P at{};
  scalar_of<P> t{};
};

/// The same with the parameters s1 and s2 of the point in the plane.
template <Scalar T>
struct parametric_meeting {
  plane_line_relation relation = plane_line_relation::none;
  point<T, 3> at{};
  T s1{}, s2{}, t{};
};

namespace detail {
inline namespace IRG_ABI {

// v: the divisor, t times it, and the point times it.
template <Point P, class V, std::size_t Size>
constexpr plane_line_meeting<P> rounded_plane_meeting(const std::optional<std::array<V, Size>>& v) noexcept {
  if (!v) return {};
  const auto& x = *v;
  if (known_sign(x[0]) == 0)
    return {known_sign(x[1]) == 0 ? plane_line_relation::contained : plane_line_relation::parallel, {}, {}};
  return {plane_line_relation::crossing, coordinates_over<P>(x, 2, x[0]), rounded_to<scalar_of<P>>(x[1] / x[0])};
}

// The plane with normal n, the line a + t u, and the height of a over the plane times |n|.
template <class N>
constexpr std::array<N, 5> cross_plane(const std::array<N, 3>& n, const std::array<N, 3>& a, const std::array<N, 3>& u,
                                       const N& height) noexcept {
  const N divisor = dot_of(n, u), t = -height;
  return joined(std::array<N, 2>{divisor, t}, sum_of(multiple_of(a, divisor), multiple_of(u, t)));
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// How the line through a (t = 0) and b (t = 1) lies to the plane of these coefficients, and where it crosses it.
/// gives   `none` when the normal is zero or a == b, or a number is NaN or infinite. Never NaN for finite input;
///         infinity where the exact value is beyond the range
/// exact   the relation; each coordinate of the point and t within 0.501 ulp, for
///         the coefficients as they are
/// cost    some 150 ns; about 3 us near a degenerate case or for numbers beyond 2^+-80
template <Plane L, Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>> && std::same_as<plane_scalar<L>, scalar_of<P>>)
constexpr plane_line_meeting<P> intersect_plane_line(const L& plane, const P& a, const P& b) noexcept {
  using T = scalar_of<P>;
  if (detail::are_equal(a, b) || detail::is_zero_vector(normal_of(plane))) return {};
  return detail::rounded_plane_meeting<P>(detail::evaluate<3>(
      [](const auto& x) {
        const auto n = detail::part_of<3>(x, 0), from = detail::part_of<3>(x, 4);
        return detail::cross_plane(n, from, detail::difference_of(detail::part_of<3>(x, 7), from),
                                   detail::dot_of(n, from) + x[3]);
      },
      detail::gathered<T>(detail::coefficients_of(plane), a, b)));
}

/// The same for a line given by origin and direction; t counts in its direction.
template <Plane L, Real T>
  requires std::same_as<plane_scalar<L>, T>
constexpr plane_line_meeting<point<T, 3>> intersect_plane_line(const L& plane,
                                                               const parametric_line<T, 3>& line) noexcept {
  if (detail::is_zero_vector(line.direction) || detail::is_zero_vector(normal_of(plane))) return {};
  return detail::rounded_plane_meeting<point<T, 3>>(detail::evaluate<3>(
      [](const auto& x) {
        const auto n = detail::part_of<3>(x, 0), from = detail::part_of<3>(x, 4);
        return detail::cross_plane(n, from, detail::part_of<3>(x, 7), detail::dot_of(n, from) + x[3]);
      },
      detail::gathered<T>(detail::coefficients_of(plane), line.origin, line.direction)));
}

/// The same for the plane through three points, of which no coefficient is ever rounded.
/// gives   `none` when p, q and r lie on a line
/// exact   as for coefficients, for the points as they are
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
constexpr plane_line_meeting<P> intersect_plane_line(const P& p, const P& q, const P& r, const P& a,
                                                     const P& b) noexcept {
  using T = scalar_of<P>;
  if (detail::are_equal(a, b)) return {};
  const auto m = detail::rounded_plane_meeting<P>(detail::evaluate<4>(
      [](const auto& x) {
        const auto base = detail::part_of<3>(x, 0), from = detail::part_of<3>(x, 9);
        const auto n = detail::cross_of(detail::difference_of(detail::part_of<3>(x, 3), base),
                                        detail::difference_of(detail::part_of<3>(x, 6), base));
        return detail::cross_plane(n, from, detail::difference_of(detail::part_of<3>(x, 12), from),
                                   detail::dot_of(n, detail::difference_of(from, base)));
      },
      detail::gathered<T>(p, q, r, a, b)));
  if (m.relation == plane_line_relation::contained && !detail::spans_plane(p, q, r)) return {};
  return m;
}

/// The same for a parametric plane: also the parameters s1 and s2 of the crossing in the plane.
/// gives   `none` when the plane's directions are dependent or the line's is zero
/// exact   as for coefficients, for the directions as they are
/// source  Hank n.d., 1.3.5: s1*first + s2*second - t*direction = line's origin - plane's origin
template <Real T>
constexpr parametric_meeting<T> intersect_plane_line(const parametric_plane<T>& plane,
                                                     const parametric_line<T, 3>& line) noexcept {
  if (detail::is_zero_vector(line.direction)) return {};
  const auto v = detail::evaluate<4>(
      [](const auto& x) {
        using N = std::remove_cvref_t<decltype(x[0])>;
        const auto first = detail::part_of<3>(x, 0), second = detail::part_of<3>(x, 3), from = detail::part_of<3>(x, 9);
        const auto u = detail::part_of<3>(x, 12), w = detail::difference_of(from, detail::part_of<3>(x, 6));
        const auto n = detail::cross_of(first, second);
        return detail::joined(detail::cross_plane(n, from, u, detail::dot_of(n, w)),
                              std::array<N, 2>{detail::dot_of(w, detail::cross_of(second, u)),
                                               detail::dot_of(w, detail::cross_of(u, first))});
      },
      detail::gathered<T>(plane.first, plane.second, plane.origin, line.origin, line.direction));
  const auto m = detail::rounded_plane_meeting<point<T, 3>>(v);
  if (m.relation == plane_line_relation::none) return {};
  if (m.relation == plane_line_relation::crossing)
    return {m.relation, m.at, detail::rounded_to<T>((*v)[5] / (*v)[0]), detail::rounded_to<T>((*v)[6] / (*v)[0]), m.t};
  const auto normal = detail::directions_normal(plane);
  if (!normal || detail::are_zero(*normal, 0, 3)) return {};
  return {m.relation, {}, {}, {}, {}};
}

}  // namespace IRG_ABI
}  // namespace irg
