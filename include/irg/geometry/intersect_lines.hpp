// SPDX-License-Identifier: MIT
// Where two lines meet, in the plane and in space: crossing, parallel, coincident or skew is decided exactly, and the
// point is right to the last bit or nearly so, however nearly parallel the lines are.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>

#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/parametric_line.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg {

/// How two lines lie, where they cross, and the parameters of that point on the first and on the second line.
/// shape   at, t and s have a meaning only where the lines cross
template <Point P>
struct lines_meeting {
  flat_relation relation = flat_relation::none;
  P at = zero_coordinates<P>();
  scalar_of<P> t{}, s{};
  IRG_APART constexpr bool operator==(const lines_meeting& o) const {
    return relation == o.relation && same_place(at, o.at) && t == o.t && s == o.s;
  }
};

namespace detail {

inline namespace IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API lines_meeting<point<T, N>> meeting_of_lines(const point<T, N>& a, const point<T, N>& b, const point<T, N>& c,
                                                    const point<T, N>& d) noexcept;
template <Floating T, int N>
IRG_API lines_meeting<point<T, N>> meeting_of_lines(const parametric_line<T, N>& first,
                                                    const parametric_line<T, N>& second) noexcept;

}  // namespace IRG_COMPILED_ABI

// The type of the place where such points' lines meet: in doubles for points of integers.
template <Point P>
using meeting_point = std::conditional_t<std::integral<scalar_of<P>>, point<double, size_of<P>>, P>;

// What is known of two crossing lines: t and s times the divisor, what they lack of 1, and the point times it.
template <class V, int D>
struct line_crossing {
  flat_relation relation = flat_relation::none;
  V divisor{}, t{}, s{}, t_rest{}, s_rest{};
  vec<V, D> at{};
};

