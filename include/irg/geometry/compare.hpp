// SPDX-License-Identifier: MIT
// Which of two points comes first: by coordinates, along a line, by distance from a point. Decided exactly.
#pragma once

#include <irg/core/coordinates.hpp>
#include <irg/math/exact/nearest_float.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg::inline IRG_ABI {

/// -1 when p comes before q by its first coordinate, or by the first that differs; 1 when it comes after q; 0 when they
/// are equal.
/// needs   no NaN
/// exact   comparisons alone; -0 and 0 are equal
template <Point P>
[[nodiscard]] constexpr int compare_lexicographic(const P& p, const P& q) noexcept {
  for (int i = 0; i < size_of<P>; ++i)
    if (const int order = compare_numbers(coordinate(p, i), coordinate(q, i)); order != 0) return order;
  return 0;
}

/// Whether p, a point of the line through a and b, lies on the segment between them, its ends included.
/// needs   no NaN
/// exact   comparisons alone
template <Point P>
[[nodiscard]] constexpr bool is_between_ends(const P& a, const P& b, const P& p) noexcept {
  return compare_lexicographic(a, p) * compare_lexicographic(p, b) >= 0;
}

/// -1 when p comes before q for one who goes from a to b, 1 when it comes after q, 0 when they are level: the points
/// count where they fall on the line through a and b, which they need not lie on.
/// needs   finite coordinates
/// gives   0 when a and b are equal
/// exact   the sign of (b - a) . (p - q), for every finite float, double and integer
/// cost    about 5 ns, where roundings do not tell some 200 ns
template <Point P>
  requires(size_of<P> == 2 || size_of<P> == 3)
[[nodiscard]] constexpr int order_along_line(const P& a, const P& b, const P& p, const P& q) noexcept {
  return sign_of<2>(
      [](const auto& from, const auto& to, const auto& x, const auto& y) { return dot(to - from, x - y); }, a, b, p, q);
}

/// -1 when a is nearer to p than b is, 1 when b is nearer, 0 when they are equally far.
/// needs   finite coordinates
/// exact   the sign of |a - p|^2 - |b - p|^2, for every finite float, double and integer
/// cost    about 5 ns, where roundings do not tell some 300 ns
template <Point P>
  requires(size_of<P> == 2 || size_of<P> == 3)
[[nodiscard]] constexpr int compare_distance(const P& p, const P& a, const P& b) noexcept {
  return sign_of<2>(
      [](const auto& from, const auto& x, const auto& y) { return dot(x - from, x - from) - dot(y - from, y - from); },
      p, a, b);
}

IRG_REFUSES_VECTORS(compare_distance);
IRG_REFUSES_VECTORS(compare_lexicographic);
IRG_REFUSES_VECTORS(is_between_ends);
IRG_REFUSES_VECTORS(order_along_line);

}  // namespace irg::inline IRG_ABI
