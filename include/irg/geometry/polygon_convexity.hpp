// SPDX-License-Identifier: MIT
// What a polygon in the plane is: which way round it runs, whether it is convex, and where a point lies. All three are
// decided exactly for the coordinates as they are, however nearly collinear. y points up; where it points down,
// clockwise and counter-clockwise change places.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <irg/core/ring.hpp>
#include <irg/geometry/detail/exact_products.hpp>
#include <irg/math/error_free.hpp>

namespace irg {

/// Which way round a polygon runs, as the sign of its area says: `degenerate` when that is zero.
enum class polygon_orientation { clockwise = -1, degenerate = 0, counter_clockwise = 1 };

/// Where a point lies against a polygon.
enum class point_location { outside = -1, boundary = 0, inside = 1 };

/// The line a*x + b*y + c = 0 through an edge; the value is positive on the left of the edge's direction.
template <Scalar T>
struct edge_equation {
  T a{}, b{}, c{};
  constexpr bool operator==(const edge_equation&) const = default;
};

/// A ring of points of the plane.
template <class R>
concept PlaneRing = PolygonRing<R> && Point<ring_point<R>> && (size_of<ring_point<R>> == 2);

namespace detail {
inline namespace IRG_ABI {

// Number types every value of which is a double.
template <class T>
inline constexpr bool fits_double = Floating<T> || (std::is_integral_v<T> && sizeof(T) <= 4);

// Whether x is 0 or 2^-400 <= |x| < 2^400, so that differences and their products neither overflow nor underflow. Told
// from the bits: no mode of the processor hides a tiny number from it.
IRG_INLINE constexpr bool is_moderate(double x) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return ((bits >> 52) & 0x7ff) - 623 < 800 || bits << 1 == 0;
}

template <class T>
IRG_INLINE constexpr int coordinate_sign(const T& v) noexcept {
  return v < T(0) ? -1 : T(0) < v ? 1 : 0;
}

// The sign of (b - a) x (c - a) is sure when it is further from zero than this times the sum of the products' sizes.
inline constexpr double turn_error_bound = 3.3306690738754716e-16;  // (3 + 16u)u, u = 2^-53; Shewchuk 1997

// -1, 0 or 1: the way from a over b to c turns right, not at all (or back), or left.
constexpr int turn_of_doubles(double ax, double ay, double bx, double by, double cx, double cy) noexcept {
  if (is_moderate(ax) && is_moderate(ay) && is_moderate(bx) && is_moderate(by) && is_moderate(cx) && is_moderate(cy)) {
    const double left = product(bx - ax, cy - ay), right = product(by - ay, cx - ax), difference = left - right;
    if (coordinate_sign(left) * coordinate_sign(right) <= 0)
      return coordinate_sign(difference);  // the signs of the products are exact
    const double size = (left < 0 ? -left : left) + (right < 0 ? -right : right), bound = turn_error_bound * size;
    if (difference > bound || -difference > bound) return coordinate_sign(difference);
  }
  exact_products sum;
  sum.add(ax, by), sum.subtract(ay, bx);
  sum.add(bx, cy), sum.subtract(by, cx);
  sum.add(cx, ay), sum.subtract(cy, ax);
  return sum.sign();
}

template <Point P>
constexpr int turn_of(const P& a, const P& b, const P& c) noexcept {
  const auto x = [](const P& p) { return coordinate(p, 0); };
  const auto y = [](const P& p) { return coordinate(p, 1); };
  using T = scalar_of<P>;
  if constexpr (fits_double<T>) {
    const auto wide = [](const T& v) { return static_cast<double>(v); };
    return turn_of_doubles(wide(x(a)), wide(y(a)), wide(x(b)), wide(y(b)), wide(x(c)), wide(y(c)));
  } else {
    const T left = (x(b) - x(a)) * (y(c) - y(a)), right = (y(b) - y(a)) * (x(c) - x(a));
    return right < left ? 1 : left < right ? -1 : 0;
  }
}

template <Point P>
IRG_INLINE constexpr bool is_finite_point(const P& p) noexcept {
  const auto is_finite_double = [](double x) { return ((std::bit_cast<std::uint64_t>(x) >> 52) & 0x7ff) != 0x7ff; };
  if constexpr (Floating<scalar_of<P>>)
    return is_finite_double(static_cast<double>(coordinate(p, 0))) &&
           is_finite_double(static_cast<double>(coordinate(p, 1)));
  else
    return true;
}

template <PlaneRing R>
constexpr bool is_finite_ring(const R& ring) noexcept {
  if constexpr (Floating<scalar_of<ring_point<R>>>)
    for (std::size_t i = 0; i < ring_size(ring); ++i)
      if (!is_finite_point(ring_vertex(ring, i))) return false;
  return true;
}

template <Point P>
IRG_INLINE constexpr bool same_place(const P& a, const P& b) noexcept {
  return coordinate(a, 0) == coordinate(b, 0) && coordinate(a, 1) == coordinate(b, 1);
}

// Whether the way from a to b leads to greater x, or straight to greater y.
template <Point P>
IRG_INLINE constexpr bool leads_forward(const P& a, const P& b) noexcept {
  return coordinate(a, 0) < coordinate(b, 0) ||
         (coordinate(a, 0) == coordinate(b, 0) && coordinate(a, 1) < coordinate(b, 1));
}

// Whether p, which is on the line through a and b, is between them or on one of them.
template <Point P>
constexpr bool is_between(const P& a, const P& b, const P& p) noexcept {
  const auto within = [](const auto& from, const auto& to, const auto& v) {
    return from < to ? !(v < from) && !(to < v) : !(v < to) && !(from < v);
  };
  return within(coordinate(a, 0), coordinate(b, 0), coordinate(p, 0)) &&
         within(coordinate(a, 1), coordinate(b, 1), coordinate(p, 1));
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The line through an edge from p to q: a = y1 - y2, b = x2 - x1, c = x1*y2 - x2*y1.
/// gives   (0, 0, 0) when the points coincide
/// exact   in integers (without overflow) and rationals; in floats a and b are rounded once, c is within 1 ulp (2^-1073
///         more where it underflows)
/// source  formulas 2.6 and 3.1 of the course
template <Point P>
  requires(size_of<P> == 2)
constexpr edge_equation<scalar_of<P>> edge_through(const P& p, const P& q) noexcept {
  using T = scalar_of<P>;
  const T x1 = coordinate(p, 0), y1 = coordinate(p, 1), x2 = coordinate(q, 0), y2 = coordinate(q, 1);
  if constexpr (Floating<T>)
    return {y1 - y2, x2 - x1, difference_of_products(x1, y2, x2, y1)};
  else
    return {y1 - y2, x2 - x1, x1 * y2 - x2 * y1};
}

/// Which way round the polygon runs (y up), by the sign of its area; where it crosses itself the parts' areas add up.
/// gives   `degenerate` for fewer than three vertices, collinear ones, a figure of eight whose halves cancel, and when
///         a coordinate is NaN or infinite
/// exact   for all finite floats and integers of up to 32 bits; other scalars: as exact as their own + - * are
/// cost    one pass; nothing allocates
template <PlaneRing R>
constexpr polygon_orientation orientation_of(const R& ring) noexcept {
  using T = scalar_of<ring_point<R>>;
  const std::size_t n = ring_size(ring);
  if (n < 3 || !detail::is_finite_ring(ring)) return polygon_orientation::degenerate;
  int sign = 0;
  if constexpr (detail::fits_double<T>) {
    detail::exact_products area;
    for (std::size_t i = 0; i < n; ++i) {
      const auto p = ring_vertex(ring, i), q = ring_vertex(ring, i + 1);
      area.add(static_cast<double>(coordinate(p, 0)), static_cast<double>(coordinate(q, 1)));
      area.subtract(static_cast<double>(coordinate(p, 1)), static_cast<double>(coordinate(q, 0)));
    }
    sign = area.sign();
  } else {
    T area(0);
    for (std::size_t i = 0; i < n; ++i) area = area + edge_through(ring_vertex(ring, i), ring_vertex(ring, i + 1)).c;
    sign = detail::coordinate_sign(area);
  }
  return static_cast<polygon_orientation>(sign);
}

/// The course's criterion 3.2: clockwise or counter-clockwise when every vertex V(i+2) lies on that side of edge i.
/// gives   `degenerate` when the signs differ or one is zero. It looks at three vertices at a time: a pentagram passes,
///         a convex polygon with collinear vertices does not; is_convex and orientation_of decide those
/// exact   as orientation_of
/// source  criterion 3.2 of the course
template <PlaneRing R>
constexpr polygon_orientation orientation_textbook(const R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  if (n < 3 || !detail::is_finite_ring(ring)) return polygon_orientation::degenerate;
  const auto turn = [&](std::size_t i) {
    return detail::turn_of(ring_vertex(ring, i), ring_vertex(ring, i + 1), ring_vertex(ring, i + 2));
  };
  const int first = turn(0);
  for (std::size_t i = 1; i < n; ++i)
    if (turn(i) != first) return polygon_orientation::degenerate;
  return static_cast<polygon_orientation>(first);
}

/// Whether the polygon is convex: it turns one way only, and goes round once. Collinear and repeated vertices are
/// allowed; so are points and segments there and back, which are convex, too. Polygons that cross themselves are not.
/// gives   false when a coordinate is NaN or infinite; true for an empty ring
/// exact   as orientation_of
/// cost    one pass; nothing allocates
template <PlaneRing R>
constexpr bool is_convex(const R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  if (!detail::is_finite_ring(ring)) return false;
  std::size_t start = 1;  // an edge that has a length ends there
  while (start <= n && detail::same_place(ring_vertex(ring, start - 1), ring_vertex(ring, start))) ++start;
  if (n == 0 || start > n) return true;
  auto a = ring_vertex(ring, start - 1), b = ring_vertex(ring, start);
  bool turns_left = false, turns_right = false;
  int changes = 0;  // of leading forward and leading back: two in one round
  for (std::size_t i = start + 1; i <= start + n; ++i) {
    const auto c = ring_vertex(ring, i);
    if (detail::same_place(b, c)) continue;
    const int turn = detail::turn_of(a, b, c);
    turns_left = turns_left || turn > 0;
    turns_right = turns_right || turn < 0;
    changes += detail::leads_forward(a, b) != detail::leads_forward(b, c);
    if ((turns_left && turns_right) || changes > 2) return false;
    a = b;
    b = c;
  }
  return true;
}

/// Where p lies: on an edge or vertex, inside or outside of the polygon, which may be convex or not. Inside is where
/// the polygon's winding number is not zero.
/// gives   `outside` when a coordinate is NaN or infinite, and for an empty ring
/// exact   as orientation_of
/// cost    one pass; nothing allocates
/// source  for convex polygons the result is that of rules 3.3 and 3.4 of the course, which need them clockwise
template <PlaneRing R>
constexpr point_location locate_point(const R& ring, const ring_point<R>& p) noexcept {
  if (!detail::is_finite_point(p) || !detail::is_finite_ring(ring)) return point_location::outside;
  const auto height = coordinate(p, 1);
  int winding = 0;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const auto a = ring_vertex(ring, i), b = ring_vertex(ring, i + 1);
    const bool a_above = height < coordinate(a, 1), b_above = height < coordinate(b, 1);
    if (a_above && b_above) continue;
    const int turn = detail::turn_of(a, b, p);
    if (turn == 0 && detail::is_between(a, b, p)) return point_location::boundary;
    if (a_above != b_above && (turn > 0) == b_above) winding += b_above ? 1 : -1;
  }
  return winding != 0 ? point_location::inside : point_location::outside;
}

}  // namespace IRG_ABI
}  // namespace irg
