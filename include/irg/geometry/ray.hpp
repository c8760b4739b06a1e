// SPDX-License-Identifier: MIT
// ray<T, N>: a part of a half-line.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

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

  /// Whether the ray has no points.
  // From the bits of all numbers at once: comparisons with branches would cost more than a ray's way through a tree.
  [[nodiscard]] IRG_INLINE constexpr bool empty() const noexcept {
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr bits exponent = std::bit_cast<bits>(std::numeric_limits<T>::infinity());
    constexpr bits one = exponent & ~(exponent << 1), sign = ~(~bits{0} >> 1);
    bits beyond = 0, moves = 0;
    for (int i = 0; i < N; ++i) {
      const auto o = std::bit_cast<bits>(origin[i]), d = std::bit_cast<bits>(direction[i]);
      beyond |= ((o & exponent) + one) | ((d & exponent) + one);
      moves |= d & ~sign;
    }
    const bool in_order = low <= (std::numeric_limits<T>::max)() && maximum(low, T(0)) <= high;
    return (beyond & sign) != 0 || moves == 0 || !in_order;
  }
  bool operator==(const ray&) const = default;
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

}  // namespace IRG_ABI
}  // namespace irg
