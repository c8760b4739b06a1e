// SPDX-License-Identifier: MIT
// Planes a*x + b*y + c*z + d = 0 of any type. The one customisation point is plane_traits<T>; it fits types with
// members a, b, c and d, and types with four coordinates (Eigen::Vector4d, std::array<float, 4>).
#pragma once

#include <irg/core/coordinates.hpp>

namespace irg {

namespace detail {
template <class T>
concept has_abcd = requires(const T& p) {
  requires Number<std::remove_cvref_t<decltype(p.a)>>;
  requires std::same_as<std::remove_cvref_t<decltype(p.a)>, std::remove_cvref_t<decltype(p.b)>>;
  requires std::same_as<std::remove_cvref_t<decltype(p.a)>, std::remove_cvref_t<decltype(p.c)>>;
  requires std::same_as<std::remove_cvref_t<decltype(p.a)>, std::remove_cvref_t<decltype(p.d)>>;
};
}  // namespace detail

/// How irg reads a plane. Members: scalar, coefficient(p, i) for a, b, c, d as i = 0..3.
template <class T>
struct plane_traits {};

template <detail::has_abcd T>
struct plane_traits<T> {
  using scalar = std::remove_cvref_t<decltype(std::declval<const T&>().a)>;
  IRG_INLINE static constexpr scalar coefficient(const T& p,
                                                 int i) noexcept(std::is_nothrow_copy_constructible_v<scalar>) {
    return i == 0 ? p.a : i == 1 ? p.b : i == 2 ? p.c : p.d;
  }
};

template <Coordinates T>
  requires(!detail::has_abcd<T> && coordinate_traits<T>::size == 4 &&
           coordinate_traits<T>::kind == coordinate_kind::any)
struct plane_traits<T> {
  using scalar = scalar_of<T>;
  IRG_INLINE static constexpr scalar coefficient(const T& p, int i) noexcept(noexcept(coordinate(p, i))) {
    return coordinate(p, i);
  }
};

/// A plane with readable coefficients. Models: plane, a struct with a, b, c and d, an Eigen::Vector4d.
template <class T>
concept Plane = requires(const T& p) {
  requires Number<typename plane_traits<T>::scalar>;
  { plane_traits<T>::coefficient(p, 0) } -> std::convertible_to<typename plane_traits<T>::scalar>;
};

/// The number type of a plane's coefficients.
template <Plane T>
using plane_scalar = typename plane_traits<T>::scalar;

inline namespace IRG_ABI {

/// Coefficient a, b, c or d of a plane, for i = 0 to 3.
/// needs   0 <= i < 4
template <Plane P>
[[nodiscard]] IRG_INLINE constexpr plane_scalar<P> plane_coefficient(const P& p, int i) noexcept(
    noexcept(plane_traits<P>::coefficient(p, i))) {
  return plane_traits<P>::coefficient(p, i);
}

}  // namespace IRG_ABI
}  // namespace irg
