// SPDX-License-Identifier: MIT
// B-spline curves through given points, or as near to them as their control points allow. Both solve the same banded
// system, row by row, by Givens's rotations: as stable as it can be, and no square of a condition number comes in.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/result.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/length.hpp>
#include <irg/math/sqrt.hpp>

namespace irg {

/// How parameters follow the points: at equal steps, or in steps like the distances of the points or their roots.
enum class fit_spacing { uniform, chord_length, centripetal };

/// The ends of a fitted curve: through the first and the last point, or free as all others.
enum class fit_ends { through, free };

/// What became of a fit: `not_rising` where a parameter is less than the one before it or outside of the knots' range,
/// `undetermined` where some control point is not determined by the points (as when two are to be interpolated at one
/// place), or no parameter, all points being equal; `not_finite` where a number is not finite, be it given or one of a
/// control point, or a distance of points.
enum class [[nodiscard]] bspline_fit_status {
  ok,
  not_rising,
  undetermined,
  not_finite,
  done [[deprecated("irg: done is now ok")]] = ok
};

namespace detail::inline IRG_ABI {

// Whether basis function i is not zero at t.
template <Floating T, int Degree>
constexpr bool counts_at(const bspline_knots<T, Degree>& knots, std::size_t i, T t) noexcept {
  const T from = knots[i], to = knots[i + knots.order()];
  if (from < t && t < to) return true;
  return (t == from && knots[i + knots.order() - 1] == from && t < to) ||
         (t == to && knots[i + 1] == to && t == knots.last());
}

// Schoenberg's and Whitney's condition: rising places can be given to the basis functions, each of which counts at its
// own.
template <Floating T, int Degree>
constexpr bool determines_all(const bspline_knots<T, Degree>& knots, std::span<const T> places) noexcept {
  std::size_t i = 0;
  for (std::size_t k = 0; k < places.size() && i < knots.size(); ++k) {
    if (k > 0 && places[k] == places[k - 1]) continue;
    if (counts_at(knots, i, places[k])) ++i;
  }
  return i == knots.size();
}

template <Floating T>
struct givens_rotation {
  T cosine, sine;
  constexpr void apply(T& a, T& b) const noexcept {
    const T turned = product(cosine, a) + product(sine, b);
    b = product(cosine, b) - product(sine, a);
    a = turned;
  }
};

// An upper triangular banded matrix with a right side of points, to which rows are added.
template <CurvePoint P>
class banded_rows {
public:
  using T = scalar_of<P>;
  constexpr banded_rows(std::size_t size, std::size_t order)
      : size_(size), order_(order), r_(size * order, T(0)), right_(size, zero_coordinates<P>()) {}

