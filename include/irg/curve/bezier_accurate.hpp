// SPDX-License-Identifier: MIT
// Bezier curves by the compensated de Casteljau algorithm: each step's rounding error is kept and carried along by the
// same steps, so that the point is as good as if it had been computed in twice the precision and rounded once.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <irg/curve/bezier.hpp>
#include <irg/math/error_free.hpp>

namespace irg::detail::inline IRG_ABI {

/// A parameter t and 1 - t in two parts.
template <Floating T>
struct split_parameter {
  T t;
  exact_sum<T> rest;
};

/// One step for one coordinate: the error of rest*a + t*b, those of a and b blended and the step's own.
template <Floating T>
IRG_INLINE constexpr exact_sum<T> compensated_blend(const exact_sum<T>& a, const exact_sum<T>& b,
                                                    const split_parameter<T>& at) noexcept {
  const exact_sum<T> from_a = two_product(at.rest.value, a.value), from_b = two_product(at.t, b.value);
  const exact_sum<T> sum = two_sum(from_a.value, from_b.value);
  const T made = (from_a.error + from_b.error) + (sum.error + product(at.rest.error, a.value));
  return {sum.value, made + (product(at.rest.value, a.error) + product(at.t, b.error))};
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// The point of the Bezier curve at t, as if computed in twice the precision.
/// needs   one or more finite control points, 0 <= t <= 1; scratch as long as points, its contents are lost
/// exact   the ends bit for bit; each coordinate's relative error at most u + 5 n^2 u^2 c, where c is the condition,
///         the sum of |b_i| B_i(t) over the size of the result, unless something underflows
/// cost    n*(n + 1)/2 steps a coordinate, each some 5 times (without fused multiply-add 12 times) a blend
/// source  Jiang, Li, Cheng and Su 2010; Hermes 2019
template <ControlPoints R>
  requires Floating<scalar_of<control_point<R>>>
constexpr control_point<R> bezier_point_accurate(const R& points, scalar_of<control_point<R>> t,
                                                 std::span<exact_sum<scalar_of<control_point<R>>>> scratch) noexcept {
  using T = scalar_of<control_point<R>>;
  const std::size_t count = ring_traits<R>::size(points);
  IRG_EXPECTS(count > 0 && scratch.size() >= count);
  if (t == T(0)) return ring_traits<R>::vertex(points, 0);
  if (t == T(1)) return ring_traits<R>::vertex(points, count - 1);
  const detail::split_parameter<T> at{t, two_sum(T(1), -t)};
  return generate_coordinates<control_point<R>>([&](int axis) {
    for (std::size_t k = 0; k < count; ++k) scratch[k] = {coordinate(ring_traits<R>::vertex(points, k), axis), T(0)};
    for (std::size_t n = count; n > 1; --n)
      for (std::size_t k = 0; k + 1 < n; ++k) scratch[k] = detail::compensated_blend(scratch[k], scratch[k + 1], at);
    return scratch[0].value + scratch[0].error;
  });
}

/// The point of the Bezier curve at t, as if computed in twice the precision, for control points whose number is part
/// of the type.
/// exact   as the form with scratch
template <FixedControlPoints R>
  requires Floating<scalar_of<control_point<R>>>
[[nodiscard]] constexpr control_point<R> bezier_point_accurate(const R& points,
                                                               scalar_of<control_point<R>> t) noexcept {
  std::array<exact_sum<scalar_of<control_point<R>>>, detail::fixed_size<R>()> scratch{};
  return bezier_point_accurate(points, t, scratch);
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, WorkspaceFor<R> W = detail::own_workspace<R, !FixedControlPoints<R>>>
  requires Floating<scalar_of<control_point<R>>>
[[nodiscard]] constexpr control_point<R> bezier_point_accurate(const R& points, scalar_of<control_point<R>> t,
                                                               W&& memory = W{}) {
  return bezier_point_accurate(points, t, detail::room_for(memory.sums, points));
}

}  // namespace irg::inline IRG_ABI
