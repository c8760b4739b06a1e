// SPDX-License-Identifier: MIT
// B-spline bases over any legal knot vector, B-spline curves and rational ones (NURBS), of a degree known when
// compiling or when running. Knots are checked once, when a bspline_knots is made; from then on nothing divides by
// zero: every quotient is over a stretch of knots that contains the place asked for.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/lane_masks.hpp>
#include <irg/core/lanes.hpp>
#include <irg/core/ring.hpp>
#include <irg/core/scalar.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/homogeneous.hpp>

namespace irg {

/// What is wrong with a list of knots: fewer than 2 * (degree + 1), NaN or beyond an eighth of the largest number in
/// size, one less than the one before it, more than degree + 1 equal ones, no two different ones between which the
/// curve could run; with its degree, which is below 0; or with a knot to insert, which is outside of the curve's range.
enum class [[nodiscard]] knots_status {
  ok,
  too_few,
  not_finite,
  decreasing,
  too_many_equal,
  empty,
  negative_degree,
  outside,
  none [[deprecated("irg: none is now ok")]] = ok
};

/// The Degree of bspline_knots that bring it along.
inline constexpr int degree_at_run_time = -1;

/// The Degree + 1 functions of a B-spline basis that are not zero at some place: function `first` + i has value[i].
template <Floating T, int Degree>
struct bspline_values {
  std::size_t first = 0;
  std::array<T, static_cast<std::size_t>(Degree) + 1> value{};
  bool operator==(const bspline_values&) const = default;
};

namespace detail::inline IRG_ABI {

template <int Degree>
struct knots_degree {
  static constexpr int degree() noexcept { return Degree; }
};
template <>
struct knots_degree<degree_at_run_time> {
  int degree_at_hand = 0;
  constexpr int degree() const noexcept { return degree_at_hand; }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// What is wrong with the knots of a B-spline of this degree, or none.
/// cost    one pass
template <Floating T>
[[nodiscard]] constexpr knots_status check_knots(std::span<const T> knots, int degree) noexcept;
template <int Degree, Floating T>
  requires(Degree >= 0)
[[nodiscard]] constexpr knots_status check_knots(std::span<const T> knots) noexcept;

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
    IRG_EXPECTS(check_knots(knots, Degree) == knots_status::ok);
  }
  IRG_APART constexpr bspline_knots(std::span<const T> knots, int degree) noexcept
    requires(Degree == degree_at_run_time)
      : detail::knots_degree<Degree>{degree}, knots_(knots) {
    IRG_EXPECTS(check_knots(knots, degree) == knots_status::ok);
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

inline namespace IRG_ABI {

/// The knots, if they are legal; check_knots tells why they are not.
template <int Degree, Floating T>
[[nodiscard]] constexpr std::optional<bspline_knots<T, Degree>> make_bspline_knots(std::span<const T> knots) noexcept;
template <Floating T>
[[nodiscard]] constexpr std::optional<bspline_knots<T, degree_at_run_time>> make_bspline_knots(std::span<const T> knots,
                                                                                               int degree) noexcept;

/// The basis functions at t that are not zero.
/// gives   nothing for NaN and for t outside of [first(), last()]; at a knot the functions of the stretch behind it, at
///         last() those of the last stretch
/// exact   never negative, their sum within 4u of 1 for every legal knot vector (u = 2^-53, float 2^-24); at an end
///         knot of full multiplicity exactly one of them is 1
/// source  Cox 1972; de Boor 1972; Piegl and Tiller 1997, A2.2
template <Floating T, int Degree>
  requires(Degree >= 0)
[[nodiscard]] constexpr std::optional<bspline_values<T, Degree>> bspline_basis(const bspline_knots<T, Degree>& knots,
                                                                               std::type_identity_t<T> t) noexcept;

/// The same in the first order() of `value`, for any degree; the result is the index of the first of these functions.
/// needs   room for order() values
/// gives   nothing, and `value` as it was, where the other form gives nothing
template <Floating T, int Degree>
constexpr std::optional<std::size_t> bspline_basis(const bspline_knots<T, Degree>& knots, std::type_identity_t<T> t,
                                                   std::type_identity_t<std::span<T>> value) noexcept;

/// The point of a B-spline curve at t.
/// needs   as many control points as knots.size()
/// gives   nothing for NaN and for t outside of the knots' range
/// exact   an end point of full multiplicity is the control point, bit for bit; elsewhere each product and sum rounded
///         once, within the box of the control points up to some u of their size
template <Floating T, int Degree, ControlPolygon R>
  requires(Degree >= 0)
[[nodiscard]] constexpr std::optional<ring_point<R>> bspline_point(const bspline_knots<T, Degree>& knots,
                                                                   const R& points, std::type_identity_t<T> t) noexcept;

/// The same for any degree, with working space of the caller's for order() numbers; its contents are lost.
template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<ring_point<R>> bspline_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                     std::type_identity_t<T> t,
                                                     std::type_identity_t<std::span<T>> scratch) noexcept;

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int Degree, ControlPolygon R,
          WorkspaceFor<R> W = detail::own_workspace<R, Degree == degree_at_run_time>>
[[nodiscard]] constexpr std::optional<ring_point<R>> bspline_point(const bspline_knots<T, Degree>& knots,
                                                                   const R& points, std::type_identity_t<T> t,
                                                                   W&& memory = W{}) {
  return bspline_point(knots, points, t, detail::room_for(memory.numbers, knots.order()));
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
    std::type_identity_t<T> t) noexcept;

/// The same in the first order() of `value`, for any degree; the result is the index of the first of these functions.
/// needs   as many weights as knots.size(); room for order() values
template <Floating T, int Degree>
constexpr std::optional<std::size_t> nurbs_basis(const bspline_knots<T, Degree>& knots,
                                                 std::type_identity_t<std::span<const T>> weights,
                                                 std::type_identity_t<T> t,
                                                 std::type_identity_t<std::span<T>> value) noexcept;

/// The point of a rational B-spline curve (NURBS) at t.
/// needs   as many control points and weights as knots.size()
/// gives   as nurbs_basis
/// exact   as bspline_point
/// source  Piegl and Tiller 1997
template <Floating T, int Degree, ControlPolygon R>
  requires(Degree >= 0)
[[nodiscard]] constexpr std::optional<ring_point<R>> nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                                 std::type_identity_t<std::span<const T>> weights,
                                                                 std::type_identity_t<T> t) noexcept;

/// The same for any degree, with working space of the caller's for order() numbers; its contents are lost.
template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<ring_point<R>> nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                   std::type_identity_t<std::span<const T>> weights,
                                                   std::type_identity_t<T> t,
                                                   std::type_identity_t<std::span<T>> scratch) noexcept;

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int Degree, ControlPolygon R,
          WorkspaceFor<R> W = detail::own_workspace<R, Degree == degree_at_run_time>>
[[nodiscard]] constexpr std::optional<ring_point<R>> nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                                 std::type_identity_t<std::span<const T>> weights,
                                                                 std::type_identity_t<T> t, W&& memory = W{}) {
  return nurbs_point(knots, points, weights, t, detail::room_for(memory.numbers, knots.order()));
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
    -> decltype(try_to_cartesian(ring_vertex(points, 0)));

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_ABI {

// The sums and shares that B-splines are made of, in registers where points fill one.

// Adds to the largest value what the sum of all lacks of 1. Of numbers, or of packs lane by lane.
template <class V>
constexpr void make_sum_one(V& value) noexcept {
  using F = std::remove_cvref_t<decltype(value[0])>;
  const auto index = [](std::size_t i) {
    if constexpr (std::is_arithmetic_v<F>)
      return i;
    else
      return lanes<F>::broadcast(static_cast<typename lanes<F>::scalar>(static_cast<std::ptrdiff_t>(i)));
  };
  const F zero = lanes<F>::broadcast(0);
  F sum = value[0], error = zero, most = value[0];
  auto largest = index(0);
  for (std::size_t i = 1; i < value.size(); ++i) {
    const F next = value[i], s = sum + next, part = s - sum;  // two_sum
    error = error + ((sum - (s - part)) + (next - part));
    sum = s;
    largest = select(most < next, index(i), largest);  // no jumps: which one it is changes from place to place
    most = maximum(most, next);
  }
  const F lacking = (lanes<F>::broadcast(1) - sum) - error;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = value[i] + select(largest == index(i), lacking, zero);
}

// How t divides the stretch between two knots: what is right of it and what is left, of 1. The greater part is what the
// lesser one leaves.
template <class F>
struct stretch_shares {
  F rest, t;
};
template <class F>
IRG_INLINE constexpr stretch_shares<F> shares_of_stretch(const F& from, const F& to, const F& t) noexcept {
  const F right = to - t, left = t - from;
  const auto distant = right < left;  // no jumps here either
  const F less = select(distant, right, left) / (to - from), more = lanes<F>::broadcast(1) - less;
  return {select(distant, less, more), select(distant, more, less)};
}
template <Floating T>
IRG_INLINE constexpr curve_parameter<T> share_of_stretch(const T& from, const T& to, const T& t) noexcept {
  const auto shares = shares_of_stretch(from, to, t);
  return {shares.rest, shares.t};
}

// The greatest `low` of [low, high) with u(low) <= t.
// needs   u(low) <= t < u(high)
template <class Knots, Floating T>
constexpr std::size_t stretch_between(const Knots& u, std::size_t low, std::size_t high, T t) noexcept {
  // Evenly spaced knots are found at once.
  const auto guess = low + static_cast<std::size_t>((t - u[low]) / (u[high] - u[low]) *
                                                    static_cast<T>(static_cast<std::ptrdiff_t>(high - low)));
  if (guess < high && u[guess] <= t && t < u[guess + 1]) return guess;
  for (std::size_t n = high - low; n > 1;) {
    const std::size_t half = n / 2;
    low = u[low + half] <= t ? low + half : low;
    n -= half;
  }
  return low;
}

// Cox's and de Boor's recursion in the stretch from knot(low) on, each level at a place of its own: at one t the basis
// functions, at successive knots of a refined list the coefficients of a refined control point. Of numbers, or of packs
// lane by lane.
template <class V, class Knot, class Place>
constexpr void fill_bspline_values(V& value, const Knot& knot, std::size_t low, const Place& place) noexcept {
  using F = std::remove_cvref_t<decltype(value[0])>;
  const F zero = lanes<F>::broadcast(0);
  value[0] = lanes<F>::broadcast(1);
  for (std::size_t k = 1; k < value.size(); ++k) {
    F carried = zero;
    for (std::size_t r = 0; r < k; ++r) {
      const F before = value[r];
      const auto none = before == zero;  // its share may be any number then
      if constexpr (std::is_same_v<decltype(none), const bool>)
        if (none) {
          value[r] = carried;
          carried = zero;
          continue;
        }
      const auto share = shares_of_stretch<F>(knot(low + r + 1 - k), knot(low + r + 1), place(k));
      value[r] = carried + select(none, zero, product(before, share.rest));
      carried = select(none, zero, product(before, share.t));
    }
    value[k] = carried;
  }
  make_sum_one(value);
}

// Two bases at a place each, `u` and `v` beginning with the first knot that counts; of one degree side by side.
template <Floating T, std::size_t U, std::size_t V>
constexpr void fill_two_bases(std::array<T, U>& value_u, std::span<const T> u, T at_u, std::array<T, V>& value_v,
                              std::span<const T> v, T at_v) noexcept {
  if constexpr (U == V && has_lanes && std::is_same_v<T, double>)
    if (!std::is_constant_evaluated()) {
      using F = pack<T, 2>;
      const F at = pack_of(at_u, at_v);
      std::array<F, U> value;
      fill_bspline_values(
          value, [&](std::size_t i) { return pack_of(u[i], v[i]); }, U - 1, [&](std::size_t) { return at; });
      for (std::size_t i = 0; i < U; ++i) {
        value_u[i] = lane(value[i], 0);
        value_v[i] = lane(value[i], 1);
      }
      return;
    }
  fill_bspline_values(value_u, [&](std::size_t i) { return u[i]; }, U - 1, [&](std::size_t) { return at_u; });
  fill_bspline_values(value_v, [&](std::size_t i) { return v[i]; }, V - 1, [&](std::size_t) { return at_v; });
}

// Points that fill a register.
template <class P>
inline constexpr bool fills_lanes = has_lanes && std::is_trivially_copyable_v<P> && size_of<P> == 4 &&
                                    sizeof(P) == 4 * sizeof(scalar_of<P>) && Floating<scalar_of<P>>;

// The sum of at(i), each times its value, in registers.
template <class V, class At>
IRG_INLINE auto lanes_of_multiples(const V& value, const At& at) noexcept {
  using F = std::remove_cvref_t<decltype(at(std::size_t{}))>;
  F sum = lanes<F>::broadcast(0);
  for (std::size_t i = 0; i < value.size(); ++i) sum = sum + lanes<F>::broadcast(value[i]) * at(i);
  return sum;
}
template <class P>
IRG_INLINE pack<scalar_of<P>, 4> lanes_of(const P& p) noexcept {
  return lanes<pack<scalar_of<P>, 4>>::load_bytes(&p);
}
template <class P>
IRG_INLINE P point_of(const pack<scalar_of<P>, 4>& sum) noexcept {
  std::array<scalar_of<P>, 4> result;
  lanes<pack<scalar_of<P>, 4>>::store(result.data(), sum);
  return std::bit_cast<P>(result);
}

// The sum of at(i), each times its value. Those of value 0 do not count, whatever they are: an end point is the control
// point itself.
template <class V, class At>
IRG_INLINE constexpr auto sum_of_multiples(const V& value, const At& at) noexcept {
  using P = std::remove_cvref_t<decltype(at(std::size_t{}))>;
  using T = scalar_of<P>;
  if constexpr (fills_lanes<P>) {
    if (!std::is_constant_evaluated()) {
      using F = pack<T, 4>;
      F sum = lanes<F>::broadcast(0);
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i] == T(0)) continue;
        const auto coordinates = std::bit_cast<std::array<T, 4>>(at(i));
        sum = sum + lanes<F>::broadcast(value[i]) * lanes<F>::load(coordinates.data());
      }
      return point_of<P>(sum);
    }
  }
  return generate_coordinates<P>([&](int axis) {
    T sum = 0;
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i] != T(0)) sum = sum + product(value[i], coordinate(at(i), axis));
    return sum;
  });
}

