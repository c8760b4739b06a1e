// SPDX-License-Identifier: MIT
// De Boor's algorithm, and the derivatives of B-spline curves: within one stretch of knots the differences of a
// spline's control points, each over the knots it spans, control its derivative. Only the degree + 1 points that count
// at a place are touched, so that knots of any multiplicity divide nothing by zero.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/bspline.hpp>

namespace irg::detail::inline IRG_ABI {

// How many rows of as many vectors as knots.order() bspline_derivatives works in.
inline constexpr std::size_t derivative_rows = 2;

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// The point of a B-spline curve at t, by blends of two points at a time.
/// needs   as many control points as knots.size(); scratch for knots.order() points, its contents are lost
/// gives   nothing for NaN and for t outside of the knots' range
/// exact   each blend within the box of its two points up to rounding; an end point of full multiplicity is the
///         control point, bit for bit. Within 3 * degree * u of the largest control point that counts
/// cost    degree (degree + 1) / 2 blends of points. Where control points cancel each other the result keeps digits
///         that bspline_point loses; of degree 20 and more bspline_point is the faster
/// source  de Boor 1972
template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<ring_point<R>> bspline_point_de_boor(const bspline_knots<T, Degree>& knots, const R& points,
                                                             std::type_identity_t<T> t,
                                                             std::span<ring_point<R>> scratch) noexcept;

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int Degree, ControlPolygon R, WorkspaceFor<R> W = workspace_for<R>>
[[nodiscard]] constexpr std::optional<ring_point<R>> bspline_point_de_boor(const bspline_knots<T, Degree>& knots,
                                                                           const R& points, std::type_identity_t<T> t,
                                                                           W&& memory = W{}) {
  return bspline_point_de_boor(knots, points, t, detail::room_for(memory.points, knots.order()));
}

/// The point of a B-spline curve and its derivatives at t: derivatives[k] is the k-th, derivatives[0] the point's
/// own coordinates.
/// needs   as many control points as knots.size(); scratch for 2 * knots.order() vectors, its contents are lost
/// gives   false, and nothing written, for NaN and for t outside of the knots' range. Beyond the degree zeros. At a
///         knot the derivatives behind it, at last() those before it. Where a difference over its stretch passes the
///         largest number, no finite vectors
/// exact   differences, quotients and products rounded once each, then blends as in bspline_point_de_boor
/// cost    degree^2 / 2 blends for each derivative
/// source  de Boor 1972; Piegl and Tiller 1997, 3.3
template <Floating T, int Degree, ControlPolygon R>
constexpr bool bspline_derivatives(const bspline_knots<T, Degree>& knots, const R& points, std::type_identity_t<T> t,
                                   std::span<typename curve_sample<ring_point<R>>::vector> derivatives,
                                   std::span<typename curve_sample<ring_point<R>>::vector> scratch) noexcept;

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int Degree, ControlPolygon R, WorkspaceFor<R> W = workspace_for<R>>
constexpr bool bspline_derivatives(const bspline_knots<T, Degree>& knots, const R& points, std::type_identity_t<T> t,
                                   std::span<typename curve_sample<ring_point<R>>::vector> derivatives,
                                   W&& memory = W{}) {
  return bspline_derivatives(knots, points, t, derivatives,
                             detail::room_for(memory.vectors, detail::derivative_rows * knots.order()));
}

/// The point of a B-spline curve at t and its derivative there.
/// needs   as bspline_derivatives
/// gives   nothing for NaN and for t outside of the knots' range
/// exact   as bspline_derivatives
template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<curve_sample<ring_point<R>>> bspline_sample(
    const bspline_knots<T, Degree>& knots, const R& points, std::type_identity_t<T> t,
    std::span<typename curve_sample<ring_point<R>>::vector> scratch) noexcept;

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int Degree, ControlPolygon R, WorkspaceFor<R> W = workspace_for<R>>
[[nodiscard]] constexpr std::optional<curve_sample<ring_point<R>>> bspline_sample(const bspline_knots<T, Degree>& knots,
                                                                                  const R& points,
                                                                                  std::type_identity_t<T> t,
                                                                                  W&& memory = W{}) {
  return bspline_sample(knots, points, t, detail::room_for(memory.vectors, detail::derivative_rows * knots.order()));
}

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

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

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<ring_point<R>> bspline_point_de_boor(const bspline_knots<T, Degree>& knots, const R& points,
                                                             std::type_identity_t<T> t,
                                                             std::span<ring_point<R>> scratch) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size() && scratch.size() >= knots.order());
  if (!(knots.first() <= t && t <= knots.last())) return std::nullopt;
  const std::size_t low = detail::bspline_stretch(knots, t), first = low + 1 - knots.order();
  for (std::size_t i = 0; i < knots.order(); ++i) scratch[i] = ring_vertex(points, first + i);
  return detail::de_boor_in_stretch(knots, low, t, scratch.first(knots.order()));
}

template <Floating T, int Degree, ControlPolygon R>
constexpr bool bspline_derivatives(const bspline_knots<T, Degree>& knots, const R& points, std::type_identity_t<T> t,
                                   std::span<typename curve_sample<ring_point<R>>::vector> derivatives,
                                   std::span<typename curve_sample<ring_point<R>>::vector> scratch) noexcept {
  const std::size_t order = knots.order(), room = detail::derivative_rows * order;
  IRG_EXPECTS(ring_size(points) == knots.size() && scratch.size() >= room);
  if (!(knots.first() <= t && t <= knots.last())) return false;
  const std::size_t low = detail::bspline_stretch(knots, t);
  for (std::size_t i = 0; i < order; ++i) scratch[i] = detail::as_vector(ring_vertex(points, low + 1 - order + i));
  detail::derivatives_in_stretch(knots, low, static_cast<T>(t), derivatives, scratch.first(room));
  return true;
}

template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<curve_sample<ring_point<R>>> bspline_sample(
    const bspline_knots<T, Degree>& knots, const R& points, std::type_identity_t<T> t,
    std::span<typename curve_sample<ring_point<R>>::vector> scratch) noexcept {
  using V = typename curve_sample<ring_point<R>>::vector;
  std::array<V, 2> d{};
  if (!bspline_derivatives(knots, points, t, std::span<V>(d), scratch)) return std::nullopt;
  return curve_sample<ring_point<R>>{
      generate_coordinates<ring_point<R>>([&](int axis) { return coordinate(d[0], axis); }), d[1]};
}

}  // namespace irg::inline IRG_ABI
