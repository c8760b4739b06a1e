// SPDX-License-Identifier: MIT
// What two segments have in common, in the plane and in space: nothing, a point or a segment, decided exactly.
#pragma once

#include <concepts>

#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/vocabulary.hpp>

namespace irg {

/// What two segments have in common: `none` also when a coordinate is NaN or infinite.
enum class segment_relation { none, point, overlap };

/// What two segments have in common: nothing, the point `first`, or the segment from `first` to `last`.
/// shape   first and last run in the direction of the first segment; first == last for a point. Of nothing they have no
///         meaning: Eigen's are what was in memory. t and s are the parameters of `first` on the two segments where
///         they cross in one point and neither is collinear to the other, 0 elsewhere
template <Point P>
struct segments_meeting {
  segment_relation relation = segment_relation::none;
  P first = zero_coordinates<P>(), last = zero_coordinates<P>();
  scalar_of<P> t{}, s{};
  IRG_APART constexpr bool operator==(const segments_meeting& o) const {
    return relation == o.relation && same_place(first, o.first) && same_place(last, o.last) && t == o.t && s == o.s;
  }
};

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API segments_meeting<point<T, N>> meeting_of_segments(const point<T, N>& a, const point<T, N>& b,
                                                          const point<T, N>& c, const point<T, N>& d) noexcept;

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// A point given, as a place where two segments meet.
template <Point P>
IRG_INLINE constexpr meeting_point<P> as_meeting(const P& p) noexcept {
  if constexpr (std::integral<scalar_of<P>>)
    return generate_coordinates<meeting_point<P>>([&](int i) { return static_cast<double>(coordinate(p, i)); });
  else
    return p;
}

// The common part of two segments on one line, by the order of coordinates along an axis on which they extend.
template <Point P>
constexpr segments_meeting<meeting_point<P>> common_part(const P& a, const P& b, const P& c, const P& d) noexcept {
  int axis = 0;
  const auto differ = [&](const P& p, const P& q) { return !(coordinate(p, axis) == coordinate(q, axis)); };
  while (axis < size_of<P> - 1 && !differ(a, b) && !differ(c, d) && !differ(a, c)) ++axis;
  const auto precedes = [&](const P& p, const P& q) { return coordinate(p, axis) < coordinate(q, axis); };
  const bool forward = !precedes(b, a), c_first = !precedes(d, c);
  const P &low1 = forward ? a : b, &high1 = forward ? b : a, &low2 = c_first ? c : d, &high2 = c_first ? d : c;
  const P &low = precedes(low1, low2) ? low2 : low1, &high = precedes(high2, high1) ? high2 : high1;
  if (precedes(high, low)) return {};
  const auto first = as_meeting(forward ? low : high), last = as_meeting(forward ? high : low);
  return {precedes(low, high) ? segment_relation::overlap : segment_relation::point, first, last, {}, {}};
}

// Whether c and d are surely on one side of the line ab.
template <Point P>
constexpr bool on_one_side(const P& a, const P& b, const P& c, const P& d) noexcept {
  const int side = orient2d(a, b, c);
  return side != 0 && side == orient2d(a, b, d);
}

template <Point P>
constexpr segments_meeting<meeting_point<P>> find_meeting_of_segments(const P& a, const P& b, const P& c,
                                                                      const P& d) noexcept {
  using M = meeting_point<P>;
  using T = scalar_of<M>;
  if (!is_finite(a, b, c, d)) return {};
  if constexpr (size_of<P> == 2)
    if (on_one_side(a, b, c, d) || on_one_side(c, d, a, b)) return {};
  const auto m = cross_lines(a, b, c, d);
  if (m.relation == flat_relation::coincident) return common_part(a, b, c, d);
  if (m.relation != flat_relation::crossing) return {};
  const int side = sign_of(m.divisor);
  const auto part = [&](const auto& v) { return sign_of(v) * side; };
  const int t = part(m.t), t_rest = part(m.t_rest), s = part(m.s), s_rest = part(m.s_rest);
  if (t < 0 || t_rest < 0 || s < 0 || s_rest < 0) return {};
  const auto parameter = [&](const auto& v, int rest) { return rest == 0 ? T(1) : rounded_to<T>(v / m.divisor); };
  const P* end = t == 0 ? &a : t_rest == 0 ? &b : s == 0 ? &c : s_rest == 0 ? &d : nullptr;
  const M at = end != nullptr ? as_meeting(*end) : rounded_coordinates<M>(m.at / m.divisor);
  return {segment_relation::point, at, at, parameter(m.t, t_rest), parameter(m.s, s_rest)};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// What the segments ab and cd have in common: nothing, a point, or a segment. Segments may be points.
/// gives   `none` when a coordinate is NaN or infinite
/// exact   the relation for all finite points and all integers. Where an end of one lies on the other, the point is
///         that end, bit for bit (integers: the nearest doubles); elsewhere coordinates, t and s are within 0.501 ulp
/// cost    some 20 ns in the plane when one segment is on one side of the other's line, else as intersect_lines
template <Point P>
  requires(Scalar<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr auto intersect_segments(const P& a, const P& b, const P& c, const P& d) noexcept
    -> segments_meeting<detail::meeting_point<P>> {
  if constexpr (detail::CompiledNumber<scalar_of<P>>) {
    if constexpr (size_of<P> == 2 && !IRG_BODIES) {  // what is told in less time than a call takes
      if (!is_finite(a, b, c, d)) return {};
      if (detail::on_one_side(a, b, c, d) || detail::on_one_side(c, d, a, b)) return {};
    }
    const auto m = detail::meeting_of_segments(detail::library_point(a), detail::library_point(b),
                                               detail::library_point(c), detail::library_point(d));
    using M = detail::meeting_point<P>;
    return {m.relation, detail::own_point<M>(m.first), detail::own_point<M>(m.last), m.t, m.s};
  } else {
    return detail::find_meeting_of_segments(a, b, c, d);
  }
}

/// The same for segments by name.
template <Scalar T, int N>
[[nodiscard]] constexpr auto intersect_segments(const segment<T, N>& first, const segment<T, N>& second) noexcept {
  return intersect_segments(first.a, first.b, second.a, second.b);
}

IRG_REFUSES_VECTORS(intersect_segments);

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API segments_meeting<point<T, N>> meeting_of_segments(const point<T, N>& a, const point<T, N>& b,
                                                          const point<T, N>& c, const point<T, N>& d) noexcept {
  return find_meeting_of_segments(a, b, c, d);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