  // Row `values` from column `first` on; its values are lost. Returns how many rows it was turned with or passed: of
  // rows that come in the order of `first` no more than `order`, since none before it reaches farther.
  constexpr std::size_t add(std::vector<T>& values, std::size_t first, P right) {
    for (std::size_t k = first; k < size_; ++k) {
      if (values[0] != T(0)) {
        T* const row = &r_[k * order_];
        if (row[0] == T(0)) {
          for (std::size_t i = 0; i < order_; ++i) row[i] = values[i];
          right_[k] = right;
          return k - first + 1;
        }
        const T length = hypot(row[0], values[0]);
        const givens_rotation<T> turn{row[0] / length, values[0] / length};
        for (std::size_t i = 0; i < order_; ++i) turn.apply(row[i], values[i]);
        right_[k] = turned(turn, right_[k], right);
      }
      bool is_spent = true;
      for (std::size_t i = 0; i + 1 < order_; ++i) {
        values[i] = values[i + 1];
        is_spent = is_spent && values[i] == T(0);
      }
      if (is_spent) return k - first + 1;
      values[order_ - 1] = T(0);
    }
    return size_ - first;
  }
  // The solution but for columns that no row has, which keep what is in `result`.
  constexpr void solve(std::span<P> result) const {
    for (std::size_t k = size_; k-- > 0;) {
      const T* const row = &r_[k * order_];
      if (row[0] == T(0)) continue;
      result[k] = generate_coordinates<P>([&](int axis) {
        T sum = coordinate(right_[k], axis);
        for (std::size_t i = 1; i < order_ && k + i < size_; ++i)
          if (row[i] != T(0)) sum = sum - product(row[i], coordinate(result[k + i], axis));
        return sum / row[0];
      });
    }
  }

private:
  static constexpr P turned(const givens_rotation<T>& turn, P& kept, P& added) noexcept {
    const P first = generate_coordinates<P>([&](int axis) {
      return product(turn.cosine, coordinate(kept, axis)) + product(turn.sine, coordinate(added, axis));
    });
    added = generate_coordinates<P>([&](int axis) {
      return product(turn.cosine, coordinate(added, axis)) - product(turn.sine, coordinate(kept, axis));
    });
    return first;
  }
  std::size_t size_, order_;
  std::vector<T> r_;
  std::vector<P> right_;
};

template <Floating T, int Degree, CurvePoint P>
constexpr result<T, bspline_fit_status> fit_points(const bspline_knots<T, Degree>& knots, std::span<const T> places,
                                                   std::span<const P> points, fit_ends ends, std::span<P> control) {
  const std::size_t size = knots.size(), order = knots.order();
  T largest = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!is_finite(places[k])) return bspline_fit_status::not_finite;
    for (int axis = 0; axis < size_of<P>; ++axis) {
      if (!is_finite(coordinate(points[k], axis))) return bspline_fit_status::not_finite;
      largest = maximum(largest, magnitude(coordinate(points[k], axis)));
    }
    if ((k > 0 && places[k] < places[k - 1]) || places[k] < knots.first() || places[k] > knots.last())
      return bspline_fit_status::not_rising;
  }
  if (!determines_all(knots, places)) return bspline_fit_status::undetermined;
  const bool through = ends == fit_ends::through && counts_at(knots, 0, places[0]) &&
                       counts_at(knots, size - 1, places[places.size() - 1]) && knots[0] == knots.first() &&
                       knots[knots.list().size() - 1] == knots.last() && places[0] == knots.first() &&
                       places[places.size() - 1] == knots.last();
  // Rows add up to their number's root.
  const T down = largest > product((std::numeric_limits<T>::max)(), T(0x1p-40f)) ? T(0x1p-40f) : T(1);
  const auto times = [](const P& p, const T& factor) {
    return generate_coordinates<P>([&](int axis) { return product(coordinate(p, axis), factor); });
  };
  for (std::size_t k = 0; k < size; ++k) control[k] = zero_coordinates<P>();
  if (through) {
    control[0] = times(points[0], down);
    control[size - 1] = times(points[points.size() - 1], down);
  }
  banded_rows<P> rows(size, order);
  std::vector<T> values(order, T(0));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t first = *bspline_basis(knots, places[k], std::span<T>(values));
    P right = times(points[k], down);
    for (std::size_t i = 0; i < order && through; ++i) {
      const std::size_t column = first + i;
      if (column != 0 && column + 1 != size) continue;
      right = generate_coordinates<P>(
          [&](int axis) { return coordinate(right, axis) - product(values[i], coordinate(control[column], axis)); });
      values[i] = T(0);
    }
    static_cast<void>(rows.add(values, first, right));
  }
  rows.solve(control);
  for (std::size_t k = 0; k < size && down != T(1); ++k) control[k] = times(control[k], 1 / down);
  if (through) {
    control[0] = points[0];
    control[size - 1] = points[points.size() - 1];
  }
  for (std::size_t k = 0; k < size; ++k)
    for (int axis = 0; axis < size_of<P>; ++axis)
      if (!is_finite(coordinate(control[k], axis))) return bspline_fit_status::not_finite;
  T farthest = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const P at = *bspline_point(knots, control, places[k], std::span<T>(values));
    const T off = length(scaled_difference(points[k], at, 1));
    if (!(off <= farthest)) farthest = off;
  }
  return farthest;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Writes parameters from 0 to 1 for points, one after the other.
/// needs   two points or more, places as long
/// gives   `undetermined` where all points are equal, `not_finite` where a distance or the sum of all is not: places of
///         no use then. Equal successive points have equal places. But for uniform spacing, which looks at no point
/// exact   sums of rounded distances over their sum; the first 0, the last 1
/// source  Piegl and Tiller 1997, 9.2.1; Lee 1989 (centripetal)
template <CartesianPoint P>
  requires Floating<scalar_of<P>>
constexpr bspline_fit_status parametrize(std::span<const P> points, fit_spacing spacing,
                                         std::type_identity_t<std::span<scalar_of<P>>> places) noexcept {
  using T = scalar_of<P>;
  IRG_EXPECTS(points.size() > 1 && places.size() >= points.size());
  places[0] = T(0);
  for (std::size_t k = 0; k < points.size() && spacing != fit_spacing::uniform; ++k)
    for (int axis = 0; axis < size_of<P>; ++axis)
      if (!is_finite(coordinate(points[k], axis))) return bspline_fit_status::not_finite;
  const auto step_to = [&](std::size_t k) {
    if (spacing == fit_spacing::uniform) return T(1);
    const T distant = length(detail::scaled_difference(points[k - 1], points[k], 1));
    return spacing == fit_spacing::chord_length ? distant : sqrt(distant);
  };
  for (std::size_t k = 1; k < points.size(); ++k) places[k] = places[k - 1] + step_to(k);
  const std::size_t last = points.size() - 1;
  const T all = places[last];
  if (!is_finite(all)) return bspline_fit_status::not_finite;
  if (!(all > T(0))) return bspline_fit_status::undetermined;
  for (std::size_t k = 1; k < last; ++k) places[k] = places[k] / all;
  places[last] = T(1);
  return bspline_fit_status::ok;
}

