// SPDX-License-Identifier: MIT
// segment<T, N>: two points and all between them.
#pragma once

#include <irg/geometry/box.hpp>
#include <irg/geometry/parametric_line.hpp>

namespace irg {

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
[[nodiscard]] constexpr box<T, N> enclosing_box(const segment<T, N>& s) noexcept {
  return enclosing_box(enclosing_box(box<T, N>{}, s.a), s.b);
}

/// The segment from b to a.
template <class T, int N>
[[nodiscard]] constexpr segment<T, N> reversed(const segment<T, N>& s) noexcept {
  return {s.b, s.a};
}

}  // namespace IRG_ABI
}  // namespace irg
