// SPDX-License-Identifier: MIT
// Bezier curves that are asked for many points: expanded once, in twice the precision, about places so near each other
// that a point takes two short polynomials of the distance from the nearest, and hardly rounds more than its result.
#pragma once

#include <bit>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lane_masks.hpp>
#include <irg/core/lanes.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_accurate.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// How many coefficients of an expansion count, by fours: the k-th is at most 1/k! of the largest control point.
template <Floating T>
constexpr std::size_t expansion_size(std::size_t count) noexcept {
  constexpr std::size_t most = sizeof(T) == 4 ? 12 : 20;
  return count < most ? (count + 3) / 4 * 4 : most;
}

}  // namespace detail::inline IRG_ABI

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
  requires Floating<scalar_of<control_point<R>>>
constexpr std::optional<prepared_bezier<control_point<R>>> prepare_bezier(
    const R& points, std::span<scalar_of<control_point<R>>> space,
    std::type_identity_t<std::span<exact_sum<scalar_of<control_point<R>>>>> scratch) noexcept;

/// The same, computed in a workspace, which may go afterwards; allocates where that has too little memory.
template <ControlPoints R, WorkspaceFor<R> W = workspace_for<R>>
  requires Floating<scalar_of<control_point<R>>>
[[nodiscard]] constexpr std::optional<prepared_bezier<control_point<R>>> prepare_bezier(
    const R& points, std::span<scalar_of<control_point<R>>> space, W&& memory = W{}) {
  return prepare_bezier(points, space, detail::room_for(memory.sums, points));
}

/// The point of the curve at t.
/// needs   0 <= t <= 1; outside, the polynomial goes on to degree 19 (in floats 11)
/// exact   the ends bit for bit; error for control points within 1, measured: 3 u at most to degree 50, in the mean
///         0.15 u; bound (3 degree + 4) u, and 15 u, of the largest
/// cost    a product and a sum for each of min(degree + 1, 20) coefficients (in floats 12), all coordinates together
/// source  Dorn 1962
template <CurvePoint P>
[[nodiscard]] constexpr P bezier_point(const prepared_bezier<P>& curve, std::type_identity_t<scalar_of<P>> t) noexcept;

/// The points of the curve at many places.
/// needs   as many points as places
/// exact   as one by one, bit for bit
/// cost    half of it or less where successive places are in order
template <CurvePoint P>
constexpr void bezier_points(const prepared_bezier<P>& curve, std::type_identity_t<std::span<const scalar_of<P>>> t,
                             std::span<P> points) noexcept;

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_ABI {

// A Bezier curve's Taylor expansions about evenly spaced places, made in twice the precision,
// and their value next to such a place, with the coordinates side by side in a register.

// Hands the coefficients about the place node / pieces to put(i, c): those of x^i, where the control points are at(k)
// and x = 2 (pieces t - node). False where a number is too large for products without loss.
// The curve is cut there; what remains on the longer side is not magnified when its control points are differenced.
template <Floating T, class At, class Put>
constexpr bool put_expansion(std::size_t node, std::size_t pieces, std::span<exact_sum<T>> b, const At& at,
                             const Put& put) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)() * T(0x1p-34);
  const auto number = [](std::size_t i) { return static_cast<T>(static_cast<std::ptrdiff_t>(i)); };
  const std::size_t n = b.size() - 1, most_orders = expansion_size<T>(b.size()),
                    count = b.size() < most_orders ? b.size() : most_orders;
  const bool backwards = 2 * node > pieces;
  const std::size_t ahead = backwards ? node : pieces - node;
  const split_parameter<T> t{number(pieces - ahead) / number(pieces), {number(ahead) / number(pieces), T(0)}};
  for (std::size_t i = 0; i <= n; ++i) {
    const T c = at(backwards ? n - i : i);
    if (!(c <= most && c >= -most)) return false;
    b[i] = {c, T(0)};
  }
  if (ahead < pieces)
    for (std::size_t level = n; level > 0; --level)
      for (std::size_t i = 0; i < level; ++i) b[i] = compensated_blend(b[i], b[i + 1], t);
  for (std::size_t order = 1; order < count; ++order)
    for (std::size_t i = count - 1; i >= order; --i) {
      const auto [value, error] = two_sum(b[i].value, -b[i - 1].value);
      b[i] = {value, error + (b[i].error - b[i - 1].error)};
    }
  double_word<T> factor = T(1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [high, low] = two_sum(b[i].value, b[i].error);
    if (!(high <= most && high >= -most)) return false;
    put(i, (double_word<T>(high, low) * factor).high);
    const T times = number(n - i);
    factor = factor * (backwards ? -times : times) / double_word<T>(product(number(i + 1), number(2 * ahead)));
  }
  return true;
}

// The nearest expansion's row, its place in pieces, and x there.
template <class T>
struct expansion_place {
  const T* row;
  T node, x;
};
template <class Curve, Floating T>
IRG_INLINE constexpr expansion_place<T> nearest_expansion(const Curve& curve, T t) noexcept {
  const T pieces = static_cast<T>(static_cast<std::ptrdiff_t>(curve.pieces)), at = product(t, pieces);
  const T within = minimum(maximum(at + T(0.5), T(0.5)), pieces);  // t is within [0, 1], but who knows
  const auto index = static_cast<std::ptrdiff_t>(within);
  const T node = static_cast<T>(index), off = at - node;
  return {curve.rows.data() + index * static_cast<std::ptrdiff_t>(curve.row_length), node, off + off};
}

