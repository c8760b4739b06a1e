// SPDX-License-Identifier: MIT
// What polynomials of points and vectors of the plane and of space share, and questions about what comes out of them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

/// The floating-point numbers that hold every T, where there are some: what the doors take numbers of type T as.
template <class T>
struct door_number {};
template <Floating T>
struct door_number<T> {
  using type = T;
};
template <std::integral T>
  requires(sizeof(T) <= 4)
struct door_number<T> {
  using type = double;
};
template <class T>
concept DoorNumber = requires { typename door_number<T>::type; };

inline namespace IRG_ABI {

/// A point of the same coordinates that has irg's operators.
template <class T, Point P>
IRG_INLINE constexpr point<T, size_of<P>> as_point(const P& p) noexcept {
  return generate_coordinates<point<T, size_of<P>>>([&](int i) { return coordinate(p, i); });
}

/// A point of the caller's type with the coordinates of one of irg's.
template <Point P, class T>
IRG_INLINE constexpr P own_point(const point<T, size_of<P>>& p) noexcept {
  if constexpr (std::is_same_v<P, point<T, size_of<P>>>)
    return p;
  else
    return generate_coordinates<P>([&](int i) { return p[i]; });
}

/// The point as the doors take it.
template <Point P>
  requires DoorNumber<scalar_of<P>>
IRG_INLINE constexpr auto door_point(const P& p) noexcept {
  return as_point<typename door_number<scalar_of<P>>::type>(p);
}

/// v . v, or x * x.
template <class N>
IRG_INLINE constexpr N squared(const N& x) noexcept {
  return x * x;
}
template <class N, int D>
IRG_INLINE constexpr N squared(const vec<N, D>& v) noexcept {
  return dot(v, v);
}

/// Whether all numbers are zero.
template <Scalar V>
IRG_INLINE constexpr bool is_zero(const V& x) noexcept {
  return sign_of(x) == 0;
}
template <Coordinates V>
IRG_INLINE constexpr bool is_zero(const V& v) noexcept {
  for (int i = 0; i < size_of<V>; ++i)
    if (sign_of(coordinate(v, i)) != 0) return false;
  return true;
}

/// Which coordinate has the largest magnitude, 0 to 2.
template <class V>
constexpr int largest_coordinate(const vec<V, 3>& v) noexcept {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (sign_of(v[i] * v[i] - v[k] * v[k]) > 0) k = i;
  return k;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