inline namespace IRG_ABI {

// The way from one point to another, or a direction itself.
template <class A, class N, int D>
IRG_INLINE constexpr vec<N, D> way_along(const A&, const vec<N, D>& direction) noexcept {
  return direction;
}
template <class N, int D>
IRG_INLINE constexpr auto way_along(const point<N, D>& from, const point<N, D>& to) noexcept {
  return to - from;
}

// Coordinate k of the cross product, which in the plane has but one.
template <class N>
IRG_INLINE constexpr N cross_coordinate(const vec<N, 2>& a, const vec<N, 2>& b, int) noexcept {
  return cross(a, b);
}
template <class N>
IRG_INLINE constexpr N cross_coordinate(const vec<N, 3>& a, const vec<N, 3>& b, int k) noexcept {
  return cross(a, b)[k];
}

// The lines from a to (or along) b and from c to (or along) d.
template <class P, class Q>
constexpr auto cross_lines(const P& a, const Q& b, const P& c, const Q& d) noexcept {
  using T = scalar_of<P>;
  using V = std::conditional_t<std::integral<T>, scaled_double_double, known_value<T>>;
  constexpr int D = size_of<P>;
  line_crossing<V, D> result;
  int k = 0;
  bool parallel = false;
  if constexpr (D == 3) {
    const auto normal = known_values_of<3>(
        [](const auto& from, const auto& to, const auto& other, const auto& end) {
          const auto n = cross(way_along(from, to), way_along(other, end));
          return std::tuple{n, dot(n, other - from)};
        },
        a, b, c, d);
    if (!normal) return result;
    const auto& [n, volume] = *normal;
    parallel = is_zero(n);
    if (!parallel && !is_zero(volume)) {
      result.relation = flat_relation::skew;
      return result;
    }
    k = largest_coordinate(n);
  }
  if (!parallel) {
    const auto meeting = known_values_of<3>(
        [k](const auto& from, const auto& to, const auto& other, const auto& end) {
          const auto u = way_along(from, to), v = way_along(other, end), w = other - from;
          const auto n = cross_coordinate(u, v, k), t = cross_coordinate(w, v, k), s = cross_coordinate(w, u, k);
          return std::tuple{n, t, s, n - t, n - s, to_vec(from) * n + u * t};
        },
        a, b, c, d);
    if (!meeting) return result;
    const auto& [n, t, s, t_rest, s_rest, at] = *meeting;
    if (!is_zero(n)) return line_crossing<V, D>{flat_relation::crossing, n, t, s, t_rest, s_rest, at};
  }
  // All four points on one line? Where a line is but a point, it need be on the other one.
  const auto apart = known_values_of<2>(
      [](const auto& from, const auto& to, const auto& other, const auto& end) {
        const auto w = other - from;
        return std::tuple{cross(w, way_along(from, to)), cross(w, way_along(other, end))};
      },
      a, b, c, d);
  if (!apart) return result;
  const auto& [from_first, from_second] = *apart;
  result.relation = is_zero(from_first) && is_zero(from_second) ? flat_relation::coincident : flat_relation::parallel;
  return result;
}

template <Point P, class V, int D>
constexpr lines_meeting<P> rounded_meeting(const line_crossing<V, D>& c) noexcept {
  if (c.relation != flat_relation::crossing) return {c.relation};
  using T = scalar_of<P>;
  return {c.relation, rounded_coordinates<P>(c.at / c.divisor), rounded_to<T>(c.t / c.divisor),
          rounded_to<T>(c.s / c.divisor)};
}

template <Point P>
constexpr lines_meeting<meeting_point<P>> find_meeting_of_lines(const P& a, const P& b, const P& c,
                                                                const P& d) noexcept {
  if (same_place(a, b) || same_place(c, d)) return {};
  return rounded_meeting<meeting_point<P>>(cross_lines(a, b, c, d));
}
template <Real T, int N>
constexpr lines_meeting<point<T, N>> find_meeting_of_lines(const parametric_line<T, N>& first,
                                                           const parametric_line<T, N>& second) noexcept {
  if (is_zero(first.direction) || is_zero(second.direction)) return {};
  return rounded_meeting<point<T, N>>(cross_lines(first.origin, first.direction, second.origin, second.direction));
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// How the line through a and b and the line through c and d lie, and where they cross.
/// gives   `none` when a == b or c == d, or a coordinate is NaN or infinite. Never NaN for finite points; infinity
///         where the exact value is beyond the range
/// exact   the relation for all finite points and all integers; each coordinate of the point, t and s within 0.501 ulp
///         of the exact ones, in doubles for points of integers. Exact in rationals
/// cost    some 250 ns (space: 300), about 4 us near a degenerate case or beyond 2^+-80 (integers: 2^53)
template <Point P>
  requires(Scalar<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr auto intersect_lines(const P& a, const P& b, const P& c, const P& d) noexcept
    -> lines_meeting<detail::meeting_point<P>> {
  if constexpr (detail::CompiledNumber<scalar_of<P>>) {
    const auto m = detail::meeting_of_lines(detail::library_point(a), detail::library_point(b),
                                            detail::library_point(c), detail::library_point(d));
    return {m.relation, detail::own_point<detail::meeting_point<P>>(m.at), m.t, m.s};
  } else {
    return detail::find_meeting_of_lines(a, b, c, d);
  }
}

/// The same for lines given by origin and direction; t and s count in their directions.
/// gives   `none` when a direction is zero
/// exact   as for points, for the directions as they are
template <Real T, int N>
  requires(N == 2 || N == 3)
[[nodiscard]] constexpr lines_meeting<point<T, N>> intersect_lines(const parametric_line<T, N>& first,
                                                                   const parametric_line<T, N>& second) noexcept {
  if constexpr (Floating<T>)
    return detail::meeting_of_lines(first, second);
  else
    return detail::find_meeting_of_lines(first, second);
}

IRG_REFUSES_VECTORS(intersect_lines);

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API lines_meeting<point<T, N>> meeting_of_lines(const point<T, N>& a, const point<T, N>& b, const point<T, N>& c,
                                                    const point<T, N>& d) noexcept {
  return find_meeting_of_lines(a, b, c, d);
}

template <Floating T, int N>
IRG_API lines_meeting<point<T, N>> meeting_of_lines(const parametric_line<T, N>& first,
                                                    const parametric_line<T, N>& second) noexcept {
  return find_meeting_of_lines(first, second);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
