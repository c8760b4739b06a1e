// SPDX-License-Identifier: MIT
// plane<T>: a*x + b*y + c*z + d = 0 with the normal (a, b, c), made from points, and on which side of it a point lies.
#pragma once

#include <optional>

#include <irg/core/plane_concept.hpp>
#include <irg/core/ring.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// The points with a*x + b*y + c*z + d = 0; (a, b, c) points to its upper side and need not be of length 1.
template <Number T>
struct plane {
  T a{}, b{}, c{}, d{};
  bool operator==(const plane&) const = default;
};

namespace detail::inline IRG_ABI {

template <Plane P>
IRG_INLINE constexpr plane<plane_scalar<P>> as_plane(const P& p) noexcept {
  return {plane_coefficient(p, 0), plane_coefficient(p, 1), plane_coefficient(p, 2), plane_coefficient(p, 3)};
}

template <class T, Coordinates P>
IRG_INLINE constexpr vec<T, 3> displacement(const P& from, const P& to) noexcept {
  return generate_coordinates<vec<T, 3>>([&](int i) { return coordinate(to, i) - coordinate(from, i); });
}

// The plane with normal n through p, unless n is zero (or NaN).
template <class T, Coordinates P>
IRG_INLINE constexpr std::optional<plane<T>> plane_with_normal(const vec<T, 3>& n, const P& p) noexcept {
  const auto nonzero = [](const T& x) { return x < T(0) || T(0) < x; };
  if (!(nonzero(n.x) || nonzero(n.y) || nonzero(n.z))) return std::nullopt;
  const auto height = product(n.x, coordinate(p, 0)) + product(n.y, coordinate(p, 1)) + product(n.z, coordinate(p, 2));
  return plane<T>{n.x, n.y, n.z, static_cast<T>(T(0) - height)};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The plane as polynomials of sign_of and values_of take it.
template <class N, class T, class F>
[[nodiscard]] IRG_INLINE constexpr plane<N> in_numbers(const plane<T>& p, const F& number) noexcept {
  return {number(p.a), number(p.b), number(p.c), number(p.d)};
}

/// The vector (a, b, c), at right angles to the plane.
template <Plane P>
[[nodiscard]] IRG_INLINE constexpr vec<typename plane_traits<P>::scalar, 3> normal_of(const P& p) noexcept {
  return {plane_traits<P>::coefficient(p, 0), plane_traits<P>::coefficient(p, 1), plane_traits<P>::coefficient(p, 2)};
}

/// The plane through three points, from whose upper side they are seen counter-clockwise. Its normal is as long as
/// twice the triangle's area.
/// shape   in bare braces points of doubles
/// gives   nothing when the normal comes out as zero: collinear or equal points. In floats points that are nearly
///         collinear may give a plane of any direction, since the normal is rounded
/// exact   in integers and rationals; in floats each difference, product and sum is rounded once, and the products are
///         of differences, so that the distance from the origin costs the normal no accuracy
/// source  Mihajlovic 2016, formula 4.1
template <Point P = point<double, 3>>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr std::optional<plane<scalar_of<P>>> plane_through(const P& p1, const P& p2,
                                                                         const P& p3) noexcept {
  using T = scalar_of<P>;
  return detail::plane_with_normal(cross(detail::displacement<T>(p1, p2), detail::displacement<T>(p1, p3)), p1);
}

/// The plane of a polygon in space, flat or nearly so, concave or not; the polygon is counter-clockwise as seen from
/// its upper side. Its normal is as long as twice the polygon's area; it contains the first vertex.
/// gives   nothing for fewer than three vertices and when the normal comes out as zero
/// exact   in integers and rationals. In floats the normal is at most 2e-10 rad off where coordinates are 10^6 sizes
///         away from the origin (double), since vertices count from the first one
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's method)
template <PolygonRing R>
  requires Point<typename ring_traits<R>::point> && (size_of<typename ring_traits<R>::point> == 3)
[[nodiscard]] constexpr std::optional<plane<ring_scalar<R>>> newell_plane(const R& ring) noexcept {
  using T = ring_scalar<R>;
  const std::size_t n = ring_size(ring);
  if (n < 3) return std::nullopt;
  const auto origin = ring_vertex(ring, 0);
  vec<T, 3> normal{T(0), T(0), T(0)}, from = normal;
  for (std::size_t i = 1; i <= n; ++i) {
    const vec<T, 3> to = detail::displacement<T>(origin, ring_vertex(ring, i));
    normal.x = normal.x + product(from.y - to.y, from.z + to.z);
    normal.y = normal.y + product(from.z - to.z, from.x + to.x);
    normal.z = normal.z + product(from.x - to.x, from.y + to.y);
    from = to;
  }
  return detail::plane_with_normal(normal, origin);
}

/// a*x + b*y + c*z + d: the distance of p from the plane times the length of its normal, positive above.
/// exact   in integers and rationals; in floats, where nothing over- or underflows, off by at most 4u times the sum of
///         the absolute values of the four terms, so that its sign may be wrong for points nearer than that
template <Plane P, Point Q>
  requires(size_of<Q> == 3 && std::same_as<typename plane_traits<P>::scalar, scalar_of<Q>>)
[[nodiscard]] IRG_INLINE constexpr scalar_of<Q> plane_value(const P& p, const Q& q) noexcept {
  const auto term = [&](int i) { return product(plane_traits<P>::coefficient(p, i), coordinate(q, i)); };
  return term(0) + term(1) + term(2) + plane_traits<P>::coefficient(p, 3);
}

/// a*x + b*y + c*z + d*w, the value at x/w, y/w, z/w times the weight w.
/// exact   as for a point
template <Plane P, HomogeneousPoint Q>
  requires(size_of<Q> == 4 && std::same_as<typename plane_traits<P>::scalar, scalar_of<Q>>)
[[nodiscard]] IRG_INLINE constexpr scalar_of<Q> plane_value(const P& p, const Q& q) noexcept {
  const auto term = [&](int i) { return product(plane_traits<P>::coefficient(p, i), coordinate(q, i)); };
  return term(0) + term(1) + term(2) + term(3);
}

/// On which side of the plane q lies, by the sign of what plane_value rounds.
/// shape   q is a point or a homogeneous point. A negative weight does not change the point, nor the answer; weight 0
///         is a direction
/// gives   `on` when something is NaN or infinite
/// exact   for every finite float, double and integer: the plane is its coefficients, as they are
/// cost    about 4 ns, where roundings do not tell some 150 ns
template <Plane P, Coordinates Q>
  requires(((size_of<Q> == 3 && Point<Q>) || (size_of<Q> == 4 && HomogeneousPoint<Q>)) &&
           std::same_as<typename plane_traits<P>::scalar, scalar_of<Q>>)
[[nodiscard]] constexpr side side_of(const P& p, const Q& q) noexcept {
  using T = scalar_of<Q>;
  const plane<T> form = detail::as_plane(p);
  if constexpr (size_of<Q> == 3) {
    return static_cast<side>(
        sign_of<2>([](const auto& l, const auto& x) { return l.a * x.x + l.b * x.y + l.c * x.z + l.d; }, form, q));
  } else {
    const auto at = generate_coordinates<hpoint<T, 3>>([&](int i) { return coordinate(q, i); });
    const int sign = sign_of<2>(
        [](const auto& l, const auto& x) { return l.a * x.x + l.b * x.y + l.c * x.z + l.d * x.w; }, form, at);
    return static_cast<side>(at.w < T(0) ? -sign : sign);
  }
}

/// newell_plane moved so that it passes through the centroid of the vertices: of all parallel planes the one from which
/// the vertices of a polygon that is not quite flat are off by the least sum of squares.
/// gives   as newell_plane
/// exact   in rationals; in floats the normal as newell_plane's
/// source  Mihajlovic 2016, formula 4.2
template <PolygonRing R>
  requires Point<ring_point<R>> && (size_of<ring_point<R>> == 3) && Real<ring_scalar<R>>
[[nodiscard]] constexpr std::optional<plane<ring_scalar<R>>> newell_plane_through_centroid(const R& ring) noexcept {
  using T = ring_scalar<R>;
  auto p = newell_plane(ring);
  if (!p) return p;
  const auto origin = ring_vertex(ring, 0);
  vec<T, 3> sum{T(0), T(0), T(0)};
  T count(0);
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    sum = sum + detail::displacement<T>(origin, ring_vertex(ring, i));
    count = count + T(1);
  }
  p->d = p->d - dot(normal_of(*p), sum) / count;
  return p;
}

IRG_REFUSES_VECTORS(plane_through);
IRG_REFUSES_VECTORS(plane_value);

}  // namespace IRG_ABI
}  // namespace irg