// The sum of row(i)[j], each times its two values; in registers all of them, as long as none is infinite.
template <class U, class V, class Row>
IRG_INLINE constexpr auto sum_of_rows(const U& u, const V& v, const Row& row) noexcept {
  using P = std::remove_cvref_t<decltype(row(0)[0])>;
  if constexpr (fills_lanes<P>)
    if (!std::is_constant_evaluated()) {
      const auto sum = lanes_of_multiples(u, [&](std::size_t i) {
        return lanes_of_multiples(v, [at = row(i)](std::size_t j) { return lanes_of(at[j]); });
      });
      if (all_lanes(sum - sum == lanes<pack<scalar_of<P>, 4>>::broadcast(0))) return point_of<P>(sum);
    }
  return sum_of_multiples(
      u, [&](std::size_t i) { return sum_of_multiples(v, [at = row(i)](std::size_t j) { return at[j]; }); });
}

template <class V, PolygonRing R>
constexpr ring_point<R> blend_points(const V& value, std::size_t first, const R& points) noexcept {
  return sum_of_multiples(value, [&](std::size_t i) { return ring_vertex(points, first + i); });
}

// try_to_cartesian, whose exceptions are looked for only where a quotient is not finite.
template <Floating T, int N>
IRG_INLINE constexpr std::optional<point<T, N>> cartesian_of(const hpoint<T, N>& p) noexcept {
  if (std::is_constant_evaluated()) return try_to_cartesian(p);
  const point<T, N> q = generate_coordinates<point<T, N>>([&](int i) { return p[i] / p[N]; });
  T none = p[N] - p[N];
  for (int i = 0; i < N; ++i) none = none + (q[i] - q[i]);
  return none == T(0) ? std::optional(q) : try_to_cartesian(p);
}

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

