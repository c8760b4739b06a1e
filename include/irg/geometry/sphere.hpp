// SPDX-License-Identifier: MIT
// Circles and spheres (bounding_sphere<T, N>, a centre and a radius): through two, three and four points, and against
// points, boxes, planes and each other, decided exactly.
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <tuple>

#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg::inline IRG_ABI {

/// The smallest circle or sphere through two points: their way is its diameter.
/// gives   nothing when the points are equal, or a coordinate is NaN or infinite
/// exact   each coordinate of the centre and the radius within 0.501 ulp of the exact ones; infinity where the exact
///         value is beyond the range
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<bounding_sphere<scalar_of<P>, size_of<P>>> sphere_through(const P& a,
                                                                                                const P& b) noexcept;

/// The circle through three points, in space the sphere that has it as a great circle.
/// gives   nothing when the points lie exactly on a line, or a coordinate is NaN or infinite
/// exact   as for two points
/// cost    some 300 ns; about 10 us near a degenerate case or for coordinates beyond 2^+-80
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<bounding_sphere<scalar_of<P>, size_of<P>>> sphere_through(const P& a, const P& b,
                                                                                                const P& c) noexcept;

/// The sphere through four points.
/// gives   nothing when the points lie exactly in a plane, or a coordinate is NaN or infinite
/// exact   as for two points
template <Point P>
  requires(Floating<scalar_of<P>> && size_of<P> == 3)
[[nodiscard]] constexpr std::optional<bounding_sphere<scalar_of<P>, 3>> sphere_through(const P& a, const P& b,
                                                                                       const P& c, const P& d) noexcept;

/// Whether p lies in the sphere or on its boundary.
/// gives   false when the radius is negative, or a number is NaN or infinite
/// exact   for all finite numbers
template <Floating T, int N>
[[nodiscard]] constexpr bool contains(const bounding_sphere<T, N>& s, const point<T, N>& p) noexcept;

/// Whether two spheres have a point in common; with an open boundary touching does not count.
/// gives   false when a radius is negative, or a number is NaN or infinite
/// exact   for all finite numbers
template <Floating T, int N>
[[nodiscard]] constexpr bool overlap(const bounding_sphere<T, N>& a, const bounding_sphere<T, N>& b,
                                     box_boundary boundary = box_boundary::closed) noexcept;

/// Whether a sphere and a box have a point in common; with an open boundary touching does not count.
/// gives   false when the radius is negative, the box empty, or a number is NaN or infinite
/// exact   for all finite numbers
template <Floating T, int N>
[[nodiscard]] constexpr bool overlap(const bounding_sphere<T, N>& s, const box<T, N>& b,
                                     box_boundary boundary = box_boundary::closed) noexcept;

/// Where a sphere lies to a plane: above or below as a whole, or `on` when the plane cuts it; touching is cutting.
/// gives   `on` when a number is NaN or infinite, the radius is negative or the plane's normal zero
/// exact   for all finite numbers
template <Plane L, Floating T>
  requires std::same_as<plane_scalar<L>, T>
[[nodiscard]] constexpr side side_of(const L& plane, const bounding_sphere<T, 3>& s) noexcept;

IRG_REFUSES_VECTORS(sphere_through);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API std::optional<bounding_sphere<T, N>> sphere_on(const point<T, N>& a, const point<T, N>& b) noexcept;
template <Floating T, int N>
IRG_API std::optional<bounding_sphere<T, N>> sphere_on(const point<T, N>& a, const point<T, N>& b,
                                                       const point<T, N>& c) noexcept;
template <Floating T>
IRG_API std::optional<bounding_sphere<T, 3>> sphere_on(const point<T, 3>& a, const point<T, 3>& b, const point<T, 3>& c,
                                                       const point<T, 3>& d) noexcept;

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// The smallest sphere through a and up to three points at u, v, w from it: its centre is at `offset / (2 divisor)` from
// a.
template <class N, int D>
struct sphere_centre {
  N divisor{};
  vec<N, D> offset{};
};

template <class N, int D>
constexpr sphere_centre<N, D> centre_of_sphere(const vec<N, D>& u) noexcept {
  return {dot(u, u), u * dot(u, u)};
}
template <class N>
constexpr sphere_centre<N, 2> centre_of_sphere(const vec<N, 2>& u, const vec<N, 2>& v) noexcept {
  const N uu = dot(u, u), vv = dot(v, v);
  return {cross(u, v), {uu * v.y - vv * u.y, vv * u.x - uu * v.x}};
}
template <class N>
constexpr sphere_centre<N, 3> centre_of_sphere(const vec<N, 3>& u, const vec<N, 3>& v) noexcept {
  const auto n = cross(u, v);
  return {dot(n, n), cross(v, n) * dot(u, u) + cross(n, u) * dot(v, v)};
}
template <class N>
constexpr sphere_centre<N, 3> centre_of_sphere(const vec<N, 3>& u, const vec<N, 3>& v, const vec<N, 3>& w) noexcept {
  const auto vw = cross(v, w);
  return {dot(u, vw), vw * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w)};
}

