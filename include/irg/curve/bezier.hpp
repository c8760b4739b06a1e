// SPDX-License-Identifier: MIT
// Bezier curves of any degree and dimension by de Casteljau's algorithm, and the Bernstein polynomials. Control points
// are any range of points or vectors. A range whose length is part of its type (std::array) brings its own working
// space; any other takes scratch of the caller's, and nothing allocates, or a workspace that grows.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A place on a curve: t and 1 - t, each rounded once. A plain number converts to it.
template <Real T>
struct curve_parameter {
  T rest = T(1), t = T(0);
  constexpr curve_parameter() = default;
  IRG_INLINE constexpr curve_parameter(const T& at) noexcept : rest(T(1) - at), t(at) {}
  IRG_INLINE constexpr curve_parameter(const T& remaining, const T& at) noexcept : rest(remaining), t(at) {}
  bool operator==(const curve_parameter&) const = default;
};

/// What the control points of a range are.
template <class R>
using control_point = typename ring_traits<R>::point;

namespace detail {

/// The number of elements of a range if its type fixes it, else 0.
template <class R>
constexpr std::size_t fixed_size() {
  if constexpr (requires { std::tuple_size<R>::value; })
    return std::tuple_size<R>::value;
  else if constexpr (requires { R::extent; })
    return R::extent == std::dynamic_extent ? 0 : R::extent;
  else
    return 0;
}

template <Coordinates P>
struct displacement_of {
  using type = P;
};
template <Coordinates P>
  requires(coordinate_traits<P>::kind == coordinate_kind::point)
struct displacement_of<P> {
  using type = vec<scalar_of<P>, size_of<P>>;
};

}  // namespace detail

/// A point or vector of a curve or surface: coordinates in numbers that divide, made without a value and assigned,
/// since the schemes keep rows of them.
template <class P>
concept CurvePoint = Coordinates<P> && std::semiregular<P> && Real<scalar_of<P>>;

/// One that is not homogeneous: distances of such points are the lengths of their differences.
template <class P>
concept CartesianPoint = CurvePoint<P> && coordinate_traits<P>::kind != coordinate_kind::homogeneous;

/// A range of control points: std::array, std::vector or std::span of points, vectors or homogeneous points.
template <class R>
concept ControlPoints = requires { requires CurvePoint<control_point<R>>; };

/// Control points that are no vectors.
template <class R>
concept ControlPolygon = ControlPoints<R> && PolygonRing<R>;

/// Control points whose number is part of the type.
template <class R>
concept FixedControlPoints = ControlPoints<R> && (detail::fixed_size<R>() > 0);

/// The parameter type of a curve with control points R.
template <ControlPoints R>
using parameter_of = curve_parameter<scalar_of<control_point<R>>>;

/// A point of a curve and the derivative there with respect to the parameter; of type vec when the points are point.
template <Coordinates P>
struct curve_sample {
  using vector = typename detail::displacement_of<P>::type;
  P point{};
  vector derivative{};
  bool operator==(const curve_sample&) const = default;
};

/// Memory that functions of curves and surfaces with control points P work in, to be used again by the next call: its
/// rows grow to what a call needs, and what they hold between calls means nothing.
/// needs   one call at a time: none from the sink of another one
template <CurvePoint P>
struct curve_workspace {
  std::vector<P> points{};
  std::vector<typename curve_sample<P>::vector> vectors{};
  std::vector<scalar_of<P>> numbers{};
  std::vector<vec<scalar_of<P>, 1>> coefficients{};
  std::vector<exact_sum<std::conditional_t<Floating<scalar_of<P>>, scalar_of<P>, double>>> sums{};
};

namespace detail {

template <class R>
struct workspace_of;
template <CurvePoint P>
struct workspace_of<P> {
  using type = curve_workspace<P>;
};
template <ControlPoints R>
struct workspace_of<R> {
  using type = curve_workspace<control_point<R>>;
};

}  // namespace detail

