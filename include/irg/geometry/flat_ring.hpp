// SPDX-License-Identifier: MIT
// A polygon in space, seen along an axis: the ring without one of its coordinates, and the axis along which it looks
// largest.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>

#include <irg/core/contract.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A ring in space, read without coordinate `axis`: y z, z x or x y, so that it runs counter-clockwise when its normal
/// points forward along the axis. It refers to the ring.
template <SpaceRing R>
class flat_ring {
public:
  using scalar = ring_scalar<R>;
  /// needs   0 <= axis < 3; a ring that outlives the view
  IRG_INLINE constexpr flat_ring(const R& ring, int axis) noexcept : ring_(&ring), axis_(axis) {
    IRG_EXPECTS(axis >= 0 && axis < 3);
  }
  flat_ring(const R&& ring, int axis) = delete;
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return ring_size(*ring_); }
  /// needs   i < size()
  IRG_INLINE constexpr point<scalar, 2> operator[](std::size_t i) const noexcept {
    const auto p = ring_vertex(*ring_, i);
    return {coordinate(p, axis_ == 2 ? 0 : axis_ + 1), coordinate(p, axis_ == 0 ? 2 : axis_ - 1)};
  }

private:
  const R* ring_;
  int axis_;
};

namespace detail {

template <Scalar T>
struct ring_areas {
  T along[3];
};

inline namespace IRG_ABI {

// Twice the areas that a ring shows along the axes, times a power of two of their own.
template <SpaceRing R>
constexpr ring_areas<ring_scalar<R>> areas_along_axes(const R& ring) noexcept {
  using T = ring_scalar<R>;
  const std::size_t n = ring_size(ring);
  T scale(1);  // a power of two that keeps products from overflow and underflow
  if constexpr (Floating<T>) {
    constexpr bool is_double = std::same_as<T, double>;
    T largest(0);
    for (std::size_t i = 0; i < n; ++i) {
      const auto p = ring_vertex(ring, i);
      for (int k = 0; k < 3; ++k)
        largest = maximum(largest, coordinate(p, k) < T(0) ? -coordinate(p, k) : coordinate(p, k));
    }
    if constexpr (is_double)
      scale = largest > 0x1p450 ? 0x1p-600 : largest < 0x1p-450 ? 0x1p600 : 1.0;
    else
      scale = largest > 0x1p55f ? 0x1p-75f : largest < 0x1p-55f ? 0x1p75f : 1.0f;
  }
  T area[3] = {T(0), T(0), T(0)};
  const auto from_first = [&](std::size_t i, int k) {
    return product(coordinate(ring_vertex(ring, i), k), scale) - product(coordinate(ring_vertex(ring, 0), k), scale);
  };
  for (std::size_t i = 1; i + 1 < n; ++i)
    for (int k = 0; k < 3; ++k) {
      const int u = k == 2 ? 0 : k + 1, v = k == 0 ? 2 : k - 1;
      area[k] =
          area[k] + (product(from_first(i, u), from_first(i + 1, v)) - product(from_first(i, v), from_first(i + 1, u)));
    }
  for (T& a : area) a = a < T(0) ? -a : a;
  return {{area[0], area[1], area[2]}};
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The axis (0, 1 or 2 for x, y or z) along which a polygon in space looks largest: that of the longest coordinate of
/// its Newell normal; the lowest one of equal ones. Without this coordinate it is a ring in the plane.
/// gives   nothing for a ring without area
/// exact   in integers and rationals; in floats the normal is rounded, so that another axis may come out where two
///         areas are nearly equal, and any or none for areas that are lost in rounding
/// cost    one pass; doubles a second one, against overflow
template <SpaceRing R>
[[nodiscard]] constexpr std::optional<int> dropped_axis(const R& ring) noexcept {
  using T = ring_scalar<R>;
  const auto area = detail::areas_along_axes(ring);
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (area.along[widest] < area.along[axis]) widest = axis;
  return T(0) < area.along[widest] ? std::optional(widest) : std::nullopt;
}

/// The old form of dropped_axis: z before x and y of equal ones, and z for a ring without area.
template <SpaceRing R>
[[nodiscard, deprecated("irg: use dropped_axis, which gives nothing for a ring without area")]] constexpr int
flattening_axis(const R& ring) noexcept {
  const auto area = detail::areas_along_axes(ring);
  const int x_or_y = area.along[0] < area.along[1] ? 1 : 0;
  return area.along[2] < area.along[x_or_y] ? x_or_y : 2;
}

}  // namespace IRG_ABI
}  // namespace irg
