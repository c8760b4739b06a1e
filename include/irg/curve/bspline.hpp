// SPDX-License-Identifier: MIT
// B-spline bases over any legal knot vector, B-spline curves and rational ones (NURBS), of a degree known when
// compiling or when running. Knots are checked once, when a bspline_knots is made; from then on nothing divides by
// zero: every quotient is over a stretch of knots that contains the place asked for.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/ring.hpp>
#include <irg/core/scalar.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/curve/detail/bspline_kernel.hpp>
#include <irg/math/homogeneous.hpp>

namespace irg {

/// What is wrong with a list of knots: fewer than 2 * (degree + 1), NaN or beyond an eighth of the largest number in
/// size, one less than the one before it, more than degree + 1 equal ones, no two different ones between which the
/// curve could run; with its degree, which is below 0; or with a knot to insert, which is outside of the curve's range.
enum class [[nodiscard]] knots_error {
  none,
  too_few,
  not_finite,
  decreasing,
  too_many_equal,
  empty,
  negative_degree,
  outside
};

/// The Degree of bspline_knots that bring it along.
inline constexpr int degree_at_run_time = -1;

/// The Degree + 1 functions of a B-spline basis that are not zero at some place: function `first` + i has value[i].
template <Floating T, int Degree>
struct bspline_values {
  std::size_t first = 0;
  std::array<T, static_cast<std::size_t>(Degree) + 1> value{};
};

namespace detail {
inline namespace IRG_ABI {

template <int Degree>
struct knots_degree {
  static constexpr int degree() noexcept { return Degree; }
};
template <>
struct knots_degree<degree_at_run_time> {
  int degree_at_hand = 0;
  constexpr int degree() const noexcept { return degree_at_hand; }
};

// Values of a basis times the weights that belong to them, over the sum; false where there is no such thing.
template <class V, Floating T>
constexpr bool make_rational(V& value, std::span<const T> weights) noexcept {
  T largest = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!(weights[i] >= 0) || !is_finite(weights[i])) return false;
    if (value[i] > 0) largest = largest < weights[i] ? weights[i] : largest;
  }
  if (largest == 0) return false;
  T sum = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    value[i] = value[i] > 0 ? product(value[i], weights[i] / largest) : T(0);  // elsewhere the quotient may overflow
    sum = sum + value[i];
  }
  if (!(sum > 0)) return false;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = value[i] / sum;
  make_sum_one(value);
  return true;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// What is wrong with the knots of a B-spline of this degree, or none.
/// cost    one pass
template <Floating T>
[[nodiscard]] constexpr knots_error check_knots(std::span<const T> knots, int degree) noexcept {
  constexpr T largest = (std::numeric_limits<T>::max)() / 8;
  if (degree < 0) return knots_error::negative_degree;
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  if (knots.size() / 2 < order) return knots_error::too_few;
  for (const T& u : knots)
    if (!(u <= largest && u >= -largest)) return knots_error::not_finite;
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i] < knots[i - 1]) return knots_error::decreasing;
  for (std::size_t i = order; i < knots.size(); ++i)
    if (knots[i] == knots[i - order]) return knots_error::too_many_equal;
  return knots[order - 1] < knots[knots.size() - order] ? knots_error::none : knots_error::empty;
}
template <int Degree, Floating T>
  requires(Degree >= 0)
[[nodiscard]] constexpr knots_error check_knots(std::span<const T> knots) noexcept {
  return check_knots(knots, Degree);
}

}  // namespace IRG_ABI

/// A legal list of knots of a B-spline of this degree; it refers to yours.
template <Floating T, int Degree>
  requires(Degree >= degree_at_run_time)
class bspline_knots : public detail::knots_degree<Degree> {
public:
  /// Knots that have been checked.
  /// needs   check_knots gives none
  IRG_INLINE constexpr explicit bspline_knots(std::span<const T> knots) noexcept
    requires(Degree >= 0)
      : knots_(knots) {
    IRG_EXPECTS(check_knots(knots, Degree) == knots_error::none);
  }
  IRG_APART constexpr bspline_knots(std::span<const T> knots, int degree) noexcept
    requires(Degree == degree_at_run_time)
      : detail::knots_degree<Degree>{degree}, knots_(knots) {
    IRG_EXPECTS(check_knots(knots, degree) == knots_error::none);
  }

