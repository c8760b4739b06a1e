// SPDX-License-Identifier: MIT
// The regions that polygons are clipped to, as polygon_pipe asks for them.
#pragma once

#include <limits>
#include <span>

#include <irg/core/conversion.hpp>
#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/axis_crossing.hpp>
#include <irg/geometry/detail/half_space.hpp>

namespace irg::detail {

// A window: a stage for each axis. Exact, and cut coordinates are correctly rounded.
template <class T, class F>
struct window_region {
  static constexpr std::size_t stages = 2;
  const box<T, 2>& window;
  const F& interpolate;

  IRG_INLINE static constexpr std::size_t count() noexcept { return stages; }
  IRG_INLINE constexpr const T& bound(std::size_t s, int place) const noexcept {
    return place < 0 ? window.low[static_cast<int>(s)] : window.high[static_cast<int>(s)];
  }
  template <Point P>
  IRG_INLINE constexpr int place(std::size_t s, const P& p) const noexcept {
    const int axis = static_cast<int>(s);
    const T x = coordinate(p, axis);
    return static_cast<int>(window.high[axis] < x) - static_cast<int>(x < window.low[axis]);
  }
  template <Point P>
  IRG_INLINE constexpr bool is_on(std::size_t s, int place, const P& p) const noexcept {
    return coordinate(p, static_cast<int>(s)) == bound(s, place);
  }
  template <class V>
  constexpr V cut(std::size_t s, int place, const V& from, const V& to) const {
    using P = vertex_position<V>;
    const int axis = static_cast<int>(s);
    const bool swapped = comes_before(position_of(to), position_of(from));
    const V& a = swapped ? to : from;
    const V& b = swapped ? from : to;
    const P& p = position_of(a);
    const P& q = position_of(b);
    const T x = bound(s, place), low = coordinate(p, axis), high = coordinate(q, axis);
    const T y = axis_crossing_of(low, coordinate(p, 1 - axis), high, coordinate(q, 1 - axis), x);
    const P at = generate_coordinates<P>([&](int i) { return i == axis ? x : y; });
    if constexpr (Point<V>)
      return at;
    else
      return placed_at(V(interpolate(a, b, parameter_of(low, high, x))), at);
  }
};

// Half-spaces. What is no further from a boundary than rounding moves a cut (8u of the sizes of the value's terms)
// counts as on it.
template <class T, int D, class F, class Boundary>
struct half_space_region {
  static constexpr std::size_t stages = static_cast<std::size_t>(-1);
  std::size_t boundaries;
  const Boundary& boundary;  // boundary(s): half_space<T, D>
  const F& interpolate;

  IRG_INLINE constexpr std::size_t count() const noexcept { return boundaries; }
  template <Point P>
  constexpr int place(std::size_t s, const P& p) const noexcept {
    return side(s, p) < 0 ? -1 : 0;
  }
  template <Point P>
  constexpr bool is_on(std::size_t s, int, const P& p) const noexcept {
    return side(s, p) == 0;
  }
  template <Point P>
  constexpr int side(std::size_t s, const P& p) const noexcept {
    const auto h = boundary(s).numbers;
    const auto x = gathered<T>(p);
    if constexpr (!Floating<T>) {
      return known_sign(half_space_value<D>(h, x));
    } else {
      const auto term = [](T a, T b) { return product(widened(a), widened(b)); };
      double value = 0, size = 0;
      const auto add = [&](double t, double s_of_t) { value += t, size += s_of_t; };
      if constexpr (D == 2) {
        const T along[] = {h[3] - h[1], h[2] - h[0]};
        const auto spread = [](T a, T b) { return widened(magnitude(a)) + widened(magnitude(b)); };
        add(term(along[1], x[1] - h[1]), product(widened(magnitude(along[1])), spread(x[1], h[1])));
        add(-term(along[0], x[0] - h[0]), product(widened(magnitude(along[0])), spread(x[0], h[0])));
      } else {
        for (std::size_t i = 0; i < 3; ++i) add(term(h[i], x[i]), magnitude(term(h[i], x[i])));
        add(widened(h[3]), widened(magnitude(h[3])));
      }
      const double bound = product(size, 4 * static_cast<double>(std::numeric_limits<T>::epsilon()));
      return value > bound ? 1 : -value > bound ? -1 : 0;
    }
  }
  template <class V>
  constexpr V cut(std::size_t s, int, const V& from, const V& to) const {
    const bool swapped = comes_before(position_of(to), position_of(from));
    const V& a = swapped ? to : from;
    const V& b = swapped ? from : to;
    const auto meeting = meet_half_space(position_of(a), position_of(b), boundary(s));
    if constexpr (Point<V>)
      return meeting.at;
    else
      return placed_at(V(interpolate(a, b, meeting.t)), meeting.at);
  }
};

}  // namespace irg::detail
