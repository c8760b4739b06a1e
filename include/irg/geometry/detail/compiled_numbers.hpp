// SPDX-License-Identifier: MIT
// What irg::compiled takes points of any type as: irg's own, of floats or doubles.
#pragma once

#include <concepts>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

/// The floating-point numbers that hold every T, where there are some: what irg::compiled takes numbers of type T as.
template <class T>
struct library_number {};
template <Floating T>
struct library_number<T> {
  using type = T;
};
template <std::integral T>
  requires(sizeof(T) <= 4)
struct library_number<T> {
  using type = double;
};
template <class T>
concept CompiledNumber = requires { typename library_number<T>::type; };

/// That type, or T itself where there is none.
template <class T>
struct library_number_or {
  using type = T;
};
template <CompiledNumber T>
struct library_number_or<T> : library_number<T> {};

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

/// The point as irg::compiled takes it.
template <Point P>
  requires CompiledNumber<scalar_of<P>>
IRG_INLINE constexpr auto library_point(const P& p) noexcept {
  return as_point<typename library_number<scalar_of<P>>::type>(p);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
