// SPDX-License-Identifier: MIT
// B-spline bases over any legal knot vector, B-spline curves and rational ones (NURBS). Knots are checked once, when a
// bspline_knots is made; from then on nothing divides by zero: every quotient is over a stretch of knots that contains
// the place asked for.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/ring.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// What is wrong with a list of knots: fewer than 2 * (degree + 1), NaN or beyond an eighth of the largest number in
/// size, one less than the one before it, more than degree + 1 equal ones, or no two different ones between which the
/// curve could run.
enum class knots_error { none, too_few, not_finite, decreasing, too_many_equal, empty };

/// The Degree + 1 functions of a B-spline basis that are not zero at some place: function `first` + i has value[i].
template <Floating T, int Degree>
struct bspline_values {
  std::size_t first = 0;
  std::array<T, static_cast<std::size_t>(Degree) + 1> value{};
};

namespace detail {
inline namespace IRG_ABI {

// Adds to the largest value what the sum of all lacks of 1.
template <class V>
constexpr void make_sum_one(V& value) noexcept {
  auto sum = value[0], error = sum - sum;
  std::size_t largest = 0;
  for (std::size_t i = 1; i < value.size(); ++i) {
    const auto s = two_sum(sum, value[i]);
    sum = s.value;
    error = error + s.error;
    if (value[largest] < value[i]) largest = i;
  }
  value[largest] = value[largest] + ((1 - sum) - error);
}

// Control points of value 0 do not count, whatever they are: an end point is the control point itself.
template <Floating T, int Degree, PolygonRing R>
constexpr ring_point<R> blend(const bspline_values<T, Degree>& basis, const R& points) noexcept {
  return generate_coordinates<ring_point<R>>([&](int axis) {
    T sum = 0;
    for (std::size_t i = 0; i < basis.value.size(); ++i)
      if (basis.value[i] != 0)
        sum = sum + product(basis.value[i], coordinate(ring_vertex(points, basis.first + i), axis));
    return sum;
  });
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// What is wrong with the knots of a B-spline of this degree, or none.
/// cost    one pass
template <int Degree, Floating T>
  requires(Degree >= 0)
constexpr knots_error check_knots(std::span<const T> knots) noexcept {
  constexpr std::size_t order = static_cast<std::size_t>(Degree) + 1;
  constexpr T largest = (std::numeric_limits<T>::max)() / 8;
  if (knots.size() < 2 * order) return knots_error::too_few;
  for (const T& u : knots)
    if (!(u <= largest && u >= -largest)) return knots_error::not_finite;
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i] < knots[i - 1]) return knots_error::decreasing;
  for (std::size_t i = order; i < knots.size(); ++i)
    if (knots[i] == knots[i - order]) return knots_error::too_many_equal;
  return knots[order - 1] < knots[knots.size() - order] ? knots_error::none : knots_error::empty;
}

}  // namespace IRG_ABI

/// A legal list of knots of a B-spline of this degree; it refers to yours.
template <Floating T, int Degree>
class bspline_knots {
public:
  /// Knots that have been checked.
  /// needs   check_knots gives none
  IRG_INLINE constexpr explicit bspline_knots(std::span<const T> knots) noexcept : knots_(knots) {
    IRG_EXPECTS(check_knots<Degree>(knots) == knots_error::none);
  }

  /// The number of control points, and of basis functions.
  IRG_INLINE constexpr std::size_t size() const noexcept { return knots_.size() - order; }
  /// The curve runs from first() to last().
  IRG_INLINE constexpr T first() const noexcept { return knots_[order - 1]; }
  IRG_INLINE constexpr T last() const noexcept { return knots_[size()]; }
  IRG_INLINE constexpr T operator[](std::size_t i) const noexcept { return knots_[i]; }

private:
  static constexpr std::size_t order = static_cast<std::size_t>(Degree) + 1;
  std::span<const T> knots_;
};

