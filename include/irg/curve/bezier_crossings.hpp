// SPDX-License-Identifier: MIT
// Where two Bezier curves meet: the wider one is halved again and again, and pairs of stretches are dropped whose
// boxes, widened by what rounding may have done, are apart. Nothing else is ever dropped, so that no meeting is
// missed; what is left when the boxes are as narrow as asked, or the steps are used up, is handed over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include <irg/core/vocabulary.hpp>
#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// A stretch of each of two curves in which they may meet.
template <Floating T>
struct curve_meeting {
  T first_from = 0, first_to = 1, second_from = 0, second_to = 1;
  [[nodiscard]] IRG_APART constexpr T first_middle() const noexcept { return first_from + (first_to - first_from) / 2; }
  [[nodiscard]] IRG_APART constexpr T second_middle() const noexcept {
    return second_from + (second_to - second_from) / 2;
  }
  bool operator==(const curve_meeting&) const = default;
};

/// How far to go: pieces of curves are narrow enough when their boxes are no wider than the tolerance; and how many
/// pairs of pieces to look at before the rest is handed over as it is.
template <Floating T>
struct bezier_intersection_options {
  T tolerance = 0;
  std::size_t most_steps = 65536;
  bool operator==(const bezier_intersection_options&) const = default;
};

/// What came of a search: all meetings within the tolerance; some stretches wider, the steps having been used up or the
/// parameter's smallest step reached; or more of them than there was room for, the last one holding the rest.
enum class [[nodiscard]] bezier_intersection_status {
  ok,
  wide,
  too_many,
  within_tolerance [[deprecated("irg: within_tolerance is now ok")]] = ok
};

namespace detail::inline IRG_ABI {

// Stretch k of 2^level of a curve: its control points, and how far rounding may have moved them.
template <ControlPoints R>
struct halved_curve {
  using P = control_point<R>;
  using T = scalar_of<P>;
  const R& points;
  std::span<P> space;
  T off = 0;

  constexpr halved_curve(const R& r, std::span<P> scratch) noexcept : points(r), space(scratch) {
    T largest = 0;
    for (std::size_t i = 0; i < count(); ++i)
      for (int axis = 0; axis < size_of<P>; ++axis) {
        const T size = magnitude(coordinate(ring_traits<R>::vertex(points, i), axis));
        if (!(size <= largest)) largest = size == size ? size : std::numeric_limits<T>::infinity();
      }
    // Two splits, each of 3 * degree * u: bezier_point's bound.
    off = product(static_cast<T>(static_cast<int>(8 * count())),
                  product(largest, std::numeric_limits<T>::epsilon() / 2) + std::numeric_limits<T>::denorm_min());
  }
  constexpr std::size_t count() const noexcept { return ring_traits<R>::size(points); }
  constexpr void cut(int level, int k) noexcept {
    if (!is_finite(off)) return;
    const auto left = space.first(count()), work = space.subspan(count(), count());
    bezier_split(points, curve_fraction<T>(k + 1, 1 << level), left, work);
    bezier_split(left, curve_fraction<T>(k, k + 1), work, space.subspan(2 * count(), count()));
  }
  // The least and the greatest coordinate of the piece along an axis, widened.
  constexpr vec<T, 2> extent(int axis) const noexcept {
    if (!is_finite(off)) return {-std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()};
    T low = coordinate(space[2 * count()], axis), high = low;
    for (std::size_t i = 1; i < count(); ++i) {
      const T x = coordinate(space[2 * count() + i], axis);
      low = minimum(low, x), high = maximum(high, x);
    }
    return {low - off, high + off};
  }
};

// How many rows of as many points as both curves have bezier_intersections works in.
inline constexpr std::size_t meeting_rows = 3;

enum class pair_of_pieces { apart, narrow, first_is_wide, second_is_wide };

// Whether the boxes of two pieces are apart, both as narrow as asked, or else the wider of them.
template <class A, class B, Floating T>
constexpr pair_of_pieces compare_pieces(const A& a, const B& b, T tolerance) noexcept {
  T first = 0, second = 0;
  bool is_narrow = true;
  for (int axis = 0; axis < size_of<typename A::P>; ++axis) {
    const auto x = a.extent(axis), y = b.extent(axis);
    if (x.y < y.x || y.y < x.x) return pair_of_pieces::apart;
    is_narrow = is_narrow && x.y - x.x <= tolerance && y.y - y.x <= tolerance;
    first = maximum(first, x.y - x.x), second = maximum(second, y.y - y.x);
  }
  return is_narrow        ? pair_of_pieces::narrow
         : first < second ? pair_of_pieces::second_is_wide
                          : pair_of_pieces::first_is_wide;
}

// A walk over pairs of stretches: halves of the first or of the second curve, one after the other.
struct pair_walk {
  int level[2] = {0, 0}, at[2] = {0, 0};
  std::uint64_t path = 0;  // which curve was halved, the last one in the lowest bit

  constexpr void halve(int curve) noexcept {
    path = path * 2 + static_cast<std::uint64_t>(curve);
    ++level[curve], at[curve] *= 2;
  }
  // To the pair behind this one and its halves; false where there is none.
  constexpr bool advance() noexcept {
    while (level[0] + level[1] > 0) {
      const int curve = static_cast<int>(path % 2);
      if (at[curve] % 2 == 0) {
        ++at[curve];
        return true;
      }
      --level[curve], at[curve] /= 2, path /= 2;
    }
    return false;
  }
};

// A list of meetings in which those that touch are one.
template <Floating T>
struct meeting_list {
  std::span<curve_meeting<T>> room;
  std::size_t count = 0;
  bool is_full = false;

