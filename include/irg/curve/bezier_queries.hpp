// SPDX-License-Identifier: MIT
// Questions to a Bezier curve of any degree that end in zeros of a polynomial: its box, where it crosses a line, and
// its point nearest to another point. Each polynomial comes with what rounding may have done to its coefficients, so
// that no extremum and no crossing is missed.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_zeros.hpp>
#include <irg/geometry/box.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/length.hpp>

namespace irg {

/// A place on a curve: its parameter, the point there, and how far the curve is there from what was asked about.
template <CurvePoint P>
struct nearest_place {
  scalar_of<P> t = 0;
  P point{};
  scalar_of<P> distance = 0;
  bool operator==(const nearest_place&) const = default;
};

namespace detail::inline IRG_ABI {

template <Floating T>
constexpr T half_ulp_of_one = std::numeric_limits<T>::epsilon() / 2;

// How many rows of as many numbers as there are control points each query works in.
inline constexpr std::size_t box_rows = 8, line_rows = 4, nearest_rows = 8;

// Least and greatest coefficient of the polynomial between two places, widened by what rounding may hide.
template <Floating T>
constexpr vec<T, 2> hull_of_stretch(std::span<const vec<T, 1>> c, T from, T to, std::span<vec<T, 1>> scratch) noexcept {
  const std::size_t n = c.size();
  const auto left = scratch.first(n), work = scratch.subspan(n, n), piece = scratch.subspan(2 * n, n);
  bezier_split(c, curve_parameter<T>(to), left, work);
  bezier_split(left, curve_parameter<T>(to > T(0) ? from / to : T(0)), work, piece);
  T low = piece[0][0], high = low, largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    low = minimum(low, piece[i][0]), high = maximum(high, piece[i][0]);
    largest = maximum(largest, magnitude(c[i][0]));
  }
  const T off = product(static_cast<T>(static_cast<int>(8 * n)),
                        product(largest, half_ulp_of_one<T>) + std::numeric_limits<T>::denorm_min());
  return {low - off, high + off};
}

// Half the difference of two coordinates, which does not overflow.
template <Floating T>
IRG_INLINE constexpr T half_difference(T a, T b) noexcept {
  return product(a, T(0.5)) - product(b, T(0.5));
}

// Bernstein coefficients of (curve - p) . derivative, of degree 2n - 1, the vectors scaled so that none is beyond 1;
// how far each may be off.
template <ControlPoints R, class T>
constexpr T foot_coefficients(const R& points, const control_point<R>& p, std::span<vec<T, 1>> result) noexcept {
  const std::size_t n = ring_traits<R>::size(points) - 1;
  constexpr int dimension = size_of<control_point<R>>;
  const auto offset = [&](std::size_t i, int axis) {
    return half_difference(coordinate(ring_traits<R>::vertex(points, i), axis), coordinate(p, axis));
  };
  T largest = 0;
  for (std::size_t i = 0; i <= n; ++i)
    for (int axis = 0; axis < dimension; ++axis) largest = maximum(largest, magnitude(offset(i, axis)));
  if (largest == T(0)) largest = T(1);  // the curve is p all along
  for (std::size_t k = 0; k < 2 * n; ++k) {
    T sum = 0, weights = 0, weight = 1;  // C(n, i) C(n - 1, k - i), up to a factor
    for (std::size_t i = k < n ? 0 : k + 1 - n; i <= n && i <= k; ++i) {
      T term = 0;
      for (int axis = 0; axis < dimension; ++axis) {
        const T here = offset(i, axis) / largest;
        const T step = offset(k - i + 1, axis) / largest - offset(k - i, axis) / largest;
        term = term + product(here, step);
      }
      sum = sum + product(weight, term);
      weights = weights + weight;
      weight = product(weight, static_cast<T>(static_cast<int>((n - i) * (k - i)))) /
               static_cast<T>(static_cast<int>((i + 1) * (n + i - k)));
    }
    result[k] = vec<T, 1>{sum / weights};
  }
  return product(static_cast<T>(static_cast<int>(32 * n) * dimension),
                 half_ulp_of_one<T> + std::numeric_limits<T>::denorm_min() / largest);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The box of the curve between t = 0 and 1: by its extrema, not by its control points.
/// needs   one or more finite control points; scratch eight times as long
/// gives   a box that holds the whole curve and no more than that of the control points; an axis along which the curve
///         only rises or falls gets the end points' own coordinates. Control points that are not finite: the box of all
///         numbers
/// exact   no side is farther out than some 20 * degree * u of the largest coordinate
/// cost    bernstein_roots of degree - 1 for each axis, two bezier_split for each extremum
/// source  Farin 2002, 5.3
template <ControlPoints R>
  requires Floating<scalar_of<control_point<R>>>
constexpr box<scalar_of<control_point<R>>, size_of<control_point<R>>> bezier_box(
    const R& points, std::span<vec<scalar_of<control_point<R>>, 1>> scratch) noexcept {
  using T = scalar_of<control_point<R>>;
  constexpr int dimension = size_of<control_point<R>>;
  const std::size_t count = ring_traits<R>::size(points);
  IRG_EXPECTS(count > 0 && scratch.size() >= detail::box_rows * count);
  const auto c = scratch.first(count), slopes = scratch.subspan(count, count - 1);
  const auto work = scratch.subspan(2 * count, 3 * count);
  std::array<T, static_cast<std::size_t>(dimension)> low{}, high{};
  for (int axis = 0; axis < dimension; ++axis) {
    T largest = 0, least = coordinate(ring_traits<R>::vertex(points, 0), axis), greatest = least;
    for (std::size_t i = 0; i < count; ++i) {
      c[i] = {coordinate(ring_traits<R>::vertex(points, i), axis)};
      largest = maximum(largest, magnitude(c[i][0]));
      least = minimum(least, c[i][0]), greatest = maximum(greatest, c[i][0]);
      if (!is_finite(c[i][0])) largest = std::numeric_limits<T>::infinity();
    }
    auto& from = low[static_cast<std::size_t>(axis)];
    auto& to = high[static_cast<std::size_t>(axis)];
    from = minimum(c[0][0], c[count - 1][0]), to = maximum(c[0][0], c[count - 1][0]);
    if (!is_finite(largest)) from = (std::numeric_limits<T>::lowest)(), to = (std::numeric_limits<T>::max)();
    if (count < 3 || !is_finite(largest)) continue;
    for (std::size_t i = 0; i + 1 < count; ++i) slopes[i] = {detail::half_difference(c[i + 1][0], c[i][0])};
    const T off = product(largest, std::numeric_limits<T>::epsilon()) + std::numeric_limits<T>::denorm_min() * 4;
    bernstein_roots(std::span<const vec<T, 1>>(slopes), off, work, [&](const root_interval<T>& z) {
      const auto hull = detail::hull_of_stretch(std::span<const vec<T, 1>>(c), z.from, z.to, scratch.last(3 * count));
      from = minimum(from, maximum(hull.x, least)), to = maximum(to, minimum(hull.y, greatest));
    });
  }
  return {generate_coordinates<point<T, dimension>>([&](int i) { return low[static_cast<std::size_t>(i)]; }),
          generate_coordinates<point<T, dimension>>([&](int i) { return high[static_cast<std::size_t>(i)]; })};
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, WorkspaceFor<R> W = workspace_for<R>>
  requires Floating<scalar_of<control_point<R>>>
[[nodiscard]] constexpr box<scalar_of<control_point<R>>, size_of<control_point<R>>> bezier_box(const R& points,
                                                                                               W&& memory = W{}) {
  return bezier_box(points, detail::room_for(memory.coefficients, points, detail::box_rows));
}

/// Hands sink(root_interval) the stretches of the parameter in which the curve may meet the line through a and b.
/// needs   one or more control points in the plane; scratch of four times as many numbers
/// gives   false, and no stretches, where a and b are the same or not finite. A sign is 1 where the curve is left of
///         the line; a curve along the line is one stretch
/// exact   as bernstein_roots: no crossing is missed, whatever the sizes
/// cost    as bernstein_roots
/// source  Lane and Riesenfeld 1981
template <ControlPoints R, class Sink>
  requires(Floating<scalar_of<control_point<R>>> && size_of<control_point<R>> == 2)
constexpr bool bezier_line_intersections(const R& points, const control_point<R>& a, const control_point<R>& b,
                                         std::span<vec<scalar_of<control_point<R>>, 1>> scratch, Sink&& sink) {
  using T = scalar_of<control_point<R>>;
  const std::size_t count = ring_traits<R>::size(points);
  IRG_EXPECTS(count > 0 && scratch.size() >= detail::line_rows * count);
  bool is_sound = true, is_large = false;
  for (int i = 0; i < 2; ++i)
    for (const T& x : {coordinate(a, i), coordinate(b, i)}) {
      is_sound = is_sound && is_finite(x);
      is_large = is_large || magnitude(x) > T(1);
    }
  if (!is_sound) return false;
  const auto along = try_normalized(generate_coordinates<vec<T, 2>>([&](int i) {
    const T from = coordinate(a, i), to = coordinate(b, i);
    return is_large ? detail::half_difference(to, from) : to - from;
  }));
  if (!along) return false;
  T largest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto p = ring_traits<R>::vertex(points, k);
    // A quarter of the offset and its products with a unit vector cannot overflow.
    const T x = product(detail::half_difference(coordinate(p, 0), coordinate(a, 0)), T(0.5));
    const T y = product(detail::half_difference(coordinate(p, 1), coordinate(a, 1)), T(0.5));
    scratch[k] = {difference_of_products(along->x, y, along->y, x)};
    largest = maximum(largest, magnitude(x) + magnitude(y));
  }
  const T off = product(largest, 8 * std::numeric_limits<T>::epsilon()) + std::numeric_limits<T>::denorm_min() * 8;
  bernstein_roots(std::span<const vec<T, 1>>(scratch.first(count)), off, scratch.subspan(count, 3 * count), sink);
  return true;
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, class Sink, WorkspaceFor<R> W = workspace_for<R>>
  requires(Floating<scalar_of<control_point<R>>> && size_of<control_point<R>> == 2)
constexpr bool bezier_line_intersections(const R& points, const control_point<R>& a, const control_point<R>& b,
                                         Sink&& sink, W&& memory = W{}) {
  const auto scratch = detail::room_for(memory.coefficients, points, detail::line_rows);
  return bezier_line_intersections(points, a, b, scratch, sink);
}

/// The place on the curve, 0 <= t <= 1, that is nearest to p.
/// needs   one or more finite control points, degree 60 at most; scratch of eight times as many numbers, work for as
///         many points
/// gives   of places that are equally near the one with the least t, up to rounding
/// exact   all places are compared at which the line to p may be at right angles to the curve, and both ends: the
///         square of the distance is the least up to 200 * degree * u of the square of the largest offset of a control
///         point, unless that offset is subnormal, wherever curve and p are. That is some u of the size, but half the
///         digits where the curve nearly stands still beside p. The point is rounded where it is, as bezier_point
/// cost    bernstein_roots of degree 2 * degree - 1, and degree^2 products for its coefficients
/// source  Schneider 1990
template <ControlPoints R>
  requires CartesianPoint<control_point<R>> && Floating<scalar_of<control_point<R>>>
constexpr nearest_place<control_point<R>> bezier_nearest(const R& points, const control_point<R>& p,
                                                         std::span<vec<scalar_of<control_point<R>>, 1>> scratch,
                                                         std::span<control_point<R>> work) noexcept {
  using P = control_point<R>;
  using T = scalar_of<P>;
  const std::size_t count = ring_traits<R>::size(points), degree = count - 1;
  IRG_EXPECTS(count > 0 && count <= 61 && scratch.size() >= detail::nearest_rows * count && work.size() >= count);
  // Places are compared by the curve of offsets from p: far from the origin the curve's own points have fewer digits
  // than their distances. Offsets that may overflow are taken to a quarter.
  T largest = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (int axis = 0; axis < size_of<P>; ++axis)
      largest = maximum(largest, magnitude(detail::half_difference(coordinate(ring_traits<R>::vertex(points, i), axis),
                                                                   coordinate(p, axis))));
  const bool is_large = largest > (std::numeric_limits<T>::max)() / 8;
  const auto distance = [&](T t) {
    for (std::size_t i = 0; i < count; ++i)
      work[i] = generate_coordinates<P>([&](int axis) {
        const T here = coordinate(ring_traits<R>::vertex(points, i), axis), from = coordinate(p, axis);
        return is_large ? product(detail::half_difference(here, from), T(0.5)) : here - from;
      });
    detail::reduce(work.first(count), 1, curve_parameter<T>(t));
    return length(
        generate_coordinates<typename curve_sample<P>::vector>([&](int axis) { return coordinate(work[0], axis); }));
  };
  T best = 0, least = distance(best);
  const auto compare = [&](T t) {
    const T there = distance(t);
    if (there < least) best = t, least = there;
  };
  if (degree > 0) {
    const auto c = scratch.first(2 * degree);
    const T off = detail::foot_coefficients<R, T>(points, p, c);
    bernstein_roots(std::span<const vec<T, 1>>(c), off, scratch.subspan(2 * degree, 6 * degree),
                    [&](const root_interval<T>& z) {
                      compare(z.from);
                      compare(z.middle());
                      compare(z.to);
                    });
    compare(T(1));
  }
  return {best, bezier_point(points, curve_parameter<T>(best), work), is_large ? 4 * least : least};
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, WorkspaceFor<R> W = workspace_for<R>>
  requires CartesianPoint<control_point<R>> && Floating<scalar_of<control_point<R>>>
[[nodiscard]] constexpr nearest_place<control_point<R>> bezier_nearest(const R& points, const control_point<R>& p,
                                                                       W&& memory = W{}) {
  const auto scratch = detail::room_for(memory.coefficients, points, detail::nearest_rows);
  return bezier_nearest(points, p, scratch, detail::room_for(memory.points, points));
}

IRG_RENAMED(bezier_line_crossings, bezier_line_intersections)

}  // namespace IRG_ABI
}  // namespace irg