inline namespace IRG_ABI {

/// The knots, if they are legal; check_knots tells why they are not.
template <int Degree, Floating T>
constexpr std::optional<bspline_knots<T, Degree>> make_bspline_knots(std::span<const T> knots) noexcept {
  if (check_knots<Degree>(knots) != knots_error::none) return std::nullopt;
  return bspline_knots<T, Degree>(knots);
}

/// The basis functions at t that are not zero.
/// gives   nothing for NaN and for t outside of [first(), last()]; at a knot the functions of the stretch behind it, at
///         last() those of the last stretch
/// exact   never negative, their sum within 4u of 1 for every legal knot vector (u = 2^-53, float 2^-24); at an end
///         knot of full multiplicity exactly one of them is 1
/// source  Cox 1972; de Boor 1972; Piegl and Tiller 1997, A2.2
template <Floating T, int Degree>
constexpr std::optional<bspline_values<T, Degree>> bspline_basis(const bspline_knots<T, Degree>& knots,
                                                                 std::type_identity_t<T> t) noexcept {
  if (!(knots.first() <= t && t <= knots.last())) return std::nullopt;
  std::size_t low = static_cast<std::size_t>(Degree), high = knots.size();  // knots[low] <= t, t < knots[high] or last
  if (t == knots.last()) {
    while (knots[high - 1] == t) --high;
    low = high - 1;
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (t < knots[middle] ? high : low) = middle;
  }
  bspline_values<T, Degree> basis{low - static_cast<std::size_t>(Degree), {}};
  basis.value[0] = 1;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(Degree); ++k) {
    T carried = 0;
    for (std::size_t r = 0; r < k; ++r) {
      const T right = knots[low + r + 1] - t, left = t - knots[low + r + 1 - k];
      const T stretch = knots[low + r + 1] - knots[low + r + 1 - k], value = basis.value[r];
      // The greater part is what the lesser one leaves of 1.
      const T share = right < left ? right / stretch : T(1) - left / stretch;
      const T rest = right < left ? T(1) - right / stretch : left / stretch;
      basis.value[r] = carried + product(value, share);
      carried = product(value, rest);
    }
    basis.value[k] = carried;
  }
  detail::make_sum_one(basis.value);
  return basis;
}

/// The point of a B-spline curve at t.
/// needs   as many control points as knots.size()
/// gives   nothing for NaN and for t outside of the knots' range
/// exact   an end point of full multiplicity is the control point, bit for bit; elsewhere each product and sum rounded
///         once, within the box of the control points up to some u of their size
template <Floating T, int Degree, PolygonRing R>
constexpr std::optional<ring_point<R>> bspline_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                     std::type_identity_t<T> t) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size());
  const auto basis = bspline_basis(knots, t);
  if (!basis) return std::nullopt;
  return detail::blend(*basis, points);
}

/// The basis functions at t of a rational B-spline (NURBS): each times its weight, over the sum of these.
/// needs   as many weights as knots.size()
/// gives   nothing for NaN, for t outside of the knots' range, and where a weight is negative, NaN or infinite or all
///         that count are zero
/// exact   as bspline_basis
template <Floating T, int Degree>
constexpr std::optional<bspline_values<T, Degree>> nurbs_basis(const bspline_knots<T, Degree>& knots,
                                                               std::type_identity_t<std::span<const T>> weights,
                                                               std::type_identity_t<T> t) noexcept {
  IRG_EXPECTS(weights.size() == knots.size());
  auto basis = bspline_basis(knots, t);
  if (!basis) return std::nullopt;
  T largest = 0;
  for (std::size_t i = 0; i < basis->value.size(); ++i) {
    const T w = weights[basis->first + i];
    if (!(w >= 0) || !detail::is_finite(w)) return std::nullopt;
    if (basis->value[i] > 0) largest = largest < w ? w : largest;
  }
  if (largest == 0) return std::nullopt;
  T sum = 0;
  for (std::size_t i = 0; i < basis->value.size(); ++i) {
    basis->value[i] = product(basis->value[i], weights[basis->first + i] / largest);
    sum = sum + basis->value[i];
  }
  if (!(sum > 0)) return std::nullopt;
  for (T& v : basis->value) v = v / sum;
  detail::make_sum_one(basis->value);
  return basis;
}

/// The point of a rational B-spline curve (NURBS) at t.
/// needs   as many control points and weights as knots.size()
/// gives   as nurbs_basis
/// exact   as bspline_point
/// source  Piegl and Tiller 1997
template <Floating T, int Degree, PolygonRing R>
constexpr std::optional<ring_point<R>> nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                   std::type_identity_t<std::span<const T>> weights,
                                                   std::type_identity_t<T> t) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size());
  const auto basis = nurbs_basis(knots, weights, t);
  if (!basis) return std::nullopt;
  return detail::blend(*basis, points);
}

}  // namespace IRG_ABI
}  // namespace irg