  /// The number of control points, and of basis functions.
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return knots_.size() - order(); }
  /// How many basis functions are not zero at a place: the degree and one.
  [[nodiscard]] IRG_INLINE constexpr std::size_t order() const noexcept {
    return static_cast<std::size_t>(this->degree()) + 1;
  }
  /// The curve runs from first() to last().
  [[nodiscard]] IRG_INLINE constexpr T first() const noexcept { return knots_[order() - 1]; }
  [[nodiscard]] IRG_INLINE constexpr T last() const noexcept { return knots_[size()]; }
  IRG_INLINE constexpr T operator[](std::size_t i) const noexcept { return knots_[i]; }
  /// All knots, size() + order() of them.
  [[nodiscard]] IRG_INLINE constexpr std::span<const T> list() const noexcept { return knots_; }

private:
  std::span<const T> knots_;
};

namespace detail {
inline namespace IRG_ABI {

// The index of the knot at which the stretch of t begins: the one behind t, at last() the last one.
// needs   first() <= t <= last()
template <Floating T, int Degree>
constexpr std::size_t bspline_stretch(const bspline_knots<T, Degree>& knots, T t) noexcept {
  std::size_t high = knots.size();
  if (t < knots.last()) return stretch_between(knots, knots.order() - 1, high, t);
  while (knots[high - 1] == t) --high;
  return high - 1;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The knots, if they are legal; check_knots tells why they are not.
template <int Degree, Floating T>
[[nodiscard]] constexpr std::optional<bspline_knots<T, Degree>> make_bspline_knots(std::span<const T> knots) noexcept {
  if (check_knots<Degree>(knots) != knots_error::none) return std::nullopt;
  return bspline_knots<T, Degree>(knots);
}
template <Floating T>
[[nodiscard]] constexpr std::optional<bspline_knots<T, degree_at_run_time>> make_bspline_knots(std::span<const T> knots,
                                                                                               int degree) noexcept {
  if (check_knots(knots, degree) != knots_error::none) return std::nullopt;
  return bspline_knots<T, degree_at_run_time>(knots, degree);
}

/// The basis functions at t that are not zero.
/// gives   nothing for NaN and for t outside of [first(), last()]; at a knot the functions of the stretch behind it, at
///         last() those of the last stretch
/// exact   never negative, their sum within 4u of 1 for every legal knot vector (u = 2^-53, float 2^-24); at an end
///         knot of full multiplicity exactly one of them is 1
/// source  Cox 1972; de Boor 1972; Piegl and Tiller 1997, A2.2
template <Floating T, int Degree>
  requires(Degree >= 0)
[[nodiscard]] constexpr std::optional<bspline_values<T, Degree>> bspline_basis(const bspline_knots<T, Degree>& knots,
                                                                               std::type_identity_t<T> t) noexcept {
  if (!(knots.first() <= t && t <= knots.last())) return std::nullopt;
  const std::size_t low = detail::bspline_stretch(knots, t);
  bspline_values<T, Degree> basis{low - static_cast<std::size_t>(Degree), {}};
  detail::fill_bspline_values(
      basis.value, [&](std::size_t i) { return knots[i]; }, low, [&](std::size_t) { return t; });
  return basis;
}

/// The same in the first order() of `value`, for any degree; the result is the index of the first of these functions.
/// needs   room for order() values
/// gives   nothing, and `value` as it was, where the other form gives nothing
template <Floating T, int Degree>
constexpr std::optional<std::size_t> bspline_basis(const bspline_knots<T, Degree>& knots, std::type_identity_t<T> t,
                                                   std::type_identity_t<std::span<T>> value) noexcept {
  IRG_EXPECTS(value.size() >= knots.order());
  if (!(knots.first() <= t && t <= knots.last())) return std::nullopt;
  const std::size_t low = detail::bspline_stretch(knots, t);
  const auto these = value.first(knots.order());
  detail::fill_bspline_values(these, [&](std::size_t i) { return knots[i]; }, low, [&](std::size_t) { return t; });
  return low + 1 - knots.order();
}

/// The point of a B-spline curve at t.
/// needs   as many control points as knots.size()
/// gives   nothing for NaN and for t outside of the knots' range
/// exact   an end point of full multiplicity is the control point, bit for bit; elsewhere each product and sum rounded
///         once, within the box of the control points up to some u of their size
template <Floating T, int Degree, ControlPolygon R>
  requires(Degree >= 0)
[[nodiscard]] constexpr std::optional<ring_point<R>> bspline_point(const bspline_knots<T, Degree>& knots,
                                                                   const R& points,
                                                                   std::type_identity_t<T> t) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size());
  const auto basis = bspline_basis(knots, t);
  if (!basis) return std::nullopt;
  return detail::blend_points(basis->value, basis->first, points);
}

/// The same for any degree, with working space of the caller's for order() numbers; its contents are lost.
template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<ring_point<R>> bspline_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                     std::type_identity_t<T> t,
                                                     std::type_identity_t<std::span<T>> scratch) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size());
  const auto first = bspline_basis(knots, t, scratch);
  if (!first) return std::nullopt;
  return detail::blend_points(scratch.first(knots.order()), *first, points);
}

