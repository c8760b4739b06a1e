// SPDX-License-Identifier: MIT
// Barycentric coordinates: the weights t1, t2, t3 of the corners A, B, C of a triangle whose weighted sum is a point T.
// In the plane and in space they exist for every triangle with an area; in space T is seen along a coordinate axis, or
// at right angles to the plane. The lecture's own methods, the inverse of the matrix [A B C] and the replacement of one
// of its rows, stand in textbook/barycentric.hpp.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/geometry/detail/twice_area.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// Which part of a triangle a point lies on, its outline included.
enum class triangle_part { outside, inside, edge, vertex };

/// Where a point of space lies against a triangle: whether in its plane, and which part it projects to.
struct triangle_location {
  bool in_plane = false;
  triangle_part where = triangle_part::outside;
  friend constexpr bool operator==(const triangle_location&, const triangle_location&) = default;
};

namespace detail::inline IRG_ABI {

/// The other two axes in cyclic order, so that areas seen along `axis` keep their sign.
struct plane_axes {
  int u, v;
};
IRG_INLINE constexpr plane_axes axes_across(int axis) noexcept {
  return axis == 0 ? plane_axes{1, 2} : axis == 1 ? plane_axes{2, 0} : plane_axes{0, 1};
}

template <Point P>
IRG_INLINE constexpr plane_corners corners_in(plane_axes k, const P& a, const P& b, const P& c) noexcept {
  const auto at = [](const P& p, int i) { return widened(coordinate(p, i)); };
  return {at(a, k.u), at(a, k.v), at(b, k.u), at(b, k.v), at(c, k.u), at(c, k.v)};
}

// A point of space, seen along an axis.
template <Point P>
IRG_INLINE constexpr point<scalar_of<P>, 2> seen_in(plane_axes k, const P& p) noexcept {
  return {coordinate(p, k.u), coordinate(p, k.v)};
}

template <Point P>
IRG_INLINE constexpr scalar_of<P> twice_area_plain(plane_axes k, const P& a, const P& b, const P& c) noexcept {
  const auto across = [&](const P& p, const P& q) {
    return product(coordinate(p, k.u) - coordinate(a, k.u), coordinate(q, k.v) - coordinate(a, k.v));
  };
  return across(b, c) - across(c, b);
}

template <Point P>
constexpr std::optional<vec<scalar_of<P>, 3>> barycentric_in(plane_axes k, const P& a, const P& b, const P& c,
                                                             const P& p) noexcept {
  using T = scalar_of<P>;
  if constexpr (Floating<T>) {
    const plane_corners whole = corners_in(k, a, b, c), t1 = corners_in(k, p, b, c), t2 = corners_in(k, a, p, c),
                        t3 = corners_in(k, a, b, p);
    if (is_moderate(whole) && is_moderate(t1)) {
      const exact_sum<double> area = twice_area_of_moderate(whole);
      if (area.value == 0) return std::nullopt;
      const auto weight = [&](const plane_corners& t) { return converted<T>(ratio(twice_area_of_moderate(t), area)); };
      return vec<T, 3>{weight(t1), weight(t2), weight(t3)};
    }
    const exact_accumulator<2> area = exact_twice_area(whole);
    if (area.sign() == 0) return std::nullopt;
    const auto weight = [&](const plane_corners& t) { return converted<T>(ratio(exact_twice_area(t), area)); };
    return vec<T, 3>{weight(t1), weight(t2), weight(t3)};
  } else {
    const T area = twice_area_plain(k, a, b, c);
    if (area == T(0)) return std::nullopt;
    return vec<T, 3>{twice_area_plain(k, p, b, c) / area, twice_area_plain(k, a, p, c) / area,
                     twice_area_plain(k, a, b, p) / area};
  }
}

// The view whose area exceeds the others by more than the errors of their computation; -1 when there is none.
constexpr int clearly_widest(const plane_corners (&seen)[3]) noexcept {
  if (!is_moderate(seen[0]) || !is_moderate(seen[1])) return -1;  // together they have all coordinates
  const double size[] = {magnitude(twice_area_of_moderate(seen[0]).value),
                         magnitude(twice_area_of_moderate(seen[1]).value),
                         magnitude(twice_area_of_moderate(seen[2]).value)};
  const int best = size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : size[1] >= size[2] ? 1 : 2;
  const double bound = size[best] * (1 - 0x1p-50);
  return size[(best + 1) % 3] < bound && size[(best + 2) % 3] < bound ? best : -1;
}

// (to - from) * scale without overflow on the way, floats in double.
template <Point P, class S>
IRG_INLINE constexpr vec<S, 3> scaled_way(const P& from, const P& to, const S& scale) noexcept {
  return generate_coordinates<vec<S, 3>>([&](int i) {
    if constexpr (Floating<scalar_of<P>>)
      return (widened(coordinate(to, i)) * 0.25 - widened(coordinate(from, i)) * 0.25) * scale;
    else
      return (coordinate(to, i) - coordinate(from, i)) * scale;
  });
}

// What scaled_way multiplies by so that the longest side comes out as 1 to 4 long, or so.
template <Point P>
constexpr auto scale_of_sides(const P& a, const P& b, const P& c) noexcept {
  if constexpr (Floating<scalar_of<P>>) {
    double largest = 0;
    for (const vec<double, 3>& side : {scaled_way(a, b, 1.0), scaled_way(a, c, 1.0)})
      for (int i = 0; i < 3; ++i) largest = maximum(largest, magnitude(side[i]));
    return normalizing_power_of_two(largest);
  } else {
    return scalar_of<P>(1);
  }
}

// Whether no coordinate of v * scale is beyond 2^900, found without overflow.
IRG_INLINE constexpr bool stays_moderate(const vec<double, 3>& v, double scale) noexcept {
  const double largest = maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
  return scale > 1 ? largest < 0x1p900 / scale : largest * scale < 0x1p900;
}

// The sign of |x| - |y| for the areas of a triangle seen along two axes.
constexpr int compare_areas(const plane_corners& x, const plane_corners& y) noexcept {
  exact_accumulator<2> p = exact_twice_area(x);
  const exact_accumulator<2> q = exact_twice_area(y);
  const int sign_p = p.sign(), sign_q = q.sign();
  // |x| - |y| = +-(x -+ y)
  const auto mix = [&](const plane_corners& t, bool minus) {
    const double s = minus ? -1.0 : 1.0;
    p.add(s * t.ax, t.by), p.subtract(s * t.ay, t.bx);
    p.add(s * t.bx, t.cy), p.subtract(s * t.by, t.cx);
    p.add(s * t.cx, t.ay), p.subtract(s * t.cy, t.ax);
  };
  if (sign_p == 0 || sign_q == 0) return (sign_p != 0 ? 1 : 0) - (sign_q != 0 ? 1 : 0);
  mix(y, sign_p == sign_q);
  return p.sign() * sign_p;
}

template <Point P>
constexpr triangle_part part_in(plane_axes k, const P& a, const P& b, const P& c, const P& p) noexcept {
  const auto va = seen_in(k, a), vb = seen_in(k, b), vc = seen_in(k, c), vp = seen_in(k, p);
  const int turn = orient2d(va, vb, vc);
  const int s1 = turn * orient2d(vb, vc, vp), s2 = turn * orient2d(vc, va, vp), s3 = turn * orient2d(va, vb, vp);
  if (turn == 0 || s1 < 0 || s2 < 0 || s3 < 0) return triangle_part::outside;
  const int zeros = (s1 == 0 ? 1 : 0) + (s2 == 0 ? 1 : 0) + (s3 == 0 ? 1 : 0);
  return zeros == 0 ? triangle_part::inside : zeros == 1 ? triangle_part::edge : triangle_part::vertex;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The axis (0, 1, 2 for x, y, z) along which a triangle in space shows the largest area: that of the largest component
/// of its normal; the lowest such axis when several are equal. Without this coordinate it is a triangle in the plane.
/// needs   finite coordinates
/// gives   nothing for a triangle without area
/// exact   decided exactly for every float and double
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<int> dropped_axis(const P& a, const P& b, const P& c) noexcept {
  int best = 0;
  if constexpr (Floating<scalar_of<P>>) {
    const detail::plane_corners seen[] = {detail::corners_in(detail::axes_across(0), a, b, c),
                                          detail::corners_in(detail::axes_across(1), a, b, c),
                                          detail::corners_in(detail::axes_across(2), a, b, c)};
    const int clear = detail::clearly_widest(seen);
    if (clear >= 0) return clear;
    for (int axis = 1; axis < 3; ++axis)
      if (detail::compare_areas(seen[axis], seen[best]) > 0) best = axis;
    if (detail::exact_twice_area(seen[best]).sign() == 0) return std::nullopt;
  } else {
    using T = scalar_of<P>;
    const auto size = [&](int axis) {
      const T area = detail::twice_area_plain(detail::axes_across(axis), a, b, c);
      return area < T(0) ? -area : area;
    };
    for (int axis = 1; axis < 3; ++axis)
      if (size(best) < size(axis)) best = axis;
    if (size(best) == T(0)) return std::nullopt;
  }
  return best;
}

/// The barycentric coordinates of T in the triangle A, B, C: A*t1 + B*t2 + C*t3 = T and t1 + t2 + t3 = 1.
/// shape   points of the plane, or of space; there T is first moved along dropped_axis into the plane of the triangle,
///         so that the result means something for every T
/// needs   finite coordinates
/// gives   nothing for a triangle without area
/// exact   in rationals. Each coordinate within 0.51 ulp of the exact one (float 0.501; subnormal and beyond 2^960
///         within 2), 0 where it is 0, with its right sign elsewhere. For T in the triangle all lie in [0, 1], and
///         their sum is within 2^-52 of 1 (float 2^-23)
/// cost    in the plane about 40 ns; nearly collinear or immoderate points take exact sums, about a microsecond
/// source  Moebius 1827, the areas of part triangles
template <Point P>
  requires((size_of<P> == 2 || size_of<P> == 3) && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<vec<scalar_of<P>, 3>> barycentric(const P& a, const P& b, const P& c,
                                                                        const P& t) noexcept {
  if constexpr (size_of<P> == 2) {
    return detail::barycentric_in({0, 1}, a, b, c, t);
  } else {
    const std::optional<int> axis = dropped_axis(a, b, c);
    if (!axis) return std::nullopt;
    return detail::barycentric_in(detail::axes_across(*axis), a, b, c, t);
  }
}

/// The barycentric coordinates of T in the triangle A, B, C by the plain formula, for inner loops.
/// needs   coordinates whose differences' products neither over- nor underflow: sizes from 2^-250 to 2^250 (float:
///         2^-30 to 2^30)
/// gives   infinities or NaN for a triangle without area
/// exact   errors of some u times the condition: u * (sum of the products' sizes) / (twice the area), u = 2^-53 (float
///         2^-24)
/// cost    about 20 operations and one division
template <Point P>
  requires(size_of<P> == 2 && Floating<scalar_of<P>>)
[[nodiscard]] IRG_INLINE constexpr vec<scalar_of<P>, 3> barycentric_fast(const P& a, const P& b, const P& c,
                                                                         const P& t) noexcept {
  using T = scalar_of<P>;
  const T scale = T(1) / detail::twice_area_plain({0, 1}, a, b, c);
  const T t2 = product(detail::twice_area_plain({0, 1}, a, t, c), scale);
  const T t3 = product(detail::twice_area_plain({0, 1}, a, b, t), scale);
  return {T(1) - t2 - t3, t2, t3};
}

/// The barycentric coordinates of the point of the triangle's plane that is nearest to T.
/// needs   finite coordinates
/// gives   nothing for a triangle without area, decided exactly; in floats also for one that is 10^150 times as long as
///         wide, and for T so far away that the coordinates overflow
/// exact   in rationals; in floats some u times the square of the triangle's longest side over its area
/// cost    about 70 operations and dropped_axis
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<vec<scalar_of<P>, 3>> barycentric_orthogonal(const P& a, const P& b, const P& c,
                                                                                   const P& t) noexcept {
  using T = scalar_of<P>;
  if (!dropped_axis(a, b, c)) return std::nullopt;
  const auto scale = detail::scale_of_sides(a, b, c);
  const auto way = [&](const P& from, const P& to) { return detail::scaled_way(from, to, scale); };
  if constexpr (Floating<T>)
    if (!detail::stays_moderate(detail::scaled_way(a, t, 1.0), scale)) return std::nullopt;
  const auto n = cross(way(a, b), way(a, c));
  const auto square = dot(n, n);
  if (square == std::remove_cvref_t<decltype(square)>(0)) return std::nullopt;
  const auto weight = [&](const P& p, const P& q) { return dot(n, cross(way(p, q), way(p, t))) / square; };
  return vec<T, 3>{converted<T>(weight(b, c)), converted<T>(weight(c, a)), converted<T>(weight(a, b))};
}

/// Which part of a triangle of the plane a point lies on: inside, on an edge, at a vertex, or outside.
/// needs   finite coordinates
/// gives   outside for every point when the triangle has no area
/// exact   for every finite float and double, and for integers
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr triangle_part locate_in_triangle(const P& a, const P& b, const P& c, const P& t) noexcept {
  return detail::part_in({0, 1}, a, b, c, t);
}

/// Where a point lies against a triangle in space: whether in its plane, and which part of it T is on once it is moved
/// along dropped_axis into that plane.
/// needs   finite coordinates
/// gives   nothing for a triangle without area
/// exact   for every finite float and double
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<triangle_location> locate_in_triangle(const P& a, const P& b, const P& c,
                                                                            const P& t) noexcept {
  const std::optional<int> axis = dropped_axis(a, b, c);
  if (!axis) return std::nullopt;
  return triangle_location{orient3d(a, b, c, t) == 0, detail::part_in(detail::axes_across(*axis), a, b, c, t)};
}

/// x1*t1 + x2*t2 + x3*t3: a value that is x1, x2 and x3 at the corners, at the point of barycentric coordinates t.
/// exact   three products and two sums, each rounded; for t in the triangle never outside of the range of the three
///         values, and exactly x where all three are x
template <Real T>
[[nodiscard]] IRG_INLINE constexpr T interpolate(const vec<T, 3>& t, const std::type_identity_t<T>& x1,
                                                 const std::type_identity_t<T>& x2,
                                                 const std::type_identity_t<T>& x3) noexcept {
  const T value = product(x1, t.x) + product(x2, t.y) + product(x3, t.z);
  if (t.x < T(0) || t.y < T(0) || t.z < T(0)) return value;
  return clamped(value, minimum(minimum(x1, x2), x3), maximum(maximum(x1, x2), x3));
}

IRG_REFUSES_VECTORS(barycentric);
IRG_REFUSES_VECTORS(barycentric_fast);
IRG_REFUSES_VECTORS(barycentric_orthogonal);
IRG_REFUSES_VECTORS(locate_in_triangle);
IRG_REFUSES_VECTORS(dropped_axis);

IRG_RENAMED(widest_view, dropped_axis)

}  // namespace IRG_ABI
}  // namespace irg