// The index of the knot at which the stretch of t begins: the one behind t, at last() the last one.
// needs   first() <= t <= last()
template <Floating T, int Degree>
constexpr std::size_t bspline_stretch(const bspline_knots<T, Degree>& knots, T t) noexcept {
  std::size_t high = knots.size();
  if (t < knots.last()) return stretch_between(knots, knots.order() - 1, high, t);
  while (knots[high - 1] == t) --high;
  return high - 1;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr knots_status check_knots(std::span<const T> knots, int degree) noexcept {
  constexpr T largest = (std::numeric_limits<T>::max)() / 8;
  if (degree < 0) return knots_status::negative_degree;
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  if (knots.size() / 2 < order) return knots_status::too_few;
  for (const T& u : knots)
    if (!(u <= largest && u >= -largest)) return knots_status::not_finite;
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i] < knots[i - 1]) return knots_status::decreasing;
  for (std::size_t i = order; i < knots.size(); ++i)
    if (knots[i] == knots[i - order]) return knots_status::too_many_equal;
  return knots[order - 1] < knots[knots.size() - order] ? knots_status::ok : knots_status::empty;
}

template <int Degree, Floating T>
  requires(Degree >= 0)
[[nodiscard]] constexpr knots_status check_knots(std::span<const T> knots) noexcept {
  return check_knots(knots, Degree);
}

