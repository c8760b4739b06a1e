// SPDX-License-Identifier: MIT
// The steps of frustum.hpp.
#pragma once

#include <limits>
#include <optional>

#include <irg/core/containment.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/view/projection.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

template <class T>
IRG_INLINE constexpr T coefficient_of(const plane<T>& p, int i) noexcept {
  return i == 0 ? p.a : i == 1 ? p.b : i == 2 ? p.c : p.d;
}

// The plane with its normal at length 1, and its weights on the same scale.
template <class T>
constexpr void normalise_frustum_plane(plane<T>& p, plane<T>& weight) noexcept {
  const T length_of_normal = length(normal_of(p));
  const auto over = [&](T x) { return quotient(x, length_of_normal); };
  if (T(0) < length_of_normal && is_finite(length_of_normal) && is_finite(p.d) && is_finite(over(p.d))) {
    p = {over(p.a), over(p.b), over(p.c), over(p.d)};
    weight = {over(weight.a), over(weight.b), over(weight.c), over(weight.d)};
  } else {
    const bool at_infinity = length_of_normal == T(0) && T(0) < p.d;
    p = {T(0), T(0), T(0), at_infinity ? T(1) : T(0)};
    weight = p;
  }
}

// What rounding may have moved the value of a plane by, for positions whose coordinates are at most `size`.
template <class T>
constexpr T frustum_margin(const plane<T>& weight, const point<T, 3>& size) noexcept {
  if constexpr (Floating<T>) {
    constexpr T u16 = T(8) * std::numeric_limits<T>::epsilon();
    const T sum = product(weight.a, size.x) + product(weight.b, size.y) + product(weight.c, size.z) + weight.d;
    return product(u16, sum) + (std::numeric_limits<T>::min)();
  } else {
    return T(0);
  }
}

// The position that three planes have in common, homogeneous; all zero when there is none or more than one.
template <class T>
constexpr hpoint<T, 3> common_position(const plane<T>& p, const plane<T>& q, const plane<T>& r) noexcept {
  const auto det = [&](int i, int j, int k) {
    const mat<T, 3, 3> m{{{coefficient_of(p, i), coefficient_of(p, j), coefficient_of(p, k)},
                          {coefficient_of(q, i), coefficient_of(q, j), coefficient_of(q, k)},
                          {coefficient_of(r, i), coefficient_of(r, j), coefficient_of(r, k)}}};
    return determinant(m);
  };
  return {det(1, 2, 3), T(0) - det(0, 2, 3), det(0, 1, 3), T(0) - det(0, 1, 2)};
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