// Whether p lies within this distance of centre, which is the sum of the radii.
template <Floating T, int N, class... R>
constexpr bool lies_within(const point<T, N>& centre, const point<T, N>& p, box_boundary boundary,
                           const R&... radius) noexcept {
  if (!(is_finite(centre) && is_finite(p) && (is_finite(radius) && ...))) return false;
  const int gap = sign_of<2>(
      [](const auto& from, const auto& to, const auto&... r) {
        const auto d = to - from;
        const auto reach = (r + ...);
        return dot(d, d) - reach * reach;
      },
      centre, p, radius...);
  return gap < 0 || (gap == 0 && boundary == box_boundary::closed);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<bounding_sphere<scalar_of<P>, size_of<P>>> sphere_through(const P& a,
                                                                                                const P& b) noexcept {
  return detail::sphere_on(detail::library_point(a), detail::library_point(b));
}

template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<bounding_sphere<scalar_of<P>, size_of<P>>> sphere_through(const P& a, const P& b,
                                                                                                const P& c) noexcept {
  return detail::sphere_on(detail::library_point(a), detail::library_point(b), detail::library_point(c));
}

template <Point P>
  requires(Floating<scalar_of<P>> && size_of<P> == 3)
[[nodiscard]] constexpr std::optional<bounding_sphere<scalar_of<P>, 3>> sphere_through(const P& a, const P& b,
                                                                                       const P& c,
                                                                                       const P& d) noexcept {
  return detail::sphere_on(detail::library_point(a), detail::library_point(b), detail::library_point(c),
                           detail::library_point(d));
}

template <Floating T, int N>
[[nodiscard]] constexpr bool contains(const bounding_sphere<T, N>& s, const point<T, N>& p) noexcept {
  return s.radius >= T(0) && detail::lies_within(s.centre, p, box_boundary::closed, s.radius);
}

template <Floating T, int N>
[[nodiscard]] constexpr bool overlap(const bounding_sphere<T, N>& a, const bounding_sphere<T, N>& b,
                                     box_boundary boundary) noexcept {
  return a.radius >= T(0) && b.radius >= T(0) && detail::lies_within(a.centre, b.centre, boundary, a.radius, b.radius);
}

template <Floating T, int N>
[[nodiscard]] constexpr bool overlap(const bounding_sphere<T, N>& s, const box<T, N>& b,
                                     box_boundary boundary) noexcept {
  if (!(s.radius >= T(0)) || b.empty()) return false;
  const auto nearest = generate_coordinates<point<T, N>>([&](int i) {
    return s.centre[i] < b.low[i] ? b.low[i] : b.high[i] < s.centre[i] ? b.high[i] : s.centre[i];
  });
  return detail::lies_within(s.centre, nearest, boundary, s.radius);
}

template <Plane L, Floating T>
  requires std::same_as<plane_scalar<L>, T>
[[nodiscard]] constexpr side side_of(const L& plane, const bounding_sphere<T, 3>& s) noexcept {
  if (!(s.radius >= T(0)) || detail::is_zero(normal_of(plane))) return side::on;
  const auto [height, beyond] = sign_of<4>(
      [](const auto& l, const auto& at, const auto& radius) {
        const auto n = normal_of(l);
        const auto h = dot(n, to_vec(at)) + l.d;
        return std::array{h, h * h - radius * radius * dot(n, n)};
      },
      detail::as_plane(plane), s.centre, s.radius);
  return beyond > 0 ? static_cast<side>(height) : side::on;
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

template <Point P, class... More>
constexpr auto sphere_of(const P& a, const More&... more) noexcept {
  using T = scalar_of<P>;
  using ball = bounding_sphere<T, size_of<P>>;
  const auto values = values_of<5>(
      [](const auto& from, const auto&... to) {
        const auto c = centre_of_sphere((to - from)...);
        const auto twice = c.divisor + c.divisor;
        return std::tuple{twice, c.offset, to_vec(from) * twice + c.offset};
      },
      a, more...);
  if (!values || is_zero(std::get<0>(*values))) return std::optional<ball>();
  const auto& [divisor, offset, at] = *values;
  scaled_double_double squared = offset[0] * offset[0];
  for (int i = 1; i < size_of<P>; ++i) squared = squared + offset[i] * offset[i];
  const T radius = magnitude(rounded_to<T>(sqrt(squared) / divisor));
  return std::optional(ball{rounded_coordinates<point<T, size_of<P>>>(at / divisor), radius});
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API std::optional<bounding_sphere<T, N>> sphere_on(const point<T, N>& a, const point<T, N>& b) noexcept {
  return sphere_of(a, b);
}
template <Floating T, int N>
IRG_API std::optional<bounding_sphere<T, N>> sphere_on(const point<T, N>& a, const point<T, N>& b,
                                                       const point<T, N>& c) noexcept {
  return sphere_of(a, b, c);
}
template <Floating T>
IRG_API std::optional<bounding_sphere<T, 3>> sphere_on(const point<T, 3>& a, const point<T, 3>& b, const point<T, 3>& c,
                                                       const point<T, 3>& d) noexcept {
  return sphere_of(a, b, c, d);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
