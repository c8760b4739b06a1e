// SPDX-License-Identifier: MIT
// Bezier curves that are asked for many points: control points multiplied by their binomials once, then Horner's scheme
// in t / (1 - t) or (1 - t) / t, whichever is at most 1. In registers: the coordinates of one point, or many points.
#pragma once

#include <bit>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/detail/bezier_prepared_kernel.hpp>

namespace irg {

/// A Bezier curve of points P ready for many points; it refers to your space, which prepare_bezier fills.
template <Coordinates P>
  requires Floating<scalar_of<P>>
struct prepared_bezier {
  /// Numbers that a control point takes: its coordinates, up to a power of two.
  static constexpr std::size_t width = std::bit_ceil(static_cast<std::size_t>(size_of<P>));
  std::span<const scalar_of<P>> rows{};
  [[nodiscard]] constexpr std::size_t degree() const noexcept { return rows.size() / width - 1; }
};

inline namespace IRG_ABI {

/// The curve of these control points, made ready in `space`.
/// needs   one or more control points; space for prepared_bezier<P>::width numbers for each
/// gives   nothing where a control point times its binomial is not finite, and for degrees over 900 (in floats 120)
/// exact   each number rounded once to degree 56, later the binomial too
template <ControlPoints R>
  requires Floating<scalar_of<detail::control_point<R>>>
constexpr std::optional<prepared_bezier<detail::control_point<R>>> prepare_bezier(
    const R& points, std::span<scalar_of<detail::control_point<R>>> space) noexcept {
  using P = detail::control_point<R>;
  using T = scalar_of<P>;
  constexpr std::size_t width = prepared_bezier<P>::width;
  const std::size_t count = ring_traits<R>::size(points);
  IRG_EXPECTS(count > 0 && space.size() >= width * count);
  if (count > (sizeof(T) == 4 ? 121u : 901u)) return std::nullopt;
  double binomial = 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0)  // whole numbers all along, up to 2^53
      binomial = product(binomial, static_cast<double>(static_cast<int>(count - i))) /
                 static_cast<double>(static_cast<int>(i));
    constexpr T most = (std::numeric_limits<T>::max)();
    if (!(binomial <= static_cast<double>(most))) return std::nullopt;
    const T times = static_cast<T>(binomial), limit = most / times;
    const P p = ring_traits<R>::vertex(points, i);
    for (std::size_t axis = 0; axis < width; ++axis) {
      const T c = axis < static_cast<std::size_t>(size_of<P>) ? coordinate(p, static_cast<int>(axis)) : T(0);
      if (!(c <= limit && c >= -limit)) return std::nullopt;
      space[i * width + axis] = product(c, times);
    }
  }
  return prepared_bezier<P>{space.first(width * count)};
}

/// The point of the curve at t.
/// needs   0 <= t <= 1; outside, the polynomial goes on while powers of t stay within the numbers
/// exact   the ends bit for bit; error for control points within 1, measured: 3 u at most to degree 30, 4 u at 50, in
///         the mean 0.35 u; bound (3 degree + 4) u of the largest. Where control points cancel, bezier_point keeps more
/// cost    degree products and sums for all coordinates together, a division
/// source  Schumaker and Volk 1986; irg's own: the power of the side that belongs to the rounded ratio, as if in twice
///         the precision
template <Coordinates P>
[[nodiscard]] constexpr P bezier_point(const prepared_bezier<P>& curve, std::type_identity_t<scalar_of<P>> t) noexcept {
  return detail::prepared_point<P>(curve, t);
}

/// The points of the curve at many places.
/// needs   as many points as places
/// exact   as one by one, bit for bit
/// cost    degree products and sums for each coordinate of several points together, where successive places are on one
///         side of 1/2; else as one by one
/// source  Schumaker and Volk 1986
template <Coordinates P>
constexpr void bezier_points(const prepared_bezier<P>& curve, std::type_identity_t<std::span<const scalar_of<P>>> t,
                             std::span<P> points) noexcept {
  IRG_EXPECTS(points.size() >= t.size());
  detail::prepared_points<P>(curve, t, points);
}

}  // namespace IRG_ABI
}  // namespace irg