/// The basis functions at t of a rational B-spline (NURBS): each times its weight, over the sum of these.
/// needs   as many weights as knots.size()
/// gives   nothing for NaN, for t outside of the knots' range, and where a weight is negative, NaN or infinite or all
///         that count are zero
/// exact   as bspline_basis
template <Floating T, int Degree>
  requires(Degree >= 0)
[[nodiscard]] constexpr std::optional<bspline_values<T, Degree>> nurbs_basis(
    const bspline_knots<T, Degree>& knots, std::type_identity_t<std::span<const T>> weights,
    std::type_identity_t<T> t) noexcept {
  IRG_EXPECTS(weights.size() == knots.size());
  auto basis = bspline_basis(knots, t);
  if (!basis || !detail::make_rational(basis->value, weights.subspan(basis->first))) return std::nullopt;
  return basis;
}

/// The same in the first order() of `value`, for any degree; the result is the index of the first of these functions.
/// needs   as many weights as knots.size(); room for order() values
template <Floating T, int Degree>
constexpr std::optional<std::size_t> nurbs_basis(const bspline_knots<T, Degree>& knots,
                                                 std::type_identity_t<std::span<const T>> weights,
                                                 std::type_identity_t<T> t,
                                                 std::type_identity_t<std::span<T>> value) noexcept {
  IRG_EXPECTS(weights.size() == knots.size());
  const auto first = bspline_basis(knots, t, value);
  if (!first) return std::nullopt;
  const auto these = value.first(knots.order());
  if (!detail::make_rational(these, weights.subspan(*first))) return std::nullopt;
  return first;
}

/// The point of a rational B-spline curve (NURBS) at t.
/// needs   as many control points and weights as knots.size()
/// gives   as nurbs_basis
/// exact   as bspline_point
/// source  Piegl and Tiller 1997
template <Floating T, int Degree, ControlPolygon R>
  requires(Degree >= 0)
[[nodiscard]] constexpr std::optional<ring_point<R>> nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                                 std::type_identity_t<std::span<const T>> weights,
                                                                 std::type_identity_t<T> t) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size());
  const auto basis = nurbs_basis(knots, weights, t);
  if (!basis) return std::nullopt;
  return detail::blend_points(basis->value, basis->first, points);
}

/// The same for any degree, with working space of the caller's for order() numbers; its contents are lost.
template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<ring_point<R>> nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                   std::type_identity_t<std::span<const T>> weights,
                                                   std::type_identity_t<T> t,
                                                   std::type_identity_t<std::span<T>> scratch) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size());
  const auto first = nurbs_basis(knots, weights, t, scratch);
  if (!first) return std::nullopt;
  return detail::blend_points(scratch.first(knots.order()), *first, points);
}

/// The point of a rational B-spline curve (NURBS) of homogeneous control points at t.
/// needs   as many control points as knots.size()
/// gives   nothing for NaN, for t outside of the knots' range, and where the weight is 0 or not finite
/// exact   as bspline_point, and a quotient
/// source  Piegl and Tiller 1997, A4.1
template <Floating T, int Degree, ControlPolygon R>
  requires(Degree >= 0 && coordinate_traits<ring_point<R>>::kind == coordinate_kind::homogeneous)
[[nodiscard]] constexpr auto nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                         std::type_identity_t<T> t) noexcept
    -> decltype(try_to_cartesian(ring_vertex(points, 0))) {
  const auto p = bspline_point(knots, points, t);
  if (!p) return std::nullopt;
  return detail::cartesian_of(*p);
}

}  // namespace IRG_ABI
}  // namespace irg
