// SPDX-License-Identifier: MIT
// Control nets of surfaces made of curves: turned about an axis, ruled between two curves, moved along a path. Knots of
// the curves are those of the surface, along u or v as said; rational curves take part as curves of hpoint.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/ring.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/curve_frame.hpp>
#include <irg/curve/rational.hpp>

namespace irg::inline IRG_ABI {

/// The net of the surface that a curve of (radius, height) sweeps when it turns once round the y axis, from x towards
/// -z (right-handed). 9 rows; the first 3, 5 or 7 are a quarter, a half or three quarters of it.
/// shape   along u circle_knots(), degree 2; along v the curve's own. Normals point outward where the height rises
/// needs   net for 9 times as many points as the curve has
/// exact   no coordinate is rounded: the surface of these control points is turned exactly. Points on the axis give
///         columns of one position: poles
/// source  Piegl and Tiller 1997, 8.5
template <Floating T>
constexpr void revolution_net(std::span<const hpoint<T, 2>> curve,
                              std::type_identity_t<std::span<hpoint<T, 3>>> net) noexcept {
  IRG_EXPECTS(net.size() >= 9 * curve.size());
  const auto circle = circle_points(point<T, 2>{T(0), T(0)}, T(1));  // coordinates 0, 1 and 2
  for (std::size_t i = 0; i < circle.size(); ++i)
    for (std::size_t j = 0; j < curve.size(); ++j) {
      const hpoint<T, 2>&c = circle[i], &p = curve[j];
      net[i * curve.size() + j] = {product(c[0], p[0]), product(c[2], p[1]), -product(c[1], p[0]), product(c[2], p[2])};
    }
}

/// The net of the surface of straight lines between two curves at equal parameters.
/// shape   along u the curves' knots; along v 0, 0, 1, 1, degree 1. 2 columns: the first curve is at v = 0
/// needs   curves of as many points over the same knots (bspline_refine and bspline_elevate make them so); net for both
/// exact   points are copied
/// source  Piegl and Tiller 1997, 8.4
template <CurvePoint P>
constexpr void ruled_net(std::span<const P> first, std::type_identity_t<std::span<const P>> second,
                         std::type_identity_t<std::span<P>> net) noexcept {
  IRG_EXPECTS(first.size() == second.size() && net.size() >= 2 * first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    net[2 * i] = first[i];
    net[2 * i + 1] = second[i];
  }
}

/// The net of the surface that a curve sweeps when it is moved along a path without turning: curve(u) + path(v).
/// shape   along u the curve's knots, along v those of the path
/// needs   net for as many points as the product of both numbers
/// exact   each coordinate is a product (by the weight, of hpoint only) and a sum, rounded once each
/// source  Piegl and Tiller 1997, 8.3
template <CurvePoint P, Vector V>
constexpr void translation_net(std::span<const P> curve, std::span<const V> path,
                               std::type_identity_t<std::span<P>> net) noexcept {
  IRG_EXPECTS(net.size() >= curve.size() * path.size());
  constexpr bool is_rational = coordinate_traits<P>::kind == coordinate_kind::homogeneous;
  constexpr int weight = size_of<P> - 1;
  for (std::size_t i = 0; i < curve.size(); ++i)
    for (std::size_t j = 0; j < path.size(); ++j)
      net[i * path.size() + j] = generate_coordinates<P>([&](int axis) {
        const auto from = coordinate(curve[i], axis);
        if constexpr (is_rational)
          return axis == weight ? from : from + product(coordinate(curve[i], weight), coordinate(path[j], axis));
        else
          return from + coordinate(path[j], axis);
      });
}

/// One row of a surface swept along a path with turning: a section in the plane of a frame, x along its normal and y
/// along its binormal.
/// shape   rows of successive frames (rotation_minimizing_frame) are points for bspline_interpolate along the path
/// needs   row as long as section
/// exact   two products and two sums, rounded once each; at section points (0, 0) the place bit for bit
/// source  Piegl and Tiller 1997, 10.4
template <Floating T>
constexpr void section_row(const curve_frame<vec<T, 3>>& frame, const std::type_identity_t<point<T, 3>>& place,
                           std::type_identity_t<std::span<const point<T, 2>>> section,
                           std::type_identity_t<std::span<point<T, 3>>> row) noexcept {
  IRG_EXPECTS(row.size() >= section.size());
  for (std::size_t k = 0; k < section.size(); ++k)
    row[k] = generate_coordinates<point<T, 3>>([&](int axis) {
      return place[axis] + (product(section[k].x, frame.normal[axis]) + product(section[k].y, frame.binormal[axis]));
    });
}

}  // namespace irg::inline IRG_ABI
