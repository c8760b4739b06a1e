// SPDX-License-Identifier: MIT
// Derivatives of basis functions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/bspline.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The point at t that `local`, the control points of degree local.size() - 1 in the stretch from knot low on, lead to;
// their values are lost.
template <Floating T, int Degree, Coordinates P>
constexpr P de_boor_in_stretch(const bspline_knots<T, Degree>& knots, std::size_t low, T t,
                               std::span<P> local) noexcept {
  const std::size_t degree = local.size() - 1;
  for (std::size_t r = 1; r <= degree; ++r)
    for (std::size_t i = degree; i >= r; --i)
      local[i] = blend(local[i - 1], local[i], share_of_stretch<T>(knots[low - degree + i], knots[low + 1 + i - r], t));
  return local[degree];
}

// The derivatives at t of the curve that `local` controls in the stretch from knot low on; local and work are lost.
template <Floating T, int Degree, Coordinates V>
constexpr void derivatives_in_stretch(const bspline_knots<T, Degree>& knots, std::size_t low, T t,
                                      std::span<V> derivatives, std::span<V> local_and_work) noexcept {
  const std::size_t order = knots.order();
  const auto local = local_and_work.first(order), work = local_and_work.subspan(order, order);
  for (std::size_t k = 0; k < derivatives.size(); ++k) {
    if (k >= order) {
      derivatives[k] = zero_coordinates<V>();
      continue;
    }
    const std::size_t degree = order - 1 - k;  // of this derivative; its control points are local[0 ... degree]
    for (std::size_t i = 0; i <= degree; ++i) work[i] = local[i];
    derivatives[k] = de_boor_in_stretch(knots, low, t, work.first(degree + 1));
    for (std::size_t i = 0; i < degree; ++i) {
      const T stretch = knots[low + 1 + i] - knots[low + 1 + i - degree];
      local[i] = generate_coordinates<V>([&](int axis) {
        const T difference = coordinate(local[i + 1], axis) - coordinate(local[i], axis);
        return product(difference / stretch, static_cast<T>(static_cast<int>(degree)));
      });
    }
  }
}

// A point as the vector from the origin; homogeneous points as they are.
template <Coordinates P>
constexpr typename curve_sample<P>::vector as_vector(const P& p) noexcept {
  return generate_coordinates<typename curve_sample<P>::vector>([&](int axis) { return coordinate(p, axis); });
}

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
