// SPDX-License-Identifier: MIT
// ray<T, N>: a part of a half-line.
#pragma once

#include <limits>

#include <irg/geometry/parametric_line.hpp>

namespace irg {

/// The points origin + t*direction with low <= t <= high: t counts in lengths of the direction, which may have any.
/// shape   nothing where the direction is zero, a number is NaN or infinite (but for high), or high < low; low counts
///         as 0 where it is negative
template <Floating T, int N>
struct ray {
  point<T, N> origin{};
  vec<T, N> direction{};
  T low = T(0), high = std::numeric_limits<T>::infinity();
  constexpr bool operator==(const ray&) const = default;
};

inline namespace IRG_ABI {

/// The ray from a to b: b is at t = 1, where it ends.
/// exact   the direction b - a is rounded once
template <Floating T, int N>
[[nodiscard]] constexpr ray<T, N> ray_between(const point<T, N>& a, const point<T, N>& b) noexcept {
  return {a, b - a, T(0), T(1)};
}

/// The point at t.
/// exact   product and sum rounded once each
template <Floating T, int N>
[[nodiscard]] constexpr point<T, N> point_at(const ray<T, N>& r, std::type_identity_t<T> t) noexcept {
  return r.origin + r.direction * t;
}

/// Whether the ray has points.
template <Floating T, int N>
[[nodiscard]] constexpr bool is_empty(const ray<T, N>& r) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)();
  const auto is_number = [](T x) { return (unsigned{-most <= x} & unsigned{x <= most}) != 0; };
  // All is asked at once: branches would cost more.
  unsigned finite = r.low <= most, moves = 0;
  for (int i = 0; i < N; ++i) {
    finite &= unsigned{is_number(r.origin[i])} & unsigned{is_number(r.direction[i])};
    moves |= unsigned{r.direction[i] < T(0)} | unsigned{T(0) < r.direction[i]};
  }
  return (finite & moves & unsigned{greater(r.low, T(0)) <= r.high}) == 0;
}

}  // namespace IRG_ABI
}  // namespace irg
