// SPDX-License-Identifier: MIT
// Bezier curves that are asked for many points: expanded once, in twice the precision, about places so near each other
// that a point takes two short polynomials of the distance from the nearest, and hardly rounds more than its result.
#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/detail/bezier_prepared_kernel.hpp>
#include <irg/math/double_double.hpp>

namespace irg {

/// A Bezier curve of points P ready for many points; it refers to your space, which prepare_bezier fills.
template <CurvePoint P>
  requires Floating<scalar_of<P>>
struct prepared_bezier {
  /// Numbers that a coefficient takes: a point's coordinates, up to a power of two.
  static constexpr std::size_t width = std::bit_ceil(static_cast<std::size_t>(size_of<P>));
  std::span<const scalar_of<P>> rows{};  // an expansion each: row_length / width coefficients
  std::size_t count = 1, pieces = 1, row_length = 4 * width;

  [[nodiscard]] IRG_APART constexpr std::size_t degree() const noexcept { return count - 1; }
  /// The space that a curve of so many control points takes.
  [[nodiscard]] IRG_APART static constexpr std::size_t numbers_for(std::size_t count) noexcept {
    return (std::bit_ceil(count) + 1) * detail::expansion_size<scalar_of<P>>(count) * width;
  }
};

inline namespace IRG_ABI {

/// The curve of these control points, made ready in `space`.
/// needs   one or more control points; space for prepared_bezier<P>::numbers_for(count) numbers; scratch as long as
///         points, its contents are lost
/// gives   nothing where a coordinate or a difference of control points is not finite or over 2^989 (in floats 2^93)
/// exact   each coefficient to about one rounding, unless something underflows
/// cost    degree^2 compensated steps a coordinate for each of bit_ceil(degree + 1) + 1 places: as much as some 80
///         points without preparation at degree 3, 400 at degrees 10 to 50
/// source  Farin 2002 (control points of a part, their differences); Jiang, Li, Cheng and Su 2010
template <ControlPoints R>
  requires Floating<scalar_of<detail::control_point<R>>>
constexpr std::optional<prepared_bezier<detail::control_point<R>>> prepare_bezier(
    const R& points, std::span<scalar_of<detail::control_point<R>>> space,
    std::type_identity_t<std::span<exact_sum<scalar_of<detail::control_point<R>>>>> scratch) noexcept {
  using P = detail::control_point<R>;
  using T = scalar_of<P>;
  using curve = prepared_bezier<P>;
  const std::size_t count = ring_traits<R>::size(points), pieces = std::bit_ceil(count);
  IRG_EXPECTS(count > 0 && space.size() >= curve::numbers_for(count) && scratch.size() >= count);
  const curve result{space.first(curve::numbers_for(count)), count, pieces,
                     detail::expansion_size<T>(count) * curve::width};
  for (T& number : space.first(result.rows.size())) number = T(0);
  for (std::size_t node = 0; node <= pieces; ++node)
    for (int axis = 0; axis < static_cast<int>(size_of<P>); ++axis) {
      const auto row = space.subspan(node * result.row_length + static_cast<std::size_t>(axis));
      const bool made = detail::put_expansion(
          node, pieces, scratch.first(count),
          [&](std::size_t k) { return coordinate(ring_traits<R>::vertex(points, k), axis); },
          [&](std::size_t i, const T& c) { row[i * curve::width] = c; });
      if (!made) return std::nullopt;
    }
  return result;
}

/// The point of the curve at t.
/// needs   0 <= t <= 1; outside, the polynomial goes on to degree 19 (in floats 11)
/// exact   the ends bit for bit; error for control points within 1, measured: 3 u at most to degree 50, in the mean
///         0.15 u; bound (3 degree + 4) u, and 15 u, of the largest
/// cost    a product and a sum for each of min(degree + 1, 20) coefficients (in floats 12), all coordinates together
/// source  Dorn 1962
template <CurvePoint P>
[[nodiscard]] constexpr P bezier_point(const prepared_bezier<P>& curve, std::type_identity_t<scalar_of<P>> t) noexcept {
  return detail::prepared_point<P>(curve, t);
}

/// The points of the curve at many places.
/// needs   as many points as places
/// exact   as one by one, bit for bit
/// cost    half of it or less where successive places are in order
template <CurvePoint P>
constexpr void bezier_points(const prepared_bezier<P>& curve, std::type_identity_t<std::span<const scalar_of<P>>> t,
                             std::span<P> points) noexcept {
  IRG_EXPECTS(points.size() >= t.size());
  detail::prepared_points<P>(curve, t, points);
}

}  // namespace IRG_ABI
}  // namespace irg
