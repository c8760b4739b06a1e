// SPDX-License-Identifier: MIT
// Rational curves are curves of homogeneous points: every algorithm for Bezier and B-spline curves of hpoint (points,
// splits, knots, degrees) is that of rational ones. Here is what homogeneous coordinates do not give by themselves:
// derivatives, and the circles and conics, whose control points are exact.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/homogeneous.hpp>

namespace irg {

/// The curve of three control points and a weight: which conic it is a piece of. A weight that is negative gives the
/// piece that is missing.
enum class conic_kind { line, ellipse, parabola, hyperbola };

inline namespace IRG_ABI {

/// The derivatives of a rational curve from those of its homogeneous points: derivatives[k] is the k-th, and
/// derivatives[0] the point's own coordinates.
/// needs   homogeneous[k] for k < derivatives.size(), as bspline_derivatives or repeated bezier_derivative gives them
/// gives   false, and nothing written, where the weight is 0 or not finite
/// exact   Leibniz's rule for x = w * c, solved for c: each product, difference and quotient rounded once
/// cost    k products for the k-th
/// source  Piegl and Tiller 1997, A4.2
template <Floating T, int N>
constexpr bool rational_derivatives(std::span<const hpoint<T, N>> homogeneous,
                                    std::span<vec<T, N>> derivatives) noexcept {
  IRG_EXPECTS(homogeneous.size() >= derivatives.size());
  if (derivatives.empty()) return true;
  const T weight = coordinate(homogeneous[0], N);
  if (weight == T(0) || !is_finite(weight)) return false;
  for (std::size_t k = 0; k < derivatives.size(); ++k)
    derivatives[k] = generate_coordinates<vec<T, N>>([&](int axis) {
      T rest = coordinate(homogeneous[k], axis), binomial = 1;
      for (std::size_t i = 1; i <= k; ++i) {
        binomial = product(binomial, static_cast<T>(static_cast<int>(k + 1 - i))) / static_cast<T>(static_cast<int>(i));
        const T factor = product(binomial, coordinate(homogeneous[i], N));
        if (factor != T(0)) rest = rest - product(factor, coordinate(derivatives[k - i], axis));
      }
      return rest / weight;
    });
  return true;
}

/// The three homogeneous control points of the conic from `begin` to `end` whose tangents there meet in `corner`; the
/// greater the weight, the nearer it runs to the corner.
/// gives   with the cosine of half the angle it spans: an arc of a circle, where the corner is as far from both ends
/// exact   begin and end as they are, the corner's coordinates times the weight rounded once each
/// source  Farin 2002, 12.2
template <Scalar T, int N>
[[nodiscard]] constexpr std::array<hpoint<T, N>, 3> conic_arc(const point<T, N>& begin,
                                                              const std::type_identity_t<point<T, N>>& corner,
                                                              const std::type_identity_t<point<T, N>>& end,
                                                              const std::type_identity_t<T>& weight) noexcept {
  const auto weighted = [&](const point<T, N>& p, const T& w) {
    return generate_coordinates<hpoint<T, N>>([&](int axis) { return axis < N ? product(coordinate(p, axis), w) : w; });
  };
  return {to_homogeneous(begin, T(1)), weighted(corner, weight), to_homogeneous(end, T(1))};
}

/// Which conic conic_arc gives at this weight, for points that are not on one line.
/// exact   by comparison
/// source  Farin 2002, 12.5
template <Scalar T>
[[nodiscard]] constexpr conic_kind conic_kind_of(const T& weight) noexcept {
  const T size = weight < T(0) ? -weight : weight;
  if (size == T(0)) return conic_kind::line;
  if (size == T(1)) return conic_kind::parabola;
  return size < T(1) ? conic_kind::ellipse : conic_kind::hyperbola;
}

/// The knots of circle_points: four quarters of degree 2, from 0 to 4.
template <Scalar T>
[[nodiscard]] constexpr std::array<T, 12> circle_knots() noexcept {
  return {T(0), T(0), T(0), T(1), T(1), T(2), T(2), T(3), T(3), T(4), T(4), T(4)};
}

/// The control points of a circle, counter-clockwise from its rightmost point, as a B-spline of degree 2 over
/// circle_knots(). Its weights are 1 and 2: no root is rounded.
/// needs   a radius that is not negative; 0 gives the centre all over
/// exact   the curve of these control points is a circle exactly where they are exact themselves (integers and floats
///         that sums and doubling do not round); otherwise each coordinate is off by two roundings at most
/// source  Piegl and Tiller 1997, 7.5
template <Scalar T>
[[nodiscard]] constexpr std::array<hpoint<T, 2>, 9> circle_points(const point<T, 2>& centre,
                                                                  const std::type_identity_t<T>& radius) noexcept {
  const T x = centre.x, y = centre.y, east = x + radius, west = x - radius, north = y + radius, south = y - radius;
  return {hpoint<T, 2>{east, y, T(1)},  {east, north, T(1)}, {x + x, north + north, T(2)},
          {west, north, T(1)},          {west, y, T(1)},     {west, south, T(1)},
          {x + x, south + south, T(2)}, {east, south, T(1)}, {east, y, T(1)}};
}

}  // namespace IRG_ABI
}  // namespace irg
