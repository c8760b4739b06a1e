// SPDX-License-Identifier: MIT
// line<T>: a*x + b*y + c = 0 in the plane, made from points, and the point that two lines have in common.
#pragma once

#include <optional>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/side_of_line.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// The points with a*x + b*y + c = 0, in homogeneous coordinates a*x + b*y + c*w = 0. The value is positive on the left
/// of the direction (b, -a).
template <Scalar T>
struct line {
  T a{}, b{}, c{};
  bool operator==(const line&) const = default;
};

namespace detail::inline IRG_ABI {

template <class T, class V>
constexpr std::optional<line<T>> rounded_line(const std::optional<vec<V, 3>>& v) noexcept {
  if (!v || is_zero(*v)) return std::nullopt;
  using N = std::conditional_t<std::is_integral_v<V>, T, V>;  // a difference of shorts is an int
  const auto c =
      rounded_together<T, 3>(std::array<N, 3>{static_cast<N>(v->x), static_cast<N>(v->y), static_cast<N>(v->z)});
  return line<T>{c[0], c[1], c[2]};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The line through p and q: a = y1 - y2, b = x2 - x1, c = x1*y2 - x2*y1; its left side is that of the way from p to q.
/// gives   nothing when the points are equal, or a coordinate is NaN or infinite
/// exact   in integers (without overflow) and rationals; in floats each coefficient within 0.501 ulp; all are
///         multiplied by one power of two where they are beyond the range
/// cost    some 100 ns; edge_through (edge_equation.hpp) is the plain formula
/// source  Mihajlovic 2016, formula 2.6, expanded
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr std::optional<line<scalar_of<P>>> line_through(const P& p, const P& q) noexcept {
  using T = scalar_of<P>;
  if (same_place(p, q)) return std::nullopt;
  return detail::rounded_line<T>(values_of<2>(
      [](const auto& a, const auto& b) { return vec{a.y - b.y, b.x - a.x, a.x * b.y - b.x * a.y}; }, p, q));
}

/// The line through two homogeneous points, their cross product. For two directions it is the line at infinity, (0, 0,
/// c); a negative weight turns the sides round.
/// gives   nothing when the points are the same (proportional), and when a coordinate is NaN or infinite
/// exact   as for points
/// source  Mihajlovic 2016, formula 2.5
template <HomogeneousPoint P>
  requires(size_of<P> == 3 && !Point<P>)
[[nodiscard]] constexpr std::optional<line<scalar_of<P>>> line_through(const P& p, const P& q) noexcept {
  using T = scalar_of<P>;
  const auto own = [](const P& x) { return vec<T, 3>{coordinate(x, 0), coordinate(x, 1), coordinate(x, 2)}; };
  return detail::rounded_line<T>(
      values_of<2>([](const auto& a, const auto& b) { return cross(a, b); }, own(p), own(q)));
}

/// The point that two lines have in common, their cross product: of weight 0, a direction, for parallel lines.
/// gives   nothing when the lines are the same (proportional), or a coefficient is NaN or infinite
/// exact   in integers (without overflow) and rationals; in floats each coordinate within 0.501 ulp; all are multiplied
///         by one power of two where they are beyond the range. The weight is zero
///         for exactly parallel lines only
/// source  Mihajlovic 2016, the dual of formula 2.5; parallel lines have a common point at infinity
template <Scalar T>
[[nodiscard]] constexpr std::optional<hpoint<T, 2>> intersection_point(const line<T>& first,
                                                                       const line<T>& second) noexcept {
  const auto own = [](const line<T>& l) { return vec<T, 3>{l.a, l.b, l.c}; };
  const auto p = detail::rounded_line<T>(
      values_of<2>([](const auto& a, const auto& b) { return cross(a, b); }, own(first), own(second)));
  return p ? std::optional(hpoint<T, 2>{p->a, p->b, p->c}) : std::nullopt;
}

/// a*x + b*y + c: the distance of p from the line times the length of (a, b), positive on the left.
/// exact   in integers and rationals; in floats, where nothing over- or underflows, off by at most 3u times the sum of
///         the absolute values of the terms. side_of_line and orient2d decide sides exactly
/// source  Mihajlovic 2016, 2.3
template <Scalar T, Point P>
  requires(size_of<P> == 2 && std::same_as<scalar_of<P>, T>)
[[nodiscard]] constexpr T line_value(const line<T>& l, const P& p) noexcept {
  return product(l.a, coordinate(p, 0)) + product(l.b, coordinate(p, 1)) + l.c;
}

/// a*x + b*y + c*w, the value at x/w, y/w times the weight w.
/// exact   as for a point
template <Scalar T>
[[nodiscard]] constexpr T line_value(const line<T>& l, const hpoint<T, 2>& p) noexcept {
  return product(l.a, p.x) + product(l.b, p.y) + product(l.c, p.z);
}

/// Whether p lies above or below the line, y up. The sign of the line's value tells left from right of its direction
/// alone: above is left only for lines that run to greater x.
/// needs   finite numbers
/// gives   nothing for a vertical line, which has no upper side; `on` when a number of another one is NaN or infinite
/// exact   for every finite float, double and integer
/// source  Mihajlovic 2016, 2.3, whose sign means above for x2 > x1 only
template <Scalar T, Point P>
  requires(size_of<P> == 2 && std::same_as<scalar_of<P>, T>)
[[nodiscard]] constexpr std::optional<side> vertical_side_of(const line<T>& l, const P& p) noexcept {
  if (l.b == T(0)) return std::nullopt;
  const side normal_side = side_of_line(l, p);
  return l.b < T(0) ? opposite(normal_side) : normal_side;
}

IRG_REFUSES_VECTORS(line_through);
IRG_REFUSES_VECTORS(line_value);
IRG_REFUSES_VECTORS(vertical_side_of);

IRG_RENAMED(height_of, vertical_side_of)
IRG_RENAMED(common_point, intersection_point)

}  // namespace IRG_ABI
}  // namespace irg
