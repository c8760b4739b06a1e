// SPDX-License-Identifier: MIT
// Distances between points, lines, segments, planes, triangles and boxes, right to the last bit or nearly so over the
// whole range of float and double: nothing cancels, overflows or underflows on the way.
#pragma once

#include <optional>

#include <irg/core/contract.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/line.hpp>
#include <irg/geometry/plane.hpp>
#if IRG_BODIES
#include <array>
#include <cstddef>

#include <irg/geometry/detail/nearest.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/math/exact/values_of.hpp>
#endif

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API std::optional<T> distance_of_points(const point<T, N>& p, const point<T, N>& q) noexcept;
template <Floating T, int N>
IRG_API std::optional<T> distance_from_line(const point<T, N>& a, const point<T, N>& b, const point<T, N>& p) noexcept;
template <Floating T>
IRG_API std::optional<T> height_over_line(const line<T>& l, const point<T, 2>& p) noexcept;
template <Floating T>
IRG_API std::optional<T> height_over_plane(const plane<T>& l, const point<T, 3>& p) noexcept;
template <Floating T, int N>
IRG_API std::optional<T> distance_from_segment(const point<T, N>& a, const point<T, N>& b,
                                               const point<T, N>& p) noexcept;
template <Floating T>
IRG_API std::optional<T> distance_from_triangle(const point<T, 3>& a, const point<T, 3>& b, const point<T, 3>& c,
                                                const point<T, 3>& p) noexcept;
template <Floating T>
IRG_API std::optional<T> distance_between_lines(const point<T, 3>& a, const point<T, 3>& b, const point<T, 3>& c,
                                                const point<T, 3>& d) noexcept;
template <Floating T, int N>
IRG_API std::optional<T> distance_between_segments(const point<T, N>& a, const point<T, N>& b, const point<T, N>& c,
                                                   const point<T, N>& d) noexcept;

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

/// The distance of two points.
/// gives   nothing when a coordinate is NaN or infinite; infinity where it is beyond the range
/// exact   within 0.501 ulp
/// cost    some 100 ns; length(q - p) takes 10 ns and rounds the difference
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<scalar_of<P>> distance(const P& p, const P& q) noexcept {
  return detail::distance_of_points(detail::as_point<scalar_of<P>>(p), detail::as_point<scalar_of<P>>(q));
}

/// The distance of p from the line through a and b.
/// gives   nothing when a == b, or a coordinate is NaN or infinite
/// exact   as distance
/// cost    some 200 ns; about 4 us near a degenerate case or for coordinates beyond 2^+-80
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<scalar_of<P>> distance_to_line(const P& a, const P& b, const P& p) noexcept {
  return detail::distance_from_line(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                    detail::as_point<scalar_of<P>>(p));
}

/// The distance of p from the line a*x + b*y + c = 0, positive on the side of (a, b), which is the left one.
/// gives   nothing when a and b are zero, or a number is NaN or infinite
/// exact   as distance, for the coefficients as they are; the sign always
template <Floating T, Point P>
  requires(size_of<P> == 2 && std::same_as<scalar_of<P>, T>)
[[nodiscard]] constexpr std::optional<T> signed_distance(const line<T>& l, const P& p) noexcept {
  return detail::height_over_line(l, detail::as_point<T>(p));
}

/// The distance of p from the plane, positive on its upper side.
/// gives   nothing when the plane's normal is zero, or a number is NaN or infinite
/// exact   as distance, for the coefficients as they are; the sign always
template <Plane L, Point P>
  requires(size_of<P> == 3 && Floating<scalar_of<P>> && std::same_as<plane_scalar<L>, scalar_of<P>>)
[[nodiscard]] constexpr std::optional<scalar_of<P>> signed_distance(const L& plane, const P& p) noexcept {
  return detail::height_over_plane(detail::as_plane(plane), detail::as_point<scalar_of<P>>(p));
}

/// The distance of p from the segment ab, which may be a point.
/// gives   nothing when a coordinate is NaN or infinite
/// exact   as distance
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<scalar_of<P>> distance_to_segment(const P& a, const P& b, const P& p) noexcept {
  return detail::distance_from_segment(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                       detail::as_point<scalar_of<P>>(p));
}

