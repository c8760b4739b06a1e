// SPDX-License-Identifier: MIT
// The smallest circle or sphere around points: which points it rests on is decided exactly.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/geometry/sphere.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/vec.hpp>

namespace irg::inline IRG_ABI {

/// The smallest circle or sphere around the points of a range or ring.
/// gives   nothing for no points, and when a coordinate is NaN or infinite; radius 0 when all points are equal
/// exact   the points it rests on; centre and radius as sphere_through's, so that points may stand out by that much
/// cost    some ten passes over the points as a rule, also where all lie on one sphere up to rounding; nothing
///         allocates
/// source  Welzl 1991, for the few points that matter; these are found by taking in the farthest point each time, after
///         Gaertner 1999
template <PolygonRing R>
  requires(Point<ring_point<R>> && Floating<ring_scalar<R>> &&
           (size_of<ring_point<R>> == 2 || size_of<ring_point<R>> == 3))
[[nodiscard]] constexpr std::optional<bounding_sphere<ring_scalar<R>, size_of<ring_point<R>>>> smallest_sphere(
    const R& points) noexcept;

}  // namespace irg::inline IRG_ABI

namespace irg::detail {

// The points that the smallest ball around them rests on, and one more while it grows.
template <Floating T, int N>
struct ball_points {
  std::array<point<T, N>, static_cast<std::size_t>(N) + 2> points{};
  std::size_t size = 0;
};

// A ball by one of the points that it rests on and its centre from there, in double-double: where points lie to it to
// some 90 bits, for those that lie on it up to rounding. With way = p - from, |p - c|^2 - r^2 is
// (way . way divisor - way . offset) / divisor.
//
// Ways are exact. With L the greatest coordinate of a way to a point that the ball rests on, all numbers of
// centre_of_sphere are sums of at most 48 products of coordinates, divisor of degree k and offset of k + 1; each passes
// at most 12 operations, of relative errors below 5 * 2^-106, so that both are off by less than 48 * 12 * 5 * 2^-106 <
// 2^-94 times L^k and L^(k+1). The two products and their sums with p add less than 2^-98 of their sizes. Sizes between
// 2^-60 and 2^60 keep what underflows, some 2^-1074 times 2^360, far below that.
template <int N>
struct close_ball {
  vec<double, N> from{};
  double_double divisor{};
  vec<double_double, N> offset{};
  double divisor_off = 0, offset_off = 0, divisor_size = 0, offset_size = 0;  // offset_off 0: nothing is known