template <int Degree, Floating T>
[[nodiscard]] constexpr std::optional<bspline_knots<T, Degree>> make_bspline_knots(std::span<const T> knots) noexcept {
  if (check_knots<Degree>(knots) != knots_status::ok) return std::nullopt;
  return bspline_knots<T, Degree>(knots);
}

template <Floating T>
[[nodiscard]] constexpr std::optional<bspline_knots<T, degree_at_run_time>> make_bspline_knots(std::span<const T> knots,
                                                                                               int degree) noexcept {
  if (check_knots(knots, degree) != knots_status::ok) return std::nullopt;
  return bspline_knots<T, degree_at_run_time>(knots, degree);
}

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

template <Floating T, int Degree, ControlPolygon R>
constexpr std::optional<ring_point<R>> bspline_point(const bspline_knots<T, Degree>& knots, const R& points,
                                                     std::type_identity_t<T> t,
                                                     std::type_identity_t<std::span<T>> scratch) noexcept {
  IRG_EXPECTS(ring_size(points) == knots.size());
  const auto first = bspline_basis(knots, t, scratch);
  if (!first) return std::nullopt;
  return detail::blend_points(scratch.first(knots.order()), *first, points);
}

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

template <Floating T, int Degree, ControlPolygon R>
  requires(Degree >= 0 && coordinate_traits<ring_point<R>>::kind == coordinate_kind::homogeneous)
[[nodiscard]] constexpr auto nurbs_point(const bspline_knots<T, Degree>& knots, const R& points,
                                         std::type_identity_t<T> t) noexcept
    -> decltype(try_to_cartesian(ring_vertex(points, 0))) {
  const auto p = bspline_point(knots, points, t);
  if (!p) return std::nullopt;
  return detail::cartesian_of(*p);
}

}  // namespace irg::inline IRG_ABI