// Horner's scheme in x^4 for each fourth power: four short chains instead of a long one. load(k) gives the k-th
// coefficient, numbers that F holds.
template <class F, class Load>
IRG_INLINE constexpr F sum_of_powers(std::size_t count, const F& x, const Load& load) noexcept {
  const auto times = [](const F& a, const F& b) {
    if constexpr (lanes<F>::count == 1 && std::is_floating_point_v<F>)
      return product(a, b);
    else
      return a * b;
  };
  const F square = times(x, x), fourth = times(square, square);
  std::size_t k = count - 4;
  F a = load(k), b = load(k + 1), c = load(k + 2), d = load(k + 3);
  while (k > 0) {
    k -= 4;
    a = times(a, fourth) + load(k);
    b = times(b, fourth) + load(k + 1);
    c = times(c, fourth) + load(k + 2);
    d = times(d, fourth) + load(k + 3);
  }
  return (a + times(c, square)) + times(b + times(d, square), x);
}

template <Coordinates P, class Curve>
constexpr P prepared_point_plain(const Curve& curve, scalar_of<P> t) noexcept {
  const auto place = nearest_expansion(curve, t);
  return generate_coordinates<P>([&](int axis) {
    return sum_of_powers(curve.row_length / Curve::width, place.x,
                         [&](std::size_t k) { return place.row[k * Curve::width + static_cast<std::size_t>(axis)]; });
  });
}

template <Coordinates P, class Curve>
IRG_INLINE constexpr P prepared_point(const Curve& curve, scalar_of<P> t) noexcept {
  if (!has_lanes || std::is_constant_evaluated()) return prepared_point_plain<P>(curve, t);
  using F = pack<scalar_of<P>, static_cast<int>(Curve::width)>;
  const auto place = nearest_expansion(curve, t);
  const F sum = sum_of_powers(curve.row_length / Curve::width, lanes<F>::broadcast(place.x),
                              [&](std::size_t k) { return lanes<F>::load(place.row + k * Curve::width); });
  return generate_coordinates<P>([&](int axis) { return lane(sum, axis); });
}

// Points at a register full of places next to one expansion; false, and nothing written, where they are not.
template <class F, Coordinates P, class Curve>
IRG_INLINE bool put_points_together(const Curve& curve, const scalar_of<P>* t, P* points) noexcept {
  using T = scalar_of<P>;
  constexpr std::size_t axes = static_cast<std::size_t>(size_of<P>), width = Curve::width;
  const auto place = nearest_expansion(curve, t[0]);
  if (nearest_expansion(curve, t[lanes<F>::count - 1]).row != place.row) return false;
  const F at = lanes<F>::load(t) * lanes<F>::broadcast(static_cast<T>(static_cast<std::ptrdiff_t>(curve.pieces))),
          rounded_up = at + lanes<F>::broadcast(T(0.5)), node = lanes<F>::broadcast(place.node);
  if (!all_lanes(rounded_up >= node) || !all_lanes(rounded_up < node + lanes<F>::broadcast(1))) return false;
  const F off = at - node, x = off + off;
  F sum[axes];
  for (std::size_t axis = 0; axis < axes; ++axis)
    sum[axis] = sum_of_powers(curve.row_length / width, x,
                              [&](std::size_t k) { return lanes<F>::broadcast(place.row[k * width + axis]); });
  if constexpr (axes == 3 && sizeof(P) == 3 * sizeof(T) && std::is_trivially_copyable_v<P> &&
                std::is_standard_layout_v<P>)
    store_triples(reinterpret_cast<T*>(points), triple_lanes<T, lanes<F>::count>{sum[0], sum[1], sum[2]});
  else
    for (int i = 0; i < lanes<F>::count; ++i)
      points[i] = generate_coordinates<P>([&](int axis) { return lane(sum[static_cast<std::size_t>(axis)], i); });
  return true;
}

template <Coordinates P, class Curve>
constexpr void prepared_points(const Curve curve, std::span<const scalar_of<P>> t, std::span<P> points) noexcept {
  using F = pack<scalar_of<P>, widest_lanes<scalar_of<P>>>;
  constexpr std::size_t together = static_cast<std::size_t>(lanes<F>::count);
  std::size_t k = 0;
  if (has_lanes && !std::is_constant_evaluated())
    for (; k + together <= t.size(); k += together)
      if (!put_points_together<F>(curve, &t[k], &points[k]))
        for (std::size_t i = k; i < k + together; ++i) points[i] = prepared_point<P>(curve, t[i]);
  for (; k < t.size(); ++k) points[k] = prepared_point<P>(curve, t[k]);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <ControlPoints R>
  requires Floating<scalar_of<control_point<R>>>
constexpr std::optional<prepared_bezier<control_point<R>>> prepare_bezier(
    const R& points, std::span<scalar_of<control_point<R>>> space,
    std::type_identity_t<std::span<exact_sum<scalar_of<control_point<R>>>>> scratch) noexcept {
  using P = control_point<R>;
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

template <CurvePoint P>
[[nodiscard]] constexpr P bezier_point(const prepared_bezier<P>& curve, std::type_identity_t<scalar_of<P>> t) noexcept {
  return detail::prepared_point<P>(curve, t);
}

template <CurvePoint P>
constexpr void bezier_points(const prepared_bezier<P>& curve, std::type_identity_t<std::span<const scalar_of<P>>> t,
                             std::span<P> points) noexcept {
  IRG_EXPECTS(points.size() >= t.size());
  detail::prepared_points<P>(curve, t, points);
}

}  // namespace irg::inline IRG_ABI
