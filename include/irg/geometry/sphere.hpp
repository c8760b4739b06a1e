// SPDX-License-Identifier: MIT
// Circles and spheres (bounding_sphere<T, N>, a centre and a radius): through two, three and four points, and against
// points, boxes, planes and each other, decided exactly.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/formula.hpp>
#include <irg/geometry/plane.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The smallest sphere through a and up to three points at u, v, w from it: its centre is at `offset / (2 divisor)` from
// a.
template <class N, std::size_t D>
struct sphere_centre {
  N divisor{};
  std::array<N, D> offset{};
};

template <class N, std::size_t D>
constexpr sphere_centre<N, D> centre_of_sphere(const std::array<N, D>& u) noexcept {
  return {dot_of(u, u), multiple_of(u, dot_of(u, u))};
}
template <class N>
constexpr sphere_centre<N, 2> centre_of_sphere(const std::array<N, 2>& u, const std::array<N, 2>& v) noexcept {
  const N uu = dot_of(u, u), vv = dot_of(v, v);
  return {cross_of(u, v)[0], {uu * v[1] - vv * u[1], vv * u[0] - uu * v[0]}};
}
template <class N>
constexpr sphere_centre<N, 3> centre_of_sphere(const std::array<N, 3>& u, const std::array<N, 3>& v) noexcept {
  const auto n = cross_of(u, v);
  return {dot_of(n, n), sum_of(multiple_of(cross_of(v, n), dot_of(u, u)), multiple_of(cross_of(n, u), dot_of(v, v)))};
}
template <class N>
constexpr sphere_centre<N, 3> centre_of_sphere(const std::array<N, 3>& u, const std::array<N, 3>& v,
                                               const std::array<N, 3>& w) noexcept {
  const auto vw = cross_of(v, w), wu = cross_of(w, u), uv = cross_of(u, v);
  return {dot_of(u, vw),
          sum_of(sum_of(multiple_of(vw, dot_of(u, u)), multiple_of(wu, dot_of(v, v))), multiple_of(uv, dot_of(w, w)))};
}

// The centre of the sphere through the points that x holds one after the other, as seen from the first.
template <std::size_t Count, std::size_t D, class N, std::size_t Size>
constexpr sphere_centre<N, D> centre_from(const std::array<N, Size>& x) noexcept {
  const auto way = [&](std::size_t i) { return difference_of(part_of<D>(x, i * D), part_of<D>(x, 0)); };
  if constexpr (Count == 2)
    return centre_of_sphere(way(1));
  else if constexpr (Count == 3)
    return centre_of_sphere(way(1), way(2));
  else
    return centre_of_sphere(way(1), way(2), way(3));
}

template <Point P, class... More>
constexpr auto sphere_of(const P& a, const More&... more) noexcept {
  using T = scalar_of<P>;
  using ball = bounding_sphere<T, size_of<P>>;
  constexpr std::size_t D = static_cast<std::size_t>(size_of<P>), points = 1 + sizeof...(More);
  const auto values = evaluate<5>(
      [](const auto& x) {
        const auto c = centre_from<points, D>(x);
        const auto twice = c.divisor + c.divisor;
        return joined(std::array{twice}, joined(c.offset, sum_of(multiple_of(part_of<D>(x, 0), twice), c.offset)));
      },
      gathered<T>(a, more...));
  if (!values || known_sign((*values)[0]) == 0) return std::optional<ball>();
  const auto& v = *values;
  known_number squared = v[1] * v[1];
  for (std::size_t i = 1; i < D; ++i) squared = squared - -(v[1 + i] * v[1 + i]);
  const T radius = magnitude(rounded_to<T>(root_of(squared) / v[0]));
  return std::optional(ball{coordinates_over<point<T, size_of<P>>>(v, 1 + D, v[0]), radius});
}

// The sign of a sum of a squared length and the like, or nothing for NaN and infinities.
template <int Degree, class T, std::size_t Size, class Formula>
constexpr std::optional<int> sign_of_formula(const Formula& formula, const std::array<T, Size>& in) noexcept {
  const auto v = evaluate<Degree>(formula, in);
  if (!v) return std::nullopt;
  return known_sign((*v)[0]);
}

