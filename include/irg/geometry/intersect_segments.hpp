// SPDX-License-Identifier: MIT
// What two segments have in common, in the plane and in space: nothing, a point or a segment, decided exactly.
#pragma once

#include <cstddef>

#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/segment.hpp>

namespace irg {

/// What two segments have in common: `none` also when a coordinate is NaN or infinite.
enum class segment_relation { none, point, overlap };

/// What two segments have in common: nothing, the point `first`, or the segment from `first` to `last`.
/// shape   first and last run in the direction of the first segment; first == last for a point. t and s are the
///         parameters of `first` on the two segments where they cross in one point and neither is collinear to the
///         other, 0 elsewhere
template <Point P>
struct segments_meeting {
  segment_relation relation = segment_relation::none;
  P first{}, last{};
  scalar_of<P> t{}, s{};
};

namespace detail {
inline namespace IRG_ABI {

// The common part of two segments on one line, by the order of coordinates along an axis on which they extend.
template <Point P>
constexpr segments_meeting<P> common_part(const P& a, const P& b, const P& c, const P& d) noexcept {
  int axis = 0;
  const auto differ = [&](const P& p, const P& q) { return !(coordinate(p, axis) == coordinate(q, axis)); };
  while (axis < size_of<P> - 1 && !differ(a, b) && !differ(c, d) && !differ(a, c)) ++axis;
  const auto precedes = [&](const P& p, const P& q) { return coordinate(p, axis) < coordinate(q, axis); };
  const bool forward = !precedes(b, a), c_first = !precedes(d, c);
  const P &low1 = forward ? a : b, &high1 = forward ? b : a, &low2 = c_first ? c : d, &high2 = c_first ? d : c;
  const P &low = precedes(low1, low2) ? low2 : low1, &high = precedes(high2, high1) ? high2 : high1;
  if (precedes(high, low)) return {};
  if (!precedes(low, high)) return {segment_relation::point, low, low, {}, {}};
  return {segment_relation::overlap, forward ? low : high, forward ? high : low, {}, {}};
}

// Whether c and d are surely on one side of the line ab.
template <Point P>
constexpr bool on_one_side(const P& a, const P& b, const P& c, const P& d) noexcept {
  const int side = orient2d(a, b, c);
  return side != 0 && side == orient2d(a, b, d);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// What the segments ab and cd have in common: nothing, a point, or a segment. Segments may be points.
/// gives   `none` when a coordinate is NaN or infinite
/// exact   the relation for all finite points. Where an end of one lies on the other, the point is that end, bit for
///         bit; elsewhere its coordinates, t and s are within 0.501 ulp
/// cost    some 20 ns in the plane when one segment is on one side of the other's line, else as intersect_lines
template <Point P>
  requires(Real<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr segments_meeting<P> intersect_segments(const P& a, const P& b, const P& c,
                                                               const P& d) noexcept {
  using T = scalar_of<P>;
  if (!is_finite(a, b, c, d)) return {};
  if constexpr (size_of<P> == 2)
    if (detail::on_one_side(a, b, c, d) || detail::on_one_side(c, d, a, b)) return {};
  const auto m = detail::cross_lines(a, b, c, d);
  if (m.relation == flat_relation::coincident) return detail::common_part(a, b, c, d);
  if (m.relation != flat_relation::crossing) return {};
  const int side = sign_of(m.divisor);
  const auto part = [&](const auto& v) { return sign_of(v) * side; };
  const int t = part(m.t), t_rest = part(m.t_rest), s = part(m.s), s_rest = part(m.s_rest);
  if (t < 0 || t_rest < 0 || s < 0 || s_rest < 0) return {};
  const auto parameter = [&](const auto& v, int rest) { return rest == 0 ? T(1) : rounded_to<T>(v / m.divisor); };
  const P at = t == 0 ? a : t_rest == 0 ? b : s == 0 ? c : s_rest == 0 ? d : rounded_coordinates<P>(m.at / m.divisor);
  return {segment_relation::point, at, at, parameter(m.t, t_rest), parameter(m.s, s_rest)};
}

/// The same for segments by name.
template <Real T, int N>
[[nodiscard]] constexpr segments_meeting<point<T, N>> intersect_segments(const segment<T, N>& first,
                                                                         const segment<T, N>& second) noexcept {
  return intersect_segments(first.a, first.b, second.a, second.b);
}

/// The same for points of integers; what they have in common comes in doubles.
template <detail::SmallIntegerPoint P>
[[nodiscard]] constexpr segments_meeting<point<double, size_of<P>>> intersect_segments(const P& a, const P& b,
                                                                                       const P& c,
                                                                                       const P& d) noexcept {
  return intersect_segments(detail::in_doubles(a), detail::in_doubles(b), detail::in_doubles(c), detail::in_doubles(d));
}

}  // namespace IRG_ABI
}  // namespace irg