/// Whether parametrize wrote parameters: its old name.
template <CartesianPoint P>
  requires Floating<scalar_of<P>>
[[deprecated("irg: fit_places is now parametrize, which gives a status")]] constexpr bool fit_places(
    std::span<const P> points, fit_spacing spacing, std::type_identity_t<std::span<scalar_of<P>>> places) noexcept {
  return parametrize(points, spacing, places) == bspline_fit_status::ok;
}

/// Knots for a curve of `count` control points near data at these places: as many of them in each stretch as can be,
/// where count is that of the places the means of `degree` successive ones.
/// needs   places that rise from the first to the last, as parametrize gives them; 0 < degree < count <= their number;
///         knots for count + degree + 1
/// exact   means rounded a few times; ends as they are
/// source  de Boor 1978, XIII; Piegl and Tiller 1997, 9.8, 9.69
template <Floating T>
constexpr void fit_knots(std::span<const T> places, int degree, std::size_t count,
                         std::type_identity_t<std::span<T>> knots) noexcept {
  const std::size_t p = static_cast<std::size_t>(degree), n = places.size();
  IRG_EXPECTS(degree > 0 && p < count && count <= n && knots.size() >= count + p + 1);
  for (std::size_t i = 0; i <= p; ++i) {
    knots[i] = places[0];
    knots[count + i] = places[n - 1];
  }
  for (std::size_t j = 1; j + p < count; ++j) {
    T sum = 0;
    if (count == n) {
      for (std::size_t i = 0; i < p; ++i) sum = sum + places[j + i];
      knots[p + j] = sum / static_cast<T>(degree);
    } else {
      const T d = static_cast<T>(static_cast<int>(n)) / static_cast<T>(static_cast<int>(count - p));
      const T at = product(static_cast<T>(static_cast<int>(j)), d);
      const auto i = static_cast<std::size_t>(static_cast<int>(at));
      const curve_parameter<T> share(at - static_cast<T>(static_cast<int>(i)));
      knots[p + j] = product(share.rest, places[i - 1]) + product(share.t, places[i]);
    }
  }
}

/// The control points of the curve over these knots that is at each place in the point that belongs to it.
/// needs   as many points, places and room for control points as knots.size()
/// gives   how far the farthest point is from the curve at its place; or why there is no such curve, or more than one,
///         and no control points then
/// exact   rotations of one banded matrix, each rounded: at its place the curve is within some 10 u of the largest
///         control point of the given one, first and last point bit for bit where the end knots are of full
///         multiplicity and have the first and last place
/// cost    some 4 order^2 operations for each point; allocates
/// source  Schoenberg and Whitney 1953; Givens 1958; Piegl and Tiller 1997, 9.2
template <Floating T, int Degree, CartesianPoint P>
  requires Floating<scalar_of<P>>
constexpr result<T, bspline_fit_status> bspline_interpolate(const bspline_knots<T, Degree>& knots,
                                                            std::type_identity_t<std::span<const T>> places,
                                                            std::span<const P> points,
                                                            std::type_identity_t<std::span<P>> control) {
  IRG_EXPECTS(points.size() == knots.size() && places.size() == points.size() && control.size() >= knots.size());
  return detail::fit_points(knots, places, points, fit_ends::through, control);
}

/// The control points of the curve over these knots with the least sum of squared distances from the points at their
/// places.
/// needs   as many places as points; room for knots.size() control points
/// gives   as bspline_interpolate. Ends are `through` the first and last point only where the end knots are of full
///         multiplicity and have the first and last place
/// exact   as bspline_interpolate: rotations of the matrix itself, no normal equations
/// cost    some 4 order^2 operations for each point, however many control points; allocates
/// source  Givens 1958; Piegl and Tiller 1997, 9.4
template <Floating T, int Degree, CartesianPoint P>
  requires Floating<scalar_of<P>>
constexpr result<T, bspline_fit_status> bspline_least_squares(const bspline_knots<T, Degree>& knots,
                                                              std::type_identity_t<std::span<const T>> places,
                                                              std::span<const P> points, fit_ends ends,
                                                              std::type_identity_t<std::span<P>> control) {
  IRG_EXPECTS(places.size() == points.size() && !points.empty() && control.size() >= knots.size());
  return detail::fit_points(knots, places, points, ends, control);
}

}  // namespace IRG_ABI
}  // namespace irg
