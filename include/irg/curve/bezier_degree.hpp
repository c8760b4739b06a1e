// SPDX-License-Identifier: MIT
// Bezier curves of another degree: the derivative as a curve of its own, degree elevation and degree reduction.
#pragma once

#include <cstddef>
#include <span>

#include <irg/curve/bezier.hpp>
#include <irg/math/length.hpp>

namespace irg::inline IRG_ABI {

/// The control vectors of the derivative (hodograph), a Bezier curve of one degree less; again for the second one.
/// shape   vectors[i] is the degree times the difference of points i + 1 and i; a single point has one vector, zero
/// needs   one control point or more; vectors as long as points but for one, and at least 1
/// exact   a difference and a product, each rounded once
/// source  Farin 2002, 5.3
template <ControlPoints R>
constexpr void bezier_derivative(const R& points,
                                 std::span<typename curve_sample<control_point<R>>::vector> vectors) noexcept {
  const std::size_t n = ring_traits<R>::size(points) - 1;
  IRG_EXPECTS(ring_traits<R>::size(points) > 0 && vectors.size() >= (n > 0 ? n : 1));
  if (n == 0) vectors[0] = zero_coordinates<typename curve_sample<control_point<R>>::vector>();
  for (std::size_t k = 0; k < n; ++k)
    vectors[k] = detail::scaled_difference(ring_traits<R>::vertex(points, k), ring_traits<R>::vertex(points, k + 1),
                                           static_cast<int>(n));
}

/// Control points of the same curve with one degree more.
/// needs   elevated longer than points by one
/// exact   ends bit for bit; each other point is one blend of two, within 3u of the larger
/// source  Farin 2002, 6.1
template <ControlPoints R>
constexpr void bezier_elevate(const R& points, std::span<control_point<R>> elevated) noexcept {
  using T = scalar_of<control_point<R>>;
  const std::size_t count = ring_traits<R>::size(points);
  IRG_EXPECTS(count > 0 && elevated.size() > count);
  for (std::size_t k = 0; k <= count; ++k) {
    const auto share = curve_fraction<T>(static_cast<int>(k), static_cast<int>(count));
    elevated[k] = detail::blend(ring_traits<R>::vertex(points, k < count ? k : count - 1),
                                ring_traits<R>::vertex(points, k > 0 ? k - 1 : 0), share);
  }
}

/// Control points of a curve with one degree less that is near the curve; the curve itself where that is possible.
/// needs   two control points or more; reduced shorter than points by one
/// gives   no point of the new curve is farther from the old one's at the same t than this; up to rounding 0 where the
///         degree had been elevated
/// exact   both ends bit for bit from degree 2 on; of degree 1, the middle
/// source  Forrest 1972: from either end to the middle
template <ControlPoints R>
  requires CartesianPoint<control_point<R>> && Floating<scalar_of<control_point<R>>>
constexpr scalar_of<control_point<R>> bezier_reduce(const R& points, std::span<control_point<R>> reduced) noexcept {
  using P = control_point<R>;
  using T = scalar_of<P>;
  const std::size_t n = ring_traits<R>::size(points) - 1;
  IRG_EXPECTS(ring_traits<R>::size(points) > 1 && reduced.size() >= n);
  const auto b = [&](std::size_t k) { return ring_traits<R>::vertex(points, k); };
  const auto number = [](std::size_t k) { return static_cast<T>(static_cast<int>(k)); };
  // Elevation read backwards: b_k = (k q_{k-1} + (n - k) q_k) / n.
  const auto without = [&](const P& whole, const P& known, T share, T left) {
    return generate_coordinates<P>([&](int i) {
      return (product(number(n), coordinate(whole, i)) - product(share, coordinate(known, i))) / left;
    });
  };
  const std::size_t half = n / 2;
  reduced[0] = b(0);
  for (std::size_t k = 1; k < half; ++k) reduced[k] = without(b(k), reduced[k - 1], number(k), number(n - k));
  reduced[n - 1] = b(n);
  for (std::size_t k = n - 1; k > n - half; --k) reduced[k - 1] = without(b(k), reduced[k], number(n - k), number(k));
  if (n % 2 == 1) {  // the two runs meet in one point
    const P from_left = n > 1 ? without(b(half), reduced[half - 1], number(half), number(half + 1)) : b(0);
    const P from_right = n > 1 ? without(b(half + 1), reduced[half + 1], number(half), number(half + 1)) : b(1);
    reduced[half] = detail::blend(from_left, from_right, curve_parameter<T>(T(1) / T(2)));
  }
  T farthest = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const P again = detail::blend(reduced[k < n ? k : n - 1], reduced[k > 0 ? k - 1 : 0],
                                  curve_fraction<T>(static_cast<int>(k), static_cast<int>(n)));
    farthest = maximum(farthest, length(detail::scaled_difference(again, b(k), 1)));
  }
  return farthest;
}

}  // namespace irg::inline IRG_ABI
