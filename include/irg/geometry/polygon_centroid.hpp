// SPDX-License-Identifier: MIT
// The centre of gravity of a polygon's area, and the length of its edges.
#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/geometry/detail/twice_area.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/vec.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// Adds the cross product of two vertices times s.
IRG_INLINE constexpr void add_cross(exact_accumulator<3>& sum, const vec<double, 2>& p, const vec<double, 2>& q,
                                    double s) noexcept {
  sum.add(s, p.x, q.y), sum.subtract(s, q.x, p.y);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The centre of gravity of a polygon's area; rings count by their signed areas, so that holes that run the other way
/// are taken off.
/// gives   nothing for a polygon without area and when a coordinate is NaN or infinite. Where a ring crosses itself,
///         parts of opposite signs may put the centre outside of it. A point of doubles for integers of up to 32 bits
/// exact   float and double: each coordinate within 0.52 ulp for all finite coordinates, however far from the origin;
///         exact in rationals
/// cost    some 100 ns for a vertex; nothing allocates
/// source  irg's own: the moments of the triangles from the origin to each edge
template <PlanePolygon P>
  requires(!std::integral<scalar_of<polygon_point<P>>> || sizeof(scalar_of<polygon_point<P>>) <= 4)
[[nodiscard]] constexpr auto polygon_centroid(const P& polygon) noexcept {
  using T = scalar_of<polygon_point<P>>;
  if constexpr (Floating<T> || std::integral<T>) {
    using result_type = std::conditional_t<Floating<T>, T, double>;
    using centre = std::optional<point<result_type, 2>>;
    if (!irg::is_finite(polygon)) return centre();
    exact_accumulator<3> x, y, area;
    detail::each_edge(polygon, [&](const auto& from, const auto& to) {
      const vec<double, 2> p{widened(coordinate(from, 0)), widened(coordinate(from, 1))};
      const vec<double, 2> q{widened(coordinate(to, 0)), widened(coordinate(to, 1))};
      detail::add_cross(x, p, q, p.x), detail::add_cross(x, p, q, q.x);
      detail::add_cross(y, p, q, p.y), detail::add_cross(y, p, q, q.y);
      detail::add_cross(area, p, q, 3.0);
    });
    if (area.sign() == 0) return centre();
    const auto over_area = [&](const exact_accumulator<3>& moment) {
      return moment.sign() == 0 ? result_type(0) : static_cast<result_type>(detail::ratio(moment, area));
    };
    return centre({over_area(x), over_area(y)});
  } else {
    T x(0), y(0), area(0);
    detail::each_edge(polygon, [&](const auto& p, const auto& q) {
      const T part = coordinate(p, 0) * coordinate(q, 1) - coordinate(q, 0) * coordinate(p, 1);
      x = x + (coordinate(p, 0) + coordinate(q, 0)) * part;
      y = y + (coordinate(p, 1) + coordinate(q, 1)) * part;
      area = area + T(3) * part;
    });
    using centre = std::optional<point<T, 2>>;
    return area == T(0) ? centre() : centre({x / area, y / area});
  }
}

/// The centre of gravity of one ring, in plain arithmetic about its first vertex.
/// gives   nothing when the area comes out as zero or NaN; no NaN while coordinates are below 2^340 (float: 2^41) in
///         size and sizes above 2^-340
/// exact   of a ring that runs one way round its first vertex: off by some (n + 6) u times its size; distance from the
///         origin adds half an ulp
/// cost    about 3 ns for a vertex
template <PlaneRing R>
  requires Floating<ring_scalar<R>>
[[nodiscard]] constexpr std::optional<point<ring_scalar<R>, 2>> polygon_centroid_fast(const R& ring) noexcept {
  using T = ring_scalar<R>;
  const std::size_t n = ring_size(ring);
  if (n < 3) return std::nullopt;
  const auto origin = ring_vertex(ring, 0), first = ring_vertex(ring, 1);
  T ux = coordinate(first, 0) - coordinate(origin, 0), uy = coordinate(first, 1) - coordinate(origin, 1);
  T x(0), y(0), area(0);
  for (std::size_t i = 2; i < n; ++i) {
    const auto p = ring_vertex(ring, i);
    const T vx = coordinate(p, 0) - coordinate(origin, 0), vy = coordinate(p, 1) - coordinate(origin, 1);
    const T part = product(ux, vy) - product(uy, vx);
    x = x + product(ux + vx, part);
    y = y + product(uy + vy, part);
    area = area + part;
    ux = vx;
    uy = vy;
  }
  if (!(area < T(0) || T(0) < area)) return std::nullopt;
  return point<T, 2>{coordinate(origin, 0) + x / (T(3) * area), coordinate(origin, 1) + y / (T(3) * area)};
}

/// The length of a polygon's edges together, those of all its rings. An edge that is walked twice counts twice.
/// gives   0 for no vertices and one; infinity when it overflows or a coordinate is infinite, NaN for NaN
/// exact   within 2 ulp while no difference of coordinates overflows: lengths are added without loss
/// cost    a square root and a division for each edge
template <PlanePolygon P>
  requires Floating<scalar_of<polygon_point<P>>>
[[nodiscard]] constexpr auto polygon_perimeter(const P& polygon) noexcept {
  using T = scalar_of<polygon_point<P>>;
  constexpr T most = (std::numeric_limits<T>::max)(), infinity = std::numeric_limits<T>::infinity();
  // Asked before sums are made: constants may not overflow.
  const auto overflows = [](T a, T b) { return magnitude(a / 2 + b / 2) > most / 2; };
  const auto length = [&](const auto& scaled) {
    T sum(0), error(0);
    detail::each_edge(polygon, [&](const auto& p, const auto& q) {
      for (int i = 0; i < 2; ++i)
        if (overflows(coordinate(q, i), -coordinate(p, i))) sum = infinity;
      if (sum == infinity) return;
      const T dx = coordinate(q, 0) - coordinate(p, 0), dy = coordinate(q, 1) - coordinate(p, 1);
      const T edge = hypot(scaled(dx), scaled(dy));
      const auto next = overflows(sum, edge) ? exact_sum<T>{infinity, T(0)} : two_sum(sum, edge);
      sum = next.value;
      error = error + next.error;
    });
    return sum == infinity || overflows(sum, error) ? infinity : sum + error;
  };
  if (!is_finite(polygon)) {
    bool any_nan = false;
    detail::each_edge(polygon, [&](const auto& p, const auto&) {
      for (int i = 0; i < 2; ++i) any_nan = any_nan || coordinate(p, i) != coordinate(p, i);
    });
    return any_nan ? std::numeric_limits<T>::quiet_NaN() : infinity;
  }
  const T sum = length([](T x) { return x; });
  constexpr T up = std::is_same_v<T, float> ? T(0x1p60f) : T(0x1p200);
  // As multiples of the smallest number the edges' lengths would lose half of it each.
  if (T(0) < sum && sum < (std::numeric_limits<T>::min)() * up) return length([](T x) { return x * up; }) / up;
  return sum;
}

}  // namespace IRG_ABI
}  // namespace irg