  template <Point P>
  IRG_INLINE constexpr vec<double_double, N> way_to(const P& p) const noexcept {
    vec<double_double, N> way;
    for (int i = 0; i < N; ++i) {
      const auto [value, error] = two_sum(widened(coordinate(p, i)), -from[i]);
      way[i] = double_double(value, error);
    }
    return way;
  }
};

inline namespace IRG_COMPILED_ABI {

// Takes p, which is outside of the ball, in; those points that the new ball does not rest on are forgotten.
template <Floating T, int N>
IRG_API void grow_ball(ball_points<T, N>& ball, const point<T, N>& p) noexcept;
template <Floating T, int N>
IRG_API bool is_outside_ball(const ball_points<T, N>& ball, const point<T, N>& p) noexcept;
template <Floating T, int N>
IRG_API close_ball<N> close_ball_of(const ball_points<T, N>& ball) noexcept;
template <Floating T, int N>
IRG_API bounding_sphere<T, N> rounded_ball_of(const ball_points<T, N>& ball) noexcept;

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

// How far p is from the ball's centre, squared, less the radius squared, about; and whether it is outside (1) or inside
// (-1) by far more than what rounding can do to the ball and to this; 0 when that is not sure.
struct guessed_side {
  double excess = 0;
  int side = 0;
};
template <Floating T, int N, Point P>
constexpr guessed_side guess_side(const bounding_sphere<T, N>& ball, const P& p) noexcept {
  const double radius = widened(ball.radius);
  double squared = 0, reach = radius;
  for (int i = 0; i < N; ++i) {
    const double c = widened(ball.centre[i]), x = widened(coordinate(p, i));
    reach = maximum(reach, maximum(magnitude(c), magnitude(x)));
    if (!(reach < 0x1p400)) return {0, 0};
    squared = squared + product(x - c, x - c);
  }
  const double slack = reach * (sizeof(T) == 4 ? 0x1p-18 : 0x1p-44), inner = radius - slack, outer = radius + slack;
  const double excess = squared - product(radius, radius);
  if (!(slack > 0x1p-400)) return {excess, 0};
  if (squared > product(outer, outer)) return {excess, 1};
  return {excess, inner > 0 && squared < product(inner, inner) ? -1 : 0};
}
template <int N, Point P>
constexpr guessed_side close_side(const close_ball<N>& ball, const P& p) noexcept {
  if (ball.offset_off == 0) return {};
  const vec<double_double, N> way = ball.way_to(p);
  double size = 0;
  for (int i = 0; i < N; ++i) size = maximum(size, magnitude(way[i].high));
  if (!(size < 0x1p60)) return {};
  const double_double gap = dot(way, way) * ball.divisor - dot(way, ball.offset);
  const double error = 3.1 * (product(product(size, size), ball.divisor_off + ball.divisor_size * 0x1p-98) +
                              product(size, ball.offset_off + ball.offset_size * 0x1p-98));
  if (!(magnitude(gap.high) > error)) return {};
  return {gap.high / ball.divisor.high, (gap.high > 0) == (ball.divisor.high > 0) ? 1 : -1};
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <PolygonRing R>
  requires(Point<ring_point<R>> && Floating<ring_scalar<R>> &&
           (size_of<ring_point<R>> == 2 || size_of<ring_point<R>> == 3))
[[nodiscard]] constexpr std::optional<bounding_sphere<ring_scalar<R>, size_of<ring_point<R>>>> smallest_sphere(
    const R& points) noexcept {
  using T = ring_scalar<R>;
  constexpr int N = size_of<ring_point<R>>;
  const auto at = [&](std::size_t i) { return detail::library_point(ring_vertex(points, i)); };
  if (ring_size(points) == 0) return std::nullopt;
  for (std::size_t i = 0; i < ring_size(points); ++i)
    for (int k = 0; k < N; ++k)
      if (!is_finite(coordinate(ring_vertex(points, i), k))) return std::nullopt;
  detail::ball_points<T, N> ball{{at(0)}, 1};
  for (;;) {  // the ball grows each time, and there are only so many
    const auto rounded = detail::rounded_ball_of(ball);
    const auto close = detail::close_ball_of(ball);
    std::size_t farthest = ring_size(points);
    double most = 0;
    for (std::size_t i = 0; i < ring_size(points); ++i) {
      const point<T, N> p = at(i);
      detail::guessed_side guess = detail::guess_side(rounded, p);
      if (guess.side == 0)
        if (const auto closer = detail::close_side(close, p); closer.side != 0) guess = closer;
      if (guess.side < 0 || (farthest < ring_size(points) && !(most < guess.excess))) continue;
      if (guess.side == 0 && !detail::is_outside_ball(ball, p)) continue;
      farthest = i, most = guess.excess;
    }
    if (farthest == ring_size(points)) return rounded;
    detail::grow_ball(ball, at(farthest));
  }
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail {

// The points that a ball rests on, by their numbers.
template <int N>
struct ball_support {
  std::array<std::size_t, static_cast<std::size_t>(N) + 1> at{};
  std::size_t count = 0;
};

inline namespace IRG_ABI {

// Whether p is outside of the smallest sphere through the points `on`.
template <Point P, std::same_as<P>... More>
constexpr bool is_outside(const P& p, const P& on, const More&... more) noexcept {
  const auto [gap, turn] = sign_of<6>(
      [](const auto& x, const auto& from, const auto&... to) {
        const auto c = centre_of_sphere((to - from)...);
        const auto way = x - from;
        return std::array{dot(way, way) * c.divisor - dot(way, c.offset), c.divisor};
      },
      p, on, more...);
  return gap * turn > 0;  // the divisor of a ball on D + 1 points may be negative
}

template <Point P, std::same_as<P>... More>
constexpr close_ball<size_of<P>> close_ball_on(const P& a, const More&... more) noexcept {
  constexpr int N = size_of<P>;
  close_ball<N> ball;
  for (int i = 0; i < N; ++i) ball.from[i] = widened(coordinate(a, i));
  double size = 0;
  const auto look = [&](const vec<double_double, N>& way) {
    for (int i = 0; i < N; ++i) size = maximum(size, magnitude(way[i].high));
  };
  (look(ball.way_to(more)), ...);
  if (!(size > 0x1p-60) || !(size < 0x1p60)) return ball;
  const auto centre = centre_of_sphere(ball.way_to(more)...);
  ball.divisor = centre.divisor, ball.offset = centre.offset;
  constexpr int degree = sizeof...(More) == 3 ? 3 : sizeof...(More) == 2 && N == 3 ? 4 : 2;
  ball.divisor_off = 0x1p-94;
  for (int i = 0; i < degree; ++i) ball.divisor_off = product(ball.divisor_off, size);
  ball.offset_off = product(ball.divisor_off, size);
  ball.divisor_size = magnitude(ball.divisor.high);
  for (int i = 0; i < N; ++i) ball.offset_size = maximum(ball.offset_size, magnitude(ball.offset[i].high));
  return ball;
}

template <Floating T, int N>
constexpr bool is_outside_of(const ball_points<T, N>& ball, const ball_support<N>& s, const point<T, N>& p) noexcept {
  std::array<point<T, N>, 4> on{};
  for (std::size_t k = 0; k < s.count; ++k) on[k] = ball.points[s.at[k]];
  if (s.count == 0) return true;
  if (s.count == 1) return !same_place(on[0], p);
  if (s.count == 2) return is_outside(p, on[0], on[1]);
  if constexpr (N == 3)
    if (s.count == 4) return is_outside(p, on[0], on[1], on[2], on[3]);
  return is_outside(p, on[0], on[1], on[2]);
}

// The points that the smallest ball around the first `count` points rests on when it passes through `forced`.
template <Floating T, int N>
constexpr ball_support<N> support_around(const ball_points<T, N>& ball, std::size_t count,
                                         const ball_support<N>& forced) noexcept {
  ball_support<N> s = forced;
  if (forced.count == static_cast<std::size_t>(N) + 1) return s;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_outside_of(ball, s, ball.points[i])) continue;
    ball_support<N> more = forced;
    more.at[more.count++] = i;
    s = support_around(ball, i, more);
  }
  return s;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API void grow_ball(ball_points<T, N>& ball, const point<T, N>& p) noexcept {
  ball.points[ball.size++] = p;
  const ball_support<N> s = support_around(ball, ball.size, {});
  ball_points<T, N> kept;
  for (; kept.size < s.count; ++kept.size) kept.points[kept.size] = ball.points[s.at[kept.size]];
  ball = kept;
}

template <Floating T, int N>
IRG_API bool is_outside_ball(const ball_points<T, N>& ball, const point<T, N>& p) noexcept {
  ball_support<N> all;
  for (; all.count < ball.size; ++all.count) all.at[all.count] = all.count;
  return is_outside_of(ball, all, p);
}

template <Floating T, int N>
IRG_API close_ball<N> close_ball_of(const ball_points<T, N>& ball) noexcept {
  const auto& p = ball.points;
  if (ball.size == 2) return close_ball_on(p[0], p[1]);
  if (ball.size == 3) return close_ball_on(p[0], p[1], p[2]);
  if constexpr (N == 3)
    if (ball.size == 4) return close_ball_on(p[0], p[1], p[2], p[3]);
  return {};
}

template <Floating T, int N>
IRG_API bounding_sphere<T, N> rounded_ball_of(const ball_points<T, N>& ball) noexcept {
  const auto& p = ball.points;
  if (ball.size == 2) return *sphere_on(p[0], p[1]);
  if (ball.size == 3) return *sphere_on(p[0], p[1], p[2]);
  if constexpr (N == 3)
    if (ball.size == 4) return *sphere_on(p[0], p[1], p[2], p[3]);
  return {p[0], T(0)};
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