  static constexpr bool touch(const curve_meeting<T>& a, const curve_meeting<T>& b) noexcept {
    return a.first_from <= b.first_to && b.first_from <= a.first_to && a.second_from <= b.second_to &&
           b.second_from <= a.second_to;
  }
  static constexpr void unite(curve_meeting<T>& a, const curve_meeting<T>& b) noexcept {
    a = {minimum(a.first_from, b.first_from), maximum(a.first_to, b.first_to), minimum(a.second_from, b.second_from),
         maximum(a.second_to, b.second_to)};
  }
  constexpr void add(curve_meeting<T> m) noexcept {
    for (std::size_t i = 0; i < count;) {
      if (!touch(room[i], m)) {
        ++i;
        continue;
      }
      unite(m, room[i]);
      room[i] = room[--count];
      i = 0;  // the greater one may touch those before
    }
    if (count < room.size()) {
      room[count++] = m;
      return;
    }
    is_full = true;
    unite(room[count - 1], m);
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Writes to `room` the stretches in which two Bezier curves may meet; stretches that touch are one.
/// shape   in no order. A pair of stretches may hold one meeting, several, or none: curves nearer than the tolerance
/// needs   one or more control points each, of any dimension; room for 1 meeting or more; scratch three times as long
///         as both curves; tolerance >= 0
/// gives   how many there are: the first ones of the room. Coincident curves and control points that are not finite use
///         up the steps: few long stretches, and `wide`
/// exact   no meeting is missed, whatever the sizes, the steps and the room; no stretch is shorter than 2^-30 of its
///         parameter (float: 2^-24)
/// cost    four bezier_split a step; some 10 steps for each halving and each meeting
/// source  Lane and Riesenfeld 1980
template <ControlPoints R, ControlPoints S>
  requires(Floating<scalar_of<control_point<R>>> && std::is_same_v<control_point<R>, control_point<S>>)
constexpr checked<std::size_t, bezier_intersection_status> bezier_intersections(
    const R& first, const S& second,
    const std::type_identity_t<bezier_intersection_options<scalar_of<control_point<R>>>>& search,
    std::span<curve_meeting<scalar_of<control_point<R>>>> room, std::span<control_point<R>> scratch) noexcept {
  using T = scalar_of<control_point<R>>;
  constexpr int depth = minimum(std::numeric_limits<T>::digits, 30);
  const std::size_t n = ring_traits<R>::size(first), m = ring_traits<S>::size(second);
  const std::size_t needed = detail::meeting_rows * (n + m);
  IRG_EXPECTS(n > 0 && m > 0 && !room.empty() && scratch.size() >= needed && search.tolerance >= 0);
  detail::halved_curve<R> a(first, scratch.first(3 * n));
  detail::halved_curve<S> b(second, scratch.subspan(3 * n, 3 * m));
  detail::meeting_list<T> list{room};
  bool any_wide = false;
  std::size_t steps = 0;
  detail::pair_walk walk;
  for (bool goes_on = true; goes_on;) {
    using enum detail::pair_of_pieces;
    const int i = walk.at[0], j = walk.at[1];
    a.cut(walk.level[0], i);
    b.cut(walk.level[1], j);
    const auto pair = detail::compare_pieces(a, b, search.tolerance);
    const bool is_wide = pair == first_is_wide || pair == second_is_wide;
    if (is_wide && walk.level[0] + walk.level[1] < 2 * depth && ++steps < search.most_steps) {
      const int wider = pair == second_is_wide ? 1 : 0;
      walk.halve(walk.level[wider] < depth ? wider : 1 - wider);
      continue;
    }
    any_wide = any_wide || is_wide;
    const T first_all = static_cast<T>(1 << walk.level[0]), second_all = static_cast<T>(1 << walk.level[1]);
    if (pair != apart)
      list.add({static_cast<T>(i) / first_all, static_cast<T>(i + 1) / first_all, static_cast<T>(j) / second_all,
                static_cast<T>(j + 1) / second_all});
    goes_on = walk.advance();
  }
  return {list.count, list.is_full ? bezier_intersection_status::too_many
                      : any_wide   ? bezier_intersection_status::wide
                                   : bezier_intersection_status::ok};
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, ControlPoints S, WorkspaceFor<R> W = workspace_for<R>>
  requires(Floating<scalar_of<control_point<R>>> && std::is_same_v<control_point<R>, control_point<S>>)
constexpr checked<std::size_t, bezier_intersection_status> bezier_intersections(
    const R& first, const S& second,
    const std::type_identity_t<bezier_intersection_options<scalar_of<control_point<R>>>>& search,
    std::span<curve_meeting<scalar_of<control_point<R>>>> room, W&& memory = W{}) {
  const std::size_t count = ring_traits<R>::size(first) + ring_traits<S>::size(second);
  return bezier_intersections(first, second, search, room,
                              detail::room_for(memory.points, detail::meeting_rows * count));
}

IRG_RENAMED(bezier_meetings, bezier_intersections)

}  // namespace IRG_ABI
}  // namespace irg