/// The workspace for control points of this type, or of ranges like this.
template <class R>
using workspace_for = typename detail::workspace_of<R>::type;

/// A workspace of yours, or one that is made for the call.
template <class W, class R>
concept WorkspaceFor = std::same_as<W&, workspace_for<R>&>;

namespace detail {

/// What a call makes that is given no workspace: none where another form needs no memory.
template <class R, bool IsNeeded>
using own_workspace = std::conditional_t<IsNeeded, workspace_for<R>, void>;

}  // namespace detail

inline namespace IRG_ABI {

/// The parameter k/n. Counting from the other end gives the same pair the other way round, so that a curve traversed
/// backwards has the same points bit for bit.
/// needs   n > 0
/// exact   k/n and (n - k)/n rounded once each
template <Real T>
[[nodiscard]] IRG_INLINE constexpr curve_parameter<T> curve_fraction(int k, int n) noexcept {
  return {static_cast<T>(n - k) / static_cast<T>(n), static_cast<T>(k) / static_cast<T>(n)};
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

/// (1 - t)*a + t*b; exactly a for t = 0 and b for t = 1, whatever the other is.
template <Coordinates P>
IRG_INLINE constexpr P blend(const P& a, const P& b, const curve_parameter<scalar_of<P>>& at) noexcept {
  using T = scalar_of<P>;
  if (at.t == T(0)) return a;
  if (at.rest == T(0)) return b;
  return generate_coordinates<P>(
      [&](int i) { return product(at.rest, coordinate(a, i)) + product(at.t, coordinate(b, i)); });
}

/// De Casteljau's steps in place: afterwards the first `keep` points control a curve of lower degree; for keep = 1 it
/// is the curve's point, for 2 the chord whose difference is the derivative over the degree.
template <Coordinates P>
constexpr void reduce(std::span<P> work, std::size_t keep, const curve_parameter<scalar_of<P>>& at) noexcept {
  for (std::size_t n = work.size(); n > keep; --n)
    for (std::size_t k = 0; k + 1 < n; ++k) work[k] = blend(work[k], work[k + 1], at);
}

template <Coordinates P>
IRG_INLINE constexpr typename curve_sample<P>::vector scaled_difference(const P& a, const P& b, int factor) noexcept {
  using T = scalar_of<P>;
  return generate_coordinates<typename curve_sample<P>::vector>(
      [&](int i) { return product(coordinate(b, i) - coordinate(a, i), static_cast<T>(factor)); });
}

/// The first n elements of a row of a workspace, which grows where it has fewer.
template <class E>
constexpr std::span<E> room_for(std::vector<E>& row, std::size_t n) {
  if constexpr (Coordinates<E>) {  // of which some have any numbers when they are made
    if (row.size() < n) row.resize(n, zero_coordinates<E>());
  } else if (row.size() < n) {
    row.resize(n, E{});
  }
  return std::span<E>(row).first(n);
}
/// As many rows as that, each as long as the range of control points.
template <class E, ControlPoints R>
constexpr std::span<E> room_for(std::vector<E>& row, const R& points, std::size_t rows = 1) {
  return room_for(row, rows * ring_traits<R>::size(points));
}

template <class R>
constexpr std::span<control_point<R>> copied(const R& points, std::span<control_point<R>> scratch) noexcept {
  const std::size_t n = ring_traits<R>::size(points);
  IRG_EXPECTS(n > 0 && scratch.size() >= n);
  for (std::size_t k = 0; k < n; ++k) scratch[k] = ring_traits<R>::vertex(points, k);
  return scratch.first(n);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The point of the Bezier curve at t, by de Casteljau's algorithm.
/// needs   one or more control points; scratch at least as long, its contents are lost. t outside [0, 1] continues the
///         polynomial
/// exact   the first and last control point bit for bit at t = 0 and 1; within [0, 1] the error is below
///         3*degree*u*max(abs b) in each coordinate (degree 20, measured: 5 u), to first order and where nothing
///         underflows
/// cost    degree*(degree + 1)/2 blends
/// source  de Casteljau 1959; Mihajlovic 2016, 6.2
template <ControlPoints R>
constexpr control_point<R> bezier_point(const R& points, parameter_of<R> t,
                                        std::span<control_point<R>> scratch) noexcept {
  const auto work = detail::copied(points, scratch);
  detail::reduce(work, 1, t);
  return work[0];
}

/// The point of the Bezier curve at t, for control points whose number is part of the type.
/// exact   as the form with scratch
template <FixedControlPoints R>
[[nodiscard]] constexpr control_point<R> bezier_point(const R& points, parameter_of<R> t) noexcept {
  std::array<control_point<R>, detail::fixed_size<R>()> scratch{};
  return bezier_point(points, t, scratch);
}

/// The point of the Bezier curve at t, computed in a workspace; allocates where that has too little memory.
/// exact   as the form with scratch
template <ControlPoints R, WorkspaceFor<R> W = detail::own_workspace<R, !FixedControlPoints<R>>>
[[nodiscard]] constexpr control_point<R> bezier_point(const R& points, parameter_of<R> t, W&& memory = W{}) {
  return bezier_point(points, t, detail::room_for(memory.points, points));
}

/// The point of the Bezier curve at t and its derivative there.
/// needs   as bezier_point
/// gives   derivative zero for a single control point
/// exact   the point is that of bezier_point bit for bit; the derivative is the degree times one difference
/// source  de Casteljau 1959
template <ControlPoints R>
constexpr curve_sample<control_point<R>> bezier_sample(const R& points, parameter_of<R> t,
                                                       std::span<control_point<R>> scratch) noexcept {
  const auto work = detail::copied(points, scratch);
  using vector = typename curve_sample<control_point<R>>::vector;
  if (work.size() == 1) return {work[0], zero_coordinates<vector>()};
  detail::reduce(work, 2, t);
  return {detail::blend(work[0], work[1], t),
          detail::scaled_difference(work[0], work[1], static_cast<int>(work.size()) - 1)};
}

/// The point and the derivative, for control points whose number is part of the type.
template <FixedControlPoints R>
[[nodiscard]] constexpr curve_sample<control_point<R>> bezier_sample(const R& points, parameter_of<R> t) noexcept {
  std::array<control_point<R>, detail::fixed_size<R>()> scratch{};
  return bezier_sample(points, t, scratch);
}

/// The point and the derivative, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, WorkspaceFor<R> W = detail::own_workspace<R, !FixedControlPoints<R>>>
[[nodiscard]] constexpr curve_sample<control_point<R>> bezier_sample(const R& points, parameter_of<R> t,
                                                                     W&& memory = W{}) {
  return bezier_sample(points, t, detail::room_for(memory.points, points));
}

/// Cuts the curve at t: left gets the control points from 0 to t, right those from t to 1.
/// needs   left and right each as long as points
/// exact   the last point of left is the first of right, and bezier_point's, bit for bit; outer ends are exact
/// source  de Casteljau 1959
template <ControlPoints R>
constexpr void bezier_split(const R& points, parameter_of<R> t, std::span<control_point<R>> left,
                            std::span<control_point<R>> right) noexcept {
  const auto work = detail::copied(points, right);
  IRG_EXPECTS(left.size() >= work.size());
  left[0] = work[0];
  for (std::size_t k = 1; k < work.size(); ++k) {
    detail::reduce(work.first(work.size() - k + 1), work.size() - k, t);
    left[k] = work[0];
  }
}

/// The point of the Bezier curve at t in linear time and without working space.
/// needs   one or more control points, 0 <= t <= 1
/// exact   ends bit for bit; each step is a blend of two points, so the result stays in the hull up to rounding (degree
///         20, measured: 6 u*max(abs b)); where control points cancel, bezier_point keeps more
/// cost    degree blends and divisions
/// source  Wozny and Chudy 2020
template <ControlPoints R>
[[nodiscard]] constexpr control_point<R> bezier_point_wozny_chudy(const R& points, parameter_of<R> t) noexcept {
  using T = scalar_of<control_point<R>>;
  const std::size_t count = ring_traits<R>::size(points);
  IRG_EXPECTS(count > 0);
  if (t.rest == T(0)) return ring_traits<R>::vertex(points, count - 1);
  auto result = ring_traits<R>::vertex(points, 0);
  if (t.t == T(0)) return result;
  T share = T(1);
  for (std::size_t k = 1; k < count; ++k) {
    const T on = product(product(t.t, static_cast<T>(static_cast<int>(count - k))), share);
    const T off = product(t.rest, static_cast<T>(static_cast<int>(k)));
    share = on / (off + on);
    result = detail::blend(result, ring_traits<R>::vertex(points, k), curve_parameter<T>(share));
  }
  return result;
}

/// The values at t of the Bernstein polynomials of degree basis.size() - 1.
/// needs   room for one value or more
/// exact   within [0, 1] each is not negative and has relative error below 2*n*u for degree n, unless it underflows
/// cost    n*(n + 1)/2 steps
/// source  Bernstein 1912; the recursion b_{i,n} = (1 - t) b_{i,n-1} + t b_{i-1,n-1}
template <Real T>
constexpr void bernstein_basis(std::type_identity_t<curve_parameter<T>> t, std::span<T> basis) noexcept {
  IRG_EXPECTS(!basis.empty());
  basis[0] = T(1);
  for (std::size_t n = 1; n < basis.size(); ++n) {
    basis[n] = product(t.t, basis[n - 1]);
    for (std::size_t i = n - 1; i > 0; --i) basis[i] = product(t.rest, basis[i]) + product(t.t, basis[i - 1]);
    basis[0] = product(t.rest, basis[0]);
  }
}

/// The values of the N + 1 Bernstein polynomials of degree N at t.
/// exact   as the form that fills a span
template <int N, Real T>
  requires(N >= 0)
[[nodiscard]] constexpr std::array<T, static_cast<std::size_t>(N) + 1> bernstein_basis(curve_parameter<T> t) noexcept {
  std::array<T, static_cast<std::size_t>(N) + 1> b{};
  bernstein_basis<T>(t, b);
  return b;
}
template <int N, Real T>
[[nodiscard]] constexpr std::array<T, static_cast<std::size_t>(N) + 1> bernstein_basis(T t) noexcept {
  return bernstein_basis<N>(curve_parameter<T>(t));
}

/// The Bernstein polynomial C(n, i) t^i (1 - t)^(n - i).
/// gives   0 for i outside [0, n]; b(0, 0) = 1 also at t = 0
/// exact   relative error below 4*n*u within [0, 1], unless a factor underflows
/// cost    n products and at most n/2 quotients
/// source  Bernstein 1912; Mihajlovic 2016, 6.2 (4)
template <Real T>
[[nodiscard]] constexpr T bernstein(int n, int i, T t) noexcept {
  if (i < 0 || i > n) return T(0);
  const T rest = T(1) - t;
  const int fewer = i < n - i ? i : n - i;
  T value = 1;
  int ups = i, downs = n - i;
  // Powers and binomial grow together, so that the value stays near its final size.
  for (int k = 1; k <= fewer; ++k)
    value = product(product(value, static_cast<T>(n - fewer + k)) / static_cast<T>(k), product(t, rest));
  for (ups -= fewer; ups > 0; --ups) value = product(value, t);
  for (downs -= fewer; downs > 0; --downs) value = product(value, rest);
  return value;
}

}  // namespace IRG_ABI
}  // namespace irg
