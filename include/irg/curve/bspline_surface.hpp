// SPDX-License-Identifier: MIT
// Tensor-product B-spline surfaces of any degrees, and rational ones (NURBS), which are surfaces of homogeneous points:
// points, derivatives, and the Bezier patches they are made of.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/curve/bezier_surface.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/curve/bspline_knots.hpp>
#include <irg/math/homogeneous.hpp>

namespace irg {

/// A B-spline surface; it refers to your knots and points.
/// needs   net.rows() == u.size(), net.columns == v.size()
template <CurvePoint P, int DegreeU = degree_at_run_time, int DegreeV = DegreeU>
  requires Floating<scalar_of<P>>
struct bspline_surface {
  bspline_knots<scalar_of<P>, DegreeU> u;
  bspline_knots<scalar_of<P>, DegreeV> v;
  control_net<P> net;
};

/// One Bezier patch of a B-spline surface: over [u_from, u_to] x [v_from, v_to], controlled by net.
template <CurvePoint P>
struct surface_piece {
  scalar_of<P> u_from{}, u_to{}, v_from{}, v_to{};
  control_net<P> net{};
};

namespace detail::inline IRG_ABI {

template <class P, int U, int V>
using own_surface_workspace = own_workspace<P, U == degree_at_run_time || V == degree_at_run_time>;

template <CurvePoint P, int U, int V>
constexpr bool is_in_range(const bspline_surface<P, U, V>& s, const scalar_of<P>& u, const scalar_of<P>& v) noexcept {
  return s.u.first() <= u && u <= s.u.last() && s.v.first() <= v && v <= s.v.last();
}

// How many numbers a point, how many vectors the derivatives up to an order, and how many numbers the patches take.
template <CurvePoint P, int U, int V>
constexpr std::size_t point_room(const bspline_surface<P, U, V>& s) noexcept {
  return s.u.order() + s.v.order();
}
template <CurvePoint P, int U, int V>
constexpr std::size_t derivatives_room(const bspline_surface<P, U, V>& s, int order) noexcept {
  const std::size_t rows = s.u.order(), columns = s.v.order();
  return (static_cast<std::size_t>(order) + 1) * (rows + 1) + 2 * (rows < columns ? columns : rows);
}
template <CurvePoint P, int U, int V>
constexpr std::size_t patches_room(const bspline_surface<P, U, V>& s) noexcept {
  return s.u.order() * s.u.order() + s.v.order() * s.v.order();
}

// The sum of the control points that count, each times its two functions; those of value 0 do not count.
template <CurvePoint P, class U, class V>
constexpr P blend_net(const control_net<P>& net, std::size_t i0, const U& u, std::size_t j0, const V& v) noexcept {
  return sum_of_rows(u, v, [&](std::size_t i) { return &net.points[(i0 + i) * net.columns + j0]; });
}

// Whether these control points, `step` apart, are all one position.
template <Floating T, int N>
constexpr bool is_one_position(std::span<const hpoint<T, N>> points, std::size_t first, std::size_t step,
                               std::size_t count) noexcept {
  for (std::size_t k = 1; k < count; ++k)
    if (!same_position(points[first], points[first + k * step])) return false;
  return true;
}

// Whether the border through this place, if there is one at t, passes through its own end points alone.
template <Floating T, int Degree>
constexpr std::optional<std::size_t> border_at(const bspline_knots<T, Degree>& knots, T t) noexcept {
  if (t == knots.first() && knots[0] == t) return 0;
  if (t == knots.last() && knots[knots.list().size() - 1] == t) return knots.size() - 1;
  return std::nullopt;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The point of the surface at (u, v).
/// gives   nothing for NaN and for places outside of the knots' ranges
/// exact   corners of full multiplicity bit for bit; elsewhere each product and sum rounded once, within the box of the
///         control points that count up to some u of their size
/// cost    order_u * order_v products per coordinate and two bases
/// source  Piegl and Tiller 1997, A3.5
template <CurvePoint P, int U, int V>
  requires(U >= 0 && V >= 0)
[[nodiscard]] constexpr std::optional<P> bspline_surface_point(const bspline_surface<P, U, V>& surface,
                                                               std::type_identity_t<scalar_of<P>> u,
                                                               std::type_identity_t<scalar_of<P>> v) noexcept {
  if (!detail::is_in_range(surface, u, v)) return std::nullopt;
  const std::size_t first_u = detail::bspline_stretch<scalar_of<P>>(surface.u, u) - static_cast<std::size_t>(U),
                    first_v = detail::bspline_stretch<scalar_of<P>>(surface.v, v) - static_cast<std::size_t>(V);
  std::array<scalar_of<P>, static_cast<std::size_t>(U) + 1> value_u{};
  std::array<scalar_of<P>, static_cast<std::size_t>(V) + 1> value_v{};
  detail::fill_two_bases<scalar_of<P>>(value_u, surface.u.list().subspan(first_u), u, value_v,
                                       surface.v.list().subspan(first_v), v);
  return detail::blend_net(surface.net, first_u, value_u, first_v, value_v);
}

/// The same for any degrees, with working space of the caller's for surface.u.order() + surface.v.order() numbers; its
/// contents are lost.
template <CurvePoint P, int U, int V>
constexpr std::optional<P> bspline_surface_point(const bspline_surface<P, U, V>& surface,
                                                 std::type_identity_t<scalar_of<P>> u,
                                                 std::type_identity_t<scalar_of<P>> v,
                                                 std::type_identity_t<std::span<scalar_of<P>>> scratch) noexcept {
  const std::size_t order_u = surface.u.order(), order_v = surface.v.order();
  IRG_EXPECTS(scratch.size() >= detail::point_room(surface));
  const auto value_u = scratch.first(order_u), value_v = scratch.subspan(order_u, order_v);
  const auto i = bspline_basis(surface.u, u, value_u), j = bspline_basis(surface.v, v, value_v);
  if (!i || !j) return std::nullopt;
  return detail::blend_net(surface.net, *i, value_u, *j, value_v);
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <CurvePoint P, int U, int V, WorkspaceFor<P> W = detail::own_surface_workspace<P, U, V>>
[[nodiscard]] constexpr std::optional<P> bspline_surface_point(const bspline_surface<P, U, V>& surface, scalar_of<P> u,
                                                               scalar_of<P> v, W&& memory = W{}) {
  return bspline_surface_point(surface, u, v, detail::room_for(memory.numbers, detail::point_room(surface)));
}

/// The derivatives of the surface at (u, v) up to `order` times along u and along v: derivatives[k * (order + 1) + l]
/// is the one k times along u and l times along v, and the first one the point's own coordinates.
/// needs   derivatives for (order + 1)^2 vectors; scratch for (order + 1) * (surface.u.order() + 1) and twice the
///         greater order of the surface, its contents are lost
/// gives   false, and nothing written, for NaN and for places outside of the knots' ranges; at a knot the derivatives
///         behind it, at a last one those before it
/// exact   as bspline_derivatives, along v, then along u; a derivative along control points that are equal is 0
/// source  de Boor 1972; Piegl and Tiller 1997, 3.5
template <CurvePoint P, int U, int V>
constexpr bool bspline_surface_derivatives(const bspline_surface<P, U, V>& surface,
                                           const std::type_identity_t<vec<scalar_of<P>, 2>>& at, int order,
                                           std::span<typename curve_sample<P>::vector> derivatives,
                                           std::span<typename curve_sample<P>::vector> scratch) noexcept {
  using vector = typename curve_sample<P>::vector;
  const std::size_t count = static_cast<std::size_t>(order) + 1, rows = surface.u.order(), columns = surface.v.order();
  const std::size_t room = 2 * (rows < columns ? columns : rows);
  IRG_EXPECTS(derivatives.size() >= count * count && scratch.size() >= detail::derivatives_room(surface, order));
  if (!detail::is_in_range(surface, at.x, at.y)) return false;
  const std::size_t low_u = detail::bspline_stretch(surface.u, at.x), low_v = detail::bspline_stretch(surface.v, at.y);
  const auto work = scratch.first(room), result = scratch.subspan(room, count),
             of_rows = scratch.subspan(room + count, count * rows);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j)
      work[j] = detail::as_vector(surface.net(low_u + 1 - rows + i, low_v + 1 - columns + j));
    detail::derivatives_in_stretch(surface.v, low_v, at.y, of_rows.subspan(i * count, count), work);
  }
  for (std::size_t l = 0; l < count; ++l) {
    for (std::size_t i = 0; i < rows; ++i) work[i] = of_rows[i * count + l];
    detail::derivatives_in_stretch(surface.u, low_u, at.x, result, work);
    for (std::size_t k = 0; k < count; ++k) derivatives[k * count + l] = static_cast<vector>(result[k]);
  }
  return true;
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <CurvePoint P, int U, int V, WorkspaceFor<P> W = curve_workspace<P>>
constexpr bool bspline_surface_derivatives(const bspline_surface<P, U, V>& surface, const vec<scalar_of<P>, 2>& at,
                                           int order, std::span<typename curve_sample<P>::vector> derivatives,
                                           W&& memory = W{}) {
  return bspline_surface_derivatives(surface, at, order, derivatives,
                                     detail::room_for(memory.vectors, detail::derivatives_room(surface, order)));
}

/// The point of the surface at (u, v) with its first derivatives and the mixed one.
/// needs   scratch as bspline_surface_derivatives of order 1
/// gives   nothing, and is exact, as bspline_surface_derivatives
template <CurvePoint P, int U, int V>
constexpr std::optional<surface_sample<P>> bspline_surface_sample(
    const bspline_surface<P, U, V>& surface, std::type_identity_t<scalar_of<P>> u, std::type_identity_t<scalar_of<P>> v,
    std::span<typename curve_sample<P>::vector> scratch) noexcept {
  std::array<typename curve_sample<P>::vector, 4> d{};
  if (!bspline_surface_derivatives(surface, {u, v}, 1, std::span<typename curve_sample<P>::vector>(d), scratch))
    return std::nullopt;
  return surface_sample<P>{generate_coordinates<P>([&](int axis) { return coordinate(d[0], axis); }), d[2], d[1], d[3]};
}
template <CurvePoint P, int U, int V>
  requires(U >= 0 && V >= 0)
[[nodiscard]] constexpr std::optional<surface_sample<P>> bspline_surface_sample(
    const bspline_surface<P, U, V>& surface, std::type_identity_t<scalar_of<P>> u,
    std::type_identity_t<scalar_of<P>> v) noexcept {
  std::array<typename curve_sample<P>::vector, static_cast<std::size_t>(2 * (U + 2) + 2 * ((U < V ? V : U) + 1))>
      room{};
  return bspline_surface_sample(surface, u, v, std::span<typename curve_sample<P>::vector>(room));
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <CurvePoint P, int U, int V, WorkspaceFor<P> W = detail::own_surface_workspace<P, U, V>>
[[nodiscard]] constexpr std::optional<surface_sample<P>> bspline_surface_sample(const bspline_surface<P, U, V>& surface,
                                                                                scalar_of<P> u, scalar_of<P> v,
                                                                                W&& memory = W{}) {
  return bspline_surface_sample(surface, u, v, detail::room_for(memory.vectors, detail::derivatives_room(surface, 1)));
}

/// The point of a rational surface with its derivatives from those of its homogeneous points.
/// gives   nothing where the weight is 0 or a number, given or on the way, is not finite
/// exact   the quotient rule, each operation rounded once
/// source  Piegl and Tiller 1997, A4.4
template <Floating T, int N>
[[nodiscard]] constexpr std::optional<surface_sample<point<T, N>>> rational_sample(
    const surface_sample<hpoint<T, N>>& s) noexcept {
  const auto place = try_to_cartesian(s.point);
  if (!place || !is_finite(s.du, s.dv, s.duv)) return std::nullopt;
  const T weight = coordinate(s.point, N), weight_u = coordinate(s.du, N), weight_v = coordinate(s.dv, N),
          weight_uv = coordinate(s.duv, N);
  surface_sample<point<T, N>> result{*place, {}, {}, {}};
  const auto less = [](const T& a, const T& factor, const T& b) { return a - product(factor, b); };
  for (int i = 0; i < N; ++i) {
    const T x = coordinate(*place, i);
    const T du = less(coordinate(s.du, i), weight_u, x) / weight, dv = less(coordinate(s.dv, i), weight_v, x) / weight;
    result.du[i] = du;
    result.dv[i] = dv;
    result.duv[i] = less(less(less(coordinate(s.duv, i), weight_u, dv), weight_v, du), weight_uv, x) / weight;
  }
  return is_finite(result.du, result.dv, result.duv) ? std::optional(result) : std::nullopt;
}

/// The point of a rational B-spline surface (NURBS) at (u, v).
/// gives   nothing for NaN, for places outside of the knots' ranges, and where the weight is 0 or not finite
/// exact   as bspline_surface_point, and a quotient: a few u of the largest control point times its weight over the
///         weight here; weights of one sign keep it in the box of the control points up to that
/// source  Piegl and Tiller 1997, A4.3
template <Floating T, int N, int U, int V>
  requires(U >= 0 && V >= 0)
[[nodiscard]] constexpr std::optional<point<T, N>> nurbs_surface_point(
    const bspline_surface<hpoint<T, N>, U, V>& surface, std::type_identity_t<T> u, std::type_identity_t<T> v) noexcept {
  const auto p = bspline_surface_point(surface, u, v);
  return p ? detail::cartesian_of(*p) : std::nullopt;
}
template <Floating T, int N, int U, int V>
constexpr std::optional<point<T, N>> nurbs_surface_point(const bspline_surface<hpoint<T, N>, U, V>& surface,
                                                         std::type_identity_t<T> u, std::type_identity_t<T> v,
                                                         std::type_identity_t<std::span<T>> scratch) noexcept {
  const auto p = bspline_surface_point(surface, u, v, scratch);
  return p ? detail::cartesian_of(*p) : std::nullopt;
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int N, int U, int V,
          WorkspaceFor<hpoint<T, N>> W = detail::own_surface_workspace<hpoint<T, N>, U, V>>
[[nodiscard]] constexpr std::optional<point<T, N>> nurbs_surface_point(
    const bspline_surface<hpoint<T, N>, U, V>& surface, std::type_identity_t<T> u, std::type_identity_t<T> v,
    W&& memory = W{}) {
  return nurbs_surface_point(surface, u, v, detail::room_for(memory.numbers, detail::point_room(surface)));
}

/// The point of a rational B-spline surface (NURBS) with its first derivatives and the mixed one.
/// needs   scratch as bspline_surface_derivatives of order 1
/// gives   as nurbs_surface_point and rational_sample. A border that has shrunk to a point (control points that are the
///         same_position) has the derivative 0 along it, bit for bit, so that surface_normal finds its normal
/// exact   as bspline_surface_derivatives and rational_sample
template <Floating T, int N, int U, int V>
constexpr std::optional<surface_sample<point<T, N>>> nurbs_surface_sample(
    const bspline_surface<hpoint<T, N>, U, V>& surface, std::type_identity_t<T> u, std::type_identity_t<T> v,
    std::type_identity_t<std::span<hpoint<T, N>>> scratch) noexcept {
  const auto homogeneous = bspline_surface_sample(surface, u, v, scratch);
  if (!homogeneous) return std::nullopt;
  auto sample = rational_sample(*homogeneous);
  if (!sample) return std::nullopt;
  const std::size_t columns = surface.net.columns;
  const std::size_t i = detail::bspline_stretch(surface.u, u) + 1 - surface.u.order(),
                    j = detail::bspline_stretch(surface.v, v) + 1 - surface.v.order();
  if (const auto row = detail::border_at(surface.u, u))
    if (detail::is_one_position(surface.net.points, *row * columns + j, 1, surface.v.order())) sample->dv = {};
  if (const auto column = detail::border_at(surface.v, v))
    if (detail::is_one_position(surface.net.points, i * columns + *column, columns, surface.u.order())) sample->du = {};
  return sample;
}
template <Floating T, int N, int U, int V>
  requires(U >= 0 && V >= 0)
[[nodiscard]] constexpr std::optional<surface_sample<point<T, N>>> nurbs_surface_sample(
    const bspline_surface<hpoint<T, N>, U, V>& surface, std::type_identity_t<T> u, std::type_identity_t<T> v) noexcept {
  std::array<hpoint<T, N>, static_cast<std::size_t>(2 * (U + 2) + 2 * ((U < V ? V : U) + 1))> room{};
  return nurbs_surface_sample(surface, u, v, std::span<hpoint<T, N>>(room));
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <Floating T, int N, int U, int V,
          WorkspaceFor<hpoint<T, N>> W = detail::own_surface_workspace<hpoint<T, N>, U, V>>
[[nodiscard]] constexpr std::optional<surface_sample<point<T, N>>> nurbs_surface_sample(
    const bspline_surface<hpoint<T, N>, U, V>& surface, std::type_identity_t<T> u, std::type_identity_t<T> v,
    W&& memory = W{}) {
  return nurbs_surface_sample(surface, u, v, detail::room_for(memory.vectors, detail::derivatives_room(surface, 1)));
}

/// t as a parameter from 0 to 1 over the knots' range: what surface_normal needs to know of a place.
/// needs   first() <= t <= last()
template <Floating T, int Degree>
[[nodiscard]] constexpr curve_parameter<T> normalized_parameter(const bspline_knots<T, Degree>& knots,
                                                                std::type_identity_t<T> t) noexcept {
  return detail::share_of_stretch(knots.first(), knots.last(), static_cast<T>(t));
}

/// Hands each polynomial patch of the surface to sink(surface_piece), along v first.
/// needs   scratch for order_u^2 + order_v^2 numbers, piece for order_u * order_v points
/// exact   as bspline_bezier_pieces: patches that touch share their border's control points bit for bit, but at knots
///         of full multiplicity, where the surface may be torn
/// cost    order_u^2 * order_v^2 products per coordinate for each patch
/// source  Piegl and Tiller 1997, 5.3; Ramshaw 1987 (blossoms)
template <CurvePoint P, int U, int V, class Sink>
constexpr void bspline_surface_patches(const bspline_surface<P, U, V>& surface,
                                       std::type_identity_t<std::span<scalar_of<P>>> scratch,
                                       std::type_identity_t<std::span<P>> piece, Sink&& sink) {
  const std::size_t rows = surface.u.order(), columns = surface.v.order();
  IRG_EXPECTS(scratch.size() >= detail::patches_room(surface) && piece.size() >= rows * columns);
  const auto share_u = [&](std::size_t i) { return scratch.subspan(i * rows, rows); };
  const auto share_v = [&](std::size_t j) { return scratch.subspan(rows * rows + j * columns, columns); };
  const auto end_u = surface.u.size(), end_v = surface.v.size();
  const auto begin_v = detail::bspline_stretch(surface.v, surface.v.first());
  for (auto low_u = detail::bspline_stretch(surface.u, surface.u.first()); low_u < end_u;
       low_u = detail::next_stretch(surface.u, low_u))
    for (auto low_v = begin_v; low_v < end_v; low_v = detail::next_stretch(surface.v, low_v)) {
      for (std::size_t i = 0; i < rows; ++i) {
        auto values_u = share_u(i);
        const std::size_t first_u = detail::fill_piece_shares(values_u, surface.u, low_u, i);
        for (std::size_t j = 0; j < columns; ++j) {
          auto values_v = share_v(j);
          const std::size_t first_v = detail::fill_piece_shares(values_v, surface.v, low_v, j);
          piece[i * columns + j] = detail::blend_net(surface.net, first_u, values_u, first_v, values_v);
        }
      }
      sink(surface_piece<P>{surface.u[low_u],
                            surface.u[low_u + 1],
                            surface.v[low_v],
                            surface.v[low_v + 1],
                            {piece.first(rows * columns), columns}});
    }
}

/// The same, computed in a workspace, where the control points stand; allocates where that has too little memory.
template <CurvePoint P, int U, int V, class Sink, WorkspaceFor<P> W = curve_workspace<P>>
constexpr void bspline_surface_patches(const bspline_surface<P, U, V>& surface, Sink&& sink, W&& memory = W{}) {
  bspline_surface_patches(surface, detail::room_for(memory.numbers, detail::patches_room(surface)),
                          detail::room_for(memory.points, surface.u.order() * surface.v.order()), sink);
}

IRG_RENAMED(share_of_range, normalized_parameter)

}  // namespace IRG_ABI
}  // namespace irg
