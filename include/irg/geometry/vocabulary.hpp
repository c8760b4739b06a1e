// SPDX-License-Identifier: MIT
// The words of geometry: segments and what clipping leaves of them, how two flats lie, what can be made of two sets.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/parametric_line.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// What to make of a and b.
enum class boolean_operation {
  intersection,
  union_,
  difference,
  symmetric_difference,
  unite [[deprecated("irg: unite is now union_")]] = union_
};

/// How two lines, two planes, or a line and a plane lie: `none` when one of them is none (equal points, a zero normal)
/// or a number is NaN or infinite; `coincident` when they are the same or one contains the other; `skew` for lines of
/// space without a common plane.
enum class flat_relation { none, crossing, parallel, coincident, skew };

/// The points from a to b, both included; a point when they are equal.
template <Scalar T, int N>
struct segment {
  point<T, N> a{}, b{};
  bool operator==(const segment&) const = default;
};

inline namespace IRG_ABI {

/// The point at t: a at 0, b at 1.
/// exact   as point_between
template <Real T, int N>
[[nodiscard]] constexpr point<T, N> point_at(const segment<T, N>& s, std::type_identity_t<T> t) noexcept {
  return point_between(s.a, s.b, t);
}

/// The smallest box around the segment.
/// exact   no arithmetic
template <class T, int N>
[[nodiscard]] constexpr box<T, N> bounding_box(const segment<T, N>& s) noexcept {
  return bounding_box(bounding_box(box<T, N>{}, s.a), s.b);
}

/// The segment from b to a.
template <class T, int N>
[[nodiscard]] constexpr segment<T, N> reversed(const segment<T, N>& s) noexcept {
  return {s.b, s.a};
}

}  // namespace IRG_ABI

/// The visible part of the segment from a to b: from `first` to `second`, where the parameters are those of a + t*(b -
/// a).
/// shape   0 <= t_first <= t_second <= 1; a kept end is the given point, bit for bit, at 0 or 1. Parameters are numbers
///         of the coordinates' type, doubles for integers
template <Point P>
struct clipped_line {
  using parameter = std::conditional_t<std::is_integral_v<scalar_of<P>>, double, scalar_of<P>>;
  P first = zero_coordinates<P>(), second = zero_coordinates<P>();
  parameter t_first = parameter(0), t_second = parameter(1);
  // Coordinate by coordinate: == of foreign points need not be constexpr.
  IRG_APART constexpr bool operator==(const clipped_line& other) const {
    for (int i = 0; i < size_of<P>; ++i)
      if (coordinate(first, i) != coordinate(other.first, i) || coordinate(second, i) != coordinate(other.second, i))
        return false;
    return t_first == other.t_first && t_second == other.t_second;
  }
};

}  // namespace irg
