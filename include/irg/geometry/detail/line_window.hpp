// SPDX-License-Identifier: MIT
// What the line clippers share: where an end lies against a window, on which side of its corners a line passes, and
// where it enters. Every decision is exact, so the clippers differ in their order of work alone.
#pragma once

#include <optional>

#include <irg/geometry/box.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/detail/axis_crossing.hpp>
#include <irg/geometry/orient2d.hpp>

namespace irg::detail::inline IRG_ABI {

// A boundary of a window: x = low.x is {0, -1}, y = high.y is {1, 1}. No boundary has side 0.
struct window_side {
  int axis = 0, side = 0;
};

template <class T, int N>
IRG_INLINE constexpr const T& bound_of(const box<T, N>& window, window_side at) noexcept {
  return at.side < 0 ? window.low[at.axis] : window.high[at.axis];
}

// -1 below the window, 1 above it, 0 in it, along one axis.
template <class T, int N>
IRG_INLINE constexpr int place_of(const T& x, const box<T, N>& window, int axis) noexcept {
  return x < window.low[axis] ? -1 : window.high[axis] < x ? 1 : 0;
}

template <Point P, int N>
IRG_INLINE constexpr bool is_within(const P& p, const box<scalar_of<P>, N>& window) noexcept {
  bool within = true;
  for (int i = 0; i < N; ++i) {
    const auto x = coordinate(p, i);
    within = within && !(x < window.low[i]) && !(window.high[i] < x) && x == x;
  }
  return within;
}

// The sign of t_first - t_second, where the line from a to b crosses the two boundaries, which are of different axes
// and are crossed: the side of the line on which their corner lies says it.
template <Point P, int N>
constexpr int compare_crossings(const P& a, const P& b, const box<scalar_of<P>, N>& window, window_side first,
                                window_side second) noexcept {
  using T = scalar_of<P>;
  const auto project = [&](const P& p) { return point<T, 2>{coordinate(p, first.axis), coordinate(p, second.axis)}; };
  const point<T, 2> pa = project(a), pb = project(b);
  const int turn = orient2d(pa, pb, point<T, 2>{bound_of(window, first), bound_of(window, second)});
  return (pa.x < pb.x) == (pa.y < pb.y) ? -turn : turn;
}

// Where the line from a to b crosses a boundary: there exactly, the other coordinates correctly rounded.
template <Point P, int N>
constexpr P intersection_point(const P& a, const P& b, const box<scalar_of<P>, N>& window, window_side at) noexcept {
  const auto x = bound_of(window, at);
  const auto ax = coordinate(a, at.axis), bx = coordinate(b, at.axis);
  return generate_coordinates<P>(
      [&](int i) { return i == at.axis ? x : axis_crossing_of(ax, coordinate(a, i), bx, coordinate(b, i), x); });
}

// The visible part that begins at one boundary and ends at another; at the line's own ends where there is none.
template <Point P, int N>
constexpr clipped_line<P> line_between(const P& a, const P& b, const box<scalar_of<P>, N>& window, window_side entry,
                                       window_side exit) noexcept {
  using T = typename clipped_line<P>::parameter;
  const auto parameter = [&](window_side at) {
    return parameter_of(coordinate(a, at.axis), coordinate(b, at.axis), bound_of(window, at));
  };
  const T t_first = entry.side != 0 ? parameter(entry) : T(0);
  T t_second = exit.side != 0 ? parameter(exit) : T(1);
  if (t_second < t_first) t_second = t_first;  // a point, or nearly, crossed on two axes
  return {entry.side != 0 ? intersection_point(a, b, window, entry) : a,
          exit.side != 0 ? intersection_point(a, b, window, exit) : b, t_first, t_second};
}

}  // namespace irg::detail::inline IRG_ABI