/// The distance of p from the triangle abc, its inside included; it may be a segment or a point.
/// gives   nothing when a coordinate is NaN or infinite
/// exact   as distance
template <Point P>
  requires(size_of<P> == 3 && Floating<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<scalar_of<P>> distance_to_triangle(const P& a, const P& b, const P& c,
                                                                         const P& p) noexcept {
  return detail::distance_from_triangle(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                        detail::as_point<scalar_of<P>>(c), detail::as_point<scalar_of<P>>(p));
}

/// The distance of the line through a and b from the line through c and d, 0 where they cross.
/// gives   nothing when a == b or c == d, or a coordinate is NaN or infinite
/// exact   as distance; 0 for crossing lines only
template <Point P>
  requires(size_of<P> == 3 && Floating<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<scalar_of<P>> distance_of_lines(const P& a, const P& b, const P& c,
                                                                      const P& d) noexcept {
  return detail::distance_between_lines(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                        detail::as_point<scalar_of<P>>(c), detail::as_point<scalar_of<P>>(d));
}

/// The distance of the segments ab and cd, 0 where they have a point in common. Segments may be points.
/// gives   nothing when a coordinate is NaN or infinite
/// exact   as distance; 0 for segments with a common point only
/// cost    some 1 us; about 30 us near a degenerate case or for coordinates beyond 2^+-80
template <Point P>
  requires(Floating<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<scalar_of<P>> distance_of_segments(const P& a, const P& b, const P& c,
                                                                         const P& d) noexcept {
  return detail::distance_between_segments(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                           detail::as_point<scalar_of<P>>(c), detail::as_point<scalar_of<P>>(d));
}

/// The distance of p from the box, 0 inside.
/// needs   a box that is not empty
/// gives   nothing when a number is NaN or infinite
/// exact   as distance
template <Floating T, int N>
[[nodiscard]] constexpr std::optional<T> distance_to_box(const box<T, N>& b, const point<T, N>& p) noexcept {
  IRG_EXPECTS(!b.empty());
  if (!is_finite(b.low, b.high)) return std::nullopt;
  return distance(p, generate_coordinates<point<T, N>>([&](int i) { return clamped(p[i], b.low[i], b.high[i]); }));
}

IRG_REFUSES_VECTORS(distance);
IRG_REFUSES_VECTORS(distance_of_lines);
IRG_REFUSES_VECTORS(distance_of_segments);
IRG_REFUSES_VECTORS(distance_to_line);
IRG_REFUSES_VECTORS(distance_to_segment);
IRG_REFUSES_VECTORS(distance_to_triangle);
IRG_REFUSES_VECTORS(signed_distance);

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// height / sqrt(squared), with the sign of the height.
template <Floating T>
constexpr T height_over_root(const scaled_double_double& height, const scaled_double_double& squared) noexcept {
  return rounded_to<T>(height / sqrt(squared));
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API std::optional<T> distance_of_points(const point<T, N>& p, const point<T, N>& q) noexcept {
  const auto squared = squared_distance(p, q);
  if (!squared) return std::nullopt;
  return rounded_to<T>(sqrt(*squared));
}

template <Floating T, int N>
IRG_API std::optional<T> distance_from_line(const point<T, N>& a, const point<T, N>& b, const point<T, N>& p) noexcept {
  const auto v = squared_from_line(a, b, p);
  if (!v || same_place(a, b)) return std::nullopt;
  return rounded_to<T>(sqrt((*v)[0] / (*v)[1]));
}

template <Floating T>
IRG_API std::optional<T> height_over_line(const line<T>& l, const point<T, 2>& p) noexcept {
  const auto v = values_of<2>(
      [](const auto& k, const auto& at) { return std::array{k.x * at.x + k.y * at.y + k.z, k.x * k.x + k.y * k.y}; },
      vec{l.a, l.b, l.c}, p);
  if (!v || is_zero((*v)[1])) return std::nullopt;
  return height_over_root<T>((*v)[0], (*v)[1]);
}

template <Floating T>
IRG_API std::optional<T> height_over_plane(const plane<T>& l, const point<T, 3>& p) noexcept {
  const auto v = values_of<2>(
      [](const auto& of, const auto& at) {
        const auto n = normal_of(of);
        return std::array{dot(n, to_vec(at)) + of.d, dot(n, n)};
      },
      l, p);
  if (!v || is_zero((*v)[1])) return std::nullopt;
  return height_over_root<T>((*v)[0], (*v)[1]);
}

template <Floating T, int N>
IRG_API std::optional<T> distance_from_segment(const point<T, N>& a, const point<T, N>& b,
                                               const point<T, N>& p) noexcept {
  if (!is_finite(a, b, p)) return std::nullopt;
  return rounded_to<T>(sqrt(squared_from_segment(a, b, p)));
}

template <Floating T>
IRG_API std::optional<T> distance_from_triangle(const point<T, 3>& a, const point<T, 3>& b, const point<T, 3>& c,
                                                const point<T, 3>& p) noexcept {
  const auto foot = foot_on_triangle(a, b, c, p);
  if (!foot) return std::nullopt;
  switch (foot->region) {
    case 1: return distance_of_points(a, p);
    case 2: return distance_of_points(b, p);
    case 3: return distance_of_points(c, p);
    case 4: return distance_from_line(a, b, p);
    case 5: return distance_from_line(b, c, p);
    case 6: return distance_from_line(a, c, p);
    default: break;
  }
  const auto v = *values_of<4>(
      [](const auto& from, const auto& second, const auto& third, const auto& at) {
        const auto n = cross(second - from, third - from);
        return std::array{dot(n, at - from), dot(n, n)};
      },
      a, b, c, p);
  return magnitude(height_over_root<T>(v[0], v[1]));
}

template <Floating T>
IRG_API std::optional<T> distance_between_lines(const point<T, 3>& a, const point<T, 3>& b, const point<T, 3>& c,
                                                const point<T, 3>& d) noexcept {
  if (same_place(a, b) || same_place(c, d)) return std::nullopt;
  const auto lines = nearest_on_lines(a, b, c, d);
  if (!lines) return std::nullopt;
  const auto& v = *lines;
  if (sign_of(v[0]) == 0) return distance_from_line(a, b, c);
  return magnitude(height_over_root<T>(v[1], v[0]));
}

template <Floating T, int N>
IRG_API std::optional<T> distance_between_segments(const point<T, N>& a, const point<T, N>& b, const point<T, N>& c,
                                                   const point<T, N>& d) noexcept {
  if (!is_finite(a, b, c, d)) return std::nullopt;
  if (intersect_segments(a, b, c, d).relation != segment_relation::none) return T(0);
  if constexpr (N == 3) {
    const auto v = *nearest_on_lines(a, b, c, d);
    const auto sign = [&](std::size_t i) { return sign_of(v[i]); };
    if (sign(0) > 0 && sign(2) >= 0 && sign(3) >= 0 && sign(4) >= 0 && sign(5) >= 0)
      return magnitude(height_over_root<T>(v[1], v[0]));
  }
  switch (nearest_end(a, b, c, d)) {
    case 0: return distance_from_segment(c, d, a);
    case 1: return distance_from_segment(c, d, b);
    case 2: return distance_from_segment(a, b, c);
    default: return distance_from_segment(a, b, d);
  }
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
