// SPDX-License-Identifier: MIT
// Where a line meets a plane given by its coefficients, by three points or by parameters: crossing, parallel or
// coincident is decided exactly, and point and parameters are right to the last bit or nearly so.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/parametric_plane.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg {

/// How a line lies to a plane, where it crosses it, and the parameter of that point on the line.
/// shape   at and t have a meaning only where the line crosses the plane
template <Point P>
struct plane_line_meeting {
  flat_relation relation = flat_relation::none;
  P at = zero_coordinates<P>();
  scalar_of<P> t{};
  IRG_APART constexpr bool operator==(const plane_line_meeting& o) const {
    return relation == o.relation && same_place(at, o.at) && t == o.t;
  }
};

/// The same with the parameters s1 and s2 of the point in the plane.
template <Scalar T>
struct parametric_meeting {
  flat_relation relation = flat_relation::none;
  point<T, 3> at{};
  T s1{}, s2{}, t{};
  bool operator==(const parametric_meeting&) const = default;
};

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API plane_line_meeting<point<T, 3>> meeting_of_plane_line(const plane<T>& plane, const point<T, 3>& a,
                                                              const point<T, 3>& b) noexcept;
template <Floating T>
IRG_API plane_line_meeting<point<T, 3>> meeting_of_plane_line(const plane<T>& plane,
                                                              const parametric_line<T, 3>& line) noexcept;
template <Floating T>
IRG_API plane_line_meeting<point<T, 3>> meeting_of_plane_line(const point<T, 3>& p, const point<T, 3>& q,
                                                              const point<T, 3>& r, const point<T, 3>& a,
                                                              const point<T, 3>& b) noexcept;
template <Floating T>
IRG_API parametric_meeting<T> meeting_of_plane_line(const parametric_plane<T>& plane,
                                                    const parametric_line<T, 3>& line) noexcept;

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// The divisor, t times it, and the point times it: of the plane with normal n, the line a + t u, and the height of a
// over the plane times |n|.
template <class P, class N>
constexpr std::tuple<N, N, vec<N, 3>> cross_plane(const vec<N, 3>& n, const P& a, const vec<N, 3>& u,
                                                  const N& height) noexcept {
  const N divisor = dot(n, u), t = -height;
  return {divisor, t, to_vec(a) * divisor + u * t};
}

template <Point P, class V>
constexpr plane_line_meeting<P> rounded_plane_meeting(const std::optional<std::tuple<V, V, vec<V, 3>>>& v) noexcept {
  if (!v) return {};
  const auto& [divisor, t, at] = *v;
  if (is_zero(divisor)) return {is_zero(t) ? flat_relation::coincident : flat_relation::parallel};
  return {flat_relation::crossing, rounded_coordinates<P>(at / divisor), rounded_to<scalar_of<P>>(t / divisor)};
}

template <Point P>
constexpr plane_line_meeting<P> find_meeting_of_plane_line(const plane<scalar_of<P>>& plane, const P& a,
                                                           const P& b) noexcept {
  if (same_place(a, b) || is_zero(normal_of(plane))) return {};
  return rounded_plane_meeting<P>(values_of<3>(
      [](const auto& l, const auto& from, const auto& to) {
        const auto n = normal_of(l);
        return cross_plane(n, from, to - from, dot(n, to_vec(from)) + l.d);
      },
      plane, a, b));
}

template <Real T>
constexpr plane_line_meeting<point<T, 3>> find_meeting_of_plane_line(const plane<T>& plane,
                                                                     const parametric_line<T, 3>& line) noexcept {
  if (is_zero(line.direction) || is_zero(normal_of(plane))) return {};
  return rounded_plane_meeting<point<T, 3>>(values_of<3>(
      [](const auto& l, const auto& from, const auto& u) {
        const auto n = normal_of(l);
        return cross_plane(n, from, u, dot(n, to_vec(from)) + l.d);
      },
      plane, line.origin, line.direction));
}

template <Point P>
constexpr plane_line_meeting<P> find_meeting_of_plane_line(const P& p, const P& q, const P& r, const P& a,
                                                           const P& b) noexcept {
  if (same_place(a, b)) return {};
  const auto m = rounded_plane_meeting<P>(values_of<4>(
      [](const auto& base, const auto& second, const auto& third, const auto& from, const auto& to) {
        const auto n = cross(second - base, third - base);
        return cross_plane(n, from, to - from, dot(n, from - base));
      },
      p, q, r, a, b));
  if (m.relation == flat_relation::coincident && !spans_plane(p, q, r)) return {};
  return m;
}