constexpr bool touches(std::optional<int> gap, box_boundary boundary) noexcept {
  return gap && (*gap < 0 || (*gap == 0 && boundary == box_boundary::closed));
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The smallest circle or sphere through two points: their way is its diameter.
/// gives   nothing when the points are equal, or a coordinate is NaN or infinite
/// exact   each coordinate of the centre and the radius within 0.501 ulp of the exact ones; infinity where the exact
///         value is beyond the range
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
constexpr std::optional<bounding_sphere<scalar_of<P>, size_of<P>>> sphere_through(const P& a, const P& b) noexcept {
  return detail::sphere_of(a, b);
}

/// The circle through three points, in space the sphere that has it as a great circle.
/// gives   nothing when the points lie exactly on a line, or a coordinate is NaN or infinite
/// exact   as for two points
/// cost    some 300 ns; about 10 us near a degenerate case or for coordinates beyond 2^+-80
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
constexpr std::optional<bounding_sphere<scalar_of<P>, size_of<P>>> sphere_through(const P& a, const P& b,
                                                                                  const P& c) noexcept {
  return detail::sphere_of(a, b, c);
}

/// The sphere through four points.
/// gives   nothing when the points lie exactly in a plane, or a coordinate is NaN or infinite
/// exact   as for two points
template <Point P>
  requires(Floating<scalar_of<P>> && size_of<P> == 3)
constexpr std::optional<bounding_sphere<scalar_of<P>, 3>> sphere_through(const P& a, const P& b, const P& c,
                                                                         const P& d) noexcept {
  return detail::sphere_of(a, b, c, d);
}

/// Whether p lies in the sphere or on its boundary.
/// gives   false when the radius is negative, or a number is NaN or infinite
/// exact   for all finite numbers
template <Floating T, int N>
constexpr bool contains(const bounding_sphere<T, N>& s, const point<T, N>& p) noexcept {
  constexpr std::size_t D = static_cast<std::size_t>(N);
  if (!(s.radius >= T(0))) return false;
  const auto gap = detail::sign_of_formula<2>(
      [](const auto& x) {
        const auto d = detail::difference_of(detail::part_of<D>(x, 0), detail::part_of<D>(x, D));
        return std::array{detail::dot_of(d, d) - x[2 * D] * x[2 * D]};
      },
      detail::joined(detail::gathered<T>(s.centre, p), std::array<T, 1>{s.radius}));
  return detail::touches(gap, box_boundary::closed);
}

/// Whether two spheres have a point in common; with an open boundary touching does not count.
/// gives   false when a radius is negative, or a number is NaN or infinite
/// exact   for all finite numbers
template <Floating T, int N>
constexpr bool overlap(const bounding_sphere<T, N>& a, const bounding_sphere<T, N>& b,
                       box_boundary boundary = box_boundary::closed) noexcept {
  constexpr std::size_t D = static_cast<std::size_t>(N);
  if (!(a.radius >= T(0)) || !(b.radius >= T(0))) return false;
  const auto gap = detail::sign_of_formula<2>(
      [](const auto& x) {
        const auto d = detail::difference_of(detail::part_of<D>(x, 0), detail::part_of<D>(x, D));
        const auto reach = x[2 * D] + x[2 * D + 1];
        return std::array{detail::dot_of(d, d) - reach * reach};
      },
      detail::joined(detail::gathered<T>(a.centre, b.centre), std::array<T, 2>{a.radius, b.radius}));
  return detail::touches(gap, boundary);
}

/// Whether a sphere and a box have a point in common; with an open boundary touching does not count.
/// gives   false when the radius is negative, the box empty, or a number is NaN or infinite
/// exact   for all finite numbers
template <Floating T, int N>
constexpr bool overlap(const bounding_sphere<T, N>& s, const box<T, N>& b,
                       box_boundary boundary = box_boundary::closed) noexcept {
  constexpr std::size_t D = static_cast<std::size_t>(N);
  if (!(s.radius >= T(0)) || is_empty(b)) return false;
  const auto nearest = generate_coordinates<point<T, N>>([&](int i) {
    return s.centre[i] < b.low[i] ? b.low[i] : b.high[i] < s.centre[i] ? b.high[i] : s.centre[i];
  });
  const auto gap = detail::sign_of_formula<2>(
      [](const auto& x) {
        const auto d = detail::difference_of(detail::part_of<D>(x, 0), detail::part_of<D>(x, D));
        return std::array{detail::dot_of(d, d) - x[2 * D] * x[2 * D]};
      },
      detail::joined(detail::gathered<T>(s.centre, nearest), std::array<T, 1>{s.radius}));
  return detail::touches(gap, boundary);
}

/// Where a sphere lies to a plane: above or below as a whole, or `on` when the plane cuts it; touching is cutting.
/// gives   `on` when a number is NaN or infinite, the radius is negative or the plane's normal zero
/// exact   for all finite numbers
template <Plane L, Floating T>
  requires std::same_as<plane_scalar<L>, T>
constexpr plane_side side_of(const L& plane, const bounding_sphere<T, 3>& s) noexcept {
  const auto height = [](const auto& x) {
    return detail::dot_of(detail::part_of<3>(x, 0), detail::part_of<3>(x, 4)) + x[3];
  };
  const auto in =
      detail::joined(detail::gathered<T>(detail::coefficients_of(plane), s.centre), std::array<T, 1>{s.radius});
  const auto v = detail::evaluate<4>(
      [&](const auto& x) {
        const auto h = height(x);
        const auto n = detail::part_of<3>(x, 0);
        return std::array{h, h * h - x[7] * x[7] * detail::dot_of(n, n)};
      },
      in);
  if (!v || !(s.radius >= T(0)) || detail::known_sign((*v)[1]) <= 0) return plane_side::on;
  return detail::is_zero_vector(normal_of(plane)) ? plane_side::on
                                                  : static_cast<plane_side>(detail::known_sign((*v)[0]));
}

}  // namespace IRG_ABI
}  // namespace irg