template <Real T>
constexpr parametric_meeting<T> find_meeting_of_plane_line(const parametric_plane<T>& plane,
                                                           const parametric_line<T, 3>& line) noexcept {
  if (is_zero(line.direction)) return {};
  const auto v = values_of<4>(
      [](const auto& first, const auto& second, const auto& base, const auto& from, const auto& u) {
        const auto n = cross(first, second), w = from - base;
        return std::tuple{cross_plane(n, from, u, dot(n, w)), vec{dot(w, cross(second, u)), dot(w, cross(u, first))}};
      },
      plane.first, plane.second, plane.origin, line.origin, line.direction);
  if (!v) return {};
  const auto m = rounded_plane_meeting<point<T, 3>>(std::optional(std::get<0>(*v)));
  if (m.relation == flat_relation::crossing) {
    const auto s = std::get<1>(*v) / std::get<0>(std::get<0>(*v));
    return {m.relation, m.at, rounded_to<T>(s.x), rounded_to<T>(s.y), m.t};
  }
  const auto normal = directions_normal(plane);
  if (!normal || is_zero(*normal)) return {};
  return {m.relation, {}, {}, {}, {}};
}

template <Point P, class Q>
constexpr plane_line_meeting<P> own_meeting(const plane_line_meeting<Q>& m) noexcept {
  return {m.relation, own_point<P>(m.at), m.t};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// How the line through a (t = 0) and b (t = 1) lies to the plane of these coefficients, and where it crosses it.
/// gives   `none` when the normal is zero or a == b, or a number is NaN or infinite. Never NaN for finite input;
///         infinity where the exact value is beyond the range
/// exact   the relation; each coordinate of the point and t within 0.501 ulp, for
///         the coefficients as they are
/// cost    some 150 ns; about 3 us near a degenerate case or for numbers beyond 2^+-80
template <Plane L, Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>> && std::same_as<plane_scalar<L>, scalar_of<P>>)
[[nodiscard]] constexpr plane_line_meeting<P> intersect_plane_line(const L& plane, const P& a, const P& b) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_meeting<P>(
        detail::meeting_of_plane_line(detail::as_plane(plane), detail::library_point(a), detail::library_point(b)));
  else
    return detail::find_meeting_of_plane_line(detail::as_plane(plane), a, b);
}

/// The same for a line given by origin and direction; t counts in its direction.
template <Plane L, Real T>
  requires std::same_as<plane_scalar<L>, T>
[[nodiscard]] constexpr plane_line_meeting<point<T, 3>> intersect_plane_line(
    const L& plane, const parametric_line<T, 3>& line) noexcept {
  if constexpr (Floating<T>)
    return detail::meeting_of_plane_line(detail::as_plane(plane), line);
  else
    return detail::find_meeting_of_plane_line(detail::as_plane(plane), line);
}

/// The same for the plane through three points, of which no coefficient is ever rounded.
/// gives   `none` when p, q and r lie on a line
/// exact   as for coefficients, for the points as they are
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr plane_line_meeting<P> intersect_plane_line(const P& p, const P& q, const P& r, const P& a,
                                                                   const P& b) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_meeting<P>(detail::meeting_of_plane_line(detail::library_point(p), detail::library_point(q),
                                                                detail::library_point(r), detail::library_point(a),
                                                                detail::library_point(b)));
  else
    return detail::find_meeting_of_plane_line(p, q, r, a, b);
}

/// The same for a parametric plane: also the parameters s1 and s2 of the crossing in the plane.
/// gives   `none` when the plane's directions are dependent or the line's is zero
/// exact   as for coefficients, for the directions as they are
/// source  Hank n.d., 1.3.5: s1*first + s2*second - t*direction = line's origin - plane's origin
template <Real T>
[[nodiscard]] constexpr parametric_meeting<T> intersect_plane_line(const parametric_plane<T>& plane,
                                                                   const parametric_line<T, 3>& line) noexcept {
  if constexpr (Floating<T>)
    return detail::meeting_of_plane_line(plane, line);
  else
    return detail::find_meeting_of_plane_line(plane, line);
}

IRG_REFUSES_VECTORS(intersect_plane_line);

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API plane_line_meeting<point<T, 3>> meeting_of_plane_line(const plane<T>& plane, const point<T, 3>& a,
                                                              const point<T, 3>& b) noexcept {
  return find_meeting_of_plane_line(plane, a, b);
}

template <Floating T>
IRG_API plane_line_meeting<point<T, 3>> meeting_of_plane_line(const plane<T>& plane,
                                                              const parametric_line<T, 3>& line) noexcept {
  return find_meeting_of_plane_line(plane, line);
}

template <Floating T>
IRG_API plane_line_meeting<point<T, 3>> meeting_of_plane_line(const point<T, 3>& p, const point<T, 3>& q,
                                                              const point<T, 3>& r, const point<T, 3>& a,
                                                              const point<T, 3>& b) noexcept {
  return find_meeting_of_plane_line(p, q, r, a, b);
}

template <Floating T>
IRG_API parametric_meeting<T> meeting_of_plane_line(const parametric_plane<T>& plane,
                                                    const parametric_line<T, 3>& line) noexcept {
  return find_meeting_of_plane_line(plane, line);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
